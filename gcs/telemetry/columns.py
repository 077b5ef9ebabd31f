"""The fleet at one instant as arrays: a row for each vehicle, in order of system id.

What every tick asks of every vehicle is read here; a `VehicleView` is for what one of them is asked for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Flags = NDArray[np.bool_]
Floats = NDArray[np.float64]
UNSTAMPED = -1


@dataclass(frozen=True, slots=True, eq=False)
class FleetColumns:
    """Of n vehicles; each column as the attribute of `VehicleView` with its name. Nobody writes into them."""

    sysids: Sequence[int]
    row: Mapping[int, int]
    """by system id"""
    stamps: NDArray[np.int64]
    """(n,) another number whenever anything of a vehicle but the figures below may have changed since the fleet's last
    snapshot: the truth of each flag, mode, profile, doubt, energy received or given, frame, ground. UNSTAMPED where
    that is not known."""
    alive: Flags
    steerable: Flags
    """whether it is in a mode in which it may fly set points"""
    flying: Flags
    fresh: Flags
    p_ned: Floats
    """(n, 3) m; NaN where it is unknown, as in `p_now_ned`"""
    v_ned: Floats
    """(n, 3) m/s"""
    p_now_ned: Floats
    """(n, 3) m"""
    age_s: Floats
    ground_down_m: Floats
    """(n,) NaN where it is unknown"""
    remaining_j: Floats
