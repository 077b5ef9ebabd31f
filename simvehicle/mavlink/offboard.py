"""Handlers of incoming streams: set points, HEARTBEAT, FOLLOW_TARGET, and counters as NAMED_VALUE_INT."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

from simvehicle.autopilot.energy_transfer import Neighbour
from simvehicle.autopilot.maneuvers import OffboardSetPoint
from simvehicle.autopilot.snapshot import Vec3
from simvehicle.mavlink.commands import RELATIVE_FRAMES
from simvehicle.mavlink.context import Call, MessageHandler, ServiceContext
from skytender import elementary
from skytender import mavlink as mav

_NEVER_FLOWN = (
    mav.POSITION_TARGET_TYPEMASK_AX_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AY_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AZ_IGNORE
)
"""Bits that a set point must set: accelerations, or forces, are not flown."""
_TRAVELLING = frozenset({mav.MAV_FRAME_LOCAL_OFFSET_NED, mav.MAV_FRAME_BODY_OFFSET_NED, mav.MAV_FRAME_BODY_FRD})
"""Frames whose places count from where the vehicle is when they come."""
_TURNED = frozenset({mav.MAV_FRAME_BODY_NED, mav.MAV_FRAME_BODY_OFFSET_NED, mav.MAV_FRAME_BODY_FRD})
"""Frames whose velocities point forward, right and down by the vehicle's yaw when they come; roll and pitch play no
part. Places are turned too where they also travel: those of BODY_NED are LOCAL_NED's, as MAV_FRAME has it. A yaw counts
from north in every frame."""
_LOCAL = _TRAVELLING | _TURNED | {mav.MAV_FRAME_LOCAL_NED}
_EVERY_AXIS = (True, True, True)
_GLOBAL = RELATIVE_FRAMES | {mav.MAV_FRAME_GLOBAL, mav.MAV_FRAME_GLOBAL_INT}


def heartbeat(context: ServiceContext, call: Call) -> None:
    if call.content.type == mav.MAV_TYPE_GCS:
        context.vehicle.receive_gcs_heartbeat()


def local_set_point(context: ServiceContext, call: Call) -> None:
    content = call.content
    if content.coordinate_frame not in _LOCAL:
        return context.complain("frame", f"Set point ignored: frame {content.coordinate_frame}")
    return _fly(context, content, (content.x, content.y, content.z))


def global_set_point(context: ServiceContext, call: Call) -> None:
    content, vehicle = call.content, context.vehicle
    if content.coordinate_frame not in _GLOBAL:
        return context.complain("frame", f"Set point ignored: frame {content.coordinate_frame}")
    north, east, down = vehicle.frame.to_local(1e-7 * content.lat_int, 1e-7 * content.lon_int, content.alt)
    if content.coordinate_frame in RELATIVE_FRAMES:
        down = vehicle.home_ned[2] - content.alt
    return _fly(context, content, (north, east, down))


def _fly(context: ServiceContext, content: Any, place: Vec3) -> None:
    vehicle, mask, frame = context.vehicle, content.type_mask, content.coordinate_frame
    use_position, use_velocity, use_yaw, use_yaw_rate, flown = _uses(mask)
    halved = frame in _TURNED and any(use[0] != use[1] for use in (use_position, use_velocity))
    if not flown or halved:
        return context.complain("type_mask", f"Set point ignored: type_mask {mask}")
    p_ned = _where_used(place, use_position)
    v_ned = _where_used((content.vx, content.vy, content.vz), use_velocity)
    turn = (content.yaw if use_yaw else 0.0, content.yaw_rate if use_yaw_rate else 0.0)
    if not math.isfinite(sum((*p_ned, *v_ned, *turn))):
        return context.complain("number", "Set point ignored: not a number")
    if frame in _TURNED:
        v_ned = _turned(v_ned, vehicle.attitude_ned[2])
    if frame in _TRAVELLING:
        offset_ned = _turned(p_ned, vehicle.attitude_ned[2]) if frame in _TURNED else p_ned
        north, east, down = (here + away for here, away in zip(vehicle.p_ned, offset_ned, strict=True))
        p_ned = _where_used((north, east, down), use_position)
    yaw_rad, yaw_rate = turn[0] if use_yaw else None, turn[1] if use_yaw_rate else None
    vehicle.set_point(OffboardSetPoint(p_ned, v_ned, use_position, yaw_rad, vehicle.time_s, yaw_rate))
    return None


class _Uses(NamedTuple):
    """Parts of a set point that count by its type_mask, and whether what it asks for is flown."""

    position: tuple[bool, bool, bool]
    velocity: tuple[bool, bool, bool]
    yaw: bool
    yaw_rate: bool
    flown: bool


@lru_cache(maxsize=64)
def _uses(mask: int) -> _Uses:
    position = (not mask & 1, not mask & 2, not mask & 4)
    velocity = (not mask & 8, not mask & 16, not mask & 32)
    yaw = not mask & mav.POSITION_TARGET_TYPEMASK_YAW_IGNORE
    yaw_rate = not mask & mav.POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE
    each = all(p or v for p, v in zip(position, velocity, strict=True))
    flown = each and not (yaw and yaw_rate) and mask & _NEVER_FLOWN == _NEVER_FLOWN
    return _Uses(position, velocity, yaw, yaw_rate, flown)


def _turned(v: Vec3, yaw_rad: float) -> Vec3:
    """A vector given as forward, right, down, in NED: turned about down by the yaw."""
    sin, cos = elementary.sin_cos(yaw_rad)
    return cos * v[0] - sin * v[1], sin * v[0] + cos * v[1], v[2]


def follow_target(context: ServiceContext, call: Call) -> None:
    """Take in a position: of a partner in a transfer, or of a target that the vehicle may follow. No velocity is
    none."""
    content, vehicle = call.content, context.vehicle
    vel = tuple(0.0 if math.isnan(v) else v for v in content.vel)
    if all(map(math.isfinite, (content.alt, *vel))):
        p_ned = vehicle.frame.to_local(1e-7 * content.lat, 1e-7 * content.lon, content.alt)
        vehicle.receive_target(p_ned, (vel[0], vel[1], vel[2]))
        if all(map(math.isfinite, content.vel)):
            vehicle.exchange.neighbours[call.frame.sysid] = Neighbour(
                p_ned, tuple(content.vel), vehicle.v_ned, vehicle.time_s
            )


def named_value_int(context: ServiceContext, call: Call) -> None:
    vehicle = context.vehicle
    vehicle.exchange.receive_counter(call.frame.sysid, call.content.name, call.content.value, vehicle.time_s)


def _where_used(numbers: Vec3, used: tuple[bool, bool, bool]) -> Vec3:
    """The numbers, 0 where they are not used, since anything may stand there."""
    if used == _EVERY_AXIS:
        return numbers
    first, second, third = (number if use else 0.0 for number, use in zip(numbers, used, strict=True))
    return first, second, third


MESSAGES: dict[int, MessageHandler] = {
    mav.MAVLINK_MSG_ID_HEARTBEAT: heartbeat,
    mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED: local_set_point,
    mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT: global_set_point,
    mav.MAVLINK_MSG_ID_FOLLOW_TARGET: follow_target,
    mav.MAVLINK_MSG_ID_NAMED_VALUE_INT: named_value_int,
}
