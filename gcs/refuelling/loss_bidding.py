"""The competition with bids that see ahead: what is likely to be lost if another vehicle is served first
(docs/model/competition.md#likely-losses) [choice].

All services of all givers are planned (skytender/rolling_horizon.py). A vehicle's gain is what the best plan costs in
which the givers that are free first do not set off to it, less what the best costs in which one does. The law decides
among these bids as among any others, and several win at once as in the competition by time.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from gcs.refuelling.early_ends import EarlyEnds
from gcs.refuelling.giver import Giver
from gcs.refuelling.service_plan import plan_services
from gcs.refuelling.time_bidding import TimeBidding
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import VehicleView
from skytender.service_plan import AGAIN_S, below_greatest, gain_of

TIE = 0.01
"""[choice] Smaller differences of gains count for nothing: 1 % of the probability that all vehicles are kept."""
_MOST_GAIN = 1e3


class _Situation(NamedTuple):
    """Competitors and givers that a plan was made for, and vehicles with a known draw."""

    competitors: frozenset[int]
    draws: frozenset[int]
    free: frozenset[int | str]
    busy: frozenset[int | str]


class LossBidding(TimeBidding):
    """The competition's memory from tick to tick."""

    def __init__(self, rules: CompetitionRules, refuelling: RefuellingRules, end_s: float) -> None:
        """`end_s`: session time at which the session ends."""
        super().__init__(rules, refuelling)
        self.early_ends = EarlyEnds(refuelling, rules.need_from, end_s)
        self._end_s = end_s
        self._planned_for: _Situation | None = None
        self._planned_s = -math.inf

    def _bids_s(
        self, now_s: float, competitors: Sequence[VehicleView], able: Sequence[VehicleView], givers: Sequence[Giver]
    ) -> dict[int, float]:
        situation = _Situation(
            frozenset(view.sysid for view in competitors),
            frozenset(view.sysid for view in able if view.power_w > 0.0),
            frozenset(giver.name for giver in givers if giver.free_in_s == 0.0),
            frozenset(giver.name for giver in givers if giver.free_in_s > 0.0),
        )
        if situation != self._planned_for or now_s - self._planned_s >= AGAIN_S:
            self._planned_for, self._planned_s = situation, now_s
            self.gain = self._gains(now_s, situation.competitors, able, givers)
        return {view.sysid: self._rules.horizon_s * below_greatest(self.gain[view.sysid]) for view in competitors}

    def _gains(
        self, now_s: float, competitors: frozenset[int], able: Sequence[VehicleView], givers: Sequence[Giver]
    ) -> dict[int, float]:
        """0 for all where there is no giver."""
        if not givers:
            return dict.fromkeys(competitors, 0.0)
        assert self._times is not None
        need_from, left_s = self._rules.need_from, max(self._end_s - now_s, 0.0)
        best = plan_services(
            able, competitors, givers, self._times, self._refuelling, need_from=need_from, left_s=left_s
        )
        costs = zip(able, best.served_cost.tolist(), best.passed_over_cost.tolist(), strict=True)
        return {view.sysid: gain_of(*cost) for view, *cost in costs if view.sysid in competitors}

    def _rank(self, view: VehicleView) -> tuple[float, ...]:
        """The greatest gain first. Gains are equal to `TIE`; then the least time left, the greatest need and the lowest
        system id decide."""
        gain = round(min(max(self.gain[view.sysid], -_MOST_GAIN), _MOST_GAIN) / TIE)
        return -gain, self.slack_s[view.sysid], -view.need, view.sysid

    def _in_time(self, giver: Giver, view: VehicleView) -> bool:
        """True: the plan has weighed how likely that is."""
        return True
