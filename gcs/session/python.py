"""A session from Python, watched:

    with gcs.Session("demo", lockstep=True) as session:
        for snapshot in session:
            ...
    print(session.summary.outcome_text)

and acted in:

    with gcs.Session("demo", lockstep=True) as session:
        snapshot = session.step()
        while snapshot.time_s < 60.0:
            snapshot = session.step({1: (p_ned, v_ned)})
        session.command(1, "return")

The same processes as `gcs run` starts, and the same folder left behind; here the loop's body sees every snapshot, and
in lockstep the fleet waits for it.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import socket
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Self

from numpy.typing import ArrayLike

from gcs.html_table import html_table
from gcs.planner.request import PursuerPlanner
from gcs.processes import plugin_process
from gcs.processes.python import current_folders
from gcs.recording.summary import FILE, Summary
from gcs.refuelling.policies import RefuellingPolicy
from gcs.scenario.document import path_of
from gcs.scenario.faults import Fault
from gcs.scenario.file import find, load
from gcs.scenario.model import Scenario
from gcs.scenario.parts.reach import reached
from gcs.scenario.parts.surroundings import Attractor, Obstacle
from gcs.scenario.parts.trust import digest_of, require
from gcs.scenario.parts.world import Change, changed, new_path
from gcs.scenario.plugins import PLANNER, POLICY
from gcs.session.arrays import SentCommand, Snapshot, from_message
from gcs.session.message_types import Reply
from gcs.session.program import acting
from gcs.session.program.messages import CHANGE, INJECT, NEXT, SEND, STOP, FleetMessage
from gcs.session.program.objects import Objects, without
from gcs.session.program.session_channel import SessionChannel
from gcs.session.program.truth_tail import Truth, TruthTails
from gcs.session.program.turn import SessionError, Turn
from gcs.session.program.world import Bodies
from gcs.session.spawning.spawner import SessionSpawner
from gcs.session.supervised import PATIENCE_S, RunError, Supervised, make_folder, write_scenario


@dataclass(frozen=True)
class ScenarioSource:
    """A scenario that a program may fly, and where its modules are looked for."""

    scenario: Scenario
    folders: Sequence[Path]


def source_of(
    scenario: str | os.PathLike[str] | Scenario, own: Mapping[str, object] | None = None, *, trust: bool = False
) -> ScenarioSource:
    """A session's scenario, read and agreed to, without the parts that are the program's `own`. Raises as `Session`."""
    folders, file, key = current_folders(), None, None
    if isinstance(scenario, Scenario):
        loaded = scenario
    else:
        file = find(path_of(scenario, "scenario", "a file, the name of a shipped one, or a gcs.Scenario"))
        loaded, key = load(file), digest_of(file)
        folders.insert(0, file.parent)
    loaded = without(loaded, own or {})
    require(loaded.name if file is None else str(scenario), reached(loaded), key, trust=trust)
    plugin_process.check(loaded, file, folders)
    return ScenarioSource(loaded, [folder.resolve() for folder in folders])


class Session:
    """One session; a context manager, and inside it an iterator of snapshots.

    scenario: a file, the name of a shipped one, or a `Scenario`. lockstep, speed, seed: instead of the scenario's, as
    `gcs run`'s options. out: the session's folder, which must not exist yet; `sessions/NAME-TIME` without it.
    every_s: session time between snapshots, a multiple of the scenario's clock.period_s; each period without it.

    On the real clock the fleet does not wait: a slow body misses snapshots. Ending the context before the session's
    end stops it and saves what was flown.

    In lockstep a program may also act: `step`, `command` and `inject`. What it does stands in decisions.jsonl, and the
    same acts make the same session, byte for byte (docs/protocol/socket.md#programs-that-act). One call at a time: a
    second one, by another thread or by the session's own planner or policy, raises SessionError.

    planner, policy: instead of the scenario's, a class that is made as CLASS(scenario) when the context begins, or an
    object with the method `plan`, or `choose` or `assign`; also one that a notebook defines. In lockstep only: they are
    called in this process while it waits for the session, without a deadline (docs/how-to/own-planner.md). What one
    raises holds the vehicle that it was asked about, and is raised again by `step` as the cause of a SessionError.

    spawner: a `gcs.SessionSpawner`, around a loop of sessions, of which each then begins sooner.

    trust: let the scenario use the code, programs, key files, devices and addresses that it names, which for a file is
    remembered until it changes, as of `--trust`. Raises TrustError where that has not been agreed to, ScenarioError,
    ValueError for options, SessionError.
    """

    def __init__(
        self,
        scenario: str | os.PathLike[str] | Scenario | ScenarioSource,
        *,
        lockstep: bool = False,
        speed: float | None = None,
        seed: int | None = None,
        out: str | os.PathLike[str] | None = None,
        every_s: float | None = None,
        planner: Callable[[Scenario], PursuerPlanner] | PursuerPlanner | None = None,
        policy: Callable[[Scenario], RefuellingPolicy] | RefuellingPolicy | None = None,
        trust: bool = False,
        spawner: SessionSpawner | None = None,
    ) -> None:
        if lockstep and speed is not None:
            raise ValueError("lockstep and speed exclude each other: lockstep is as fast as the machine can")
        given = {PLANNER: planner, POLICY: policy}
        self._given = {part: one for part, one in given.items() if one is not None}
        source = scenario
        if not isinstance(source, ScenarioSource):
            source = source_of(source, self._given, trust=trust)
        self.scenario = source.scenario.flown(lockstep=lockstep, speed=speed, seed=seed)
        if self._given and self.scenario.clock.mode != "lockstep":
            raise ValueError("planner and policy as objects need lockstep=True: else the fleet does not wait for them")
        self._objects: Objects | None = None
        period_ms = round(1e3 * self.scenario.clock.period_s)
        try:
            self._every_ms = period_ms if every_s is None else round(1e3 * every_s)
        except (TypeError, ValueError, OverflowError):
            self._every_ms = 0
        if self._every_ms <= 0 or self._every_ms % period_ms:
            raise ValueError(
                f"every_s is {every_s!r}; it must be a multiple of the scenario's period, {period_ms / 1e3} s"
            )
        self._modules = [str(folder) for folder in source.folders]
        self._spawner = spawner
        self._out = None if out is None else Path(path_of(out, "out"))
        self._folder: Path | None = None
        self._pid = 0
        """of the process that began it"""
        self._process: Supervised | None = None
        self._channel: SessionChannel | None = None
        self._turn = Turn()
        self._sysids = {vehicle.sysid for vehicle in self.scenario.vehicles.all}
        self._time_s: float | None = None
        """of the last snapshot"""
        self._sent: dict[int, SentCommand] = {}
        """commands without an outcome, by number"""
        self._numbers, self._ids = itertools.count(1), itertools.count(1)
        """of commands, and of requests"""
        self._unseen: list[FleetMessage] = []
        """snapshots that no call has returned yet: one that was interrupted returns none"""
        self._truth: TruthTails | None = None
        self._world = self.scenario
        """with what the program has changed"""
        self._summary: Summary | None = None
        self._broken: str | None = None
        """how it ended, where it has no summary"""

    @property
    def folder(self) -> Path:
        """Folder that the session leaves behind (docs/protocol/folder.md#session-folder)."""
        if self._folder is None:
            raise SessionError("the session has no folder before it begins; use it as `with Session(...) as session:`")
        return self._folder

    @property
    def summary(self) -> Summary:
        """Result: outcome, distances, energy, refuellings, digest. Raises SessionError before the end."""
        if self._summary is None:
            raise SessionError(
                self._broken or "the session has not ended: read `summary` after the loop, or after the with block"
            )
        return self._summary

    def __enter__(self) -> Self:
        if self._folder is not None:
            raise SessionError("a session flies once; make another one")
        if self._spawner is not None:
            self._spawner.check()
        self._objects = Objects(self._given, self.scenario) if self._given else None
        try:
            self._folder = make_folder(self._out, self.scenario.name).absolute()
            write_scenario(self._folder, self.scenario)
        except RunError as error:
            raise SessionError(error.message) from None
        ours, theirs = socket.socketpair()
        with theirs, contextlib.nullcontext() if self._objects is None else self._objects.theirs as asks:
            self._channel = SessionChannel(ours, self._objects)
            self._pid = os.getpid()
            try:
                self._process = self._supervised(theirs.fileno(), None if asks is None else asks.fileno())
            except BaseException:
                self._channel.close()
                raise
            self._process.close_in_forks()
        return self

    def _supervised(self, program: int, objects: int | None) -> Supervised:
        """Start the supervisor, with the descriptors that gcs.session.process.fly takes."""
        folder, every_ms = self.folder, self._every_ms
        if self._spawner is not None:
            start = partial(self._spawner.start, self.scenario, folder, program=program, objects=objects)
            return Supervised(folder, (), start=lambda _: start(modules=self._modules, every_ms=every_ms))
        words = ["--program", str(program), "--every-ms", str(every_ms)]
        words += [] if objects is None else ["--objects", str(objects)]
        words += [word for path in self._modules for word in ("--modules", path)]
        return Supervised(folder, words, (program,) if objects is None else (program, objects))

    def __iter__(self) -> Iterator[Snapshot]:
        self._check_flies()
        while (snapshot := self._next({})) is not None:
            yield snapshot

    def step(
        self, set_points: Mapping[int, ArrayLike] | None = None, commands: Iterable[tuple[Any, ...]] = ()
    ) -> Snapshot:
        """Fly on to the next snapshot, and return it; the first one is of time 0.

        set_points: (p_ned, v_ned) by system id, shape (2, 3): position (m) and velocity (m/s), common NED frame, where
        the vehicle is to be at the time of the snapshot that is returned, and how fast it is to move on from there.
        They take the place of the planner's in this step, and pass the safety filter and its limits as these do; with
        every_s longer than a period they are on their way there with their velocity. A vehicle that is not in offboard
        (on its way up, an operator's, down) is sent none, and `Snapshot.set_point_p_ned` says what was sent. Vehicles
        without one are the planner's. commands: arguments of `command`, given before the step.

        Raises ValueError for what makes no set point or command, SessionError where the session does not fly in
        lockstep, has ended, or refuses a command.
        """
        self._check_acts()
        points = {} if set_points is None else acting.checked_set_points(set_points, self._sysids)
        for one in acting.checked_commands(commands):
            self.command(*one)
        snapshot = self._next(points)
        if snapshot is None:
            raise SessionError(f"the session ended at {self._time_s or 0.0:g} s: it cannot be stepped any more")
        return snapshot

    def command(self, sysid: int, command: str | int, *params: float) -> SentCommand:
        """Command a vehicle, with the next tick.

        command: an operator's order (`hold`, `return`, `land`, `release`, `rejoin`, `refuel`, `skip`, and `retarget`
        with the new target's system id), as the console has them; or a MAV_CMD by name or number with up to 7
        parameters, sent in a COMMAND_LONG and again until it is acknowledged. The planner goes on with a vehicle that a
        MAV_CMD has put into another mode, unless it was given away by `release` before.

        The returned command gets its `outcome` while the session is stepped on; `Snapshot.acknowledged` lists the
        commands that have ended.
        Raises ValueError for what is no command, or a vehicle that is not there; SessionError where the session refuses
        it, or nothing can be commanded.
        """
        self._check_acts()
        sysid = acting.known(sysid, self._sysids)
        name, mav_cmd = acting.checked_command(command, params)
        if mav_cmd is not None:
            content = {"command": SEND, "mav_cmd": mav_cmd, "params": acting.checked_params(name, params)}
        elif params:
            content = {"command": name, "target": acting.known(params[0], self._sysids)}
        else:
            content = {"command": name}
        number = next(self._numbers)
        text = self._ask({**content, "sysid": sysid, "number": number})
        sent = self._sent[number] = SentCommand(number, sysid, name, text)
        return sent

    def inject(self, fault: Fault | Mapping[str, Any]) -> None:
        """Let a fault happen, with the next tick or at `at_s`.

        fault: one, `gcs.Fault(fault="motor", sysid=3)`, or the keys that a scenario gives it, {"fault": "motor",
        "sysid": 3} (docs/protocol/radio.md#faults); without `between_s` and `chance`, since nothing is drawn in flight.
        `kill` and `hang` need a vehicle with a process of its own. Raises ValueError for a vehicle that is not there,
        SessionError where there is no such fault, or it cannot befall that vehicle.
        """
        self._check_acts()
        self._ask({"command": INJECT, "fault": acting.keys_of(fault, self._sysids)})

    @property
    def obstacles(self) -> Bodies[Obstacle]:
        """Obstacles, which can be changed in flight: `session.obstacles.move("pillar", (4, 0, -5))`, `add`, `remove`.

        Planner, safety filter and goal heed them where they are from the next tick on, and so do page, report and
        replay. Vehicles that fly by themselves keep to those that they were launched with.
        """
        return Bodies("obstacle", lambda: self._world, self._change)

    @property
    def attractors(self) -> Bodies[Attractor]:
        """Points that draw pursuers, which can be changed as `obstacles` can."""
        return Bodies("attractor", lambda: self._world, self._change)

    def set_path(
        self, sysid: int, path_m: ArrayLike, *, closed: bool = False, laps: int = 1, speed_m_s: float | None = None
    ) -> None:
        """Let a target fly another path from the next tick on, from its first corner; it flies there straight.

        path_m: (k, 3) corners, common NED frame, m. closed, laps: as a scenario's. speed_m_s: along the path; as it was
        without it. Raises ValueError where the path cannot be flown, or the vehicle is no target.
        """
        self._change(new_path(self._world, acting.known(sysid, self._sysids), path_m, closed=closed, laps=laps,
                              speed_m_s=speed_m_s))  # fmt: skip

    def _change(self, change: Change) -> None:
        self._check_acts()
        world = changed(self._world, change)
        self._ask({"command": CHANGE, "change": change})
        self._world = world

    @property
    def truth(self) -> Truth:
        """Motion and energy of the vehicles at the last snapshot's time, by their own records, whatever they report.

        Raises SessionError before the first snapshot, and where the scenario has `truth: false`.
        """
        if self._time_s is None:
            raise SessionError("there is no truth before the first snapshot: call step, or read it in the loop")
        if not self.scenario.truth:
            raise SessionError("the scenario has truth: false, so that its vehicles leave none: take that out")
        if self._truth is None:
            self._truth = TruthTails(self.folder, sorted(self._sysids))
        truth = self._truth.at(self._time_s)
        if not self._open:
            self._truth.close()
        return truth

    def _repr_html_(self) -> str:
        if self._summary is not None:
            state = self._summary.outcome_text
        elif self._time_s is None:
            state = "has not begun"
        else:
            state = f"in flight at {self._time_s:.1f} s"
        rows = [("scenario", self.scenario.name), ("clock", self.scenario.clock.mode), ("state", state)]
        return html_table(rows if self._folder is None else [*rows, ("folder", self._folder)])

    def _check_flies(self) -> None:
        self._check_process()
        if self._summary is not None:
            raise SessionError(f"the session ended at {self._time_s or 0.0:g} s: make another one")
        if self._channel is None:
            raise SessionError("the session does not fly; use it as `with Session(...) as session:`")
        if not self._open:
            raise SessionError(self._broken or "the session flies on to its end by itself: call `finish`")

    def _check_process(self) -> None:
        if self._pid not in (0, os.getpid()):
            raise SessionError("the session is that of the process that began it, of which this is a fork")

    def _check_acts(self) -> None:
        if self.scenario.clock.mode != "lockstep":
            raise SessionError(
                "step, command, inject and changes need Session(..., lockstep=True): else the fleet does not wait"
            )
        self._check_flies()

    @property
    def _open(self) -> bool:
        """Whether the session flies, as far as is known."""
        return self._channel is not None and not self._channel.closed

    def _exchange(self, content: Mapping[str, Any]) -> FleetMessage | Reply | None:
        """The session's answer; None where it has ended, and its summary is there then.

        Before it come those to calls that were interrupted, as by Ctrl-C: what they asked for is carried out.
        """
        assert self._channel is not None
        with self._turn:
            request = next(self._ids)
            self._channel.say({**content, "id": request})
            while (line := self._channel.receive()) is not None:
                if isinstance(line, FleetMessage):
                    self._unseen.append(line)
                if line.id == request:
                    return line
            self._end()
        return None

    def _next(self, points: Mapping[int, list[float]]) -> Snapshot | None:
        """The next snapshot; None at the end."""
        if self._exchange({"command": NEXT, "set_points": points} if points else {"command": NEXT}) is None:
            return None
        messages, self._unseen = self._unseen, []
        message = messages[-1]
        message.events = [row for one in messages for row in one.events]
        self._time_s = message.t_s
        ended = []
        for row in (row for one in messages for row in one.acknowledged):
            if (sent := self._sent.pop(row.number, None)) is not None:
                sent.outcome, sent.result = row.outcome, row.result
                ended.append(sent)
        if self._objects is not None and (failed := self._objects.pop_raised()) is not None:
            raise SessionError(f"{failed[0]} failed at {message.t_s:g} s: {failed[1]!r}") from failed[1]
        return from_message(message, tuple(ended))

    def _ask(self, content: Mapping[str, Any]) -> str:
        """The session's answer to a request. Raises SessionError where it refuses, or has ended."""
        reply = self._exchange(content)
        if reply is None:
            raise SessionError(f"the session ended at {self._time_s or 0.0:g} s: nothing can be asked of it any more")
        assert isinstance(reply, Reply)
        if not reply.ok:
            raise SessionError(reply.text)
        return reply.text

    def finish(self) -> Summary:
        """Fly on to the end without looking, and return the summary."""
        self._check_process()
        with self._turn:
            self._end()
        return self.summary

    def stop(self) -> Summary:
        """End the session now, save what was flown, and return the summary; its outcome is `interrupted`."""
        self._check_process()
        if self._open and self._channel is not None and self._summary is None:
            with self._turn:
                self._channel.say({"command": STOP})
                self._end(time.monotonic() + PATIENCE_S[0])
        return self.summary

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        assert self._process is not None
        if self._pid != os.getpid():
            return
        try:
            if self._open:
                with contextlib.suppress(SessionError) if kind is not None else contextlib.nullcontext():
                    self.stop()
        finally:
            if self._channel is not None:
                self._channel.close()
            if self._objects is not None:
                self._objects.close()
            self._process.__exit__()
            if self._truth is not None:
                self._truth.close()

    def _end(self, deadline_s: float = float("inf")) -> None:
        """Wait for the supervisor's last word and read the summary. Raises SessionError where there is none."""
        process, channel = self._process, self._channel
        if process is None or channel is None or self._summary is not None:
            return
        if deadline_s == float("inf"):
            channel.finish()
        while not process.ended and time.monotonic() < deadline_s:
            channel.await_word(process.death)
            process.read()
        process.read()
        channel.close()
        verdict = process.verdict
        if verdict is None:
            how = "was stopped" if process.status is None else f"ended with status {process.status}"
            self._broken = f"the supervisor {how} before the session's end; its files are in {self.folder}"
        else:
            self._broken = verdict.get("error")
        if self._broken:
            raise SessionError(self._broken)
        self._summary = Summary.model_validate_json((self.folder / FILE).read_text(encoding="utf-8"))
