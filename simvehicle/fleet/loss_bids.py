"""Bids by likely losses, as a vehicle makes its own from what the others report
(docs/model/competition.md#likely-losses) [choice]."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from simvehicle.fleet.bids import END_S, PER_WAY, START_S, Offer
from simvehicle.fleet.peers import PeerReport, PeerStage
from simvehicle.fleet.rules import FleetRules
from skytender.rolling_horizon import Durations, Givers
from skytender.service_plan import AGAIN_S, PlannedFleet, below_greatest, gain_of, planned

_AWAITS = frozenset({PeerStage.APART, PeerStage.COMPETES})


class LossBids:
    """One vehicle's own gain, planned for all that it receives."""

    def __init__(self, sysid: int, rules: FleetRules) -> None:
        self._sysid, self._rules = sysid, rules
        self._planned_for: tuple[frozenset[int], ...] | None = None
        self._planned_s = -math.inf
        self._gain = 0.0

    def bid_s(self, now_s: float, own: PeerReport, peers: Mapping[int, PeerReport], givers: Sequence[Offer]) -> float:
        """Its bid on the scale of time, of a vehicle that reports `own`."""
        if not givers:
            return self._rules.horizon_s * below_greatest(0.0)
        fleet = {sysid: one for sysid, one in peers.items() if sysid in self._rules.pursuers and self._can_wait(one)}
        fleet[self._sysid] = own
        competing = frozenset(sysid for sysid, one in fleet.items() if one.stage is PeerStage.COMPETES)
        free = frozenset(giver.sysid for giver in givers if giver.free_in_s == 0.0)
        draws = frozenset(sysid for sysid, one in fleet.items() if one.power_w > 0.0)
        situation = competing | {self._sysid}, free, draws
        if situation != self._planned_for or now_s - self._planned_s >= AGAIN_S:
            self._planned_for, self._planned_s = situation, now_s
            self._gain = self._planned(now_s, dict(sorted(fleet.items())), situation[0], givers)
        return self._rules.horizon_s * below_greatest(self._gain)

    @staticmethod
    def _can_wait(peer: PeerReport) -> bool:
        return peer.up and peer.stage in _AWAITS

    def _planned(
        self, now_s: float, fleet: Mapping[int, PeerReport], competing: frozenset[int], givers: Sequence[Offer]
    ) -> float:
        rules, reports = self._rules, list(fleet.values())
        vehicles = PlannedFleet(
            np.array([one.p_at(now_s) for one in reports]),
            np.array([one.remaining_at_j(now_s) for one in reports]),
            np.array([one.capacity_j for one in reports]),
            np.array([one.power_w for one in reports]),
            np.array([sysid in competing for sysid in fleet]),
        )
        tankers = Givers(
            np.array([giver.p_ned for giver in givers]),
            np.array([giver.free_in_s for giver in givers]),
            np.array([giver.speed_m_s for giver in givers]),
            np.array([giver.available_j for giver in givers]),
            np.full(len(givers), rules.rate_w),
            np.ones(len(givers), np.bool_),
        )
        best = planned(
            vehicles,
            tankers,
            Durations(START_S, PER_WAY, END_S),
            need_from=rules.need_from,
            until=rules.until,
            lands_at=rules.lands_at,
            left_s=max(rules.transfers_until_s - now_s, 0.0),
        )
        row = list(fleet).index(self._sysid)
        return gain_of(float(best.served_cost[row]), float(best.passed_over_cost[row]))
