"""Handlers of incoming streams: set points, HEARTBEAT, FOLLOW_TARGET, and counters as NAMED_VALUE_INT."""

from __future__ import annotations

from math import isfinite, isnan
from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.libc import math
from cython.cimports.libc.string import memcpy, memset
from cython.cimports.simvehicle.autopilot.vehicle import SetPoint
from cython.cimports.simvehicle.mavlink.offboard import ACCELERATIONS_IGNORED, Wanted
from cython.cimports.skytender.messages import (
    MAV_COMP_ID_AUTOPILOT1,
    MAV_FRAME_BODY_FRD,
    MAV_FRAME_BODY_NED,
    MAV_FRAME_BODY_OFFSET_NED,
    MAV_FRAME_LOCAL_NED,
    MAV_FRAME_LOCAL_OFFSET_NED,
    MAV_TYPE_GCS,
    POSITION_TARGET_TYPEMASK_YAW_IGNORE,
    POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE,
    Heartbeat,
    SetPositionTargetLocalNed,
)

from simvehicle.autopilot.energy_transfer import Neighbour
from simvehicle.mavlink.commands import RELATIVE_FRAMES
from simvehicle.mavlink.context import Call, MessageHandler, ServiceContext
from skytender import mavlink as mav

_GLOBAL = RELATIVE_FRAMES | {mav.MAV_FRAME_GLOBAL, mav.MAV_FRAME_GLOBAL_INT}


def is_ground_station(payload: bytes) -> bool:
    """Whether a HEARTBEAT, whose payload may lack zeros at its end, is a ground station's."""
    m = cython.declare(Heartbeat)
    size = cython.sizeof(Heartbeat)
    memset(cython.address(m), 0, size)
    memcpy(cython.address(m), PyBytes_AS_STRING(payload), min(len(payload), size))
    return m.type == MAV_TYPE_GCS


def local_set_point(context: ServiceContext, vehicle: Any, sysid: int, payload: bytes) -> None:
    """Fly a SET_POSITION_TARGET_LOCAL_NED for this vehicle, whose payload may lack zeros at its end.

    MAV_FRAME_LOCAL_OFFSET_NED, BODY_OFFSET_NED and BODY_FRD count places from where the vehicle is when they come.
    BODY_NED, BODY_OFFSET_NED and BODY_FRD have velocities point forward, right and down by its yaw then; roll and pitch
    play no part. Places are turned too where they also travel: those of BODY_NED are LOCAL_NED's, as MAV_FRAME has it.
    A yaw counts from north in every frame.
    """
    m, wanted = cython.declare(SetPositionTargetLocalNed), cython.declare(Wanted)
    size = cython.sizeof(SetPositionTargetLocalNed)
    memset(cython.address(m), 0, size)
    memcpy(cython.address(m), PyBytes_AS_STRING(payload), min(len(payload), size))
    if m.target_system not in (0, sysid) or m.target_component > MAV_COMP_ID_AUTOPILOT1:
        return
    wanted.frame, wanted.mask = m.coordinate_frame, m.type_mask
    wanted.place[0], wanted.place[1], wanted.place[2] = m.x, m.y, m.z
    wanted.velocity[0], wanted.velocity[1], wanted.velocity[2] = m.vx, m.vy, m.vz
    wanted.yaw, wanted.yaw_rate = m.yaw, m.yaw_rate
    frame = wanted.frame
    wanted.travels = frame in (MAV_FRAME_LOCAL_OFFSET_NED, MAV_FRAME_BODY_OFFSET_NED, MAV_FRAME_BODY_FRD)
    wanted.turned = frame in (MAV_FRAME_BODY_NED, MAV_FRAME_BODY_OFFSET_NED, MAV_FRAME_BODY_FRD)
    if frame != MAV_FRAME_LOCAL_NED and not wanted.travels and not wanted.turned:
        context.complain("frame", f"Set point ignored: frame {frame}")
    else:
        _take(context, vehicle, cython.address(wanted))


def global_set_point(context: ServiceContext, call: Call) -> None:
    """Fly a SET_POSITION_TARGET_GLOBAL_INT."""
    content, vehicle, wanted = call.content, context.vehicle, cython.declare(Wanted)
    if content.coordinate_frame not in _GLOBAL:
        context.complain("frame", f"Set point ignored: frame {content.coordinate_frame}")
        return
    north, east, down = vehicle.frame.to_local(1e-7 * content.lat_int, 1e-7 * content.lon_int, content.alt)
    if content.coordinate_frame in RELATIVE_FRAMES:
        down = vehicle.home_ned[2] - content.alt
    wanted.frame, wanted.mask = content.coordinate_frame, content.type_mask
    wanted.travels = wanted.turned = False
    wanted.place[0], wanted.place[1], wanted.place[2] = north, east, down
    wanted.velocity[0], wanted.velocity[1], wanted.velocity[2] = content.vx, content.vy, content.vz
    wanted.yaw, wanted.yaw_rate = content.yaw, content.yaw_rate
    _take(context, vehicle, cython.address(wanted))


def _take(context: ServiceContext, v: Any, wanted: Any) -> None:
    """Fly what is asked for, if all of it can be flown; what is not used may be any number."""
    set_point, mask = cython.declare(SetPoint), wanted.mask
    use_yaw = mask & POSITION_TARGET_TYPEMASK_YAW_IGNORE == 0
    use_rate = mask & POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE == 0
    flown = not (use_yaw and use_rate) and mask & ACCELERATIONS_IGNORED == ACCELERATIONS_IGNORED
    total = 0.0
    set_point.place_alone = True
    for i in range(3):
        position, velocity = not mask & 1 << i, not mask & 8 << i
        flown = flown and (position or velocity)
        set_point.place_alone = set_point.place_alone and position and not velocity
        set_point.use_position[i] = position
        set_point.p_ned[i] = wanted.place[i] if position else 0.0
        set_point.v_ned[i] = wanted.velocity[i] if velocity else 0.0
        total += set_point.p_ned[i] + set_point.v_ned[i]
    halved = wanted.turned and ((mask ^ mask >> 1) & 1 or (mask >> 3 ^ mask >> 4) & 1)
    if not flown or halved:
        context.complain("type_mask", f"Set point ignored: type_mask {mask}")
        return
    set_point.yaw_ned = wanted.yaw if use_yaw else math.NAN
    set_point.yaw_rate = wanted.yaw_rate if use_rate else math.NAN
    total += (wanted.yaw if use_yaw else 0.0) + (wanted.yaw_rate if use_rate else 0.0)
    if not math.isfinite(total):
        context.complain("number", "Set point ignored: not a number")
        return
    if wanted.turned:
        _turn(set_point.v_ned, -v.plant.row.attitude[2])
    if wanted.travels:
        if wanted.turned:
            _turn(set_point.p_ned, -v.plant.row.attitude[2])
        here = v.p_ned
        for i in range(3):
            set_point.p_ned[i] = here[i] + set_point.p_ned[i] if set_point.use_position[i] else 0.0
    set_point.time_s = v.time_ms / 1e3
    v.take_set_point(cython.address(set_point))


def _turn(v: Any, yaw_rad: float) -> None:
    """Turn a vector (3,) given as forward, right, down, into NED: about down by the yaw."""
    sin, cos = elementary.sin_cos(yaw_rad)
    north, east = cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]
    v[0], v[1] = north, east


def follow_target(context: ServiceContext, call: Call) -> None:
    """Take in a position: of a partner in a transfer, or of a target that the vehicle may follow. No velocity is
    none."""
    content, vehicle = call.content, context.vehicle
    known = all(isfinite(v) for v in content.vel)
    vel = [0.0 if isnan(v) else v for v in content.vel]
    if all(isfinite(number) for number in (content.alt, *vel)):
        p_ned = vehicle.frame.to_local(1e-7 * content.lat, 1e-7 * content.lon, content.alt)
        vehicle.receive_target(p_ned, (vel[0], vel[1], vel[2]))
        if known:
            vehicle.exchange.neighbours[call.frame.sysid] = Neighbour(
                p_ned, tuple(content.vel), vehicle.v_ned, vehicle.time_s
            )


def named_value_int(context: ServiceContext, call: Call) -> None:
    vehicle = context.vehicle
    vehicle.exchange.receive_counter(call.frame.sysid, call.content.name, call.content.value, vehicle.time_s)


MESSAGES: dict[int, MessageHandler] = {
    mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT: global_set_point,
    mav.MAVLINK_MSG_ID_FOLLOW_TARGET: follow_target,
    mav.MAVLINK_MSG_ID_NAMED_VALUE_INT: named_value_int,
}
