"""Policies in the competition's place, and which bidding a scenario names."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence

from gcs.refuelling.bidding import (
    Award,
    BiddingRule,
    CompetitionState,
    EffortBidding,
    NeedBidding,
    is_servable,
    urgent_of,
)
from gcs.refuelling.early_ends import EarlyEnds
from gcs.refuelling.giver import Giver, ServiceTimes
from gcs.refuelling.loss_bidding import LossBidding
from gcs.refuelling.policies import OPTIMAL, SHIPPED, WINNER_TAKE_ALL, GuardedPolicy, PolicyCalls, RefuellingRequest
from gcs.refuelling.time_bidding import TimeBidding
from gcs.scenario.guard import Guard, PluginFault
from gcs.scenario.model import CompetitionRules, RefuellingRules, Scenario
from gcs.scenario.plugins import POLICY, PluginClient
from gcs.telemetry.state import FleetSnapshot, VehicleView
from skytender.winner_take_all import normalise


class PolicyBidding(BiddingRule):
    """Asks a policy for each free tanker; a tanker without a good answer waits where it is."""

    waits_for_all = True

    def __init__(
        self,
        rules: CompetitionRules,
        refuelling: RefuellingRules,
        speed_m_s: Mapping[int, float],
        policy: PolicyCalls,
        end_s: float,
    ) -> None:
        """`end_s`: session time at which the session ends."""
        self._rules = rules
        self._refuelling = refuelling
        self._speed_m_s = speed_m_s
        self._policy = policy
        self._end_s = end_s
        self._able: list[int] = []
        self._wanting: tuple[VehicleView, ...] = ()
        self._givers: tuple[Giver, ...] = ()
        self._times: ServiceTimes | None = None
        self.competition_state = CompetitionState()

    def advance(
        self, snapshot: FleetSnapshot, served: Collection[int], givers: Sequence[Giver], times: ServiceTimes
    ) -> None:
        """Vehicles that may be served at the snapshot's time; nothing competes: bids are needs and v is empty."""
        self._givers, self._times = tuple(givers), times
        able = [view for view in snapshot.of_role("pursuer") if view.sysid not in served and is_servable(view)]
        self._able = [view.sysid for view in able]
        self._wanting = tuple(view for view in able if view.need >= self._rules.need_from)
        need = {view.sysid: view.need for view in self._wanting}
        bids = normalise(list(need.values()), low=self._rules.floor, high=self._rules.high) if need else ()
        self.competition_state = CompetitionState({}, dict(zip(need, map(float, bids), strict=True)), need, None, 0.0)

    def awards(self, snapshot: FleetSnapshot, free: Sequence[Giver]) -> Iterator[Award]:
        """By `urgency` or `policy`: for all free tankers at once where the policy can, else for one after another."""
        waiting = [giver for giver in free if giver.is_tanker]
        if not waiting:
            return
        if self._policy.assigns:
            if self._wanting:
                yield from self._assigned(snapshot, waiting)
            return
        while waiting:
            giver = waiting.pop(0)
            won = self._won(snapshot, giver, waiting)
            if won is not None:
                yield Award(giver, *won)

    def _assigned(self, snapshot: FleetSnapshot, free: Sequence[Giver]) -> Iterator[Award]:
        pairs = self._policy.pairs(self._request(snapshot, free))
        for giver in free:
            if giver.name in pairs:
                yield Award(giver, pairs[giver.name], "policy")

    def _won(self, snapshot: FleetSnapshot, giver: Giver, others: Sequence[Giver]) -> tuple[int, str] | None:
        reserve_s = self._refuelling.hold_s + self._refuelling.reserve_s
        urgent = urgent_of(snapshot, self._able, [giver.p_ned], giver.speed_m_s, reserve_s)
        if urgent is not None:
            return urgent, "urgency"
        if not self._wanting:
            return None
        request = self._request(snapshot, [giver, *others])
        chosen = self._policy.pairs(request).get(request.tanker.sysid)
        return None if chosen is None else (chosen, "policy")

    def _request(self, snapshot: FleetSnapshot, free: Sequence[Giver]) -> RefuellingRequest:
        tankers = tuple(snapshot.vehicle(int(giver.name)) for giver in free)
        wanting = {view.sysid for view in self._wanting}
        return RefuellingRequest(
            snapshot.time_s,
            tankers[0],
            self._wanting,
            tankers,
            self._speed_m_s,
            self._refuelling,
            givers=tuple(one for one in self._givers if one.is_tanker),
            later=tuple(view for view in map(snapshot.vehicle, self._able) if view.sysid not in wanting),
            times=self._times,
            left_s=max(self._end_s - snapshot.time_s, 0.0),
        )

    def award(self, sysid: int, now_s: float) -> None:
        """The chosen vehicle is no longer available to other givers."""
        self._able = [one for one in self._able if one != sysid]
        self._wanting = tuple(view for view in self._wanting if view.sysid != sysid)
        self.competition_state = self.competition_state.without(sysid)


class PluginPolicy(PolicyCalls):
    """A user's policy, in another process. Once that has ended, urgency alone decides: a vehicle that would not
    last until a later rendezvous is served. See `PolicyCalls` for the methods."""

    def __init__(self, plugins: PluginClient) -> None:
        """Raises ScenarioError where it cannot be made."""
        self._assigns = plugins.made(POLICY)
        self._plugins = plugins

    @property
    def assigns(self) -> bool:
        return self._assigns and not self._plugins.ended

    def pairs(self, request: RefuellingRequest) -> dict[int, int]:
        self._plugins.ask(POLICY, request)
        return dict(self._plugins.answers(POLICY))

    def pop_faults(self) -> list[PluginFault]:
        return []  # the supervisor has them of the process


def make_competition(rules: CompetitionRules, refuelling: RefuellingRules, end_s: float = math.inf) -> BiddingRule:
    """The competition by likely losses until the session's end, by time, or the paper's by need or control effort."""
    if rules.bids == "losses":
        return LossBidding(rules, refuelling, end_s)
    if rules.bids == "time":
        return TimeBidding(rules, refuelling)
    kind = NeedBidding if rules.bids == "need" else EffortBidding
    return kind(rules, refuelling.hold_s + refuelling.reserve_s)


def make_bidding(scenario: Scenario, own: PluginClient | None) -> tuple[BiddingRule, PolicyCalls | None]:
    """The bidding that a scenario names, or by the user's `own` policy; and the policy in it where it is not the
    competition. Raises ScenarioError."""
    name, rules = scenario.competition.policy, scenario.competition
    policy: PolicyCalls
    if own is not None:
        policy = PluginPolicy(own)
    elif name == WINNER_TAKE_ALL:
        return make_competition(rules, scenario.refuelling, scenario.goal.duration_s), None
    else:
        policy = GuardedPolicy(SHIPPED[name](scenario), Guard(f"policy {name}"))
    end_s = scenario.goal.duration_s
    speed_m_s = {tanker.sysid: tanker.speed_m_s for tanker in scenario.vehicles.tankers}
    bidding = PolicyBidding(rules, scenario.refuelling, speed_m_s, policy, end_s)
    if own is None and name == OPTIMAL:
        bidding.early_ends = EarlyEnds(scenario.refuelling, rules.need_from, end_s)
    return bidding, policy
