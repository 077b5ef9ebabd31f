"""PX4's HIL messages as pymavlink reads and writes them."""

from __future__ import annotations

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common

from simvehicle.mavlink.codec import encode, split
from simvehicle.mavlink.real_autopilots import hil


def read(content: Any) -> Any:
    """A message of ours as pymavlink reads it."""
    (message,) = common.MAVLink(None).parse_buffer(encode(content, seq=0, sysid=1, compid=2)) or []
    return message


def controls(time_us: int, values: list[float], flags: int) -> hil.MotorControls | None:
    sent = common.MAVLink_hil_actuator_controls_message(time_us, values, 0, flags)
    (frame,) = split(bytes(sent.pack(common.MAVLink(None, 1, 1))))
    return hil.controls(frame)


def test_a_reading_of_the_fast_sensors_leaves_the_slow_ones_alone() -> None:
    m = read(hil.sensor(4000, accel_body=(0.1, 0.2, -9.8), rates_body=(1.0, 2.0, 3.0), slow=None))
    assert (m.time_usec, m.id, m.fields_updated) == (4000, 0, 0b111111)
    assert (m.xacc, m.yacc, m.zacc) == pytest.approx((0.1, 0.2, -9.8))
    assert (m.xgyro, m.ygyro, m.zgyro) == (1.0, 2.0, 3.0)


def test_field_and_pressure_are_told_in_gauss_and_hectopascals() -> None:
    slow = ((2.1e-5, 1e-6, 4.3e-5), 95_461.0, 500.0, 11.75)
    m = read(hil.sensor(8000, accel_body=(0, 0, 0), rates_body=(0, 0, 0), slow=slow))
    assert (m.xmag, m.ymag, m.zmag) == pytest.approx((0.21, 0.01, 0.43))
    assert (m.abs_pressure, m.pressure_alt, m.temperature) == pytest.approx((954.61, 500.0, 11.75))
    # HIL_SENSOR_UPDATED_FLAGS: all but the air speed's pressure
    assert m.fields_updated == 0b1_1111_1111_1111 & ~common.HIL_SENSOR_UPDATED_DIFF_PRESSURE


def gnss(
    time_us: int = 0, v_ned: tuple[float, float, float] = (0.0, 0.0, 0.0), *, satellites: int = 12, **how: Any
) -> Any:
    where = {"lat_deg": 47.3977421, "lon_deg": -8.5455941, "alt_m": 488.125}
    return read(hil.gnss(time_us, **where, v_ned=v_ned, eph_m=0.3, epv_m=0.4, satellites=satellites, **how))


def test_a_fix_of_gnss_is_in_its_units() -> None:
    m = gnss(1_770_000_000_000_000, (3.0, -4.0, 400.0))
    assert (m.time_usec, m.lat, m.lon, m.alt) == (1_770_000_000_000_000, 473977421, -85455941, 488125)
    assert (m.vn, m.ve, m.vd, m.vel) == (300, -400, 32767, round(100 * math.hypot(3, 4, 400)))
    assert m.cog == round(100 * (360.0 - math.degrees(math.atan2(4.0, 3.0))))
    assert (m.fix_type, m.eph, m.epv, m.satellites_visible, m.id) == (3, 30, 40, 12, 0)
    lost = gnss(satellites=0, fix=False)
    assert (lost.fix_type, lost.satellites_visible) == (common.GPS_FIX_TYPE_NO_FIX, 0)


@pytest.mark.parametrize("east", [0.0, -1e-9])
def test_a_course_to_the_north_is_none_of_36000(east: float) -> None:
    assert gnss(v_ned=(1.0, east, 0.0)).cog == 0


def test_what_is_true_is_told_for_the_log() -> None:
    turned = (math.cos(0.5), 0.0, 0.0, math.sin(0.5))
    where = {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 490.0}
    said = hil.truth(
        12000,
        quaternion=turned,
        rates_body=(0.1, 0.2, 0.3),
        **where,
        v_ned=(1.0, 2.0, -2.0),
        accel_body=(0, 0, -9.80665),
    )
    m = read(said)
    assert m.attitude_quaternion == pytest.approx(turned)
    assert (m.lat, m.lon, m.alt) == (470000000, 80000000, 490000)
    assert (m.vx, m.vy, m.vz, m.true_airspeed, m.zacc) == (100, 200, -200, 300, -1000)
    assert (m.rollspeed, m.pitchspeed, m.yawspeed) == pytest.approx((0.1, 0.2, 0.3))


def test_motor_controls_are_shares_of_the_greatest_speed_of_four() -> None:
    wanted = controls(16000, [0.25, 0.5, 1.5, -1.0, 0.7, *[0.0] * 11], 1)
    assert wanted == hil.MotorControls(16000, True, (0.25, 0.5, 1.0, 0.0))
    odd = controls(16000, [math.nan, math.inf, 0.5, 0.0, *[0.0] * 12], 0)
    assert odd == hil.MotorControls(16000, False, (0.0, 0.0, 0.5, 0.0))
    (frame,) = split(bytes(common.MAVLink_heartbeat_message(2, 12, 0, 0, 0, 3).pack(common.MAVLink(None, 1, 1))))
    assert hil.controls(frame) is None
