"""The scripted ArduCopter's parameters as it tells them: by the names of a version, and in its units."""

from __future__ import annotations

import math
from collections.abc import Collection

from arducopter_motion import PARAMETERS, REAL32, Copter

SINCE_47 = {
    "LAND_SPEED": ("LAND_SPD_MS", 0.01),
    "PILOT_SPEED_UP": ("PILOT_SPD_UP", 0.01),
    "RTL_ALT": ("RTL_ALT_M", 0.01),
    "RTL_CLIMB_MIN": ("RTL_CLIMB_MIN_M", 0.01),
    "SYSID_THISMAV": ("MAV_SYSID", 1.0),
    "WPNAV_ACCEL": ("WP_ACC", 0.01),
    "WPNAV_SPEED": ("WP_SPD", 0.01),
    "WPNAV_SPEED_DN": ("WP_SPD_DN", 0.01),
}
"""Names since 4.7, in SI units, and the factor from the old numbers."""


class Told:
    """What it answers about the copter's parameters."""

    def __init__(self, copter: Copter, *, si_names: bool, locked: Collection[str]) -> None:
        """`locked`: names of those that stay as they are, whatever is written."""
        renamed = SINCE_47 if si_names else {}
        self._copter, self._locked = copter, locked
        self._own = {renamed[name][0] if name in renamed else name: name for name in PARAMETERS}
        self._factor = {told: renamed[name][1] for told, name in self._own.items() if name in renamed}

    @property
    def names(self) -> list[str]:
        return list(self._own)

    def number(self, told: str) -> float:
        return self._copter.parameters[self._own[told]] * self._factor.get(told, 1.0)

    def kind(self, told: str) -> int:
        """Numbers in SI units are floats."""
        return REAL32 if self._factor.get(told, 1.0) != 1.0 else PARAMETERS[self._own[told]][0]

    def write(self, told: str, number: float) -> bool:
        """Whether it has such a parameter, and answers."""
        if told not in self._own or not math.isfinite(number):
            return False
        if told not in self._locked:
            taken = number if self.kind(told) == REAL32 else float(round(number))
            self._copter.parameters[self._own[told]] = taken / self._factor.get(told, 1.0)
        return True
