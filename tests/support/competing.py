"""Vehicles that compete for givers, and the competition run until it decides."""

from __future__ import annotations

import math
from typing import Any

from gcs.refuelling.giver import Giver, ServiceTimes
from gcs.refuelling.time_bidding import TimeBidding
from gcs.telemetry.state import FleetSnapshot, VehicleView
from tests.support.services import view

TIMES = ServiceTimes(3.0, 1.0, 1.0)


def pursuer(
    sysid: int, lasts_s: float, at: tuple[float, float, float] = (0.0, 0.0, -5.0), **changed: Any
) -> VehicleView:
    """Lands in `lasts_s` at 200 W, for it lands at 5 % of 20 kJ."""
    made = view(sysid, "pursuer", at, 1000.0 + 200.0 * lasts_s, 20_000.0)
    return made._replace(power_w=200.0, **changed)


def giver(
    name: int, at: tuple[float, float, float] = (0.0, 0.0, -6.0), free_in_s: float = 0.0, speed: float = 5.0
) -> Giver:
    return Giver(name, at, free_in_s, speed, 1e5, 2000.0)


def decide(
    bidding: TimeBidding, views: list[VehicleView], givers: list[Giver], within_s: float = 40.0, from_s: float = 0.0
) -> tuple[float, list[tuple[int | str, int, str]]]:
    """Ticks of 0.1 s, the batteries drawn meanwhile, until there are awards: when, and (giver, receiver, by)."""
    for k in range(round(within_s * 10) + 1):
        now_s = from_s + k / 10
        drawn = [v._replace(drawn_j=v.drawn_j + v.power_w * (now_s - from_s)) for v in views]
        snapshot = FleetSnapshot(now_s, tuple(drawn), ())
        bidding.advance(snapshot, (), givers, TIMES)
        if found := list(bidding.awards(snapshot, [g for g in givers if g.free_in_s == 0.0])):
            return now_s, [(award.giver.name, award.receiver, award.by) for award in found]
    return math.inf, []
