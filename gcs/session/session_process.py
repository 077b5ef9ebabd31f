"""One session from its first process to its summary: link, recorder, supervisor and server, on its clock."""

from __future__ import annotations

import contextlib
import math
import os
import signal
import time
from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from gcs.link.link import Link
from gcs.link.lockstep import REPEAT_S
from gcs.link.socket import BUFFER_BYTES
from gcs.mavlink.ids import AUTOPILOT, TRAFFIC
from gcs.planner.returns.warnings import given_heights
from gcs.processes.fork_server import Ended
from gcs.processes.pace import Pace
from gcs.processes.suspension import SuspensionWatch
from gcs.recording.recorder import Recorder, RecorderError, reason
from gcs.recording.reserve import Reserve
from gcs.recording.summary import FILE as SUMMARY
from gcs.scenario import goal
from gcs.scenario.file import dump
from gcs.scenario.model import Scenario
from gcs.scenario.plugins import PluginClient
from gcs.session.arrival import WATCH_EVERY_S, BadVehicleError, ForkServerDied, SessionFailed, arriving
from gcs.session.commands import Clients
from gcs.session.link_notices import LinkNotices
from gcs.session.messages import end_message, kept_of_snapshot, session_message, snapshot_message
from gcs.session.own_vehicles import OwnVehicles
from gcs.session.parent import explained, has_gone, say
from gcs.session.program.channel import Program
from gcs.session.replaced import OldParameters, OldPlans
from gcs.session.server import Publisher
from gcs.supervisor import summarise
from gcs.supervisor.supervisor import Supervisor
from gcs.telemetry.events import Event, Kind, Level
from skytender.exit import BAD_INPUT, DONE, INTERRUPTED, NOT_DONE
from skytender.processes import printable

if TYPE_CHECKING:
    from gcs.link.external import ExternalLink
    from gcs.link.forwarder import Forwarder

PUBLISH_EVERY_S = 0.1
SAY_WAITING_EVERY_S = 5.0
GIVE_UP_S, GIVE_UP_SOON_S = 60.0, 5.0
"""Time that the session stands still for a process that lives but does not answer, in wall time; the second is with
external vehicles, which fly on meanwhile."""
HAND_BACK_S = 2.5
"""Time that external vehicles have at the end to obey; their HEARTBEAT, once a second, shows that they do."""
PUT_BACK_S = 6.0
"""Time that they have then to take the parameters that they had."""


class _Stopped(Exception):
    """The session's end was asked for."""


class SessionProcess:
    """One session, from the first process to the summary."""

    def __init__(
        self,
        folder: Path,
        scenario: Scenario,
        vehicles: OwnVehicles,
        *,
        plugins: Mapping[str, PluginClient] = MappingProxyType({}),
    ) -> None:
        """vehicles: those that the scenario launches, which are coming up. plugins: by key the processes of a planner
        and policy that are not Skytender's. Raises ScenarioError."""
        self._vehicles = vehicles
        self._folder = folder
        self._scenario = scenario
        external = scenario.vehicles.external
        self._external_link: ExternalLink | None = None
        clock = scenario.clock
        speed = None if clock.mode == "lockstep" else clock.speed
        self._pace = Pace(speed, time.monotonic, keeps_up=bool(external))
        self._lockstep_link = vehicles.link
        self._link: Link = self._lockstep_link
        if external:
            from gcs.link.external import ExternalLink  # noqa: PLC0415 - most sessions have none
            from gcs.link.fleet import FleetLink  # noqa: PLC0415

            self._external_link = ExternalLink(external, lambda: self._pace.running_s, scenario.station.ids)
            self._link = FleetLink(self._lockstep_link, self._external_link)
        self._forwarder: Forwarder | None = None
        if scenario.forward.to:
            from gcs.link.forwarder import Forwarder  # noqa: PLC0415 - the same

            self._forwarder = Forwarder(scenario.forward.to)
        self._notices = LinkNotices(self._link, self._external_link, self._forwarder)
        self._sleep = time.sleep if self._external_link is None else self._external_link.rest
        record = scenario.record
        self._recorder = Recorder(
            folder,
            rotate_bytes=None if record.rotate_mb is None else record.rotate_mb * 1_000_000,
            keep=record.keep,
            changes_only=record.decisions == "changes",
        )
        self._reserve = Reserve(folder, len(scenario.vehicles.all))
        self._shown = scenario
        """world that clients are shown"""
        self._publisher = Publisher(folder, session_message(scenario, printable(folder.resolve())))
        self._supervisor = Supervisor(scenario, self._link, self._recorder, forwarder=self._forwarder, plugins=plugins)
        self._supervisor.faults.signal_process = self._signal
        self._unpublished: list[Event] = []
        self.program: Program | None = None
        """the program in Python that steps the session; not a client of the socket"""
        self._clients = Clients(self._publisher, self._supervisor, self._pace)
        self._labels = {v.sysid: v.label for v in scenario.vehicles.all} | {255: "traffic"}
        self._blocks = {order.sysid: order.sysids for order in vehicles.orders}
        self._killed: set[int] = set()
        """whose process a fault has ended"""
        self._answered_s = self._said_waiting_s = math.inf
        self._suspension = SuspensionWatch()
        self._published_s = self._watched_s = 0.0
        self._old_parameters, self._old_plans = OldParameters(folder), OldPlans(folder)
        self._phase = "starting"
        self.begun = False
        """whether anything has flown"""
        self._wall_time_s = 0.0
        self._terminated = False
        self.outcome: str | None = None
        """as it stands in the summary; None where there is none"""
        self.error: str | None = None
        """why the session broke off, where it did"""

    def terminate(self, *_: object) -> None:
        """End the session in order, soon; a handler of SIGTERM, as when the machine shuts down."""
        self._terminated = True

    def run(self) -> int:
        """Fly the session; the exit status. Clients' last line says how it ended, or why it broke off."""
        try:
            return self._run()
        except Exception as problem:
            status, self.error = explained(problem, self._folder, begun=self.begun)
            self._publisher.publish(end_message(self.outcome, status, self.error))
            return status
        finally:
            self._link.close()
            if self._forwarder is not None:
                self._forwarder.close()
            self._publisher.close()

    def _run(self) -> int:
        """The session to its end; the exit status. Raises SessionError, LaunchError, RecorderError, OSError."""
        try:
            with self._recorder:
                say({"listening": True})
                interrupted = self._fly_fleet()
                self._supervisor.judge(self._folder)
            outcome, text = self._outcome(interrupted)
            self._summarise(outcome, text)
            self._phase = "ended"
            status = INTERRUPTED if interrupted else DONE if outcome == goal.MET else NOT_DONE
            self._publish()
            self._publisher.publish(end_message(outcome, status, text))
            return status
        except (SessionFailed, RecorderError) as problem:
            if self.begun:
                died = isinstance(problem, ForkServerDied)
                with contextlib.suppress(OSError):  # a full disk may have no room for it either
                    why = "lost every vehicle: their fork server has died" if died else "the session broke off"
                    self._summarise("lost" if died else goal.INTERRUPTED, f"not met: {why}")
            raise

    def _summarise(self, outcome: str, text: str) -> None:
        self._reserve.release()
        summarise.summarise(
            self._supervisor,
            self._link,
            outcome=outcome,
            outcome_text=text,
            completed=self._supervisor.time_ms >= round(1e3 * self._scenario.goal.duration_s),
            wall_time_s=self._wall_time_s,
            lag_s=self._pace.lag_s,
        ).write(self._folder)
        self.outcome = outcome

    def _fly_fleet(self) -> bool:
        """The session from its first process to its last; True where it was interrupted."""
        try:
            self._await_fleet()
            self._fly()
        except _Stopped:
            self._supervisor.stop()
            return True
        finally:
            self._wall_time_s = self._pace.running_wall_s if self.begun else 0.0
            if self.begun and self._scenario.vehicles.external:
                self._hand_back()
            self._vehicles.end()
        return False

    def _hand_back(self) -> None:
        """External vehicles must not be left in offboard without control."""
        supervisor = self._supervisor
        supervisor.hand_back()
        deadline_s = time.monotonic() + HAND_BACK_S
        with contextlib.suppress(RecorderError):  # it has been reported, or will be; what matters now is sent before
            while supervisor.exchange(self._pace.running_s):
                if time.monotonic() > deadline_s:
                    supervisor.report_disobedience()
                    break
                self._sleep(WATCH_EVERY_S)
            supervisor.begin_putting_back()
            deadline_s = time.monotonic() + PUT_BACK_S
            while supervisor.putting_back and time.monotonic() < deadline_s:
                supervisor.exchange(self._pace.running_s)
                self._sleep(WATCH_EVERY_S)
            supervisor.report_put_back()

    # start

    def _await_fleet(self) -> None:
        if self._link.buffer_bytes < BUFFER_BYTES:
            granted = f"{self._link.buffer_bytes >> 10} KiB"
            self._event(0, "warning", f"The kernel grants a receive buffer of {granted}, not 4 MiB: raise rmem_max")
        for text in given_heights(self._scenario):
            self._event(0, "warning", text)
        vehicles = self._scenario.vehicles.launched
        self._lockstep_link.expect(self._vehicles.keys)
        self._lockstep_link.compare_clocks((v.sysid, AUTOPILOT) for v in vehicles if v.is_foreign)
        for notices in arriving(self._scenario, self._labels, self._link, self._lockstep_link, self._external_link):
            for sysid, text in notices:
                self._event(sysid, "info", text)
            self._watch()

    # fly

    def _fly(self) -> None:
        supervisor, pace = self._supervisor, self._pace
        self._phase = "flying"
        self.begun = True
        self._answered_s = self._said_waiting_s = time.monotonic()
        if self._scenario.vehicles.external:
            self._begin_on_true_time()
        self._link.begin()
        supervisor.begin()
        pace.start()  # of a full fleet's first bundles none is late
        end_ms = round(1e3 * self._scenario.goal.duration_s)
        while supervisor.time_ms < end_ms and self._link.joined:
            self._await_program()
            supervisor.tick(self._watch, lambda: pace.next(self._scenario.clock.period_s))
            self._keep_room()
            if supervisor.preflight.under_way and self._external_link is not None:
                self._old_parameters.keep(supervisor.preflight.before())
                self._old_plans.keep(supervisor.preflight.plans_before(), supervisor.snapshot.vehicle)
            self._answered_s = self._said_waiting_s = time.monotonic()
            if time.monotonic() - self._watched_s >= WATCH_EVERY_S:
                self._watch()
            self._show_program()
            self._wait()
        self._await_program()
        supervisor.finish(self._watch)
        self._show_program()

    def _keep_room(self) -> None:
        """Keep room on the disk for the summary, which grows; where there is none, the disk is full."""
        try:
            self._reserve.keep_for(self._supervisor.schedule.services)
        except OSError as error:
            raise RecorderError(f"{self._folder} has no room for {SUMMARY}: {reason(error)}; recording ends.") from None

    def _begin_on_true_time(self) -> None:
        """Let session time 0 be now: autopilots' own logs, beside which the recording is laid, are on the true time."""
        now = datetime.fromtimestamp(time.time_ns() // 1_000_000 / 1e3, UTC)
        clock = self._scenario.clock.model_copy(update={"epoch": now})
        self._supervisor.epoch_us = round(1e6 * now.timestamp())
        path = self._folder / "scenario.yaml"
        new = path.with_name("scenario.yaml.new")
        new.write_text(dump(self._scenario.model_copy(update={"clock": clock})), encoding="utf-8")
        new.replace(path)

    def _wait(self) -> None:
        """Until the next tick is due, or while the session is paused, serve the clients."""
        repeat_s = time.monotonic() + REPEAT_S
        while self._pace.paused or (left_s := self._pace.wait_s()) > 0.0:
            self._sleep(min(WATCH_EVERY_S, WATCH_EVERY_S if self._pace.paused else left_s))
            self._watch()
            if time.monotonic() >= repeat_s:
                self._link.repeat()
                repeat_s = time.monotonic() + REPEAT_S

    def _await_program(self) -> None:
        """Let a program say what it wants; in lockstep the session stands still until it has asked to go on."""
        program = self.program
        if program is None:
            return
        repeat_s = time.monotonic() + REPEAT_S
        blocks = self._blocks.values()
        program.serve(self._supervisor, blocks, 0.0)
        while program.awaited:
            if program.serve(self._supervisor, blocks, WATCH_EVERY_S):
                continue
            self._answered_s = self._said_waiting_s = time.monotonic()  # it is no vehicle that is waited for
            self._watch()
            if time.monotonic() >= repeat_s:
                self._link.repeat()
                repeat_s = time.monotonic() + REPEAT_S
        if program.stops:
            raise _Stopped

    def _show_program(self) -> None:
        """Give a program the snapshot that it has asked for."""
        if self.program is not None and self.program.wants(self._supervisor.snapshot.time_s):
            self._gather_events()
            self.program.give(self._supervisor)

    def _watch(self) -> None:
        """Deaths, operators, the parent's pipe; and a fresh snapshot for clients."""
        self._watched_s = now_s = time.monotonic()
        if away_s := self._suspension.look():
            self._go_on_after(away_s)
        for end in self._vehicles.ended():
            self._lose(end)
        if self._vehicles.died:
            raise ForkServerDied
        if now_s - self._said_waiting_s >= SAY_WAITING_EVERY_S and not self._pace.paused:
            self._said_waiting_s = now_s
            self._wait_for(now_s - self._answered_s)
        if self._terminated:
            self._event(0, "warning", "The supervisor received SIGTERM: the session stops")
        if self._clients.serve() or has_gone() or self._terminated:
            raise _Stopped
        for sysid, level, text in self._notices.poll(now_s, begun=self.begun):
            self._event(sysid, level, text, "link")
        if now_s - self._published_s >= PUBLISH_EVERY_S:
            if not self._folder.is_dir():  # files that are open would be written to the end, for no reader
                raise RecorderError(f"{self._folder} is gone.")
            self._published_s = now_s
            self._publish()

    def _go_on_after(self, away_s: float) -> None:
        """The supervisor did not run for so long: no vehicle counts as silent for that time."""
        now_s = time.monotonic()
        if not self.begun:
            return  # there is no session yet that could have stood still
        self._answered_s = self._said_waiting_s = now_s
        external = bool(self._scenario.vehicles.external)
        if external:
            self._supervisor.recovery.returned(self._supervisor.time_s)
        how = "the external vehicles flew on without it" if external else "the session stood still, and goes on"
        self._event(0, "warning", f"The supervisor was suspended for {away_s:.0f} s: {how}")

    def _wait_for(self, waited_s: float) -> None:
        """Say whose answer the session waits for; after a minute, go on without them."""
        for key in self._link.awaited:
            label = self._labels.get(key[0], f"vehicle {key[0]}")
            if key[0] in self._supervisor.hung:  # no wait: it is known to hang
                self._supervisor.lose(key, f"{label} hangs, and is given up")
                continue
            if waited_s < (GIVE_UP_SOON_S if self._scenario.vehicles.external else GIVE_UP_S):
                self._event(
                    key[0], "warning", f"{label} lives but has not answered for {waited_s:.0f} s of wall time", "link"
                )
                continue
            self._supervisor.lose(key, f"{label} lives but has not answered for {waited_s:.0f} s: given up")

    def _lose(self, end: Ended) -> None:
        sysids = self._blocks.get(end.sysid, (end.sysid,))
        sentence = end.sentence(", ".join(self._labels.get(sysid, f"vehicle {sysid}") for sysid in sysids))
        if self._phase == "starting":
            raise (BadVehicleError if end.status == BAD_INPUT else SessionFailed)(sentence)
        for sysid in sysids:
            if sysid in self._killed:
                continue
            self._supervisor.lose(TRAFFIC if sysid == TRAFFIC[0] else (sysid, AUTOPILOT), sentence)

    def _signal(self, sysid: int, fault: str) -> None:
        """Let a fault befall a vehicle's process: it is the only one in it."""
        if fault == "kill":
            self._killed.add(sysid)
        for pid, first in self._vehicles.pids.items():
            if first == sysid:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL if fault == "kill" else signal.SIGSTOP)

    def _event(self, sysid: int, level: Level, text: str, kind: Kind = "session") -> None:
        self._supervisor.events.append(Event(self._supervisor.time_s, sysid, level, text, kind))

    # publish

    def _outcome(self, interrupted: bool) -> tuple[str, str]:
        """`met`, the first part of the goal that was not, or `interrupted`; and the same as a sentence."""
        supervisor = self._supervisor
        if not interrupted:
            outcome, text = goal.verdict(supervisor.judged())
            return outcome, text + supervisor.faults_text()
        text = f"interrupted at {supervisor.time_s:.1f} s"
        broken = [one.text for one in supervisor.goal_watch.broken()]
        return goal.INTERRUPTED, f"{text}; {goal.outcome_text(broken)}" if broken else text

    def _gather_events(self) -> None:
        """New events, for the next snapshot and for the program's."""
        events, self._supervisor.events = self._supervisor.events, []
        self._unpublished += events
        if self.program is not None:
            self.program.remember(events)

    def _publish(self) -> None:
        """Send clients a snapshot, with the events since the last one; where there are none, these are kept."""
        self._gather_events()
        if self._supervisor.worlds.now is not self._shown:
            self._shown = self._supervisor.worlds.now
            self._publisher.greet(session_message(self._shown, printable(self._folder.resolve())))
        events, self._unpublished = self._unpublished, []
        if self._publisher.watched:
            self._publisher.publish(self._snapshot(events))
        else:
            self._publisher.remember(kept_of_snapshot(self._supervisor, events))

    def _snapshot(self, events: Sequence[Event]) -> dict[str, Any]:
        supervisor = self._supervisor
        wall_s = self._pace.running_wall_s if self.begun else 0.0
        return snapshot_message(
            supervisor,
            phase="paused" if self._pace.paused else self._phase,
            speed=supervisor.time_s / wall_s if wall_s > 0.0 else 0.0,
            refuelled=len(supervisor.schedule.refuelled),
            events=events,
            unanswered_s=self._unanswered_s(),
        )

    def _unanswered_s(self) -> dict[int, float]:
        """Vehicles that the session stands still for, and for how long, in wall time."""
        if not self.begun or self._pace.paused:
            return {}
        waited_s = time.monotonic() - self._answered_s
        return {sysid: waited_s for sysid, _ in self._link.awaited}
