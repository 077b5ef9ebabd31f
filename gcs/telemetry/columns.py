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

FLAGS = 5
IS_ALIVE, IS_STEERABLE, IS_FLYING, IS_FRESH, IS_LANDED = range(FLAGS)
PLACES = 3
P_NED, V_NED, P_NOW_NED = range(PLACES)
FIGURES = 6
AGE_S, GROUND_DOWN_M, REMAINING_J, DRAWN_J, INITIAL_J, CAPACITY_J = range(FIGURES)


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
        column: Flags = self.flags[IS_ALIVE]
        return column

    @property
    def steerable(self) -> Flags:
        """(n,) whether it is in a mode in which it may fly set points."""
        column: Flags = self.flags[IS_STEERABLE]
        return column

    @property
    def flying(self) -> Flags:
        """(n,)"""
        column: Flags = self.flags[IS_FLYING]
        return column

    @property
    def fresh(self) -> Flags:
        """(n,)"""
        column: Flags = self.flags[IS_FRESH]
        return column

    @property
    def p_ned(self) -> Floats:
        """(n, 3) m; NaN where it is unknown, as in `p_now_ned`."""
        column: Floats = self.places[P_NED]
        return column

    @property
    def v_ned(self) -> Floats:
        """(n, 3) m/s."""
        column: Floats = self.places[V_NED]
        return column

    @property
    def p_now_ned(self) -> Floats:
        """(n, 3) m."""
        column: Floats = self.places[P_NOW_NED]
        return column

    @property
    def age_s(self) -> Floats:
        """(n,)"""
        column: Floats = self.figures[AGE_S]
        return column

    @property
    def ground_down_m(self) -> Floats:
        """(n,) NaN where it is unknown."""
        column: Floats = self.figures[GROUND_DOWN_M]
        return column

    @property
    def remaining_j(self) -> Floats:
        """(n,)"""
        column: Floats = self.figures[REMAINING_J]
        return column
