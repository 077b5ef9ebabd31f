"""Who pursues: predicted efforts by hand, and the races' rules."""

from typing import Any

import numpy as np
import pytest
import views as base
from hypothesis import given
from hypothesis import strategies as st

from gcs.refuelling.target_assignment import TargetAssignment, predicted_effort
from gcs.scenario.model import PursuitRules as Rules
from gcs.telemetry.state import GRAVITY_M_S2, FleetSnapshot, Vec3, VehicleView

STILL: Vec3 = (0.0, 0.0, 0.0)
SPEED = 2.0


def view(sysid: int, *at: float, role: str = "pursuer", **changed: Any) -> VehicleView:
    return base.view(sysid, role, p_ned=at, **changed)


def pursuit(targets: tuple[int, ...] = (101,), pursuers: tuple[int, ...] = (1, 2, 3), **rules: Any) -> TargetAssignment:
    return TargetAssignment(Rules(by="competition", **rules), pursuers, targets, SPEED)


def run(races: TargetAssignment, views: list[VehicleView], from_s: float, to_s: float) -> dict[int, int]:
    chosen: dict[int, int] = {}
    for k in range(round(from_s * 10), round(to_s * 10) + 1):
        chosen = races.decide(FleetSnapshot(k / 10, tuple(views), ()))
    return chosen


def test_effort_to_a_still_target_is_the_weight_for_the_way_and_the_speed_gained() -> None:
    assert predicted_effort(STILL, STILL, (6.0, 8.0, 0.0), STILL, SPEED) == pytest.approx(GRAVITY_M_S2 * 5.0 + SPEED)


def test_a_vehicle_on_its_way_already_needs_no_change_of_speed() -> None:
    assert predicted_effort(STILL, (2.0, 0.0, 0.0), (10.0, 0.0, 0.0), STILL, SPEED) == pytest.approx(GRAVITY_M_S2 * 5)


def test_a_target_that_comes_is_met_sooner_and_one_that_flees_later() -> None:
    # 10 m apart: closing at 3 m/s, or at 1 m/s.
    comes = predicted_effort(STILL, (2.0, 0.0, 0.0), (10.0, 0.0, 0.0), (-1.0, 0.0, 0.0), SPEED)
    flees = predicted_effort(STILL, (2.0, 0.0, 0.0), (10.0, 0.0, 0.0), (1.0, 0.0, 0.0), SPEED)
    assert (comes, flees) == pytest.approx((GRAVITY_M_S2 * 10 / 3, GRAVITY_M_S2 * 10))


numbers = st.floats(-50, 50)
vectors = st.tuples(numbers, numbers, numbers)


@given(vectors, vectors, vectors, vectors)
def test_effort_is_finite_and_never_negative(p: Vec3, v: Vec3, target_p: Vec3, target_v: Vec3) -> None:
    effort = predicted_effort(p, v, target_p, target_v, SPEED)
    assert np.isfinite(effort)
    assert effort >= 0.0


def test_the_nearest_pursues_from_the_first_tick_and_the_others_hold() -> None:
    races = pursuit()
    views = [view(1, 9.0, 0.0, -5.0), view(2, 3.0, 0.0, -5.0), view(3, 5.0, 0.0, -5.0)]
    views.append(view(101, 0.0, 0.0, -5.0, role="target"))
    assert run(races, views, 0.0, 0.0) == {2: 101}
    (record,) = races.records
    assert (record["kind"], record["pursuer"], record["before"]) == ("pursuit", 2, None)
    assert record["efforts"]["2"] == min(record["efforts"].values())


def test_another_takes_over_when_it_needs_clearly_less_and_not_at_once() -> None:
    races = pursuit()
    target = view(101, 0.0, 0.0, -5.0, role="target")
    assert run(races, [view(1, 3.0, 0.0, -5.0), view(2, 9.0, 0.0, -5.0), target], 0.0, 5.0) == {1: 101}
    moved = [view(1, 9.0, 0.0, -5.0), view(2, 3.0, 0.0, -5.0), target]
    assert run(races, moved, 5.1, 5.2) == {1: 101}
    assert run(races, moved, 5.3, 10.0) == {2: 101}


def test_a_small_lead_does_not_change_the_pursuer() -> None:
    target = view(101, 0.0, 0.0, -5.0, role="target")
    before = [view(1, 10.0, 0.0, -5.0), view(2, 10.5, 0.0, -5.0), target]
    after = [view(1, 10.0, 0.0, -5.0), view(2, 9.5, 0.0, -5.0), target]
    for hysteresis, expected in ((0.1, {1: 101}), (0.0, {2: 101})):
        races = pursuit(hysteresis=hysteresis)
        assert run(races, before, 0.0, 5.0) == {1: 101}
        assert run(races, after, 5.1, 60.0) == expected


def test_each_target_gets_a_pursuer_of_its_own() -> None:
    races = pursuit((101, 102))
    views = [view(1, 1.0, 0.0, -5.0), view(2, 8.0, 0.0, -5.0), view(3, 20.0, 0.0, -5.0)]
    views += [view(101, 0.0, 0.0, -5.0, role="target"), view(102, 0.5, 1.0, -5.0, role="target")]
    assert run(races, views, 0.0, 20.0) == {1: 101, 2: 102}


def test_more_targets_than_pursuers_leave_the_last_ones_alone() -> None:
    views = [view(1, 1.0, 0.0, -5.0), *(view(sysid, 0.0, 0.0, -5.0, role="target") for sysid in (101, 102))]
    assert run(pursuit((101, 102)), views, 0.0, 5.0) == {1: 101}


def test_a_pursuer_that_is_lost_is_replaced_in_the_same_tick() -> None:
    races = pursuit()
    target = view(101, 0.0, 0.0, -5.0, role="target")
    run(races, [view(1, 3.0, 0.0, -5.0), view(2, 9.0, 0.0, -5.0), target], 0.0, 5.0)
    lost = view(1, 3.0, 0.0, -5.0, alive=False)
    assert run(races, [lost, view(2, 9.0, 0.0, -5.0), target], 5.1, 5.1) == {2: 101}


def measured(*efforts: float, age_s: float = 0.0) -> list[VehicleView]:
    """Pursuers that have reported these, and a target beside the last one."""
    views = [view(i + 1, 4.0 * i, 0.0, -5.0, control_effort=e, effort_age_s=age_s) for i, e in enumerate(efforts)]
    return [*views, view(101, 4.0 * len(efforts), 0.0, -5.0, role="target")]


def test_by_measured_effort_nobody_pursues_before_the_least_has_left_the_others_behind() -> None:
    """Bids 1, 0.505, 0.01 by min-max: from equal states the second is at 1.41 % of the winner, where with the floor's
    own its square is a ten-thousandth of the sum, after ln(1/0.0141)/0.495 = 8.6 s."""
    rules = {"bids": "measured", "p": 2.0, "rate": 1.0, "share": 0.9999, "hysteresis": 0.0}
    races = pursuit(**rules)
    assert run(races, measured(120.0, 100.0, 110.0), 0.0, 8.4) == {}
    assert run(races, measured(120.0, 100.0, 110.0), 8.5, 8.8) == {2: 101}
    assert run(races, measured(120.0, 100.0, 110.0), 8.9, 20.0) == {2: 101}
    assert run(races, measured(120.0, 130.0, 110.0), 20.1, 24.0) == {2: 101}
    assert run(races, measured(120.0, 130.0, 110.0), 24.1, 60.0) == {3: 101}


def test_measured_efforts_are_compared_as_of_now() -> None:
    """A report of 100 that is 2 s old stands for 119.6, and loses against 115 of now."""
    (old, *_), (_, new, *others) = measured(100.0, 115.0, age_s=2.0), measured(100.0, 115.0)
    races = pursuit(bids="measured", hysteresis=0.0)
    assert run(races, [old, new, *others], 0.0, 30.0) == {2: 101}
    assert old._replace(landed=True).effort_now == 100.0


def test_nobody_pursues_a_target_that_does_not_fly_and_those_with_a_course_of_their_own_do_not_race() -> None:
    on_ground = view(101, 0.0, 0.0, 0.0, role="target", landed=True)
    assert run(pursuit(), [view(1, 3.0, 0.0, -5.0), on_ground], 0.0, 1.0) == {}
    views = [view(1, 3.0, 0.0, -5.0), view(2, 9.0, 0.0, -5.0), view(101, 0.0, 0.0, -5.0, role="target")]
    assert run(pursuit(pursuers=(2,)), views, 0.0, 1.0) == {2: 101}
