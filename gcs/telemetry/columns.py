"""The fleet at one instant as arrays: a row for each vehicle, in order of system id.

What every tick asks of every vehicle is read here; a `VehicleView` is for what one of them is asked for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Flags = NDArray[np.bool_]
Floats = NDArray[np.float64]
NO_NUMBER = -1

FLAGS = 6
IS_ALIVE, IS_STEERABLE, IS_FLYING, IS_FRESH, IS_LANDED, IS_EMPTY = range(FLAGS)
PLACES = 3
P_NED, V_NED, P_NOW_NED = range(PLACES)
FIGURES = 7
AGE_S, GROUND_DOWN_M, REMAINING_J, DRAWN_J, INITIAL_J, CAPACITY_J, WAY_M = range(FIGURES)


class FleetColumns(NamedTuple):
    """Of n vehicles; each column as the attribute of `VehicleView` with its name. They are read only.

    They are kept as three blocks, of which columns are made on demand.
    """

    sysids: Sequence[int]
    row: Mapping[int, int]
    """by system id"""
    number: int
    """one more than the last snapshot's where anything of a vehicle but the figures below has changed since: the truth
    of each flag, mode, profile, doubt, energy received or given, whether any is left, frame, ground. NO_NUMBER where
    changes are not known."""
    changed: NDArray[np.int64]
    """(n,) the number since which a vehicle has not changed"""
    flags: Flags
    """(FLAGS, n)"""
    places: Floats
    """(PLACES, n, 3)"""
    figures: Floats
    """(FIGURES, n)"""
    frames: Floats
    """(n, 4) each vehicle's own frame in the common one: its origin, NED, m, NaN while that is unknown; and by how much
    it is turned about the vertical, rad"""

    def changed_since(self, number: int) -> list[int]:
        """System ids, in order, of vehicles of which more than figures has changed since a number."""
        if number == self.number != NO_NUMBER:
            return []
        if self.number == NO_NUMBER:
            return list(self.sysids)
        return [self.sysids[row] for row in np.flatnonzero(self.changed > number).tolist()]

    @property
    def alive(self) -> Flags:
        """(n,)"""
        return self.flags[IS_ALIVE]

    @property
    def steerable(self) -> Flags:
        """(n,) whether it is in a mode in which it may fly set points."""
        return self.flags[IS_STEERABLE]

    @property
    def flying(self) -> Flags:
        """(n,)"""
        return self.flags[IS_FLYING]

    @property
    def fresh(self) -> Flags:
        """(n,)"""
        return self.flags[IS_FRESH]

    @property
    def p_ned(self) -> Floats:
        """(n, 3) m; NaN where it is unknown, as in `p_now_ned`."""
        return self.places[P_NED]

    @property
    def v_ned(self) -> Floats:
        """(n, 3) m/s."""
        return self.places[V_NED]

    @property
    def p_now_ned(self) -> Floats:
        """(n, 3) m."""
        return self.places[P_NOW_NED]

    @property
    def age_s(self) -> Floats:
        """(n,)"""
        return self.figures[AGE_S]

    @property
    def ground_down_m(self) -> Floats:
        """(n,) NaN where it is unknown."""
        return self.figures[GROUND_DOWN_M]

    @property
    def remaining_j(self) -> Floats:
        """(n,)"""
        return self.figures[REMAINING_J]
