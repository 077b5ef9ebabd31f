"""Constants and tables of `elementary`, computed in whole numbers of 160 bits, so that none is typed in.

Each number is given as a sum of doubles: the first has few enough bits that its products with whole numbers are exact.
"""

from __future__ import annotations

from math import isqrt

BITS = 160
ONE = 1 << BITS

POWER_STEPS = 128
"""Steps of the table of 2^x on [0, 1)."""
LOG_STEPS = 128
"""Steps of the table of log2 on [1, 2]."""
ARCTANGENT_STEPS = 16
"""Steps of the table of atan on [0, 1]."""


def _odd_series(n: int, d: int, sign: int) -> int:
    """x + sign·x³/3 + x⁵/5 + … of x = n/d: artanh x with sign 1, atan x with -1."""
    total, power, k = 0, ONE * n // d, 1
    while power:
        total += power // k
        power = sign * power * n * n // (d * d)
        if power == -1:  # what rounding down leaves of a negative number
            break
        k += 2
    return total


def parts(value: int, *bits: int) -> tuple[float, ...]:
    """A number as a sum of doubles, each but the last a multiple of 2^-bits; `value` counts 2^-160."""
    made = []
    for count in bits:
        unit = 1 << (BITS - count)
        multiple = (value + unit // 2) // unit
        made.append(multiple / (1 << count))
        value -= multiple * unit
    return (*made, value / ONE)


LN_2 = 2 * _odd_series(1, 3, 1)
PI = 16 * _odd_series(1, 5, -1) - 4 * _odd_series(1, 239, -1)  # Machin 1706


def powers() -> list[int]:
    """2^(j/128)."""
    root = 2 * ONE
    for _ in range(POWER_STEPS.bit_length() - 1):
        root = isqrt(root * ONE)
    made = [ONE]
    for _ in range(1, POWER_STEPS):
        made.append(made[-1] * root // ONE)
    return made


def logarithms() -> list[int]:
    """log2(1 + m/128) of m from 0 to 128."""
    made = [0]
    for m in range(LOG_STEPS, 2 * LOG_STEPS):  # ln(1 + 1/m) = 2 artanh(1/(2m + 1))
        made.append(made[-1] + 2 * _odd_series(1, 2 * m + 1, 1) * ONE // LN_2)
    return made


def arctangents() -> list[int]:
    """atan(m/16) of m from 0 to 16."""
    made = [0]
    for m in range(ARCTANGENT_STEPS):  # atan b - atan a = atan((b - a)/(1 + a b))
        step = _odd_series(ARCTANGENT_STEPS, ARCTANGENT_STEPS * ARCTANGENT_STEPS + m * (m + 1), -1)
        made.append(made[-1] + step)
    return made
