"""What telemetry says of a vehicle whose state is known, in MAVLink's own units."""

import math
from typing import Any

import pymap3d
import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.failures import Failure
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law import rows
from simvehicle.law.plants import RotorPlant
from simvehicle.mavlink.codec import encode
from simvehicle.mavlink.telemetry import TELEMETRY, autopilot_version, message_of
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import WorldVehicle

ORIGIN = (47.397742, 8.545594, 488.0)


def flying(vehicle_bench: Any, params: dict[str, float] | None = None, **state: Any) -> Vehicle:
    """A vehicle in flight, with other numbers in its plant's row, nwu."""
    start = Start((30.0, -40.0, -12.0), (1.5, -2.0, 0.5), (0.1, -0.2, 0.3), airborne=True)
    vehicle: Vehicle = vehicle_bench(params=params, start=start).vehicle
    for name, numbers in state.items():
        vehicle.plant.state[0, rows.STATE[name]] = numbers
    return vehicle


def told(vehicle: Vehicle, key: str) -> Any:
    (read,) = mav.MAVLink(None).parse_buffer(encode(message_of(vehicle, key), seq=0, sysid=1, compid=1))
    return read


def test_local_state_is_ned_in_si(vehicle_bench: Any) -> None:
    s = flying(vehicle_bench)
    local, attitude = told(s, "LOCAL_POSITION_NED"), told(s, "ATTITUDE")
    assert (local.x, local.y, local.z) == pytest.approx((30.0, -40.0, -12.0))
    assert (local.vx, local.vy, local.vz) == pytest.approx((1.5, -2.0, 0.5))
    assert (attitude.roll, attitude.pitch, attitude.yaw) == pytest.approx((0.1, -0.2, 0.3))


@pytest.mark.parametrize("p_ned", [(30.0, -40.0, -12.0), (-80.0, 55.0, 0.0)])
def test_global_position_agrees_with_the_ellipsoid(vehicle_bench: Any, p_ned: tuple[float, float, float]) -> None:
    north, east, down = p_ned
    s = flying(vehicle_bench, position=(north, -east, -down))
    m = told(s, "GLOBAL_POSITION_INT")
    lat, lon, alt = pymap3d.ned2geodetic(*p_ned, *ORIGIN)
    assert 1e-7 * m.lat == pytest.approx(lat, abs=7e-8)  # 0.5 of rounding, and 1 mm at 100 m
    assert 1e-7 * m.lon == pytest.approx(lon, abs=7e-8)
    assert 1e-3 * m.alt == pytest.approx(alt, abs=2e-3)
    assert (m.vx, m.vy, m.vz) == (150, -200, 50)
    assert m.relative_alt == round(1e3 * (-12.0 - p_ned[2]))  # home is the start, 12 m up
    assert m.hdg == round(math.degrees(0.3) * 100)
    gps = told(s, "GPS_RAW_INT")
    assert (gps.lat, gps.lon, gps.alt) == (m.lat, m.lon, m.alt)
    assert gps.vel == 250
    assert gps.cog == round(100 * (math.degrees(math.atan2(-2.0, 1.5)) % 360.0))
    assert gps.fix_type == mav.GPS_FIX_TYPE_3D_FIX
    assert (gps.h_acc, gps.v_acc, gps.vel_acc) == (1, 1, 1)  # it knows its place exactly, and 0 would be unknown


def test_without_a_fix_nothing_of_a_place_is_said(vehicle_bench: Any) -> None:
    """What PX4's GPS_RAW_INT.hpp sends without a GPS and ArduPilot's AP_GPS once it times out, and MAVLink's words for
    what is not known: UINT16_MAX, and 0 in extensions."""
    s = flying(vehicle_bench)
    s.failed.add(Failure.GPS)
    gps = told(s, "GPS_RAW_INT")
    assert gps.fix_type == mav.GPS_FIX_TYPE_NO_FIX
    assert (gps.lat, gps.lon, gps.alt, gps.alt_ellipsoid, gps.satellites_visible) == (0, 0, 0, 0, 0)
    assert (gps.eph, gps.epv, gps.vel, gps.cog) == (65535, 65535, 65535, 65535)
    assert (gps.h_acc, gps.v_acc, gps.vel_acc) == (0, 0, 0)


def test_a_gps_that_jumps_is_sure_of_its_place(vehicle_bench: Any) -> None:
    s = flying(vehicle_bench)
    before = told(s, "GPS_RAW_INT")
    s.position_error_ned = (40.0, 0.0, 0.0)
    gps = told(s, "GPS_RAW_INT")
    assert gps.lat - before.lat == pytest.approx(3600, abs=40)  # 40 m
    assert (gps.fix_type, gps.eph, gps.h_acc) == (before.fix_type, before.eph, before.h_acc)


def test_origin_home_and_follow_target_stand_in_one_frame(vehicle_bench: Any) -> None:
    s = flying(vehicle_bench)
    origin, home, follow = told(s, "GPS_GLOBAL_ORIGIN"), told(s, "HOME_POSITION"), told(s, "FOLLOW_TARGET")
    assert (origin.latitude, origin.longitude, origin.altitude) == (473977420, 85455940, 488000)
    back = LocalFrame(*ORIGIN).to_local(1e-7 * home.latitude, 1e-7 * home.longitude, 1e-3 * home.altitude)
    assert back == pytest.approx((30.0, -40.0, -12.0), abs=0.01)
    back = LocalFrame(*ORIGIN).to_local(1e-7 * follow.lat, 1e-7 * follow.lon, follow.alt)
    assert back == pytest.approx((30.0, -40.0, -12.0), abs=0.01)
    assert tuple(follow.vel) == pytest.approx((1.5, -2.0, 0.5))


def test_battery_is_told_in_hectojoules_and_percent(vehicle_bench: Any) -> None:
    s = flying(vehicle_bench, {"SIM_BAT_CAP_J": 20_000.0}, drawn_j=12_399.0, remaining_j=11_000.0)
    s.power_w = 210.0
    battery, status = told(s, "BATTERY_STATUS"), told(s, "SYS_STATUS")
    assert battery.energy_consumed == 123
    assert battery.battery_remaining == status.battery_remaining == 55
    assert battery.time_remaining == round(11_000.0 / 210.0)
    cells = [mv for mv in battery.voltages if mv != 65535]
    assert len(cells) == 4
    assert sum(cells) == pytest.approx(status.voltage_battery, abs=4)
    power_w = battery.current_battery / 100 * status.voltage_battery / 1000
    assert power_w == pytest.approx(210.0, rel=0.01)


def throttles(bench: Any, seconds: float) -> list[int]:
    """VFR_HUD's in some seconds, at 10 Hz."""
    bench.connection.streams.set_rate("VFR_HUD", 10.0, bench.vehicle.time_ms)
    before = len(bench.of("VFR_HUD"))
    bench.fly(seconds)
    return [m.throttle for m in bench.of("VFR_HUD")[before:]]


@pytest.mark.parametrize("autopilot", ["px4", "ardupilot"])
def test_throttle_is_the_share_of_the_greatest_thrust(vehicle_bench: Any, autopilot: str) -> None:
    """PX4's VFR_HUD.hpp and ArduCopter's vfr_hud_throttle send the thrust, in percent of what there is; it hovers with
    its weight, of which it has 2.5."""
    bench = vehicle_bench(autopilot=autopilot, params={"MPC_THR_MAX_G": 2.5})
    assert set(throttles(bench, 1.0)) == {0}
    bench.in_air() if autopilot == "px4" else bench.in_air_guided()
    assert set(throttles(bench, 1.0)) == {40}
    assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1, 1, 0, math.nan, math.nan, math.nan, 508.0) == 0
    assert 45 < max(throttles(bench, 2.0)) <= 100  # it climbs
    assert bench.result(mav.MAV_CMD_NAV_LAND) == 0
    bench.fly(60.0, until=lambda b: not b.vehicle.armed)
    assert set(throttles(bench, 1.0)) == {0}


def test_throttle_of_rotors_is_of_all_at_their_fastest(vehicle_bench: Any) -> None:
    airframe = AIRFRAMES["iris"]
    bench = vehicle_bench(plant=RotorPlant(WorldVehicle(airframe))).in_air()
    newtons = 4.0 * airframe.thrust_n_s2 * airframe.fastest_rad_s**2
    hover = round(100.0 * airframe.mass_kg * 9.80665 / newtons)
    assert all(abs(throttle - hover) <= 1 for throttle in throttles(bench, 1.0))
    bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, 0.0, 21196.0)
    assert throttles(bench, 0.2)[-1] == 0  # at once, while the rotors run down


def test_throttle_without_a_limit_is_that_of_the_parameter(vehicle_bench: Any) -> None:
    """The paper's set of gains limits no thrust; MPC_THR_MAX_G is 2 weights."""
    bench = vehicle_bench(params={"SIM_GAIN_SET": 1.0}, start=Start((0.0, 0.0, -8.0), airborne=True))
    bench.fly(0.5, p_ned=(0.0, 0.0, -8.0))
    assert throttles(bench, 0.3)[-1] == 50


def test_landed_state_follows_the_flight(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.fly(1.5)
    bench.in_air()
    bench.result(mav.MAV_CMD_NAV_LAND)
    bench.fly(15.0, until=lambda b: not b.vehicle.armed)
    bench.fly(1.0)
    states = [m.landed_state for m in bench.of("EXTENDED_SYS_STATE")]
    changes = [state for state, before in zip(states, [None, *states], strict=False) if state != before]
    assert changes == [
        mav.MAV_LANDED_STATE_ON_GROUND, mav.MAV_LANDED_STATE_TAKEOFF, mav.MAV_LANDED_STATE_IN_AIR,
        mav.MAV_LANDED_STATE_LANDING, mav.MAV_LANDED_STATE_ON_GROUND,
    ]  # fmt: skip


def state(bench: Any) -> int:
    return int(bench.of("HEARTBEAT")[-1].system_status)


@pytest.mark.parametrize(
    ("autopilot", "charge"),
    [("px4", mav.MAV_BATTERY_CHARGE_STATE_EMERGENCY), ("ardupilot", mav.MAV_BATTERY_CHARGE_STATE_CRITICAL)],
)
def test_state_of_a_vehicle_that_a_battery_takes_down_is_critical(
    vehicle_bench: Any, autopilot: str, charge: int
) -> None:
    bench = vehicle_bench(autopilot=autopilot, params={"SIM_BAT_CAP_J": 24_000.0, "BAT_EMERGEN_THR": 0.05})
    bench.in_air() if autopilot == "px4" else bench.in_air_guided()
    assert (state(bench), bench.of("BATTERY_STATUS")[-1].charge_state) == (mav.MAV_STATE_ACTIVE, 1)
    bench.vehicle.plant.waste(22_500.0)
    bench.fly(1.5)
    assert bench.vehicle.mode == "land"
    assert (state(bench), bench.of("BATTERY_STATUS")[-1].charge_state) == (mav.MAV_STATE_CRITICAL, charge)
    bench.fly(15.0, until=lambda b: not b.vehicle.armed)
    bench.fly(1.1)
    assert (state(bench), bench.of("BATTERY_STATUS")[-1].charge_state) == (mav.MAV_STATE_STANDBY, charge)


def test_state_is_critical_from_a_lost_station_to_the_next_order(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"RTL_RETURN_ALT": 3.0}).in_air()
    bench.vehicle.reposition((9.0, 0.0, -2.5))
    bench.fly(6.0)
    bench.fly(6.5, gcs=False)
    assert (bench.vehicle.mode, state(bench)) == ("return", mav.MAV_STATE_CRITICAL)
    bench.gcs_heartbeat()
    bench.fly(1.0)
    assert state(bench) == mav.MAV_STATE_CRITICAL
    bench.result(mav.MAV_CMD_NAV_LOITER_UNLIM)
    bench.tick()
    assert (bench.vehicle.mode, state(bench)) == ("hold", mav.MAV_STATE_ACTIVE)


@pytest.mark.parametrize(("autopilot", "after"), [("px4", mav.MAV_STATE_CRITICAL), ("ardupilot", mav.MAV_STATE_ACTIVE)])
def test_lost_set_points_are_a_failsafe_of_a_px4_alone(vehicle_bench: Any, autopilot: str, after: int) -> None:
    """GUIDED times out and holds: no part of ArduCopter's any_failsafe_triggered."""
    bench = vehicle_bench(autopilot=autopilot)
    bench.offboard() if autopilot == "px4" else bench.in_air_guided()
    bench.fly(1.0, p_ned=(3.0, 0.0, -2.5), v_ned=(0.1, 0.0, 0.0))
    bench.fly(2.5)
    assert bench.vehicle.mode in ("hold", "guided")
    assert state(bench) == after


def test_position_target_is_what_is_really_flown(vehicle_bench: Any) -> None:
    bench = vehicle_bench(start=Start((0.0, 0.0, -5.0), airborne=True))
    bench.fly(1.0, p_ned=(40.0, 0.0, -5.0))
    m, at = bench.of("POSITION_TARGET_LOCAL_NED")[-1], bench.of("LOCAL_POSITION_NED")[-1]
    assert 0.0 < m.x < 10.0  # on its way, not the set point itself
    assert abs(m.x - at.x) < 1.0
    bench.fly(15.0, p_ned=(40.0, 0.0, -5.0))
    m = bench.of("POSITION_TARGET_LOCAL_NED")[-1]
    assert (m.x, m.y, m.z, m.vx) == pytest.approx((40.0, 0.0, -5.0, 0.0), abs=0.05)


@pytest.mark.parametrize(
    "wild",
    [
        {"position": (1e9, -1e9, 1e9), "velocity": (1e7, -1e7, 1e7)},
        {"position": (-1e12, 1e12, -1e12), "velocity": (-1e7, 1e7, -1e7)},
        {"power_w": 1e9, "drawn_j": 1e13},
        {"power_w": 1e-12, "remaining_j": 1e9},
        {"given_j": 2**40, "received_j": 2**40},
        {"remaining_j": 2e13},
        {"attitude": (100.0, -100.0, 1e6)},
    ],
)
def test_no_state_is_too_great_for_its_telemetry(vehicle_bench: Any, wild: dict[str, Any]) -> None:
    s = flying(vehicle_bench, **{name: numbers for name, numbers in wild.items() if name in rows.STATE})
    s.power_w = wild.get("power_w", 210.0)
    s.exchange.given_j, s.exchange.received_j = wild.get("given_j", 0), wild.get("received_j", 0)
    for stream in TELEMETRY:
        told(s, stream.key)


@pytest.mark.parametrize(
    ("autopilot", "number"), [("px4", (1, 15, 0)), ("generic", (1, 15, 0)), ("ardupilot", (4, 6, 2))]
)
def test_version_is_one_of_the_autopilots_and_of_no_release(
    vehicle_bench: Any, autopilot: str, number: tuple[int, int, int]
) -> None:
    told = autopilot_version(vehicle_bench(autopilot=autopilot).vehicle, 9)
    version = told.flight_sw_version
    assert (version >> 24, version >> 16 & 255, version >> 8 & 255) == number
    assert version & 255 != mav.FIRMWARE_VERSION_TYPE_OFFICIAL
    assert told.capabilities == IDENTITIES[autopilot].capabilities
