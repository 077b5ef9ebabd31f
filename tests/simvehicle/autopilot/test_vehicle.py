"""One vehicle flown over its services: modes, failsafes, set points, time."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.mavlink.telemetry import message_of

ACCEPTED, TEMPORARILY_REJECTED = 0, 1
VELOCITY_ONLY, POSITION_ONLY, POSITION_AND_YAW, BOTH = 3527, 3576, 2552, 3520
MIXED = VELOCITY_ONLY - 7 + 1 + 4 + 8
BODY, BODY_OFFSET = mav.MAV_FRAME_BODY_NED, mav.MAV_FRAME_BODY_OFFSET_NED
AIRBORNE = Start(p_ned=(0.0, 0.0, -5.0), airborne=True)
WILD = [math.nan, math.inf, -math.inf, 3.4e38, -3.4e38, 1e12, 0.0]


def set_mode(bench: Any, main: int, sub: int = 0) -> int:
    return int(bench.result(mav.MAV_CMD_DO_SET_MODE, 129.0, main, sub))


def test_whole_flight_from_the_ground_and_back(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.fly(1.0)
    assert bench.vehicle.landed
    assert bench.arm() == ACCEPTED
    assert bench.result(mav.MAV_CMD_NAV_TAKEOFF, *[math.nan] * 7) == ACCEPTED
    bench.fly(10.0, until=lambda b: b.vehicle.mode == "hold")
    bench.fly(3.0)
    assert bench.vehicle.p_ned == pytest.approx((0.0, 0.0, -2.5), abs=0.05)
    bench.set_point((4.0, -3.0, -4.0))
    assert set_mode(bench, 6) == ACCEPTED
    bench.fly(8.0, p_ned=(4.0, -3.0, -4.0))
    assert bench.vehicle.p_ned == pytest.approx((4.0, -3.0, -4.0), abs=0.05)
    assert bench.result(mav.MAV_CMD_NAV_RETURN_TO_LAUNCH) == ACCEPTED
    bench.fly(30.0, until=lambda b: not b.vehicle.armed)
    assert bench.vehicle.landed
    assert math.hypot(*bench.vehicle.p_ned[:2]) < 0.3
    assert bench.texts == [
        "Armed", "Take-off", "Take-off done, hold", "Offboard", "Return to home", "Home reached, land",
        "Landed, disarmed",
    ]  # fmt: skip
    assert max(-m.z for m in bench.of("LOCAL_POSITION_NED")) == pytest.approx(5.0, abs=0.3)  # RTL_RETURN_ALT


def test_each_change_is_announced_once_and_by_a_heartbeat_in_the_same_period(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for act in (
        bench.arm,
        lambda: bench.result(mav.MAV_CMD_NAV_TAKEOFF, *[math.nan] * 7),
        lambda: set_mode(bench, 4, 3),
        lambda: bench.result(mav.MAV_CMD_NAV_LAND),
        lambda: bench.result(mav.MAV_CMD_NAV_RETURN_TO_LAUNCH),
    ):
        bench.tick(3)
        assert act() == ACCEPTED
        act()
        sent = [m.get_type() for m in bench.tick()]
        assert sent.count("STATUSTEXT") == 1
        assert sent.count("HEARTBEAT") == 1
        armed_mode = bench.of("HEARTBEAT")[-1]
        assert armed_mode.custom_mode == bench.vehicle.identity.spoken[bench.vehicle.mode]
        assert bool(armed_mode.base_mode & 0x80) == bench.vehicle.armed


def test_take_off_is_bumpless(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.fly(1.0)
    bench.arm()
    bench.vehicle.take_off(2.5)
    bench.fly(5.0)
    speeds = np.array([m.vz for m in bench.of("LOCAL_POSITION_NED")])
    assert np.abs(np.diff(speeds)).max() / 0.1 < 5.0  # m/s² between reports: never a jump
    assert -speeds.min() < 1.1 * 1.5  # MPC_TKO_SPEED
    tilt = max(math.hypot(m.roll, m.pitch) for m in bench.of("ATTITUDE"))
    assert tilt < math.radians(1.0)


def test_take_off_needs_arming_and_never_goes_down(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    assert bench.result(mav.MAV_CMD_NAV_TAKEOFF, *[math.nan] * 7) == TEMPORARILY_REJECTED
    bench.arm()
    bench.fly(5.0)
    assert bench.vehicle.landed
    assert bench.of("NAMED_VALUE_FLOAT")[-1].value == 0.0  # motors are off
    bench.in_air(6.0)
    assert bench.result(mav.MAV_CMD_NAV_TAKEOFF, *[math.nan] * 7) == ACCEPTED
    bench.fly(5.0)
    assert bench.vehicle.mode == "hold"
    assert bench.vehicle.p_ned[2] == pytest.approx(-6.0, abs=0.3)


def test_set_points_lost_means_hold_at_the_time_out(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"COM_OF_LOSS_T": 0.5}).offboard()
    bench.fly(0.5, p_ned=(math.nan, 0.0, 0.0))  # such as count for none
    assert bench.vehicle.mode == "offboard"
    bench.fly(0.2, p_ned=(math.nan, 0.0, 0.0))
    assert bench.vehicle.mode == "hold"
    assert "Failsafe: set points lost, hold" in bench.texts
    bench.fly(3.0)
    assert bench.vehicle.p_ned == pytest.approx((0.0, 0.0, -2.5), abs=0.1)


def test_hold_stops_a_fast_vehicle_where_it_can_and_stays(vehicle_bench: Any) -> None:
    bench = vehicle_bench().offboard()
    for _ in range(40):
        bench.set_point(v_ned=(4.0, 0.0, 0.0), mask=VELOCITY_ONLY)
        bench.gcs_heartbeat()
        bench.tick()
    assert bench.vehicle.v_ned[0] == pytest.approx(4.0, abs=0.1)
    at = bench.vehicle.p_ned[0]
    assert set_mode(bench, 4, 3) == ACCEPTED
    bench.fly(6.0)
    assert math.hypot(*bench.vehicle.v_ned) < 0.02
    # From 4 m/s, at 5 m/s² that the guidance allows at most, no less than v²/2a; nor a turn back of any size.
    assert 16.0 / 10.0 < bench.vehicle.p_ned[0] - at < 8.0
    assert max(m.x for m in bench.of("LOCAL_POSITION_NED")) < bench.vehicle.p_ned[0] + 0.5


def test_ground_station_lost_means_return_and_land_whatever_other_vehicles_say(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"COM_DL_LOSS_T": 2.0}).offboard((5.0, 0.0, -2.5))
    bench.fly(4.0, p_ned=(5.0, 0.0, -2.5))
    for mode, periods in (("offboard", 20), ("return", 3)):
        for _ in range(periods):
            bench.send(mav.MAVLink_heartbeat_message(mav.MAV_TYPE_QUADROTOR, 12, 0, 0, 4, 3), (2, 1))
            bench.fly(0.1, gcs=False, p_ned=(5.0, 0.0, -2.5))
        assert bench.vehicle.mode == mode
    bench.fly(40.0, gcs=False, until=lambda b: not b.vehicle.armed)
    assert bench.vehicle.landed
    assert math.hypot(*bench.vehicle.p_ned[:2]) < 0.3
    assert bench.texts[-3:] == [
        "Failsafe: ground station lost, return", "Home reached, land", "Landed, disarmed"
    ]  # fmt: skip


def test_vehicle_that_never_heard_a_ground_station_does_not_miss_it(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"COM_DL_LOSS_T": 1.0})
    bench.arm()
    bench.vehicle.take_off(2.0)
    bench.fly(8.0, gcs=False)
    assert bench.vehicle.mode == "hold"


def test_empty_battery_lands_before_anything_else_and_stays_landed(vehicle_bench: Any) -> None:
    share = {"SIM_BAT_CAP_J": 4000.0, "BAT_EMERGEN_THR": 0.3, "COM_DL_LOSS_T": 1.0}
    bench = vehicle_bench(params=share).in_air()
    bench.fly(20.0, until=lambda b: b.vehicle.remaining_j < 0.31 * 4000.0)
    bench.fly(30.0, gcs=False, until=lambda b: not b.vehicle.armed)
    assert "Failsafe: battery empty, land" in bench.texts
    severities = {m.text: m.severity for m in bench.of("STATUSTEXT")}
    assert severities["Failsafe: battery empty, land"] == mav.MAV_SEVERITY_CRITICAL
    assert bench.texts[-1] == "Landed, disarmed"
    assert bench.vehicle.remaining_j > 0.0
    assert bench.arm() == TEMPORARILY_REJECTED


@pytest.mark.parametrize("worse", ["battery", "gcs"])
def test_several_failsafes_at_once_are_decided_by_the_worst(vehicle_bench: Any, worse: str) -> None:
    bench = vehicle_bench(params={"COM_DL_LOSS_T": 1.0, "COM_OF_LOSS_T": 1.0}).offboard((5.0, 0.0, -2.5))
    bench.fly(4.0, p_ned=(5.0, 0.0, -2.5))
    if worse == "battery":
        bench.vehicle.parameters.set("BAT_EMERGEN_THR", 1.0)
        bench.vehicle.retune()
    bench.vehicle.advance(bench.vehicle.time_ms + 1300)
    assert bench.vehicle.mode == {"battery": "land", "gcs": "return"}[worse]


def test_failsafe_on_the_ground_disarms(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"COM_DL_LOSS_T": 1.0})
    bench.gcs_heartbeat()
    bench.arm()
    bench.fly(1.5, gcs=False)
    assert not bench.vehicle.armed
    assert bench.vehicle.mode == "hold"
    assert bench.texts == ["Armed", "Failsafe on the ground, disarmed"]


def test_empty_battery_refuses_arming_unless_forced(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"SIM_BAT_INIT_J": 100.0})
    assert bench.arm() == TEMPORARILY_REJECTED
    bench.tick()
    assert bench.texts == ["Arming refused: battery below BAT_EMERGEN_THR"]
    health = [m.onboard_control_sensors_health for m in bench.of("SYS_STATUS")]
    assert not any(h & mav.MAV_SYS_STATUS_PREARM_CHECK for h in health)
    assert bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, 21196.0) == ACCEPTED


def test_disarming_in_the_air_is_refused_unless_forced(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    assert bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, 0.0) == TEMPORARILY_REJECTED
    bench.tick()
    assert bench.vehicle.armed
    assert bench.texts[-1] == "Disarming refused: in the air"
    assert bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, 0.0, 21196.0) == ACCEPTED
    assert not bench.vehicle.armed
    bench.fly(3.0)
    assert bench.vehicle.landed


def test_return_flies_home_from_where_the_vehicle_was_set_down(vehicle_bench: Any) -> None:
    bench = vehicle_bench().offboard()
    bench.fly(12.0, p_ned=(6.0, 0.0, 1.0), until=lambda b: b.vehicle.landed)
    assert bench.result(mav.MAV_CMD_NAV_RETURN_TO_LAUNCH) == ACCEPTED
    bench.fly(40.0, until=lambda b: not b.vehicle.armed)
    assert math.hypot(*bench.vehicle.p_ned[:2]) < 0.3


def test_arming_on_the_ground_sets_home_there(vehicle_bench: Any) -> None:
    bench = vehicle_bench(start=Start(p_ned=(30.0, 40.0, 0.0)))
    bench.arm()
    bench.fly(2.1)
    home = bench.of("HOME_POSITION")[-1]
    assert (home.x, home.y, home.z) == (30.0, 40.0, 0.0)


@pytest.mark.parametrize("autopilot", ["px4", "ardupilot"])
def test_arming_leaves_a_home_that_was_commanded_and_a_reboot_forgets_it(vehicle_bench: Any, autopilot: str) -> None:
    bench = vehicle_bench(autopilot=autopilot, start=Start(p_ned=(30.0, 40.0, 0.0)))
    lat, lon, alt = bench.vehicle.frame.to_global(7.0, -3.0, 0.0)
    place = (round(1e7 * lat), round(1e7 * lon), alt)
    assert bench.result(mav.MAV_CMD_DO_SET_HOME, 0.0, place=place, frame=mav.MAV_FRAME_GLOBAL_INT) == ACCEPTED
    for rebooted in (False, True):
        assert bench.arm() == ACCEPTED
        bench.fly(2.1)
        home = bench.of("HOME_POSITION")[-1]
        expected = (30.0, 40.0) if rebooted else (7.0, -3.0)
        assert (home.x, home.y) == pytest.approx(expected, abs=0.02)
        assert bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, 0.0) == ACCEPTED
        bench.command(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1.0)
        bench.fly(1.2)


@pytest.mark.parametrize(("autopilot", "stays"), [("px4", False), ("ardupilot", True)])
def test_arming_elsewhere_moves_home_that_was_set_to_where_a_px4_was(
    vehicle_bench: Any, autopilot: str, stays: bool
) -> None:
    bench = vehicle_bench(autopilot=autopilot)
    bench.in_air_guided() if stays else bench.in_air()
    assert bench.result(mav.MAV_CMD_DO_SET_HOME, 1.0) == ACCEPTED
    bench.vehicle.reposition((8.0, 0.0, -2.5))
    bench.fly(8.0)
    bench.result(mav.MAV_CMD_NAV_LAND)
    bench.fly(20.0, until=lambda b: not b.vehicle.armed)
    bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, *((4.0,) if stays else (4.0, 3.0)))
    assert bench.arm() == ACCEPTED
    assert bench.vehicle.home_ned[0] == pytest.approx(0.0 if stays else 8.0, abs=0.4)


@pytest.mark.parametrize(
    ("mask", "p_ned", "v_ned", "moves"),
    [
        (POSITION_ONLY, (3.0, 2.0, -4.0), (0.0, 0.0, 0.0), (3.0, 2.0, -4.0)),
        (BOTH, (3.0, 2.0, -4.0), (0.0, 0.0, 0.0), (3.0, 2.0, -4.0)),
        (BOTH | 512, (3.0, 2.0, -4.0), (0.0, 0.0, 0.0), (3.0, 2.0, -4.0)),
        (VELOCITY_ONLY, (0.0, 0.0, 0.0), (0.5, 0.0, 0.0), None),
        (POSITION_ONLY & ~0b100000 | 0b100, (3.0, 2.0, 0.0), (0.0, 0.0, -0.25), None),
    ],
    ids=["position", "position and velocity", "the same, force ignored", "velocity", "position level, velocity up"],
)
def test_mask_says_which_axes_are_flown_by_position(
    vehicle_bench: Any, mask: int, p_ned: Any, v_ned: Any, moves: Any
) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    before = bench.vehicle.p_ned
    bench.fly(8.0, p_ned=p_ned, v_ned=v_ned, mask=mask)
    if moves is not None:
        assert bench.vehicle.p_ned == pytest.approx(moves, abs=0.1)
        return
    assert bench.vehicle.v_ned == pytest.approx(v_ned, abs=0.02)
    for axis in range(3):
        if not mask & 1 << axis:
            assert bench.vehicle.p_ned[axis] == pytest.approx(p_ned[axis], abs=0.1)
        else:
            assert bench.vehicle.p_ned[axis] == pytest.approx(before[axis] + 8.0 * v_ned[axis], abs=1.0)


@pytest.mark.parametrize(
    ("bad", "said"),
    [
        ({"mask": 0xFFFF}, "Set point ignored: type_mask 65535"),
        ({"mask": 3072}, "Set point ignored: type_mask 3072"),  # with acceleration
        ({"mask": 448}, "Set point ignored: type_mask 448"),  # with both yaw and yaw rate
        ({"mask": POSITION_ONLY | 1}, f"Set point ignored: type_mask {POSITION_ONLY | 1}"),
        ({"frame": mav.MAV_FRAME_LOCAL_ENU}, "Set point ignored: frame 4"),
        ({"p_ned": (math.nan, 0.0, 0.0)}, "Set point ignored: not a number"),
        ({"v_ned": (0.0, math.inf, 0.0)}, "Set point ignored: not a number"),
        ({"yaw": math.nan, "mask": POSITION_AND_YAW}, "Set point ignored: not a number"),
        ({"frame": BODY, "mask": MIXED}, f"Set point ignored: type_mask {MIXED}"),  # north by place, right by velocity
        ({"frame": BODY, "mask": 1479, "yaw_rate": math.nan}, "Set point ignored: not a number"),
        ({"frame": BODY_OFFSET, "mask": POSITION_ONLY, "p_ned": (math.inf, 0, 0)}, "Set point ignored: not a number"),
    ],
)
def test_bad_set_point_is_ignored_and_said_every_5_seconds_at_most(vehicle_bench: Any, bad: Any, said: str) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    bench.fly(2.0, p_ned=(0.0, 0.0, -5.0))
    for _ in range(98):
        bench.set_point(**{"p_ned": (500.0, 0.0, -5.0)} | bad)
        bench.set_point(**{"p_ned": (0.0, 0.0, -5.0)})
        bench.gcs_heartbeat()
        bench.tick()
    assert bench.vehicle.mode == "offboard"
    assert bench.vehicle.p_ned == pytest.approx((0.0, 0.0, -5.0), abs=0.01)
    assert bench.texts == [said, said]


def test_masks_that_differ_are_complained_of_together(vehicle_bench: Any) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    for mask in range(200):
        bench.set_point(mask=mask)
    bench.tick()
    assert bench.texts == ["Set point ignored: type_mask 0"]


@settings(max_examples=60)
@given(
    st.lists(
        st.tuples(
            st.lists(st.one_of(st.sampled_from(WILD), st.floats(width=32)), min_size=7, max_size=7),
            st.sampled_from([BOTH, POSITION_ONLY, POSITION_AND_YAW, VELOCITY_ONLY, 2496, 3547, 0, 65535]),
        ),
        min_size=1,
        max_size=6,
    )
)
def test_no_set_point_gives_a_state_that_is_no_number(
    vehicle_bench: Any, points: list[tuple[list[float], int]]
) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    for numbers, mask in points:
        bench.send(
            mav.MAVLink_set_position_target_local_ned_message(0, 1, 1, 1, mask, *numbers[:6], 0, 0, 0, numbers[6], 0)
        )
        bench.tick(2)
    assert np.isfinite(bench.vehicle.state).all()
    assert bench.vehicle.mode in ("offboard", "hold")
    assert math.hypot(*bench.vehicle.v_ned) < 20.0
    assert abs(bench.ledger_gap_j()) < 1e-6


@pytest.mark.parametrize("kind", ["airborne", "take-off", "landing", "battery"])
def test_jump_of_several_periods_equals_single_ones_bit_for_bit(vehicle_bench: Any, kind: str) -> None:
    ends = []
    for jump in (1, 10):
        params = {"SIM_BAT_CAP_J": 3000.0, "BAT_EMERGEN_THR": 0.9} if kind == "battery" else None
        bench = vehicle_bench(params=params, start=AIRBORNE if kind == "airborne" else None)
        if kind != "airborne":
            bench.arm()
            bench.vehicle.take_off(1.0)
        if kind == "landing":
            bench.fly(4.0, gcs=False)
            bench.result(mav.MAV_CMD_NAV_LAND)
        start_ms, thrust = bench.vehicle.time_ms, []
        for k in range(40 // jump):
            bench.vehicle.advance(start_ms + (k + 1) * jump * 100)
            thrust.append(bench.vehicle.thrust_m_s2)
        ends.append((bench.vehicle.state.tobytes(), np.concatenate(thrust, axis=1).tobytes(), bench.vehicle.mode))
    assert ends[0] == ends[1]


def test_airborne_start_flies_its_own_state_until_the_first_set_point(vehicle_bench: Any) -> None:
    bench = vehicle_bench(start=Start((1.0, 2.0, -3.0), (1.0, 0.0, 0.0), airborne=True))
    assert bench.vehicle.armed
    assert bench.vehicle.mode == "offboard"
    bench.tick(9)
    assert bench.vehicle.mode == "offboard"
    assert bench.vehicle.p_ned == pytest.approx((1.9, 2.0, -3.0), abs=0.35)
    assert not bench.vehicle.landed


def test_first_grant_sets_the_clock_without_a_step(vehicle_bench: Any) -> None:
    vehicle = vehicle_bench(start=AIRBORNE).vehicle
    before = vehicle.state.tobytes()
    vehicle.set_clock(60_000, 1_700_000_060_000_000)
    assert vehicle.state.tobytes() == before
    assert message_of(vehicle, "GPS_RAW_INT").time_usec == 1_700_000_060_000_000
    assert vehicle.setpoints_fresh()
    vehicle.advance(60_100)
    assert vehicle.mode == "offboard"
    assert message_of(vehicle, "GPS_RAW_INT").time_usec == 1_700_000_060_100_000
