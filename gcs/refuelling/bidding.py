"""The paper's competition, by need and for one winner after another: bids, dwell time, time limit, urgency
(docs/protocol/energy.md#bids-by-need).

Needs are the bids, or what a kind of this competition puts in their place (`EffortBidding`). A winner must lead for the
dwell time; near ties are cut short by `decide_within_s`; and a vehicle that would not last until a rendezvous is served
before anyone else.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

import numpy as np

from gcs.mavlink.autopilots import STEERABLE
from gcs.refuelling.early_ends import EarlyEnds
from gcs.refuelling.giver import Giver, ServiceTimes
from gcs.scenario.model import CompetitionRules
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView
from skytender import elementary
from skytender.winner_take_all import advance, normalise, revive, share

# Session times are sums of tick lengths; a dwell time must not slip a tick for their last bits.
_ROUNDING_S = 1e-6


@dataclass(frozen=True)
class CompetitionState:
    """The competition as it stands, by system id: state v, bid τ and need; the leader and its share; and with bids by
    losses what each gains (docs/model/competition.md#likely-losses)."""

    v: dict[int, float] = field(default_factory=dict)
    tau: dict[int, float] = field(default_factory=dict)
    need: dict[int, float] = field(default_factory=dict)
    leader: int | None = None
    share: float = 0.0
    gain: dict[int, float] = field(default_factory=dict)

    def without(self, sysid: int) -> CompetitionState:
        """The competition once this one has been given a giver: none leads."""
        v = {key: value for key, value in self.v.items() if key != sysid}
        return CompetitionState(v, self.tau, self.need, gain=self.gain)


NO_COMPETITION = CompetitionState()
"""While no vehicle competes."""


class Award(NamedTuple):
    """A giver has its next receiver."""

    giver: Giver
    receiver: int
    """system id"""
    by: str
    """`competition`, `unopposed`, `urgency`, `timeout`, `policy` or `operator`"""


class BiddingRule(Protocol):
    """Rule by which free givers choose their receivers."""

    competition_state: CompetitionState
    waits_for_all: bool
    """whether nothing is to be decided before every vehicle received can be served, at a session's start"""
    early_ends: EarlyEnds | None = None
    """what ends transfers before their receivers are full; None: nothing does"""

    def advance(
        self, snapshot: FleetSnapshot, served: Collection[int], givers: Sequence[Giver], times: ServiceTimes
    ) -> None:
        """Move on to the snapshot's time; `served` are vehicles that take no part, `givers` all that there are, busy
        ones too."""

    def awards(self, snapshot: FleetSnapshot, free: Sequence[Giver]) -> Iterable[Award]:
        """The next services of free givers; `award` is called with each before the next is asked for."""

    def approaches(self, snapshot: FleetSnapshot, free: Sequence[Giver]) -> dict[int, int]:
        """Receiver by tanker, of free tankers that fly towards a vehicle while nothing is decided: usually none."""
        return {}

    def award(self, sysid: int, now_s: float) -> None:
        """This one has been given a giver."""


class NeedBidding(BiddingRule):
    """The competition's memory from tick to tick."""

    waits_for_all = False

    def __init__(self, rules: CompetitionRules, reserve_s: float = 0.0) -> None:
        """`reserve_s`: a vehicle that would not last so long after a rendezvous is urgent."""
        self._rules = rules
        self._reserve_s = reserve_s
        self._able: list[int] = []
        self._v: dict[int, float] = {}
        self._leading_since_s: float | None = None
        self._begun_s: float | None = None
        self._last_s: float | None = None
        self.competition_state = CompetitionState()

    def advance(
        self, snapshot: FleetSnapshot, served: Collection[int], givers: Sequence[Giver] = (), times: object = None
    ) -> None:
        """Advance the competition to the snapshot's time; `served` are vehicles that are being served already."""
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
        tau = normalise(self._wants(competitors), low=rules.floor, high=rules.high)
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

    def _wants(self, competitors: Sequence[VehicleView]) -> Sequence[float]:
        """The numbers that compete, of each in turn; the greatest wins."""
        return [view.need for view in competitors]

    def awards(self, snapshot: FleetSnapshot, free: Sequence[Giver]) -> Iterator[Award]:
        """One for each free tanker in turn; of several bases the one that is nearest to the winner."""
        for giver in (one for one in free if one.is_tanker):
            won = self.winner_at([giver.p_ned], snapshot, giver.speed_m_s, self._reserve_s)
            if won is not None:
                yield Award(giver, *won)
        bases = [giver for giver in free if not giver.is_tanker]
        while bases:
            won = self.winner_at([base.p_ned for base in bases], snapshot, bases[0].speed_m_s, self._reserve_s)
            if won is None:
                return
            place = snapshot.vehicle(won[0]).p_now_ned()
            base = min(bases, key=lambda one: elementary.distance(one.p_ned, place))
            bases.remove(base)
            yield Award(base, *won)

    def winner_at(
        self, places: Sequence[Vec3], snapshot: FleetSnapshot, speed_m_s: float, reserve_s: float
    ) -> tuple[int, str] | None:
        """Next receiver of free givers at some places, and by what: `urgency`, `competition` or `timeout`; None while
        undecided. A vehicle is urgent if it would not last until the nearest."""
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
        self.competition_state = self.competition_state.without(sysid)
        self._leading_since_s = None
        self._begun_s = now_s if self.competition_state.v else None


class EffortBidding(NeedBidding):
    """The competition by control energy (paper, Example 4; docs/protocol/energy.md#bids-by-effort): as by need, with
    the control effort that each has reported since its last joule came in place of the needs.

    That the most energy wins, and that it is counted anew after a while, is the paper's; its definition and what it is
    counted from are a [choice].
    """

    def __init__(self, rules: CompetitionRules, reserve_s: float = 0.0) -> None:
        """As `NeedBidding`."""
        super().__init__(rules, reserve_s)
        self._counted_from: dict[int, float] = {}
        self._received_j: dict[int, float] = {}

    def advance(
        self, snapshot: FleetSnapshot, served: Collection[int], givers: Sequence[Giver] = (), times: object = None
    ) -> None:
        """As `NeedBidding`, once vehicles that have received energy since the last tick count from zero again."""
        for view in snapshot.of_role("pursuer"):
            if view.received_j != self._received_j.get(view.sysid, 0):
                self._received_j[view.sysid] = view.received_j
                self._counted_from[view.sysid] = view.effort_now
        super().advance(snapshot, served, givers, times)

    def _wants(self, competitors: Sequence[VehicleView]) -> Sequence[float]:
        return [view.effort_now - self._counted_from.get(view.sysid, 0.0) for view in competitors]


def urgent_of(
    snapshot: FleetSnapshot, able: Iterable[int], places: Sequence[Vec3], speed_m_s: float, reserve_s: float
) -> int | None:
    """The first to run empty of the vehicles that would not last until the nearest place and `reserve_s` after it;
    common NED frame, m."""
    urgent = []
    for sysid in able:
        view = snapshot.vehicle(sysid)
        way_m = min((elementary.distance(place, view.p_now_ned()) for place in places), default=math.inf)
        if view.endurance_s < way_m / speed_m_s + reserve_s:
            urgent.append((view.endurance_s, sysid))
    return min(urgent)[1] if urgent else None


def is_servable(view: VehicleView) -> bool:
    """Only vehicles that can receive compete, or are served."""
    return view.flying and view.fresh and view.mode in STEERABLE
