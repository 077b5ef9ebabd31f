"""The filtered planner and vehicles that have fallen silent, or follow their leaders or not: others keep away from
where they may be."""

import math
from collections import deque
from collections.abc import Sequence
from typing import Any

import pytest
from views import view

from gcs.mavlink.autopilots import FlightMode
from gcs.mavlink.setpoints import SetPoint
from gcs.planner.planner import Planner
from gcs.planner.request import PlanRequest
from gcs.planner.safe_planner import SafePlanner
from gcs.scenario.model import Scenario
from gcs.telemetry.state import FleetSnapshot, Vec3

PERIOD_S, SPEED_M_S = 0.1, 3.0
AHEAD_M = 10.0


def scenario(
    starts: Sequence[Vec3] = ((AHEAD_M, 0.0, -5.0), (0.0, 0.0, -5.0)),
    goals: Sequence[Vec3] = ((AHEAD_M, 0.0, -5.0), (30.0, 0.0, -5.0)),
) -> Scenario:
    """Vehicles 1 and so on, in the air at these places, each with one way point."""
    battery = {"capacity_j": 24_000.0}
    pursuers: list[dict[str, Any]] = [
        {"sysid": sysid, "start_m": start, "waypoints_m": [goal]}
        for sysid, (start, goal) in enumerate(zip(starts, goals, strict=True), 1)
    ]
    return Scenario.model_validate(
        {
            "schema": 1, "name": "silent", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
            "goal": {"duration_s": 60.0}, "planner": {"cruise_m_s": SPEED_M_S},
            "vehicles": {"pursuers": [one | {"airborne": True, "battery": battery} for one in pursuers]},
        }
    )  # fmt: skip


def gives_way_m(mode: FlightMode) -> float:
    """How far the leader of vehicle 1 has gone when the last report of vehicle 2, which flew at it, is 1.5 s old."""
    content = scenario()
    planner = SafePlanner(content, Planner(content))
    here = (AHEAD_M, 0.0, -5.0)
    for tick in range(16):
        age_s = tick * PERIOD_S
        vehicles = (
            view(1, p_ned=here),
            view(2, p_ned=(0.0, 0.0, -5.0), v_ned=(SPEED_M_S, 0.0, 0.0), mode=mode, age_s=age_s),
        )
        (point,) = planner.plan(PlanRequest(FleetSnapshot(20.0 + age_s, vehicles, ()), frozenset({1}), PERIOD_S))
    return math.dist(point.p_ned, here)


def test_a_silent_vehicle_is_looked_for_where_its_mode_takes_it() -> None:
    """Without set points it stops where it needs them, and flies on where it does not, as when it returns."""
    assert gives_way_m(FlightMode.RETURN) > gives_way_m(FlightMode.OFFBOARD) + 0.2


@pytest.mark.parametrize("begins_s", [3.5, 4.3, 5.0])
@pytest.mark.parametrize("stops_m", [1.2, 1.8, 2.4])
def test_others_stay_out_of_the_way_up_of_a_silent_one_wherever_it_has_stopped(stops_m: float, begins_s: float) -> None:
    """Vehicle 2 flew at 3 m/s when it last reported, so that it stops after 1.1 to 3 m, and climbs home from there some
    time after its last HEARTBEAT; vehicle 1 wants to be 1.3 m above that place."""
    there = (0.0, 0.0, -5.0)
    content = scenario(((stops_m, -5.0, -6.3), there), ((stops_m, 0.0, -6.3), (30.0, 0.0, -5.0)))
    planner, follower = SafePlanner(content, Planner(content)), Follower((stops_m, -5.0, -6.3))
    nearest_m = math.inf
    for tick in range(100):
        age_s = tick * PERIOD_S
        own_ned, v_ned = follower.fly()
        vehicles = (view(1, p_ned=own_ned, v_ned=v_ned), view(2, p_ned=there, v_ned=(SPEED_M_S, 0.0, 0.0), age_s=age_s))
        (point,) = planner.plan(PlanRequest(FleetSnapshot(20.0 + age_s, vehicles, ()), frozenset({1}), PERIOD_S))
        climbs_s = max(age_s - begins_s, 0.0)
        up_m = 5.0 * climbs_s - 3.125 if climbs_s > 1.25 else 2.0 * climbs_s**2
        if age_s > 1.5:
            nearest_m = min(nearest_m, math.dist(own_ned, (stops_m, 0.0, -5.0 - up_m)))
        follower.receive(point)
    assert nearest_m >= content.planner.separation_m


def nearest_to_rest_m(mode: FlightMode) -> float:
    """How near the leader of vehicle 2, on its way along the row, comes to where vehicle 1 would rest if it braked at
    4 m/s²: 1.2 m ahead of where it is at first."""
    content = scenario()
    planner = SafePlanner(content, Planner(content))
    rest, speed_m_s = (1.2, 0.0, -5.0), 1.6
    here = (rest[0] - speed_m_s**2 / 8.0, 0.0, -5.0)
    p_ned, nearest_m = (0.0, 0.0, -5.0), math.inf
    for tick in range(20):
        vehicles = (
            view(1, p_ned=here, v_ned=(speed_m_s, 0.0, 0.0), mode=mode),
            view(2, p_ned=p_ned),
        )
        time_s = 20.0 + tick * PERIOD_S
        (point,) = planner.plan(PlanRequest(FleetSnapshot(time_s, vehicles, ()), frozenset({2}), PERIOD_S))
        p_ned = point.p_ned
        nearest_m = min(nearest_m, math.dist(p_ned, rest))
    return nearest_m


@pytest.mark.parametrize("mode", [FlightMode.HOLD, FlightMode.TAKEOFF, FlightMode.RETURN])
def test_one_that_flies_by_itself_may_stop_and_come_back_at_any_time(mode: FlightMode) -> None:
    assert nearest_to_rest_m(mode) >= scenario().planner.separation_m


@pytest.mark.parametrize("ordered", [True, False])
@pytest.mark.parametrize("begins_s", [0.6, 0.8, 1.0, 1.4])
def test_others_stay_out_of_the_way_up_of_one_that_takes_off(ordered: bool, begins_s: float) -> None:
    """Vehicle 1 stands 2 m ahead of vehicle 2, which would pass over it; it is to be armed, and shows no mode of its
    own for a take-off, or shows one that another station has ordered."""
    content = scenario(((2.0, 0.0, 0.0), (0.0, 0.0, -0.5)), ((2.0, 0.0, 0.0), (30.0, 0.0, -0.5)))
    planner = SafePlanner(content, Planner(content))
    there, nearest_m = (0.0, 0.0, -0.5), math.inf
    mode, takes_off = (FlightMode.HOLD, frozenset({1})) if ordered else (FlightMode.TAKEOFF, frozenset())
    for tick in range(30):
        climbs_s = max(tick * PERIOD_S - begins_s, 0.0)
        up_m_s, up_m = min(3.0 * climbs_s, 1.5), max(1.5 * climbs_s - 0.375, 1.5 * min(climbs_s, 0.5) ** 2)
        one = (2.0, 0.0, -min(up_m, content.vehicles.pursuers[0].takeoff_m))
        stands = {"landed": up_m == 0.0, "armed": up_m > 0.0 or not ordered, "ground_down_m": 0.0}
        vehicles = (
            view(1, p_ned=one, v_ned=(0.0, 0.0, -up_m_s), mode=mode, **stands),
            view(2, p_ned=there, ground_down_m=0.0),
        )
        snapshot = FleetSnapshot(20.0 + tick * PERIOD_S, vehicles, ())
        (point,) = planner.plan(PlanRequest(snapshot, frozenset({2}), PERIOD_S, takes_off=takes_off))
        there = point.p_ned
        nearest_m = min(nearest_m, math.dist(one, there))
    assert nearest_m >= content.planner.separation_m


class Follower:
    """A vehicle that is where its leader was four periods ago, on the way that it flies at a constant velocity."""

    def __init__(self, p_ned: Vec3, v_ned: Vec3 = (0.0, 0.0, 0.0)) -> None:
        way = [tuple(x + PERIOD_S * k * v for x, v in zip(p_ned, v_ned, strict=True)) for k in range(4)]
        self._way: deque[tuple[Any, Any]] = deque((place, v_ned) for place in way)

    def fly(self) -> tuple[Vec3, Vec3]:
        return self._way.popleft()

    def receive(self, point: SetPoint) -> None:
        self._way.append((point.p_ned, point.v_ned))


@pytest.mark.parametrize("gap_m", [2.0, 2.5, 3.0])
@pytest.mark.parametrize("mode", [FlightMode.TAKEOFF, FlightMode.HOLD])
def test_one_that_follows_set_points_without_having_said_so_comes_to_rest(mode: FlightMode, gap_m: float) -> None:
    """Its HEARTBEATs are lost, and another vehicle hovers on its way."""
    content = scenario()
    planner, follower = SafePlanner(content, Planner(content)), Follower((0.0, 0.0, -5.0), (2.0, 0.0, 0.0))
    other = (gap_m + 0.6, 0.0, -5.0)
    for tick in range(40):
        p_ned, v_ned = follower.fly()
        vehicles = (view(1, p_ned=other), view(2, p_ned=p_ned, v_ned=v_ned, mode=mode))
        snapshot = FleetSnapshot(20.0 + tick * PERIOD_S, vehicles, ())
        (point,) = planner.plan(PlanRequest(snapshot, frozenset({2}), PERIOD_S))
        follower.receive(point)
        assert math.dist(p_ned, other) >= content.planner.separation_m
    assert math.hypot(*v_ned) < 0.1


def meets_m(approaches: frozenset[int]) -> list[float]:
    """Distance of a tanker from its receiver in each tick, as it comes from the side, and how far the receiver has
    moved at the end. Vehicles are where their leaders are."""
    content = scenario().model_dump(mode="json", by_alias=True)
    content["planner"]["separation_m"] = 2.0
    content["vehicles"]["pursuers"] = content["vehicles"]["pursuers"][:1]
    content["vehicles"]["tankers"] = [
        {"sysid": 3, "start_m": (AHEAD_M + 6.0, 0.5, -5.0), "airborne": True, "battery": {"capacity_j": 1e5}}
    ]
    loaded = Scenario.model_validate(content)
    planner = SafePlanner(loaded, Planner(loaded))
    start = here = (AHEAD_M, 0.0, -5.0)
    tanker: Vec3 = (AHEAD_M + 6.0, 0.5, -5.0)
    v_ned, tanker_v_ned = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    away_m = []
    for tick in range(150):
        vehicles = (
            view(1, p_ned=here, v_ned=v_ned),
            view(3, "tanker", p_ned=tanker, v_ned=tanker_v_ned),
        )
        request = PlanRequest(FleetSnapshot(20.0 + tick * PERIOD_S, vehicles, ()), frozenset({1, 3}), PERIOD_S)
        own, other = planner.plan(request._replace(rendezvous={3: 1}, approaches=approaches))
        (here, v_ned), (tanker, tanker_v_ned) = (own.p_ned, own.v_ned), (other.p_ned, other.v_ned)
        away_m.append(math.dist(here, tanker))
    return [*away_m, math.dist(here, start)]


def test_a_tanker_keeps_its_distance_until_it_is_to_serve() -> None:
    *away_m, moved_m = meets_m(frozenset({3}))
    assert min(away_m) >= 2.0
    assert away_m[-1] < 2.5
    assert moved_m < 0.5


def test_a_tanker_that_serves_stands_at_its_height() -> None:
    *away_m, moved_m = meets_m(frozenset())
    assert away_m[-1] == pytest.approx(1.2, abs=0.1)
    assert min(away_m) >= 0.6
    assert moved_m < 0.5
