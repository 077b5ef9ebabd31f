"""What streams towards the vehicle: set points, heartbeats, the places and counters of others."""

from __future__ import annotations

import math
from typing import Any

from pymavlink.dialects.v20 import common as mav

from simvehicle.maneuvers import SetPoint
from simvehicle.mavlink.snapshot import Vec3
from simvehicle.microservices.desk import Call, Desk, MessageHandler
from simvehicle.transfer import Neighbour

_NEVER_FLOWN = (
    mav.POSITION_TARGET_TYPEMASK_AX_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AY_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AZ_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE
)
"""Bits that a set point must set: accelerations, or forces, and yaw rates are not flown."""
_RELATIVE = frozenset({mav.MAV_FRAME_GLOBAL_RELATIVE_ALT, mav.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT})
_GLOBAL = _RELATIVE | {mav.MAV_FRAME_GLOBAL, mav.MAV_FRAME_GLOBAL_INT}


def heartbeat(desk: Desk, call: Call) -> None:
    if call.content.type == mav.MAV_TYPE_GCS:
        desk.vehicle.gcs_heard()


def local_set_point(desk: Desk, call: Call) -> None:
    content = call.content
    if content.coordinate_frame != mav.MAV_FRAME_LOCAL_NED:
        return desk.complain("frame", f"Set point ignored: frame {content.coordinate_frame}")
    return _fly(desk, content, (content.x, content.y, content.z))


def global_set_point(desk: Desk, call: Call) -> None:
    content, vehicle = call.content, desk.vehicle
    if content.coordinate_frame not in _GLOBAL:
        return desk.complain("frame", f"Set point ignored: frame {content.coordinate_frame}")
    north, east, down = vehicle.frame.to_local(1e-7 * content.lat_int, 1e-7 * content.lon_int, content.alt)
    if content.coordinate_frame in _RELATIVE:
        down = vehicle.home_ned[2] - content.alt
    return _fly(desk, content, (north, east, down))


def _fly(desk: Desk, content: Any, place_ned: Vec3) -> None:
    mask = content.type_mask
    use_position = (not mask & 1, not mask & 2, not mask & 4)
    use_velocity = (not mask & 8, not mask & 16, not mask & 32)
    flown = all(p or v for p, v in zip(use_position, use_velocity, strict=True))
    if mask & _NEVER_FLOWN != _NEVER_FLOWN or not flown:
        return desk.complain("type_mask", f"Set point ignored: type_mask {mask}")
    use_yaw = not mask & mav.POSITION_TARGET_TYPEMASK_YAW_IGNORE
    p_ned = _where_used(place_ned, use_position)
    v_ned = _where_used((content.vx, content.vy, content.vz), use_velocity)
    if not all(map(math.isfinite, (*p_ned, *v_ned, content.yaw if use_yaw else 0.0))):
        return desk.complain("number", "Set point ignored: not a number")
    yaw_rad = content.yaw if use_yaw else None
    desk.vehicle.set_point(SetPoint(p_ned, v_ned, use_position, yaw_rad, desk.vehicle.time_s))
    return None


def follow_target(desk: Desk, call: Call) -> None:
    """Somebody's place: of a partner in a transfer, or of whom the vehicle may follow. No velocity is none."""
    content, vehicle = call.content, desk.vehicle
    vel = tuple(0.0 if math.isnan(v) else v for v in content.vel)
    if all(map(math.isfinite, (content.alt, *vel))):
        p_ned = vehicle.frame.to_local(1e-7 * content.lat, 1e-7 * content.lon, content.alt)
        vehicle.follow_hears(p_ned, (vel[0], vel[1], vel[2]))
        if all(map(math.isfinite, content.vel)):
            vehicle.exchange.neighbours[call.frame.sysid] = Neighbour(p_ned, tuple(content.vel), vehicle.time_s)


def named_value_int(desk: Desk, call: Call) -> None:
    vehicle = desk.vehicle
    vehicle.exchange.hear_counter(call.frame.sysid, call.content.name, call.content.value, vehicle.time_s)


def _where_used(numbers: Vec3, used: tuple[bool, bool, bool]) -> Vec3:
    """The numbers, 0 where they are not used, since anything may stand there."""
    first, second, third = (number if use else 0.0 for number, use in zip(numbers, used, strict=True))
    return first, second, third


MESSAGES: dict[int, MessageHandler] = {
    mav.MAVLINK_MSG_ID_HEARTBEAT: heartbeat,
    mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED: local_set_point,
    mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT: global_set_point,
    mav.MAVLINK_MSG_ID_FOLLOW_TARGET: follow_target,
    mav.MAVLINK_MSG_ID_NAMED_VALUE_INT: named_value_int,
}
