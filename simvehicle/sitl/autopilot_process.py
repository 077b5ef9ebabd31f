"""A real ArduPilot as a process: parameters, ports, start and end (docs/protocol.md#autopilots-of-others)."""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import socket
import subprocess
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from simvehicle.autopilot.body import STEP_MS
from simvehicle.autopilot.energy_transfer import Envelope
from simvehicle.law.params import BatteryParams
from simvehicle.law.plants import RotorPlant
from simvehicle.mavlink.analog_battery import DEFAULTS
from simvehicle.world.description import read_world
from simvehicle.world.sensors import SensorErrors

PR_SET_PDEATHSIG = 1
STEP_S = STEP_MS / 1e3
HOST = "127.0.0.1"
JSON_PORT, SERIAL_PORT, APART = 9002, 5760, 10
MOST_INSTANCES = 2000
PARAMETERS: dict[str, float] = {
    "FRAME_CLASS": 1,
    "FRAME_TYPE": 1,
    "SCHED_LOOP_RATE": round(1.0 / STEP_S),
    "MOT_THST_EXPO": 1.0,
    "MOT_SPIN_MIN": 0.0,
    "MOT_SPIN_ARM": 0.0,
    "MOT_BAT_VOLT_MAX": 0.0,
    "BATT_MONITOR": 4,
    **DEFAULTS,
    "FS_THR_ENABLE": 0,
    "LOG_BACKEND_TYPE": 0,
    "GPS_TYPE": 100,
    "GPS1_TYPE": 100,
    "EK3_YAW_M_NSE": 0.05,
    "EK3_GPS_CHECK": 0,
    **{f"INS_ACC{i}OFFS_{axis}": 0.001 for i in ("", "2") for axis in "XYZ"},
    **{f"INS_ACC{i}SCAL_{axis}": 1.001 for i in ("", "2") for axis in "XYZ"},
    **{f"COMPASS_OFS{i}_{axis}": x for i in ("", "2", "3") for axis, x in zip("XYZ", (5, 13, -18), strict=True)},
    **{f"RC{i}_{end}": us for i in range(1, 5) for end, us in (("MIN", 1000), ("MAX", 2000), ("TRIM", 1500))},
    "RC3_TRIM": 1000,
}
"""Parameters that it starts with [choice]: calibrated, in no want of a transmitter, thrust by the throttle squared."""


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
    battery: BatteryParams
    envelope: Envelope
    parameters: dict[str, float]
    sensors: SensorErrors
    truth: Path | None = None


def simulation_port() -> tuple[socket.socket, int]:
    """A socket where an autopilot of some instance number speaks to its simulation, and that number: the first whose
    ports are free."""
    for instance in range(MOST_INSTANCES):
        udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            udp.bind((HOST, JSON_PORT + APART * instance))
            with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as tcp:
                tcp.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
                tcp.bind((HOST, SERIAL_PORT + APART * instance))
            return udp, instance
        except OSError:
            udp.close()
    raise AutopilotError(
        f"no ports are free for an autopilot: UDP {JSON_PORT} and TCP {SERIAL_PORT}, in steps of {APART}"
    )


def start(wanted: AutopilotWanted, instance: int) -> subprocess.Popen[bytes]:
    wanted.folder.mkdir(parents=True, exist_ok=True)
    defaults = wanted.folder / "defaults.parm"
    values = {**PARAMETERS, **wanted.parameters}
    defaults.write_text("".join(f"{name} {value:g}\n" for name, value in values.items()), encoding="utf-8")
    place = ",".join(f"{number:.9g}" for number in wanted.home)
    argv = [
        *(str(wanted.program.resolve()), "--model", f"JSON:{HOST}", "-I", str(instance)),
        *("--home", f"{place},{wanted.yaw_deg:g}", "--defaults", str(defaults.resolve()), "-w"),
        *("--start-time", str(wanted.epoch_s), "--sysid", str(wanted.sysid)),
        *("--serial1", "none:1", "--serial2", "none:1"),
    ]
    libc = ctypes.CDLL(None)
    with (wanted.folder / "autopilot.log").open("wb") as log:
        try:
            return subprocess.Popen(
                argv,
                cwd=wanted.folder,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
                preexec_fn=lambda: libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL),  # noqa: PLW1509 - one thread alone
            )
        except OSError as error:
            raise AutopilotError(f"the autopilot {wanted.program} cannot be started: {error.strerror}") from error


def end(process: subprocess.Popen[bytes]) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.kill(process.pid, signal.SIGKILL)
    process.wait()


def read_wanted(content: Any, sysid: int) -> tuple[AutopilotWanted, RotorPlant]:
    """An autopilot and its physics from plain data, as a file holds them. Raises AutopilotError."""
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
            battery=BatteryParams(**{name: float(value) for name, value in content["battery"].items()}),
            envelope=Envelope(float(content["capture_m"]), float(content["relative_speed_m_s"])),
            parameters={str(name): float(value) for name, value in content["parameters"].items()},
            sensors=SensorErrors(own.errors, STEP_S, seed=world.seed, sysid=sysid),
            truth=None if content["truth"] is None else Path(content["truth"]),
        )
    except (KeyError, TypeError, AttributeError, ValueError) as error:
        raise AutopilotError(f"its file cannot be read: {error}") from error
    return wanted, plant
