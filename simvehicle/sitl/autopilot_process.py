"""An autopilot that is not ours as a process: what is wanted of it, its start, its end, its last words
(docs/protocol/autopilots.md#autopilots-of-others)."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Self

from simvehicle.autopilot.energy_transfer import Envelope
from simvehicle.law.params import BatteryParams
from simvehicle.law.plants import RotorPlant
from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.world.description import read_world
from simvehicle.world.sensors import SensorErrors
from skytender.frames import CHECKSUM_BYTES, HEADER_BYTES, MAGIC
from skytender.processes import end_with

HOST = "127.0.0.1"
MOST_INSTANCES = 2000
READY_WITHIN_S = 60.0
"""Wall time from its start to its first word to its simulation: a machine may have much else to do."""
LOOK_EVERY_S = 0.5
LAST_LINES = 5


class AutopilotError(RuntimeError):
    """An autopilot that cannot be started, is not ready, or has ended; the text says which, with its last lines."""


@dataclass(frozen=True)
class AutopilotWanted:
    """One autopilot of a command line; `folder` is its own, `home` degrees, degrees, m; `start_ned` where it stands."""

    program: Path
    sysid: int
    folder: Path
    home: tuple[float, float, float]
    start_ned: tuple[float, float, float]
    yaw_deg: float
    epoch_s: int
    seed: int
    air_density_kg_m3: float
    battery: BatteryParams
    envelope: Envelope
    parameters: dict[str, float]
    renamed: dict[str, str]
    """clause about each parameter that other versions call by another name"""
    sensors: SensorErrors | None
    """errors of what it senses; None where it senses exactly"""
    truth: Path | None = None


class AutopilotProcess:
    """The process of an autopilot, which ends with this one, or with the block that it is opened for."""

    def __init__(self, wanted: AutopilotWanted, argv: Sequence[str], environment: Mapping[str, str]) -> None:
        """Start it in its folder, with its output in a log. Raises AutopilotError."""
        self._wanted = wanted
        with (wanted.folder / "autopilot.log").open("wb") as log:
            try:
                self._process = subprocess.Popen(
                    argv,
                    cwd=wanted.folder,
                    env=environment,
                    stdin=subprocess.DEVNULL,
                    stdout=log,
                    stderr=subprocess.STDOUT,
                    process_group=0,
                    preexec_fn=partial(end_with, os.getpid()),  # noqa: PLW1509 - one thread alone
                )
            except OSError as error:
                raise AutopilotError(f"{self.name} cannot be started: {error.strerror}") from error

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._process.poll() is None:  # else its number may be another's by now
            with contextlib.suppress(ProcessLookupError):
                os.killpg(self._process.pid, signal.SIGKILL)  # with what it has started itself
        self._process.wait()

    @property
    def name(self) -> str:
        """The autopilot, for a sentence."""
        return f"the autopilot {self._wanted.program}"

    def look(self) -> None:
        """Raise AutopilotError where it has ended."""
        if self._process.poll() is not None:
            raise self.gone()

    def gone(self) -> AutopilotError:
        """The error that says how it ended."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(LOOK_EVERY_S)
        status = self._process.poll()
        how = "has closed its connection" if status is None else f"ended with status {status}"
        if status is not None and status < 0:
            how = f"was killed by signal {-status}"
        return AutopilotError(f"{self.name} {how}{self.last_lines()}")

    def late(self, what: str) -> AutopilotError:
        """The error that says what it has not done in time."""
        return AutopilotError(f"{self.name} {what}{self.last_lines()}")

    def last_lines(self) -> str:
        """Last lines of its log, each once, to end a sentence."""
        try:
            lines = (self._wanted.folder / "autopilot.log").read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError:
            lines = []
        last = list(dict.fromkeys(line.strip() for line in lines if line.strip()))[-LAST_LINES:]
        return f"; its last lines: {' | '.join(last)}" if last else ", and said nothing"


class AutopilotLink(ABC):
    """An autopilot's process with its sockets. Everything raises AutopilotError once it is gone."""

    process: AutopilotProcess
    _closing: contextlib.ExitStack
    """all that is open"""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._closing.close()

    @abstractmethod
    def say(self, raw: bytes) -> None:
        """Say bytes to it over its MAVLink."""

    @abstractmethod
    def received(self) -> list[ReceivedFrame]:
        """Frames that it has said over its MAVLink since it was asked last."""


def whole_frames(content: bytes) -> tuple[bytes, bytes]:
    """Bytes of a stream up to the end of the last whole frame, and the rest."""
    at = 0
    while (start := content.find(bytes((MAGIC,)), at)) >= 0:
        if len(content) < start + HEADER_BYTES:
            return content[:start], content[start:]
        end = start + HEADER_BYTES + content[start + 1] + CHECKSUM_BYTES
        if len(content) < end:
            return content[:start], content[start:]
        at = end
    return content, b""


def read_wanted(content: Any, sysid: int, step_s: float) -> tuple[AutopilotWanted, RotorPlant]:
    """An autopilot and its physics, stepped each `step_s`, from plain data as in a file. Raises AutopilotError."""
    try:
        world = read_world(content["world"])
        own = world.vehicles[sysid]
        plant = RotorPlant(replace(own, errors=None), world.air, seed=world.seed, sysid=sysid)
        lat_deg, lon_deg, alt_m = map(float, content["home"])
        north_m, east_m, down_m = map(float, content["start_ned"])
        wanted = AutopilotWanted(
            program=Path(content["program"]),
            sysid=sysid,
            folder=Path(content["folder"]),
            home=(lat_deg, lon_deg, alt_m),
            start_ned=(north_m, east_m, down_m),
            yaw_deg=float(content["yaw_deg"]),
            epoch_s=int(content["epoch_s"]),
            seed=world.seed,
            air_density_kg_m3=world.air.density_kg_m3,
            battery=BatteryParams(**{name: float(value) for name, value in content["battery"].items()}),
            envelope=Envelope(float(content["capture_m"]), float(content["relative_speed_m_s"])),
            parameters={str(name): float(value) for name, value in content["parameters"].items()},
            renamed={str(name): str(clause) for name, clause in content.get("renamed", {}).items()},
            sensors=None if own.errors is None else SensorErrors(own.errors, step_s, seed=world.seed, sysid=sysid),
            truth=None if content["truth"] is None else Path(content["truth"]),
        )
        wanted.folder.mkdir(parents=True, exist_ok=True)
    except (KeyError, TypeError, AttributeError, ValueError) as error:
        raise AutopilotError(f"its file cannot be read: {error}") from error
    return wanted, plant
