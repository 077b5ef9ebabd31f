"""Who the vehicle says it is: every number that changes with the autopilot it stands in for, in one table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pymavlink.dialects.v20 import common as mav

from simvehicle.modes import Mode


def _px4(main: int, sub: int = 0) -> int:
    return main << 16 | sub << 24


@dataclass(frozen=True)
class Identity:
    """One autopilot's numbers; `spoken` is what HEARTBEAT says of a mode, `heard` what a mode request may say."""

    autopilot: int
    spoken: Mapping[Mode, int]
    heard: Mapping[int, Mode]
    integers_bytewise: bool
    takeoff_altitude_is_relative: bool
    capabilities: int

    def custom_mode(self, mode: Mode) -> int:
        """HEARTBEAT.custom_mode of a mode."""
        return self.spoken[mode]


_COMMON_CAPABILITIES = (
    mav.MAV_PROTOCOL_CAPABILITY_MAVLINK2
    | mav.MAV_PROTOCOL_CAPABILITY_COMMAND_INT
    | mav.MAV_PROTOCOL_CAPABILITY_SET_POSITION_TARGET_LOCAL_NED
)

_PX4_MODES = {
    Mode.TAKEOFF: _px4(4, 2),
    Mode.HOLD: _px4(4, 3),
    Mode.RETURN: _px4(4, 5),
    Mode.LAND: _px4(4, 6),
    Mode.OFFBOARD: _px4(6),
    Mode.REFUEL: _px4(6, 1),
}
_ARDUCOPTER_MODES = {
    Mode.TAKEOFF: 4,
    Mode.HOLD: 5,
    Mode.RETURN: 6,
    Mode.LAND: 9,
    Mode.OFFBOARD: 4,
    Mode.REFUEL: 4,
}
_PX4_HEARD = {
    **{number: mode for mode, number in _PX4_MODES.items() if mode is not Mode.REFUEL},
    _px4(3): Mode.HOLD,
}
_ARDUCOPTER_HEARD = {4: Mode.OFFBOARD, 5: Mode.HOLD, 6: Mode.RETURN, 9: Mode.LAND, 17: Mode.HOLD}

IDENTITIES: dict[str, Identity] = {
    "px4": Identity(
        mav.MAV_AUTOPILOT_PX4,
        _PX4_MODES,
        _PX4_HEARD,
        True,
        False,
        _COMMON_CAPABILITIES | mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE,
    ),
    "ardupilot": Identity(
        mav.MAV_AUTOPILOT_ARDUPILOTMEGA,
        _ARDUCOPTER_MODES,
        _ARDUCOPTER_HEARD,
        False,
        True,
        _COMMON_CAPABILITIES | mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST,
    ),
    "generic": Identity(
        mav.MAV_AUTOPILOT_GENERIC,
        _PX4_MODES,
        _PX4_HEARD,
        True,
        True,
        _COMMON_CAPABILITIES | mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE,
    ),
}
