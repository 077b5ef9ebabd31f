"""Acts of a program in Python in the session that it steps (set points, commands, faults, changes of the world), and
what came of them (docs/protocol/socket.md#programs-that-act).

All of it happens between two ticks, and stands in decisions.jsonl with the next one's time: the same acts at the same
ticks make the same session, and a recording can be decided again with them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from gcs.mavlink.command_protocol import OPERATOR, CommandRequest, CommandResult, Outcome, result_name
from gcs.scenario.faults import Fault, Injection
from gcs.scenario.parts.world import WORLD, Change, sentence
from gcs.supervisor.operator import ENDS
from gcs.telemetry.state import Vec3

STEERED, COMMAND, INJECT = "steered", "command", "inject"
"""Kinds of decisions that say what a program did."""
KINDS = frozenset({STEERED, COMMAND, INJECT, WORLD})
AXES = ("n", "e", "d", "vn", "ve", "vd")
"""Numbers of a set point: m and m/s, common NED frame."""
_TOKEN = "program"

Given = Mapping[int, tuple[Vec3, Vec3]]
"""Position, m, and velocity, m/s, by system id; common NED frame."""


class Acknowledgement(NamedTuple):
    """A vehicle's last word about a command, or its silence."""

    number: int
    """the command's, as its program counts"""
    sysid: int
    outcome: Outcome
    result: str | None
    """of MAV_RESULT, without that; None after a time-out"""


class Script:
    """The acts of one session's program. Times are of the session."""

    def __init__(self) -> None:
        self._points: Given = {}
        self._at_s: float | None = None
        self._awaited: dict[tuple[int, str], int] = {}
        """numbers of commands by vehicle and token"""
        self._acknowledged: list[Acknowledgement] = []
        self._records: list[dict[str, Any]] = []

    def steer(self, points: Given, at_s: float | None = None) -> None:
        """Let vehicles fly these set points instead of a planner's, while nothing else is said. All others are the
        planner's.

        at_s: when they are to be there; at ticks before it they are on their way there with their velocities. Without
        it they hold at each tick as they are.
        """
        self._points, self._at_s = points, at_s

    def given(self, now_s: float) -> Given:
        """Set points of the tick at a time, which are recorded."""
        if not self._points:
            return self._points
        points = self._points
        if self._at_s is not None and (after_s := now_s - self._at_s):
            points = {sysid: (_moved(p, v, after_s), v) for sysid, (p, v) in points.items()}
        columns = zip(*((*p, *v) for p, v in points.values()), strict=True)
        names = list(map(str, points))
        self._record(
            now_s,
            STEERED,
            {axis: dict(zip(names, column, strict=True)) for axis, column in zip(AXES, columns, strict=True)},
        )
        return points

    def ordered(self, number: int, sysid: int, command: str) -> None:
        """An operator's order is this program's, and `number` of its commands."""
        if command in ENDS:
            self._awaited[sysid, f"{OPERATOR} {command}"] = number

    def command(
        self, now_s: float, number: int, sysid: int, command: int, params: Sequence[float | None]
    ) -> CommandRequest:
        """The request of a MAV_CMD, number `number` of the program's commands; a parameter None is sent as NaN."""
        token = f"{_TOKEN} {number}"
        self._awaited[sysid, token] = number
        self._record(now_s, COMMAND, {"number": number, "sysid": sysid, "mav_cmd": command, "params": list(params)})
        return CommandRequest(sysid, command, tuple(math.nan if p is None else p for p in params), token)

    def injected(self, now_s: float, one: Injection) -> None:
        """A fault will happen, or happens at the next tick, that no scenario has."""
        self._record(now_s, INJECT, {"number": one.number, **one.fault.model_dump(mode="json", exclude_defaults=True)})

    def changed(self, now_s: float, change: Change) -> dict[str, Any]:
        """The world is another from the next tick on; the decision."""
        return self._record(now_s, WORLD, {**change, "text": sentence(change)})

    def acknowledge(self, sysid: int, result: CommandResult) -> None:
        """Take in the end of a command, which may be another's."""
        if self._awaited and (number := self._awaited.pop((sysid, str(result.token)), None)) is not None:
            name = None if result.result is None else result_name(result.result)
            self._acknowledged.append(Acknowledgement(number, sysid, result.outcome, name))

    def pop_acknowledged(self) -> list[Acknowledgement]:
        """Commands of the program that have ended since the last call."""
        taken, self._acknowledged = self._acknowledged, []
        return taken

    def pop_records(self) -> list[dict[str, Any]]:
        """Acts since the last call, as decisions."""
        taken, self._records = self._records, []
        return taken

    def _record(self, t_s: float, kind: str, content: Mapping[str, Any]) -> dict[str, Any]:
        record = {"t_s": t_s, "kind": kind, **content}
        self._records.append(record)
        return record


def steered_of(record: Mapping[str, Any]) -> Given:
    """Set points of a decision of kind `steered`. Raises KeyError, TypeError, ValueError where it is none."""
    columns = [record[axis] for axis in AXES]
    return as_points((int(sysid), [float(column[sysid]) for column in columns]) for sysid in columns[0])


def fault_of(record: Mapping[str, Any]) -> Fault:
    """Fault of a decision of kind `inject`. Raises ValueError where it is none."""
    return Fault.model_validate({key: record[key] for key in Fault.model_fields if key in record})


def as_points(rows: Iterable[tuple[int, Sequence[float]]]) -> Given:
    """Set points of (system id, six numbers)."""
    return {sysid: ((n, e, d), (vn, ve, vd)) for sysid, (n, e, d, vn, ve, vd) in rows}


def _moved(p_ned: Vec3, v_ned: Vec3, after_s: float) -> Vec3:
    return (p_ned[0] + v_ned[0] * after_s, p_ned[1] + v_ned[1] * after_s, p_ned[2] + v_ned[2] * after_s)
