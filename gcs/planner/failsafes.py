"""Failsafes of launched vehicles, by which they come home when the ground station is lost: plan B [choice].

If the station falls silent for all at once, they return without it, by one timetable: up, each to a height of its
own where its way home may meet another's; level, when all are up; down over their own homes, when all are there.
What can meet is coloured: two vehicles whose boxes around their places and homes overlap have different heights. All
heights are above the places to which the scenario sends any of them: one that could not climb in time, because another
hangs over it, stays below all ways until the others have landed.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gcs.planner import return_ways
from gcs.planner.foreign_returns import BEGINS_S, ForeignReturn, foreign_returns, layers_of
from gcs.scenario.accuracy import widest_m
from gcs.scenario.model import Scenario, VehicleBase, keeps_apart
from skytender import elementary
from skytender.safety.silence import MOST_LOST_S, Failsafe

LOST_AFTER_PERIODS, LEAST_LOST_S = 5, 0.1
"""[choice] Periods without a set point after which a launched vehicle holds; the shortest wait that it can be set
to."""
GONE_AFTER_PERIODS = 2
"""[choice] The same where none is lost or late by itself: two that are missing were kept from it."""
LEAST_ALTITUDE_M, MOST_ALTITUDE_M = 1.0, 150.0
"""Least and greatest RTL_RETURN_ALT of our vehicles."""
SLACK_S = 4.0
"""[choice] Beyond the time of a leg at its speed: to set out and to come to rest, and for a heartbeat that was lost."""
DESCEND_M = 5.0
"""[choice] Above home: from there vehicles that return by the timetable land."""


def failsafes_of(scenario: Scenario) -> dict[int, Failsafe]:
    """Failsafe of each launched vehicle of ours, by system id."""
    vehicles = [vehicle for vehicle in scenario.vehicles.launched if vehicle.real is None]
    alone = {vehicle.sysid: failsafe_of(vehicle, scenario) for vehicle in vehicles}
    return _timetable(vehicles, alone, scenario)[0] if _by_timetable(scenario) else alone


def foreign_returns_of(scenario: Scenario) -> dict[int, ForeignReturn]:
    """Returns of the vehicles whose autopilots are not ours, by system id; none where none needs one."""
    layers = layers_of(scenario) if scenario.planner.safety else {}
    if not layers or (not scenario.obstacles and not _by_timetable(scenario)):
        return {}
    vehicles = [vehicle for vehicle in scenario.vehicles.launched if vehicle.real is None]
    alone = {vehicle.sysid: failsafe_of(vehicle, scenario) for vehicle in vehicles}
    return _timetable(vehicles, alone, scenario)[1]


def shared_heights(scenario: Scenario) -> list[tuple[int, ...]]:
    """System ids of vehicles that have to return at one height though their ways may meet, as there is no other; those
    of each such height."""
    if not keeps_apart(scenario):
        return []
    vehicles = [vehicle for vehicle in scenario.vehicles.launched if vehicle.real is None]
    heights = {sysid: failsafe.altitude_m for sysid, failsafe in failsafes_of(scenario).items()}
    meet, found = return_ways.meeting(return_ways.boxes_of(vehicles, scenario)), dict[float, set[int]]()
    pair_m, _ = widest_m(scenario)
    for i, j in np.argwhere(np.triu(meet, 1)).tolist():
        one, other = vehicles[i], vehicles[j]
        height_m = heights[one.sysid] - one.start_m[2]
        if abs(height_m - heights[other.sysid] + other.start_m[2]) < scenario.planner.separation_m + pair_m:
            found.setdefault(round(height_m, 3), set()).update((one.sysid, other.sysid))
    return [tuple(sorted(sysids)) for _, sysids in sorted(found.items())]


def facts(scenario: Scenario) -> list[str]:
    """Plan B in sentences, for people: heights and times, and for which vehicles there is none."""
    lines = []
    found, foreign = failsafes_of(scenario), foreign_returns_of(scenario)
    if found and _by_timetable(scenario):
        high = _heights([failsafe.altitude_m for failsafe in found.values()])
        one = next(iter(found.values()))
        lines.append(
            f"plan B: without the station {len(found)} vehicles return {high} above home, fly home from "
            f"{one.loss_s + one.level_after_s:.1f} s and descend there from {one.loss_s + one.down_after_s:.1f} s "
            "after its last HEARTBEAT"
        )
    for sysids in shared_heights(scenario):
        lines.append(f"plan B: {_named(sysids)} return at one height, and keep apart there by their radio alone")
    if foreign:
        lines.append(_foreign_fact(foreign))
    if late := [sysid for sysid, one in foreign.items() if not one.in_time]:
        lines.append(f"plan B: {_named(late)} return among others: more ways meet than autopilots can wait for")
    if len(foreign) > 1 and scenario.rally_m:
        lines.append(f"plan B: {_named(list(foreign))} return to the nearest rally point, which several may share")
    if others := [vehicle.sysid for vehicle in scenario.vehicles.all if vehicle.sysid not in {*found, *foreign}]:
        lines.append(f"plan B: none for {_named(others)}: autopilots that are not ours return by their own parameters")
    return lines


def _foreign_fact(foreign: dict[int, ForeignReturn]) -> str:
    """Heights and times of the returns of vehicles that are not ours."""
    high = _heights([one.height_m for one in foreign.values()])
    begins_s = sorted(one.begins_after_s for one in foreign.values())
    many = f"s {', '.join(map(str, sorted(foreign)))} return" if len(foreign) > 1 else f" {next(iter(foreign))} returns"
    begin = f"{begins_s[0]:.0f}" if begins_s[0] == begins_s[-1] else f"{begins_s[0]:.0f} to {begins_s[-1]:.0f}"
    down_s = max(one.lands_after_s for one in foreign.values())
    return (
        f"plan B: without the station vehicle{many} {high} above height 0, beginning {begin} s and down "
        f"{down_s:.0f} s after its last HEARTBEAT, by parameters that are set and read back before they are armed"
    )


def _heights(heights_m: list[float]) -> str:
    low, high = f"{min(heights_m):.1f}", f"{max(heights_m):.1f}"
    return f"at {low} m" if low == high else f"{low} to {high} m"


def _named(sysids: Sequence[int]) -> str:
    return f"vehicle{'s' * (len(sysids) > 1)} {', '.join(map(str, sysids))}"


def _by_timetable(scenario: Scenario) -> bool:
    """Whether several have to return without meeting."""
    rules, vehicles = scenario.planner, scenario.vehicles
    mixed = rules.safety and rules.vehicles_repel and bool(vehicles.foreign) and len(vehicles.all) > 1
    return mixed or keeps_apart(scenario)


def _timetable(
    vehicles: Sequence[VehicleBase], alone: dict[int, Failsafe], scenario: Scenario
) -> tuple[dict[int, Failsafe], dict[int, ForeignReturn]]:
    """Heights and times of a fleet's return, of our vehicles and of others; a height that a vehicle's own parameters
    give stays. Ours climb at once, above all others, and come down with them."""
    every = scenario.vehicles.all
    rows = [row for row, vehicle in enumerate(every) if not vehicle.is_foreign]
    boxes = return_ways.boxes_of(every, scenario)[rows]
    layers, below = return_ways.coloured(return_ways.meeting(boxes)), layers_of(scenario)
    gap_m = scenario.planner.separation_m + widest_m(scenario)[0] + return_ways.LAYER_SPARE_M
    over_m = max(
        return_ways.highest_place_m(every, scenario) + return_ways.OVER_M,
        return_ways.highest_obstacle_m(scenario.obstacles) + return_ways.OVER_M if below else 0.0,
        *(alone[v.sysid].altitude_m - v.start_m[2] for v in vehicles),
    )
    first = max(below.values(), default=-1) + 1
    found = {}
    for vehicle, layer in zip(vehicles, layers, strict=True):
        failsafe = alone[vehicle.sysid]
        if "RTL_RETURN_ALT" not in vehicle.params:
            altitude_m = over_m + gap_m * (first + layer) + vehicle.start_m[2]
            altitude_m = min(max(altitude_m, LEAST_ALTITUDE_M), MOST_ALTITUDE_M)
            failsafe = replace(failsafe, altitude_m=altitude_m)
        found[vehicle.sysid] = replace(failsafe, descend_m=DESCEND_M)
    hold_s = _waits_s(scenario)
    if not found:
        return {}, foreign_returns(scenario, below, over_m, gap_m, BEGINS_S, hold_s)
    slowest = min(failsafe.speed_m_s for failsafe in found.values())
    highest_m = max(failsafe.altitude_m for failsafe in found.values())
    wide_m = max(elementary.hypot(*(box[2:] - box[:2]).tolist()) for box in boxes)
    level_s = highest_m / slowest + SLACK_S
    lost_s = max(failsafe.loss_s for failsafe in found.values())
    foreign = foreign_returns(scenario, below, over_m, gap_m, max(lost_s + level_s, BEGINS_S), hold_s)
    down_s = level_s + wide_m / slowest + SLACK_S
    down_s = max([down_s, *(one.lands_after_s - lost_s for one in foreign.values())])
    lands_s = max(min(one.descend_m, one.altitude_m) / one.sink_m_s for one in found.values())
    again_s = down_s + highest_m / slowest + lands_s + SLACK_S
    times = {"level_after_s": level_s, "down_after_s": down_s, "again_after_s": again_s}
    return {sysid: replace(failsafe, **times) for sysid, failsafe in found.items()}, foreign


def failsafe_of(vehicle: VehicleBase, scenario: Scenario) -> Failsafe:
    """Failsafe of a launched vehicle that is alone: by its parameters, and else one for who knows of no obstacle.

    It returns above all of them. Without set points it flies on as it did, where the next one might have led it around
    something, so that it waits no longer than for a few that were lost, or for the radio's jitter.
    """
    params, usual = vehicle.params, Failsafe()
    altitude_m = params.get("RTL_RETURN_ALT")
    if altitude_m is None:
        over_m = return_ways.highest_obstacle_m(scenario.obstacles) + return_ways.OVER_M + vehicle.start_m[2]
        altitude_m = min(max(usual.altitude_m, math.ceil(over_m)), MOST_ALTITUDE_M)
    return Failsafe(
        params.get("COM_DL_LOSS_T", usual.loss_s),
        params.get("COM_OF_LOSS_T", _waits_s(scenario)),
        altitude_m,
        params.get("MPC_XY_CRUISE", usual.speed_m_s),
        params.get("MPC_LAND_SPEED", usual.sink_m_s),
    )


def _waits_s(scenario: Scenario) -> float:
    """Wait of a vehicle for a set point before it holds, as long as for a few that were lost, or for the radio's
    jitter."""
    radio, lockstep = scenario.radio, scenario.clock.mode == "lockstep"
    frames_go_missing = (
        radio.loss or radio.reorder or any(fault.fault in ("loss", "delay") for fault in scenario.faults)
    )
    flies_itself = scenario.competition.where == "vehicles"  # and begins to a moment before it would hold
    sure = lockstep and not frames_go_missing and not flies_itself
    periods = GONE_AFTER_PERIODS if sure else LOST_AFTER_PERIODS
    return min(max(periods * scenario.clock.period_s + radio.jitter_s, LEAST_LOST_S), MOST_LOST_S)
