"""Answers of a program's own planner and policy, as decisions: written by the session that asked them, and read when
it is decided again, since they cannot be asked then (docs/protocol/socket.md#programs-that-act)."""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from gcs.scenario.guard import PluginFault
from gcs.scenario.plugins import PLANNER, POLICY, PluginClient, policy_of
from gcs.supervisor.script import AXES

PROGRAM, PLANNED, CHOSEN = "program", "planned", "chosen"
"""Kinds of decisions: what was the program's own; what its planner, and its policy, answered."""
ANSWERS = frozenset({PLANNED, CHOSEN})
FAILED = "policy failed"
_PARTS = {PLANNER: "planner", POLICY: "policy"}


def object_record(key: str, name: str, *, assigns: bool) -> dict[str, Any]:
    """Decision at time 0 that something is the program's own; `assigns`: whether it has a method `assign`."""
    return {"t_s": 0.0, "kind": PROGRAM, "part": _PARTS[key], "name": name, "assigns": assigns}


def answer_record(t_s: float, key: str, rows: Sequence[Sequence[Any]]) -> dict[str, Any]:
    """Decision of the answers to a question, rows as `PluginClient.answers` gives them."""
    if key == POLICY:
        return {"t_s": t_s, "kind": CHOSEN, "receivers": {str(tanker): receiver for tanker, receiver in rows}}
    names = [str(row[0]) for row in rows]
    columns = {axis: {name: row[k] for name, row in zip(names, rows, strict=True)} for k, axis in enumerate(AXES, 1)}
    return {"t_s": t_s, "kind": PLANNED, **columns}


def rows_of(record: Mapping[str, Any]) -> list[Any]:
    """Rows of such a decision. Raises KeyError, TypeError, ValueError where it is none."""
    if record["kind"] == CHOSEN:
        return [(int(tanker), int(receiver)) for tanker, receiver in record["receivers"].items()]
    columns = [record[axis] for axis in AXES]
    return [(int(sysid), *(float(column[sysid]) for column in columns)) for sysid in columns[0]]


class RecordedObjects(PluginClient):
    """Answers as they were recorded. See `PluginClient` for the methods."""

    def __init__(self, records: Iterable[Mapping[str, Any]]) -> None:
        """records: all decisions, the first of which say what was the program's own."""
        keys = {part: key for key, part in _PARTS.items()}
        begin = itertools.takewhile(lambda record: record["kind"] == PROGRAM, records)
        self.objects = {keys[record["part"]]: record for record in begin if record.get("part") in keys}
        self._policies = {policy_of(key, str(record["name"])) for key, record in self.objects.items()}
        self._answers: dict[str, deque[list[Any]]] = {key: deque() for key in self.objects}
        self._faults: list[PluginFault] = []

    @property
    def ended(self) -> bool:
        return False

    def made(self, key: str) -> bool:
        return bool(self.objects[key].get("assigns"))

    def ask(self, key: str, asked: Any) -> None:
        """Nothing is asked."""

    def answers(self, key: str) -> list[Any]:
        return self._answers[key].popleft() if self._answers[key] else []

    def pop_faults(self) -> list[PluginFault]:
        taken, self._faults = self._faults, []
        return taken

    def take(self, record: Mapping[str, Any]) -> None:
        """Answer, from the next tick on, what a decision says. Raises KeyError, TypeError, ValueError."""
        if record["kind"] in ANSWERS:
            key = PLANNER if record["kind"] == PLANNED else POLICY
            if key in self._answers:
                self._answers[key].append(rows_of(record))
        elif record["kind"] == FAILED and record.get("policy") in self._policies:
            self._faults.append(PluginFault(int(record["sysid"]), str(record["policy"]), str(record["problem"])))

    @property
    def text(self) -> str:
        """A sentence about what was the program's own; empty where nothing was."""
        if not self.objects:
            return ""
        named = " and ".join(f"{record['part']} {record['name']}" for record in self.objects.values())
        was = "was a Python object" if len(self.objects) == 1 else "were Python objects"
        return f"the {named} {was} of that program and cannot be asked again: answers are taken from the recording."
