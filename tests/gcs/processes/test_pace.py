"""Pacing against a wall clock that only the test moves."""

import pytest

from gcs.processes.pace import MOST_PERIODS, Pace


class Wall:
    def __init__(self) -> None:
        self.now_s = 100.0

    def __call__(self) -> float:
        return self.now_s


@pytest.fixture
def wall() -> Wall:
    return Wall()


def started(wall: Wall, speed: float | None) -> Pace:
    pace = Pace(speed, wall)
    wall.now_s += 7.0  # vehicles start up
    pace.start()
    return pace


def test_lockstep_never_waits_nor_lags(wall: Wall) -> None:
    pace = started(wall, None)
    for _ in range(5):
        pace.next(0.1)
        wall.now_s += 3.0
        assert pace.wait_s() == 0.0
    assert (pace.lag_s, pace.running_wall_s) == (0.0, 15.0)


@pytest.mark.parametrize("speed", [0.5, 1.0, 5.0])
def test_ticks_fall_due_a_period_over_the_speed_apart(wall: Wall, speed: float) -> None:
    pace = started(wall, speed)
    for tick in range(50):
        assert wall.now_s == pytest.approx(107.0 + tick * 0.1 / speed)
        pace.next(0.1)
        wall.now_s += 0.3 * pace.wait_s()  # work within the period does not move the pace
        wall.now_s += pace.wait_s()
    assert pace.lag_s == pytest.approx(0.0, abs=1e-9)


def test_a_late_tick_moves_all_later_ones_and_is_counted(wall: Wall) -> None:
    pace = started(wall, 1.0)
    pace.next(0.1)
    wall.now_s += 0.35
    assert pace.wait_s() == 0.0
    pace.next(0.1)
    assert pace.lag_s == pytest.approx(0.25)
    assert pace.wait_s() == pytest.approx(0.1)
    wall.now_s += 0.1
    pace.next(0.1)
    assert (pace.lag_s, pace.wait_s()) == pytest.approx((0.25, 0.1))


def test_sleeps_that_end_late_do_not_slow_the_session(wall: Wall) -> None:
    pace = started(wall, 5.0)
    for _ in range(200):
        pace.next(0.1)
        wall.now_s += pace.wait_s() + 0.0008
    assert wall.now_s - 107.0 == pytest.approx(200 * 0.02, abs=0.001)
    assert pace.lag_s == 0.0


def test_ticks_that_take_longer_than_a_period_slow_it(wall: Wall) -> None:
    pace = started(wall, 1.0)
    for _ in range(100):
        pace.next(0.1)
        wall.now_s += max(pace.wait_s(), 0.13)
    assert wall.now_s - 107.0 == pytest.approx(13.0)
    assert 3.0 - 0.2 <= pace.lag_s <= 3.0  # the last period's lateness does not count yet


def test_a_pause_is_neither_running_time_nor_lag(wall: Wall) -> None:
    pace = started(wall, 2.0)
    pace.next(0.1)
    wall.now_s += 0.02
    pace.pause()
    wall.now_s += 30.0
    pace.pause()
    assert pace.paused
    assert pace.running_wall_s == pytest.approx(0.02)
    wall.now_s += 30.0
    pace.resume()
    pace.resume()
    assert not pace.paused
    assert pace.wait_s() == pytest.approx(0.03)
    wall.now_s += 0.03
    pace.next(0.1)
    assert pace.lag_s == pytest.approx(0.0, abs=1e-9)
    assert pace.running_wall_s == pytest.approx(0.05)


def test_beside_the_real_clock_a_late_tick_grants_what_has_gone_by_and_says_so(wall: Wall) -> None:
    """Ticks at 0, 0.1, 0.55 and 0.6 s: the third is four periods late, which the fourth need not know."""
    pace = Pace(1.0, wall, keeps_up=True)
    pace.start()
    begun_s, granted = wall.now_s, []
    for at_s in (0.0, 0.1, 0.55, 0.6):
        wall.now_s = begun_s + at_s
        granted.append(pace.next(0.1))
    assert granted == [1, 1, 4, 1]
    assert pace.lag_s == pytest.approx(0.3)
    assert pace.wait_s() == pytest.approx(0.1)
    assert sum(granted) * 0.1 == pytest.approx(wall.now_s + pace.wait_s() - begun_s)


def test_after_a_long_absence_grants_stay_short_and_follow_without_waiting(wall: Wall) -> None:
    pace = Pace(1.0, wall, keeps_up=True)
    pace.start()
    pace.next(0.1)
    wall.now_s += 60.0
    granted = []
    while pace.wait_s() == 0.0:
        granted.append(pace.next(0.1))
    assert max(granted) == MOST_PERIODS
    assert sum(granted) == pytest.approx(600, abs=1)
    assert len(granted) <= 600 / MOST_PERIODS + 1
