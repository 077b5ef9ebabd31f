"""How figures are measured: CPU time, interleaved rounds, medians, and a calibration of the machine of the moment."""

from __future__ import annotations

import math
import os
import resource
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

REFERENCE_STEPS_S = 3.9e6
"""Steps of the calibration loop per CPU second, by CPython 3.11, on the machine where these figures were first taken:
two cores of an AMD EPYC under Firecracker, left to itself."""
ROOT = Path(__file__).resolve().parents[2]
SUPPORT = ROOT / "tests" / "support"
CALIBRATION_STEPS = 400_000
ROUNDS = 7


@dataclass(frozen=True)
class Figure:
    """One line of the table. The goal is for `value`, or for `ratio`: to be at least that, or, `at_most`, at most."""

    id: int
    name: str
    value: float
    unit: str
    goal: float | None = None
    at_most: bool = False
    goal_is_ratio: bool = False
    peer: str = ""
    peer_value: float | None = None
    cpu_s: float | None = None

    @property
    def ratio(self) -> float | None:
        """How many times better than the peer."""
        if not self.peer_value or not self.value:
            return None
        return self.peer_value / self.value if self.at_most else self.value / self.peer_value

    @property
    def met(self) -> bool | None:
        """Whether the goal is reached; None where there is none."""
        if self.goal is None:
            return None
        if self.goal_is_ratio:
            return self.ratio is not None and self.ratio >= self.goal
        return self.value <= self.goal if self.at_most else self.value >= self.goal


@dataclass(frozen=True)
class Scale:
    """This machine's speed now over the reference's, in CPU time and on the wall: 1 is as fast."""

    cpu: float
    wall: float


def used_cpu_s(of: int = resource.RUSAGE_SELF) -> float:
    """Processor time of this process, or with `RUSAGE_CHILDREN` of all that were waited for."""
    used = resource.getrusage(of)
    return used.ru_utime + used.ru_stime


def children_cpu_s() -> float:
    """Processor time of all processes that were waited for."""
    return used_cpu_s(resource.RUSAGE_CHILDREN)


def cpu_s_of(pid: int) -> float:
    """Processor time of a process that runs, without that of its children."""
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _pendulum(steps: int) -> float:
    """Damped pendulum, Euler, on scalar floats: what the flight law's arithmetic is made of."""
    angle, rate, dt = 1.0, 0.0, 1e-3
    for _ in range(steps):
        rate += dt * (-9.81 * math.sin(angle) - 0.1 * rate * math.sqrt(1.0 + rate * rate))
        angle += dt * rate
        rate /= 1.0 + 1e-9 * math.exp(-angle * angle)
    return angle


def calibrate() -> Scale:
    """Run the loop and compare."""
    _pendulum(1)
    cpu, wall = [], []
    for _ in range(ROUNDS):
        wall_s, cpu_s = time.perf_counter(), time.process_time()
        _pendulum(CALIBRATION_STEPS)
        cpu.append(time.process_time() - cpu_s)
        wall.append(time.perf_counter() - wall_s)
    reference_s = CALIBRATION_STEPS / REFERENCE_STEPS_S
    return Scale(reference_s / statistics.median(cpu), reference_s / statistics.median(wall))


@dataclass(frozen=True)
class Prepared:
    """A job, and what has to be done before each of its calls, whose time does not count."""

    before: Callable[[], object]
    job: Callable[[], object]

    def timed(self, count: int) -> float:
        """CPU seconds of so many calls."""
        spent_s = 0.0
        for _ in range(count):
            self.before()
            begun_s = time.process_time()
            self.job()
            spent_s += time.process_time() - begun_s
        return spent_s


def _timed(job: Callable[[], object] | Prepared, count: int) -> float:
    if isinstance(job, Prepared):
        return job.timed(count)
    begun_s = time.process_time()
    for _ in range(count):
        job()
    return time.process_time() - begun_s


def cpu_times(*jobs: Callable[[], object] | Prepared, least_s: float = 0.02) -> list[float]:
    """CPU seconds of one call of each job: medians over rounds in which they take turns."""
    repeats = []
    for job in jobs:
        _timed(job, 1)
        count, spent = 0, 0.0
        while spent < least_s:
            spent += _timed(job, 1)
            count += 1
        repeats.append(count)
    rounds: list[list[float]] = [[] for _ in jobs]
    for _ in range(ROUNDS):
        for job, count, times in zip(jobs, repeats, rounds, strict=True):
            times.append(_timed(job, count) / count)
    return [statistics.median(times) for times in rounds]
