"""The goal's measures, of those alone to whom something happens against those of everybody in every tick."""

from typing import Any

import numpy as np
import pytest
from changing import ChangingFleet
from views import snapshot, view

from gcs.mavlink.autopilots import End, FlightMode
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import ArmingSequence, Stage
from gcs.supervisor.factory import make_arming_sequences
from gcs.supervisor.fleet_arming import FleetArming
from gcs.supervisor.goal_watch import GoalWatch
from gcs.telemetry.state import VehicleView
from skytender import geometry

SYSIDS = (1, 2, 3, 101, 201)
ORDERS: tuple[End, ...] = ("hold", "return", "land")
OBSTACLES = [{"sphere_m": (3.0, 0.0, -2.0), "radius_m": 1.0}]


def scenario(**goal: Any) -> Scenario:
    def vehicle(sysid: int, **more: Any) -> dict[str, Any]:
        return {"sysid": sysid, "start_m": (5.0 * sysid, 0.0, 0.0), "battery": {"capacity_j": 1e4}} | more

    ways = {1: [(1.0, 0.0, -1.0), (1.0, 1.0, -1.0)], 3: [(3.0, 0.0, -1.0), (4.0, 3.0, -2.0), (90.0, 0.0, -1.0)]}
    pursuers = [vehicle(sysid, waypoints_m=ways.get(sysid, [])) for sysid in SYSIDS[:3]]
    return Scenario.model_validate({
        "schema": 1, "name": "m", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 0.0},
        "goal": {"duration_s": 60.0, "separation_m": 0.4, "clearance_m": 0.3, "ground": True, **goal},
        "vehicles": {"pursuers": pursuers,
                     "targets": [vehicle(101, path_m=[(0.0, 0.0, 0.0)], speed_m_s=1.0)],
                     "tankers": [vehicle(201, reserve_j=0.0)]},
        "obstacles": OBSTACLES, "planner": {"step_m": 0.3},
    })  # fmt: skip


def memory(watch: GoalWatch) -> dict[str, Any]:
    near = watch.believed
    return {
        "lost": list(watch._lost.items()), "flew": watch._flew, "up": watch._up, "missed": watch._waypoints.missed,
        "near": (near.separation, near.clearance, near.traffic, near.ground),
    }  # fmt: skip


@pytest.mark.parametrize("seed", [10, 12])
def test_what_is_measured_is_the_same_when_everybody_is_looked_at_in_every_tick(seed: int) -> None:
    fleet, told = ChangingFleet(SYSIDS, seed), scenario()
    sequences: dict[int, ArmingSequence] = make_arming_sequences(told)
    arming, shapes = FleetArming(sequences), geometry.of_scenario(told.obstacles)
    some, everybody = GoalWatch(told, shapes, arming), GoalWatch(told, shapes, arming)
    looked_at: list[int] = []
    look_at = some._look_at
    some._look_at = lambda view, *rest: (looked_at.append(view.sysid), look_at(view, *rest))  # type: ignore
    broken: set[str] = set()
    ticks = 1500
    for tick in range(ticks):
        sysid = fleet.chance.choice(SYSIDS)
        match fleet.chance.randrange(300):
            case 0:
                some.lose(sysid, fleet.time_s, "gone")
                everybody.lose(sysid, fleet.time_s, "gone")
            case 1:
                some.find(sysid)
                everybody.find(sysid)
            case 2 | 3:
                sequences[sysid].order(ORDERS[tick % 3])
            case 4 | 5 | 6 | 7 | 8:
                sequences[sysid].rejoin()
            case 9:
                arming.ground(frozenset({sysid} if fleet.chance.random() < 0.3 else ()))
        snapshot, plain = fleet.tick()
        for due in arming.due(snapshot.columns):
            sequences[due].decide(snapshot.vehicle(due), fleet.time_s)
            arming.asked(due, snapshot.vehicle(due))
        partners = {(201, 3)} if tick % 400 < 50 else set()
        notices = some.update(snapshot, partners)
        assert notices == everybody.update(plain, partners)
        assert memory(some) == memory(everybody)
        assert some.losses(snapshot, fleet.time_s) == everybody.losses(plain, fleet.time_s)
        broken |= {record["part"] for record in notices[0]}
    for (_, one, *_), (_, other, *_) in zip(some._log, everybody._log, strict=True):
        for flags in ("flying", "ours", "up", "exempt"):
            np.testing.assert_array_equal(getattr(one, flags), getattr(other, flags))
    assert broken == {"separation", "clearance", "ground"}
    assert some._lost
    assert sum(some._waypoints.missed.values()) < 5
    assert len(looked_at) < 0.9 * ticks * len(SYSIDS)


def test_only_an_order_that_explains_a_landing_keeps_it_from_counting_as_a_loss() -> None:
    """A vehicle flies, is ordered to hold, return or land, and comes down in LAND with some charge, or none, left."""

    def lost(ordered: End | None, *, left_j: float) -> tuple[list[str], list[str]]:
        content = scenario(ground=False)
        sequences = make_arming_sequences(content)
        watch = GoalWatch(content, geometry.of_scenario(content.obstacles), FleetArming(sequences))
        sequence, why = sequences[1], []
        sequence.stage = Stage.FLY
        for tick, (mode, landed) in enumerate(
            [(FlightMode.OFFBOARD, False), (FlightMode.HOLD, False), (FlightMode.LAND, False), (FlightMode.LAND, True)]
        ):
            one = view(1, mode=mode, landed=landed, armed=not landed, drawn_j=10_000.0 - left_j if tick >= 2 else 0.0)
            if tick == 1 and ordered is not None:
                sequence.order(ordered)
            if tick != 1 or ordered is not None:
                sequence.decide(one, float(tick))
                now = snapshot(one, *(view(sysid) for sysid in SYSIDS[1:]), time_s=float(tick))
                watch.update(now, ())
                why.append([loss.why for loss in watch.losses(now, float(tick)) if loss.sysid == 1])
        return why[-2], why[-1]

    falls, landed, empty = ["its failsafe flies it (Land)"], ["landed by itself"], ["its battery is empty"]
    assert lost(None, left_j=40.0) == (falls, falls)
    assert lost("hold", left_j=40.0) == (falls, landed)
    assert lost("return", left_j=40.0) == lost("land", left_j=40.0) == ([], [])
    assert lost("hold", left_j=0.0) == lost("return", left_j=0.0) == lost("land", left_j=0.0) == (empty, empty)


@pytest.mark.parametrize("rejoins", [False, True])
def test_an_external_vehicle_that_falls_since_it_booted_is_lost_until_it_flies_again(rejoins: bool) -> None:
    """A pilot who disarms one in the air took it down himself, which is no loss of ours."""
    block = {"connect": "udpin:127.0.0.1:14550", "sysid": 1, "capacity_j": 1e4, "rejoins": rejoins}
    content = Scenario.model_validate({
        "schema": 1, "name": "m", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 0.0},
        "goal": {"duration_s": 60.0}, "vehicles": {"pursuers": [{"external": block}]},
    })  # fmt: skip
    fallen = view(1, mode=FlightMode.MANUAL, armed=False, last_received_s=5.0)

    def lost(*steps: VehicleView, boots: int | None = None, ordered: End | None = None) -> list[list[str]]:
        sequences = make_arming_sequences(content)
        watch, sequence = GoalWatch(content, geometry.of_scenario(()), FleetArming(sequences)), sequences[1]
        sequence.stage, why = Stage.FLY, []
        if ordered is not None:
            sequence.order(ordered)
        for tick, one in enumerate((view(1, last_received_s=1.0), *steps)):
            if tick == boots:
                sequence.boot(one)
            sequence.decide(one, float(tick))
            now = snapshot(one, time_s=float(tick))
            watch.update(now, ())
            why.append([loss.why for loss in watch.losses(now, float(tick))])
        return why[1:]

    old, landed = fallen._replace(age_s=3.0), fallen._replace(age_s=9.0, landed=True)
    flies = [view(1, last_received_s=9.0)] * 3
    booted = ["it booted in flight"]
    assert lost(old, landed, *flies, boots=1) == [
        booted,
        booted,
        [] if rejoins else booted,
        *[[] if rejoins else booted] * 2,
    ]
    assert lost(old, landed, boots=2) == [[], booted]
    assert lost(old, landed, boots=1, ordered="hold") == [booted, booted]
    assert lost(old, landed, boots=1, ordered="land") == [[], []]
    assert lost(fallen, landed, landed) == [[], [], []]


@pytest.mark.parametrize("boots", [False, True])
def test_one_that_has_booted_does_not_touch_the_ground_before_it_says_its_mode(boots: bool) -> None:
    """A PX4 that boots says first that it has landed, up to a second before its HEARTBEAT."""
    block = {"connect": "udpin:127.0.0.1:14550", "sysid": 1, "capacity_j": 1e4}
    content = Scenario.model_validate({
        "schema": 1, "name": "m", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 0.0},
        "goal": {"duration_s": 60.0}, "vehicles": {"pursuers": [{"external": block}]},
    })  # fmt: skip
    sequences = make_arming_sequences(content)
    watch, sequence = GoalWatch(content, geometry.of_scenario(()), FleetArming(sequences)), sequences[1]
    sequence.stage, broken = Stage.FLY, set()
    stands = view(1, landed=True, last_received_s=0.0, ground_down_m=0.0)
    for tick, one in enumerate((view(1, last_received_s=0.0, ground_down_m=0.0), stands)):
        if tick and boots:
            sequence.boot(one)
        sequence.decide(one, float(tick))
        records, _ = watch.update(snapshot(one, time_s=float(tick)), ())
        broken |= {record["part"] for record in records}
    assert broken == (set() if boots else {"ground"})


@pytest.mark.parametrize("failsafe", [False, True])
def test_an_external_vehicle_that_its_failsafe_has_landed_is_lost_also_once_it_stands(failsafe: bool) -> None:
    """A PX4 whose battery is critical holds, lands and disarms; then it says STANDBY, and the mode before its failsafe.
    A pilot who does the same takes it down himself."""
    block = {"connect": "udpin:127.0.0.1:14550", "sysid": 1, "capacity_j": 1e4}
    content = Scenario.model_validate({
        "schema": 1, "name": "m", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 0.0},
        "goal": {"duration_s": 60.0}, "vehicles": {"pursuers": [{"external": block}]},
    })  # fmt: skip
    sequences = make_arming_sequences(content)
    watch, sequence = GoalWatch(content, geometry.of_scenario(()), FleetArming(sequences)), sequences[1]
    sequence.stage, why = Stage.FLY, []
    taken = {"failsafe": failsafe, "last_received_s": 5.0}
    for tick, one in enumerate([
        view(1, last_received_s=1.0),
        view(1, mode=FlightMode.HOLD, **taken),
        view(1, mode=FlightMode.LAND, **taken),
        view(1, mode=FlightMode.LAND, landed=True, **taken),
        *[view(1, mode=FlightMode.OFFBOARD, landed=True, armed=False, last_received_s=9.0)] * 2,
    ]):  # fmt: skip
        sequence.decide(one, 10.0 * tick)
        now = snapshot(one, time_s=10.0 * tick)
        watch.update(now, ())
        why.append([loss.why for loss in watch.losses(now, 10.0 * tick)])
    assert sequence.stage is Stage.DOWN
    landed = ["landed by itself"] if failsafe else []
    assert why == [[], [], ["its failsafe flies it (Land)"] if failsafe else [], [], landed, landed]


def test_what_a_vehicle_was_lost_by_first_stays() -> None:
    content = scenario()
    watch = GoalWatch(content, geometry.of_scenario(content.obstacles), FleetArming(make_arming_sequences(content)))
    now = snapshot(*(view(sysid) for sysid in SYSIDS), time_s=22.0)
    watch.lose(2, 12.0, "its process died")
    watch.lose(2, 22.0, "silent")
    assert [(loss.t_s, loss.why) for loss in watch.losses(now, 22.0) if loss.sysid == 2] == [(12.0, "its process died")]


def test_a_silent_vehicle_is_lost_after_its_failsafes_delay_unless_an_order_explains_its_landing() -> None:
    """A vehicle flies, and nothing comes of it from 3 s on; there is no truth of it."""
    content = scenario(ground=False)

    def lost(
        mode: FlightMode = FlightMode.OFFBOARD, *, end_s: float = 60.0, stage: Stage = Stage.FLY, **arming: Any
    ) -> list[str]:
        sequences = make_arming_sequences(content)
        watch = GoalWatch(content, geometry.of_scenario(content.obstacles), FleetArming(sequences))
        sequences[1].stage = stage
        for name, value in arming.items():
            setattr(sequences[1], name, value)
        for t_s, age_s in [(3.0, 0.0), (end_s, end_s - 3.0)]:
            others = (view(sysid, last_message_s=t_s, last_received_s=t_s) for sysid in SYSIDS[1:])
            one = view(1, mode=mode, last_message_s=3.0, last_received_s=3.0, age_s=age_s)
            now = snapshot(one, *others, time_s=t_s)
            watch.update(now, ())
        return [f"{loss.t_s:g} s: {loss.why}" for loss in watch.losses(now, end_s) if loss.sysid == 1]

    silent = ["60 s: no telemetry since 3.0 s"]
    assert lost() == lost(ordered="hold", stage=Stage.TAKEN) == lost(stage=Stage.MISSION) == silent
    assert lost(grounded=True, stage=Stage.BASE) == silent
    assert lost(FlightMode.LAND, grounded=True, stage=Stage.BASE) == []
    assert lost(ordered="land", stage=Stage.TAKEN) == lost(ordered="return", stage=Stage.TAKEN) == []
    assert lost(released=True, stage=Stage.TAKEN) == lost(stage=Stage.YIELDED) == []
    assert lost(end_s=7.9) == []
    assert lost(end_s=8.0) == ["8 s: no telemetry since 3.0 s"]


def test_no_way_point_is_passed_by_a_failsafe_nor_on_the_line_to_where_it_ends() -> None:
    content = scenario(ground=False)
    past = [(4.0, 0.0), (3.0, 0.0), (-2.0, 0.0), (-2.0, 3.0), (4.0, 3.0)]
    around = [(4.0, 0.0), (4.0, 5.0), (-2.0, 5.0), (-2.0, 4.0), (-2.0, 0.0)]
    """N and E at each second, of which the failsafe flies those of the middle; the way points are (1, 0) and (1, 1)"""

    def missed(way_m: list[tuple[float, float]], failsafe: dict[str, Any]) -> int:
        sequences = make_arming_sequences(content)
        watch = GoalWatch(content, geometry.of_scenario(content.obstacles), FleetArming(sequences))
        sequences[1].stage = Stage.FLY
        for t_s, (north, east) in enumerate(way_m):
            received = {"last_message_s": float(t_s), "last_received_s": float(t_s), "p_ned": (north, east, -1.0)}
            one = view(1, **received | (failsafe if 0 < t_s < 4 else {}))
            watch.update(snapshot(one, *(view(sysid) for sysid in SYSIDS[1:]), time_s=float(t_s)), ())
        return watch._waypoints.missed[1]

    assert missed(past, {}) < 2
    for failsafe in ({"mode": FlightMode.RETURN}, {"last_message_s": -9.0, "last_received_s": -9.0}):
        assert missed(past, failsafe) == missed(around, failsafe) == 2
