"""Whether what a vehicle tells can be: finite, within physical range, and reached no faster than anything flies.

What cannot be is not taken in, and the vehicle is doubted for a while: it is named, shown, and no decision is made by
it. A place is held against the last one believed, so a jump is believed once time enough has passed for it. The ranges
are choices, far beyond what a multirotor does; errors within them are not detected.
"""

from __future__ import annotations

import math
from typing import Any

from cython.cimports.gcs.telemetry.plausibility import FAR, FAST, JUMP, NO_NUMBER, POSSIBLE
from cython.cimports.libc.math import fabs, isfinite, sqrt

FARTHEST_M = 1e6
FASTEST_M_S = 300.0
JUMP_M = 10.0
"""A place may be off by so much besides: what a position estimate moves by when it is corrected."""
MOST_J = 1e9
MOST_W = 1e5
STEP_J = 1e5
"""A count of energy may grow by so much besides: reports are rounded, and late. Energy drawn, by as much as the battery
holds: cells fail."""
LEAST_SHARE, MOST_SHARE = -1.0, 2.0
"""Shares of its capacity that a battery may hold, by a ledger of several messages that may be lost or late."""
DOUBTED_S = 5.0
"""A vehicle is doubted for so long after the last that could not be."""

_FARTHEST_M, _FASTEST_M_S, _JUMP_M, _MOST_J, _MOST_W = FARTHEST_M, FASTEST_M_S, JUMP_M, MOST_J, MOST_W


def place_fault(
    n: float, e: float, d: float, v_n: float, v_e: float, v_d: float, moved_m: float, elapsed_s: float
) -> Any:
    """Why a place in m and a velocity in m/s cannot be, which are `moved_m` and `elapsed_s` from the last place that
    was believed; `moved_m` NaN where there is none."""
    if not isfinite(n + e + d + v_n + v_e + v_d):  # each a 32-bit float: the sum of finite ones is finite
        return NO_NUMBER
    if max(fabs(n), fabs(e), fabs(d)) > _FARTHEST_M:
        return FAR
    if sqrt(v_n * v_n + v_e * v_e + v_d * v_d) > _FASTEST_M_S:
        return FAST
    if moved_m > _JUMP_M + _FASTEST_M_S * max(elapsed_s, 0.0):
        return JUMP
    return POSSIBLE


def impossible_place(fault: int, moved_m: float) -> str:
    """The sentence on a place that cannot be."""
    return {
        NO_NUMBER: "its position is no number",
        FAR: f"its position is more than {FARTHEST_M / 1e3:.0f} km away",
        FAST: f"its velocity is above {FASTEST_M_S:.0f} m/s",
        JUMP: f"its position jumps by {moved_m:.0f} m",
    }[fault]


def globe(latitude_e7: int, longitude_e7: int) -> str:
    """Why a latitude and longitude in degE7 cannot be."""
    on_earth = abs(latitude_e7) <= 900_000_000 and abs(longitude_e7) <= 1_800_000_000
    return "" if on_earth else "its origin lies on no globe"


def countable(joules: float, before_j: float, elapsed_s: float, step_j: float) -> bool:
    """Whether a count of energy can be, `elapsed_s` after it was `before_j`; it may grow by `step_j` at once."""
    return 0.0 <= joules <= _MOST_J and joules - before_j <= step_j + _MOST_W * max(elapsed_s, 0.0)


def counted(joules: float, before_j: float, elapsed_s: float, what: str) -> str:
    """Why a count of energy cannot be, `elapsed_s` after it was `before_j`."""
    return "" if countable(joules, before_j, elapsed_s, STEP_J) else impossible_count(joules, what)


def impossible_count(joules: float, what: str) -> str:
    """The sentence on a count of energy that cannot be."""
    return f"it says that it has {what} {joules:.3g} J"


def impossible_power(watts: float) -> str:
    """The sentence on a power beyond MOST_W."""
    return f"it says that it draws {watts:.3g} W"


def capacity(joules: float, least_j: float) -> str:
    """Why a capacity, or a charge at the start, cannot be."""
    return "" if least_j <= joules <= MOST_J else f"it says that its battery holds {joules:.3g} J"


def charge(remaining_j: float, capacity_j: float) -> str:
    """Why what a battery would hold by all its messages cannot be; nothing where its capacity is not known."""
    if not capacity_j > 0.0 or LEAST_SHARE <= remaining_j / capacity_j <= MOST_SHARE or math.isnan(remaining_j):
        return ""
    return f"by its messages its battery would hold {100.0 * remaining_j / capacity_j:.0f} %"
