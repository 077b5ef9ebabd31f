"""Session state for the panels, from its messages: newest snapshot, trails, competition history, events."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from gcs.scenario.colours import DARK
from gcs.session.client import Message
from gcs.session.plain_text import clean, unnamed

EVENTS = 5000
TRAIL_EVERY_S, TRAIL_LENGTH = 0.5, 120
CONTEST_EVERY_S, STATES_LENGTH = 0.2, 600
NO_MESSAGE: Message = {}

Vehicle = Mapping[str, Any]


class SessionModel:
    """A session as seen through its messages. Whatever is missing from them reads as unknown."""

    def __init__(self) -> None:
        self.session: Message = NO_MESSAGE
        self.snapshot: Message = NO_MESSAGE
        self.vehicles: dict[int, Vehicle] = {}
        self.known: dict[int, Mapping[str, Any]] = {}
        """what the session message says of each vehicle: capacity, path"""
        self.trails: dict[int, deque[tuple[float, float]]] = {}
        """(north, east) in m, oldest first"""
        self.competition_states: deque[tuple[float, Mapping[str, float]]] = deque(maxlen=STATES_LENGTH)
        """(session time, {sysid as text: v_i}), oldest first"""
        self.handovers: deque[tuple[float, str]] = deque(maxlen=50)
        self.events: deque[Mapping[str, Any]] = deque(maxlen=EVENTS)
        self.event_count = 0
        """events so far, those forgotten included"""
        self.replies: list[Message] = []
        self.end: Message | None = None
        self._trailed_s = self._contested_s = float("-inf")

    def update(self, messages: Iterable[Message]) -> bool:
        """Take in messages; whether anything is new."""
        changed = False
        for message in messages:
            kind = message.get("type")
            changed = True
            if kind == "snapshot":
                self._update_snapshot(message)
            elif kind == "session":
                self.session = message
                self._recall(message.get("contest") or ())
                self.known = {v["sysid"]: v for v in message.get("vehicles") or () if "sysid" in v}
            elif kind == "reply":
                self.replies.append(message)
            elif kind == "end":
                self.end = message
        return changed

    def _update_snapshot(self, snapshot: Message) -> None:
        t_s = float(snapshot.get("t_s") or 0.0)
        if t_s < self.t_s:
            self._go_back(t_s)
        self.snapshot = snapshot
        self.vehicles = {v["sysid"]: v for v in snapshot.get("vehicles") or () if "sysid" in v}
        events = snapshot.get("events") or ()
        self.events.extend(events)
        self.event_count += len(events)
        for event in events:
            if event.get("kind") == "decision" and "decided" in str(event.get("text")):
                self.handovers.append((float(event.get("t_s") or t_s), str(event.get("sysid"))))
        if t_s - self._trailed_s >= TRAIL_EVERY_S:
            self._trailed_s = t_s
            for sysid, vehicle in self.vehicles.items():
                if (p_ned := vehicle.get("p_ned")) is not None:
                    trail = self.trails.setdefault(sysid, deque(maxlen=TRAIL_LENGTH))
                    trail.append((p_ned[0], p_ned[1]))
        if t_s - self._contested_s >= CONTEST_EVERY_S and (v := self.competition.get("v")):
            self._contested_s = t_s
            self.competition_states.append((t_s, dict(v)))

    def _recall(self, past: Sequence[tuple[float, Mapping[str, float]]]) -> None:
        """Put what was there before this console among the competition's states."""
        if past:
            before = [one for one in self.competition_states if one[0] < past[0][0]]
            after = [one for one in self.competition_states if one[0] > past[-1][0]]
            self.competition_states = deque(
                [*before, *((float(t_s), v) for t_s, v in past), *after], maxlen=STATES_LENGTH
            )

    def _go_back(self, t_s: float) -> None:
        """A replay has gone back to `t_s`: what came later has not happened."""
        self.trails.clear()
        self._trailed_s = self._contested_s = float("-inf")
        while self.competition_states and self.competition_states[-1][0] > t_s:
            self.competition_states.pop()
        while self.handovers and self.handovers[-1][0] > t_s:
            self.handovers.pop()
        while self.events and float(self.events[-1].get("t_s") or 0.0) > t_s:
            self.events.pop()
        self.event_count = len(self.events)

    def style(self, sysid: int) -> str:
        """The style of a vehicle's colour, the same in map, curves and table, and on the page: targets have the ink."""
        known = self.known.get(sysid, {})
        if known.get("role") == "target":
            return "target"
        return f"vehicle{int(known.get('colour', sysid - 1)) % len(DARK)}"

    @property
    def t_s(self) -> float:
        """Session time."""
        return float(self.snapshot.get("t_s") or 0.0)

    @property
    def phase(self) -> str:
        """`starting`, `flying`, `paused` or `ended`; `monitoring` where vehicles at an address are watched."""
        return clean(self.snapshot.get("phase") or "starting")

    @property
    def control(self) -> bool:
        """Whether the other end takes an operator's commands."""
        return bool(self.session.get("control", not self.replay))

    @property
    def monitors(self) -> bool:
        """Whether the vehicles at an address are watched (`gcs monitor --connect`), whichever station flies them."""
        return bool(self.session.get("source") == "monitor")

    @property
    def replay(self) -> Mapping[str, Any] | None:
        """Progress of a replay; None for a live session."""
        return self.snapshot.get("replay")

    @property
    def competition(self) -> Mapping[str, Any]:
        """v_i, bids, leader and share; from the vehicles themselves where the snapshot has no summary."""
        if given := self.snapshot.get("competition"):
            return dict(given)
        vehicles = self.vehicles.values()
        found = {key: {str(v["sysid"]): v[key] for v in vehicles if v.get(key) is not None} for key in ("v", "tau")}
        return found if found["v"] else {}

    def giver(self, service: Mapping[str, Any]) -> str:
        """Giver of a service: `tanker 201`, or `base pad`."""
        base = service.get("base")
        return self.name(service.get("tanker")) if base is None else f"base {clean(base)}"

    def name(self, sysid: object) -> str:
        """`pursuer 5`; the session's own events carry no vehicle's id."""
        try:
            number = int(str(sysid))
        except ValueError:
            return "session"
        vehicle = self.vehicles.get(number) or self.known.get(number)
        if vehicle is not None:
            return clean(vehicle.get("label") or f"vehicle {number}")
        return unnamed(number)


def severity(vehicle: Vehicle) -> int:
    """0 well, 1 look, 2 act."""
    given = vehicle.get("severity")
    return (0 if vehicle.get("alive", True) else 2) if given is None else int(given)


def issues(vehicle: Vehicle) -> list[str]:
    """Health issues of a vehicle, worst first."""
    given = [clean(word) for word in vehicle.get("trouble") or ()]
    return given if given or vehicle.get("alive", True) else ["dead"]


def battery_share(vehicle: Vehicle) -> float | None:
    """0..1, or None where unknown."""
    share = vehicle.get("battery")
    return None if share is None else float(share)


def ordered(vehicles: Iterable[Vehicle], by: str) -> list[Vehicle]:
    """The worst health first; equally healthy vehicles by `id`, `battery` or `competition`."""

    def key(vehicle: Vehicle) -> tuple[int, float, int]:
        second = 0.0
        if by == "battery":
            share = battery_share(vehicle)
            second = 2.0 if share is None else share
        elif by == "competition":
            second = -float(vehicle.get("v") or 0.0)
        return -severity(vehicle), second, vehicle["sysid"]

    return sorted(vehicles, key=key)


def margin(competition: Mapping[str, Any]) -> float | None:
    """The leader's share less what is needed to win; above 0 the leader wins when the dwell time is over."""
    share = competition.get("share")
    return None if share is None else float(share) - float(competition.get("threshold") or 0.9)
