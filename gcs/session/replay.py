"""A recording, played: an observer that is fed what was recorded, at any speed, from any time on.

A session's folder gives more than its frames: the scenario's roles and obstacles, and the decisions with their reasons.
What is missing of it is said, and the rest is played.
"""

from __future__ import annotations

import contextlib
import math
import time
from collections.abc import Callable, Collection, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from gcs.missions.items import MissionPlan
from gcs.processes.looks import SETTLED_S, Looks
from gcs.recording import rotation
from gcs.recording.missing import SCENARIO, passed_over, unread
from gcs.recording.plans import PlansReader
from gcs.recording.pursuit_held import HeldTimesReader
from gcs.recording.recorder import DECISIONS, TLOG
from gcs.recording.summary import FILE as SUMMARY
from gcs.recording.summary import Summary
from gcs.recording.tlog_walk import Chunk
from gcs.scenario.file import load
from gcs.scenario.model import Scenario, ScenarioError
from gcs.session.message_types import ReplayRow, SnapshotMessage
from gcs.session.messages import plan_row, reply_message
from gcs.session.observer import Observer
from gcs.session.timeline import Timeline
from gcs.session.tlog_index import RecordedFrame, TlogIndex
from gcs.telemetry.events import Event
from gcs.telemetry.state import FleetSnapshot

FASTEST = 1000.0
DECIDED, INDEXED = 0.25, 0.9
"""Share of the time that opening a session takes which is gone when its decisions, and its frames, have been read."""
SNAPSHOT_EVERY_S = 0.1
"""of wall time, as from a session"""
SILENCE_S = 60.0
"""In a replay without waiting, a longer time in which nothing was recorded is passed over."""
PATIENCE_S = 0.05
"""Wall time that one call may take to keep up; what is faster than the machine goes as fast as that."""

Message = Mapping[str, Any]


class ReplayError(Exception):
    """There is nothing to play; one sentence."""


class Replay:
    """A recording and the fleet in it, at `t_s` of it. Raises ReplayError, OSError.

    source: a session's folder, or a .tlog file. plans: further ones to be shown, by their names. block_bytes: as of a
    `TlogIndex`. `problems`: what could not be read, a sentence each.
    """

    def __init__(
        self,
        source: Path,
        progress: Callable[[float], None] = lambda _: None,
        *,
        plans: Mapping[str, MissionPlan] = MappingProxyType({}),
        block_bytes: int | None = None,
    ) -> None:
        self.problems: list[str] = []
        self._scenario: Scenario | None = None
        self._timeline: Timeline | None = None
        self._folder = str(source.resolve()) if source.is_dir() else None
        self.name = source.resolve().name if source.is_dir() else source.name
        path, epoch_us = source, None
        if source.is_dir():
            path = source / TLOG
            epoch_us = self._read_session(source, lambda share: progress(DECIDED * share))
        if not rotation.exists(path):
            missing = f"{source} has no {TLOG}" if source.is_dir() else f"{source} does not exist"
            raise ReplayError(f"{missing}; give a session's folder or a .tlog file.")
        reader: HeldTimesReader | None = None
        if self._scenario is not None and self._timeline is not None:
            reader = HeldTimesReader(self._scenario, self._timeline.chases)
        plans_reader = PlansReader()

        def watch(chunk: Chunk) -> None:
            plans_reader.add(chunk)
            if reader is not None:
                reader.add(chunk)

        begin, end = (DECIDED, INDEXED) if source.is_dir() else (0.0, 1.0)
        self._recording = TlogIndex(
            path,
            epoch_us=epoch_us,
            session=source.is_dir(),
            block_bytes=block_bytes,
            metered=self._scenario.vehicles.foreign if self._scenario else (),
            progress=lambda share: progress(begin + (end - begin) * share),
            watch=watch,
        )
        self._given_plans, self._plans = plans, plans_reader.plans(self._recording.zero_s)
        self.problems += self._recording.problems
        if not self._recording.frames:
            raise ReplayError(" ".join(self._recording.problems) or f"{path} holds no MAVLink frame.")
        self._pursuit: Callable[[float], float] | None = None
        if reader is not None and self._timeline is not None:
            reader.finish()
            self._pursuit = reader.held_times()
            self._timeline.see_landings(reader.recorded)
        progress(1.0)
        self.from_s, self.to_s = self._recording.from_s, self._recording.to_s
        self._wanted: frozenset[int] = frozenset()
        self.seek(self.from_s)

    def seek(self, t_s: float, *, reported_s: float = math.inf) -> None:
        """Go to a time of the recording: what is known then is known; decisions after `reported_s` are reported."""
        t_s = min(max(t_s, self.from_s), self.to_s)
        observer = Observer("replay", self.name, scenario=self._scenario, folder=self._folder)
        observer.duration_s = self.to_s if self._scenario is None else self._scenario.goal.duration_s
        observer.inspection.want(self._wanted)
        self.observer, self.t_s = observer, self.from_s
        self._happened = 0
        self._planned_until_s = self._plans.next_change_s(-math.inf)
        for recorded in self._recording.before(t_s):
            self._take(recorded, counted=False)
        observer.resume(self._recording.gaps_before(t_s), t_s)
        self._looks = Looks(after_s=t_s, settled_s=SETTLED_S)
        self._frames: Iterator[RecordedFrame] = self._recording.play(t_s)
        self._next: RecordedFrame | None = next(self._frames, None)
        self.advance(t_s, math.inf)
        self._look(t_s)
        observer.pop_events()  # no client was there to see them
        self._reported_until_s = min(t_s, reported_s) if t_s > self.from_s else -math.inf

    def advance(self, t_s: float, until_wall_s: float) -> bool:
        """Play on up to a time of the recording, or of the wall clock; whether the former was reached."""
        count = 0
        while self._next is not None and self._next.t_s <= t_s:
            if self._next.t_s > self._looks.due_s:
                self._look_before(self._next.t_s)
            self._take(self._next)
            self.t_s = self._next.t_s
            self._next = next(self._frames, None)
            count += 1
            if count % 64 == 0 and time.monotonic() > until_wall_s:
                return False
        self.t_s = max(self.t_s, min(t_s, self.to_s))
        self._look_before(math.nextafter(self.t_s, math.inf))
        if self.ended:
            self._look(self.t_s)
        self._see_what_happened(self.t_s)
        if self._timeline is not None and (world := self._timeline.worlds.at(self.t_s)) is not self.observer.scenario:
            self.observer.scenario, self.observer.changed = world, True
        return True

    def _look_before(self, t_s: float) -> None:
        """Look at the fleet at each time before `t_s` at which that is due; all frames until then have been taken."""
        for due_s in self._looks.before(t_s):
            self._look(due_s)

    def _look(self, t_s: float) -> None:
        self._see_what_happened(t_s)
        if self._timeline is not None:
            self._timeline.show(self.observer, t_s)
        self.observer.look(t_s)

    def _take(self, recorded: RecordedFrame, *, counted: bool = True) -> None:
        self._see_what_happened(recorded.t_s)
        if recorded.sent:
            self.observer.receive_sent(recorded.frame)
        else:
            self.observer.receive(recorded.frame, recorded.t_s, counted=counted)

    @property
    def silence_s(self) -> float:
        """How long nothing more comes, from where it is."""
        return (self.to_s if self._next is None else self._next.t_s) - self.t_s

    @property
    def ended(self) -> bool:
        """Whether there is nothing left to play."""
        return self._next is None and self.t_s >= self.to_s

    def inspect(self, sysids: Collection[int]) -> None:
        """Let snapshots hold everything that these vehicles send."""
        self._wanted = frozenset(sysids)
        self.observer.inspection.want(self._wanted)

    def session(self) -> dict[str, Any]:
        """The message of type "session"."""
        self._show_plans()
        line = self.observer.session()
        return line if self._timeline is None else line | {"contest": self._timeline.contest(self.t_s)}

    def _show_plans(self) -> None:
        """Let the observer show vehicles' present plans and the given ones, once the common frame is known."""
        origin = self.observer.origin
        if origin is None:
            return
        shown = [plan_row(plan, name, None, origin, None) for name, plan in self._given_plans.items()]
        for sysids, plan, home_alt_m in self._plans.at(self.t_s):
            name = f"vehicle{'s' if len(sysids) > 1 else ''} {', '.join(map(str, sysids))}"
            shown.append(plan_row(plan, name, sysids[0] if len(sysids) == 1 else None, origin, home_alt_m))
        self.observer.plans = shown
        self._planned_until_s = self._plans.next_change_s(self.t_s)

    def snapshot(self, *, speed: float | None, paused: bool = False) -> dict[str, Any]:
        """The message of type "snapshot" at `t_s`, with the events since the last one; no speed: without waiting."""

        def amend(line: SnapshotMessage, view: FleetSnapshot) -> None:
            line.replay = ReplayRow(self.from_s, self.to_s, speed, paused)
            if self._timeline is not None:
                self._timeline.fill(line, view, self._pursuit(self.t_s) if self._pursuit is not None else None)

        if self._timeline is not None:
            for event in self._timeline.events(self._reported_until_s, self.t_s):
                self.observer.add_event(event)
            self._timeline.show(self.observer, self.t_s)
        self._reported_until_s = self.t_s
        if self.t_s >= self._planned_until_s and self.observer.origin is not None:
            self.observer.changed = True
        phase = "ended" if self.ended else "paused" if paused else "flying"
        return self.observer.snapshot(self.t_s, speed=speed, phase=phase, amend=amend)

    def _see_what_happened(self, t_s: float) -> None:
        """Let vehicles die, and energy be booked, that did so by a time of the recording."""
        if self._timeline is not None:
            self._happened = self._timeline.let_happen(self.observer, self._happened, t_s)

    def _read_session(self, folder: Path, progress: Callable[[float], None]) -> int | None:
        """Scenario and decisions, as far as they are there; the session's epoch."""
        lost = "roles, obstacles and decisions are not shown."
        try:
            self._scenario = load(folder / SCENARIO)
        except (OSError, ScenarioError) as error:
            self.problems.append(unread(folder / SCENARIO, error, lost))
            return None
        self.name = self._scenario.name
        try:
            self._timeline = Timeline(folder / DECISIONS, self._scenario, progress)
        except OSError as error:
            self.problems.append(unread(folder / DECISIONS, error, "decisions are not shown."))
        else:
            with contextlib.suppress(OSError, ValueError):  # as after a session that was killed
                self._timeline.end(Summary.model_validate_json((folder / SUMMARY).read_bytes()))
            if self._timeline.broken:
                self.problems.append(passed_over(DECISIONS, self._timeline.broken))
        return round(1e6 * self._scenario.clock.epoch.timestamp())


class ReplaySource:
    """A replay as a console's source: it plays on while it is asked for messages, and takes speed, pause and seek.

    speed: recorded seconds per second of `clock`; None where that clock goes on without waiting, one second each.
    reached: called with each time of the recording that has been played up to, before that is shown.
    """

    def __init__(
        self,
        replay: Replay,
        *,
        speed: float | None = 1.0,
        clock: Callable[[], float] = time.monotonic,
        patience_s: float = PATIENCE_S,
        reached: Callable[[float], object] = lambda _: None,
    ) -> None:
        self._replay = replay
        self._reached = reached
        self._patience_s = patience_s
        self._speed = speed
        self._clock = clock
        self._paused = False
        self._open = True
        self._played_s = clock()
        self._shown_s = -math.inf
        self._replies: list[Message] = [replay.session()]
        for problem in replay.problems:
            replay.observer.add_event(Event(replay.t_s, 0, "warning", problem, "session"))

    @property
    def connected(self) -> bool:
        """Whether it has not been closed: a recording does not go away."""
        return self._open

    def receive(self) -> list[Message]:
        """Play on up to now; the messages since the last call."""
        now_s = self._clock()
        replay = self._replay
        if not self._paused and not replay.ended:
            ahead_s = (now_s - self._played_s) * (self._speed or 1.0)
            if self._speed is None and replay.silence_s > SILENCE_S:
                ahead_s = replay.silence_s
            replay.advance(replay.t_s + ahead_s, time.monotonic() + self._patience_s)
            self._reached(replay.t_s)
        self._played_s = now_s
        messages, self._replies = self._replies, []
        if replay.observer.changed:
            messages.append(replay.session())
        if now_s - self._shown_s >= SNAPSHOT_EVERY_S:
            self._shown_s = now_s
            messages.append(replay.snapshot(speed=self._speed, paused=self._paused))
        return messages

    def send(self, command: Message) -> None:
        """Take `pause`, `resume`, `speed`, `seek` and `inspect`; a recording's vehicles take no orders."""
        ok, text = self._obey(command)
        self._replies.append(reply_message(command.get("id"), ok, text))

    def close(self) -> None:
        """End the replay."""
        self._open = False

    def _obey(self, command: Message) -> tuple[bool, str]:
        word = command.get("command")
        if word in ("pause", "resume"):
            self._paused = word == "pause"
            if word == "resume" and self._replay.ended:
                self._go(self._replay.from_s)
                return True, "The recording begins again."
            return True, f"The recording {'stands still' if self._paused else 'plays on'}."
        if word == "speed":
            speed = _number(command.get("speed"))
            if speed is None or not 0.0 < speed <= FASTEST:
                return False, f"A speed is a number above 0 and up to {FASTEST:g}."
            self._speed = speed
            return True, f"The recording plays at x{speed:g}."
        if word == "seek":
            t_s = _number(command.get("t_s"))
            if t_s is None:
                return False, "seek needs t_s, a time of the recording in seconds."
            self._go(t_s)
            return True, f"The recording is at {self._replay.t_s:.1f} s."
        if word == "inspect":
            sysid = command.get("sysid")
            if sysid is not None and sysid not in self._replay.observer.sysids:
                return False, f"There is no vehicle {sysid} in this recording."
            self._replay.inspect(() if sysid is None else (sysid,))
            return True, "" if sysid is None else f"Snapshots tell everything that vehicle {sysid} sends."
        return False, f"This is a recording: its vehicles take no command, such as {word}."

    def _go(self, t_s: float) -> None:
        self._replay.seek(t_s, reported_s=self._replay.t_s)
        self._shown_s = -math.inf


def _number(value: Any) -> float | None:
    usable = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
    return float(value) if usable else None
