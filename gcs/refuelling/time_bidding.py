"""The competition of vehicles that wait, as many winners at once as givers are free
(docs/protocol/energy.md#refuelling-schedule, docs/model/competition.md#k-winners) [choice].

A bid is the time until the vehicle must land, less the time until energy could reach it if another were served first,
and the way to it, which all others wait for, added: the least bids most. The law is the paper's; the k greatest win at
once when the last of them has left the next one behind for the dwell time. While no giver is free the competition goes
on for every k, so that a giver that becomes free is seldom kept waiting.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from gcs.refuelling.bidding import Award, CompetitionState, is_servable
from gcs.refuelling.early_ends import EarlyEnds
from gcs.refuelling.giver import Giver, ServiceTimes, lasts_s, match, nearest_s, served_if_passed_over_s, ways_s
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import FleetSnapshot, VehicleView
from skytender import elementary
from skytender.k_winners import Competitor, Standings, bounded, meant, read
from skytender.winner_take_all import advance_ln

HOPELESS_S = -3.0
"""[choice] A vehicle that would have landed so long before energy could reach it is served after all others: estimates
are as wrong as that."""
LATEST_S = 15.0
"""[choice] A vehicle that would be so much too late, were another served first, bids `high`."""
_ROUNDING_S = 1e-6


class TimeBidding:
    """The competition's memory from tick to tick."""

    waits_for_all = True
    early_ends: EarlyEnds | None = None

    def __init__(self, rules: CompetitionRules, refuelling: RefuellingRules) -> None:
        self._rules = rules
        self._refuelling = refuelling
        self._ln_v: dict[int, float] = {}
        self._competing: list[Competitor] = []
        self._standings = Standings(p=rules.p, tie_s=rules.tie_s, share=rules.share)
        self._begun_s: float | None = None
        self._last_s: float | None = None
        self._times: ServiceTimes | None = None
        self._tau: NDArray[np.float64] = np.empty(0)
        self.bids_s: dict[int, float] = {}
        """each competitor's bid on its scale of time, 0 to the horizon: the least is the greatest bid"""
        self.slack_s: dict[int, float] = {}
        """time until each competitor must land, less the time until energy can reach it if it is served first"""
        self.gain: dict[int, float] = {}
        """with bids by losses, each competitor's"""
        self.competition_state = CompetitionState()

    def advance(
        self, snapshot: FleetSnapshot, served: Collection[int], givers: Sequence[Giver], times: ServiceTimes
    ) -> None:
        """Advance the competition to the snapshot's time; `givers` are all that there are, busy ones too."""
        now_s, rules, self._times = snapshot.time_s, self._rules, times
        dt_s = now_s - self._last_s if self._last_s is not None else 0.0
        self._last_s = now_s
        able = [v for v in snapshot.of_role("pursuer") if v.sysid not in served and is_servable(v)]
        self.slack_s = {}
        competitors = []
        for view in able:
            left_s = lasts_s(view, self._refuelling.lands_at)
            if view.need < rules.need_from and left_s >= rules.horizon_s:
                continue
            slack_s = left_s - nearest_s(givers, view, times) if givers else left_s
            if view.need >= rules.need_from or slack_s < self._refuelling.reserve_s:
                competitors.append(view)
                self.slack_s[view.sysid] = slack_s
        if not competitors:
            self._forget()
            return
        self.bids_s = self._bids_s(now_s, competitors, able, givers)
        self._compete(competitors, dt_s, max(len(givers), 1))
        self._standings.advance(self._competing, max(len(givers), 1), now_s)
        self._begun_s = now_s if self._begun_s is None else self._begun_s
        self._show({view.sysid: view.need for view in competitors})

    def _forget(self) -> None:
        self._ln_v, self._competing = {}, []
        self._standings.advance((), 0, 0.0)
        self._begun_s = None
        self.competition_state = CompetitionState()

    def _bids_s(
        self, now_s: float, competitors: Sequence[VehicleView], able: Sequence[VehicleView], givers: Sequence[Giver]
    ) -> dict[int, float]:
        """The bid of each competitor, of the vehicles that are `able` to be served."""
        assert self._times is not None
        passed_s = served_if_passed_over_s(givers, competitors, self._times, self._refuelling)
        left_s = [lasts_s(view, self._refuelling.lands_at) for view in competitors]
        spare_s = (
            left + way - passed for left, way, passed in zip(left_s, ways_s(givers, competitors), passed_s, strict=True)
        )
        return {
            view.sysid: self._rules.horizon_s
            if self.slack_s[view.sysid] < HOPELESS_S
            else min(max(spare + LATEST_S, 0.0), self._rules.horizon_s)
            for view, spare in zip(competitors, spare_s, strict=True)
        }

    def _compete(self, competitors: Sequence[VehicleView], dt_s: float, places: int) -> None:
        """Advance the law by one tick."""
        rules = self._rules
        bids_s = list(self.bids_s.values())
        begins = self._beginnings(self.bids_s, places)
        above = 1.0 - np.array(bids_s) / rules.horizon_s
        self._tau = rules.floor * (1.0 - above) + rules.high * above
        ln_v = np.array([begins[view.sysid] for view in competitors])
        ln_v = bounded(advance_ln(ln_v, self._tau, dt_s, p=rules.p, rate=rules.rate), places, rules.floor)
        self._ln_v = {view.sysid: float(x) for view, x in zip(competitors, ln_v, strict=True)}
        self._competing = [
            Competitor(view.sysid, self._ln_v[view.sysid], bid_s, self._rank(view))
            for view, bid_s in zip(competitors, bids_s, strict=True)
        ]

    def _beginnings(self, bids_s: Mapping[int, float], places: int) -> dict[int, float]:
        """States of the last tick; a new vehicle begins beside the one whose bid is nearest to its own, as though it
        had competed as long, and where all are new, at the bottom."""
        known = [sysid for sysid in bids_s if sysid in self._ln_v]
        if not known:
            return dict.fromkeys(bids_s, places * elementary.log(self._rules.floor))
        return {
            sysid: self._ln_v[
                sysid if sysid in self._ln_v else min(known, key=lambda one: (abs(bids_s[one] - bid_s), one))
            ]
            for sysid, bid_s in bids_s.items()
        }

    def _rank(self, view: VehicleView) -> tuple[float, ...]:
        """Order of vehicles that tie: the hopeless last, then need to the percent, way to the second, system id."""
        slack_s = self.slack_s[view.sysid]
        way_s = lasts_s(view, self._refuelling.lands_at) - slack_s
        way = round(way_s) if math.isfinite(way_s) else 0
        return (float(slack_s < HOPELESS_S), -round(100.0 * view.need), way, view.sysid)

    def _show(self, need: dict[int, float]) -> None:
        """Write the competition's state for others to show: states over the leader's, bids, first reading."""
        v = {one.sysid: elementary.exp(max(one.ln_v, -700.0)) for one in self._competing}
        tau = {one.sysid: float(t) for one, t in zip(self._competing, self._tau, strict=True)}
        first = self._standings.reading(1)
        leader, held = (first.winners[0], first.share) if first else (self._competing[0].sysid, 1.0)
        self.competition_state = CompetitionState(v, tau, need, leader, held, dict(self.gain))

    def awards(self, snapshot: FleetSnapshot, free: Sequence[Giver]) -> Iterable[Award]:
        """The next services, each receiver matched to its giver; none while that is undecided."""
        if not free or not self._competing:
            return []
        k, now_s, rules = len(free), snapshot.time_s, self._rules
        if k >= len(self._competing):
            return self._matched([one.sysid for one in self._competing], "unopposed", snapshot, free)
        reading = self._standings.reading(k)
        if reading is not None and self._standings.clear_s(k, now_s) >= rules.dwell_s - _ROUNDING_S:
            return self._matched(reading.winners, "competition", snapshot, free)
        least_s = min((s for s in self.slack_s.values() if s >= HOPELESS_S), default=math.inf)
        if least_s <= 2.0 * rules.dwell_s:
            winners = meant(self._competing, k, p=rules.p, tie_s=rules.tie_s).winners
            return self._matched(winners, "urgency", snapshot, free)
        if self._begun_s is not None and now_s - self._begun_s >= rules.decide_within_s:
            return self._matched(self.likely(k), "timeout", snapshot, free)
        return []

    def likely(self, k: int) -> tuple[int, ...]:
        """The k that would win now."""
        if k >= len(self._competing):
            return tuple(one.sysid for one in self._competing)
        return read(self._competing, k, p=self._rules.p, tie_s=self._rules.tie_s).winners

    def approaches(self, snapshot: FleetSnapshot, free: Sequence[Giver]) -> dict[int, int]:
        """Receiver by tanker, of free tankers that fly towards the leader while the competition is undecided."""
        tankers = [giver for giver in free if giver.is_tanker]
        if not tankers or not self._competing:
            return {}
        likely = match(tankers, [snapshot.vehicle(sysid) for sysid in self.likely(len(tankers))])
        return {int(giver.name): view.sysid for giver, view in likely}

    def award(self, sysid: int, now_s: float) -> None:
        """The winner leaves; the others go on, and what was clear of k places is clear of one less without it."""
        if sysid not in self._ln_v:
            return
        del self._ln_v[sysid]
        self._competing = [one for one in self._competing if one.sysid != sysid]
        self.competition_state = self.competition_state.without(sysid)
        self._standings.without(sysid)
        self._begun_s = now_s if self.competition_state.v else None

    def _matched(self, winners: Sequence[int], by: str, snapshot: FleetSnapshot, free: Sequence[Giver]) -> list[Award]:
        """The winners' givers. A winner that its giver would reach too late leaves its place to the next one in time:
        another giver that is free soon may be nearer."""
        pairs = match(free, [snapshot.vehicle(sysid) for sysid in winners])
        others = [one.sysid for one in sorted(self._competing, key=lambda one: (-one.ln_v, one.rank))]
        others = [sysid for sysid in others if sysid not in winners]
        found = []
        for giver, winner in pairs:
            view = winner
            for candidate in (winner, *map(snapshot.vehicle, others)):
                if self._in_time(giver, candidate):
                    view = candidate
                    break
            if view.sysid in others:
                others.remove(view.sysid)
            found.append(Award(giver, view.sysid, by))
        return found

    def _in_time(self, giver: Giver, view: VehicleView) -> bool:
        """Whether a free giver can be with a vehicle before it lands."""
        assert self._times is not None
        return self._times.begins_in_s(giver.way_s(view)) <= lasts_s(view, self._refuelling.lands_at)
