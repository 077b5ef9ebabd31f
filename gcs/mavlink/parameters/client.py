"""Parameters of one vehicle, asked for and written: no socket and no clock here, time is an argument (s).

    read     PARAM_REQUEST_READ → PARAM_VALUE
    write    read → PARAM_SET → PARAM_VALUE → PARAM_REQUEST_READ → PARAM_VALUE: it counts when it reads as written;
             the type is the vehicle's own, and a number that the type or the wire cannot carry is not sent
    list     PARAM_REQUEST_LIST → PARAM_VALUE …, then by index what is missing; before that, where the profile names a
             file of all parameters, this is read by MAVFTP (ftp/file_client.py), which is faster: ten or more a frame

What is not answered is sent again, TRIES times in all; no more than IN_FLIGHT questions are open at once, so that a
slow radio is not flooded.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.autopilots import Profile
from gcs.mavlink.codec import Message
from gcs.mavlink.ftp.file_client import FileClient
from gcs.mavlink.ftp.requests import FileRequests
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.parameters import pack, value
from gcs.mavlink.parameters.renames import unknown_name
from gcs.mavlink.parameters.value import ParameterValue, same
from skytender import mavlink as mav

REPEAT_S = 0.7
TRIES = 5
IN_FLIGHT = 8
MOST_PARAMETERS = 1 << 14
"""Ten times what any autopilot has: further names are not kept, whatever is sent."""
SETTLED_S = 1.0
"""A list during which nothing more has come for so long has come as far as it does by itself."""

Outcome = Literal["read", "kept", "would", "set", "unknown", "refused", "silent"]
"""`kept`: it had that value already; `would`: it would be set, were this no dry run; `refused`: the vehicle keeps
another value, or cannot be given this one; `silent`: no answer."""
TYPE_UNSUPPORTED, TYPE_MISMATCH, READ_FAIL = 6, 7, 8
"""Of MAV_PARAM_ERROR, younger than pymavlink's dialect."""
_ERRORS = {
    int(mav.MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE): "it says that the value is out of range (VALUE_OUT_OF_RANGE)",
    int(mav.MAV_PARAM_ERROR_PERMISSION_DENIED): "it lets no ground station write it (PERMISSION_DENIED)",
    int(mav.MAV_PARAM_ERROR_COMPONENT_NOT_FOUND): "it has no such component (COMPONENT_NOT_FOUND)",
    int(mav.MAV_PARAM_ERROR_READ_ONLY): "it may only be read (READ_ONLY)",
    TYPE_UNSUPPORTED: "it does not support the type (TYPE_UNSUPPORTED)",
    TYPE_MISMATCH: "it expects another type (TYPE_MISMATCH)",
    READ_FAIL: "it could not read it (READ_FAIL)",
}
"""Words for MAV_PARAM_ERROR, but for a parameter that a vehicle does not have."""


class ParameterResult(NamedTuple):
    """End of one parameter's reading or writing."""

    name: str
    outcome: Outcome
    before: ParameterValue | None
    """value that it had; None where it did not say"""
    now: ParameterValue | None
    """value that it has, by its own last word"""
    why: str = ""
    wanted: ParameterValue | None = None
    """value that it was to have"""


@dataclass
class _Task:
    name: str
    number: int | float | None
    """that it is to have; None to read it"""
    wanted: ParameterValue | None = None
    """the same, in the type that the vehicle says"""
    stage: Literal["read", "write", "verify"] = "read"
    before: ParameterValue | None = None
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
    """The dialogue with one component of one vehicle."""

    def __init__(self, sysid: int, compid: int, profile: Profile, *, dry_run: bool = False) -> None:
        self.sysid, self.compid = sysid, compid
        self._to = {"target_system": sysid, "target_component": compid}
        self.profile = profile
        self.known: dict[str, ParameterValue] = {}
        self.results: list[ParameterResult] = []
        self.written: dict[str, ParameterValue] = {}
        """value before, of each that has been written, or is about to be"""
        self.incomplete = ""
        """what a list lacks, in words; empty where nothing"""
        self._dry_run = dry_run
        self._tasks: dict[str, _Task] = {}
        self._listing: _Listing | None = None
        self._file: FileClient | None = None
        self._all = False
        self._exact: dict[str, ParameterValue] = {}
        """values of its file, which no float has carried"""

    def read(self, names: Iterable[str]) -> None:
        """Read these."""
        self._tasks |= {name: _Task(name, None) for name in names}

    def write(self, numbers: Mapping[str, int | float]) -> None:
        """Give these parameters these numbers. Where the vehicle's floats cannot tell one from another, what it has is
        read from its file first, if it has one."""
        self._tasks |= {name: _Task(name, number) for name, number in numbers.items()}
        if self._has_file and not self.profile.integers_bytewise and not all(map(value.cast_keeps, numbers.values())):
            self._begin_file()

    def leave(self, names: Iterable[str]) -> None:
        """Ask no more about these, and have no result of them."""
        for name in names:
            self._tasks.pop(name, None)

    def read_all(self) -> None:
        """Read whatever it has."""
        self._all = True
        if self._has_file:
            self._begin_file()
        else:
            self._listing = _Listing()

    def expect(self, names: Iterable[str]) -> None:
        """Name those that are not among all that has been read."""
        if not self.incomplete:
            for name in names:
                if name not in self.known:
                    self._end(_Task(name, None), "unknown", None, f"it does not know it{self._newer(name)}")

    @property
    def _has_file(self) -> bool:
        return bool(self.profile.parameter_file) and self.compid == AUTOPILOT

    def _begin_file(self) -> None:
        self._file = FileClient(FileRequests(self.sysid, self.compid), self.profile.parameter_file)

    @property
    def done(self) -> bool:
        """Whether nothing is open."""
        return not self._tasks and self._file is None and self._listing is None

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if self._file is not None:
            self._file.receive(name, content, now_s)
        if name not in ("PARAM_ERROR", "PARAM_VALUE"):
            return
        task = self._tasks.get(content.param_id)
        if name == "PARAM_ERROR":
            if task is not None:
                self._end(task, *self._verdict(task, content.error))
            return
        if task is None and content.param_id not in self.known and len(self.known) >= MOST_PARAMETERS:
            return
        if self._listing is not None:
            self._list(self._listing, content, now_s)
        try:
            parameter = self.profile.parameter(content.param_value, content.param_type)
        except ValueError as error:
            self._unread(content.param_id, task, str(error))
            return
        self.known[content.param_id] = parameter
        if task is not None:
            self._go_on(task, parameter)

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        out: list[Message] = [] if self._file is None else self._poll_file(self._file, now_s)
        if self._listing is not None:
            out += self._poll_list(self._listing, now_s)
        for task in list(self._tasks.values())[:IN_FLIGHT] if self._file is None else ():
            if now_s < task.due_s:
                continue
            if task.tries >= TRIES:
                outcome: Outcome = "unknown" if task.stage == "read" else "silent"
                self._end(task, outcome, None, f"no answer, though it was asked {TRIES} times{self._newer(task.name)}")
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
                self._exact = pack.unpack(file.content)
                self.known |= self._exact
            except ValueError:
                self._listing = _Listing() if self._all else None
        return messages

    def _go_on(self, task: _Task, parameter: ParameterValue) -> None:
        if task.number is None:
            self._end(task, "read", parameter)
        elif task.stage == "read":
            self._begin(task, task.number, parameter)
        elif task.stage == "write":
            task.stage, task.tries, task.due_s = "verify", 0, 0.0
        elif same(parameter, task.wanted):
            self._end(task, "set", parameter)
        else:
            self._end(task, "refused", parameter, f"it keeps {parameter.text}")

    def _begin(self, task: _Task, number: int | float, parameter: ParameterValue) -> None:
        """Go on from what the vehicle has to what it is to have."""
        task.before = parameter = self._exact.get(task.name, parameter)
        if value.same_as(parameter, number):
            self._end(task, "kept", parameter)
            return
        try:
            task.wanted = value.carried(number, parameter.kind, bytewise=self.profile.integers_bytewise)
        except ValueError as error:
            self._end(task, "refused", parameter, str(error))
            return
        if same(parameter, task.wanted):
            self._end(task, "kept", parameter)
        elif self._dry_run:
            self._end(task, "would", parameter)
        else:
            task.stage, task.tries, task.due_s = "write", 0, 0.0
            self.written[task.name] = parameter

    def _verdict(self, task: _Task, error: int) -> tuple[Outcome, ParameterValue | None, str]:
        """End of a task by PARAM_ERROR's code."""
        if error == mav.MAV_PARAM_ERROR_DOES_NOT_EXIST:
            return "unknown", None, f"it does not know it{self._newer(task.name)}"
        return "refused", task.before, _ERRORS.get(error, f"it says error {error}")

    def _unread(self, name: str, task: _Task | None, why: str) -> None:
        """Name a parameter whose value cannot be read."""
        if task is not None:
            self._end(task, "refused", None, why)
        elif all(result.name != name for result in self.results):
            self.results.append(ParameterResult(name, "refused", None, None, why))

    def _newer(self, name: str) -> str:
        """Its name in other versions of the autopilot, behind a semicolon; empty where no table knows it."""
        advice = unknown_name(name, self.profile.renamed_parameters) if self.compid == AUTOPILOT else ""
        return f"; {advice}" if advice else ""

    def _end(self, task: _Task, outcome: Outcome, now: ParameterValue | None, why: str = "") -> None:
        self._tasks.pop(task.name, None)
        self.results.append(ParameterResult(task.name, outcome, task.before, now, why, task.wanted))

    def _list(self, listing: _Listing, content: Any, now_s: float) -> None:
        if content.param_index < content.param_count:  # 65535: sent unasked, or by name
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
        sent = value.to_wire(task.wanted, bytewise=self.profile.integers_bytewise)
        return codec.message("PARAM_SET", **self._to, param_id=task.name, param_value=sent, param_type=task.wanted.kind)
