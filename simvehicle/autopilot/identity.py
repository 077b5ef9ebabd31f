"""Identity of the vehicle: every number that changes with the autopilot it stands in for, in one table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from simvehicle.autopilot.modes import Mode
from skytender import mavlink as mav


def _px4(main: int, sub: int = 0) -> int:
    return main << 16 | sub << 24


@dataclass(frozen=True)
class Identity:
    """One autopilot's numbers; `spoken` is HEARTBEAT's number of a mode, `requestable` what a mode request may say.

    `modes_packed`: MAV_CMD_DO_SET_MODE carries main and sub mode in two parameters. `guided`: one mode is both offboard
    and holding, so that it may be entered without set points. `item_0_is_home`: missions begin with home, which is not
    flown.
    """

    autopilot: int
    spoken: Mapping[Mode, int]
    requestable: Mapping[int, Mode]
    integers_bytewise: bool
    takeoff_altitude_is_relative: bool
    modes_packed: bool
    guided: bool
    item_0_is_home: bool
    capabilities: int


_COMMON_CAPABILITIES = (
    mav.MAV_PROTOCOL_CAPABILITY_MAVLINK2
    | mav.MAV_PROTOCOL_CAPABILITY_COMMAND_INT
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

_PX4 = Identity(
    autopilot=mav.MAV_AUTOPILOT_PX4,
    spoken=_PX4_MODES,
    requestable=_PX4_REQUESTABLE,
    integers_bytewise=True,
    takeoff_altitude_is_relative=False,
    modes_packed=True,
    guided=False,
    item_0_is_home=False,
    capabilities=_COMMON_CAPABILITIES | mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE,
)

IDENTITIES: dict[str, Identity] = {
    "px4": _PX4,
    "ardupilot": Identity(
        autopilot=mav.MAV_AUTOPILOT_ARDUPILOTMEGA,
        spoken=_ARDUCOPTER_MODES,
        requestable=_ARDUCOPTER_REQUESTABLE,
        integers_bytewise=False,
        takeoff_altitude_is_relative=True,
        modes_packed=False,
        guided=True,
        item_0_is_home=True,
        capabilities=_COMMON_CAPABILITIES | mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST,
    ),
    "generic": replace(_PX4, autopilot=mav.MAV_AUTOPILOT_GENERIC, takeoff_altitude_is_relative=True),
}
