"""Asking a vehicle one question after another, as its peers do: no socket and no clock here, time is an argument.

A question is asked, asked again as patient peers do, and judged by what came back meanwhile. What a missing answer
means, and to which peer, is kept with the question (`misses`): nothing here distinguishes peers.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.autopilots import Profile, profile_of
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ids import OUR_HEARTBEAT, STATION
from gcs.mavlink.services import vehicle_uid
from gcs.mavlink.statustext import chunk_of, recorded
from skytender import mavlink as mav

HEARTBEAT_EVERY_S = 1.0
FIND_WITHIN_S = 10.0
REPEAT_S = 0.5
TRIES = 3
STREAM_EVERY_S = 0.05

Outcome = Literal["ok", "late", "missing", "wrong", "skipped"]
VEHICLE_TYPES = mav.ENUMS["MAV_TYPE"].keys() - {
    mav.MAV_TYPE_GCS,
    mav.MAV_TYPE_ADSB,
    mav.MAV_TYPE_GIMBAL,
    mav.MAV_TYPE_CAMERA,
    mav.MAV_TYPE_ONBOARD_CONTROLLER,
    mav.MAV_TYPE_ANTENNA_TRACKER,
    mav.MAV_TYPE_CHARGING_STATION,
}


_COMMANDS = frozenset({codec.msgid("COMMAND_LONG"), codec.msgid("COMMAND_INT")})


class ReceivedMessage(NamedTuple):
    """A message that the vehicle sent: its name, its fields in MAVLink's own units (of a STATUSTEXT a TextChunk, None
    for one that no dialect of ours holds), and when it came."""

    name: str
    fields: Any
    at_s: float


def texts(received: Iterable[ReceivedMessage]) -> list[str]:
    """Texts that the vehicle sent, put together from their chunks, each once."""
    chunks = ((one.at_s, one.fields) for one in received if one.name == "STATUSTEXT")
    return list(dict.fromkeys(text for _, _, text in recorded(chunks)))


@dataclass
class CheckedVehicle:
    """State known so far of the vehicle that is asked."""

    sysid: int
    compid: int
    station: tuple[int, int] = STATION
    """our ids, to which it answers"""
    latest: dict[str, ReceivedMessage] = field(default_factory=dict)
    arrivals_s: dict[str, list[float]] = field(default_factory=dict)
    parameters: dict[str, Any] = field(default_factory=dict)
    """PARAM_VALUE's fields by name"""
    uids: dict[str, set[str]] = field(default_factory=dict)
    """uids of hardware that its id comes with, by address; empty ones are not said"""
    modes: dict[int, Any] = field(default_factory=dict)
    """AVAILABLE_MODES' fields by mode_index"""
    neighbours: dict[int, str] = field(default_factory=dict)
    """other vehicles that acknowledged a command to it, with that command's name, by system id"""
    asked: Sequence[Message] = ()
    """the last messages of a question to it"""
    rates_count_from_s: float = 0.0
    """when it was first received or, where it was waited for, when it was ready: one that boots sends less"""
    running_s: float | None = None
    """how long it had run since its boot when it first said so"""
    backwards: str = ""
    """the first message whose time_boot_ms was lower than the one before"""
    _boot_ms: dict[str, int] = field(default_factory=dict)

    def receive(self, received: ReceivedMessage) -> None:
        """Remember one message."""
        self.latest[received.name] = received
        self.arrivals_s.setdefault(received.name, []).append(received.at_s)
        boot_ms = getattr(received.fields, "time_boot_ms", None)
        if boot_ms is not None:
            if self.running_s is None:
                self.running_s = 1e-3 * boot_ms
            if boot_ms < self._boot_ms.get(received.name, 0) and not self.backwards:
                self.backwards = received.name
            self._boot_ms[received.name] = boot_ms
        if received.name == "PARAM_VALUE":
            self.parameters[received.fields.param_id] = received.fields
        elif received.name == "AVAILABLE_MODES":
            self.modes[received.fields.mode_index] = received.fields

    def of(self, name: str) -> Any:
        """The newest message of this name, or None."""
        received = self.latest.get(name)
        return None if received is None else received.fields

    @property
    def profile(self) -> Profile:
        """Which autopilot it says that it is."""
        beat = self.of("HEARTBEAT")
        return profile_of(beat.autopilot, beat.type)

    @property
    def capabilities(self) -> int:
        """AUTOPILOT_VERSION's capability bits; 0 where it was never received."""
        version = self.of("AUTOPILOT_VERSION")
        return 0 if version is None else int(version.capabilities)

    @property
    def armed(self) -> bool:
        """By its last HEARTBEAT."""
        return bool(self.of("HEARTBEAT").base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED)


class Verdict(NamedTuple):
    """Result of a question; `text` says for a person what was found."""

    outcome: Outcome
    text: str = ""


Judge = Callable[[CheckedVehicle, Sequence[ReceivedMessage]], "Verdict | None"]
"""Messages received since the question was first asked → the verdict, None while it may still come."""


@dataclass(frozen=True)
class Question:
    """One thing that peers ask or wait for, and what each of them shows where it does not come.

    `ask` is sent at once and again every `repeat_s`, `tries` times in all; then `at_end` has the last word. With
    `streams` its messages go out every 50 ms meanwhile, beginning `lead_s` before the question.
    """

    key: str
    what: str
    misses: Mapping[str, str]
    judge: Judge
    ask: Callable[[CheckedVehicle], Sequence[Message]] = lambda _: ()
    at_end: Callable[[CheckedVehicle, Sequence[ReceivedMessage]], Verdict] = lambda *_: Verdict("missing", "no answer")
    when: Callable[[CheckedVehicle], str] = lambda _: ""
    """why it does not apply to this vehicle; empty where it does"""
    repeat_s: float = REPEAT_S
    tries: int = TRIES
    streams: Callable[[CheckedVehicle], Sequence[Message]] | None = None
    lead_s: float = 0.0
    elsewhere: bool = False
    """asked of another system id"""
    unsigned: bool = False
    """asked without a signature, whatever the link's key"""
    settles: bool = False
    """what came before its end says nothing of how often a vehicle sends"""


@dataclass(frozen=True)
class CheckFinding:
    """A question's outcome; `after_s` is how long the answer took, from the first asking."""

    question: Question
    outcome: Outcome
    text: str
    after_s: float | None


def command_name(command: int) -> str:
    """A command's name in MAVLink, else its number."""
    return mav.ENUMS["MAV_CMD"].get(command, str(command))


def _fields(message: Message) -> Any:
    return codec.layout(message.msgid).record(*message.values)


class Dialogue:
    """All questions to one vehicle, one at a time. The driver feeds frames, and sends what `poll` returns."""

    def __init__(
        self, questions: Iterable[Question], sysid: int | None = None, station: tuple[int, int] = STATION
    ) -> None:
        """`sysid`: the vehicle to ask; None: the first one received. `station`: our ids."""
        self.vehicle: CheckedVehicle | None = None
        self.others: set[int] = set()
        """system ids of further vehicles that were received"""
        self.findings: list[CheckFinding] = []
        self._wanted, self._station = sysid, station
        self._left = deque(questions)
        self._received: list[ReceivedMessage] = []
        self._asked = 0
        self._lead_until_s: float | None = None
        self._first_s = self._due_s = 0.0
        self._commands: set[int] = set()
        """that are being asked of the vehicle"""
        self._heartbeat_s = -HEARTBEAT_EVERY_S
        self._stream_s = 0.0

    @property
    def current(self) -> Question | None:
        """The question that is being asked; None before the vehicle is found and at the end."""
        return self._left[0] if self.vehicle is not None and self._left else None

    @property
    def done(self) -> bool:
        """Whether every question has its finding."""
        return not self._left

    def receive(self, frame: Frame, now_s: float, at: str = "") -> None:
        """Take in one frame that came, from the address `at`."""
        name = codec.name(frame.msgid)
        content: Any
        try:
            content = chunk_of(frame) if name == "STATUSTEXT" else codec.fields(frame)
        except ValueError:
            content = None
        if name == "HEARTBEAT" and content.type in VEHICLE_TYPES and content.autopilot != mav.MAV_AUTOPILOT_INVALID:
            if self.vehicle is None and self._wanted in (None, frame.sysid):
                self.vehicle = CheckedVehicle(frame.sysid, frame.compid, self._station, rates_count_from_s=now_s)
            elif self.vehicle is not None and frame.sysid != self.vehicle.sysid:
                self.others.add(frame.sysid)
        if self.vehicle is None:
            return
        if frame.sysid != self.vehicle.sysid and name == "COMMAND_ACK" and content.command in self._commands:
            self.vehicle.neighbours.setdefault(frame.sysid, command_name(content.command))
        if (frame.sysid, frame.compid) != (self.vehicle.sysid, self.vehicle.compid):
            return
        uids = self.vehicle.uids.setdefault(at, set())
        if frame.msgid == vehicle_uid.VERSION:
            uids.add(vehicle_uid.uid_of(content))
        received = ReceivedMessage(name, content, now_s)
        self.vehicle.receive(received)
        self._received.append(received)

    def poll(self, now_s: float) -> list[Message]:
        """Judge what has come, move on, and say what to send now."""
        out: list[Message] = []
        if now_s - self._heartbeat_s >= HEARTBEAT_EVERY_S:
            self._heartbeat_s = now_s
            out.append(OUR_HEARTBEAT)
        while (question := self.current) is not None:
            assert self.vehicle is not None
            if not self._asked and self._lead_until_s is None:
                if why := question.when(self.vehicle):
                    self._close(Verdict("skipped", why), None, now_s)
                    continue
                self._lead_until_s = now_s + question.lead_s
            if question.streams is not None and now_s >= self._stream_s:
                self._stream_s = now_s + STREAM_EVERY_S
                out += question.streams(self.vehicle)
            assert self._lead_until_s is not None
            if now_s < self._lead_until_s:
                return out
            if not self._asked:
                self._received = []
                self._first_s = now_s
                out += self._ask(question, now_s)
                return out
            if (verdict := question.judge(self.vehicle, self._received)) is not None:
                self._close(verdict, self._received[-1].at_s - self._first_s if self._received else None, now_s)
                continue
            if now_s < self._due_s:
                return out
            if self._asked < question.tries:
                out += self._ask(question, now_s)
                return out
            self._close(question.at_end(self.vehicle, self._received), None, now_s)
        return out

    def _ask(self, question: Question, now_s: float) -> Sequence[Message]:
        assert self.vehicle is not None
        self._asked += 1
        self._due_s = now_s + question.repeat_s
        self.vehicle.asked = messages = question.ask(self.vehicle)
        if not question.elsewhere:
            self._commands = {_fields(one).command for one in messages if one.msgid in _COMMANDS}
        return messages

    def _close(self, verdict: Verdict, after_s: float | None, now_s: float) -> None:
        assert self.vehicle is not None
        outcome, text = verdict
        if self._left[0].settles:
            self.vehicle.rates_count_from_s = now_s
        if outcome == "ok" and self._asked > 1:
            outcome, text = "late", f"came only after it was asked {self._asked} times"
        self.findings.append(CheckFinding(self._left.popleft(), outcome, text, after_s))
        self._received, self._asked, self._lead_until_s, self._commands = [], 0, None, set()
