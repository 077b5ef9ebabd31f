"""The competition as each vehicle runs it for itself, over the bids that it hears (docs/model/competition.md#k-winners)
[lineage].

The k greatest win at once, k the free tankers, when the last of them has left the next one behind for the dwell time.
Each vehicle finds all winners and their tankers; it acts only where it is one of them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from simvehicle.fleet.bids import HOPELESS_S, Offer, begins_s, lasts_s, meeting_s
from simvehicle.fleet.peers import DecidedBy, PeerReport
from simvehicle.fleet.rules import FleetRules
from skytender import elementary
from skytender.assignment import least_cost
from skytender.k_winners import Competitor, Standings, bounded, meant, read
from skytender.winner_take_all import advance_ln

_ROUNDING_S = 1e-6


class FleetAward(NamedTuple):
    """A winner, its tanker, and the rule that decided."""

    receiver: int
    tanker: int
    by: DecidedBy


class FleetCompetition:
    """One vehicle's copy of the competition, from tick to tick."""

    def __init__(self, rules: FleetRules) -> None:
        self._rules = rules
        self._ln_v: dict[int, float] = {}
        self._bidders: list[Competitor] = []
        self._reports: Mapping[int, PeerReport] = {}
        self._standings = Standings(p=rules.p, tie_s=rules.tie_s, share=rules.share)
        self._begun_s: float | None = None
        self._last_s: float | None = None

    def advance(self, now_s: float, competing: Mapping[int, PeerReport], places: int) -> None:
        """Advance the competition, by peers' reports, to a time; `places`: tankers that there are, busy ones too."""
        rules, places = self._rules, max(places, 1)
        dt_s = 0.0 if self._last_s is None else now_s - self._last_s
        self._last_s = now_s
        self._reports = dict(sorted(competing.items()))
        if not competing:
            self._ln_v, self._bidders, self._begun_s = {}, [], None
            self._standings.advance((), 0, now_s)
            return
        begins = self._beginnings(places)
        bids_s = {sysid: report.bid_s for sysid, report in self._reports.items()}
        above = 1.0 - np.array(list(bids_s.values())) / rules.horizon_s
        tau = rules.floor * (1.0 - above) + rules.high * above
        ln_v = advance_ln([begins[sysid] for sysid in bids_s], tau, dt_s, p=rules.p, rate=rules.rate)
        ln_v = bounded(ln_v, places, rules.floor)
        self._ln_v = dict(zip(bids_s, map(float, ln_v), strict=True))
        self._bidders = [
            Competitor(sysid, self._ln_v[sysid], report.bid_s, self._rank(sysid, report))
            for sysid, report in self._reports.items()
        ]
        self._standings.advance(self._bidders, places, now_s)
        self._begun_s = now_s if self._begun_s is None else self._begun_s

    def ln_v_of(self, sysid: int) -> float:
        """Logarithm of a competitor's state over the greatest one."""
        return self._ln_v[sysid] - max(self._ln_v.values()) if sysid in self._ln_v else 0.0

    def winners(self, now_s: float, free: Sequence[Offer]) -> list[FleetAward]:
        """Receivers that the free tankers serve next, each matched to its own; none while that is undecided."""
        if not free or not self._bidders:
            return []
        k, rules = len(free), self._rules
        if k >= len(self._bidders):
            return self._matched(now_s, [one.sysid for one in self._bidders], DecidedBy.UNOPPOSED, free)
        reading = self._standings.reading(k)
        if reading is not None and self._standings.clear_s(k, now_s) >= rules.dwell_s - _ROUNDING_S:
            return self._matched(now_s, reading.winners, DecidedBy.COMPETITION, free)
        slacks_s = [report.slack_s for report in self._reports.values()]
        if min((s for s in slacks_s if s >= HOPELESS_S), default=math.inf) <= 2.0 * rules.dwell_s:
            winners = meant(self._bidders, k, p=rules.p, tie_s=rules.tie_s).winners
            return self._matched(now_s, winners, DecidedBy.URGENCY, free)
        if self._begun_s is not None and now_s - self._begun_s >= rules.decide_within_s:
            winners = read(self._bidders, k, p=rules.p, tie_s=rules.tie_s).winners
            return self._matched(now_s, winners, DecidedBy.TIMEOUT, free)
        return []

    def _beginnings(self, places: int) -> dict[int, float]:
        """States of the last tick; a new vehicle begins beside the one whose bid is nearest to its own."""
        known = [sysid for sysid in self._reports if sysid in self._ln_v]
        if not known:
            return dict.fromkeys(self._reports, places * elementary.log(self._rules.floor))
        begins = {}
        for sysid, report in self._reports.items():
            nearest = min(known, key=lambda one: (abs(self._reports[one].bid_s - report.bid_s), one))
            begins[sysid] = self._ln_v[sysid if sysid in self._ln_v else nearest]
        return begins

    def _matched(self, now_s: float, winners: Sequence[int], by: DecidedBy, free: Sequence[Offer]) -> list[FleetAward]:
        """The winners' tankers, by the least sum of the ways' times. With bids by time a winner that its tanker would
        reach too late leaves its place to the next one in time."""
        cost_s = [[self._way_s(now_s, offer, sysid) for offer in free] for sysid in winners]
        _, tanker_of = least_cost(np.reshape(cost_s, (len(winners), len(free))))
        others = [one.sysid for one in sorted(self._bidders, key=lambda one: (-one.ln_v, one.rank))]
        others = [sysid for sysid in others if sysid not in winners]
        found = []
        for winner, i in zip(winners, tanker_of.tolist(), strict=True):
            chosen = winner
            for candidate in (winner, *others):
                lasts = lasts_s(self._reports[candidate], now_s, self._rules.lands_at)
                weighed = self._rules.bids == "losses"
                if weighed or begins_s(self._way_s(now_s, free[i], candidate)) <= lasts:
                    chosen = candidate
                    break
            if chosen in others:
                others.remove(chosen)
            found.append(FleetAward(chosen, free[i].sysid, by))
        return found

    def _rank(self, sysid: int, report: PeerReport) -> tuple[float, ...]:
        """Order of vehicles that tie: with bids by losses the greatest bid, then least time left, need, system id;
        by time the hopeless last, then need to the percent, way to the second, system id."""
        if self._rules.bids == "losses":
            return report.bid_s, report.slack_s, -report.need, sysid
        return float(report.slack_s < HOPELESS_S), -round(100.0 * report.need), round(report.way_s), sysid

    def _way_s(self, now_s: float, offer: Offer, sysid: int) -> float:
        report = self._reports[sysid]
        offset = [there - here for there, here in zip(report.p_at(now_s), offer.p_ned, strict=True)]
        return meeting_s(offset, report.v_ned, offer.speed_m_s)
