"""Set points of the supervisor: position and velocity in the common NED frame, and their MAVLink message."""

from __future__ import annotations

from dataclasses import dataclass

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.common_frame import Vec3, turned
from gcs.mavlink.ids import AUTOPILOT

POSITION_AND_VELOCITY = (
    mav.POSITION_TARGET_TYPEMASK_AX_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AY_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AZ_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_YAW_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE
)
_MSGID = codec.msgid("SET_POSITION_TARGET_LOCAL_NED")


@dataclass(frozen=True, slots=True)
class SetPoint:
    """Position and velocity of one vehicle wanted at the tick's time; common NED frame, m and m/s."""

    sysid: int
    p_ned: Vec3
    v_ned: Vec3


def encoded(point: SetPoint, origin_offset_ned: Vec3, time_ms: int, turn_rad: float = 0.0) -> Message:
    """SET_POSITION_TARGET_LOCAL_NED in the vehicle's own frame, whose origin lies at `origin_offset_ned` (m) and which
    is turned by `turn_rad` about the vertical."""
    (north, east, down), (north_0, east_0, down_0) = point.p_ned, origin_offset_ned
    p_local = turned((north - north_0, east - east_0, down - down_0), -turn_rad)
    values = (
        *(time_ms, *p_local, *turned(point.v_ned, -turn_rad), 0.0, 0.0, 0.0, 0.0, 0.0),
        *(POSITION_AND_VELOCITY, point.sysid, AUTOPILOT, mav.MAV_FRAME_LOCAL_NED),
    )
    return Message(_MSGID, values)
