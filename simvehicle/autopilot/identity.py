"""Identity of the vehicle: every number that changes with the autopilot it stands in for, in one table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

from simvehicle.autopilot.modes import Mode
from skytender import mavlink as mav


def _px4(main: int, sub: int = 0) -> int:
    return main << 16 | sub << 24


class AvailableMode(NamedTuple):
    """A mode as AVAILABLE_MODES lists it: HEARTBEAT's number, MAV_STANDARD_MODE, and a name where that says none."""

    number: int
    standard: int
    name: str = ""
    selectable: bool = True


@dataclass(frozen=True)
class Identity:
    """One autopilot's numbers; `spoken` is HEARTBEAT's number of a mode, `requestable` what a mode request may say.

    `modes_packed`: MAV_CMD_DO_SET_MODE carries main and sub mode in two parameters. `guided`: one mode is both offboard
    and holding, so that it may be entered without set points. `item_0_is_home`: missions begin with home, which is not
    flown. `copter_rules`: commands are taken as ArduCopter takes them, arming and NAV_TAKEOFF in some modes alone, the
    latter on the ground, upwards, and as COMMAND_INT in MAV_FRAME_GLOBAL_RELATIVE_ALT; MISSION_START does not arm; a
    home that was commanded is never moved; not all failsafes make its state critical. `version`: one that the autopilot
    has had, new enough for QGroundControl.
    """

    autopilot: int
    spoken: Mapping[Mode, int]
    requestable: Mapping[int, Mode]
    integers_bytewise: bool
    takeoff_altitude_is_relative: bool
    copter_rules: bool
    modes_packed: bool
    guided: bool
    item_0_is_home: bool
    capabilities: int
    version: tuple[int, int, int]
    available: tuple[AvailableMode, ...]

    def standard_mode(self, mode: Mode) -> int:
        """MAV_STANDARD_MODE of a mode."""
        return next((one.standard for one in self.available if one.number == self.spoken[mode]), 0)


_COMMON_CAPABILITIES = (
    mav.MAV_PROTOCOL_CAPABILITY_MAVLINK2
    | mav.MAV_PROTOCOL_CAPABILITY_COMMAND_INT
    | mav.MAV_PROTOCOL_CAPABILITY_FTP
    | mav.MAV_PROTOCOL_CAPABILITY_SET_POSITION_TARGET_LOCAL_NED
    | mav.MAV_PROTOCOL_CAPABILITY_SET_POSITION_TARGET_GLOBAL_INT
    | mav.MAV_PROTOCOL_CAPABILITY_MISSION_FLOAT
    | mav.MAV_PROTOCOL_CAPABILITY_MISSION_INT
    | mav.MAV_PROTOCOL_CAPABILITY_MISSION_FENCE
    | mav.MAV_PROTOCOL_CAPABILITY_MISSION_RALLY
)

_PX4_MODES = {
    Mode.TAKEOFF: _px4(4, 2),
    Mode.HOLD: _px4(4, 3),
    Mode.MISSION: _px4(4, 4),
    Mode.RETURN: _px4(4, 5),
    Mode.LAND: _px4(4, 6),
    Mode.FOLLOW: _px4(4, 8),
    Mode.OFFBOARD: _px4(6),
    Mode.REFUEL: _px4(6, 1),
    Mode.GUIDED: _px4(6),
}
_ARDUCOPTER_MODES = {
    Mode.TAKEOFF: 4,
    Mode.HOLD: 5,
    Mode.RETURN: 6,
    Mode.LAND: 9,
    Mode.MISSION: 3,
    Mode.FOLLOW: 23,
    Mode.OFFBOARD: 4,
    Mode.REFUEL: 4,
    Mode.GUIDED: 4,
}
_PX4_REQUESTABLE = {
    **{number: mode for mode, number in _PX4_MODES.items() if mode not in {Mode.REFUEL, Mode.GUIDED}},
    _px4(3): Mode.HOLD,
}
_ARDUCOPTER_REQUESTABLE = {
    3: Mode.MISSION,
    4: Mode.OFFBOARD,
    5: Mode.HOLD,
    6: Mode.RETURN,
    9: Mode.LAND,
    17: Mode.HOLD,
    23: Mode.FOLLOW,
}

_PX4_AVAILABLE = (
    AvailableMode(_px4(4, 4), mav.MAV_STANDARD_MODE_MISSION),
    AvailableMode(_px4(4, 3), mav.MAV_STANDARD_MODE_NON_STANDARD, "Hold"),
    AvailableMode(_px4(4, 5), mav.MAV_STANDARD_MODE_SAFE_RECOVERY),
    AvailableMode(_px4(6), mav.MAV_STANDARD_MODE_NON_STANDARD, "Offboard"),
    AvailableMode(_px4(4, 2), mav.MAV_STANDARD_MODE_TAKEOFF),
    AvailableMode(_px4(4, 6), mav.MAV_STANDARD_MODE_LAND),
    AvailableMode(_px4(4, 8), mav.MAV_STANDARD_MODE_NON_STANDARD, "Follow Target"),
    AvailableMode(_px4(6, 1), mav.MAV_STANDARD_MODE_NON_STANDARD, "Refuel", selectable=False),
)
_ARDUCOPTER_AVAILABLE = tuple(
    AvailableMode(number, mav.MAV_STANDARD_MODE_NON_STANDARD, name)
    for number, name in ((3, "Auto"), (5, "Loiter"), (4, "Guided"), (9, "Land"), (6, "RTL"), (23, "Follow"))
)
"""ArduPilot calls none of its modes a standard one."""

_PX4 = Identity(
    autopilot=mav.MAV_AUTOPILOT_PX4,
    spoken=_PX4_MODES,
    requestable=_PX4_REQUESTABLE,
    integers_bytewise=True,
    takeoff_altitude_is_relative=False,
    copter_rules=False,
    modes_packed=True,
    guided=False,
    item_0_is_home=False,
    capabilities=_COMMON_CAPABILITIES | mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE,
    version=(1, 15, 0),
    available=_PX4_AVAILABLE,
)

IDENTITIES: dict[str, Identity] = {
    "px4": _PX4,
    "ardupilot": Identity(
        autopilot=mav.MAV_AUTOPILOT_ARDUPILOTMEGA,
        spoken=_ARDUCOPTER_MODES,
        requestable=_ARDUCOPTER_REQUESTABLE,
        integers_bytewise=False,
        takeoff_altitude_is_relative=True,
        copter_rules=True,
        modes_packed=False,
        guided=True,
        item_0_is_home=True,
        capabilities=_COMMON_CAPABILITIES | mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST,
        version=(4, 6, 2),
        available=_ARDUCOPTER_AVAILABLE,
    ),
    "generic": replace(_PX4, autopilot=mav.MAV_AUTOPILOT_GENERIC, takeoff_altitude_is_relative=True),
}
