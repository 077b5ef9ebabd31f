"""Reads the set points of decisions.jsonl, nearly all of its lines, by compiled code: JSON takes ten times as long.

Only the one form in which the recorder writes them is read; every other line is handed back. Numbers come out as JSON
reads them, to the last bit; a line with one for which that is not certain is handed back too.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Octets = NDArray[np.uint8]

P_NED, SYSID, T_S = slice(0, 3), 3, 4
"""Columns of what `scan` returns, in the order in which a line tells them; its velocity, which follows, is left out."""
COLUMNS = 5

_FORM = np.frombuffer(b'{"kind":"set_point","p_ned":[#,#,#],"sysid":#,"t_s":#,"v_ned":[#,#,#]}\n', dtype=np.uint8)
_NUMBER = ord("#")
_MOST_DIGITS = 18
"""Whole numbers of so many digits fit into 63 bits."""
_EXACT_POWERS = np.array([float(f"1e{k}") for k in range(23)])
"""The powers of ten that a float64 holds exactly."""
_EXACT_WHOLE = 1 << 53
_SPLIT = 134_217_729.0
"""2²⁷ + 1: cuts a float64 into two halves whose products are exact (Dekker 1971)."""
_DOUBT = 2.0**-40


def scan(block: bytes) -> tuple[Floats, list[bytes]]:
    """(n, COLUMNS) numbers of the set points in whole lines, and the lines that are none in the recorder's form."""
    count = block.count(b"\n") + 1
    rows = np.empty((count, COLUMNS))
    others = np.empty((count, 2), dtype=np.int64)
    found, rest = _scan(np.frombuffer(block, dtype=np.uint8), _FORM, rows, others)
    return rows[:found].copy(), [block[begin:end] for begin, end in others[:rest].tolist()]


@njit(cache=True)
def _scan(data: Octets, form: Octets, rows: Floats, others: NDArray[np.int64]) -> tuple[int, int]:
    """Kernel: fills rows (lines, COLUMNS) and others (lines, 2), begins and ends; how many of each."""
    found = rest = begin = 0
    while begin < data.size:
        at, column = begin, 0
        for k in range(form.size):
            if at >= data.size:
                at = -1
            elif form[k] != _NUMBER:
                at = at + 1 if data[at] == form[k] else -1
            else:
                negative, whole, power, at = _decimal(data, at)
                if at >= 0 and column < COLUMNS:
                    value, certain = _nearest(whole, power)
                    rows[found, column] = -value if negative else value
                    at = at if certain else -1
                column += 1
            if at < 0:
                break
        if at >= 0:
            found += 1
            begin = at
            continue
        end = begin
        while end < data.size and data[end] != 0x0A:
            end += 1
        end = min(end + 1, data.size)
        others[rest, 0], others[rest, 1] = begin, end
        rest += 1
        begin = end
    return found, rest


@njit(cache=True)
def _decimal(data: Octets, at: int) -> Any:
    """Kernel: JSON's number at a place as (negative, whole number, power of ten, place behind it); the place is
    negative where there is no number, or one of too many digits."""
    size = data.size
    negative = at < size and data[at] == 0x2D
    at += negative
    whole, power, digits = 0, 0, 0
    first = at
    while at < size and 0x30 <= data[at] <= 0x39:
        whole = 10 * whole + (data[at] - 0x30)
        digits += whole > 0
        at += 1
        if digits > _MOST_DIGITS:
            return negative, whole, power, -1
    if at == first or (data[first] == 0x30 and at > first + 1):
        return negative, whole, power, -1
    if at < size and data[at] == 0x2E:
        first = at + 1
        at = first
        while at < size and 0x30 <= data[at] <= 0x39:
            whole = 10 * whole + (data[at] - 0x30)
            digits += whole > 0
            at += 1
            if digits > _MOST_DIGITS:
                return negative, whole, power, -1
        power = first - at
        if at == first:
            return negative, whole, power, -1
    if at < size and (data[at] == 0x65 or data[at] == 0x45):
        at += 1
        down = at < size and data[at] == 0x2D
        at += at < size and (data[at] == 0x2D or data[at] == 0x2B)
        first = at
        exponent = 0
        while at < size and 0x30 <= data[at] <= 0x39 and at < first + 4:
            exponent = 10 * exponent + (data[at] - 0x30)
            at += 1
        if at == first:
            return negative, whole, power, -1
        power += -exponent if down else exponent
    return negative, whole, power, at


@njit(cache=True)
def _nearest(whole: int, power: int) -> tuple[float, bool]:
    """Kernel: the float64 nearest to whole * 10**power, and whether that is certain.

    One rounding of exact operands is right (Clinger 1990). A longer whole number is the sum of two floats; its quotient
    is corrected by what is left over (Dekker 1971), and is certain where the correction is nowhere near half a unit.
    """
    if whole == 0:
        return 0.0, True
    if power > 0 or power <= -_EXACT_POWERS.size:
        return 0.0, False
    divisor = _EXACT_POWERS[-power]
    high = float(whole)
    if whole <= _EXACT_WHOLE:
        return high / divisor, True
    quotient = high / divisor
    product = quotient * divisor
    cut = _SPLIT * quotient
    q_high = cut - (cut - quotient)
    cut = _SPLIT * divisor
    d_high = cut - (cut - divisor)
    q_low, d_low = quotient - q_high, divisor - d_high
    beyond = ((q_high * d_high - product) + q_high * d_low + q_low * d_high) + q_low * d_low
    more = (((high - product) - beyond) + float(whole - np.int64(high))) / divisor
    value = quotient + more
    rest = more - (value - quotient)
    return value, value + rest * (1.0 + _DOUBT) == value
