"""Set points of a tick as lines of decisions.jsonl: nearly all that these hold.

Nearly all the time that they take is for finding the shortest decimals of their numbers. msgspec finds them quickly;
compiled code puts them between the words, as `json` writes them.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import cython
import msgspec
import numpy as np
from cython.cimports.libc.string import memcpy
from numpy.typing import NDArray

from gcs.frame_spans import FrameSpans
from gcs.mavlink.setpoints import SetPoints

Ints = NDArray[np.int64]

_encode = msgspec.json.Encoder().encode
_WORDS = len(b'{"kind":"set_point","p_ned":[],"sysid":,"t_s":,"v_ned":[]}\n')
_LONGEST = 25
"""Of a number, `-2.2250738585072014e-308` with a comma or a bracket."""


def set_point_lines(t_s: float, points: SetPoints) -> FrameSpans | None:
    """A line for each of these set points, side by side. None where a number is not finite: no line has a form for
    it."""
    if type(t_s) is not float or t_s - t_s != 0.0:
        return None
    time, sysids, count = repr(t_s).encode(), _written(points.sysids), len(points)
    numbers = _encode(points.values.tolist())
    out = np.empty(count * (_WORDS + len(time) + 3 + 6 * _LONGEST), np.uint8)
    spans = np.empty((count, 2), np.int64)
    size = _lay_out(numbers, sysids, time, len(time), out, spans)
    return None if size < 0 else FrameSpans(out[:size].tobytes(), spans)


@lru_cache(maxsize=4)  # the same vehicles are steered tick after tick
def _written(sysids: tuple[int, ...]) -> bytes:
    """System ids, a comma behind each."""
    return b"".join([b"%d," % sysid for sysid in sysids])


def _is_digit(letter: int) -> bool:
    return ord("0") <= letter <= ord("9")


def _put(text: Any, size: int, out: Any, at: int) -> int:
    """Write a text of so many letters; where it ends."""
    memcpy(out + at, text, size)
    return at + size


def _put_number(text: Any, begin: int, out: Any, at: int) -> tuple[int, int]:
    """Write the decimals of a number as `json` does, with an exponent of two figures for what is below 0.0001; where
    it ends in the text, -1 for what is no number, and in `out`."""
    k = begin
    if text[k] == ord("-"):
        out[at] = ord("-")
        k, at = k + 1, at + 1
    small = True  # of the form 0.0000...
    for i in range(6):
        small = small and text[k + i] == (ord(".") if i == 1 else ord("0"))
    if small:
        k += 6
        out[at] = text[k]
        k, at = k + 1, at + 1
        if _is_digit(text[k]):
            out[at] = ord(".")
            at += 1
        while _is_digit(text[k]):
            out[at] = text[k]
            k, at = k + 1, at + 1
        out[at], out[at + 1], out[at + 2], out[at + 3] = ord("e"), ord("-"), ord("0"), ord("0") + 5
        return k, at + 4
    first = k
    while text[k] == ord(".") or _is_digit(text[k]):
        out[at] = text[k]
        k, at = k + 1, at + 1
    if k == first:
        return -1, at
    if text[k] == ord("e"):
        out[at] = ord("e")
        k += 1
        out[at + 1] = text[k] if text[k] == ord("-") else ord("+")
        if text[k] == ord("-"):
            k += 1
        at += 2
        if not _is_digit(text[k + 1]):
            out[at] = ord("0")
            at += 1
        while _is_digit(text[k]):
            out[at] = text[k]
            k, at = k + 1, at + 1
    return k, at


def _put_three(text: Any, begin: int, out: Any, at: int) -> tuple[int, int]:
    """Write three numbers of a list, with commas between them; as `_put_number`."""
    k = begin
    for axis in range(3):
        k, at = _put_number(text, k, out, at)
        if k < 0:
            return -1, at
        if axis < 2:
            out[at] = ord(",")
            k, at = k + 1, at + 1
    return k, at


def _lay_out(numbers: bytes, sysids: bytes, time: bytes, time_size: int, out: NDArray[np.uint8], spans: Ints) -> int:
    """Write the lines of n set points, and where each begins and ends into spans (n, 2); how much it is, -1
    where something is no number. `numbers`: position and velocity of each, as [[n,e,d,n,e,d],...]."""
    text = cython.address(out[0])
    place, at, sysid = 2, 0, 0
    for k in range(len(spans)):
        spans[k, 0] = at
        at = _put(b'{"kind":"set_point","p_ned":[', 29, text, at)
        place, at = _put_three(numbers, place, text, at)
        if place < 0:
            return -1
        at = _put(b'],"sysid":', 10, text, at)
        while sysids[sysid] != ord(","):
            text[at] = sysids[sysid]
            sysid, at = sysid + 1, at + 1
        sysid += 1
        at = _put(b',"t_s":', 7, text, at)
        at = _put(time, time_size, text, at)
        at = _put(b',"v_ned":[', 10, text, at)
        place, at = _put_three(numbers, place + 1, text, at)
        if place < 0:
            return -1
        place += 3
        at = _put(b"]}\n", 3, text, at)
        spans[k, 1] = at
    return at
