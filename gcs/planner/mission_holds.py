"""Which vehicles on missions have to wait: the supervisor sends them no set points, but knows their ways.

Each goes from its place straight to the places of its remaining items. Its stretch is where it may be before it stands,
if it is ordered to hold now: so far along that way, and straight on, for it may not turn any more.

1. Of two on missions the one with the higher system id gives way. It holds where its stretch comes nearer than the
   distance wanted to where the other may be by the time when it stands; earlier, if they fly towards each other, by the
   time that it needs to step aside. The first need not fly yet: both could set out at once. While another with a lower
   id waits for it alone, it waits.
2. Each holds where its stretch comes near to one that stands or brakes, or to where one that holds may come back to.
3. Others, which are led by set points, see the stretch and give way themselves (`claims`). A vehicle holds for one that
   would come too near all the same, both going on as they do, before it could stand.
4. One that holds in the way of another steps aside: it is led by set points like all others until it goes on.
5. Led vehicles leave the way of one that waits (`claims`), forward where they stand in it. Of ways that come near to
   each other only that of the lowest system id is kept free, and none near one that is not, and of a way no more than
   leads up to a sharp corner while another is between the legs: there, or between several ways, a vehicle would have
   nowhere to go, and all would wait for ever.
6. One that waits goes on when it could by the same rules, were it up to a speed, for CLEAR_S.
Only what comes nearer counts: two that are too near may part.

NED, m, m/s, s; no clock.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gcs.telemetry.state import Vec3
from skytender import elementary
from skytender.geometry import FloatArray

ALONG_M = 0.3
"""Between places of a stretch."""
PARTS_M = 0.02
"""An approach by less does not count."""
SETS_OUT_M_S = 1.0
"""[choice] Least speed up to which one that holds must be able to go on."""
CLEAR_S = 1.0
STANDS_M_S = 0.5
"""[choice] Speed below which it can be taken over."""
ASIDE_S = 5.0
"""[choice] Time to step aside: to be steered again, and to leave."""
SAMPLE_S = 0.1
SHARP = 0.5
"""Cosine of the least angle by which a way turns at a sharp corner."""
POCKET = 1.5
"""[choice] Of the separation: what is so near to both legs of a corner is between them."""


NOWHERE: FloatArray = np.zeros((0, 3))


class Stopping(NamedTuple):
    """How a vehicle comes to stand."""

    reacts_s: float
    brakes_m_s2: float
    strays_m: float
    """how far it may fly beside its way, and what its places are wrong by"""
    gains_m_s: float
    """speed that it may gain until an order has effect"""

    def time_s(self, speed_m_s: float) -> float:
        """Until it stands."""
        return self.reacts_s + speed_m_s / self.brakes_m_s2

    def way_m(self, speed_m_s: float) -> float:
        """Until it stands, from the present."""
        fast = speed_m_s + self.gains_m_s
        return fast * self.reacts_s + fast * fast / (2.0 * self.brakes_m_s2)


OURS = Stopping(0.4, 2.5, 0.15, 0.5)
FOREIGN = Stopping(1.0, 2.0, 0.6, 1.5)
"""[choice] Of autopilots that are not ours: a command on its way, and jerk-limited brakes. A PX4 that had set
out gained 1.2 m/s more after the order to hold at 3.1 m/s, and stood 9 m further on."""


@dataclass(frozen=True, slots=True)
class OnMission:
    """A vehicle that flies its mission, holds on it, or stepped aside from it."""

    sysid: int
    name: str
    p_ned: Vec3
    v_ned: Vec3
    ahead: tuple[Vec3, ...]
    """places of its remaining items, the present one's first"""
    goes: bool
    """whether it flies its mission now; else it waits"""
    led: bool
    """whether it is led by set points"""
    stopping: Stopping
    cruise_m_s: float = 0.0
    """its greatest speed so far"""
    held_ned: FloatArray = field(default_factory=lambda: NOWHERE)
    """(k, 3) where it may come back to while it holds: an autopilot keeps the place where it was ordered to, or would
    have stood, and returns there after it has given way or flown beyond"""

    @property
    def pace_m_s(self) -> float:
        """Speed with which it is reckoned: its own; of one that waits, that which it will have."""
        speed_m_s = elementary.norm(self.v_ned)
        return speed_m_s if self.goes else max(speed_m_s, self.cruise_m_s, SETS_OUT_M_S)


@dataclass(frozen=True, slots=True)
class Other:
    """A vehicle or aircraft that flies no mission."""

    name: str
    p_ned: Vec3
    v_ned: Vec3


class MissionVerdict(NamedTuple):
    """Decision about one on a mission."""

    waits_for: str
    """name of what it holds for; empty where it may go on"""
    aside: bool
    """whether it stands in another's way"""
    claim_ned: FloatArray
    """(k, 3) where the others must not be"""


def judge(flights: Sequence[OnMission], others: Sequence[Other], separation_m: float) -> dict[int, MissionVerdict]:
    """MissionVerdict for each, by system id; `flights` in order of system id."""
    verdicts: dict[int, MissionVerdict] = {}
    blocked_by: dict[int, list[str]] = {}
    asked: list[FloatArray] = []
    for i, one in enumerate(flights):
        speed_m_s = one.pace_m_s
        stretch = _stretch(one, one.stopping.way_m(speed_m_s))
        stands_s = one.stopping.time_s(speed_m_s)
        blocks = blocked_by[one.sysid] = []
        for j, other in enumerate(flights):
            if j == i:
                continue
            if j < i and set(blocked_by[other.sysid]) == {one.name}:
                blocks.append(other.name)
            first = j < i and not blocked_by[other.sysid]
            if other.led and not first:
                continue
            wanted_m = separation_m + one.stopping.strays_m + other.stopping.strays_m
            theirs = np.concatenate([braking(other), other.held_ned])
            if first:
                for_s = stands_s + (ASIDE_S if _head_on(one, other) else 0.0)
                their_m_s = max(_speed(other), SETS_OUT_M_S)  # one that has just been let go on will be faster
                theirs = _stretch(other, other.stopping.way_m(their_m_s) + for_s * their_m_s)
            if _meet(stretch, theirs, one.p_ned, other.p_ned, wanted_m):
                blocks.append(other.name)
        led = [Other(other.name, other.p_ned, other.v_ned) for other in flights if other.led and other is not one]
        for near in (*others, *led):
            if _reach(one, near, speed_m_s, stands_s, separation_m + one.stopping.strays_m):
                blocks.append(near.name)
        waits_for = blocks[0] if blocks else ""
        claim = _bend(one, stretch) if one.goes else stretch[:0]
        if waits_for and not one.goes:  # led vehicles leave it
            way = np.array(_along(one, max(one.stopping.way_m(speed_m_s), speed_m_s * stands_s)))
            if not any(_least2(way, theirs) < 4.0 * separation_m * separation_m for theirs in asked):
                leg = _without_pocket(one, way, (*others, *led), separation_m)
                claim = _up_to(leg, (*others, *led), 0.5 * separation_m)[1:]
            asked.append(way)
        verdicts[one.sysid] = MissionVerdict(waits_for, False, claim)
    return {one.sysid: verdicts[one.sysid]._replace(aside=_in_the_way(one, flights, separation_m)) for one in flights}


def _in_the_way(one: OnMission, flights: Sequence[OnMission], separation_m: float) -> bool:
    """Whether one that holds stands where another, which goes before it, leads."""
    if one.goes or one.led or _speed(one) > STANDS_M_S:
        return False
    for other in flights:
        if other.sysid < one.sysid:
            wanted_m = separation_m + one.stopping.strays_m + other.stopping.strays_m
            speed_m_s = max(other.pace_m_s, SETS_OUT_M_S)
            way = _stretch(other, other.stopping.way_m(speed_m_s) + ASIDE_S * speed_m_s)
            if _meet(way, np.concatenate([[one.p_ned], one.held_ned]), other.p_ned, one.p_ned, wanted_m):
                return True
    return False


def _head_on(one: OnMission, other: OnMission) -> bool:
    """Whether two fly, or are to fly, towards each other rather than across."""
    mine, theirs = _heading(one), _heading(other)
    against = sum(a * b for a, b in zip(mine, theirs, strict=True))
    return against < -0.5 * elementary.norm(mine) * elementary.norm(theirs)


def _heading(one: OnMission) -> Vec3:
    """Along its velocity, or to where it is to go on."""
    if one.goes or not one.ahead:
        return one.v_ned
    n, e, d = (goal - here for goal, here in zip(one.ahead[0], one.p_ned, strict=True))
    return n, e, d


def _speed(one: OnMission) -> float:
    return elementary.norm(one.v_ned)


def braking(one: OnMission) -> FloatArray:
    """(k, 3) where it may be if it brakes now."""
    speed_m_s = _speed(one)
    if speed_m_s < 0.1:
        return np.array([one.p_ned])
    return _line(one.p_ned, one.v_ned, one.stopping.way_m(speed_m_s) / speed_m_s)


def _line(p_ned: Vec3, v_ned: Vec3, for_s: float) -> FloatArray:
    count = int(elementary.norm(v_ned) * for_s / ALONG_M) + 1
    return np.array(p_ned) + np.linspace(0.0, for_s, count + 1)[:, np.newaxis] * np.array(v_ned)


def _along(one: OnMission, length_m: float) -> list[Vec3]:
    """Places along its way, ALONG_M apart, its own first."""
    places, here, left_m = [one.p_ned], one.p_ned, length_m
    for goal in one.ahead:
        leg_m = elementary.distance(here, goal)
        count = int(min(leg_m, left_m) / ALONG_M)
        for k in range(1, count + 1):
            t = k * ALONG_M / leg_m
            n, e, d = (a + t * (b - a) for a, b in zip(here, goal, strict=True))
            places.append((n, e, d))
        left_m -= leg_m
        if left_m <= 0.0:
            break
        places.append(goal)
        here = goal
    return places


def _corner_m(one: OnMission, beyond_m: float) -> float:
    """Length of its way up to the first sharp corner that is farther than this; at most as far as its last item."""
    here, length_m = one.p_ned, 0.0
    for goal, following in pairwise(one.ahead):
        length_m += elementary.distance(here, goal)
        comes = [b - a for a, b in zip(here, goal, strict=True)]
        goes = [b - a for a, b in zip(goal, following, strict=True)]
        straight = sum(a * b for a, b in zip(comes, goes, strict=True))
        if length_m > beyond_m and straight < SHARP * elementary.norm(comes) * elementary.norm(goes):
            return length_m
        here = goal
    return length_m + (elementary.distance(here, one.ahead[-1]) if one.ahead else 0.0)


def _without_pocket(one: OnMission, way: FloatArray, others: Sequence[Other], separation_m: float) -> FloatArray:
    """(k, 3) its way, up to the next sharp corner where another is between the legs: it has to come out of there
    first."""
    corner = int(_corner_m(one, separation_m) / ALONG_M) + 1
    near_m = POCKET * separation_m
    for other in others if corner < len(way) else ():
        place = np.array([other.p_ned])
        if max(_least2(way[:corner], place), _least2(way[corner:], place)) < near_m * near_m:
            return way[:corner]
    return way


def _stretch(one: OnMission, length_m: float) -> FloatArray:
    """(k, 3) where it may be within this length of its way, or straight on."""
    return np.concatenate([np.array(_along(one, length_m)), braking(one)])


def _bend(one: OnMission, stretch: FloatArray) -> FloatArray:
    """(k, 3) the part of its stretch off the straight line on which others foresee it."""
    speed_m_s = _speed(one)
    away = stretch - np.array(one.p_ned)
    if speed_m_s < 0.1:
        return stretch[1:]
    ahead = np.array(one.v_ned) / speed_m_s
    along_m = (away * ahead).sum(axis=1)
    beside = away - np.maximum(along_m, 0.0)[:, np.newaxis] * ahead
    return stretch[(beside * beside).sum(axis=1) > one.stopping.strays_m * one.stopping.strays_m]


def _meet(mine: FloatArray, theirs: FloatArray, p_ned: Vec3, other_ned: Vec3, wanted_m: float) -> bool:
    """Whether places come nearer to each other than wanted, and than the two are now."""
    limit_m = min(wanted_m, elementary.distance(p_ned, other_ned) - PARTS_M)
    if limit_m <= 0.0:
        return False
    return _least2(mine, theirs) < limit_m * limit_m


def _up_to(way: FloatArray, others: Sequence[Other], within_m: float) -> FloatArray:
    """(k, 3) its places before it leads through another: beyond, they would drive that one back into it."""
    for k, place in enumerate(way.tolist()):
        if any(elementary.distance(place, other.p_ned) < within_m for other in others):
            return way[:k]
    return way


def _least2(mine: FloatArray, theirs: FloatArray) -> float:
    """Square of the least distance between places (k, 3) and others (n, 3), m²."""
    apart = mine[:, np.newaxis] - theirs[np.newaxis]
    return float((apart * apart).sum(axis=2).min())


def _reach(one: OnMission, other: Other, speed_m_s: float, stands_s: float, wanted_m: float) -> bool:
    """Whether another would come too near before it could stand, if both go on."""
    limit_m = min(wanted_m, elementary.distance(one.p_ned, other.p_ned) - PARTS_M)
    if limit_m <= 0.0:
        return False
    way = _along(one, speed_m_s * stands_s)
    times_s = np.arange(0.0, stands_s + SAMPLE_S, SAMPLE_S)
    rows = np.minimum((times_s * speed_m_s / ALONG_M).astype(np.int64), len(way) - 1)
    apart = np.array(way)[rows] - (np.array(other.p_ned) + times_s[:, np.newaxis] * np.array(other.v_ned))
    return bool((apart * apart).sum(axis=1).min() < limit_m * limit_m)
