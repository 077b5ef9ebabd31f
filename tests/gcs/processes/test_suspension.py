"""A process that did not run for a while knows it, and one that computed for as long does not take that for it."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

from gcs.processes.suspension import LEAST_S, SuspensionWatch, queued_s


class Clocks:
    wall_s, used_s = 100.0, 5.0

    def watch(self) -> SuspensionWatch:
        return SuspensionWatch(lambda: self.wall_s, lambda: self.used_s)


@pytest.mark.parametrize(
    ("gap_s", "computed_s", "away_s"),
    [(0.05, 0.01, 0.0), (LEAST_S - 0.1, 0.0, 0.0), (LEAST_S, 0.0, LEAST_S), (60.0, 0.02, 60.0), (20.0, 19.0, 0.0)],
)
def test_a_long_gap_without_computing_is_a_suspension(gap_s: float, computed_s: float, away_s: float) -> None:
    clocks = Clocks()
    watch = clocks.watch()
    clocks.wall_s += gap_s
    clocks.used_s += computed_s
    assert watch.look() == pytest.approx(away_s)
    clocks.wall_s += 0.05
    assert watch.look() == 0.0


@pytest.mark.parametrize(("computed_and_queued_s", "away_s"), [(0.5 + 4.0, 0.0), (0.5, 5.0)])
def test_a_gap_spent_waiting_for_a_processor_is_none(computed_and_queued_s: float, away_s: float) -> None:
    clocks = Clocks()
    watch = clocks.watch()
    clocks.wall_s += 5.0
    clocks.used_s += computed_and_queued_s
    assert watch.look() == pytest.approx(away_s)


@pytest.mark.parametrize("content", [None, "", "1", "1 x 2", "\0"])
def test_a_kernel_that_does_not_tell_costs_nothing(content: str | None, tmp_path: Path) -> None:
    told = tmp_path / "schedstat"
    if content is not None:
        told.write_text(content, encoding="ascii")
    assert queued_s(told) == 0.0


def test_the_kernel_counts_a_queue_for_a_processor_and_not_a_stop() -> None:
    """Three processes on one processor wait for two thirds of the time; one that is stopped waits for none."""
    spin = "import os,time\nos.sched_setaffinity(0,{0})\nend=time.monotonic()+20\nwhile time.monotonic()<end: pass"
    crowd = [subprocess.Popen([sys.executable, "-c", spin]) for _ in range(3)]
    try:
        one = Path(f"/proc/{crowd[0].pid}/schedstat")
        deadline_s = time.monotonic() + 20.0
        while queued_s(one) < 0.2:
            assert time.monotonic() < deadline_s
        os.kill(crowd[0].pid, signal.SIGSTOP)
        process = psutil.Process(crowd[0].pid)
        while process.status() != psutil.STATUS_STOPPED:
            assert time.monotonic() < deadline_s
        before_s, stopped_s = queued_s(one), time.monotonic()
        while time.monotonic() < stopped_s + 0.3:
            assert queued_s(one) == before_s
    finally:
        for each in crowd:
            each.kill()
            each.wait()
