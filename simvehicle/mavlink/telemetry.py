"""Telemetry of the vehicle: a snapshot in SI and NED in, MAVLink messages in MAVLink's units out.

TELEMETRY is the table: message name, rate in Hz by default on every connection, and the function that builds it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from simvehicle.autopilot.failures import Failure
from simvehicle.autopilot.modes import Mode
from simvehicle.autopilot.snapshot import CELL_FULL_V, CELLS, Vec3, VehicleState
from simvehicle.mavlink import motion_frames
from simvehicle.mavlink.codec import message
from skytender import elementary
from skytender import mavlink as mav

__all__ = ["ALL_HEALTHY", "TELEMETRY", "UNPROMPTED", "Stream", "Vec3", "VehicleState", "autopilot_version", "heartbeat"]

UNKNOWN_U16 = 65535
ALL_HEALTHY = (
    mav.MAV_SYS_STATUS_SENSOR_3D_GYRO
    | mav.MAV_SYS_STATUS_SENSOR_3D_ACCEL
    | mav.MAV_SYS_STATUS_SENSOR_3D_MAG
    | mav.MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE
    | mav.MAV_SYS_STATUS_SENSOR_GPS
    | mav.MAV_SYS_STATUS_SENSOR_BATTERY
    | mav.MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS
    | mav.MAV_SYS_STATUS_GEOFENCE
    | mav.MAV_SYS_STATUS_AHRS
)


def heartbeat(s: VehicleState) -> Any:
    base = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | mav.MAV_MODE_FLAG_STABILIZE_ENABLED
    if s.mode is not Mode.HOLD or s.armed:
        base |= mav.MAV_MODE_FLAG_GUIDED_ENABLED | mav.MAV_MODE_FLAG_AUTO_ENABLED
    if s.armed:
        base |= mav.MAV_MODE_FLAG_SAFETY_ARMED
    return message("HEARTBEAT")(
        type=mav.MAV_TYPE_QUADROTOR,
        autopilot=s.identity.autopilot,
        base_mode=base,
        custom_mode=s.identity.spoken[s.mode],
        system_status=mav.MAV_STATE_BOOT if s.booting else mav.MAV_STATE_STANDBY if s.landed else mav.MAV_STATE_ACTIVE,
        mavlink_version=3,
    )


def sys_status(s: VehicleState) -> Any:
    present = ALL_HEALTHY | mav.MAV_SYS_STATUS_PREARM_CHECK
    health = ALL_HEALTHY & ~_ill(s) | (mav.MAV_SYS_STATUS_PREARM_CHECK if s.ready_to_arm else 0)
    return message("SYS_STATUS")(
        onboard_control_sensors_present=present,
        onboard_control_sensors_enabled=present,
        onboard_control_sensors_health=health,
        load=100,
        voltage_battery=round(1e3 * s.voltage_v),
        current_battery=_current_ca(s),
        battery_remaining=s.percent,
    )


def _current_ca(s: VehicleState) -> int:
    """Current in the wire's 10 mA: the plant's, else of the power at the voltage."""
    return _int16(1e2 * s.power_w / s.voltage_v if s.electric is None else 1e2 * s.electric[1])


_ILL = {
    Failure.GPS: mav.MAV_SYS_STATUS_SENSOR_GPS,
    Failure.BATTERY: mav.MAV_SYS_STATUS_SENSOR_BATTERY,
    Failure.MOTOR: mav.MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS,
}


def _ill(s: VehicleState) -> int:
    """Bits of what has failed, and of a fence that is breached."""
    bits = mav.MAV_SYS_STATUS_GEOFENCE if s.outside_fence else 0
    for failure in s.failed:
        bits |= _ILL.get(failure, 0)
    return int(bits)


def extended_sys_state(s: VehicleState) -> Any:
    landed = mav.MAV_LANDED_STATE_IN_AIR
    if s.landed:
        landed = mav.MAV_LANDED_STATE_ON_GROUND
    elif s.mode is Mode.TAKEOFF:
        landed = mav.MAV_LANDED_STATE_TAKEOFF
    elif s.mode is Mode.LAND or s.mission_landing:
        landed = mav.MAV_LANDED_STATE_LANDING
    return message("EXTENDED_SYS_STATE")(vtol_state=mav.MAV_VTOL_STATE_UNDEFINED, landed_state=landed)


def attitude(s: VehicleState) -> Any:
    roll, pitch, yaw = s.attitude_ned
    p, q, r = s.rates_body
    return message("ATTITUDE")(s.time_ms, _wrapped(roll), _wrapped(pitch), _wrapped(yaw), p, q, r)


def local_position_ned(s: VehicleState) -> Any:
    return message("LOCAL_POSITION_NED")(s.time_ms, *s.p_ned, *s.v_ned)


def global_position_int(s: VehicleState) -> Any:
    p_ned, (v_n, v_e, v_d) = s.p_ned, s.v_ned
    lat_deg, lon_deg, alt_m = s.frame.to_global(*p_ned)
    return message("GLOBAL_POSITION_INT")(
        time_boot_ms=s.time_ms,
        lat=_deg_e7(lat_deg),
        lon=_deg_e7(lon_deg),
        alt=_int32(1e3 * alt_m),
        relative_alt=_int32(1e3 * (s.home_ned[2] - p_ned[2])),
        vx=_int16(100.0 * v_n),
        vy=_int16(100.0 * v_e),
        vz=_int16(100.0 * v_d),
        hdg=round(1e2 * math.degrees(s.attitude_ned[2])) % 36000,
    )


def gps_raw_int(s: VehicleState) -> Any:
    lat_deg, lon_deg, alt_m = s.frame.to_global(*s.p_ned)
    course_deg = math.degrees(elementary.atan2(s.v_ned[1], s.v_ned[0]))
    return message("GPS_RAW_INT")(
        time_usec=s.unix_us,
        fix_type=mav.GPS_FIX_TYPE_NO_FIX if Failure.GPS in s.failed else mav.GPS_FIX_TYPE_3D_FIX,
        lat=_deg_e7(lat_deg),
        lon=_deg_e7(lon_deg),
        alt=_int32(1e3 * alt_m),
        eph=70,
        epv=100,
        vel=_int16(100.0 * math.sqrt(s.v_ned[0] * s.v_ned[0] + s.v_ned[1] * s.v_ned[1])),
        cog=round(1e2 * course_deg) % 36000,
        satellites_visible=0 if Failure.GPS in s.failed else 14,
        alt_ellipsoid=_int32(1e3 * alt_m),
        h_acc=300,
        v_acc=500,
        vel_acc=100,
    )


def home_position(s: VehicleState) -> Any:
    lat_deg, lon_deg, alt_m = s.frame.to_global(*s.home_ned)
    return message("HOME_POSITION")(
        latitude=_deg_e7(lat_deg),
        longitude=_deg_e7(lon_deg),
        altitude=_int32(1e3 * alt_m),
        x=s.home_ned[0],
        y=s.home_ned[1],
        z=s.home_ned[2],
        q=(1.0, 0.0, 0.0, 0.0),
        time_usec=s.unix_us,
    )


def gps_global_origin(s: VehicleState) -> Any:
    return message("GPS_GLOBAL_ORIGIN")(
        latitude=_deg_e7(s.frame.lat_deg),
        longitude=_deg_e7(s.frame.lon_deg),
        altitude=_int32(1e3 * s.frame.alt_m),
        time_usec=s.unix_us,
    )


def battery_status(s: VehicleState) -> Any:
    cell_mv = round(1e3 * s.voltage_v / CELLS)
    charge_ah = s.drawn_j / (CELLS * CELL_FULL_V) / 3600.0
    return message("BATTERY_STATUS")(
        battery_function=mav.MAV_BATTERY_FUNCTION_ALL,
        type=mav.MAV_BATTERY_TYPE_LIPO,
        temperature=32767,
        voltages=(cell_mv,) * CELLS + (UNKNOWN_U16,) * (10 - CELLS),
        current_battery=_current_ca(s),
        current_consumed=_int32(1e3 * charge_ah),
        energy_consumed=_int32(math.floor(s.drawn_j / 100.0)),
        battery_remaining=s.percent,
        time_remaining=_int32(s.remaining_j / s.power_w) if s.power_w > 0.0 else 0,
        charge_state=mav.MAV_BATTERY_CHARGE_STATE_OK,
    )


def position_target_local_ned(s: VehicleState) -> Any:
    return message("POSITION_TARGET_LOCAL_NED")(
        time_boot_ms=s.time_ms,
        coordinate_frame=mav.MAV_FRAME_LOCAL_NED,
        type_mask=mav.POSITION_TARGET_TYPEMASK_AX_IGNORE
        | mav.POSITION_TARGET_TYPEMASK_AY_IGNORE
        | mav.POSITION_TARGET_TYPEMASK_AZ_IGNORE
        | mav.POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE,
        x=s.target_p_ned[0],
        y=s.target_p_ned[1],
        z=s.target_p_ned[2],
        vx=s.target_v_ned[0],
        vy=s.target_v_ned[1],
        vz=s.target_v_ned[2],
        yaw=_wrapped(s.target_yaw_ned),
    )


def control_effort(s: VehicleState) -> Any:
    return message("NAMED_VALUE_FLOAT")(time_boot_ms=s.time_ms, name="CtlEffort", value=s.control_effort)


def follow_target(s: VehicleState) -> Any:
    lat_deg, lon_deg, alt_m = s.frame.to_global(*s.p_ned)
    return message("FOLLOW_TARGET")(
        timestamp=s.time_ms,
        est_capabilities=0b11,
        lat=_deg_e7(lat_deg),
        lon=_deg_e7(lon_deg),
        alt=alt_m,
        vel=s.v_ned,
        attitude_q=(1.0, 0.0, 0.0, 0.0),
    )


def xfer_out(s: VehicleState) -> Any:
    return message("NAMED_VALUE_INT")(time_boot_ms=s.time_ms, name="XferOut", value=_int32(s.given_j))


def xfer_in(s: VehicleState) -> Any:
    return message("NAMED_VALUE_INT")(time_boot_ms=s.time_ms, name="XferIn", value=_int32(s.received_j))


def attitude_quaternion(s: VehicleState) -> Any:
    (sr, cr), (sp, cp), (sy, cy) = (elementary.sin_cos(0.5 * angle) for angle in s.attitude_ned)
    return message("ATTITUDE_QUATERNION")(
        s.time_ms,
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        *s.rates_body,
    )


def vfr_hud(s: VehicleState) -> Any:
    speed_m_s = elementary.hypot(s.v_ned[0], s.v_ned[1])
    return message("VFR_HUD")(
        airspeed=elementary.norm(s.v_ned),
        groundspeed=speed_m_s,
        heading=round(math.degrees(s.attitude_ned[2])) % 360,
        alt=s.frame.alt_m - s.p_ned[2],
        climb=-s.v_ned[2],
    )


def altitude(s: VehicleState) -> Any:
    height_m = s.home_ned[2] - s.p_ned[2]
    return message("ALTITUDE")(
        time_usec=s.unix_us,
        altitude_monotonic=s.frame.alt_m - s.p_ned[2],
        altitude_amsl=s.frame.alt_m - s.p_ned[2],
        altitude_local=-s.p_ned[2],
        altitude_relative=height_m,
        altitude_terrain=math.nan,
        bottom_clearance=math.nan,
    )


def mission_current(s: VehicleState) -> Any:
    """MISSION_CURRENT, in the words of MISSION_STATE: 1 none, 2 not begun, 3 flown, 4 paused, 5 flown to its end."""
    state = 1
    if s.mission_length:
        done = s.mission_index >= s.mission_length
        state = 5 if done else 3 if s.mode is Mode.MISSION and s.armed else 4 if s.mission_index else 2
    return message("MISSION_CURRENT")(
        seq=max(min(s.mission_index, s.mission_length - 1), 0),
        total=s.mission_length,
        mission_state=state,
        mission_mode=2 - (s.mode is Mode.MISSION),
    )


def autopilot_version(s: VehicleState, sysid: int) -> Any:
    """AUTOPILOT_VERSION: version 1.15.0 of a development build, which QGroundControl accepts as new enough."""
    version = 1 << 24 | 15 << 16 | 0 << 8 | mav.FIRMWARE_VERSION_TYPE_DEV
    return message("AUTOPILOT_VERSION")(
        capabilities=s.identity.capabilities,
        flight_sw_version=version,
        middleware_sw_version=version,
        os_sw_version=version,
        uid=sysid,
    )


def _wrapped(angle_rad: float) -> float:
    return math.remainder(angle_rad, 2.0 * math.pi)


def _int16(value: float) -> int:
    """The nearest number that 16 bits hold: no state of a vehicle may be too great for its telemetry."""
    return min(max(round(value), -(2**15)), 2**15 - 1)


def _int32(value: float) -> int:
    return min(max(round(value), -(2**31)), 2**31 - 1)


def _deg_e7(angle_deg: float) -> int:
    return round(1e7 * math.remainder(angle_deg, 360.0))


class Stream(NamedTuple):
    """One telemetry stream: its key, the message's id, its default rate and its builder."""

    key: str
    msgid: int
    rate_hz: float
    build: Callable[[VehicleState], Any]
    motion: int = 0
    """its bit where `motion_frames` makes it too"""


UNPROMPTED = {"ATTITUDE_QUATERNION": 10.0, "VFR_HUD": 4.0, "ALTITUDE": 2.0}
"""Streams beside the table's own rates, in Hz, for plain connections: QGroundControl requests none from a PX4."""

TELEMETRY: tuple[Stream, ...] = (
    Stream("HEARTBEAT", mav.MAVLINK_MSG_ID_HEARTBEAT, 1.0, heartbeat),
    Stream("SYS_STATUS", mav.MAVLINK_MSG_ID_SYS_STATUS, 1.0, sys_status),
    Stream("EXTENDED_SYS_STATE", mav.MAVLINK_MSG_ID_EXTENDED_SYS_STATE, 1.0, extended_sys_state),
    Stream("ATTITUDE", mav.MAVLINK_MSG_ID_ATTITUDE, 10.0, attitude, motion_frames.ATTITUDE),
    Stream(
        "LOCAL_POSITION_NED",
        mav.MAVLINK_MSG_ID_LOCAL_POSITION_NED,
        10.0,
        local_position_ned,
        motion_frames.LOCAL_POSITION,
    ),
    Stream(
        "GLOBAL_POSITION_INT",
        mav.MAVLINK_MSG_ID_GLOBAL_POSITION_INT,
        5.0,
        global_position_int,
        motion_frames.GLOBAL_POSITION,
    ),
    Stream("GPS_RAW_INT", mav.MAVLINK_MSG_ID_GPS_RAW_INT, 1.0, gps_raw_int),
    Stream("HOME_POSITION", mav.MAVLINK_MSG_ID_HOME_POSITION, 0.5, home_position),
    Stream("GPS_GLOBAL_ORIGIN", mav.MAVLINK_MSG_ID_GPS_GLOBAL_ORIGIN, 0.5, gps_global_origin),
    Stream("BATTERY_STATUS", mav.MAVLINK_MSG_ID_BATTERY_STATUS, 2.0, battery_status),
    Stream("POSITION_TARGET_LOCAL_NED", mav.MAVLINK_MSG_ID_POSITION_TARGET_LOCAL_NED, 2.0, position_target_local_ned),
    Stream("CtlEffort", mav.MAVLINK_MSG_ID_NAMED_VALUE_FLOAT, 1.0, control_effort),
    Stream("XferOut", mav.MAVLINK_MSG_ID_NAMED_VALUE_INT, 1.0, xfer_out),
    Stream("XferIn", mav.MAVLINK_MSG_ID_NAMED_VALUE_INT, 1.0, xfer_in),
    Stream("FOLLOW_TARGET", mav.MAVLINK_MSG_ID_FOLLOW_TARGET, 0.0, follow_target),
    Stream("MISSION_CURRENT", mav.MAVLINK_MSG_ID_MISSION_CURRENT, 0.0, mission_current),
    Stream("ATTITUDE_QUATERNION", mav.MAVLINK_MSG_ID_ATTITUDE_QUATERNION, 0.0, attitude_quaternion),
    Stream("ALTITUDE", mav.MAVLINK_MSG_ID_ALTITUDE, 0.0, altitude),
    Stream("VFR_HUD", mav.MAVLINK_MSG_ID_VFR_HUD, 0.0, vfr_hud),
)
