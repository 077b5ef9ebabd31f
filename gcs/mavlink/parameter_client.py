"""Parameters of one vehicle, asked for and written: no socket and no clock here, time is an argument (s).

    read     PARAM_REQUEST_READ → PARAM_VALUE
    write    read → PARAM_SET → PARAM_VALUE → PARAM_REQUEST_READ → PARAM_VALUE: it counts when it reads as written
    list     PARAM_REQUEST_LIST → PARAM_VALUE …, then by index what is missing; before that, where the profile names a
             file of all parameters, this is read by MAVFTP (ftp/file_client.py), which is faster: ten or more a frame

What is not answered is sent again, TRIES times in all; no more than IN_FLIGHT questions are open at once, so that a
slow radio is not flooded.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from gcs.mavlink import codec, parameter_pack
from gcs.mavlink.autopilots import Profile
from gcs.mavlink.codec import Message
from gcs.mavlink.ftp.file_client import FileClient
from gcs.mavlink.ftp.requests import FileRequests

REPEAT_S = 0.7
TRIES = 5
IN_FLIGHT = 8
MOST_PARAMETERS = 1 << 14
"""Ten times what any autopilot has: further names are not kept, whatever is sent."""
SETTLED_S = 1.0
"""A list during which nothing more has come for so long has come as far as it does by itself."""

Outcome = Literal["read", "kept", "would", "set", "unknown", "refused", "silent"]
"""`kept`: it had that value already; `would`: it would be set, were this no dry run; `refused`: the vehicle keeps
another value; `silent`: no answer."""


class Parameter(NamedTuple):
    """A parameter's number, and its MAV_PARAM_TYPE."""

    number: float
    kind: int


class ParameterResult(NamedTuple):
    """End of one parameter's reading or writing."""

    name: str
    outcome: Outcome
    before: float | None
    """number that it had; None where it did not say"""
    now: float | None
    """number that it has, by its own last word"""
    why: str = ""


@dataclass
class _Task:
    name: str
    wanted: float | None
    stage: Literal["read", "write", "verify"] = "read"
    before: float | None = None
    tries: int = 0
    due_s: float = 0.0


@dataclass
class _Listing:
    count: int = 0
    named: dict[int, str] = field(default_factory=dict)
    last_s: float = 0.0
    asked: int = 0
    begun: bool = False


class ParameterClient:
    """The dialogue with one vehicle."""

    def __init__(self, sysid: int, compid: int, profile: Profile, *, dry_run: bool = False) -> None:
        self.sysid, self.compid = sysid, compid
        self._to = {"target_system": sysid, "target_component": compid}
        self.profile = profile
        self.known: dict[str, Parameter] = {}
        self.results: list[ParameterResult] = []
        self.incomplete = ""
        """what a list lacks, in words; empty where nothing"""
        self._dry_run = dry_run
        self._tasks: dict[str, _Task] = {}
        self._listing: _Listing | None = None
        self._file: FileClient | None = None

    def read(self, names: Iterable[str]) -> None:
        """Read these."""
        self._tasks |= {name: _Task(name, None) for name in names}

    def write(self, numbers: dict[str, float]) -> None:
        """Give these parameters these numbers."""
        self._tasks |= {name: _Task(name, number) for name, number in numbers.items()}

    def read_all(self) -> None:
        """Read whatever it has."""
        if self.profile.parameter_file:
            self._file = FileClient(FileRequests(self.sysid, self.compid), self.profile.parameter_file)
        else:
            self._listing = _Listing()

    @property
    def done(self) -> bool:
        """Whether nothing is open."""
        return not self._tasks and self._file is None and self._listing is None

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if self._file is not None:
            self._file.receive(name, content, now_s)
        if name == "PARAM_ERROR" and content.param_id in self._tasks:
            self._end(self._tasks[content.param_id], "unknown", None, "it does not know it")
        if name != "PARAM_VALUE":
            return
        parameter = Parameter(self.profile.parameter(content.param_value, content.param_type), content.param_type)
        asked = content.param_id in self.known or content.param_id in self._tasks
        if not asked and len(self.known) >= MOST_PARAMETERS:
            return
        self.known[content.param_id] = parameter
        if self._listing is not None:
            self._list(self._listing, content, now_s)
        task = self._tasks.get(content.param_id)
        if task is not None:
            self._go_on(task, parameter)

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        out: list[Message] = [] if self._file is None else self._poll_file(self._file, now_s)
        if self._listing is not None:
            out += self._poll_list(self._listing, now_s)
        for task in list(self._tasks.values())[:IN_FLIGHT]:
            if now_s < task.due_s:
                continue
            if task.tries >= TRIES:
                outcome: Outcome = "unknown" if task.stage == "read" else "silent"
                self._end(task, outcome, None, f"no answer, though it was asked {TRIES} times")
                continue
            task.tries += 1
            task.due_s = now_s + REPEAT_S
            out.append(self._set(task) if task.stage == "write" else self._read(task.name, -1))
        return out

    def _poll_file(self, file: FileClient, now_s: float) -> list[Message]:
        """Read the file; once that has ended, take what is in it, or go over to the list."""
        messages = file.poll(now_s)
        if file.done:
            self._file = None
            try:
                if file.content is None:
                    raise ValueError(file.problem)
                found = parameter_pack.unpack(file.content)
                self.known |= {name: Parameter(number, kind) for name, (number, kind) in found.items()}
            except ValueError:
                self._listing = _Listing()
        return messages

    def _go_on(self, task: _Task, parameter: Parameter) -> None:
        number = parameter.number
        if task.wanted is None:
            self._end(task, "read", number)
            return
        if task.stage == "read":
            task.before = number
            try:
                self.profile.parameter_value(task.wanted, parameter.kind)
            except ValueError as error:
                self._end(task, "refused", number, str(error))
                return
            if same(number, task.wanted):
                self._end(task, "kept", number)
            elif self._dry_run:
                self._end(task, "would", number)
            else:
                task.stage, task.tries, task.due_s = "write", 0, 0.0
        elif task.stage == "write":
            task.stage, task.tries, task.due_s = "verify", 0, 0.0
        elif same(number, task.wanted):
            self._end(task, "set", number)
        else:
            self._end(task, "refused", number, f"it keeps {number:g}")

    def _end(self, task: _Task, outcome: Outcome, now: float | None, why: str = "") -> None:
        del self._tasks[task.name]
        self.results.append(ParameterResult(task.name, outcome, task.before, now, why))

    def _list(self, listing: _Listing, content: Any, now_s: float) -> None:
        if content.param_index < content.param_count:  # 65535: told unasked, or by name
            listing.count = content.param_count
            listing.named[content.param_index] = content.param_id
            listing.last_s, listing.asked = now_s, 0
            self._listing = None if len(listing.named) >= listing.count else listing

    def _poll_list(self, listing: _Listing, now_s: float) -> list[Message]:
        if listing.begun and now_s - listing.last_s < SETTLED_S:
            return []
        if listing.asked >= TRIES:
            self._listing = None
            of = f" of {listing.count}" if listing.count else ""
            self.incomplete = f"{len(listing.named)}{of} parameters came"
            return []
        listing.begun, listing.last_s = True, now_s
        listing.asked += 1
        if 2 * len(listing.named) <= listing.count:
            return [codec.message("PARAM_REQUEST_LIST", **self._to)]
        missing = [index for index in range(listing.count) if index not in listing.named]
        return [self._read("", index) for index in missing[: 4 * IN_FLIGHT]]

    def _read(self, name: str, index: int) -> Message:
        return codec.message("PARAM_REQUEST_READ", **self._to, param_id=name, param_index=index)

    def _set(self, task: _Task) -> Message:
        assert task.wanted is not None
        kind = self.known[task.name].kind
        value = self.profile.parameter_value(task.wanted, kind)
        return codec.message("PARAM_SET", **self._to, param_id=task.name, param_value=value, param_type=kind)


def same(a: float, b: float) -> bool:
    """Whether two numbers are one as a parameter of 32 bits."""
    try:
        return struct.pack("<f", a) == struct.pack("<f", b) or a == b
    except OverflowError:
        return a == b
