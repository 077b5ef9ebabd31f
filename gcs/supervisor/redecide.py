"""Planner and scheduler once more over a recorded session: what would today's code decide of the same telemetry?

The recorded answers of each tick go to a supervisor in place of a link's, its grants go nowhere, and its decisions are
held against the recorded ones instead of being written. Frames were recorded after the radio, which is therefore clear
here. Deaths, operators' orders and what a program in Python did (set points, commands, faults, changes of the world)
are no decisions: they are taken from the recording as they happened.
"""

from __future__ import annotations

import itertools
import json
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from operator import itemgetter
from pathlib import Path
from typing import Any, cast

from gcs.link.link import Answers, Key, TickGrants, TickLink
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ids import AUTOPILOT, STATION, TRAFFIC
from gcs.recording import rotation, tlog_reader
from gcs.recording.changes import ChangeFilter
from gcs.recording.decision_lines import Decisions, decision_lines, each
from gcs.recording.decisions_reader import DecisionLines
from gcs.recording.missing import passed_over
from gcs.recording.recorder import DECISIONS, TLOG, Recorder
from gcs.recording.summary import FILE as SUMMARY
from gcs.scenario.file import load
from gcs.scenario.parts.world import WORLD
from gcs.scenario.plugins import PluginClient, clients
from gcs.supervisor import script
from gcs.supervisor.faults import INJECTED
from gcs.supervisor.operator import COMMANDS
from gcs.supervisor.recorded_objects import ANSWERS, FAILED, PROGRAM, RecordedObjects
from gcs.supervisor.supervisor import Supervisor

KEPT = 1000
"""Differences that are remembered one by one; all are counted."""
INPUTS = frozenset({"death", "operator", PROGRAM, *ANSWERS, *script.KINDS})
_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")
_ABOUT = ("sysid", "receiver", "tanker", "base", "giver", "target")

Progress = Callable[[float], None]


class RedecideError(Exception):
    """The session cannot be decided again; one sentence."""


@dataclass(frozen=True)
class Difference:
    """One decision of one tick: as recorded, and as made today; None where only the other side has it."""

    t_s: float
    kind: str
    recorded: Mapping[str, Any] | None
    today: Mapping[str, Any] | None

    @property
    def sentence(self) -> str:
        """For a person: the time, what it is about, and the fields that differ."""
        either = self.recorded or self.today or {}
        about = ", ".join(f"{key} {either[key]}" for key in _ABOUT if key in either)
        head = f"{self.t_s:.1f} s: {self.kind}{f' ({about})' if about else ''}"
        if self.recorded is None:
            return f"{head}: decided today only"
        if self.today is None:
            return f"{head}: recorded only"
        changed = [key for key in {**self.recorded, **self.today} if self.recorded.get(key) != self.today.get(key)]
        changes = [f"{key} was {_short(self.recorded.get(key))}, is {_short(self.today.get(key))}" for key in changed]
        return f"{head}: {'; '.join(changes)}"

    def record(self) -> dict[str, Any]:
        """The comparison as one JSON object."""
        return {"type": "difference", **asdict(self)}


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list | tuple):
        return "(" + ", ".join(map(_short, value)) + ")"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {_short(entry)}" for key, entry in value.items()) + "}"
    return str(value)


@dataclass
class Subject:
    """Differences of one kind of decision about one vehicle: its first difference, how many, and until when."""

    first: Difference
    count: int = 0
    last_s: float = 0.0


@dataclass
class Comparison:
    """Result: `compared` recorded decisions up to `until_s`; the first `KEPT` differences, all by kind."""

    compared: int = 0
    until_s: float = 0.0
    differences: list[Difference] = field(default_factory=list)
    by_kind: Counter[str] = field(default_factory=Counter)
    subjects: dict[tuple[Any, ...], Subject] = field(default_factory=dict)
    """the same by kind and vehicles, in the order in which they begin"""
    problems: list[str] = field(default_factory=list)
    objects: str = ""
    """what of planner and policy was a program's own and is not asked again, as a sentence"""
    acts: Counter[str] = field(default_factory=Counter)
    """what a program in Python did, by its kind: ticks with set points, commands, faults, changes of the world"""

    @property
    def agrees(self) -> bool:
        """Whether every decision is the same to the last digit."""
        return not self.by_kind


class RecordedLink(TickLink):
    """A link of a supervisor without vehicles: it hands out what was recorded, and lets the grants go.

    See `TickLink` for the methods.
    """

    def __init__(self, keys: Sequence[Key]) -> None:
        self._joined = set(keys)
        self._granted: set[Key] = set()
        self.recorded: Mapping[Key, Sequence[Frame]] = {}

    @property
    def joined(self) -> set[Key]:
        return self._joined

    @property
    def silent(self) -> bool:
        """Whether no vehicle flies: nothing is sent then, and nothing recorded."""
        return not self._granted

    def leave(self, key: Key) -> None:
        self._joined.discard(key)
        self._granted.discard(key)

    def grant(
        self, key: Key, t_ms: int, unix_us: int, messages: Sequence[Message], relayed: Sequence[bytes], air: bytes = b""
    ) -> list[bytes]:
        self._granted.add(key)
        return []

    def grant_all(self, grants: TickGrants) -> Sequence[bytes]:
        self._granted.update(grants.keys)
        return []

    def flush(self) -> None:
        """Nothing waits to be sent."""

    def answers(self, idle: Callable[[], None]) -> Iterator[Answers]:
        keys = sorted(self._granted)
        yield keys, [self.recorded.get(key, []) for key in keys]


class Comparer:
    """Stand-in for a supervisor's `Recorder`: it keeps the decisions of the present tick, and no frame."""

    def __init__(self, *, changes_only: bool = False) -> None:
        self.made: list[dict[str, Any]] = []
        self._changes = ChangeFilter() if changes_only else None

    def frames(self, t_us: int, received: Sequence[bytes], sent: Sequence[bytes]) -> None:
        """As `Recorder.frames`."""

    def decisions(self, decisions: Decisions) -> Sequence[bytes]:
        """As `Recorder.decisions`."""
        lines = decision_lines(decisions)
        for line, decision in zip(lines, each(decisions), strict=True):
            written = self._changes is None or self._changes.is_change(decision)
            if written and decision["kind"] not in INPUTS:
                self.made.append(json.loads(line))
        return lines

    def flush(self) -> None:
        """As `Recorder.flush`."""


@dataclass
class Tick:
    """One tick of the recording: what each vehicle answered, and whether the supervisor went on."""

    t_us: int
    answers: dict[Key, list[Frame]] = field(default_factory=dict)
    granted: bool = False


def ticks(log: tlog_reader.Tlog) -> Iterator[Tick]:
    """A session's log tick by tick. A vehicle's answer ends with its SYSTEM_TIME; what it says later was relayed."""
    for t_us, records in itertools.groupby(log, itemgetter(0)):
        tick, answered = Tick(t_us), set[Key]()
        for _, frame in records:
            key = (frame.sysid, frame.compid)
            if key == STATION:
                tick.granted = True
            elif key not in answered:
                tick.answers.setdefault(key, []).append(frame)
                if frame.msgid == _SYSTEM_TIME:
                    answered.add(key)
        yield tick


class _Recorded:
    """The recorded decisions, tick by tick."""

    def __init__(self, path: Path) -> None:
        self.lines = DecisionLines(path)
        self._records = iter(self.lines)
        self._next = next(self._records, None)
        self._waiting: list[dict[str, Any]] = []
        """read, and not handed out yet"""

    def until(self, t_s: float) -> list[dict[str, Any]]:
        """Those up to a time that have not been handed out yet."""
        taken, self._waiting = [*self._waiting, *self._read_until(t_s)], []
        return taken

    def _read_until(self, t_s: float) -> list[dict[str, Any]]:
        taken = []
        while self._next is not None and self._next["t_s"] <= t_s:
            taken.append(self._next)
            self._next = next(self._records, None)
        return taken

    def goes_on(self, t_s: float) -> bool:
        """Whether there are any after a time."""
        self._waiting += self._read_until(t_s)
        return self._next is not None

    @property
    def ended(self) -> bool:
        """Whether there are no more."""
        return self._next is None and not self._waiting


def redecide(folder: Path, progress: Progress = lambda _: None, plugins: PluginClient | None = None) -> Comparison:
    """Decide a recorded session again; `plugins`: the process of what its scenario names, if anything. What was its
    program's own is not asked: its answers are those of the recording.

    Raises RedecideError, ScenarioError, OSError.
    """
    for name in (TLOG, DECISIONS, "scenario.yaml"):
        if not rotation.exists(folder / name):
            raise RedecideError(f"{folder} has no {name}: only a whole session's folder can be decided again.")
        if not rotation.begins(folder / name):
            raise RedecideError(
                f"{folder / name} lacks its first parts, which the session did not keep (record: keep in its "
                "scenario): only a whole recording can be decided again."
            )
    scenario = load(folder / "scenario.yaml")
    if scenario.vehicles.foreign:
        raise RedecideError(
            f"{folder} was flown with external vehicles, on their own clocks: only sessions whose vehicles were all "
            "launched can be decided again."
        )
    log = tlog_reader.read(folder / TLOG, session=True)
    recorded = _Recorded(folder / DECISIONS)
    keys = [(vehicle.sysid, AUTOPILOT) for vehicle in scenario.vehicles.all]
    link = RecordedLink([*keys, TRAFFIC] if scenario.traffic else keys)
    comparer = Comparer(changes_only=scenario.record.decisions == "changes")
    objects = RecordedObjects(DecisionLines(folder / DECISIONS))
    answering = {**clients(scenario, plugins), **dict.fromkeys(objects.objects, objects)}
    # The supervisor asks of link and recorder only what these two have.
    supervisor = Supervisor(scenario, link, cast(Recorder, comparer), impaired=False, plugins=answering)
    verdict = Comparison(objects=objects.text)
    whole = (folder / SUMMARY).exists()
    supervisor.begin()
    end_s = scenario.goal.duration_s

    lines: list[dict[str, Any]] = []

    def relive(t_s: float) -> None:
        """Let acts, orders and deaths up to a time happen again."""
        for line in recorded.until(t_s):
            _relive(supervisor, objects, line, folder)
            if line["kind"] in script.KINDS:
                verdict.acts[line["kind"]] += 1
            lines.append(line)

    def decide(tick: Tick) -> bool:
        """Decide one tick and compare it; False where its decisions may not all have been recorded."""
        t_s = (tick.t_us - supervisor.epoch_us) / 1e6
        relive(t_s)
        link.recorded = tick.answers
        comparer.made = []
        supervisor.tick(lambda: None)
        supervisor.script.steer({})
        supervisor.events.clear()
        if recorded.ended and (recorded.lines.cut or not whole):
            return False
        _compare(verdict, t_s, [line for line in lines if line["kind"] not in INPUTS], comparer.made)
        lines.clear()
        verdict.until_s = t_s
        return True

    def decide_silent(until_ms: int) -> None:
        """The same of the ticks in which no vehicle flies: only decisions are recorded of them."""
        while supervisor.time_ms < until_ms and not recorded.ended:
            relive(supervisor.time_s)
            if not link.silent:
                break
            decide(Tick(supervisor.epoch_us + 1000 * supervisor.time_ms))

    for tick in ticks(log):
        t_s = (tick.t_us - supervisor.epoch_us) / 1e6
        if recorded.ended and (recorded.lines.cut or not whole):
            break
        if not tick.granted and not recorded.goes_on(t_s):
            break
        decide_silent(round(1e3 * t_s))
        if round(1e3 * t_s) != supervisor.time_ms:
            raise RedecideError(
                f"{folder / TLOG} goes on at {t_s:.3f} s where {supervisor.time_s:.3f} s should come: it is not the "
                "recording of this scenario, or of another clock."
            )
        if not decide(tick):
            break  # of a session that was killed, the last tick's decisions may not all have been written
        progress(min(t_s / end_s, 1.0))
    decide_silent(round(1e3 * end_s))
    verdict.problems += log.problems
    if recorded.lines.broken:
        verdict.problems.append(passed_over(DECISIONS, recorded.lines.broken))
    if recorded.lines.cut:
        verdict.problems.append(f"{folder / DECISIONS} ends inside a line, and was compared up to there.")
    if not whole:
        verdict.problems.append(f"{folder} has no {SUMMARY}: the session did not end, and was compared up to there.")
    return verdict


def _relive(supervisor: Supervisor, objects: RecordedObjects, line: Mapping[str, Any], folder: Path) -> None:
    """Let an operator's order, a death or a program's act happen again. Raises RedecideError."""
    if line["kind"] == "operator" and line.get("command") in COMMANDS:
        supervisor.obey({key: line[key] for key in ("command", "sysid", "target") if key in line})
    elif line["kind"] == "death" and not str(line.get("text", "")).endswith(INJECTED):  # that it does by itself
        sysid = int(line["sysid"])
        supervisor.lose(TRAFFIC if sysid == TRAFFIC[0] else (sysid, AUTOPILOT), str(line.get("text", "")))
    elif line["kind"] in script.KINDS | ANSWERS | {FAILED}:
        try:
            if line["kind"] in script.KINDS:
                _act(supervisor, line)
            else:
                objects.take(line)
        except (KeyError, TypeError, ValueError):
            raise RedecideError(
                f"{folder / DECISIONS} holds an act of a program at {line['t_s']:.3f} s that cannot be read: only a "
                "session whose program's acts are all known can be decided again."
            ) from None


def _act(supervisor: Supervisor, line: Mapping[str, Any]) -> None:
    """Raises KeyError, TypeError, ValueError where the line does not say what was done."""
    if line["kind"] == script.STEERED:
        supervisor.script.steer(script.steered_of(line))
    elif line["kind"] == script.COMMAND:
        supervisor.command(int(line["number"]), int(line["sysid"]), int(line["mav_cmd"]), line["params"])
    elif line["kind"] == WORLD:
        supervisor.surround(line)
    else:
        supervisor.inject(script.fault_of(line))


def _compare(
    verdict: Comparison, t_s: float, recorded: Sequence[dict[str, Any]], today: Sequence[dict[str, Any]]
) -> None:
    verdict.compared += len(recorded)
    if list(recorded) == list(today):
        return
    then, now = _by_subject(recorded), _by_subject(today)
    for subject in dict.fromkeys((*then, *now)):
        before, after = then.get(subject), now.get(subject)
        if before != after:
            difference = Difference(t_s, subject[0], before, after)
            verdict.by_kind[subject[0]] += 1
            about = verdict.subjects.setdefault(subject[:-1], Subject(difference))
            about.count, about.last_s = about.count + 1, t_s
            if len(verdict.differences) < KEPT:
                verdict.differences.append(difference)


def _by_subject(decisions: Sequence[dict[str, Any]]) -> dict[tuple[Any, ...], dict[str, Any]]:
    """Decisions of one tick by their kind and vehicles; equal ones are distinguished by their number."""
    found: dict[tuple[Any, ...], dict[str, Any]] = {}
    for decision in decisions:
        subject = (decision["kind"], *(decision.get(key) for key in _ABOUT))
        count = 0
        while (*subject, count) in found:
            count += 1
        found[*subject, count] = decision
    return found
