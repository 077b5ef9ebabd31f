"""Decisions as lines of decisions.jsonl.

Nearly all decisions are set points, and nearly all the time that they take is for finding the shortest decimals of
their numbers. msgspec finds the same ones in a fifth of the time, and writes them all at once.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

import msgspec

SET_POINT_KEYS = 5
_SET_POINT = '{"kind":"set_point","p_ned":[%s,%s,%s],"sysid":%s,"t_s":%s,"v_ned":[%s,%s,%s]}\n'
_encode = json.JSONEncoder(sort_keys=True, allow_nan=False, separators=(",", ":")).encode
_encode_numbers = msgspec.json.Encoder().encode
_PLAIN = b"0123456789.,-"


def decision_lines(decisions: Sequence[Mapping[str, Any]]) -> list[bytes]:
    """Each as its line: keys sorted, no NaN. Raises ValueError, TypeError as `json` does."""
    lines: list[bytes] = []
    for are_set_points, run in groupby(decisions, lambda decision: decision.get("kind") == "set_point"):
        some = list(run)
        fast = _set_point_lines(some) if are_set_points else None
        lines += fast if fast is not None else [_encode(decision).encode() + b"\n" for decision in some]
    return lines


def _set_point_lines(points: Sequence[Mapping[str, Any]]) -> list[bytes] | None:
    """The lines that `json` makes of set points. None where one is not the usual five keys with finite numbers: `json`
    knows what is to become of it."""
    flat: list[Any] = []
    try:
        for point in points:
            (n, e, d), (v_n, v_e, v_d) = point["p_ned"], point["v_ned"]
            flat += (n, e, d, point["sysid"], point["t_s"], v_n, v_e, v_d)
        text = _encode_numbers(flat)
    except (KeyError, TypeError, ValueError):
        return None
    other = text.translate(None, _PLAIN)
    if other[1:-1].strip(b"e") or any(len(point) != SET_POINT_KEYS for point in points):
        return None
    parts = text.decode()[1:-1].split(",")
    if other != b"[]" or b".0000" in text:
        parts = [
            _as_json(part, number) if "e" in part or ".0000" in part else part
            for part, number in zip(parts, flat, strict=True)
        ]
    column = iter(parts)
    return [(_SET_POINT % values).encode() for values in zip(*[column] * 8, strict=True)]


def _as_json(part: str, number: Any) -> str:
    """Decimals as `json` writes them, which has an exponent for what is below 0.0001, and writes all others alike."""
    return float.__repr__(number) if "e" in part or part.startswith(("0.0000", "-0.0000")) else part
