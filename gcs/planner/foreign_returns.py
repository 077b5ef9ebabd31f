"""Returns of vehicles whose autopilots are not ours, without the ground station: plan B of them [choice].

Their autopilots hold, climb to a height, fly level home, wait there and land, one leg after the other and without a
word of each other. So each has a height of its own where its way may meet another's, the highest begins first, and each
lower one begins when those above it have climbed past its height: until then it holds below all heights, where the
filter has kept it apart. Over home each waits until the last is over its own. Of two ways that may meet, the vehicle
that the scenario sends higher returns higher: it hangs over the other rather than under it.

Where an external vehicle's home is, is not known before it is received: its way may meet every other.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from gcs.planner.return_ways import boxes_of, coloured, meeting, places_of
from gcs.scenario.model import Scenario, VehicleBase
from skytender import elementary
from skytender.safety.safety_constraints import descent_of

BEGINS_S = 10.0
"""Time without a HEARTBEAT after which the first begins to return: PX4's own by default."""
CLIMB_M_S = 1.5
"""Slowest climb that is reckoned with: ArduCopter's by default is 2.5 m/s, PX4's 3 m/s."""
LEVEL_M_S = 2.0
"""Slowest flight home that is reckoned with: 5 m/s by default."""
SLACK_S = 2.0
"""Beyond the time of a climb or a way: a HEARTBEAT that one of two has lost, and setting out."""
AWAY_M = 20.0
"""Least way home that is reckoned with: where homes are is not known."""
LEAST_HOLD_S = 0.5
"""Least wait for a set point: older PX4s have it by default."""
LATEST_S = 120.0
"""FS_GCS_TIMEOUT's greatest value by its documentation."""
LONGEST_S = 300.0
"""RTL_LAND_DELAY's greatest value."""


@dataclass(frozen=True, slots=True)
class ForeignReturn:
    """Numbers of one vehicle's return."""

    height_m: float
    """above the scenario's height 0"""
    begins_after_s: float
    """of the station's last HEARTBEAT"""
    waits_s: float
    """over home"""
    holds_after_s: float
    """of the last set point"""
    in_time: bool = True
    """whether those above it have climbed past it when it begins, and all are over their homes when it lands"""

    @property
    def lands_after_s(self) -> float:
        """Session time, of the last HEARTBEAT, before which it does not come down."""
        return self.begins_after_s + self.waits_s


def layers_of(scenario: Scenario) -> dict[int, int]:
    """Number of the height at which each returns, from the lowest, by system id; different where ways may meet.

    At one height, vehicles that evade others upward return above vehicles that evade downward, so that a vehicle that
    hangs over another when the station is lost climbs first.
    """
    heights_m = _heights_m(scenario)
    every = scenario.vehicles.all
    foreign = ((row, v.sysid) for row, v in enumerate(every) if v.is_foreign)
    rows = sorted((heights_m[sysid], -descent_of(sysid), sysid, row) for row, sysid in foreign)
    boxes = boxes_of(every, scenario)
    for row, vehicle in enumerate(every):
        if vehicle.external is not None:
            boxes[row] = -math.inf, -math.inf, math.inf, math.inf
    numbers = coloured(meeting(boxes[[row for *_, row in rows]])) if rows else []
    return {sysid: number for (_, _, sysid, _), number in zip(rows, numbers, strict=True)}


def foreign_returns(
    scenario: Scenario, layers: dict[int, int], over_m: float, gap_m: float, begin_s: float, hold_s: float
) -> dict[int, ForeignReturn]:
    """Returns by system id.

    Args:
        layers: as `layers_of` gives them.
        over_m: height of the lowest, m above the scenario's height 0.
        gap_m: from one height to the next.
        begin_s: when the highest begins, s after the last HEARTBEAT.
        hold_s: time without a set point after which they hold.
    """
    if not layers:
        return {}
    count = max(layers.values()) + 1
    heights_m = [over_m + gap_m * layer for layer in range(count)]
    begins_s = [begin_s] * count
    for layer in range(count - 2, -1, -1):
        begins_s[layer] = begins_s[layer + 1] + math.ceil((heights_m[layer] + gap_m) / CLIMB_M_S + SLACK_S)
    home_s = begins_s[0] + math.ceil(heights_m[0] / CLIMB_M_S + _away_m(scenario) / LEVEL_M_S + 2.0 * SLACK_S)
    alone = len(scenario.vehicles.all) == 1
    returns = []
    for height_m, at_s in zip(heights_m, begins_s, strict=True):
        one = ForeignReturn(height_m, min(at_s, LATEST_S), 0.0, max(hold_s, LEAST_HOLD_S))
        wait_s = 0.0 if alone else home_s - one.begins_after_s
        in_time = at_s <= LATEST_S and wait_s <= LONGEST_S
        returns.append(replace(one, waits_s=min(wait_s, LONGEST_S), in_time=in_time))
    return {sysid: returns[layer] for sysid, layer in layers.items()}


def _away_m(scenario: Scenario) -> float:
    """Greatest way home that is reckoned with."""
    places = np.array([place[:2] for vehicle in scenario.vehicles.all for place in places_of(vehicle, scenario)])
    n, e = (places.max(axis=0) - places.min(axis=0)).tolist()
    return max(AWAY_M, float(elementary.hypot(n, e)) + (scenario.formation.ring_m or 0.0))


def _heights_m(scenario: Scenario) -> dict[int, float]:
    """Greatest height to which the scenario sends each, by system id."""
    vehicles, rules = scenario.vehicles, scenario.refuelling

    def highest_m(some: Sequence[VehicleBase], more_m: float) -> float:
        return max((-place[2] for one in some for place in places_of(one, scenario)), default=0.0) + more_m

    of_targets_m = highest_m(vehicles.targets, max(scenario.formation.height_m, 0.0))
    found = {target.sysid: highest_m([target], 0.0) for target in vehicles.targets}
    for pursuer in vehicles.pursuers:
        own_m = highest_m([pursuer], 0.0)
        found[pursuer.sysid] = own_m if pursuer.own_way else max(own_m, of_targets_m)
    of_pursuers_m = max((found[pursuer.sysid] for pursuer in vehicles.pursuers), default=0.0)
    for tanker in vehicles.tankers:
        found[tanker.sysid] = max(highest_m([tanker], 0.0), of_pursuers_m + rules.height_m)
    return found
