"""Every difference between autopilots, in one table: the only place in the ground station where a mode has a number."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from pymavlink.dialects.v20 import common as mav


class FlightMode(StrEnum):
    """What a vehicle is flying, whatever its autopilot calls it."""

    TAKEOFF = "takeoff"
    OFFBOARD = "offboard"
    HOLD = "hold"
    LAND = "land"
    RETURN = "return"
    REFUEL = "refuel"
    OTHER = "other"


STEERABLE = frozenset({FlightMode.OFFBOARD, FlightMode.REFUEL})
"""Modes in which a vehicle follows set points."""


@dataclass(frozen=True)
class Profile:
    """One autopilot's habits.

    `modes` reads HEARTBEAT.custom_mode; `offboard` holds params 1..3 of the MAV_CMD_DO_SET_MODE that starts offboard.
    """

    name: str
    modes: Mapping[int, FlightMode]
    offboard: tuple[float, float, float]
    takeoff_is_amsl: bool

    def mode(self, custom_mode: int) -> FlightMode:
        """The mode in a HEARTBEAT."""
        return self.modes.get(custom_mode, FlightMode.OTHER)

    def takeoff_param7(self, height_m: float, ground_amsl_m: float) -> float:
        """MAV_CMD_NAV_TAKEOFF's altitude for a climb to `height_m` above a ground at `ground_amsl_m`."""
        return height_m + ground_amsl_m if self.takeoff_is_amsl else height_m


def _px4(main: int, sub: int = 0) -> int:
    return main << 16 | sub << 24


_CUSTOM = float(mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED)

PX4 = Profile(
    name="px4",
    modes={
        _px4(4, 2): FlightMode.TAKEOFF,
        _px4(4, 3): FlightMode.HOLD,
        _px4(4, 5): FlightMode.RETURN,
        _px4(4, 6): FlightMode.LAND,
        _px4(6): FlightMode.OFFBOARD,
        _px4(6, 1): FlightMode.REFUEL,
    },
    offboard=(_CUSTOM, 6.0, 0.0),
    takeoff_is_amsl=True,
)
ARDUCOPTER = Profile(
    name="ardupilot",
    modes={
        4: FlightMode.OFFBOARD,
        5: FlightMode.HOLD,
        6: FlightMode.RETURN,
        9: FlightMode.LAND,
        17: FlightMode.HOLD,
    },
    offboard=(_CUSTOM, 4.0, 0.0),
    takeoff_is_amsl=False,
)
GENERIC = Profile("generic", PX4.modes, PX4.offboard, takeoff_is_amsl=False)

_BY_AUTOPILOT = {mav.MAV_AUTOPILOT_PX4: PX4, mav.MAV_AUTOPILOT_ARDUPILOTMEGA: ARDUCOPTER}


def profile_of(autopilot: int) -> Profile:
    """The profile for HEARTBEAT.autopilot."""
    return _BY_AUTOPILOT.get(autopilot, GENERIC)


NOT_GIVEN = math.nan
"""What an unset command parameter is, to an autopilot that tells it from 0."""
