"""Figures of hand-made flights: distances, paths, pursuit and tracking that are known beforehand."""

import itertools
import math
from typing import Any

import numpy as np
import pytest
from changing import ChangingFleet

from gcs.mavlink.autopilots import PX4, FlightMode
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


def view(
    sysid: int, at: Vec3, v: Vec3 = (0.0, 0.0, 0.0), age_s: float = 0.0, landed: bool = False, way_m: float = 0.0
) -> VehicleView:
    return VehicleView(
        sysid=sysid, role="pursuer", label="", alive=True, profile=PX4, mode=FlightMode.OFFBOARD, armed=True,
        landed=landed, last_received_s=0.0, p_ned=at, v_ned=v, age_s=age_s, heading_rad=0.0,
        origin_offset_ned=(0.0, 0.0, 0.0), ground_amsl_m=0.0, capacity_j=1e4, initial_j=1e4, battery_reported=True,
        drawn_j=0.0, received_j=0, given_j=0, given_reported_s=0.0, power_w=0.0, energy_source="none",
        control_effort=0.0, way_m=way_m,
    )  # fmt: skip


def update(m: Metrics, t_s: float, *views: VehicleView, points: Any = ()) -> None:
    m.update(FleetSnapshot(t_s, views, ()), points)


def test_nothing_flown_is_nothing_measured() -> None:
    m = metrics()
    update(m, 0.0, view(1, (0, 0, 0), landed=True), view(2, (0, 0, 0.1)))
    assert (m.path_length_m, m.pursuit_held_s) == ({}, 0.0)


def test_path_length_is_the_way_flown_without_the_gaps() -> None:
    m = metrics()
    for k, (at, way_m) in enumerate([((0, 0, 0), 2.0), ((3, 4, 0), 7.0), ((3, 4, 2), 9.0)]):
        update(m, 0.1 * k, view(1, at, way_m=way_m))
    assert m.path_length_m == {1: 7.0}
    update(m, 0.3, view(1, (50, 0, 0), landed=True, way_m=60.0))
    update(m, 0.4, view(1, (60, 0, 0), way_m=70.0))
    update(m, 0.5, view(1, (61, 0, 0), way_m=71.0))
    assert m.path_length_m == {1: 8.0}


def test_a_way_across_a_silence_counts_and_what_is_carried_forward_does_not() -> None:
    m = metrics()
    for k in range(60):
        update(m, 0.1 * k, view(1, (1.0, 0, 0), v=(2.0, 0, 0), age_s=0.1 * k, way_m=5.0))
    assert m.path_length_m == {1: 0.0}
    update(m, 6.0, view(1, (10.0, 0, 0), v=(2.0, 0, 0), age_s=0.3, way_m=14.0))
    assert m.path_length_m == {1: 9.0}


def test_a_way_ends_with_an_empty_battery_and_goes_on_with_a_charged_one() -> None:
    m = metrics()
    for k, (down_m, empty) in enumerate([(-9.0, False), (-8.0, False), (-6.0, True), (-2.0, True), (-1.0, False)]):
        update(m, k / 10, view(1, (0, 0, down_m), way_m=9.0 + down_m)._replace(battery_empty=empty))
    assert m.path_length_m == {1: 2.0}


def test_the_way_to_the_last_report_counts_and_pursuit_ends_with_the_last_tick() -> None:
    m = metrics()
    for k, north_m in enumerate([0.0, 1.0, 2.5]):
        ways = {"way_m": north_m}
        update(m, k / 10, view(1, (north_m, 0, 0), **ways), view(2, (0, 0, 0)), view(101, (north_m, 1, 0), **ways))
    held_s = dict(m._pursuit.held_s)
    last = view(1, (4.5, 0, 0), way_m=4.5), view(2, (0, 0, 0)), view(101, (4.5, 1, 0), way_m=4.5)
    m.finish(FleetSnapshot(0.3, last, ()))
    assert m.path_length_m == {1: 4.5, 2: 0.0, 101: 4.5}
    assert m._pursuit.held_s == held_s
    assert held_s[1] == pytest.approx(0.2)


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


def test_a_late_report_is_held_against_the_path_that_was_planned_by_its_own_time() -> None:
    m = metrics()
    for k in range(60):  # a circle of 5 m flown 0.3 m outside; each report comes 0.4 s late
        angle, then = 0.2 * 0.1 * k, 0.2 * 0.1 * (k - 4)
        planned = [SetPoint(1, (5.0 * math.cos(angle), 5.0 * math.sin(angle), -4.0), (0.0, 1.0, 0.0))]
        at = (5.3 * math.cos(then), 5.3 * math.sin(then), -4.0)
        update(m, 0.1 * k, view(1, at, v=(8.0, 0.0, 0.0), age_s=0.4), points=planned)
    # the path is a polygon of chords of 0.1 m
    assert m.max_tracking_error_m == pytest.approx({1: 0.3}, abs=5e-4)


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


def test_figures_of_a_changing_fleet_are_those_of_its_vehicles_one_by_one() -> None:
    fleet, m, memory = ChangingFleet((1, 2, 101), seed=2), metrics(100.0), 20
    last: dict[int, Any] = {}
    lengths_m: dict[int, float] = {}
    errors_m: dict[int, float] = {}
    plans: dict[int, list[tuple[float, Vec3]]] = {1: [], 2: [], 101: []}
    measured_s: dict[int, float] = {}
    ticks_s: list[float] = []
    since_s: dict[int, float] = {}
    held_s = {1: 0.0, 2: 0.0}
    steered = {1, 2, 101}
    for _ in range(1500):
        stamped, _ = fleet.tick()
        if fleet.chance.random() < 0.02:
            steered ^= {fleet.chance.choice((1, 2, 101))}
        points = [
            SetPoint(view.sysid, tuple(x + fleet.chance.gauss(0.0, 0.1) for x in view.p_ned), view.v_ned)  # type: ignore
            for view in stamped.vehicles
            if view.sysid in steered and view.p_ned is not None
        ]
        m.update(stamped, points)
        here = {view.sysid: view.p_now_ned() for view in stamped.vehicles if view.flying and view.fresh}
        up = {view.sysid: view.p_ned for view in stamped.vehicles if view.flying}
        charged = {view.sysid for view in stamped.vehicles if view.remaining_j > 0.0}
        for sysid in up.keys() & last.keys() & charged:
            lengths_m[sysid] = lengths_m.get(sysid, 0.0) + math.dist(up[sysid], last[sysid])
        last = up
        planned = {point.sysid: point.p_ned for point in points}
        ticks_s.append(stamped.time_s)
        for sysid, plan in plans.items():
            if sysid in planned:
                goes_on = bool(plan) and plan[-1][0] == ticks_s[-2]
                plans[sysid] = [*(plan if goes_on else []), (stamped.time_s, planned[sysid])]
            reported_s = stamped.time_s - stamped.vehicle(sysid).age_s
            if sysid not in here or reported_s <= measured_s.get(sysid, -1.0) + 1e-6:
                continue
            measured_s[sysid] = reported_s
            by_then = [(t_s, point) for t_s, point in plans[sysid] if t_s <= reported_s + 1e-6][-memory:]
            if len(by_then) == memory and by_then[-1][0] == max(t_s for t_s in ticks_s if t_s <= reported_s + 1e-6):
                error_m = _off_m(up[sysid], [point for _, point in by_then])
                errors_m[sysid] = max(errors_m.get(sysid, 0.0), error_m)
        for sysid in (1, 2):
            near = sysid in here and 101 in here and math.dist(here[sysid], here[101]) <= 100.0
            begun_s = since_s.setdefault(sysid, fleet.time_s) if near else since_s.pop(sysid, None)
            if near and begun_s is not None:
                held_s[sysid] = max(held_s[sysid], fleet.time_s - begun_s)
    assert m.path_length_m == pytest.approx(lengths_m, rel=1e-12)
    assert m.max_tracking_error_m == pytest.approx(errors_m, rel=1e-9)
    assert m._pursuit.held_s == pytest.approx(held_s, abs=1e-9)
    assert min(*lengths_m.values(), *errors_m.values(), *held_s.values()) > 0.0


def _off_m(place: Vec3, line: list[Vec3]) -> float:
    """Distance of a point to a polyline, by the perpendicular of each of its pieces."""
    at = np.array(place)
    off = []
    for a, b in itertools.pairwise(map(np.array, line)):
        share = np.clip((at - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
        off.append(float(np.linalg.norm(a + share * (b - a) - at)))
    return min(off)
