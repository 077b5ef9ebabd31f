"""Ways that a vehicle finds by itself while no ground station flies it: past the map's obstacles and the peers it hears
(docs/protocol/onboard.md#flight-without-a-ground-station) [choice]. NED, m.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from simvehicle.autopilot.vectors import Vec3
from simvehicle.fleet.rules import Solid
from skytender import elementary

SAMPLE_M = 0.1
LEVELS_M = 0.5
RINGS_M = (0.5, 1.0, 1.5, 2.0, 3.0, 4.0)
BEARINGS = 8
HEIGHTS_M = (0.0, 0.7, 1.4)
CLEARANCE_SPARE_M = 0.25
SEPARATION_SPARE_M = 0.4
"""Added to what the scenario demands: a vehicle errs, and its peers are where they were when they reported."""
LOWEST_DOWN_M = -0.5


class Surroundings(NamedTuple):
    """Everything to keep away from, and by how much."""

    obstacles: Sequence[Solid]
    clearance_m: float
    peers_ned: Sequence[Vec3]
    separation_m: float


def room_m(p_ned: Vec3, around: Surroundings) -> float:
    """How far a place lies beyond the distances that are kept; negative: too near."""
    obstacle_m = min((solid.clearance_m(p_ned) for solid in around.obstacles), default=math.inf)
    peer_m = min((elementary.distance(p_ned, peer) for peer in around.peers_ned), default=math.inf)
    return min(obstacle_m - around.clearance_m - CLEARANCE_SPARE_M, peer_m - around.separation_m - SEPARATION_SPARE_M)


def is_clear(a_ned: Vec3, b_ned: Vec3, around: Surroundings) -> bool:
    """Whether the straight way keeps its distances. Who starts too near may leave, but not come nearer."""
    least_m = min(room_m(a_ned, around), 0.0) - 0.02
    count = max(math.ceil(elementary.distance(a_ned, b_ned) / SAMPLE_M), 1)
    return all(room_m(_between(a_ned, b_ned, i / count), around) >= least_m for i in range(1, count + 1))


def route(
    start_ned: Vec3, goal_ned: Vec3, around: Surroundings, transit_down_m: float, *, high: bool = False
) -> list[Vec3] | None:
    """Corners of a way: straight, else up, level over what is in between, and down; as low as can be, or, if `high`, at
    the height of transit. None: there is none up to that height."""
    if room_m(goal_ned, around) < 0.0:
        return None
    if not high and is_clear(start_ned, goal_ned, around):
        return [goal_ned]
    level = transit_down_m if high else min(start_ned[2], goal_ned[2])
    while True:
        level = min(max(level - LEVELS_M, transit_down_m), start_ned[2], goal_ned[2])
        above, over = (start_ned[0], start_ned[1], level), (goal_ned[0], goal_ned[1], level)
        legs = ((start_ned, above), (above, over), (over, goal_ned))
        if all(is_clear(a, b, around) for a, b in legs):
            return [above, over, goal_ned]
        if level <= transit_down_m:
            return None


def meeting_place(
    here_ned: Vec3, tanker_ned: Vec3, height_m: float, around: Surroundings, transit_down_m: float
) -> Vec3 | None:
    """Nearest place to `here_ned`, or that place itself, that a receiver can reach straight and above which its tanker
    can stand and come to; None where there is none within reach. `around` is without the two."""
    for place in _places(here_ned):
        above = (place[0], place[1], place[2] - height_m)
        if place != here_ned and (room_m(place, around) < 0.0 or not is_clear(here_ned, place, around)):
            continue
        if is_clear(place, above, around) and route(tanker_ned, above, around, transit_down_m) is not None:
            return place
    return None


def _places(here_ned: Vec3) -> Iterator[Vec3]:
    """Candidates around a place, the nearest first."""
    north, east, down = here_ned
    offsets = [(0.0, 0.0, -up) for up in HEIGHTS_M]
    for radius_m in RINGS_M:
        for i in range(BEARINGS):
            bearing = 2.0 * math.pi * i / BEARINGS
            offsets += [
                (radius_m * elementary.cos(bearing), radius_m * elementary.sin(bearing), -up) for up in HEIGHTS_M
            ]
    for dn, de, dd in sorted(offsets, key=lambda offset: round(elementary.norm(offset), 6)):
        yield north + dn, east + de, min(down + dd, LOWEST_DOWN_M) if dd else down


def _between(a: Vec3, b: Vec3, share: float) -> Vec3:
    return (a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2]))
