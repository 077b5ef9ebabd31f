"""Items of plans as autopilots take and give them back: ArduCopter's and PX4's, by the lines of their own sources.

ArduCopter 4.8.0-dev     AP_Mission.cpp: sanity_check_params, mavlink_int_to_mission_cmd, mission_cmd_to_mavlink_int;
                         MissionItemProtocol_Fence.cpp, MissionItemProtocol_Rally.cpp
PX4 1.17, 1.18           mavlink_mission.cpp: parse_mavlink_mission_item, format_mavlink_mission_item;
                         1.18: mavlink_command_params.hpp, by which what has no use is refused
"""

from __future__ import annotations

import math
import struct
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mav

FIELDS = ("frame", "command", "autocontinue", "param1", "param2", "param3", "param4", "x", "y", "z")
MISSION, FENCE, RALLY = mav.MAV_MISSION_TYPE_MISSION, mav.MAV_MISSION_TYPE_FENCE, mav.MAV_MISSION_TYPE_RALLY
UNSET = 2**31 - 1
RELATIVE = (mav.MAV_FRAME_GLOBAL_RELATIVE_ALT, mav.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)
GLOBAL = (mav.MAV_FRAME_GLOBAL, mav.MAV_FRAME_GLOBAL_INT)
Kept = dict[str, Any]


class Refused(Exception):
    """MAV_MISSION_RESULT of an item that is not taken."""

    def __init__(self, result: int) -> None:
        super().__init__(result)
        self.result = result


def single(number: float) -> float:
    return float(struct.unpack("<f", struct.pack("<f", number))[0])


# ArduCopter

LOCATED = {16, 17, 18, 19, 21, 22, 30, 31, 82, 179, 189, 195, 201}
ANY_YAW = {16, 17, 21, 22}
ARDUCOPTER = {16, 17, 19, 20, 21, 22, 93, 112, 177, 178, 206}


def arducopter_params(command: int, a: float, b: float, c: float, d: float) -> tuple[float, ...]:
    match command:
        case 17:
            return 0, 0, math.copysign(int(abs(c)), c), 0
        case 19:
            return int(a), 0, -1 if c < 0 else 1, int(d > 0)
        case 21:
            return int(a), 0, 0, -1 if d < 0 else 1
        case 93:
            return a, int(b), int(c), int(d)
        case 112:
            return a, 0, 0, 0
        case 177:
            return int(a), int(b), 0, 0
        case 178:
            return int(a), b, c, 0
        case 206:
            return a, 0, int(c), 0
        case 20:
            return 0, 0, 0, 0
    return int(a), 0, 0, 0


def arducopter(m: Any) -> Kept:
    """An item as ArduCopter keeps it. Raises Refused."""
    if m.mission_type == FENCE:
        if not 5000 <= m.command <= 5004:
            raise Refused(mav.MAV_MISSION_UNSUPPORTED)
        size = 0 if m.command == mav.MAV_CMD_NAV_FENCE_RETURN_POINT else m.param1
        return {"frame": 0, "command": m.command, "autocontinue": 0, "param1": size, "x": m.x, "y": m.y}
    if m.mission_type == RALLY:
        if m.command != mav.MAV_CMD_NAV_RALLY_POINT:
            raise Refused(mav.MAV_MISSION_UNSUPPORTED)
        frame = 3 if m.frame in RELATIVE else 0
        return {"frame": frame, "command": m.command, "autocontinue": 0, "x": m.x, "y": m.y, "z": float(int(m.z))}
    params = (m.param1, m.param2, m.param3, m.param4)
    for number, value in enumerate(params, 1):
        if math.isinf(value) or (math.isnan(value) and not (number == 4 and m.command in ANY_YAW)):
            raise Refused(mav.MAV_MISSION_INVALID_PARAM1 + number - 1)
    if m.command not in ARDUCOPTER:
        raise Refused(mav.MAV_MISSION_UNSUPPORTED)
    if m.command == mav.MAV_CMD_NAV_WAYPOINT and not 0 <= m.param1 <= 65535:
        raise Refused(mav.MAV_MISSION_INVALID_PARAM1)
    kept: Kept = {"frame": 0, "command": m.command, "autocontinue": 1}
    kept |= zip(("param1", "param2", "param3", "param4"), arducopter_params(m.command, *params), strict=True)
    if m.command in LOCATED:
        if abs(m.x) > 900000000:
            raise Refused(mav.MAV_MISSION_INVALID_PARAM5_X)
        if abs(m.y) > 1800000000:
            raise Refused(mav.MAV_MISSION_INVALID_PARAM6_Y)
        if math.isnan(m.z) or abs(m.z) >= 83000:
            raise Refused(mav.MAV_MISSION_INVALID_PARAM7)
        if m.frame not in (*GLOBAL, *RELATIVE, mav.MAV_FRAME_MISSION):
            raise Refused(mav.MAV_MISSION_UNSUPPORTED_FRAME)
        centimetres = int(single(m.z * 100.0))
        kept |= {"frame": 3 if m.frame in RELATIVE else 0, "x": m.x, "y": m.y, "z": single(centimetres * 0.01)}
    return kept


# PX4

USED = {
    16: 0x7B,
    17: 0x7C,
    19: 0x7F,
    20: 0x00,
    21: 0x7B,
    22: 0x78,
    93: 0x0F,
    112: 0x01,
    177: 0x03,
    178: 0x07,
    206: 0x0F,
}
"""Parameters that have a use, by bits; 22 as before it knows its kind of vehicle."""
PLACELESS = {20, 93, 112, 177, 178, 206}


def yaw(degrees: float) -> float:
    """Degrees there and back by radians of 32 bits, from 0 to 2 pi."""
    return single(math.degrees(single(math.fmod(single(math.radians(degrees)) + 2 * math.pi, 2 * math.pi))))


def px4_params(m: Any, *, new: bool) -> tuple[float, ...] | None:
    """Of an item with a place; None for one that it does not take."""
    match m.command:
        case 16:
            return m.param1, m.param2, 0, yaw(m.param4)
        case 17:
            return 0, 0, m.param3, yaw(m.param4)
        case 19:
            return m.param1, int(m.param2 > 0), m.param3, int(m.param4 > 0)
        case 21:
            return m.param1 if new else 0, int(m.param2), 0, yaw(m.param4)
        case 22:
            return 0, 0, 0, yaw(m.param4)
    return None


def px4(m: Any, *, new: bool) -> Kept:
    """An item as PX4 keeps it, from 1.18 on where `new`. Raises Refused."""
    kept: Kept = {"command": m.command, "autocontinue": m.autocontinue}
    params = (m.param1, m.param2, m.param3, m.param4)
    if m.mission_type != MISSION:
        size = m.param1 if 5000 < m.command <= 5004 else 0
        frame = 6 if m.frame in RELATIVE else 5
        return kept | {"frame": frame, "param1": size, "x": m.x, "y": m.y, "z": m.z}
    used = USED.get(m.command)
    for number, value in enumerate((*params, m.z), 1) if new and used is not None else ():
        at = number if number <= 4 else 7
        if not used >> (at - 1) & 1 and not math.isnan(value) and value != 0.0:
            raise Refused(mav.MAV_MISSION_INVALID_PARAM1 + at - 1)
    if m.frame in (*GLOBAL, *RELATIVE):
        placed = px4_params(m, new=new)
        if placed is None:
            raise Refused(mav.MAV_MISSION_UNSUPPORTED)
        values = placed
        kept |= {"frame": 6 if m.frame in RELATIVE else 5, "x": m.x, "y": m.y, "z": m.z}
    elif m.frame == mav.MAV_FRAME_MISSION:
        if m.command not in PLACELESS:
            raise Refused(mav.MAV_MISSION_UNSUPPORTED)
        values = (int(m.param1), int(m.param2), m.param3, m.param4) if m.command == 177 else params
        x, y = (-(2**31) if value == UNSET else round(single(value)) for value in (m.x, m.y))
        kept |= {"frame": mav.MAV_FRAME_MISSION, "x": x, "y": y, "z": m.z}
    else:
        raise Refused(mav.MAV_MISSION_UNSUPPORTED_FRAME)
    return kept | dict(zip(("param1", "param2", "param3", "param4"), values, strict=True))
