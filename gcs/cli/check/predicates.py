"""Predicates that decide whether a reply has come, is wrong, or never came."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import Any

from gcs.cli.check.dialogue import CheckedVehicle, Judge, ReceivedMessage, Verdict, texts
from gcs.mavlink.command_protocol import result_name
from skytender import mavlink as mav

Fault = Callable[[CheckedVehicle, Any], str]
"""Fault of a message's fields; empty without one."""

OK = Verdict("ok")
REASONS_WITHIN_S = 0.3
"""ArduPilot says why it refuses after it has acknowledged."""


def no_fault(_: CheckedVehicle, __: Any) -> str:
    """Nothing is wrong with any content."""
    return ""


def never(_: CheckedVehicle) -> bool:
    """A refusal is none of a vehicle's rights."""
    return False


def always(_: CheckedVehicle) -> bool:
    """A refusal is as good as an answer."""
    return True


def _named(received: Sequence[ReceivedMessage], name: str) -> Iterator[Any]:
    return (h.fields for h in received if h.name == name)


def _names(received: Sequence[ReceivedMessage]) -> set[str]:
    """Names of received messages, also of those that no dialect of ours holds: those have no fields to read."""
    return {h.name for h in received}


def _final_acks(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage], command: int) -> list[Any]:
    """The acknowledgements of `command` that end it and are addressed to us or to everyone."""
    sysid, compid = vehicle.station
    return [
        ack
        for ack in _named(received, "COMMAND_ACK")
        if ack.command == command
        and ack.result != mav.MAV_RESULT_IN_PROGRESS
        and ack.target_system in (0, sysid)
        and ack.target_component in (0, compid)
    ]


def answered(
    name: str, fault: Fault = no_fault, *, ours: Callable[[CheckedVehicle, Any], bool] = lambda *_: True
) -> Judge:
    """A message of this name that is meant (`ours`) has come."""

    def judge(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict | None:
        for content in _named(received, name):
            if ours(vehicle, content):
                wrong = fault(vehicle, content)
                return Verdict("wrong", wrong) if wrong else OK
        return None

    return judge


def acknowledged(
    command: int,
    *,
    then: str | None = None,
    may_refuse: Callable[[CheckedVehicle], bool] = never,
    fault: Fault = no_fault,
) -> tuple[Judge, Callable[[CheckedVehicle, Sequence[ReceivedMessage]], Verdict]]:
    """A final acknowledgement has come and, where it accepts, the message `then` too; as (judge, at_end)."""

    def refused(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage], ack: Any) -> Verdict:
        reasons = "; ".join(texts(received))
        said = f"refused: {result_name(ack.result)}" + (f", {reasons}" if reasons else "")
        return Verdict("ok" if may_refuse(vehicle) else "wrong", said)

    def judge(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict | None:
        acks = _final_acks(vehicle, received, command)
        if not acks:
            return None
        if acks[0].result != mav.MAV_RESULT_ACCEPTED:
            acked_s = next(h.at_s for h in received if h.fields is acks[0])
            waits = not may_refuse(vehicle) and received[-1].at_s - acked_s < REASONS_WITHIN_S
            return None if waits else refused(vehicle, received, acks[0])
        if then is None:
            return OK
        if then not in _names(received):
            return None
        wrong = fault(vehicle, next(_named(received, then)))
        return Verdict("wrong", wrong) if wrong else OK

    def at_end(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict:
        if acks := _final_acks(vehicle, received, command):
            if acks[0].result != mav.MAV_RESULT_ACCEPTED:
                return refused(vehicle, received, acks[0])
            return Verdict("wrong", f"accepted, but {then} never came")
        if then in _names(received):
            return Verdict("missing", f"{then} came, but no COMMAND_ACK")
        return Verdict("missing", "no COMMAND_ACK")

    return judge, at_end


def refuses(command: int) -> Judge:
    """An unknown command is refused, once."""

    def judge(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict | None:
        acks = _final_acks(vehicle, received, command)
        if not acks:
            return None
        if acks[0].result == mav.MAV_RESULT_ACCEPTED:
            return Verdict("wrong", "accepted a command that does not exist")
        return OK

    return judge


def leaves_alone(what: str) -> Judge:
    """A command that is not to be read: any acknowledgement shows that it was obeyed, although it was `what`."""
    obeyed = Verdict("wrong", f"obeyed a command {what}")
    return lambda _, received: obeyed if any(_named(received, "COMMAND_ACK")) else None


def _counted(vehicle: CheckedVehicle, name: str) -> list[float]:
    """Arrivals of a message since rates count, s."""
    return [at_s for at_s in vehicle.arrivals_s.get(name, ()) if at_s >= vehicle.rates_count_from_s]


def streamed(name: str, at_least_hz: float) -> Callable[[CheckedVehicle, Sequence[ReceivedMessage]], Verdict]:
    """The message has come unasked, since rates count, about as often as is wanted, at last with finite numbers."""

    def at_end(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
        arrivals_s = _counted(vehicle, name)
        window_s = max(times[-1] for times in vehicle.arrivals_s.values()) - vehicle.rates_count_from_s
        if not arrivals_s:
            return Verdict("missing", f"not heard in {window_s:.1f} s")
        numbers = ((field, x) for field, x in vehicle.of(name)._asdict().items() if isinstance(x, float))
        if odd := [f"{field} is {x}" for field, x in numbers if not math.isfinite(x)]:
            return Verdict("wrong", ", ".join(odd))
        if len(arrivals_s) < 0.8 * at_least_hz * window_s - 1.0:
            return Verdict("late", f"{len(arrivals_s) / window_s:.1f} Hz, wanted {at_least_hz:g} Hz")
        return OK

    return at_end


def steady(name: str, within_s: float) -> Callable[[CheckedVehicle, Sequence[ReceivedMessage]], Verdict]:
    """The message never paused for longer than its listeners' patience, since rates count."""

    def at_end(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
        times_s = [vehicle.rates_count_from_s, *_counted(vehicle, name)]
        gap_s = max((b - a for a, b in pairwise(times_s)), default=0.0)
        return Verdict("wrong", f"paused for {gap_s:.1f} s") if gap_s > within_s else OK

    return at_end
