"""Selection of the next receiver: bids, dwell time, time limit, urgency (docs/protocol.md#refuelling-schedule).

Needs are the bids. A winner must lead for the dwell time; near ties are cut short by `decide_within_s`; and a vehicle
that would not last until a rendezvous is served before anyone else.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gcs.mavlink.autopilots import STEERABLE
from gcs.refuelling.policies import SHIPPED, WINNER_TAKE_ALL, RefuellingPolicy, RefuellingRequest
from gcs.refuelling.winner_take_all import advance, normalise, revive, share
from gcs.scenario import plugins
from gcs.scenario.guard import Guard, Nonsense
from gcs.scenario.model import CompetitionRules, RefuellingRules, Scenario
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView

# Session times are sums of tick lengths; a dwell time must not slip a tick for their last bits.
_ROUNDING_S = 1e-6


@dataclass(frozen=True)
class CompetitionState:
    """The competition as it stands, by system id: state v, bid τ and need; who leads, and with which share."""

    v: dict[int, float] = field(default_factory=dict)
    tau: dict[int, float] = field(default_factory=dict)
    need: dict[int, float] = field(default_factory=dict)
    leader: int | None = None
    share: float = 0.0


class Bidding:
    """The competition's memory from tick to tick."""

    def __init__(self, rules: CompetitionRules) -> None:
        self._rules = rules
        self._able: list[int] = []
        self._v: dict[int, float] = {}
        self._leading_since_s: float | None = None
        self._begun_s: float | None = None
        self._last_s: float | None = None
        self.competition_state = CompetitionState()

    def advance(self, snapshot: FleetSnapshot, served: Collection[int]) -> None:
        """Let those who compete do so up to the snapshot's time; `served` are those whose turn it is already."""
        now_s, rules = snapshot.time_s, self._rules
        dt_s = now_s - self._last_s if self._last_s is not None else 0.0
        self._last_s = now_s
        self._able = [
            view.sysid for view in snapshot.of_role("pursuer") if view.sysid not in served and is_servable(view)
        ]
        competitors = [view for view in map(snapshot.vehicle, self._able) if view.need >= rules.need_from]
        if not competitors:
            self._v, self._begun_s = {}, None
            self.competition_state = CompetitionState()
            return
        if self._begun_s is None:
            self._begun_s = now_s
        sysids = [view.sysid for view in competitors]
        needs = [view.need for view in competitors]
        tau = normalise(needs, low=rules.floor, high=rules.high)
        v = np.array([self._v.get(sysid, rules.floor) for sysid in sysids])
        v = revive(advance(v, tau, dt_s, p=rules.p, rate=rules.rate), rules.floor)
        leader, held = sysids[int(v.argmax())], share(v, rules.p, rules.floor)
        if leader != self.competition_state.leader or held < rules.share:
            self._leading_since_s = None
        if self._leading_since_s is None and held >= rules.share:
            self._leading_since_s = now_s
        self._v = dict(zip(sysids, map(float, v), strict=True))
        bids = dict(zip(sysids, map(float, tau), strict=True))
        self.competition_state = CompetitionState(
            dict(self._v), bids, dict(zip(sysids, needs, strict=True)), leader, held
        )

    def winner(
        self,
        snapshot: FleetSnapshot,
        tanker: VehicleView,
        speed_m_s: float,
        reserve_s: float,
        free: Sequence[VehicleView] = (),
    ) -> tuple[int, str] | None:
        """System id that a free tanker serves next, and by what: `urgency`, `competition` or `timeout`; None while
        undecided.

        `free` are the tankers that have not been given anyone yet, for those who plan for several at once.
        """
        return self.winner_at([tanker.p_now_ned()], snapshot, speed_m_s, reserve_s)

    def winner_at(
        self, places: Sequence[Vec3], snapshot: FleetSnapshot, speed_m_s: float, reserve_s: float
    ) -> tuple[int, str] | None:
        """The same where givers are at some places; urgent is who would not last until the nearest."""
        competition_state, rules, now_s = self.competition_state, self._rules, snapshot.time_s
        urgent = urgent_of(snapshot, self._able, places, speed_m_s, reserve_s)
        if urgent is not None:
            return urgent, "urgency"
        if not competition_state.v:
            return None
        since_s = self._leading_since_s
        if (
            competition_state.leader is not None
            and since_s is not None
            and now_s - since_s >= rules.dwell_s - _ROUNDING_S
        ):
            return competition_state.leader, "competition"
        if self._begun_s is not None and now_s - self._begun_s >= rules.decide_within_s:
            return max(competition_state.v, key=lambda sysid: (competition_state.v[sysid], -sysid)), "timeout"
        return None

    def award(self, sysid: int, now_s: float) -> None:
        """The winner leaves; the others go on, and the next decision takes its own time."""
        self._v.pop(sysid, None)
        self._able.remove(sysid)
        left = {key: value for key, value in self.competition_state.v.items() if key != sysid}
        self.competition_state = CompetitionState(
            left, self.competition_state.tau, self.competition_state.need, None, 0.0
        )
        self._leading_since_s = None
        self._begun_s = now_s if left else None


def most_urgent(
    snapshot: FleetSnapshot, able: Iterable[int], tanker: VehicleView, speed_m_s: float, reserve_s: float
) -> int | None:
    """The first to run empty of those who would not last until a rendezvous and `reserve_s` after it."""
    return urgent_of(snapshot, able, [tanker.p_now_ned()], speed_m_s, reserve_s)


def urgent_of(
    snapshot: FleetSnapshot, able: Iterable[int], places: Sequence[Vec3], speed_m_s: float, reserve_s: float
) -> int | None:
    """The same for the nearest of several places; common NED frame, m."""
    urgent = []
    for sysid in able:
        view = snapshot.vehicle(sysid)
        way_m = min((math.dist(place, view.p_now_ned()) for place in places), default=math.inf)
        if view.endurance_s < way_m / speed_m_s + reserve_s:
            urgent.append((view.endurance_s, sysid))
    return min(urgent)[1] if urgent else None


def is_servable(view: VehicleView) -> bool:
    """Only vehicles that can receive compete, or are served."""
    return view.flying and view.fresh and view.mode in STEERABLE


class PolicyBidding(Bidding):
    """Asks a policy for each free tanker; a tanker without a good answer waits where it is."""

    def __init__(
        self,
        rules: CompetitionRules,
        refuelling: RefuellingRules,
        speed_m_s: Mapping[int, float],
        policy: RefuellingPolicy,
        guard: Guard,
    ) -> None:
        super().__init__(rules)
        self._refuelling = refuelling
        self._speed_m_s = speed_m_s
        self._policy = policy
        self._guard = guard
        self._wanting: tuple[VehicleView, ...] = ()

    def advance(self, snapshot: FleetSnapshot, served: Collection[int]) -> None:
        """Find vehicles that may be served at the snapshot's time; nothing competes, so that bids are needs and v is
        empty."""
        self._guard.begin_tick()
        able = [view for view in snapshot.of_role("pursuer") if view.sysid not in served and is_servable(view)]
        self._able = [view.sysid for view in able]
        self._wanting = tuple(view for view in able if view.need >= self._rules.need_from)
        need = {view.sysid: view.need for view in self._wanting}
        bids = normalise(list(need.values()), low=self._rules.floor, high=self._rules.high) if need else ()
        self.competition_state = CompetitionState({}, dict(zip(need, map(float, bids), strict=True)), need, None, 0.0)

    def winner(
        self,
        snapshot: FleetSnapshot,
        tanker: VehicleView,
        speed_m_s: float,
        reserve_s: float,
        free: Sequence[VehicleView] = (),
    ) -> tuple[int, str] | None:
        """System id that a free tanker serves next, and by what: `urgency` or `policy`; None where the policy names
        none."""
        urgent = most_urgent(snapshot, self._able, tanker, speed_m_s, reserve_s)
        if urgent is not None:
            return urgent, "urgency"
        if not self._wanting:
            return None
        others = tuple(view for view in free if view.sysid != tanker.sysid)
        request = RefuellingRequest(
            snapshot.time_s, tanker, self._wanting, (tanker, *others), self._speed_m_s, self._refuelling
        )
        answer = self._guard.call(tanker.sysid, lambda: self._checked(self._policy.choose(request)))
        return None if answer is None or answer.value is None else (answer.value, "policy")

    def award(self, sysid: int, now_s: float) -> None:
        """The vehicle chosen is no candidate any more."""
        self._able.remove(sysid)
        self._wanting = tuple(view for view in self._wanting if view.sysid != sysid)
        self.competition_state = CompetitionState(
            {}, self.competition_state.tau, self.competition_state.need, None, 0.0
        )

    def _checked(self, answer: Any) -> int | None:
        """The answer as a system id or None. Raises Nonsense."""
        if answer is None:
            return None
        for view in self._wanting:
            if answer == view.sysid:
                return view.sysid
        shown = "NaN" if answer != answer else " ".join(repr(answer).split())[:60]  # noqa: PLR0124 - NaN alone differs
        raise Nonsense(f"returned {shown}, which is no candidate's system id")


def make_bidding(scenario: Scenario) -> tuple[Bidding, Guard | None]:
    """The contest that a scenario names, and what guards it where it is not the competition. Raises ScenarioError."""
    name, rules = scenario.competition.policy, scenario.competition
    if name == WINNER_TAKE_ALL:
        return Bidding(rules), None
    policy: RefuellingPolicy
    if name in SHIPPED:
        policy = SHIPPED[name](scenario)
    else:
        policy = plugins.make("competition.policy", name, "choose", scenario)
    speed_m_s = {tanker.sysid: tanker.speed_m_s for tanker in scenario.vehicles.tankers}
    guard = Guard(f"policy {name}")
    return PolicyBidding(rules, scenario.refuelling, speed_m_s, policy, guard), guard
