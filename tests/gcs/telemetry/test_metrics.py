"""Figures of hand-made flights: distances, paths, pursuit and tracking that are known beforehand."""

from typing import Any

import pytest
import views as base

from gcs.mavlink.setpoints import SetPoint
from gcs.scenario.model import Scenario
from gcs.telemetry.metrics import PLAN_MEMORY, Metrics
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView

BATTERY = {"capacity_j": 1e4}


def metrics(within_m: float = 3.0, **more_of_it: Any) -> Metrics:
    def vehicle(sysid: int, **more: Any) -> dict[str, Any]:
        return {"sysid": sysid, "start_m": (float(sysid), 0.0, 0.0), "battery": BATTERY} | more

    scenario = Scenario.model_validate({
        "schema": 1, "name": "m", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 0.0},
        "goal": {"duration_s": 60.0, "pursue": {"within_m": within_m, "for_s": 5.0}},
        "vehicles": {"pursuers": [vehicle(1), vehicle(2)],
                     "targets": [vehicle(101, path_m=[(0.0, 0.0, 0.0)], speed_m_s=1.0)]},
        **more_of_it,
    })  # fmt: skip
    return Metrics(scenario)


def view(sysid: int, at: Vec3, v: Vec3 = (0.0, 0.0, 0.0), age_s: float = 0.0, landed: bool = False) -> VehicleView:
    return base.view(sysid, p_ned=at, v_ned=v, age_s=age_s, landed=landed)


def update(m: Metrics, t_s: float, *views: VehicleView, points: Any = ()) -> None:
    m.update(FleetSnapshot(t_s, views, ()), points)


def test_nothing_flown_is_nothing_measured() -> None:
    m = metrics()
    update(m, 0.0, view(1, (0, 0, 0), landed=True), view(2, (0, 0, 0.1)))
    assert (m.path_length_m, m.pursuit_held_s) == ({}, 0.0)


def test_path_length_is_the_way_flown_without_the_gaps() -> None:
    m = metrics()
    for k, at in enumerate([(0, 0, 0), (3, 4, 0), (3, 4, 2)]):
        update(m, 0.1 * k, view(1, at))
    assert m.path_length_m == {1: 7.0}
    update(m, 0.3, view(1, (50, 0, 0), landed=True))
    update(m, 0.4, view(1, (60, 0, 0)))
    update(m, 0.5, view(1, (61, 0, 0)))
    assert m.path_length_m == {1: 8.0}


def test_pursuit_is_the_longest_unbroken_run_of_the_worst_pursuer() -> None:
    m = metrics()
    for k in range(100):  # 1 is away at 4 s; 2 only comes at 7 s
        first = (9.0, 0.0, 0.0) if k == 40 else (2.9, 0.0, 0.0)
        second = (0.0, 3.0, 0.0) if k >= 70 else (0.0, 3.1, 0.0)
        update(m, k / 10, view(1, first), view(2, second), view(101, (0.0, 0.0, 0.0)))
    # From 4.1 to 9.9 s, and from 7.0 to 9.9 s.
    assert m._pursuit.held_s == pytest.approx({1: 5.8, 2: 2.9})
    assert m.pursuit_held_s == pytest.approx(2.9)
    update(m, 10.0, view(1, (0, 0, 0)), view(2, (0, 0, 0)), view(101, (0, 0, 0), landed=True))
    update(m, 10.1, view(1, (0, 0, 0)), view(2, (0, 0, 0)), view(101, (0, 0, 0)))
    assert m.pursuit_held_s == pytest.approx(2.9)


def test_tracking_error_is_the_distance_from_the_planned_line_not_from_its_newest_point() -> None:
    m = metrics()
    for k in range(60):
        planned = [SetPoint(1, (0.1 * k, 0.0, -4.0), (1.0, 0.0, 0.0))]
        update(m, 0.1 * k, view(1, (max(0.1 * (k - 4), 0.0), 0.25 if k == 50 else 0.03, -4.0)), points=planned)
        if k < PLAN_MEMORY - 1:
            assert m.max_tracking_error_m == {}
        elif k < 50:
            assert m.max_tracking_error_m == pytest.approx({1: 0.03})
    assert m.max_tracking_error_m == pytest.approx({1: 0.25})


def test_a_plan_that_was_interrupted_is_not_joined_across_the_gap() -> None:
    m = metrics()
    for k in range(30):
        update(m, 0.1 * k, view(1, (0.1 * k, 0, 0)), points=[SetPoint(1, (0.1 * k, 0.0, 0.0), (1.0, 0.0, 0.0))])
    update(m, 3.0, view(1, (3, 0, 0)))
    for k in range(PLAN_MEMORY - 1):
        update(m, 4 + 0.1 * k, view(1, (50, 0, 0)), points=[SetPoint(1, (80.0, 0.0, 0.0), (0.0, 0.0, 0.0))])
    assert m.max_tracking_error_m[1] == pytest.approx(0.0, abs=1e-9)


def test_where_one_pursuer_is_chosen_it_is_the_target_that_must_be_followed() -> None:
    m = metrics(pursuit={"by": "competition"})
    for k in range(50):  # handed over from 1 to 2 at 2 s, without a gap
        chosen = {1: 101} if k < 20 else {2: 101}
        views = (view(1, (2.0 if k < 20 else 9.0, 0.0, 0.0)), view(2, (9.0 if k < 20 else 2.0, 0.0, 0.0)))
        m.update(FleetSnapshot(k / 10, (*views, view(101, (0.0, 0.0, 0.0))), ()), [], chosen)
        assert m.target_of == chosen
    assert m._pursuit.held_s == pytest.approx({101: 4.9})
