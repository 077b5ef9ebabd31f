"""Presumed places of a vehicle whose reports stay away [choice].

Our vehicles and most autopilots do the same when nothing reaches them: they fly on for a moment and hold when set
points stay away, and return home when the ground station does: up to a height, straight to above their home, and down.
When that begins is uncertain by the ground station's last heartbeats, and how far they are by their acceleration, so
the answer is a stretch of that way, as places with a distance of STEP_M. NED, m, m/s, s.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from skytender import elementary

Vec3 = tuple[float, float, float]
Leg = tuple[Vec3, Vec3, float, float]
"""From, to, at what speed, and not before what time."""

STEP_M = 0.7
"""Between two presumed places: their spheres overlap."""
HEARTBEAT_S = 1.5
"""Time before a vehicle's last report at which it may have received the last heartbeat."""
SLOW_S = 2.5
"""Delay beyond its speed alone with which it may be anywhere: it brakes at each corner."""
BRAKES_M_S2 = 4.0
"""Deceleration of a vehicle that holds."""
MOST_LOST_S = 1.0
"""COM_OF_LOSS_T of PX4."""
OVER_HOME_M = 1.0
REACHED_M = 0.3
"""Within which a vehicle is over its home, and as high as it returns."""
AHEAD_S = 1.5
"""Time ahead for which it is looked for: a vehicle in its way needs time."""


@dataclass(frozen=True, slots=True)
class Failsafe:
    """Parameters of a vehicle that has lost its ground station; named as the parameters are."""

    loss_s: float = 5.0
    """COM_DL_LOSS_T"""
    hold_s: float = MOST_LOST_S
    """COM_OF_LOSS_T"""
    altitude_m: float = 5.0
    """RTL_RETURN_ALT, above home"""
    speed_m_s: float = 5.0
    """MPC_XY_CRUISE"""
    sink_m_s: float = 0.7
    """MPC_LAND_SPEED"""
    descend_m: float = math.inf
    """above home: to there it comes down at the speed of its return"""
    level_after_s: float = 0.0
    """of the return's beginning: it waits over where it began until then"""
    down_after_s: float = 0.0
    """of the return's beginning: it waits over its home until then"""
    again_after_s: float = math.inf
    """of the return's beginning: one that could not climb in time begins anew"""


def flown_on(p_ned: Vec3, v_ned: Vec3, silent_s: float, lag_s: float, failsafe: Failsafe) -> tuple[Vec3, Vec3]:
    """Place (NED, m) and velocity (m/s) of a vehicle whose last report, silent_s ago, was p and v.

    Its last set point was lag_s ahead of it; it flies on from there until it holds, and brakes.
    """
    stands_s = lag_s + failsafe.hold_s + elementary.norm(v_ned) / (2.0 * BRAKES_M_S2)
    n, e, d = (p + v * min(silent_s + lag_s, stands_s) for p, v in zip(p_ned, v_ned, strict=True))
    return (n, e, d), v_ned if silent_s + lag_s < stands_s else (0.0, 0.0, 0.0)


def braked(p_ned: Vec3, v_ned: Vec3, silent_s: float) -> tuple[Vec3, Vec3]:
    """Place (NED, m) and velocity (m/s) of a vehicle whose last report, silent_s ago, was p and v, if it brakes.

    Its last set points may have led it to stand: it is nowhere behind that place.
    """
    speed_m_s = elementary.norm(v_ned)
    if speed_m_s == 0.0:
        return p_ned, v_ned
    t_s = min(silent_s, speed_m_s / BRAKES_M_S2)
    gone_s, left = t_s - 0.5 * BRAKES_M_S2 * t_s * t_s / speed_m_s, 1.0 - BRAKES_M_S2 * t_s / speed_m_s
    n, e, d = (p + gone_s * v for p, v in zip(p_ned, v_ned, strict=True))
    return (n, e, d), (left * v_ned[0], left * v_ned[1], left * v_ned[2])


def stopping(p_ned: Vec3, v_ned: Vec3, silent_s: float, lag_s: float, failsafe: Failsafe) -> list[tuple[Vec3, Vec3]]:
    """Places (NED, m) and velocities (m/s) of a vehicle whose last report, silent_s ago, was p and v: all along from
    where it is if it braked at once to where it is if it flew on, which comes last; STEP_M apart or less."""
    last = flown_on(p_ned, v_ned, silent_s, lag_s, failsafe)
    return [*between(braked(p_ned, v_ned, silent_s), last), last]


def between(first: tuple[Vec3, Vec3], last: tuple[Vec3, Vec3]) -> list[tuple[Vec3, Vec3]]:
    """Places and velocities from the first on, so near to each other that their spheres overlap; without the last."""
    count = math.ceil(elementary.distance(first[0], last[0]) / STEP_M)
    (p0, v0), (p1, v1) = first, last
    return [(_between(p0, p1, k / count), _between(v0, v1, k / count)) for k in range(count)]


def presumed_places(p_ned: Vec3, home_ned: Vec3, silent_s: float, failsafe: Failsafe) -> list[Vec3]:
    """Places (NED, m) where a vehicle may be that last reported p_ned, now or AHEAD_S later; none while it may only
    hold."""
    begun_s = silent_s - failsafe.loss_s + HEARTBEAT_S
    if begun_s + AHEAD_S <= 0.0:
        return []
    legs = way_home(p_ned, home_ned, failsafe)
    return stretch(legs, max(begun_s - HEARTBEAT_S - SLOW_S, 0.0), begun_s + AHEAD_S) or [home_ned]


def way_home(p_ned: Vec3, home_ned: Vec3, failsafe: Failsafe) -> list[Leg]:
    """Way of a return: up, level, and down."""
    height = min(p_ned[2], home_ned[2] - failsafe.altitude_m)
    start, above = (p_ned[0], p_ned[1], height), (home_ned[0], home_ned[1], height)
    low = (home_ned[0], home_ned[1], max(height, home_ned[2] - failsafe.descend_m))
    ground = (home_ned[0], home_ned[1], max(home_ned[2], 0.0))
    legs = [
        (p_ned, start, failsafe.speed_m_s, 0.0),
        (start, above, failsafe.speed_m_s, failsafe.level_after_s),
        (above, low, failsafe.speed_m_s, failsafe.down_after_s),
        (low, ground, failsafe.sink_m_s, failsafe.down_after_s),
    ]
    return [leg for leg in legs if leg[0] != leg[1]]


def tube(p_ned: Vec3, from_ned: Vec3, home_ned: Vec3, returning_s: float, failsafe: Failsafe) -> tuple[Vec3, Vec3]:
    """Box of the leg that is due of a return: least and greatest n, e, d, in m, of its line.

    A vehicle at p that stays in it is where peers presume it that last received it at `from_ned`; returning_s: since it
    began to return, negative before. Two that do not receive each other are as far apart as their boxes are [choice].
    """
    top = min(from_ned[2], home_ned[2] - failsafe.altitude_m)
    if returning_s < 0.0:
        return from_ned, from_ned
    up = p_ned[2] <= top + REACHED_M
    if returning_s >= failsafe.down_after_s and elementary.distance(p_ned[:2], home_ned[:2]) <= OVER_HOME_M:
        return (home_ned[0], home_ned[1], top), (home_ned[0], home_ned[1], math.inf)
    if returning_s >= failsafe.level_after_s and up:
        n, e = (sorted((from_ned[i], home_ned[i])) for i in range(2))
        return (n[0], e[0], top), (n[1], e[1], top)
    return (from_ned[0], from_ned[1], top), from_ned


def nearest_rest(p_ned: Vec3, rest_ned: Vec3, v_ned: Vec3, within_s: float) -> Vec3:
    """Place nearest to p (NED, m) of those where a vehicle stands that has flown on at v (m/s) and braked within so
    long, in s; rest_ned: where it stands if it brakes at once."""
    square = sum(v * v for v in v_ned)
    if square == 0.0:
        return rest_ned
    along = sum((p - rest) * v for p, rest, v in zip(p_ned, rest_ned, v_ned, strict=True))
    n, e, d = (rest + min(max(along / square, 0.0), within_s) * v for rest, v in zip(rest_ned, v_ned, strict=True))
    return n, e, d


def stretch(legs: list[Leg], least_s: float, most_s: float, begun_s: float = 0.0) -> list[Vec3]:
    """Places on a way that are reached from one time to another, if it was begun at a third; none where it is flown by
    then."""
    places: list[Vec3] = []
    start_s = begun_s
    for a, b, speed_m_s, not_before_s in legs:
        if start_s < not_before_s and least_s < not_before_s and start_s < most_s:
            places.append(a)
        start_s = max(start_s, not_before_s)
        length_m = elementary.distance(a, b)
        end_s = start_s + length_m / speed_m_s
        low_s, high_s = max(least_s, start_s), min(most_s, end_s)
        if low_s < high_s:
            low_m, high_m = (low_s - start_s) * speed_m_s, (high_s - start_s) * speed_m_s
            count = math.ceil((high_m - low_m) / STEP_M) + 1
            for k in range(count):
                places.append(_between(a, b, (low_m + (high_m - low_m) * k / max(count - 1, 1)) / length_m))
        start_s = end_s
    return places


def _between(a: Vec3, b: Vec3, share: float) -> Vec3:
    return (a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2]))
