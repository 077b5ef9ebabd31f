"""Whole sessions for tests: the real programs in real processes, and what they leave behind."""

from __future__ import annotations

import contextlib
import copy
import functools
import json
import os
import select
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import yaml
from commands import gcs
from lasting import lasting
from patience import PATIENCE_S
from pymavlink import mavutil
from pymavlink.dialects.v20 import ardupilotmega

GCS = [sys.executable, "-m", "gcs"]
ROOT = Path(__file__).resolve().parents[2]
DIGESTS = {
    "paper/example1": "3ae9624e",
    "paper/example2": "cd79fc52",
    "paper/example3": "ddb863e8",
    "paper/example4": "dd3ad26a",
    "demo": "b31307c4",
}
"""First digits of the digests of shipped scenarios; the changelog names each change."""
SIMPLER = {
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F",
    "NPY_DISABLE_CPU_FEATURES": " ".join(np.show_config(mode="dicts")["SIMD Extensions"].get("found", ())),
}
"""Environment in which the C library and NumPy take what every processor of this architecture can do."""
STATE = 12


def demo() -> dict[str, Any]:
    """The shipped demo as plain data, on the lockstep clock."""
    content: dict[str, Any] = yaml.safe_load((ROOT / "configs" / "demo.yaml").read_text(encoding="utf-8"))
    content["clock"]["mode"] = "lockstep"
    return content


def small(**changes: Any) -> dict[str, Any]:
    """A short session: one pursuer that needs energy, a target that stands, a tanker; NED."""
    content: dict[str, Any] = {
        "schema": 1,
        "name": "small",
        "axes": "ned",
        "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0},
        "clock": {"mode": "lockstep"},
        "goal": {"duration_s": 40.0, "refuelled_at_least": 1},
        "vehicles": {
            "pursuers": [
                {"sysid": 1, "start_m": [2.0, 0.0, 0.0], "battery": {"capacity_j": 24000, "initial_percent": 40}}
            ],
            "targets": [
                {
                    "sysid": 101,
                    "start_m": [0.0, 0.0, 0.0],
                    "battery": {"capacity_j": 60000},
                    "path_m": [[0.0, 0.0, -2.5]],
                    "speed_m_s": 0.5,
                }
            ],
            "tankers": [{"sysid": 201, "start_m": [-3.0, 0.0, 0.0], "battery": {"capacity_j": 150000}}],
        },
        "formation": {"ring_m": 2.0},
    }
    return merged(content, changes)


def two_refuellings() -> dict[str, Any]:
    """The small one with a second pursuer to refuel, over a radio that loses, delays and shuffles."""
    content = small(
        goal={"duration_s": 45.0, "refuelled_at_least": 0, "pursue": {"within_m": 3.0, "for_s": 5.0}},
        radio={"loss": 0.03, "delay_s": 0.05, "jitter_s": 0.1},
        obstacles=[{"sphere_m": [6.0, 6.0, -2.0], "radius_m": 0.5, "name": "buoy"}],
    )
    content["vehicles"]["pursuers"].append(
        {"sysid": 2, "start_m": [2.0, 3.0, 0.0], "battery": {"capacity_j": 24000, "initial_percent": 55}}
    )
    return content


def merged(content: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Nested data with some of its keys replaced."""
    result = copy.deepcopy(dict(content))
    for key, value in changes.items():
        both = isinstance(value, Mapping) and isinstance(result.get(key), Mapping)
        result[key] = merged(result[key], value) if both else value
    return result


@dataclass
class Outcome:
    """A session that has ended."""

    status: int
    folder: Path
    stdout: str
    stderr: str

    @property
    def summary(self) -> dict[str, Any]:
        loaded: dict[str, Any] = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        return loaded

    @property
    def decisions(self) -> list[dict[str, Any]]:
        lines = (self.folder / "decisions.jsonl").read_text(encoding="utf-8").splitlines()
        return [json.loads(line) for line in lines]

    def vehicle(self, sysid: int) -> dict[str, Any]:
        found: dict[str, Any] = next(v for v in self.summary["vehicles"] if v["sysid"] == sysid)
        return found

    def messages(self, *types: str) -> Iterator[tuple[float, Any]]:
        """(session time, message) of the recorded frames, read by pymavlink; of frames of other types only the length
        is read."""
        tlog = self.folder / "session.tlog"
        for time_s, message in frames_of(tlog, types) if types else all_frames(tlog):
            yield time_s - self.epoch_s, message

    @functools.cached_property
    def epoch_s(self) -> float:
        """The session's time 0, Unix s."""
        scenario = yaml.safe_load((self.folder / "scenario.yaml").read_text(encoding="utf-8"))
        return datetime.fromisoformat(str(scenario["clock"]["epoch"])).timestamp()

    def truth(self, sysid: int) -> Truth:
        return read_truth(self.folder / "vehicles" / f"{sysid}.truth")


def all_frames(tlog: Path) -> Iterator[tuple[float, Any]]:
    """(Unix time, message) of a recording, as pymavlink reads its file."""
    reader = mavutil.mavlogfile(str(tlog), robust_parsing=False)
    try:
        while (message := reader.recv_match()) is not None:
            yield message._timestamp, message
    finally:
        reader.close()


def frames_of(tlog: Path, types: Sequence[str]) -> Iterator[tuple[float, Any]]:
    """(Unix time, message) of the frames of these types."""
    wanted = {number for number, kind in ardupilotmega.mavlink_map.items() if kind.msgname in types}
    assert len(wanted) == len(set(types)), types
    parser = ardupilotmega.MAVLink(None)
    for time_s, msgid, frame in raw_frames(tlog):
        if msgid in wanted:
            yield time_s, parser.decode(bytearray(frame))


def raw_frames(tlog: Path) -> Iterator[tuple[float, int, bytes]]:
    """(Unix time, message id, frame) of a recording; a frame that a killed process left unfinished is passed over.

    A record is a time, big-endian in us, and a frame: https://mavlink.io/en/guide/serialization.html.
    """
    raw = tlog.read_bytes()
    at = 0
    while at + 8 + 10 <= len(raw):
        head = raw[at + 8 : at + 18]
        if head[0] == 0xFD:
            length, msgid = 12 + head[1] + 13 * (head[2] & 1), int.from_bytes(head[7:10], "little")
        else:
            assert head[0] == 0xFE, f"no frame begins at byte {at + 8} of {tlog}"
            length, msgid = 8 + head[1], head[5]
        if at + 8 + length > len(raw):
            return
        yield int.from_bytes(raw[at : at + 8], "big") * 1e-6, msgid, raw[at + 8 : at + 8 + length]
        at += 8 + length


@dataclass
class Truth:
    """One vehicle's own knowledge; one row per grant."""

    head: dict[str, Any]
    time_s: np.ndarray
    state: np.ndarray
    energy: np.ndarray
    thrust: list[np.ndarray]

    @property
    def p_ned(self) -> np.ndarray:
        return self.state[:, :3]

    def drawn_from_thrust_j(self) -> np.ndarray:
        """Energy drawn up to each record, from the recorded thrust alone: P_hover (u1/g)^(3/2) + P_avionics."""
        head = self.head
        step_s, hover_w, avionics_w = head["step_s"], head["hover_w"], head["avionics_w"]
        spent = [
            float(np.sum((hover_w * (u / head["gravity_m_s2"]) ** 1.5 + avionics_w) * step_s)) for u in self.thrust
        ]
        return np.cumsum(spent)

    def ledger_error_j(self) -> float:
        """How far initial + received = drawn (from thrust) + given + remaining is off, at worst."""
        _, received, given, remaining = self.energy.T
        return float(np.abs(self.head["initial_j"] + received - self.drawn_from_thrust_j() - given - remaining).max())


def read_truth(path: Path) -> Truth:
    """Read a truth file; a record that a killed process left unfinished is passed over."""
    raw = path.read_bytes()
    line, _, body = raw.partition(b"\n")
    head = json.loads(line)
    numbers = np.frombuffer(body[: len(body) // 8 * 8], dtype="<f8")
    rows, thrust, at = [], [], 0
    width = 2 + STATE + 4
    while at + width <= len(numbers) and at + width + int(numbers[at + 1]) <= len(numbers):
        rows.append(numbers[at : at + width])
        at += width
        steps = int(numbers[at - width + 1])
        thrust.append(numbers[at : at + steps])
        at += steps
    table = np.array(rows).reshape(-1, width)
    return Truth(head, table[:, 0], table[:, 2 : 2 + STATE], table[:, 2 + STATE :], thrust)


def run_words(scenario: Mapping[str, Any] | str, folder: Path, *options: str, report: bool = False) -> list[str]:
    """Words of `gcs` that fly a scenario into `folder / "session"`."""
    name = scenario
    if isinstance(scenario, Mapping):
        name = str(folder / "scenario.yaml")
        Path(name).write_text(yaml.safe_dump(dict(scenario), sort_keys=False), encoding="utf-8")
    shown = [] if report else ["--no-report"]
    return ["run", name, "--trust", "--out", str(folder / "session"), *shown, *options]


class Running:
    """`gcs run` as a live process."""

    def __init__(
        self,
        scenario: Mapping[str, Any] | str,
        folder: Path,
        *options: str,
        file_limit: int | None = None,
        stdout: str | None = None,
        report: bool = False,
    ):
        self.folder = folder / "session"
        limit = [] if file_limit is None else ["prlimit", f"--fsize={file_limit}"]
        self.process = subprocess.Popen(
            [*limit, *GCS, *run_words(scenario, folder, *options, report=report)],
            stdout=subprocess.PIPE if stdout is None else os.open(stdout, os.O_WRONLY),
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        self._family: list[psutil.Process] = []

    def lines(self) -> Iterator[str]:
        """stdout, line by line; may be left and taken up again."""
        assert self.process.stdout is not None
        return iter(self.process.stdout.readline, "")

    def wait_for(self, wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        """The first `--json` snapshot that is as wanted; needs that option."""
        for line in self.lines():
            content: dict[str, Any] = json.loads(line)
            if content["type"] == "snapshot" and wanted(content):
                return content
            if content["type"] == "end":
                break
        raise AssertionError("the session ended before it came to what was awaited")

    def family(self) -> list[psutil.Process]:
        """The process and everything that it started, directly or not."""
        head = psutil.Process(self.process.pid)
        return [head, *head.children(recursive=True)]

    def vehicle(self, sysid: int) -> psutil.Process:
        """The process that writes a vehicle's log."""
        log = self.folder / "vehicles" / f"{sysid}.log"
        for process in self.family():
            with contextlib.suppress(OSError, psutil.Error):
                if os.readlink(f"/proc/{process.pid}/fd/1") == str(log.resolve()):
                    return process
        raise AssertionError(f"no process writes {log}")

    def named(self, word: str) -> psutil.Process:
        """The first process that has this word among its arguments and is no vehicle."""
        return next(p for p in self.family() if word in " ".join(p.cmdline()).split())  # a title is one argument

    def finish(self, patience_s: float = PATIENCE_S) -> Outcome:
        """Wait for the end."""
        stdout, stderr = self.process.communicate(timeout=patience_s)
        return Outcome(self.process.returncode, self.folder, stdout, stderr)

    def stop(self) -> None:
        """Make sure that nothing is left, whatever a test did."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
        with contextlib.suppress(subprocess.TimeoutExpired, ValueError):
            self.process.communicate(timeout=10)


def fly(scenario: Mapping[str, Any] | str, folder: Path, *options: str) -> Outcome:
    """Run a session to its end; the command in this process, all that it starts in processes of its own."""
    folder.mkdir(parents=True, exist_ok=True)
    with lasting():
        done = gcs(*run_words(scenario, folder, *options))
    return Outcome(done.returncode, folder / "session", done.stdout, done.stderr)


def fly_apart(
    scenario: Mapping[str, Any] | str, folder: Path, *options: str, patience_s: float = PATIENCE_S, **kwargs: Any
) -> Outcome:
    """The same with the command in a process of its own, as threads and limits need it."""
    folder.mkdir(parents=True, exist_ok=True)
    running = Running(scenario, folder, *options, **kwargs)
    try:
        return running.finish(patience_s)
    finally:
        running.stop()


def all_gone(processes: list[psutil.Process], within_s: float = 15.0) -> list[psutil.Process]:
    """Those that still live when the time is up; waits on the processes themselves."""
    deadline = time.monotonic() + within_s
    left = []
    for process in processes:
        try:
            fd = os.pidfd_open(process.pid)
        except ProcessLookupError:
            continue
        poll = select.poll()
        poll.register(fd, select.POLLIN)
        if not poll.poll(max(deadline - time.monotonic(), 0.0) * 1e3) and process.is_running():
            left.append(process)
        os.close(fd)
    return left
