"""Vehicles without a station keep apart by what they receive of each other, and by the timetable where that is nothing.

Distances are the vehicles' true ones; nothing of the filter is asked.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from pymavlink.dialects.v20 import common
from swarm import FRAME, SEPARATION_M, Radio, Swarm, rules_of

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.maneuvers import AT_REST, OffboardSetPoint
from simvehicle.autopilot.modes import Mode, Trigger
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vectors import Vec3
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.separation import Separation
from simvehicle.fleet.separation_rules import SeparationRulesError
from simvehicle.mavlink.codec import split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services
from simvehicle.sitl.traffic import Aircraft, Traffic

AIR = Connection(255, 156)


def circle(count: int, radius_m: float) -> dict[int, Vec3]:
    return {
        i + 1: (radius_m * math.cos(2 * math.pi * i / count), radius_m * math.sin(2 * math.pi * i / count), 0.0)
        for i in range(count)
    }


def opposite(places: dict[int, Vec3]) -> dict[int, Vec3]:
    return {sysid: (-n, -e, d) for sysid, (n, e, d) in places.items()}


def returned(count: int, heights_m: dict[int, float], passes: Radio) -> Swarm:
    """A circle of which each has its home opposite, and whose station falls silent at 5 s, flown until all must be
    down."""
    starts = circle(count, 4.0)
    swarm = Swarm(starts, rules_of(opposite(starts), heights_m), passes)

    def greet(now_s: float) -> None:
        for vehicle in swarm.vehicles.values() if now_s <= 5.0 else ():
            vehicle.receive_gcs_heartbeat()

    swarm.fly(70.0, greet)
    for sysid, vehicle in swarm.vehicles.items():
        assert (vehicle.armed, vehicle.landed) == (False, True)
        assert math.dist(vehicle.p_ned, swarm.vehicles[sysid].separation.home_ned) < 0.6
    return swarm


def test_at_one_height_they_keep_apart_by_what_they_receive() -> None:
    swarm = returned(8, dict.fromkeys(range(1, 9), 6.0), lambda *_: True)
    assert swarm.least_m >= SEPARATION_M


def test_a_third_of_all_reports_may_be_lost() -> None:
    rng = np.random.default_rng(3)
    swarm = returned(8, dict.fromkeys(range(1, 9), 6.0), lambda *_: rng.random() > 0.3)
    assert swarm.least_m >= SEPARATION_M


def test_at_heights_of_their_own_they_keep_apart_though_nothing_is_received_any_more() -> None:
    swarm = returned(8, {sysid: 5.0 + 1.2 * sysid for sysid in range(1, 9)}, lambda _s, _r, now_s: now_s < 6.0)
    assert swarm.least_m >= SEPARATION_M


@pytest.mark.parametrize("parted_s", [1.2, 1.3, 1.4])
def test_a_peer_of_which_nothing_comes_any_more_may_have_braked_since(parted_s: float) -> None:
    """The lowest of a column is parted from the other three while all climb, and they brake above it."""
    places = {1: (8.38, -0.19, -2.5), 2: (8.09, -0.42, -3.68), 3: (7.81, -0.05, -5.37), 4: (8.34, 0.41, -7.25)}
    homes = {1: (0.0, 0.0, 0.0), 2: (4.0, 0.0, 0.0), 3: (6.0, 0.0, 0.0), 4: (2.0, 0.0, 0.0)}
    heights_m = {1: 13.42, 2: 11.02, 3: 12.22, 4: 9.82}

    def passes(sender: int, reader: int, now_s: float) -> bool:
        return now_s < 5.0 + parted_s or 1 not in (sender, reader)

    swarm = Swarm(places, rules_of(homes, heights_m), passes, up=True)
    swarm.fly(30.0)
    assert swarm.least_m >= SEPARATION_M


@pytest.mark.parametrize("seed", [39, 52, 56, 91])
def test_one_whose_leader_is_not_heard_of_may_have_braked_since_though_its_place_is(seed: int) -> None:
    """The same column while two of five messages are lost, each by itself."""
    places = {1: (8.38, -0.19, -2.5), 2: (8.09, -0.42, -3.68), 3: (7.81, -0.05, -5.37), 4: (8.34, 0.41, -7.25)}
    homes = {1: (0.0, 0.0, 0.0), 2: (4.0, 0.0, 0.0), 3: (6.0, 0.0, 0.0), 4: (2.0, 0.0, 0.0)}
    rng = np.random.default_rng(seed)
    rules = rules_of(homes, {1: 13.42, 2: 11.02, 3: 12.22, 4: 9.82})
    swarm = Swarm(places, rules, lambda *_: rng.random() >= 0.4, up=True)
    swarm.fly(16.0)
    assert swarm.least_m >= SEPARATION_M


def test_they_do_not_without_either() -> None:
    """The circle is one in which something has to keep them apart."""
    swarm = returned(8, dict.fromkeys(range(1, 9), 6.0), lambda *_: False)
    assert swarm.least_m < SEPARATION_M


@pytest.mark.parametrize(("receives", "keeps_off"), [(True, True), (False, False)])
def test_an_aircraft_that_turns_among_silent_vehicles_is_kept_off(receives: bool, keeps_off: bool) -> None:
    """To and fro at 2 m/s along a line of four that hover, and then return; without its ADSB_VEHICLE it comes near."""
    places = {sysid: (3.0 * sysid, 0.0, -6.0) for sysid in range(1, 5)}
    swarm = Swarm(places, rules_of(places, dict.fromkeys(places, 6.0)), lambda *_: True, up=True)
    path = Aircraft("TURN", ((-9.0, 0.3, -6.2), (20.0, -0.3, -5.8)), 2.0, closed=False, start_s=0.0)
    aircraft = Traffic(FRAME, [path], [AIR])
    nearest_m = math.inf

    def passes(now_s: float) -> None:
        nonlocal nearest_m
        aircraft.advance(round(1e3 * now_s))
        frames = split(b"".join(AIR.frames()))
        for sysid, vehicle in swarm.vehicles.items():
            nearest_m = min(nearest_m, math.dist(vehicle.true_motion_ned[:3], path.at(now_s)[0]))
            for frame in frames if receives else ():
                swarm.receive(sysid, frame)

    swarm.fly(40.0, passes)
    assert (nearest_m >= SEPARATION_M) is keeps_off
    assert swarm.least_m >= SEPARATION_M


def test_a_vehicle_whose_set_points_stay_away_brakes_as_the_filter_presumes() -> None:
    """At 3 m/s with 0.8 of 4 m/s²: v²/2b, up to b T²/8, beyond the place to which the last set point led."""
    start = (0.0, 0.0, -10.0)
    vehicle = Vehicle(IDENTITIES["px4"], Parameters(), FRAME, Start(start, (3.0, 0.0, 0.0), airborne=True))
    rules = rules_of({1: start}, {1: 5.0})
    vehicle.period_s, vehicle.separation = rules.period_s, Separation(vehicle, 1, rules)
    vehicle.set_clock(0, 0)
    for tick in range(30):
        vehicle.set_point(OffboardSetPoint((0.3 * tick, 0.0, -10.0), (3.0, 0.0, 0.0), (True,) * 3, None, 0.1 * tick))
        vehicle.station_leads = True
        vehicle.receive_gcs_heartbeat()
        vehicle.advance(100 * (tick + 1))
    vehicle.advance(6000)
    assert vehicle.mode is Mode.HOLD
    assert vehicle.p_ned[0] == pytest.approx(0.3 * 30 + 3.0**2 / (2 * 0.8 * 4.0), abs=0.1)
    assert math.hypot(*vehicle.v_ned) < 0.01


def test_one_that_returns_counts_on_no_leader_of_one_that_the_station_steers_again() -> None:
    """Two climb on their return, one below the other, when the station comes back. It brakes the upper one by 0.8 of
    4 m/s² from its speed: a metre before the stop of the leader that it has reported."""
    places = {1: (6.0, 0.0, -3.8), 2: (6.0, 0.0, -2.45)}
    homes = {sysid: (0.0, 2.0 * sysid, 0.0) for sysid in places}
    swarm = Swarm(places, rules_of(homes, {1: 14.0, 2: 12.6}), lambda *_: True, up=True)
    upper, lower = swarm.vehicles[1], swarm.vehicles[2]
    begun: list[tuple[float, float]] = []

    def station(now_s: float) -> None:
        if upper.v_ned[2] > -0.6 and not begun:
            return
        for vehicle in (upper, lower):
            vehicle.receive_gcs_heartbeat()
        if upper.v_ned[2] > -1.6 and not begun:
            return
        begun.append((now_s, upper.v_ned[2]))
        since_s, v_m_s = begun[0]
        v_ned = (0.0, 0.0, min(v_m_s + 3.2 * (now_s - since_s), 0.0))
        upper.set_point(OffboardSetPoint(AT_REST, v_ned, (False,) * 3, None, now_s))
        upper.station_leads = True
        upper.trigger(Trigger.OFFBOARD)

    swarm.fly(50.0, station)
    assert begun
    assert upper.mode is Mode.OFFBOARD
    assert swarm.least_m >= SEPARATION_M


@pytest.mark.parametrize(("delay", "until_s"), [(0, math.inf), (5, math.inf), (0, 1.0)])
def test_neighbours_that_hover_do_not_fly_apart_because_reports_are_old_or_stay_away(
    delay: int, until_s: float
) -> None:
    """Where each came to rest is where peers presume it that do not receive it any more."""
    places = {1: (0.0, 0.0, -10.0), 2: (1.4, 0.0, -10.0)}
    rules = rules_of(places, dict.fromkeys(places, 15.0))
    swarm = Swarm(places, rules, lambda _, __, now_s: now_s < until_s, up=True, delay=delay)
    for sysid, vehicle in swarm.vehicles.items():  # of which no further set point comes
        vehicle.set_point(OffboardSetPoint(places[sysid], AT_REST, (True,) * 3, None, 0.0))
        vehicle.trigger(Trigger.OFFBOARD)

    def station(_: float) -> None:
        for vehicle in swarm.vehicles.values():
            vehicle.receive_gcs_heartbeat()

    swarm.fly(5.0, station)
    assert {vehicle.mode for vehicle in swarm.vehicles.values()} == {Mode.HOLD}
    for sysid, vehicle in swarm.vehicles.items():
        assert vehicle.p_ned == pytest.approx(places[sysid], abs=0.1)


def test_set_points_of_a_pilot_leave_it_to_the_pilot() -> None:
    vehicle = Vehicle(IDENTITIES["px4"], Parameters(), FRAME, Start((0.0, 0.0, -10.0), airborne=True))
    rules = rules_of({1: (0.0, 0.0, -10.0)}, {1: 5.0})
    vehicle.period_s, vehicle.separation = rules.period_s, Separation(vehicle, 1, rules)
    vehicle.set_clock(0, 0)
    vehicle.set_point(OffboardSetPoint((0.0, 0.0, -10.0), (1.0, 0.0, 0.0), (False,) * 3, None, 0.0))
    vehicle.advance(900)
    assert not vehicle.leads
    assert vehicle.v_ned[0] > 0.5


@pytest.mark.parametrize(("ordered", "stays"), [(True, True), (False, False)])
def test_only_a_vehicle_that_the_station_holds_stays_where_another_comes(ordered: bool, stays: bool) -> None:
    """The station keeps others away from one that it holds; from one that holds because set points stay away it does
    not."""
    places = {1: (0.0, 0.0, -10.0), 2: (6.0, 0.1, -10.0)}
    rules = rules_of(dict.fromkeys(places, (0.0, 0.0, -10.0)), dict.fromkeys(places, 10.0))
    vehicle = Vehicle(IDENTITIES["px4"], Parameters(), FRAME, Start(places[1], airborne=True))
    vehicle.period_s, vehicle.separation = rules.period_s, Separation(vehicle, 1, rules)
    vehicle.set_clock(0, 0)
    if ordered:
        vehicle.trigger(Trigger.HOLD)
    else:
        vehicle.set_point(OffboardSetPoint(places[1], (0.0, 0.0, 0.0), (True,) * 3, None, 0.0))
        vehicle.trigger(Trigger.OFFBOARD)
    connection = Connection(1)
    services, writer = Services(vehicle, 1, [connection]), common.MAVLink(None, 2, 1)
    for tick in range(60):
        vehicle.receive_gcs_heartbeat()
        north = 6.0 - 0.1 * tick
        place = common.MAVLink_local_position_ned_message(100 * tick, north, 0.1, -10.0, -1.0, 0.0, 0.0)
        for frame in split(bytes(place.pack(writer))):
            services.receive(frame, connection)
        vehicle.advance(100 * (tick + 1))
    assert vehicle.mode is Mode.HOLD
    assert (math.dist(vehicle.p_ned, places[1]) < 0.05) == stays


@pytest.mark.parametrize(("heard", "climbs"), [(True, True), (False, False)])
def test_one_that_takes_off_by_order_climbs_as_the_station_foresees(heard: bool, climbs: bool) -> None:
    """The station leads another one past its column, 0.7 m beside it; without a station it evades that."""
    rules = rules_of({1: (0.0, 0.0, 0.0), 2: (5.0, 1.2, 0.0)}, {1: 10.0, 2: 12.0})
    vehicle = Vehicle(IDENTITIES["px4"], Parameters({"COM_DL_LOSS_T": 30.0}), FRAME, Start((0.0, 0.0, 0.0)))
    vehicle.period_s, vehicle.separation = rules.period_s, Separation(vehicle, 1, rules)
    vehicle.set_clock(0, 0)
    vehicle.receive_gcs_heartbeat()
    vehicle.trigger(Trigger.ARM)
    vehicle.take_off(2.5)
    connection = Connection(1)
    services, writer = Services(vehicle, 1, [connection]), common.MAVLink(None, 2, 1)
    aside_m = 0.0
    for tick in range(60):
        if heard:
            vehicle.receive_gcs_heartbeat()
        north = 5.0 - 0.1 * tick
        place = common.MAVLink_local_position_ned_message(100 * tick, north, 0.7, -2.5, -1.0, 0.0, 0.0)
        for frame in split(bytes(place.pack(writer))):
            services.receive(frame, connection)
        vehicle.advance(100 * (tick + 1))
        aside_m = max(aside_m, math.hypot(*vehicle.p_ned[:2]))
    assert (aside_m < 0.05) == climbs


@pytest.mark.parametrize(
    ("changed", "sentence"),
    [
        ({"period_s": "often"}, "cannot be read"),
        (
            {"obstacles": [{"kind": "cone", "low_ned": [0, 0, 0], "high_ned": [0, 0, 0], "radius_m": 1.0}]},
            "kind is 'cone'",
        ),
        ({"vehicles": []}, "do not name vehicle 1"),
    ],
)
def test_rules_that_cannot_be_used_are_refused(changed: dict[str, Any], sentence: str) -> None:
    with pytest.raises(SeparationRulesError, match=sentence):
        rules_of({1: (0.0, 0.0, 0.0)}, {1: 5.0}, **changed)
