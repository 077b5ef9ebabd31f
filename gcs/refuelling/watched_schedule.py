"""Schedule of vehicles that compete on board: watched by what they report, not decided here
(docs/protocol/onboard.md#competition-on-board).

Reports in, the same records come out as of a schedule that decides. What was missed while the radio was dead is learnt
afterwards: each tanker reports all of its services again and again.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from gcs.refuelling.bidding import CompetitionState
from gcs.refuelling.giver import WORTH_J
from gcs.refuelling.scheduler import Scheduler
from gcs.refuelling.service import Decision, Phase, Service
from gcs.scenario.model import CompetitionRules
from gcs.telemetry.state import STALE_S, FleetSnapshot
from skytender import elementary
from skytender.k_winners import share_of

PEER, SERVICE = "Peer", "Service"
COMPETES, CALLS, FREE = 1, 2, 5
"""Stages of a peer's report."""
_STAGE, _PARTNER, _REMAINING, _CAPACITY, _BID, _LN_V = 0, 1, 9, 10, 12, 15
"""Places in a peer's report."""
BY = {1: "competition", 2: "unopposed", 3: "urgency", 4: "timeout"}
MOST_SERVICES = 10_000


class _PeerRow(NamedTuple):
    row: tuple[float, ...]
    at_s: float


class _ServiceRow(NamedTuple):
    """A tanker's report of one of its services; times in s, negative while they are not known."""

    receiver: int
    by: int
    decided_s: float
    start_s: float
    end_s: float
    energy_j: float
    ending: int


class WatchedSchedule(Scheduler):
    """Stands where a schedule that decides would stand; its decisions are the vehicles' own."""

    _peers: dict[int, _PeerRow]
    _rows: dict[tuple[int, int], _ServiceRow]
    _known: dict[tuple[int, int], Service]
    _competition: CompetitionRules
    _watched = CompetitionState()

    def watch(self, competition: CompetitionRules, pursuers: frozenset[int]) -> None:
        """Begin: the rules of the competition, and the vehicles that compete."""
        self._competition, self._pursuers = competition, pursuers
        self._bidding = self._base_bidding = None
        self._peers, self._rows, self._known = {}, {}, {}

    def receive(self, sysid: int, content: Any, now_s: float) -> None:
        """Take in a vehicle's DEBUG_FLOAT_ARRAY; one that cannot be is passed over."""
        row = tuple(content.data)
        if not all(map(math.isfinite, row)):
            return
        if content.name == PEER and (sysid in self._pursuers or sysid in self._tankers):
            self._peers[sysid] = _PeerRow(row, now_s)
        elif content.name == SERVICE and sysid in self._tankers and 1 <= content.array_id <= MOST_SERVICES:
            receiver, by = int(row[0]), int(row[1])
            if receiver in self._pursuers and by in BY:
                numbers = row[2], row[3], row[4], row[5]
                self._rows[sysid, content.array_id] = _ServiceRow(receiver, by, *numbers, int(row[6]))

    @property
    def competition_states(self) -> tuple[CompetitionState, CompetitionState]:
        """The competition as the vehicles' reports show it; there is none for bases."""
        return self._watched, CompetitionState()

    def settle(self, snapshot: FleetSnapshot) -> None:
        """Book on the newest services what their tankers report as given and their receivers have not counted, and on
        one under way what its receiver has counted since its tanker's last report."""
        for receiver in sorted({service.receiver for service in self.services}):
            own = [service for service in self.services if service.receiver == receiver]
            missing_j = sum(service.energy_j for service in own) - snapshot.vehicle(receiver).received_j
            if missing_j < 0 and own[-1].phase is Phase.TRANSFER:
                own[-1].energy_j -= missing_j
            for service in reversed(own):
                taken_j = min(max(missing_j, 0), service.energy_j)
                service.energy_j -= taken_j
                missing_j -= taken_j

    def bound(self, sysid: int) -> bool:
        """The vehicles break their services off themselves."""
        return False

    def decide(self, snapshot: FleetSnapshot) -> Decision:
        """Decisions of the vehicles, as far as it is known at the snapshot's time."""
        now_s = snapshot.time_s
        dt_s = 0.0 if self._last_s is None else now_s - self._last_s
        self._last_s = now_s
        self._requests.clear()
        fresh = {sysid: peer.row for sysid, peer in sorted(self._peers.items()) if now_s - peer.at_s <= STALE_S}
        self._watched = self._state(fresh)
        for key, row in sorted(self._rows.items()):
            self._follow(key, row, snapshot)
        self._rows = {}
        self.tanker_idle_s += dt_s * self._idle(fresh)
        pairs = {service.tanker: service.receiver for service in self.open_services if service.tanker is not None}
        return Decision(rendezvous=pairs, records=tuple(self._requests.records))

    def _state(self, fresh: dict[int, tuple[float, ...]]) -> CompetitionState:
        """The competition by each competitor's own report of itself."""
        rules = self._competition
        rows = {s: row for s, row in fresh.items() if row[_STAGE] == COMPETES and row[_CAPACITY] > 0.0}
        if not rows:
            return CompetitionState()
        v = {sysid: elementary.exp(min(max(row[_LN_V], -700.0), 0.0)) for sysid, row in rows.items()}
        above = {sysid: 1.0 - min(max(row[_BID] / rules.horizon_s, 0.0), 1.0) for sysid, row in rows.items()}
        tau = {sysid: rules.floor * (1.0 - a) + rules.high * a for sysid, a in above.items()}
        need = {sysid: 1.0 - row[_REMAINING] / row[_CAPACITY] for sysid, row in rows.items()}
        order = sorted(v, key=lambda sysid: (-v[sysid], sysid))
        held = 1.0
        if len(order) > 1:
            held = share_of(elementary.log(v[order[0]]) - elementary.log(v[order[1]]), rules.p)
        return CompetitionState(v, tau, need, order[0], held)

    def _idle(self, fresh: dict[int, tuple[float, ...]]) -> int:
        """How many tankers are free although a vehicle waits for each."""
        called = {int(row[_PARTNER]) for sysid, row in fresh.items() if sysid not in self._tankers}
        free = sum(
            fresh[sysid][_STAGE] == FREE and sysid not in called and fresh[sysid][_REMAINING] >= WORTH_J
            for sysid in self._tankers
            if sysid in fresh
        )
        waiting = sum(need >= self._need_from for need in self._watched.need.values())
        return min(free, waiting)

    def _follow(self, key: tuple[int, int], row: _ServiceRow, snapshot: FleetSnapshot) -> None:
        """Bring one service to what its tanker reports."""
        service = self._known.get(key)
        if service is None:
            service = self._known[key] = self._decide(
                self._watched, snapshot.vehicle(row.receiver), key[0], BY[row.by], snapshot.time_s
            )
            service.decided_at_s = _s(row.decided_s) or 0.0
            self.services.sort(key=lambda one: (one.decided_at_s, one.number))  # it may be known late
            self._record_decision(service, self._watched)
        if service.phase is Phase.DONE:
            return
        service.energy_j = max(int(row.energy_j), service.energy_j)
        if service.start_s is None and row.start_s >= 0.0:
            service.start_s = service.joined_at_s = _s(row.start_s)
            service.phase = Phase.TRANSFER
            self._requests.records.append({"kind": "transfer", **service.sides})
        if row.ending and row.end_s >= 0.0:
            service.phase, service.end_s = Phase.DONE, _s(row.end_s)
            service.ended_by = "served" if service.energy_j > 0 else "no energy was given"
            self._requests.records.append({"kind": "served", "reason": service.ended_by, **service.record()})


def _s(value: float) -> float | None:
    """A time to the millisecond, as 32 bits tell it."""
    return round(value, 3) if value >= 0.0 else None
