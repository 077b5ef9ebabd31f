"""Set points of a tick as lines of decisions.jsonl: nearly all that these hold.

Nearly all the time that they take is for finding the shortest decimals of their numbers. msgspec finds them quickly;
compiled code puts them between the words, as `json` writes them.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans
from gcs.kernels import UNCOUNTED, inner, kernel
from gcs.mavlink.setpoints import SetPoints

Bytes = NDArray[np.uint8]
Ints = NDArray[np.int64]

_encode = msgspec.json.Encoder().encode
_HEAD, _SYSID, _TIME, _VELOCITY, _TAIL = (
    np.frombuffer(text, np.uint8)
    for text in (b'{"kind":"set_point","p_ned":[', b'],"sysid":', b',"t_s":', b',"v_ned":[', b"]}\n")
)
_WORDS = sum(len(text) for text in (_HEAD, _SYSID, _TIME, _VELOCITY, _TAIL))
_LONGEST = 25
"""Of a number, `-2.2250738585072014e-308` with a comma or a bracket."""
_COMMA, _MINUS, _POINT, _ZERO, _NINE, _E, _PLUS = b",-.09e+"


def set_point_lines(t_s: float, points: SetPoints) -> FrameSpans | None:
    """A line for each of these set points, side by side. None where a number is not finite: no line has a form for
    it."""
    if type(t_s) is not float or t_s - t_s != 0.0:
        return None
    time, sysids, count = repr(t_s).encode(), _written(points.sysids), len(points)
    numbers = _encode(points.values.tolist())
    out = np.empty(count * (_WORDS + len(time) + 3 + 6 * _LONGEST), np.uint8)
    spans = np.empty((count, 2), np.int64)
    size = _lay_out(numbers, sysids, time, out, spans)
    return None if size < 0 else FrameSpans(out[:size].tobytes(), spans)


@lru_cache(maxsize=4)  # the same vehicles are steered tick after tick
def _written(sysids: tuple[int, ...]) -> bytes:
    """System ids, a comma behind each."""
    return b"".join([b"%d," % sysid for sysid in sysids])


@inner(**UNCOUNTED)
def _put(text: Any, out: Bytes, at: int) -> int:
    """Write all of a text; where it ends."""
    for i in range(len(text)):
        out[at + i] = text[i]
    return at + len(text)


@inner(**UNCOUNTED)
def _put_number(text: Any, begin: int, out: Bytes, at: int) -> tuple[int, int]:
    """Write the decimals of a number as `json` does, with an exponent of two figures for what is below 0.0001; where
    it ends in the text, -1 for what is no number, and in `out`."""
    k = begin
    if text[k] == _MINUS:
        out[at] = _MINUS
        k, at = k + 1, at + 1
    small = True  # of the form 0.0000...
    for i in range(6):
        small = small and text[k + i] == (_POINT if i == 1 else _ZERO)
    if small:
        k += 6
        out[at] = text[k]
        k, at = k + 1, at + 1
        if text[k] >= _ZERO:
            out[at] = _POINT
            at += 1
        while text[k] >= _ZERO and text[k] <= _NINE:
            out[at] = text[k]
            k, at = k + 1, at + 1
        out[at], out[at + 1], out[at + 2], out[at + 3] = _E, _MINUS, _ZERO, _ZERO + 5
        return k, at + 4
    first = k
    while text[k] == _POINT or (text[k] >= _ZERO and text[k] <= _NINE):
        out[at] = text[k]
        k, at = k + 1, at + 1
    if k == first:
        return -1, at
    if text[k] == _E:
        out[at] = _E
        k += 1
        out[at + 1] = text[k] if text[k] == _MINUS else _PLUS
        if text[k] == _MINUS:
            k += 1
        at += 2
        if text[k + 1] < _ZERO or text[k + 1] > _NINE:
            out[at] = _ZERO
            at += 1
        while text[k] >= _ZERO and text[k] <= _NINE:
            out[at] = text[k]
            k, at = k + 1, at + 1
    return k, at


@inner(**UNCOUNTED)
def _put_three(text: Any, begin: int, out: Bytes, at: int) -> tuple[int, int]:
    """Write three numbers of a list, with commas between them; as `_put_number`."""
    k = begin
    for axis in range(3):
        k, at = _put_number(text, k, out, at)
        if k < 0:
            return -1, at
        if axis < 2:
            out[at] = _COMMA
            k, at = k + 1, at + 1
    return k, at


@kernel(**UNCOUNTED)
def _lay_out(numbers: bytes, sysids: bytes, time: bytes, out: Bytes, spans: Ints) -> int:
    """Kernel: write the lines of n set points, and where each begins and ends into spans (n, 2); how much it is, -1
    where something is no number. `numbers`: position and velocity of each, as [[n,e,d,n,e,d],...]."""
    place, at, sysid = 2, 0, 0
    for k in range(len(spans)):
        spans[k, 0] = at
        at = _put(_HEAD, out, at)
        place, at = _put_three(numbers, place, out, at)
        if place < 0:
            return -1
        at = _put(_SYSID, out, at)
        while sysids[sysid] != _COMMA:
            out[at] = sysids[sysid]
            sysid, at = sysid + 1, at + 1
        sysid += 1
        at = _put(_TIME, out, at)
        at = _put(time, out, at)
        at = _put(_VELOCITY, out, at)
        place, at = _put_three(numbers, place + 1, out, at)
        if place < 0:
            return -1
        place += 3
        at = _put(_TAIL, out, at)
        spans[k, 1] = at
    return at
