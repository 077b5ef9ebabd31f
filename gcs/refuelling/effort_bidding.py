"""The paper's competition by control energy, Example 4: who has used most since energy last reached it is refuelled
(docs/protocol.md#bids-by-effort).

That the most energy wins, and that it is counted anew after a while, is the paper's; its definition and what it is
counted from are a [choice].
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from gcs.refuelling.bidding import NeedBidding
from gcs.refuelling.giver import Giver
from gcs.scenario.model import CompetitionRules
from gcs.telemetry.state import FleetSnapshot, VehicleView


class EffortBidding(NeedBidding):
    """As by need, with the control effort that each has reported since its last joule came in place of the needs."""

    def __init__(self, rules: CompetitionRules, reserve_s: float = 0.0) -> None:
        """As `NeedBidding`."""
        super().__init__(rules, reserve_s)
        self._counted_from: dict[int, float] = {}
        self._received_j: dict[int, float] = {}

    def advance(
        self, snapshot: FleetSnapshot, served: Collection[int], givers: Sequence[Giver] = (), times: object = None
    ) -> None:
        """As `NeedBidding`, once whoever has received energy since the last tick counts from zero again."""
        for view in snapshot.of_role("pursuer"):
            if view.received_j != self._received_j.get(view.sysid, 0):
                self._received_j[view.sysid] = view.received_j
                self._counted_from[view.sysid] = view.effort_now
        super().advance(snapshot, served, givers, times)

    def _wants(self, competitors: Sequence[VehicleView]) -> Sequence[float]:
        return [view.effort_now - self._counted_from.get(view.sysid, 0.0) for view in competitors]
