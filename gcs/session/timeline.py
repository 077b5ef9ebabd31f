"""A recorded session's decisions, at any time of it: vehicles that compete, which services are under way, and why.

From decisions.jsonl and the scenario alone. The set points, nearly all of the file, are passed over: the recorded
frames show them too.
"""

from __future__ import annotations

import bisect
import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from gcs.mavlink.autopilots import STEERABLE, End, FlightMode
from gcs.recording import rotation, series
from gcs.recording.decisions_reader import DecisionLine, DecisionLines
from gcs.recording.missing import NO_REASON
from gcs.recording.session_folder import Recorded
from gcs.recording.summary import GoalPartSummary, Summary
from gcs.recording.tick_record import event_of, is_event
from gcs.refuelling import explain
from gcs.refuelling.bidding import CompetitionState
from gcs.refuelling.participation import RELEASED, Participation
from gcs.refuelling.service import Phase, Service
from gcs.scenario.goal import Loss, Measured, is_refuelling, judge
from gcs.scenario.model import Scenario
from gcs.scenario.parts.world import WORLD, Worlds
from gcs.session import messages
from gcs.session.message_types import BrokenRow, CompetitionRow, ServedRow, SnapshotMessage
from gcs.supervisor.operator import ENDS
from gcs.telemetry.events import Event
from gcs.telemetry.proximity import PRESENT
from gcs.telemetry.state import FleetSnapshot

if TYPE_CHECKING:
    from gcs.session.observer import Observer

_OURS = STEERABLE | {FlightMode.MISSION}
"""Modes that a vehicle flies by what the session ordered."""
STANDS_S = 0.35
"""A competition that has not been recorded for so long is over."""


@dataclass
class _Life:
    """One service from its decision to its end, and when its phase changed."""

    service: Service
    known_s: float
    """when the session knew of it, which may be later than vehicles that compete on board decided it; -inf: before the
    recording begins"""
    phases: list[tuple[float, Phase]] = field(default_factory=list)
    end_s: float | None = None
    reason: str = ""
    energy_j: float = 0.0

    def at(self, t_s: float) -> Service:
        """State at a time."""
        if self.end_s is not None and self.end_s <= t_s:
            return replace(
                self.service, phase=Phase.DONE, end_s=self.end_s, ended_by=self.reason, energy_j=round(self.energy_j)
            )
        phase = Phase.JOIN
        for since_s, name in self.phases:
            if since_s <= t_s:
                phase = name
        joined_at_s, start_s = self.service.joined_at_s, self.service.start_s
        return replace(
            self.service,
            phase=phase,
            joined_at_s=joined_at_s if joined_at_s is not None and joined_at_s <= t_s else None,
            start_s=start_s if start_s is not None and start_s <= t_s else None,
        )


class ServiceMoment(NamedTuple):
    """Events of a vehicle that its frames do not show: its death, or energy in J that a base gave it."""

    t_s: float
    sysid: int
    booked_j: int | None
    """None: it died"""


class Moments:
    """Deaths, losses, bookings and operators' orders: a session's decisions on vehicles that their frames do not
    show."""

    def __init__(self, on_missions: Iterable[int] = ()) -> None:
        """`on_missions`: vehicles that began on one."""
        self._on_missions = list(on_missions)
        self._participation, self._changes = Participation(self._on_missions), 0
        """as of the last time that was asked for, and how many changes were before it"""
        self.happened: list[ServiceMoment] = []
        self.orders: list[tuple[float, int, End | None]] = []
        """(time, system id, what it is to fly; None: by the plan, or by others) of what operators took in hand"""
        self.losses: list[tuple[float, int]] = []
        """(time, system id) of vehicles that were lost, some of which flew again"""
        self._found: list[tuple[float, int]] = []
        """(time, system id) of vehicles that flew, or flew again, by what the session ordered"""
        self._charging: list[tuple[float, str, int]] = []
        """(time, kind, system id) of decisions on vehicles that land at a base and take off again"""
        self._breaches: list[tuple[float, Mapping[str, Any]]] = []
        """(time, violation) of pairs that are too near, which the snapshot then shows for as long as they are"""
        self._refuelling: list[tuple[float, str, int]] = []
        """(time, what, system id) of orders, faults, decisions and deaths that change who takes part in refuelling"""

    def take(self, t_s: float, record: Mapping[str, Any]) -> None:
        """Take the next decision. Raises ValueError, KeyError, TypeError for one of another version."""
        kind = record["kind"]
        if kind == "fault" and record["fault"] == "tanker_out":
            self._refuelling.append((t_s, f"tanker_out {record['state']}", int(record["sysid"])))
        elif kind == "mission" and record["state"] == "flown":
            self._refuelling.append((t_s, "mission flown", int(record["sysid"])))
        elif kind in ("decided", "death"):
            self._refuelling.append((t_s, kind, int(record["receiver" if kind == "decided" else "sysid"])))
        elif kind == "operator" and record.get("taken") and "sysid" in record:
            self._refuelling.append((t_s, str(record["command"]), int(record["sysid"])))
        if kind in ("decided", "served") and record.get("base"):
            self._charging.append((t_s, kind, int(record["receiver"])))
        if kind == "death":
            self.happened.append(ServiceMoment(t_s, int(record["sysid"]), None))
        elif kind == "served" and record.get("base"):
            self.happened.append(ServiceMoment(t_s, int(record["receiver"]), round(float(record["energy_j"]))))
        elif kind == "violation" and record["part"] == "lost":
            self.losses += [(float(record["at_s"]), int(sysid)) for sysid in record["sysids"]]
        elif kind == "violation" and record["part"] in PRESENT and record["by"] == "reports":
            self._breaches.append((t_s, record))
        elif kind == "operator" and record.get("taken") and "sysid" in record:
            if record["command"] in ("rejoin", "release"):
                self.orders.append((t_s, int(record["sysid"]), None))
            elif record["command"] in ENDS:
                self.orders.append((t_s, int(record["sysid"]), ENDS[record["command"]][0]))

    def ordered(self, t_s: float) -> dict[int, End]:
        """Modes of vehicles that an operator has taken over."""
        held: dict[int, End] = {}
        for since_s, sysid, mode in self.orders:
            if since_s <= t_s:
                held.pop(sysid, None)
                if mode is not None:
                    held[sysid] = mode
        return held

    def participation(self, t_s: float) -> Participation:
        """Which vehicles took part in refuelling at a time, as the session's scheduler knew; until the next call."""
        if self._changes and self._refuelling[self._changes - 1][0] > t_s:
            self._participation, self._changes = Participation(self._on_missions), 0
        for since_s, what, sysid in itertools.islice(self._refuelling, self._changes, None):
            if since_s > t_s:
                break
            self._participation.change(what, sysid)
            self._changes += 1
        return self._participation

    def see_landings(self, recorded: Recorded) -> None:
        """Know which vehicles came down without an order, and fly again, by what they said of themselves: a loss that
        the goal allows is in no decision. Decisions are to be taken before."""
        for t_s, sysid, came_down in series.landings(recorded):
            if not came_down:
                self._found.append((t_s, sysid))
            elif not self._was_to_land(t_s, sysid):
                self.losses.append((t_s, sysid))

    def _was_to_land(self, t_s: float, sysid: int) -> bool:
        own = [(at_s, kind) for at_s, kind, receiver in self._charging if receiver == sysid]
        before, after = ([kind for at_s, kind in own if (at_s <= t_s) is early] for early in (True, False))
        charged = before[-1:] == ["decided"] or after[:1] == ["served"]  # its decision may be in no part that was kept
        released = self.participation(t_s).out.get(sysid) == RELEASED
        return charged or released or self.ordered(t_s).get(sysid) in ("return", "land")

    def lost(self, t_s: float) -> set[int]:
        """Vehicles lost by a time; no vehicle that flew again by what was ordered counts, nor one that rejoined and was
        then ordered to land."""
        lost_s = {sysid: since_s for since_s, sysid in sorted(self.losses) if since_s <= t_s}
        for at_s, sysid in self._found:
            if lost_s.get(sysid, math.inf) < at_s <= t_s:
                del lost_s[sysid]
        ordered = self.ordered(t_s)
        rejoined = {
            sysid
            for at_s, what, sysid in self._refuelling
            if what == "rejoin" and lost_s.get(sysid, math.inf) <= at_s <= t_s
        }
        return {sysid for sysid in lost_s if sysid not in rejoined or ordered.get(sysid) not in ("return", "land")}

    def show(self, observer: Observer, t_s: float) -> None:
        """Let an observer know what was ordered, lost and broken by a time, and what kept vehicles from refuelling."""
        observer.ordered, observer.lost = self.ordered(t_s), self.lost(t_s)
        observer.kept_out = self.participation(t_s).reasons
        observer.breaches = [record for since_s, record in self._breaches if since_s <= t_s]

    def let_happen(self, observer: Observer, done: int, t_s: float) -> int:
        """Let an observer's vehicles die, and energy be booked, that did so by a time; how many of all `happened` then
        are done, of which `done` were before."""
        while done < len(self.happened) and self.happened[done].t_s <= t_s:
            _, sysid, joules = self.happened[done]
            if sysid in observer.sysids:
                if joules is None:
                    observer.fleet.lost(sysid)
                elif not observer.view(t_s).vehicle(sysid).battery_reported:
                    observer.fleet.book(sysid, joules)
            done += 1
        return done


class Timeline(Moments):
    """Decisions of a session. Raises OSError where the file cannot be read."""

    def __init__(self, path: Path, scenario: Scenario, progress: Callable[[float], object] = lambda _: None) -> None:
        super().__init__(pursuer.sysid for pursuer in scenario.vehicles.on_missions)
        self._scenario = scenario
        self._lives: list[_Life] = []
        self._competition_lines: list[DecisionLine] = []
        self._shown: list[tuple[float, dict[str, Any]]] = []
        self._pursuing: list[tuple[float, int, int]] = []
        self.chases: list[dict[str, Any]] = []
        """the decisions and orders that assign targets to pursuers"""
        self.violations: list[dict[str, Any]] = []
        """the goal's parts that were broken, in the order of their times"""
        self.unmet: Sequence[GoalPartSummary] | None = None
        """what the session's summary says of them; None where there is none"""
        self.worlds = Worlds(scenario)
        """obstacles, attractors and targets' paths, as they changed"""
        self.broken = 0
        self._begins = rotation.begins(path)
        """whether the first decisions are there"""
        lines = DecisionLines(path, progress)
        for _, others in lines.blocks(set_points=False):
            for line in others:
                self._add(line)
        self.broken += lines.passed_over
        self._shown.sort(key=lambda shown: shown[0])  # what only the vehicles' truth showed was recorded at the end
        self.violations.sort(key=lambda record: float(record["at_s"]))
        self._competition_s = [line.t_s for line in self._competition_lines]
        self._shown_s = [t_s for t_s, _ in self._shown]

    def end(self, summary: Summary) -> None:
        """Know what the session's summary says at its end: parts of the goal that were not met, when vehicles decided
        services that were under way, which no line says, and services whose lines were not kept."""
        self.unmet = summary.unmet if summary.goal else None
        known = {(*_sides(life.service), life.service.decided_at_s) for life in self._lives if life.end_s is not None}
        for row in summary.refuelling:
            sides = row.receiver, row.tanker, row.base
            life = self._under_way(sides) if row.end_s is None else None
            if life is None and not self._begins and (*sides, row.decided_at_s) not in known:
                life = self._begun_before(sides)
                life.end_s, life.reason, life.energy_j = row.end_s, NO_REASON, row.energy_j
                life.service.joined_at_s, life.service.start_s = row.joined_at_s, row.start_s
            if life is not None:
                life.service.decided_at_s, life.service.by = row.decided_at_s, row.by
                life.service.bids = _by_sysid(row.bids)

    def events(self, after_s: float, until_s: float) -> Iterator[Event]:
        """Decisions, orders and deaths in after_s < t ≤ until_s."""
        first, last = bisect.bisect_right(self._shown_s, after_s), bisect.bisect_right(self._shown_s, until_s)
        return (event_of(record) for _, record in self._shown[first:last])

    def fill(self, line: SnapshotMessage, snapshot: FleetSnapshot, pursue_held_s: float | None) -> None:
        """Write the decisions by the time of a snapshot into its line.

        pursue_held_s: for how long the goal's pursuit had been held; None where it is unknown, and the goal is left
        out.
        """
        t_s, scenario = snapshot.time_s, self._scenario
        services = [life.at(t_s) for life in self._lives if life.known_s <= t_s]
        services.sort(key=lambda service: (service.decided_at_s, service.number))
        self._book(services, snapshot)
        competition_state = self._competition_at(t_s)
        is_open = [service for service in services if service.phase is not Phase.DONE]
        line.duration_s = scenario.goal.duration_s
        line.competition = CompetitionRow(**explain.competition_of(competition_state, scenario.competition))
        line.services = messages.services_of(is_open, snapshot, scenario)
        line.history = [ServedRow(**row) for row in explain.history_of(services)]
        line.refuelled = sum(is_refuelling(service.end_s, service.energy_j) for service in services)
        line.goal = messages.goal_state(self.worlds.judged, pursue_held_s, self._broken_at(t_s, snapshot))
        if pursue_held_s is None:
            line.goal.pursue_within_m = line.goal.pursue_for_s = None
        states, notes = (
            messages.states_of(snapshot, competition_state, is_open),
            explain.notes_of(is_open, self.participation(t_s)),
        )
        targets, places = self._targets(t_s), {row.sysid: row.p_ned for row in line.vehicles}
        for row in line.vehicles:
            row.v, row.tau = competition_state.v.get(row.sysid), competition_state.tau.get(row.sysid)
            row.note, row.state = notes.get(row.sysid, ""), states[row.sysid]
            row.target_m = messages.distance_m(row.p_ned, places.get(targets.get(row.sysid, -1)))

    def _broken_at(self, t_s: float, snapshot: FleetSnapshot) -> list[BrokenRow]:
        """Parts of the goal that were broken by a time: as the session judged them at its end, by truth; where it left
        no summary, by what was recorded when it happened. Which vehicles were lost changes until the end."""
        at_end = t_s >= self._scenario.goal.duration_s - 1e-6
        if self.unmet is None:
            by_now = (record for record in self.violations if record["at_s"] <= t_s and record["part"] != "lost")
            return self._lost_row(t_s, snapshot) + messages.first_broken(by_now)
        judged = [
            BrokenRow(part.part, f"{part.part} {part.reached}", part.t_s)
            for part in self.unmet
            if at_end or (part.part != "lost" and part.t_s is not None and part.t_s <= t_s)
        ]
        return judged if at_end else self._lost_row(t_s, snapshot) + judged

    def _lost_row(self, t_s: float, snapshot: FleetSnapshot) -> list[BrokenRow]:
        """The vehicles that were lost at a time, where they were more than the goal allows. One that is steered again
        is not."""
        steered = {view.sysid for view in snapshot.vehicles if view.flying and view.mode in _OURS}
        lost, losses = self.lost(t_s) - steered, {}
        for record in self.violations:
            for sysid in record["sysids"] if record["part"] == "lost" and record["at_s"] <= t_s else ():
                losses[sysid] = Loss(sysid, record["at_s"], record["text"].partition(" is lost: ")[2])
        measured = Measured(lost=[loss for sysid, loss in losses.items() if sysid in lost])
        judged = judge(self.worlds.judged, measured)
        return [BrokenRow(one.part, one.text, one.t_s) for one in judged if one.part == "lost" and one.met is False]

    def _targets(self, t_s: float) -> dict[int, int]:
        vehicles = self._scenario.vehicles
        if self._scenario.pursuit.by != "competition":
            found = {p.sysid: on for p in vehicles.pursuers if (on := vehicles.target_of(p)) is not None}
        else:
            found = {}
        for since_s, pursuer, target in self._pursuing:
            if since_s <= t_s:
                if self._scenario.pursuit.by == "competition":
                    found = {p: on for p, on in found.items() if on != target}
                found[pursuer] = target
        return found

    def _book(self, services: list[Service], snapshot: FleetSnapshot) -> None:
        """Energy that an open service has transferred: what its receiver has got beyond what earlier ones gave it."""
        before: dict[int, float] = {}
        for service in services:
            if service.phase is Phase.DONE:
                before[service.receiver] = before.get(service.receiver, 0.0) + service.energy_j
        for service in services:
            if service.phase is not Phase.DONE and service.start_s is not None:
                received_j = snapshot.vehicle(service.receiver).received_j
                service.energy_j = max(round(received_j - before.get(service.receiver, 0.0)), 0)

    def contest(self, t_s: float) -> list[tuple[float, dict[str, float]]]:
        """The competition's states of the last minute before `t_s`, as a session's line tells them."""
        times = [
            t_s - messages.CONTEST_S + k * messages.CONTEST_EVERY_S
            for k in range(round(messages.CONTEST_S / messages.CONTEST_EVERY_S))
        ]
        states = ((at_s, self._competition_at(at_s).v) for at_s in times)
        return [(at_s, {str(sysid): v for sysid, v in of.items()}) for at_s, of in states if of]

    def _competition_at(self, t_s: float) -> CompetitionState:
        at = bisect.bisect_right(self._competition_s, t_s) - 1
        if at < 0 or t_s - self._competition_s[at] > STANDS_S:
            return CompetitionState()
        record = self._competition_lines[at].record()
        try:
            leader = None if record["leader"] is None else int(record["leader"])
            return CompetitionState(
                _by_sysid(record["v"]), _by_sysid(record["tau"]), {}, leader, float(record["share"])
            )
        except (KeyError, ValueError, TypeError, AttributeError, OverflowError):  # a broken line shows nothing
            return CompetitionState()

    # reading

    def _add(self, line: DecisionLine) -> None:
        if line.kind == "competition":
            if line.giver != "base":
                self._competition_lines.append(line)
            return
        try:
            record, t_s = line.record(), line.t_s
            self._read(t_s, record)
            if record["kind"] == "violation" and record["by"] == "truth":
                t_s = float(record["at_s"])
                record["t_s"] = t_s
            if record["kind"] == WORLD:
                self.worlds.change(t_s, record)
            if is_event(record):
                self._shown.append((t_s, record))
        except (ValueError, KeyError, TypeError, AttributeError):
            self.broken += 1

    def _read(self, t_s: float, record: Mapping[str, Any]) -> None:
        """Take a decision in."""
        kind = record["kind"]
        if kind == "decided":
            self.take(t_s, record)
            receiver, need = int(record["receiver"]), _by_sysid(record["need"])
            service = Service(
                len(self._lives) + 1,
                receiver,
                record["tanker"],
                record["by"],
                _by_sysid(record["bids"]),
                t_s,
                need=need.get(receiver, 0.0),
                need_is_largest=need.get(receiver, 0.0) >= max(need.values(), default=0.0),
                share=record["share"],
                base=record.get("base"),
                why_base=record.get("reason", ""),
            )
            self._lives.append(_Life(service, t_s))
        elif kind in ("transfer", "broken off", "served"):
            sides = (int(record["receiver"]), record["tanker"], record.get("base"))
            life = self._under_way(sides) or self._begun_before(sides)
            if kind == "served":
                life.end_s, life.reason, life.energy_j = t_s, record["reason"], float(record["energy_j"])
                life.service.decided_at_s = float(record["decided_at_s"])
                life.service.by, life.service.bids = record["by"], _by_sysid(record["bids"])
                life.service.joined_at_s, life.service.start_s = record["joined_at_s"], record["start_s"]
                self.take(t_s, record)
            else:
                life.phases.append((t_s, Phase.TRANSFER if kind == "transfer" else Phase.JOIN))
                if kind == "transfer" and life.service.start_s is None:
                    life.service.start_s = life.service.joined_at_s = t_s
        elif kind == "pursuit":
            self._pursuing.append((t_s, int(record["pursuer"]), int(record["target"])))
            self.chases.append(dict(record))
        elif kind == "violation":
            _ = float(record["at_s"]), str(record["part"]), str(record["text"]), str(record["by"])
            self.violations.append(dict(record))
            self.take(t_s, record)
        elif kind in ("death", "operator", "fault", "mission"):
            self.take(t_s, record)
            if record.get("taken") and "sysid" in record and record["command"] == "retarget":
                self._pursuing.append((t_s, int(record["sysid"]), int(record["target"])))
                self.chases.append(dict(record))

    def _under_way(self, sides: tuple[int, int | None, str | None]) -> _Life | None:
        """The last service that was decided between receiver, tanker and base, and has not ended."""
        return next((one for one in reversed(self._lives) if one.end_s is None and _sides(one.service) == sides), None)

    def _begun_before(self, sides: tuple[int, int | None, str | None]) -> _Life:
        """A service that was decided in a part of the recording that was not kept. Raises ValueError where all are
        there."""
        if self._begins:
            raise ValueError("a service that was never decided")
        receiver, tanker, base = sides
        service = Service(len(self._lives) + 1, receiver, tanker, "", {}, 0.0, need=math.nan, base=base)
        self._lives.append(_Life(service, -math.inf))
        return self._lives[-1]


def _sides(service: Service) -> tuple[int, int | None, str | None]:
    return service.receiver, service.tanker, service.base


def _by_sysid(numbers: Mapping[str, float]) -> dict[int, float]:
    return {int(sysid): float(number) for sysid, number in numbers.items()}
