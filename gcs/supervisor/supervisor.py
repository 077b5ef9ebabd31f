"""The supervisor: one tick of a session, top to bottom.

    answers → radio → fleet → snapshot → schedule → plan → messages → radio → grants → record

What the tick at T decides leaves with the grant up to T + period, and is flown from that grant's first step.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from gcs.link.impairment import Impairment
from gcs.link.link import Answers, Key, TickLink
from gcs.mavlink.autopilots import End
from gcs.mavlink.command_protocol import ARMING, CommandResult
from gcs.mavlink.ids import AUTOPILOT, OUR_HEARTBEAT, TRAFFIC
from gcs.mavlink.setpoints import SetPoint
from gcs.planner.custom import make_planner
from gcs.planner.request import PlanRequest
from gcs.recording.decision_lines import TickSetPoints
from gcs.recording.digest import Digest
from gcs.recording.recorder import Recorder
from gcs.recording.tick_record import TickRecord, event_of, is_event, records_of_tick
from gcs.refuelling.base_service import giver_messages
from gcs.refuelling.explain import acknowledged
from gcs.refuelling.policies import PolicyCalls
from gcs.refuelling.policy_bidding import make_bidding
from gcs.refuelling.relay import Relay, relayed
from gcs.refuelling.service import Decision
from gcs.refuelling.target_assignment import TargetAssignment
from gcs.refuelling.watched_schedule import WatchedSchedule
from gcs.scenario.faults import Fault, Injection, drawn
from gcs.scenario.goal import Judgement, judge
from gcs.scenario.guard import PluginFault
from gcs.scenario.model import Scenario
from gcs.scenario.parts.world import Change, Worlds, meets
from gcs.scenario.plugins import PLANNER, POLICY, PluginClient
from gcs.supervisor.arming import Stage
from gcs.supervisor.external_fleet import ENDING, ExternalFleet
from gcs.supervisor.factory import (
    make_arming_sequences,
    make_fleet,
    make_schedule,
)
from gcs.supervisor.faults import INJECTED, FaultInjector, survival_text
from gcs.supervisor.fleet_arming import FleetArming, stage_event
from gcs.supervisor.fleet_command_queue import FleetCommandQueue
from gcs.supervisor.forwarding import ForwardedControl
from gcs.supervisor.goal_watch import GoalWatch
from gcs.supervisor.grants import GrantSender, WaitingMessages
from gcs.supervisor.mission_watch import MissionWatch
from gcs.supervisor.operator import Operator, OperatorReply
from gcs.supervisor.preflight import Preflight
from gcs.supervisor.radios import Radios
from gcs.supervisor.reception import Received, Reception
from gcs.supervisor.recovery import Recovery
from gcs.supervisor.script import COMMAND, Script
from gcs.supervisor.services.operator_control import TOKEN as CONTROL
from gcs.supervisor.services.vehicle_texts import VehicleTexts
from gcs.telemetry.changes import ChangeDetector
from gcs.telemetry.events import Event
from gcs.telemetry.metrics import Metrics
from gcs.telemetry.state import FleetSnapshot, Vec3

if TYPE_CHECKING:  # most sessions have none
    from gcs.link.forwarder import Forwarder

WAIT_FOR_FLEET_S = 30.0
_SETTLED = frozenset({Stage.FLY, Stage.MISSION, Stage.YIELDED, Stage.DOWN, Stage.TAKEN})


class Supervisor:
    """A session's brain: everything between the link and the recorder."""

    def __init__(
        self,
        scenario: Scenario,
        link: TickLink,
        recorder: Recorder,
        *,
        impaired: bool = True,
        forwarder: Forwarder | None = None,
        plugins: Mapping[str, PluginClient] = MappingProxyType({}),
    ) -> None:
        """`impaired`: the radio does what the scenario says; not where frames come from a recording of it.
        `forwarder`: other ground stations that hear what vehicles say. `plugins`: by key (gcs/scenario/plugins.py) the
        processes of a planner and policy that are the user's own, where the scenario names some or its program brings
        them. Raises ScenarioError where they cannot be made."""
        self.scenario = scenario
        self.period_ms = round(1e3 * scenario.clock.period_s)
        self.epoch_us = round(1e6 * scenario.clock.epoch.timestamp())
        self.link = link
        self._recorder = recorder
        self._forwarder = forwarder
        self.digest = Digest()
        self.fleet = make_fleet(scenario)
        self.planner = make_planner(scenario, plugins.get(PLANNER))
        bidding, policy = make_bidding(scenario, plugins.get(POLICY))
        self._plugins = list(dict.fromkeys(plugins.values()))
        self._fallible: list[PluginClient | PolicyCalls] = [*self._plugins, *([] if policy is None else [policy])]
        self.schedule = make_schedule(scenario, bidding)
        self.pursuit: TargetAssignment | None = None
        if scenario.pursuit.by == "competition":
            targets = [target.sysid for target in scenario.vehicles.targets]
            pursuers = [p.sysid for p in scenario.vehicles.pursuers if not p.own_way]
            self.pursuit = TargetAssignment(scenario.pursuit, pursuers, targets, scenario.planner.cruise_m_s)
        self.metrics = Metrics(scenario)
        self.arming = make_arming_sequences(scenario)
        self._fleet_arming = FleetArming(self.arming)
        self.goal_watch = GoalWatch(scenario, self.planner.obstacles, self._fleet_arming)
        self.operator = Operator(scenario, self.arming, self.schedule)
        self.recovery = Recovery(self.arming if scenario.vehicles.external else {})
        stations = dict.fromkeys(scenario.vehicles.external, scenario.station.ids)
        self._forwarded = ForwardedControl(self.arming, self.operator, stations)
        self.externals = ExternalFleet(scenario)
        self.preflight = Preflight(scenario)
        self.missions = MissionWatch(scenario, self.arming, self.schedule.participation)
        self._wait_for_fleet_s = WAIT_FOR_FLEET_S + self.externals.patience_s
        self._join_ms = {v.sysid: round(1e3 * v.join_s) for v in scenario.vehicles.all}
        injections = drawn(scenario.faults, scenario.seed)
        self.faults = FaultInjector(scenario, injections)
        self.hung: set[int] = set()
        """whose process has been stopped by a fault"""
        self.script = Script()
        self.worlds = Worlds(scenario)
        """obstacles, attractors and targets' paths, each from a tick on"""
        self._surrounded = True
        """whether the goal is measured in the last of the worlds"""
        self._impaired = impaired
        self._radios = Radios.of(scenario, injections) if impaired else Radios(Impairment())
        self.command_queue = FleetCommandQueue(self.arming, stations)
        watched = self.schedule if isinstance(self.schedule, WatchedSchedule) else None
        self._reception = Reception(self.fleet, self._radios, watched, scenario.vehicles.external)
        self.gaps, self.quality = self._reception.gaps, self._reception.quality
        self.inspection = self._reception.inspection
        waiting = WaitingMessages(self.command_queue, self._forwarded, self.faults, self.quality)
        self._sender = GrantSender(link, self._radios, waiting, self._join_ms)
        self.time_ms = 0
        self.received = 0
        self.sent = 0
        self.events: list[Event] = []
        self.targets_move = False
        self.grounded: frozenset[int] = frozenset()
        """vehicles that land at a base, or stand at one"""
        self._watch = ChangeDetector()
        self._texts = VehicleTexts(self.fleet, self.externals, self.arming)
        self._deaths: list[dict[str, Any]] = []
        self._reported_lost: set[int] = set()
        self.set_points: Sequence[SetPoint] = []
        self.snapshot: FleetSnapshot = self.fleet.snapshot(0.0)

    @property
    def time_s(self) -> float:
        """Session time."""
        return self.time_ms / 1e3

    @property
    def _late_ms(self) -> int:
        """How far the wall clock, on which external vehicles fly, is ahead of this tick; 0 without any."""
        return (self._periods - 1) * self.period_ms if self.externals.rules else 0

    def begin(self) -> None:
        """Send the first grant, which sets the vehicles' clocks and lets none move."""
        recording = TickRecord(0, [], [], [])
        self._grant_all((), self.snapshot, {}, recording)
        self._record(recording)

    def tick(self, idle: Callable[[], None], periods: Callable[[], int] = lambda: 1) -> None:
        """Collect the answers to the last grant, decide, and send the next one.

        `periods`, asked when the answers are in: how many the next grant is of. More than one: what vehicles on the
        wall clock say now is of so much later.
        """
        now_s = self.time_s
        received = self._receive(self._answers(idle, periods), now_s, lambda: self._late_ms / 1e3)
        self._receive_acknowledgements(now_s)
        if self._forwarder is not None:
            self._receive_forwarded(self._forwarder, now_s)
        if self.faults.any:
            self._inject_faults(now_s)
        self.snapshot = snapshot = self.fleet.snapshot(now_s)
        ordered: Mapping[int, End] = self._fleet_arming.groups.ordered
        if self.grounded:
            ordered = {**dict.fromkeys(self.grounded, "land"), **ordered}
        self.events += self._watch.look(snapshot, ordered)
        decision = self.schedule.decide(snapshot)
        self._serve_at_bases(decision)
        self._prepare(snapshot)
        self._watch_missions(snapshot)
        self._fly(snapshot, now_s)
        self.events += self.recovery.look(snapshot)
        self._keep_streams(snapshot)
        pursuing = self.pursuit.decide(snapshot) if self.pursuit else self.operator.pursuing
        self.set_points = set_points = self._plan(snapshot, decision, pursuing)
        self.command_queue.ask(decision.requests, now_s)
        for sysid in self.command_queue.pending:
            for result in self.command_queue.poll(sysid, now_s):
                self._report(sysid, result, now_s)
        relays = relayed(decision.relays, received.by_system)
        recording = TickRecord(self.time_ms, received.frames, [], [], received.late_frames, self._late_ms)
        self._grant_all(set_points, snapshot, relays, recording)
        decisions = self._records(now_s, decision, set_points)
        self.metrics.update(snapshot, self._flown(set_points), pursuing, self._late_ms / 1e3)
        recording.decisions = [*decisions, *self._watch_goal(snapshot, decision.partners)]
        if not self._surrounded:  # the way to here was flown in the world before
            self._surrounded = True
            self.goal_watch.surround(now_s, self.worlds, self.planner.obstacles)
        self._record(recording)

    def finish(self, idle: Callable[[], None]) -> None:
        """Collect and record the answers to the last grant; nothing is decided any more."""
        received = self._receive(self._answers(idle, lambda: 1), self.time_s)
        self.snapshot = self.fleet.snapshot(self.time_s)
        self.metrics.finish(self.snapshot)
        broken = self._watch_goal(self.snapshot, self._partners)
        self._record(TickRecord(self.time_ms, received.frames, [], self._new_records() + broken))

    def judge(self, folder: Path) -> None:
        """At the end: judge the goal by the truth that our own vehicles have left in the session's folder, and record
        what only that shows."""
        records, events = self.goal_watch.judge_truth(folder, self.fleet.snapshot(self.time_s))
        self.events += events
        if records:
            self._record(TickRecord(self.time_ms, [], [], records))

    def judged(self) -> list[Judgement]:
        """Result of each part of the goal so far."""
        refuelled, held_s = len(self.schedule.refuelled), self.metrics.pursuit_held_s
        measured = self.goal_watch.measured(
            self.snapshot, time_s=self.time_s, pursuit_held_s=held_s, refuelled=refuelled
        )
        missed = {**(measured.missed or {}), **self.missions.missed}
        return judge(self.worlds.judged, replace(measured, missed=missed))

    def fault_outcomes(self) -> list[dict[str, Any]]:
        """Faults that were injected so far, and what came of each."""
        return self.faults.outcomes(self.goal_watch.harmed(self.fleet.snapshot(self.time_s), self.time_s))

    def faults_text(self) -> str:
        """For the end of the outcome's sentence: how many faults were survived, and which were not."""
        return survival_text(self.fault_outcomes())

    def _watch_goal(self, snapshot: FleetSnapshot, partners: Iterable[tuple[int, int]]) -> list[dict[str, Any]]:
        """Measure the tick for the goal; records of what has just been broken."""
        self._partners = frozenset(partners)
        watch, now_s = self.goal_watch, snapshot.time_s
        if self.externals.lost != self._reported_lost:
            for sysid in self.externals.lost - self._reported_lost:
                watch.lose(sysid, now_s, "silent")
            for sysid in self._reported_lost - self.externals.lost:
                watch.find(sysid)
            self._reported_lost = set(self.externals.lost)
        broken, events = watch.update(snapshot, self._partners)
        lost, of_losses = watch.new_losses(now_s)
        if events or of_losses:
            self.events += events + of_losses
        return broken + lost

    def stop(self) -> None:
        """Record orders and deaths since the last tick: there is none after it."""
        self._record(TickRecord(self.time_ms, [], [], self._new_records()))

    def obey(self, order: Mapping[str, Any]) -> OperatorReply:
        """Take an operator's order, or say why not."""
        answer, event = self.operator.obey(order, self.fleet.snapshot(self.time_s))
        self.events.append(event)
        return answer

    def command(self, number: int, sysid: int, command: int, params: Sequence[float | None]) -> OperatorReply:
        """Send a vehicle a MAV_CMD of a program's, number `number` of its commands, with the next grant, or say why
        not."""
        if (refusal := self.operator.unreachable(sysid, self.fleet.snapshot(self.time_s))) is not None:
            return OperatorReply(False, refusal)
        request = self.script.command(self.time_s, number, sysid, command, params)
        self.command_queue.ask([request], self.time_s)
        event = event_of({"t_s": self.time_s, "kind": COMMAND, "sysid": sysid, "mav_cmd": command})
        self.events.append(event)
        return OperatorReply(True, event.text)

    def change(self, change: Change) -> OperatorReply:
        """Change an obstacle, an attractor or a target's path with the next tick, or say why not."""
        try:
            if problem := meets(self.worlds.now, change, self._places()):
                raise ValueError(problem)
            self.surround(change)
        except ValueError as error:
            return OperatorReply(False, f"The change is refused: {error}.")
        record = self.script.changed(self.time_s, change)
        if is_event(record):
            self.events.append(event_of(record))
        return OperatorReply(True, record["text"])

    def surround(self, change: Change) -> None:
        """Let the world be another from the next tick on. Raises ValueError where the change makes none."""
        self.planner.surround(self.worlds.change(self.time_s, change))
        self._surrounded = False

    def _places(self) -> dict[str, Vec3]:
        """Where vehicles are that live, by their labels."""
        views = self.fleet.snapshot(self.time_s).vehicles
        return {view.label: view.p_now_ned() for view in views if view.alive and view.p_ned is not None}

    def inject(self, fault: Fault) -> OperatorReply:
        """Let a fault happen that the scenario does not have, or say that its vehicle is dead."""
        if fault.sysid is not None and not (view := self.snapshot.vehicle(fault.sysid)).alive:
            return OperatorReply(False, f"The fault is refused: {view.label} is dead.")
        one = self.faults.add(fault)
        self.script.injected(self.time_s, one)
        if self._impaired:
            self._radios.add(one, self.scenario)
        return OperatorReply(True, f"The fault {fault.fault} begins at {fault.at_s:g} s.")

    def note(self, command: str, answer: OperatorReply) -> None:
        """Report and record a command that the session's clock has carried out."""
        self.events.append(self.operator.note(self.time_s, command, answer))

    def lose(self, key: Key, why: str) -> None:
        """A process has died: hold it no longer, report it, let the others go on."""
        self.link.leave(key)
        self._deaths.append({"t_s": self.time_s, "kind": "death", "sysid": key[0], "text": why})
        self.goal_watch.lose(key[0], self.time_s, "its process died")
        if key != TRAFFIC:
            self.externals.die(key[0])
            self.fleet.lost(key[0])
        self.events.append(Event(self.time_s, key[0], "critical", why, "death"))

    # faults

    def _inject_faults(self, now_s: float) -> None:
        """Let those begin and end whose time has come; in lockstep it is the same tick in every session."""
        columns = self.snapshot.columns
        dead = {sysid for sysid, alive in zip(columns.sysids, columns.alive.tolist(), strict=True) if not alive}
        begin, end = self.faults.step(now_s, dead)
        for one in begin:
            self._begin_fault(one)
        for one in (*begin, *end):
            self.command_queue.ask(self.faults.requests(one, ends=one in end), now_s)
        for one in end:
            self._end_fault(one)
        self.events += [event_of(record) for record in self.faults.records]
        for sysid, arming in self.arming.items():
            if self.faults.unheard(sysid):
                arming.excuse(now_s)

    def _begin_fault(self, one: Injection) -> None:
        sysid, fault = one.fault.sysid, one.fault.fault
        if sysid is None or (sysid, AUTOPILOT) not in self.link.joined:
            return
        if fault in ("kill", "hang"):
            self.faults.signal_process(sysid, fault)
        if fault == "kill":
            self.lose((sysid, AUTOPILOT), f"{self.snapshot.vehicle(sysid).label} was killed {INJECTED}")
        elif fault == "hang":
            self.hung.add(sysid)
        elif fault == "tanker_out":
            self.schedule.participation.change("tanker_out begins", sysid)

    def _end_fault(self, one: Injection) -> None:
        sysid, fault = one.fault.sysid, one.fault.fault
        if fault == "tanker_out" and sysid is not None:
            self.schedule.participation.change("tanker_out ends", sysid)
        elif fault == "gps_off" and sysid is not None:
            self.arming[sysid].mend(self.fleet.snapshot(self.time_s).vehicle(sysid))

    # in

    def _answers(self, idle: Callable[[], None], periods: Callable[[], int]) -> Iterator[Answers]:
        """Frames of the vehicles for which the tick waits; then of the others, with the pace asked in between."""
        yield from self.link.answers(idle)
        self._periods = periods()
        unawaited = self.link.unawaited()
        if unawaited:
            yield list(unawaited), list(unawaited.values())

    def _receive(self, answers: Iterable[Answers], now_s: float, late_s: Callable[[], float] = lambda: 0.0) -> Received:
        """Pass what came to all its readers."""
        for sysid in self.link.pop_relinked() if self.externals.rules else ():
            self.gaps.forget(sysid)
            self.externals.relinked(sysid)
        received = self._reception.receive(answers, now_s, late_s)
        delivered, said_s = received.by_system, now_s
        if self.externals.rules:
            said_s = max(now_s, self.link.unawaited_s())
            offsets_s, rebooted = self.link.clock_offsets_s(), self.link.pop_rebooted()
            self.externals.receive(delivered, offsets_s, rebooted, self.fleet, now_s)
            for sysid in rebooted:
                self.arming[sysid].boot(self.fleet.snapshot(now_s).vehicle(sysid))
        self.preflight.receive(delivered, self.epoch_us + round(1e6 * said_s), now_s, said_s)
        self.missions.receive(delivered)
        self.received += len(received.frames) + len(received.late_frames)
        self.events += self._texts.pop_events(now_s)
        return received

    def _receive_forwarded(self, forwarder: Forwarder, now_s: float) -> None:
        """Let pass what other ground stations may say to vehicles; without control it is read and forgotten."""
        received = forwarder.receive()
        if received and self.scenario.forward.control:
            self.events += self._forwarded.receive(received, self.fleet.snapshot(now_s))

    def _receive_acknowledgements(self, now_s: float) -> None:
        for sysid, ack in self.fleet.pop_acks():
            for result in self.command_queue.on_ack(sysid, ack, now_s):
                self._report(sysid, result, now_s)

    def _report(self, sysid: int, result: CommandResult, now_s: float) -> None:
        self.schedule.result(str(result.token), result.outcome == "accepted")
        self.script.acknowledge(sysid, result)
        if self.externals.settles(sysid, result, now_s):
            return
        text, arming = acknowledged(result), self.arming[sysid]
        if result.outcome == "timeout" and arming.has_left(str(result.token)):
            return
        if result.outcome == "accepted":
            self.events.append(Event(now_s, sysid, "info", text, "ack"))
        elif not arming.repeats(text):
            self.events.append(Event(now_s, sysid, "warning", text + arming.asks_again, "ack"))

    # decide

    def _serve_at_bases(self, decision: Decision) -> None:
        """Let vehicles land that are to land; bases speak to the vehicles that they charge, or keep books for
        others."""
        if decision.grounded != self.grounded:
            self.grounded = decision.grounded
            self._fleet_arming.ground(decision.grounded)
        for report in decision.giver_reports:
            self.command_queue.put(report.sysid, giver_messages(report, self.scenario.origin, self.time_ms))
        for sysid, joules in decision.booked.items():
            self.fleet.book(sysid, joules)

    def _prepare(self, snapshot: FleetSnapshot) -> None:
        """Go on with the check lists; a vehicle that fails its own is not armed."""
        under_way = self.preflight.under_way
        if not under_way:
            return
        for sysid, messages in self.preflight.decide(snapshot).items():
            self.command_queue.put(sysid, messages)
        for sysid in under_way:
            arming = self.arming[sysid]
            arming.checked = self.preflight.ended(sysid)
            arming.unfit = self.externals.ambiguous.get(sysid) or self.preflight.failed(sysid)
        self.events += self.preflight.pop_events()

    def _watch_missions(self, snapshot: FleetSnapshot) -> None:
        if not self.missions.flights:
            return
        for sysid, messages in self.missions.decide(snapshot, may_begin=self.targets_move).items():
            self.command_queue.put(sysid, messages)
        for sysid in self.missions.turned:
            self.command_queue.withdraw(sysid)

    def _fly(self, snapshot: FleetSnapshot, now_s: float) -> None:
        due = self._fleet_arming.due(snapshot.columns)
        if not due:
            return
        for sysid in due:
            if self.time_ms < self._join_ms[sysid]:
                continue
            view, arming = snapshot.vehicle(sysid), self.arming[sysid]
            before = arming.stage
            commands, requests = arming.decide(
                view, now_s, bound=self.schedule.bound(sysid), late_s=self._late_ms / 1e3
            )
            self._fleet_arming.asked(sysid, view)
            changed = arming.stage is not before
            if (changed and Stage.TAKEN in (arming.stage, before)) or any(command.is_order for command in commands):
                self.command_queue.withdraw(sysid)
            elif changed:
                self.command_queue.withdraw(sysid, (ARMING,))
            if changed and (event := stage_event(view, arming, before, now_s)) is not None:
                self.events.append(event)
            self.command_queue.put(sysid, requests)
            if commands:
                self.command_queue.ask_once(commands, now_s)

    def _keep_streams(self, snapshot: FleetSnapshot) -> None:
        if not self.externals.rules:
            return
        for sysid in self.externals.control.pop_taken():
            self.events.append(self.operator.obey({"command": "release", "sysid": sysid}, snapshot)[1])
        released = {sysid for sysid in self.externals.rules if self.arming[sysid].released}
        commands, messages = self.externals.decide(snapshot, released)
        for sysid, requests in messages.items():
            self.command_queue.put(sysid, requests)
        self.command_queue.ask(commands, snapshot.time_s)
        for sysid, why in self.externals.ambiguous.items():
            self.arming[sysid].unfit = why
        self.events += self.externals.pop_events()

    def _plan(
        self, snapshot: FleetSnapshot, decision: Decision, pursuing: Mapping[int, int] | None
    ) -> Sequence[SetPoint]:
        groups = self._fleet_arming.groups
        if not self.targets_move:
            ready = all(p.stage in _SETTLED for s, p in self.arming.items() if self._join_ms[s] == 0)
            self.targets_move = ready or self.time_s > self._wait_for_fleet_s
        return self.planner.plan(
            PlanRequest(
                snapshot,
                groups.steered,
                self._periods * self.scenario.clock.period_s,
                self.targets_move,
                decision.rendezvous,
                decision.approaches,
                pursuing,
                decision.stations,
                self.script.given(self.time_s),
                claims=self.missions.claims,
                takes_off=groups.takes_off,
            )
        )

    def _flown(self, set_points: Sequence[SetPoint]) -> Sequence[SetPoint]:
        """Set points of vehicles under our control."""
        yielded = self._fleet_arming.groups.yielded
        return [point for point in set_points if point.sysid not in yielded] if yielded else set_points

    # out

    def _grant_all(
        self,
        set_points: Sequence[SetPoint],
        snapshot: FleetSnapshot,
        relays: Mapping[int, list[Relay]],
        recording: TickRecord,
    ) -> None:
        """Send all vehicles the next bundle; the first one carries T = 0 and lets none move."""
        grant_ms = self.time_ms + self._periods * self.period_ms
        unix_us = self.epoch_us + 1000 * grant_ms
        recording.sent = self._sender.send(set_points, snapshot.columns, relays, self.time_ms, grant_ms, unix_us)
        self.sent += len(recording.sent)
        self.time_ms = grant_ms

    _periods = 0
    _beat_s = -math.inf
    """when external vehicles were last sent a HEARTBEAT after the last tick"""
    _partners: frozenset[tuple[int, int]] = frozenset()

    def hand_back(self) -> None:
        """Command external vehicles for the end, when they are not steered any more. `exchange` sends it."""
        self.command_queue.clear()
        stages = {sysid: arming.stage for sysid, arming in self.arming.items()}
        self.command_queue.ask(self.externals.hand_back(self.snapshot, stages), self.time_s)
        self.events += self.externals.pop_events()

    def report_disobedience(self) -> None:
        """Name the external vehicles that have not obeyed, now that the session no longer waits."""
        self.externals.report_disobedience(self.snapshot)
        self.events += self.externals.pop_events()

    def begin_putting_back(self) -> None:
        """Let external vehicles have the parameters that they had, now that they have their last order, and control
        too."""
        self.command_queue.ask(self.externals.control.give_back(), self.time_s)
        self.preflight.begin_putting_back(self.snapshot)

    @property
    def putting_back(self) -> bool:
        """Whether vehicles have yet to take back what they had, or to answer that."""
        return self.preflight.putting_back or self.command_queue.awaits(CONTROL)

    def report_put_back(self) -> None:
        """Say which vehicles have their own parameters again."""
        self.preflight.report_put_back(self.time_s)
        self.events += self.preflight.pop_events()

    def exchange(self, now_s: float) -> bool:
        """After the last tick: send external vehicles what is left, receive; whether one has not obeyed yet."""
        now_s = round(now_s, 3)  # as it is recorded
        unawaited = self.link.unawaited()
        received = self._receive([(list(unawaited), list(unawaited.values()))], now_s)
        self._receive_acknowledgements(now_s)
        sent: list[bytes] = []
        beats = now_s - self._beat_s >= 1.0
        self._beat_s = now_s if beats else self._beat_s
        for sysid in self.externals.rules:
            for result in self.command_queue.poll(sysid, now_s):
                self._report(sysid, result, now_s)
            messages = [*self.command_queue.pop(sysid), *self.preflight.put_back(sysid, now_s)]
            if beats:  # else they would take the station for lost, and fly home
                messages.append(OUR_HEARTBEAT)
            if (sysid, AUTOPILOT) in self.link.joined:
                sent += self.link.grant((sysid, AUTOPILOT), self.time_ms, 0, messages, ())
        self.sent += len(sent)
        self._record(TickRecord(round(1e3 * now_s), received.frames, sent, []))
        self.snapshot = self.fleet.snapshot(now_s)
        return self.externals.awaits(self.snapshot) or self.command_queue.awaits(ENDING)

    def _records(
        self, t_s: float, decision: Decision, set_points: Sequence[SetPoint]
    ) -> list[Mapping[str, Any] | TickSetPoints]:
        records, events = records_of_tick(
            t_s,
            decision,
            set_points,
            pursued=self.pursuit.records if self.pursuit else (),
            facts=self.fleet.pop_facts() if self.fleet.facts else (),
            problems=self._new_faults(t_s) if self._fallible else (),
            competition_states=self.schedule.competition_states,
        )
        self.events += events
        interventions = [*self.missions.pop_records(), *self.planner.pop_records()]
        if interventions:
            self.events += [event_of(record) for record in interventions]
        return [*self._new_records(), *interventions, *records]

    def _new_faults(self, t_s: float) -> list[PluginFault]:
        """Faults of planners and policies since the last call."""
        faults = [fault for one in self._fallible for fault in one.pop_faults()]
        self.goal_watch.late += [(t_s, f"{fault.policy} {fault.problem}") for fault in faults if fault.is_late]
        return faults

    def _new_records(self) -> list[dict[str, Any]]:
        """Records of a program's answers and acts, vehicles' own events and boots, faults, deaths and operators'
        commands since the last call."""
        deaths, self._deaths = self._deaths, []
        answered = [record for one in self._plugins for record in one.pop_records()]
        answered += [*self._texts.pop_records(), *self.externals.pop_records()]
        return answered + self.script.pop_records() + self.faults.pop_records() + deaths + self.operator.pop_records()

    def _record(self, recording: TickRecord) -> None:
        """Recording and hashing wait until the grants are out: the vehicles fly meanwhile."""
        recording.write(self._recorder, self.digest, self.epoch_us)
        if self._forwarder is not None:
            self._forwarder.send(recording.received)
