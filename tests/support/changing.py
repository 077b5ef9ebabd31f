"""A fleet to which anything may happen, tick by tick, and its snapshots, which tell of changes or do not."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from typing import Any

import numpy as np
from views import view

from gcs.mavlink.autopilots import FlightMode
from gcs.telemetry.state import FleetSnapshot, VehicleView

PERIOD_S = 0.1
FIGURES: dict[str, Any] = {
    "last_received_s": 0.0, "p_ned": None, "v_ned": None, "age_s": 0.0, "heading_rad": 0.0, "drawn_j": 0.0,
    "power_w": 0.0, "control_effort": 0.0, "way_m": 0.0,
}  # fmt: skip
"""Attributes that count for no change."""


class ChangingFleet:
    """Vehicles that climb, fly, fall silent, are doubted, land, die and come back at random; most ticks nothing."""

    def __init__(self, sysids: Sequence[int], seed: int) -> None:
        self.chance = random.Random(seed)
        self.time_s = 0.0
        self.views = [
            view(sysid, mode=FlightMode.HOLD, armed=False, landed=True, last_received_s=-1.0, p_ned=None, age_s=9.0,
                 ground_down_m=0.0, battery_reported=False, drawn_j=0.0)
            for sysid in sysids
        ]  # fmt: skip
        self._silent: set[int] = set()
        self._number, self._changed = 0, np.zeros(len(sysids), np.int64)
        self._seen: list[Any] = [None] * len(sysids)

    def tick(self) -> tuple[FleetSnapshot, FleetSnapshot]:
        """A snapshot that tells of changes, and the same without."""
        self.time_s = round(self.time_s + PERIOD_S, 6)
        self.views = [self._later(each) for each in self.views]
        number = self._number + 1
        for row, each in enumerate(self.views):
            known = (
                each.p_ned is not None,
                each.last_received_s >= 0.0,
                each.flying,
                each.fresh,
                each.remaining_j <= 0.0,
            )
            seen = (each._replace(**FIGURES), *known)
            if seen != self._seen[row]:
                self._seen[row] = seen
                self._changed[row] = self._number = number
        telling, plain = (FleetSnapshot(self.time_s, tuple(self.views), ()) for _ in range(2))
        changes = {"number": self._number, "changed": self._changed.copy()}
        vars(telling)["columns"] = telling.columns._replace(**changes)
        return telling, plain

    def _later(self, one: VehicleView) -> VehicleView:
        chance, sysid = self.chance, one.sysid
        if chance.random() < 0.02:
            self._silent ^= {sysid}
        changed: dict[str, Any] = {"drawn_j": one.drawn_j + chance.choice([1.0, 1.0, 3.0])}
        if sysid in self._silent:
            changed["age_s"] = one.age_s + PERIOD_S
        elif chance.random() < 0.9 or one.p_ned is not None:
            n, e, d = one.p_ned or (float(sysid), 0.0, 0.0)
            v_ned = (
                chance.gauss(0.1 * (sysid - n), 1.0),
                chance.gauss(-0.1 * e, 1.0),
                chance.gauss(-0.1 * (d + 1.8), 1.0),
            )
            p_ned = (n + v_ned[0] * PERIOD_S, e + v_ned[1] * PERIOD_S, min(d + v_ned[2] * PERIOD_S, 0.0))
            changed |= {"age_s": chance.choice([0.0, 0.06]), "last_received_s": self.time_s}
            changed |= {"p_ned": p_ned, "v_ned": v_ned, "battery_reported": True}
            changed["way_m"] = one.way_m + (0.0 if one.p_ned is None else math.dist(p_ned, one.p_ned))
        if chance.random() < 0.06:
            changed |= self._happens(one)
        later = one._replace(**changed)
        return later._replace(battery_empty=later.remaining_j <= 0.0)

    def _happens(self, one: VehicleView) -> dict[str, Any]:
        flies = {"mode": FlightMode.OFFBOARD, "armed": True, "landed": False, "alive": True, "doubt": ""}
        mode = self.chance.choice(list(FlightMode))
        return self.chance.choice(
            [
                flies, flies, flies, flies, flies, {"armed": True}, {"landed": not one.landed}, {"mode": mode},
                {"armed": not one.armed}, {"mode": FlightMode.TAKEOFF, "armed": True}, {"mode": FlightMode.LAND},
                {"alive": not one.alive}, {"doubt": "its place jumps"}, {"doubt": ""}, {"failsafe": not one.failsafe},
                {"drawn_j": one.capacity_j + 1.0}, {"drawn_j": 0.0}, {"received_j": one.received_j + 100},
            ]
        )  # fmt: skip
