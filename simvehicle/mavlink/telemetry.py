"""Telemetry of the vehicle: its state in SI and NED in, payloads of MAVLink messages in MAVLink's units out.

TELEMETRY is the table: message name and rate in Hz by default on every connection. What a stream sends stands in the
function of its name.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import cython
import cython.cimports.skytender.elementary as elementary
import cython.cimports.skytender.messages as mav
from cython.cimports.cpython.bytes import PyBytes_FromStringAndSize
from cython.cimports.libc import math
from cython.cimports.libc.string import memcpy, memset, strlen
from cython.cimports.simvehicle.mavlink.telemetry import (
    _ALTITUDE,
    _ATTITUDE,
    _ATTITUDE_QUATERNION,
    _BATTERY_STATUS,
    _CONTROL_EFFORT,
    _CONTROL_STATUS,
    _CURRENT_MODE,
    _EXTENDED_SYS_STATE,
    _FOLLOW_TARGET,
    _GLOBAL_POSITION_INT,
    _GPS_GLOBAL_ORIGIN,
    _GPS_RAW_INT,
    _HEARTBEAT,
    _HOME_POSITION,
    _LOCAL_POSITION_NED,
    _MISSION_CURRENT,
    _POSITION_TARGET_LOCAL_NED,
    _SYS_STATUS,
    _VFR_HUD,
    _XFER_IN,
    _XFER_OUT,
    LARGEST_BYTES,
    MESSAGES,
    STREAMS,
)

from simvehicle.autopilot.body import CELL_FULL_V, CELLS
from simvehicle.autopilot.failures import Failure
from simvehicle.autopilot.modes import Mode
from simvehicle.mavlink.codec import message, schema, unpacked
from skytender import mavlink

UNKNOWN_U16 = 65535
_SENSORS = (
    mavlink.MAV_SYS_STATUS_SENSOR_3D_GYRO
    | mavlink.MAV_SYS_STATUS_SENSOR_3D_ACCEL
    | mavlink.MAV_SYS_STATUS_SENSOR_3D_MAG
    | mavlink.MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE
    | mavlink.MAV_SYS_STATUS_SENSOR_GPS
    | mavlink.MAV_SYS_STATUS_SENSOR_BATTERY
    | mavlink.MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS
    | mavlink.MAV_SYS_STATUS_GEOFENCE
    | mavlink.MAV_SYS_STATUS_AHRS
)
_ILL = {
    Failure.GPS: mavlink.MAV_SYS_STATUS_SENSOR_GPS,
    Failure.BATTERY: mavlink.MAV_SYS_STATUS_SENSOR_BATTERY,
    Failure.MOTOR: mavlink.MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS,
}
_HOLD, _TAKEOFF, _LAND, _MISSION = Mode.HOLD, Mode.TAKEOFF, Mode.LAND, Mode.MISSION
_TURN_RAD, _DEG = 2.0 * math.M_PI, 180.0 / math.M_PI


class Stream(NamedTuple):
    """One telemetry stream: its key, its message's id and its rate by default."""

    key: str
    msgid: int
    rate_hz: float


UNPROMPTED = {"ATTITUDE_QUATERNION": 10.0, "VFR_HUD": 4.0, "ALTITUDE": 2.0, "MISSION_CURRENT": 1.0, "CURRENT_MODE": 0.5}
"""Streams beside the table's own rates, in Hz, for plain connections: QGroundControl requests none from a PX4."""

TELEMETRY: tuple[Stream, ...] = (
    Stream("HEARTBEAT", mavlink.MAVLINK_MSG_ID_HEARTBEAT, 1.0),
    Stream("SYS_STATUS", mavlink.MAVLINK_MSG_ID_SYS_STATUS, 1.0),
    Stream("EXTENDED_SYS_STATE", mavlink.MAVLINK_MSG_ID_EXTENDED_SYS_STATE, 1.0),
    Stream("ATTITUDE", mavlink.MAVLINK_MSG_ID_ATTITUDE, 10.0),
    Stream("LOCAL_POSITION_NED", mavlink.MAVLINK_MSG_ID_LOCAL_POSITION_NED, 10.0),
    Stream("GLOBAL_POSITION_INT", mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT, 5.0),
    Stream("GPS_RAW_INT", mavlink.MAVLINK_MSG_ID_GPS_RAW_INT, 1.0),
    Stream("HOME_POSITION", mavlink.MAVLINK_MSG_ID_HOME_POSITION, 0.5),
    Stream("GPS_GLOBAL_ORIGIN", mavlink.MAVLINK_MSG_ID_GPS_GLOBAL_ORIGIN, 0.5),
    Stream("BATTERY_STATUS", mavlink.MAVLINK_MSG_ID_BATTERY_STATUS, 2.0),
    Stream("POSITION_TARGET_LOCAL_NED", mavlink.MAVLINK_MSG_ID_POSITION_TARGET_LOCAL_NED, 2.0),
    Stream("CtlEffort", mavlink.MAVLINK_MSG_ID_NAMED_VALUE_FLOAT, 1.0),
    Stream("XferOut", mavlink.MAVLINK_MSG_ID_NAMED_VALUE_INT, 1.0),
    Stream("XferIn", mavlink.MAVLINK_MSG_ID_NAMED_VALUE_INT, 1.0),
    Stream("FOLLOW_TARGET", mavlink.MAVLINK_MSG_ID_FOLLOW_TARGET, 0.0),
    Stream("MISSION_CURRENT", mavlink.MAVLINK_MSG_ID_MISSION_CURRENT, 0.0),
    Stream("ATTITUDE_QUATERNION", mavlink.MAVLINK_MSG_ID_ATTITUDE_QUATERNION, 0.0),
    Stream("ALTITUDE", mavlink.MAVLINK_MSG_ID_ALTITUDE, 0.0),
    Stream("VFR_HUD", mavlink.MAVLINK_MSG_ID_VFR_HUD, 0.0),
    Stream("CURRENT_MODE", mavlink.MAVLINK_MSG_ID_CURRENT_MODE, 0.0),
    Stream("CONTROL_STATUS", mavlink.MAVLINK_MSG_ID_CONTROL_STATUS, 0.0),
)


def _fill() -> None:
    for k in range(STREAMS):
        row = schema(TELEMETRY[k].msgid)
        assert row is not None
        assert row.packer.size <= LARGEST_BYTES
        MESSAGES[k].msgid, MESSAGES[k].seed, MESSAGES[k].size = row.msgid, row.seed, row.packer.size


_fill()


def message_of(vehicle: Any, key: str) -> Any:
    """A stream's message at the vehicle's present time."""
    written = cython.declare(cython.uchar[LARGEST_BYTES])
    (stream,) = (k for k, one in enumerate(TELEMETRY) if one.key == key)
    write_payload(vehicle, stream, written)
    payload = PyBytes_FromStringAndSize(cython.cast("char *", written), MESSAGES[stream].size)
    row = schema(MESSAGES[stream].msgid)
    assert row is not None
    return unpacked(row, payload)


def autopilot_version(vehicle: Any, sysid: int) -> Any:
    """AUTOPILOT_VERSION: the identity's version, of a development build."""
    major, minor, patch = vehicle.identity.version
    version = major << 24 | minor << 16 | patch << 8 | mavlink.FIRMWARE_VERSION_TYPE_DEV
    return message("AUTOPILOT_VERSION")(
        capabilities=vehicle.identity.capabilities,
        flight_sw_version=version,
        middleware_sw_version=version,
        os_sw_version=version,
        uid=sysid,
    )


def write_payload(v: Any, stream: int, payload: Any) -> None:
    """Write a stream's payload, LARGEST_BYTES of which the rest is 0."""
    memset(payload, 0, LARGEST_BYTES)
    if stream == _ATTITUDE:
        _attitude(v, cython.cast("messages.Attitude *", payload))
    elif stream == _LOCAL_POSITION_NED:
        _local_position_ned(v, cython.cast("messages.LocalPositionNed *", payload))
    elif stream == _GLOBAL_POSITION_INT:
        _global_position_int(v, cython.cast("messages.GlobalPositionInt *", payload))
    elif stream == _HEARTBEAT:
        _heartbeat(v, cython.cast("messages.Heartbeat *", payload))
    elif stream == _SYS_STATUS:
        _sys_status(v, cython.cast("messages.SysStatus *", payload))
    elif stream == _EXTENDED_SYS_STATE:
        _extended_sys_state(v, cython.cast("messages.ExtendedSysState *", payload))
    elif stream == _GPS_RAW_INT:
        _gps_raw_int(v, cython.cast("messages.GpsRawInt *", payload))
    elif stream == _HOME_POSITION:
        _home_position(v, cython.cast("messages.HomePosition *", payload))
    elif stream == _GPS_GLOBAL_ORIGIN:
        _gps_global_origin(v, cython.cast("messages.GpsGlobalOrigin *", payload))
    elif stream == _BATTERY_STATUS:
        _battery_status(v, cython.cast("messages.BatteryStatus *", payload))
    elif stream == _POSITION_TARGET_LOCAL_NED:
        _position_target_local_ned(v, cython.cast("messages.PositionTargetLocalNed *", payload))
    elif stream == _CONTROL_EFFORT:
        _control_effort(v, cython.cast("messages.NamedValueFloat *", payload))
    elif stream == _XFER_OUT:
        _transferred(v, cython.cast("messages.NamedValueInt *", payload), b"XferOut", v.exchange.given_j)
    elif stream == _XFER_IN:
        _transferred(v, cython.cast("messages.NamedValueInt *", payload), b"XferIn", v.exchange.received_j)
    elif stream == _FOLLOW_TARGET:
        _follow_target(v, cython.cast("messages.FollowTarget *", payload))
    elif stream == _MISSION_CURRENT:
        _mission_current(v, cython.cast("messages.MissionCurrent *", payload))
    elif stream == _ATTITUDE_QUATERNION:
        _attitude_quaternion(v, cython.cast("messages.AttitudeQuaternion *", payload))
    elif stream == _ALTITUDE:
        _altitude(v, cython.cast("messages.Altitude *", payload))
    elif stream == _VFR_HUD:
        _vfr_hud(v, cython.cast("messages.VfrHud *", payload))
    elif stream == _CURRENT_MODE:
        _current_mode(v, cython.cast("messages.CurrentMode *", payload))
    elif stream == _CONTROL_STATUS:
        _control_status(v, cython.cast("messages.ControlStatus *", payload))


def _heartbeat(v: Any, m: Any) -> None:
    base = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | mav.MAV_MODE_FLAG_STABILIZE_ENABLED
    if v.mode is not _HOLD or v.armed:
        base |= mav.MAV_MODE_FLAG_GUIDED_ENABLED | mav.MAV_MODE_FLAG_AUTO_ENABLED
    if v.armed:
        base |= mav.MAV_MODE_FLAG_SAFETY_ARMED
    flying = mav.MAV_STATE_STANDBY if v.stands() else mav.MAV_STATE_ACTIVE
    if v.armed and v.in_failsafe:
        flying = mav.MAV_STATE_CRITICAL
    m.type, m.autopilot, m.base_mode = mav.MAV_TYPE_QUADROTOR, v.identity.autopilot, base
    m.custom_mode, m.mavlink_version = v.identity.spoken[v.mode], 3
    m.system_status = mav.MAV_STATE_BOOT if v.booting else flying


def _sys_status(v: Any, m: Any) -> None:
    """Failed sensors are unhealthy, and so is the fence of a vehicle outside it."""
    healthy = _SENSORS & ~(mav.MAV_SYS_STATUS_GEOFENCE if v.outside() else 0)
    for failure in v.failed:
        healthy &= ~_ILL.get(failure, 0)
    ready = mav.MAV_SYS_STATUS_PREARM_CHECK if v.arming_refusal() is None else 0
    m.onboard_control_sensors_present = _SENSORS | mav.MAV_SYS_STATUS_PREARM_CHECK
    m.onboard_control_sensors_enabled = _SENSORS | mav.MAV_SYS_STATUS_PREARM_CHECK
    m.onboard_control_sensors_health = healthy | ready
    m.load = 100
    m.voltage_battery = _rounded(1e3 * v.voltage_v())
    m.current_battery = _bounded(1e2 * v.current_a(), 16)
    m.battery_remaining = v.percent()


def _extended_sys_state(v: Any, m: Any) -> None:
    landed = mav.MAV_LANDED_STATE_IN_AIR
    if v.stands():
        landed = mav.MAV_LANDED_STATE_ON_GROUND
    elif v.mode is _TAKEOFF:
        landed = mav.MAV_LANDED_STATE_TAKEOFF
    elif v.mode is _LAND or (v.mode is _MISSION and v.mission is not None and v.mission.landing):
        landed = mav.MAV_LANDED_STATE_LANDING
    m.vtol_state, m.landed_state = mav.MAV_VTOL_STATE_UNDEFINED, landed


def _attitude(v: Any, m: Any) -> None:
    """Euler angles, and rates about the body's axes: docs/model/vehicle.md#rigid-body."""
    angles, rates = v.plant.row.attitude, v.plant.row.rates
    sin_roll, cos_roll = elementary.sin_cos(angles[0])
    sin_pitch, cos_pitch = elementary.sin_cos(angles[1])
    m.time_boot_ms = v.time_ms
    m.roll, m.pitch, m.yaw = _radians(angles[0]), _radians(-angles[1]), _radians(-angles[2])
    m.rollspeed = rates[0] - rates[2] * sin_pitch
    m.pitchspeed = -(rates[1] * cos_roll + rates[2] * sin_roll * cos_pitch)
    m.yawspeed = -(-rates[1] * sin_roll + rates[2] * cos_roll * cos_pitch)


def _local_position_ned(v: Any, m: Any) -> None:
    velocity = v.plant.row.velocity
    m.time_boot_ms = v.time_ms
    m.x, m.y, m.z = _place(v)
    m.vx, m.vy, m.vz = velocity[0], -velocity[1], -velocity[2]


def _global_position_int(v: Any, m: Any) -> None:
    north, east, down = _place(v)
    velocity = v.plant.row.velocity
    m.time_boot_ms = v.time_ms
    m.lat, m.lon = _latitude(v, north), _longitude(v, east)
    m.alt = _bounded(1e3 * (v.origin[2] - down), 32)
    m.relative_alt = _bounded(1e3 * (v.home[2] - down), 32)
    m.vx, m.vy = _bounded(100.0 * velocity[0], 16), _bounded(-100.0 * velocity[1], 16)
    m.vz = _bounded(-100.0 * velocity[2], 16)
    m.hdg = _cdeg(-v.plant.row.attitude[2])


def _gps_raw_int(v: Any, m: Any) -> None:
    """Without a fix the message has no place and unknown accuracies, as PX4's and ArduPilot's have; 0 is the only word
    that accuracies have for unknown."""
    m.time_usec = v.unix_epoch_us + 1000 * v.time_ms
    if v.failed and Failure.GPS in v.failed:
        m.fix_type = mav.GPS_FIX_TYPE_NO_FIX
        m.eph = m.epv = m.vel = m.cog = UNKNOWN_U16
        return
    north, east, down = _place(v)
    v_north, v_east = v.plant.row.velocity[0], -v.plant.row.velocity[1]
    m.fix_type, m.satellites_visible = mav.GPS_FIX_TYPE_3D_FIX, 14
    m.lat, m.lon = _latitude(v, north), _longitude(v, east)
    m.alt = m.alt_ellipsoid = _bounded(1e3 * (v.origin[2] - down), 32)
    m.eph, m.epv = 70, 100
    m.vel = _bounded(100.0 * math.sqrt(v_north * v_north + v_east * v_east), 16)
    m.cog = _cdeg(elementary.atan2(v_east, v_north))
    m.h_acc = m.v_acc = max(_rounded(1e3 * v.plant.place_deviation_m), 1)
    m.vel_acc = max(_rounded(1e3 * v.plant.velocity_deviation_m_s), 1)


def _home_position(v: Any, m: Any) -> None:
    north, east, down = v.home[0], v.home[1], v.home[2]
    m.latitude, m.longitude = _latitude(v, north), _longitude(v, east)
    m.altitude = _bounded(1e3 * (v.origin[2] - down), 32)
    m.x, m.y, m.z, m.q[0] = north, east, down, 1.0
    m.time_usec = v.unix_epoch_us + 1000 * v.time_ms


def _gps_global_origin(v: Any, m: Any) -> None:
    m.latitude, m.longitude = _latitude(v, 0.0), _longitude(v, 0.0)
    m.altitude = _bounded(1e3 * v.origin[2], 32)
    m.time_usec = v.unix_epoch_us + 1000 * v.time_ms


def _battery_status(v: Any, m: Any) -> None:
    drawn_j, cell_mv = v.plant.row.drawn_j, _rounded(1e3 * v.voltage_v() / CELLS)
    m.battery_function, m.type = mav.MAV_BATTERY_FUNCTION_ALL, mav.MAV_BATTERY_TYPE_LIPO
    m.temperature = 32767
    for i in range(10):
        m.voltages[i] = cell_mv if i < CELLS else UNKNOWN_U16
    m.current_battery = _bounded(1e2 * v.current_a(), 16)
    m.current_consumed = _bounded(1e3 * (drawn_j / (CELLS * CELL_FULL_V) / 3600.0), 32)
    m.energy_consumed = _bounded(math.floor(drawn_j / 100.0), 32)
    m.battery_remaining = v.percent()
    m.time_remaining = _bounded(v.shown_j() / v.power_w, 32) if v.power_w > 0.0 else 0
    m.charge_state = mav.MAV_BATTERY_CHARGE_STATE_OK
    if v.battery_low():  # what lands a PX4 is its emergency, and critical is the worst that ArduPilot knows
        copter = v.identity.copter_rules
        m.charge_state = mav.MAV_BATTERY_CHARGE_STATE_CRITICAL if copter else mav.MAV_BATTERY_CHARGE_STATE_EMERGENCY


def _position_target_local_ned(v: Any, m: Any) -> None:
    """The reference that the guidance really flies; of a vehicle with a virtual leader of its own that one, and the
    acceleration that it wants."""
    m.time_boot_ms, m.coordinate_frame = v.time_ms, mav.MAV_FRAME_LOCAL_NED
    m.yaw = _radians(v.yaw_ned)
    if v.leads:
        m.type_mask = mav.POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE
        m.x, m.y, m.z = v.leader[0], v.leader[1], v.leader[2]
        m.vx, m.vy, m.vz = v.leader[3], v.leader[4], v.leader[5]
        m.afx, m.afy, m.afz = v.leader[6], v.leader[7], v.leader[8]
        return
    p, velocity = v.plant.row.reference_position, v.plant.row.reference_velocity
    m.type_mask = (
        mav.POSITION_TARGET_TYPEMASK_AX_IGNORE
        | mav.POSITION_TARGET_TYPEMASK_AY_IGNORE
        | mav.POSITION_TARGET_TYPEMASK_AZ_IGNORE
        | mav.POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE
    )
    m.x, m.y, m.z = v.seen(p[0], p[1], p[2])
    m.vx, m.vy, m.vz = velocity[0], -velocity[1], -velocity[2]


def _control_effort(v: Any, m: Any) -> None:
    m.time_boot_ms, m.value = v.time_ms, v.plant.row.effort
    memcpy(m.name, cython.cast("const char *", b"CtlEffort"), 9)


def _transferred(v: Any, m: Any, name: Any, joules: int) -> None:
    m.time_boot_ms, m.value = v.time_ms, _bounded(joules, 32)
    memcpy(m.name, name, strlen(name))


def _follow_target(v: Any, m: Any) -> None:
    north, east, down = _place(v)
    velocity = v.plant.row.velocity
    m.timestamp, m.est_capabilities = v.time_ms, 0b11
    m.lat, m.lon = _latitude(v, north), _longitude(v, east)
    m.alt, m.attitude_q[0] = v.origin[2] - down, 1.0
    m.vel[0], m.vel[1], m.vel[2] = velocity[0], -velocity[1], -velocity[2]


def _mission_current(v: Any, m: Any) -> None:
    """MISSION_CURRENT, in the words of MISSION_STATE: 1 none, 2 not begun, 3 flown, 4 paused, 5 flown to its end. Home
    is no item of the total."""
    length = 0 if v.mission is None else len(v.mission.legs)
    items = length - 1 if v.identity.item_0_is_home else length
    m.seq, m.total, m.mission_state, m.mission_mode = 0, UNKNOWN_U16, 1, 2 - (v.mode is _MISSION)
    if items > 0:
        index, flown = v.mission.index, v.mode is _MISSION and v.armed
        state = 5 if index >= length else 3 if flown else 4 if index else 2
        m.seq, m.total, m.mission_state = min(index, length - 1), items, state


def _attitude_quaternion(v: Any, m: Any) -> None:
    angles, rates = v.plant.row.attitude, v.rates_body
    sr, cr = elementary.sin_cos(0.5 * angles[0])
    sp, cp = elementary.sin_cos(-0.5 * angles[1])
    sy, cy = elementary.sin_cos(-0.5 * angles[2])
    m.time_boot_ms = v.time_ms
    m.q1, m.q2 = cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy
    m.q3, m.q4 = cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy
    m.rollspeed, m.pitchspeed, m.yawspeed = rates


def _altitude(v: Any, m: Any) -> None:
    _, _, down = _place(v)
    m.time_usec = v.unix_epoch_us + 1000 * v.time_ms
    m.altitude_monotonic = m.altitude_amsl = v.origin[2] - down
    m.altitude_local, m.altitude_relative = -down, v.home[2] - down
    m.altitude_terrain = m.bottom_clearance = math.NAN


def _vfr_hud(v: Any, m: Any) -> None:
    _, _, down = _place(v)
    north, east, v_down = v.v_ned
    m.groundspeed = elementary.hypot(north, east)
    m.airspeed = elementary.norm((north, east, v_down))
    m.heading = _turned(_rounded(-v.plant.row.attitude[2] * _DEG), 360)
    m.throttle = _rounded(100.0 * v.throttle())
    m.alt, m.climb = v.origin[2] - down, -v_down


def _current_mode(v: Any, m: Any) -> None:
    m.standard_mode = v.identity.standard_mode(v.mode)
    m.custom_mode, m.intended_custom_mode = v.identity.spoken[v.mode], v.identity.spoken[v.intended]


def _control_status(v: Any, m: Any) -> None:
    m.gcs_main, m.flags = v.gcs_main, mav.GCS_CONTROL_STATUS_FLAGS_SYSTEM_MANAGER
    if v.gcs_main == 0 or v.takeover_allowed:
        m.flags |= mav.GCS_CONTROL_STATUS_FLAGS_TAKEOVER_ALLOWED


def available_modes(vehicle: Any, index: int) -> list[Any]:
    """AVAILABLE_MODES of the mode with that index, counted from 1, or with 0 of all."""
    modes = vehicle.identity.available
    return [
        message("AVAILABLE_MODES")(
            number_modes=len(modes),
            mode_index=k,
            standard_mode=one.standard,
            custom_mode=one.number,
            properties=mavlink.MAV_MODE_PROPERTY_AUTO_MODE
            | (0 if one.selectable else mavlink.MAV_MODE_PROPERTY_NOT_USER_SELECTABLE),
            mode_name=one.name,
        )
        for k, one in enumerate(modes, 1)
        if index in (0, k)
    ]


def _place(v: Any) -> tuple[float, float, float]:
    """Position as the vehicle knows it, NED, m."""
    p = v.plant.row.position
    return v.seen(p[0], p[1], p[2])


def _latitude(v: Any, north_m: float) -> int:
    """degE7 of so far north of the origin."""
    return _rounded(1e7 * _remainder(v.origin[0] + north_m * v.origin[3], 360.0))


def _longitude(v: Any, east_m: float) -> int:
    """degE7 of so far east of the origin."""
    return _rounded(1e7 * _remainder(v.origin[1] + east_m * v.origin[4], 360.0))


def _radians(angle_rad: float) -> float:
    """The same angle within half a turn."""
    return _remainder(angle_rad, _TURN_RAD)


def _remainder(x: float, whole: float) -> float:
    """IEEE's remainder, exact."""
    rest = math.fmod(x, whole)
    if math.fabs(rest) > 0.5 * whole:
        rest -= math.copysign(whole, rest)
    return rest


def _bounded(value: float, bits: int) -> int:
    """The nearest number that so many bits hold: no state of a vehicle may be too great for its telemetry."""
    limit = math.ldexp(1.0, bits - 1)
    return cython.cast(cython.longlong, min(max(math.rint(value), -limit), limit - 1.0))


def _rounded(value: float) -> int:
    """The nearest whole number."""
    return cython.cast(cython.longlong, math.rint(value))


def _cdeg(angle_rad: float) -> int:
    """An angle in hundredths of a degree, 0 to 35999."""
    return _turned(_rounded(1e2 * (angle_rad * _DEG)), 36000)


def _turned(angle: int, whole: int) -> int:
    """The same angle, 0 to less than a whole turn."""
    rest = angle % whole
    return rest + whole if rest < 0 else rest
