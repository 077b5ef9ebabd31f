"""Decisions as lines of decisions.jsonl.

Nearly all decisions are set points, and nearly all the time that they take is for finding the shortest decimals of
their numbers. msgspec finds the same ones in a fifth of the time, and writes them all at once.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import msgspec
import numpy as np

from gcs.mavlink.setpoints import SetPoint, SetPoints

_SET_POINT = '{"kind":"set_point","p_ned":[%%s,%%s,%%s],"sysid":%d,"t_s":@,"v_ned":[%%s,%%s,%%s]}\n'
_encode = json.JSONEncoder(sort_keys=True, allow_nan=False, separators=(",", ":")).encode
_encode_numbers = msgspec.json.Encoder().encode
_PLAIN = b"0123456789.,-"


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


def decision_lines(decisions: Decisions) -> list[bytes]:
    """Each as its line: keys sorted, no NaN. Raises ValueError, TypeError as `json` does."""
    lines: list[bytes] = []
    for some in decisions:
        fast = _set_point_lines(some) if isinstance(some, TickSetPoints) else None
        lines += [_encode(one).encode() + b"\n" for one in each([some])] if fast is None else fast
    return lines


def _set_point_lines(tick: TickSetPoints) -> list[bytes] | None:
    """The lines that `json` makes of set points. None where one holds other things than finite numbers: `json` knows
    what is to become of it."""
    flat: list[float] = []
    if isinstance(tick.points, SetPoints):
        sysids = tick.points.sysids
        flat = np.hstack((tick.points.p_ned, tick.points.v_ned)).ravel().tolist()
    else:
        sysids = tuple([point.sysid for point in tick.points])
        for _, p_ned, v_ned in tick.points:
            flat += p_ned
            flat += v_ned
    try:
        text = _encode_numbers(flat)
    except (TypeError, ValueError):
        return None
    other = text.translate(None, _PLAIN)
    if other[1:-1].strip(b"e") or len(flat) != 6 * len(sysids) or any(type(sysid) is not int for sysid in sysids):
        return None
    parts = text.decode()[1:-1].split(",") if flat else []
    if other != b"[]" or b".0000" in text:
        parts = [
            _as_json(part, number) if "e" in part or ".0000" in part else part
            for part, number in zip(parts, flat, strict=True)
        ]
    form = _form(sysids).replace("@", _encode(tick.t_s))
    return (form % tuple(parts)).encode().splitlines(keepends=True)


@lru_cache(maxsize=4)  # the same vehicles are steered tick after tick
def _form(sysids: tuple[int, ...]) -> str:
    """Lines for the set points of these vehicles, without time and numbers."""
    return "".join([_SET_POINT % sysid for sysid in sysids])


def _as_json(part: str, number: Any) -> str:
    """Decimals as `json` writes them, which has an exponent for what is below 0.0001, and writes all others alike."""
    return float.__repr__(number) if "e" in part or part.startswith(("0.0000", "-0.0000")) else part
