"""Bids on the scale of time, as a vehicle makes its own from what the others report
(docs/model/competition.md#time-left) [choice].

The numbers that the ground station learns in a session, how long services take beside the way, are its first guesses
here.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from simvehicle.autopilot.vectors import Vec3
from simvehicle.fleet.peers import PeerReport, PeerStage
from simvehicle.fleet.rules import FleetRules
from skytender import elementary

HOPELESS_S = -3.0
"""[choice] A vehicle that would have landed so long before energy could reach it is served after all others."""
LATEST_S = 15.0
"""[choice] A vehicle that would be so much too late, were another served first, bids the most."""
START_S, PER_WAY, END_S = 3.0, 1.14, 0.5
"""From the decision to the first joule, as START_S + PER_WAY · way; and from the last joule to the end [choice]."""
WORTH_J = 500.0
"""A tanker that can spare less takes no receiver."""
LONG_S = 1e6
"""Stands for a time without an end in a report."""


class Offer(NamedTuple):
    """A tanker: where it will be free, when, how fast it is, and what it can spare then."""

    sysid: int
    p_ned: Vec3
    free_in_s: float
    speed_m_s: float
    available_j: float


class OwnBid(NamedTuple):
    """A bid on the absolute scale; time left beyond that until energy can come; time of the way to it, s."""

    bid_s: float
    slack_s: float
    way_s: float
    competes: bool


def lasts_s(report: PeerReport, now_s: float, lands_at: float) -> float:
    """Time until a vehicle lands by itself at its present draw."""
    left_j = max(report.remaining_at_j(now_s) - lands_at * report.capacity_j, 0.0)
    return min(left_j / report.power_w, LONG_S) if report.power_w > 0.0 else LONG_S


def begins_s(way_s: float) -> float:
    """From the decision to the first joule."""
    return START_S + PER_WAY * way_s


def flows_s(missing_j: float, power_w: float, rate_w: float) -> float:
    """How long energy flows until what is missing has come, while the receiver draws."""
    return max(missing_j, 0.0) / max(rate_w - power_w, 0.1 * rate_w)


def meeting_s(offset_ned: Sequence[float], v_ned: Sequence[float], speed_m_s: float) -> float:
    """Time to meet something that flies straight on, or to where it is if it cannot be met."""
    a = sum(v * v for v in v_ned) - speed_m_s * speed_m_s
    b = 2.0 * sum(o * v for o, v in zip(offset_ned, v_ned, strict=True))
    c = sum(o * o for o in offset_ned)
    straight_s = math.sqrt(c) / speed_m_s
    root = b * b - 4.0 * a * c
    if a >= 0.0 or root < 0.0:
        return straight_s
    return (-b - math.sqrt(root)) / (2.0 * a)


def offers(now_s: float, peers: Mapping[int, PeerReport], rules: FleetRules) -> list[Offer]:
    """Tankers that are received and have something to spare, busy ones from where and when their service ends."""
    found = []
    for sysid, tanker in peers.items():
        if sysid not in rules.tankers or tanker.stage is PeerStage.APART:
            continue
        speed_m_s, place, free_in_s, available_j = rules.tankers[sysid].speed_m_s, tanker.p_at(now_s), 0.0, 0.0
        receiver = peers.get(tanker.partner)
        available_j = tanker.remaining_j
        if tanker.stage is not PeerStage.FREE:
            free_in_s = END_S + 0.1
            if receiver is not None:
                missing_j = rules.until * receiver.capacity_j - receiver.remaining_at_j(now_s)
                free_in_s += flows_s(missing_j, receiver.power_w, rules.rate_w)
                available_j -= max(missing_j, 0.0)
                if tanker.stage is PeerStage.MEETS:
                    way_s = elementary.distance(place, receiver.p_at(now_s)) / speed_m_s
                    free_in_s += max(begins_s(way_s) - (now_s - tanker.since_s), 0.5)
                place = receiver.p_at(now_s)
        if available_j >= WORTH_J:
            found.append(Offer(sysid, place, free_in_s, speed_m_s, available_j))
    return found


def own_bid(
    now_s: float, own: PeerReport, others: Mapping[int, PeerReport], givers: Sequence[Offer], rules: FleetRules
) -> OwnBid:
    """Bid of a vehicle that reports `own`; `others`: the others that compete.

    bid = (time until it must land) - (time until energy reaches it if another is served first) + (way to it)
    """
    left_s, here = lasts_s(own, now_s, rules.lands_at), own.p_at(now_s)
    reach_s = [giver.free_in_s + begins_s(elementary.distance(giver.p_ned, here) / giver.speed_m_s) for giver in givers]
    slack_s = left_s - min(reach_s) if givers else left_s
    competes = own.need >= rules.need_from or (left_s < rules.horizon_s and slack_s < rules.reserve_s)
    soonest_s = min((giver.free_in_s for giver in givers), default=0.0)
    first = [giver for giver in givers if giver.free_in_s == soonest_s]
    way_s = min((elementary.distance(giver.p_ned, here) / giver.speed_m_s for giver in first), default=0.0)
    spare_s = left_s + way_s - _passed_over_s(now_s, here, others, givers, reach_s, rules)
    bid_s = rules.horizon_s if slack_s < HOPELESS_S else min(max(spare_s + LATEST_S, 0.0), rules.horizon_s)
    return OwnBid(bid_s, slack_s, way_s, competes)


def _passed_over_s(
    now_s: float,
    here: Vec3,
    others: Mapping[int, PeerReport],
    givers: Sequence[Offer],
    reach_s: Sequence[float],
    rules: FleetRules,
) -> float:
    """Time until energy reaches a place if another is served first by the tanker that is free first, any of the others
    as likely; a tanker that is free later may come before that."""
    if not givers:
        return 0.0
    if not others:
        return min(reach_s)
    soonest_s = min(giver.free_in_s for giver in givers)
    best_s = LONG_S
    for giver, direct_s in zip(givers, reach_s, strict=True):
        if giver.free_in_s > soonest_s:
            best_s = min(best_s, direct_s)
            continue
        total_s = 0.0
        for other in others.values():
            there = other.p_at(now_s)
            first_s = giver.free_in_s + begins_s(elementary.distance(giver.p_ned, there) / giver.speed_m_s)
            missing_j = rules.until * other.capacity_j - other.remaining_at_j(now_s) + other.power_w * first_s
            ends_s = first_s + flows_s(missing_j, other.power_w, rules.rate_w) + END_S
            total_s += ends_s + begins_s(elementary.distance(there, here) / giver.speed_m_s)
        best_s = min(best_s, total_s / len(others))
    return best_s
