"""The command protocol as the supervisor speaks it: acknowledgement, re-sending, time-out; all in session time.

Rules:
1. A target has one command of an id in flight; the next one of that id waits its turn, since their acknowledgements
   cannot be distinguished. Different ids do not wait for each other.
2. Without an acknowledgement within `timeout_s` the command is sent again with its confirmation counted up, at most
   RETRIES times; after one more `timeout_s` its outcome is `timeout`.
3. IN_PROGRESS gives it `PROGRESS_S` more. Should the final acknowledgement then be lost, re-sending goes on by rule 2:
   targets answer a repeated command again.
4. ACCEPTED ends it as `accepted`, any other result as `rejected`, with the code.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from skytender import mavlink as mav

ARMING, OPERATOR = "pilot", "operator"
"""First words of commands' tokens: the part of the supervisor that sends them."""

TIMEOUT_S = 0.5
RETRIES = 3
PROGRESS_S = 5.0
# Session times are sums of tick lengths; a deadline must not slip a tick for their last bits.
_ROUNDING_S = 1e-6

ACCEPTED: int = mav.MAV_RESULT_ACCEPTED
IN_PROGRESS: int = mav.MAV_RESULT_IN_PROGRESS


def result_name(result: int) -> str:
    """MAV_RESULT's own name: `TEMPORARILY_REJECTED`."""
    return mav.ENUMS["MAV_RESULT"].get(result, f"result {result}").removeprefix("MAV_RESULT_")


def result_in_words(result: int) -> str:
    """MAV_RESULT for a person: `temporarily rejected`."""
    return result_name(result).replace("_", " ").lower()


Outcome = Literal["accepted", "rejected", "timeout"]


class CommandTarget(NamedTuple):
    """Addressee of a command; component 0 is every component of the system."""

    sysid: int
    compid: int


@dataclass(frozen=True)
class CommandLong:
    """COMMAND_LONG: up to seven parameters, the rest 0 (NaN where the autopilot wants "unset")."""

    target: CommandTarget
    command: int
    params: tuple[float, ...] = ()

    def message(self, attempt: int) -> Message:
        """The message of the first (0) or a repeated attempt. Raises ValueError for a value that does not fit."""
        if len(self.params) > 7:
            raise ValueError(f"command {self.command} has {len(self.params)} parameters; COMMAND_LONG holds 7")
        params = (*self.params, *[0.0] * (7 - len(self.params)))
        return codec.message(
            "COMMAND_LONG",
            target_system=self.target.sysid,
            target_component=self.target.compid,
            command=self.command,
            confirmation=attempt,
            **{f"param{index}": value for index, value in enumerate(params, 1)},
        )


class CommandResult(NamedTuple):
    """Result of a command: `result` is the MAV_RESULT, None after a time-out; `token` the sender's own mark."""

    command: int
    target: CommandTarget
    outcome: Outcome
    result: int | None
    attempts: int
    token: Any


class Step(NamedTuple):
    """Consequences of an acknowledgement or of time: messages to send now, in order, and commands that ended."""

    messages: list[Message]
    results: list[CommandResult]


@dataclass
class _Pending:
    command: CommandLong
    timeout_s: float
    token: Any
    retries: int = RETRIES
    attempts: int = 0
    deadline_s: float = 0.0


@dataclass
class CommandQueue:
    """The commands to one vehicle; `sysid` and `compid` are the commander's own, to which acknowledgements are
    addressed."""

    sysid: int
    compid: int
    resent: int = 0
    """re-sent commands so far: the summary's `command_retries`"""
    _waiting: dict[tuple[CommandTarget, int], deque[_Pending]] = field(default_factory=dict)
    """by target and command id; the first of each is in flight"""

    @property
    def pending(self) -> bool:
        """Whether a command has not ended yet."""
        return bool(self._waiting)

    def send(
        self, command: CommandLong, now_s: float, timeout_s: float = TIMEOUT_S, token: Any = None
    ) -> list[Message]:
        """Send a command, or let it wait its turn; the messages to send now.

        Raises ValueError for a value that does not fit.
        """
        command.message(0)
        line = self._waiting.setdefault((command.target, command.command), deque())
        line.append(_Pending(command, timeout_s, token))
        return [self._attempt(line[0], now_s)] if len(line) == 1 else []

    def withdraw(self, unwanted: Callable[[Any], bool]) -> list[Any]:
        """Send no more commands with a token that is `unwanted`; the tokens of commands never sent, which get no
        result.

        One that is under way is not sent again: it ends by its acknowledgement or its time-out.
        """
        never_sent: list[Any] = []
        for line in self._waiting.values():
            for flight in list(line)[1:]:
                if unwanted(flight.token):
                    line.remove(flight)
                    never_sent.append(flight.token)
            if unwanted(line[0].token):
                line[0].retries = 0
        return never_sent

    def on_ack(self, sysid: int, compid: int, ack: Any, now_s: float) -> Step:
        """Take in COMMAND_ACK's fields from this sender; one to another sender, or of nothing in flight, is ignored."""
        step = Step([], [])
        if ack.target_system not in (0, self.sysid) or ack.target_component not in (0, self.compid):
            return step
        for target in (CommandTarget(sysid, compid), CommandTarget(sysid, 0)):
            line = self._waiting.get((target, ack.command))
            if line is None:
                continue
            if ack.result == IN_PROGRESS:
                line[0].deadline_s = now_s + PROGRESS_S
            else:
                self._end(line, "accepted" if ack.result == ACCEPTED else "rejected", ack.result, now_s, step)
            break
        return step

    def poll(self, now_s: float) -> Step:
        """Let time pass: what is to be sent again, what has timed out and what then takes its turn."""
        step = Step([], [])
        for line in list(self._waiting.values()):
            flight = line[0]
            if now_s < flight.deadline_s - _ROUNDING_S:
                continue
            if flight.attempts <= flight.retries:
                self.resent += 1
                step.messages.append(self._attempt(flight, now_s))
            else:
                self._end(line, "timeout", None, now_s, step)
        return step

    def _attempt(self, flight: _Pending, now_s: float) -> Message:
        message = flight.command.message(min(flight.attempts, 255))
        flight.attempts += 1
        flight.deadline_s = now_s + flight.timeout_s
        return message

    def _end(self, line: deque[_Pending], outcome: Outcome, result: int | None, now_s: float, step: Step) -> None:
        """Report the line's first command and start its next."""
        ended = line.popleft()
        command, target = ended.command.command, ended.command.target
        step.results.append(CommandResult(command, target, outcome, result, ended.attempts, ended.token))
        if line:
            step.messages.append(self._attempt(line[0], now_s))
        else:
            del self._waiting[target, command]


@dataclass(frozen=True)
class CommandRequest:
    """A command that a part of the ground station sends to a vehicle; `token` comes back with its result."""

    sysid: int
    command: int
    params: tuple[float, ...]
    """the first of its seven; the others are 0"""
    token: str

    @property
    def is_order(self) -> bool:
        """Whether it is an operator's."""
        return self.token.startswith(OPERATOR)
