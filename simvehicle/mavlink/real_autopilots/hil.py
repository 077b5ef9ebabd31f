"""PX4's interface for a simulation of one's own: MAVLink's HIL messages, to it and from it. No socket, no clock.

Each HIL_SENSOR sets the autopilot's time, and it answers with one HIL_ACTUATOR_CONTROLS of that time. Axes of the body
are frd (front, right, down), those of the world are NED. Conversions to the wire's units stand here alone.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Sequence
from typing import Any, NamedTuple

from simvehicle.mavlink.codec import ReceivedFrame, message
from skytender import elementary
from skytender import mavlink as mav

ACCEL, GYRO, MAG, BARO = 0b111, 0b111 << 3, 0b111 << 6, 0b1101 << 9
"""Bits of HIL_SENSOR's fields_updated: three axes each; pressure, its height and the temperature."""
GAUSS_PER_T = 1e4
GNSS_NO_FIX, GNSS_FIX_3D = 1, 3
_CONTROLS = struct.Struct("<QQ4f")
_CONTROLS_BYTES = 81
ROTORS = 4
LOCKSTEP = 1
"""Bit of HIL_ACTUATOR_CONTROLS' flags: the autopilot waits for its simulation."""


class MotorControls(NamedTuple):
    """Wish of the autopilot for its motors: its time, µs, whether it waits, and throttles, 0 to 1."""

    time_us: int
    lockstep: bool
    throttles: tuple[float, ...]


def controls(frame: ReceivedFrame) -> MotorControls | None:
    """The motors' controls in a frame; None where it has none."""
    if frame.msgid != mav.MAVLINK_MSG_ID_HIL_ACTUATOR_CONTROLS:
        return None
    time_us, flags, *values = _CONTROLS.unpack_from(frame.payload.ljust(_CONTROLS_BYTES, b"\0"))
    throttles = tuple(min(max(value, 0.0), 1.0) if math.isfinite(value) else 0.0 for value in values)
    return MotorControls(time_us, bool(flags & LOCKSTEP), throttles)


def sensor(
    time_us: int,
    *,
    accel_body: Sequence[float],
    rates_body: Sequence[float],
    slow: tuple[Sequence[float], float, float, float] | None,
) -> Any:
    """HIL_SENSOR: specific force m/s² and rates rad/s about the body's axes; `slow`, where magnetometer and barometer
    have been read too: field of the body's axes T, pressure Pa, height by pressure m, temperature °C."""
    field_body, pressure_pa, height_m, celsius = slow or ((0.0, 0.0, 0.0), 0.0, 0.0, 0.0)
    return message("HIL_SENSOR")(
        time_us,
        *accel_body,
        *rates_body,
        *(GAUSS_PER_T * t for t in field_body),
        pressure_pa / 100.0,
        0.0,
        height_m,
        celsius,
        ACCEL | GYRO | (0 if slow is None else MAG | BARO),
        0,
    )


def gnss(
    unix_us: int,
    *,
    lat_deg: float,
    lon_deg: float,
    alt_m: float,
    v_ned: Sequence[float],
    eph_m: float,
    epv_m: float,
    satellites: int,
    fix: bool = True,
) -> Any:
    """HIL_GPS: place in degrees and m above mean sea level, velocity m/s NED, deviations of the place across and
    along the vertical, m. Without a `fix` none of it counts."""
    north, east, down = v_ned
    return message("HIL_GPS")(
        time_usec=unix_us,
        lat=round(1e7 * lat_deg),
        lon=round(1e7 * lon_deg),
        alt=round(1e3 * alt_m),
        eph=round(1e2 * eph_m),
        epv=round(1e2 * epv_m),
        vel=min(round(1e2 * elementary.norm((north, east, down))), 65534),
        vn=_short(1e2 * north),
        ve=_short(1e2 * east),
        vd=_short(1e2 * down),
        cog=round(1e2 * (math.degrees(elementary.atan2(east, north)) % 360.0)) % 36000,
        fix_type=GNSS_FIX_3D if fix else GNSS_NO_FIX,
        satellites_visible=satellites,
    )


def truth(
    time_us: int,
    *,
    quaternion: Sequence[float],
    rates_body: Sequence[float],
    lat_deg: float,
    lon_deg: float,
    alt_m: float,
    v_ned: Sequence[float],
    accel_body: Sequence[float],
) -> Any:
    """HIL_STATE_QUATERNION, which the autopilot only writes to its log: true attitude (w first, body to NED), rates
    rad/s, place in degrees and m, velocity m/s NED, specific force m/s²."""
    speed_cm_s = min(round(1e2 * elementary.norm(v_ned)), 65535)
    return message("HIL_STATE_QUATERNION")(
        time_usec=time_us,
        attitude_quaternion=tuple(quaternion),
        rollspeed=rates_body[0],
        pitchspeed=rates_body[1],
        yawspeed=rates_body[2],
        lat=round(1e7 * lat_deg),
        lon=round(1e7 * lon_deg),
        alt=round(1e3 * alt_m),
        vx=_short(1e2 * v_ned[0]),
        vy=_short(1e2 * v_ned[1]),
        vz=_short(1e2 * v_ned[2]),
        ind_airspeed=speed_cm_s,
        true_airspeed=speed_cm_s,
        xacc=_short(accel_body[0] * 1e3 / 9.80665),
        yacc=_short(accel_body[1] * 1e3 / 9.80665),
        zacc=_short(accel_body[2] * 1e3 / 9.80665),
    )


def _short(value: float) -> int:
    """The nearest number of 16 bits."""
    return min(max(round(value), -(2**15)), 2**15 - 1)
