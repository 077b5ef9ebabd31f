"""A refuelling policy in the place of the competition: the same candidates, the same urgency, the same records."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from gcs.competition import normalise
from gcs.contest import Contest, Standing, can_receive, most_urgent
from gcs.policies import SHIPPED, WINNER_TAKE_ALL, RefuellingPolicy, Request
from gcs.scenario import plugins
from gcs.scenario.guard import Guard, Nonsense
from gcs.scenario.model import Competition, Refuelling, Scenario
from gcs.telemetry.state import Snapshot, VehicleView


class PolicyContest(Contest):
    """Asks a policy for each free tanker; a tanker without a good answer waits where it is."""

    def __init__(
        self,
        rules: Competition,
        refuelling: Refuelling,
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

    def advance(self, snapshot: Snapshot, served: Collection[int]) -> None:
        """Who may be served at the snapshot's time; nothing competes, so that bids are needs and v is empty."""
        self._guard.begin_tick()
        able = [view for view in snapshot.of_role("pursuer") if view.sysid not in served and can_receive(view)]
        self._able = [view.sysid for view in able]
        self._wanting = tuple(view for view in able if view.need >= self._rules.need_from)
        need = {view.sysid: view.need for view in self._wanting}
        bids = normalise(list(need.values()), low=self._rules.floor, high=self._rules.high) if need else ()
        self.standing = Standing({}, dict(zip(need, map(float, bids), strict=True)), need, None, 0.0)

    def winner(
        self,
        snapshot: Snapshot,
        tanker: VehicleView,
        speed_m_s: float,
        reserve_s: float,
        free: Sequence[VehicleView] = (),
    ) -> tuple[int, str] | None:
        """Who a free tanker serves next, and by what: `urgency` or `policy`; None where the policy names nobody."""
        urgent = most_urgent(snapshot, self._able, tanker, speed_m_s, reserve_s)
        if urgent is not None:
            return urgent, "urgency"
        if not self._wanting:
            return None
        others = tuple(view for view in free if view.sysid != tanker.sysid)
        request = Request(snapshot.time_s, tanker, self._wanting, (tanker, *others), self._speed_m_s, self._refuelling)
        answer = self._guard.call(tanker.sysid, lambda: self._checked(self._policy.choose(request)))
        return None if answer is None or answer.value is None else (answer.value, "policy")

    def award(self, sysid: int, now_s: float) -> None:
        """The one chosen is nobody else's any more."""
        self._able.remove(sysid)
        self._wanting = tuple(view for view in self._wanting if view.sysid != sysid)
        self.standing = Standing({}, self.standing.tau, self.standing.need, None, 0.0)

    def _checked(self, answer: Any) -> int | None:
        """The answer as a system id or None. Raises Nonsense."""
        if answer is None:
            return None
        for view in self._wanting:
            if answer == view.sysid:
                return view.sysid
        told = "NaN" if answer != answer else " ".join(repr(answer).split())[:60]  # noqa: PLR0124 - NaN alone differs
        raise Nonsense(f"returned {told}, which is no candidate's system id")


def make_contest(scenario: Scenario) -> tuple[Contest, Guard | None]:
    """The contest that a scenario names, and what guards it where it is not the competition. Raises ScenarioError."""
    name, rules = scenario.competition.policy, scenario.competition
    if name == WINNER_TAKE_ALL:
        return Contest(rules), None
    policy: RefuellingPolicy
    if name in SHIPPED:
        policy = SHIPPED[name](scenario)
    else:
        policy = plugins.make("competition.policy", name, "choose", scenario)
    speed_m_s = {tanker.sysid: tanker.speed_m_s for tanker in scenario.vehicles.tankers}
    guard = Guard(f"policy {name}")
    return PolicyContest(rules, scenario.refuelling, speed_m_s, policy, guard), guard
