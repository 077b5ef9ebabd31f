"""A process that did not run for a while knows it, and one that computed for as long does not take that for it."""

import pytest

from gcs.processes.suspension import LEAST_S, SuspensionWatch


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
