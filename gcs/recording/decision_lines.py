"""Decisions as lines of decisions.jsonl."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from gcs.frame_spans import FrameSpans
from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.recording.set_point_lines import set_point_lines

_encode = json.JSONEncoder(sort_keys=True, allow_nan=False, separators=(",", ":")).encode


class TickSetPoints(NamedTuple):
    """All set points of one tick: a decision each."""

    t_s: float
    points: Sequence[SetPoint]

    def decisions(self) -> list[dict[str, Any]]:
        """Each as a decision."""
        return [
            {"t_s": self.t_s, "kind": "set_point", "sysid": sysid, "p_ned": p_ned, "v_ned": v_ned}
            for sysid, p_ned, v_ned in self.points
        ]


Decisions = Sequence[Mapping[str, Any] | TickSetPoints]


def each(decisions: Decisions) -> list[Mapping[str, Any]]:
    """Decisions one by one."""
    return [
        decision
        for some in decisions
        for decision in (some.decisions() if isinstance(some, TickSetPoints) else (some,))
    ]


def decision_lines(decisions: Decisions) -> FrameSpans:
    """Each as its line: keys sorted, no NaN. Raises ValueError, TypeError as `json` does."""
    return FrameSpans.joined([_lines(some) for some in decisions])


def _lines(some: Mapping[str, Any] | TickSetPoints) -> Sequence[bytes]:
    if isinstance(some, TickSetPoints):
        columns = _columns(some.points)
        lines = None if columns is None else set_point_lines(some.t_s, columns)
        if lines is not None:
            return lines
    return [_encode(one).encode() + b"\n" for one in each([some])]


def _columns(points: Sequence[SetPoint]) -> SetPoints | None:
    """These set points as columns; None where those would not be just the same."""
    if isinstance(points, SetPoints):
        return points
    for point in points:
        sysid, p_ned, v_ned = point
        if type(sysid) is not int or {*map(type, p_ned), *map(type, v_ned)} != {float}:
            return None
        if len(p_ned) != len(v_ned) or len(p_ned) != 3:
            return None
    return SetPoints.of(points)
