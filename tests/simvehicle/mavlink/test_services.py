"""The smaller services: ping, time, files, streams, failures, following, GUIDED, reboot and the connect sequences."""

import json
import math
import os
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.mavlink.connection import Connection
from simvehicle.sitl.storage import StateError, StateFile

ACCEPTED, TEMPORARILY_REJECTED, DENIED, UNSUPPORTED, IN_PROGRESS = 0, 1, 2, 3, 5
GPS, BATTERY, MOTOR, LINK = 4, 100, 101, 105
OK, OFF, STUCK = 0, 1, 2
NAN = math.nan


def test_ping_to_everybody_is_echoed_to_its_sender_and_an_echo_is_not(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    (echo,) = bench.send(mav.MAVLink_ping_message(123_456, 9, 0, 0), source=(42, 7))
    assert (echo.get_type(), echo.time_usec, echo.seq) == ("PING", 123_456, 9)
    assert (echo.target_system, echo.target_component) == (42, 7)
    assert bench.send(mav.MAVLink_ping_message(123_456, 9, 1, 1)) == []


def test_time_is_synchronised_in_nanoseconds_and_an_answer_is_not_answered(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.vehicle.set_clock(2_000, 1_700_000_000_000_000)
    bench.tick()
    (reply,) = bench.send(mav.MAVLink_timesync_message(0, 777))
    assert (reply.get_type(), reply.tc1, reply.ts1) == ("TIMESYNC", 1_700_000_000_100_000_000, 777)
    assert bench.send(mav.MAVLink_timesync_message(5, 777)) == []


def test_data_streams_set_the_rates_of_their_group_and_stop_it(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.send(mav.MAVLink_request_data_stream_message(1, 0, mav.MAV_DATA_STREAM_ALL, 4, 1))
    bench.tick(2)
    bench.heard.clear()
    bench.tick(50)
    for kind in ("ATTITUDE", "VFR_HUD", "GLOBAL_POSITION_INT", "SYS_STATUS"):
        assert len(bench.of(kind)) == pytest.approx(20, abs=1), kind
    bench.send(mav.MAVLink_request_data_stream_message(1, 0, mav.MAV_DATA_STREAM_EXTRA1, 4, 0))
    bench.send(mav.MAVLink_request_data_stream_message(1, 0, 200, 4, 1))
    bench.heard.clear()
    bench.tick(50)
    assert bench.of("ATTITUDE") == []
    assert len(bench.of("HEARTBEAT")) == 5


def test_connect_sequence_of_a_ground_station_is_answered_completely(vehicle_bench: Any) -> None:
    """QGroundControl's, as its source gives it."""
    bench = vehicle_bench()
    (ack, version) = bench.command(mav.MAV_CMD_REQUEST_MESSAGE, float(mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION))
    assert (ack.result, version.get_type()) == (ACCEPTED, "AUTOPILOT_VERSION")
    for bit in ("MISSION_INT", "MISSION_FENCE", "MISSION_RALLY", "COMMAND_INT", "MAVLINK2", "FTP"):
        assert version.capabilities & getattr(mav, f"MAV_PROTOCOL_CAPABILITY_{bit}")
    for msgid, result in ((300, UNSUPPORTED), (397, ACCEPTED), (395, UNSUPPORTED)):
        assert bench.result(mav.MAV_CMD_REQUEST_MESSAGE, float(msgid)) == result
    assert bench.result(mav.MAV_CMD_REQUEST_PROTOCOL_VERSION, 1.0) == UNSUPPORTED
    values = {m.param_id: m for m in bench.send(mav.MAVLink_param_request_list_message(1, 1))}
    assert len(values) == next(iter(values.values())).param_count
    for name in ("SYS_AUTOSTART", "CAL_GYRO0_ID", "CAL_ACC0_ID", "CAL_MAG0_ID"):
        assert values[name].param_value != 0.0
    assert {"COM_RC_IN_MODE", "RC_MAP_ROLL", "RC_MAP_PITCH", "RC_MAP_YAW", "RC_MAP_THROTTLE"} <= set(values)
    for kind in (0, 1, 2):
        (count,) = bench.send(mav.MAVLink_mission_request_list_message(1, 1, kind))
        assert (count.get_type(), count.count, count.mission_type) == ("MISSION_COUNT", 0, kind)
    bench.tick(11)
    status = bench.of("SYS_STATUS")[-1]
    assert status.onboard_control_sensors_health & mav.MAV_SYS_STATUS_PREARM_CHECK


def inject(bench: Any, unit: int, kind: int) -> int:
    return int(bench.result(mav.MAV_CMD_INJECT_FAILURE, float(unit), float(kind), 0.0))


def test_failures_need_leave_and_only_known_ones_are_taken(vehicle_bench: Any) -> None:
    assert inject(vehicle_bench(), GPS, OFF) == DENIED
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1})
    assert inject(bench, 0, OFF) == UNSUPPORTED
    assert inject(bench, GPS, STUCK) == UNSUPPORTED
    assert [inject(bench, GPS, OFF) for _ in range(3)] == [ACCEPTED] * 3
    bench.tick()
    assert bench.texts == ["Injected: GPS failed"]


@pytest.mark.parametrize(("unit", "name"), [(GPS, "GPS"), (BATTERY, "battery"), (MOTOR, "motor")])
def test_what_has_failed_is_unhealthy_and_keeps_from_arming(vehicle_bench: Any, unit: int, name: str) -> None:
    bit = {
        GPS: mav.MAV_SYS_STATUS_SENSOR_GPS,
        BATTERY: mav.MAV_SYS_STATUS_SENSOR_BATTERY,
        MOTOR: mav.MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS,
    }[unit]
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1})
    inject(bench, unit, OFF)
    assert bench.arm() == TEMPORARILY_REJECTED
    bench.tick(11)
    assert f"Arming refused: {name} failed" in bench.texts
    health = bench.of("SYS_STATUS")[-1].onboard_control_sensors_health
    assert not health & (bit | mav.MAV_SYS_STATUS_PREARM_CHECK)
    inject(bench, unit, OK)
    assert bench.arm() == ACCEPTED


def test_lost_gps_lands_from_every_mode_and_tells_no_fix(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1}).in_air()
    inject(bench, GPS, OFF)
    bench.fly(0.2)
    assert bench.vehicle.mode == "land"
    assert bench.result(mav.MAV_CMD_NAV_LOITER_UNLIM) == ACCEPTED
    bench.fly(0.2)
    assert bench.vehicle.mode == "land"
    bench.fly(20.0, until=lambda b: not b.vehicle.armed)
    assert bench.of("GPS_RAW_INT")[-1].fix_type == mav.GPS_FIX_TYPE_NO_FIX


def test_failed_battery_lands_and_the_ledger_goes_on(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1}).in_air()
    inject(bench, BATTERY, OFF)
    bench.fly(20.0, until=lambda b: not b.vehicle.armed)
    bench.tick(11)
    assert bench.of("BATTERY_STATUS")[-1].battery_remaining == 0
    assert bench.ledger_gap_j() == pytest.approx(0.0, abs=1e-6)
    inject(bench, BATTERY, OK)
    bench.tick(11)
    assert bench.of("BATTERY_STATUS")[-1].battery_remaining > 90


def test_lost_motor_drops_a_vehicle_that_then_lies_disarmed(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1}).in_air(5.0)
    inject(bench, MOTOR, OFF)
    bench.fly(0.5)
    assert bench.vehicle.v_ned[2] == pytest.approx(9.8 * 0.5, rel=0.1)
    bench.fly(5.0, until=lambda b: not b.vehicle.armed)
    bench.tick()
    assert bench.texts[-1] == "Crashed, disarmed"
    assert bench.vehicle.landed


def test_lost_link_hears_and_says_nothing_and_the_vehicle_returns(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1}).in_air()
    bench.vehicle.reposition((10.0, 0.0, -2.5))
    bench.fly(5.0)
    assert inject(bench, LINK, OFF) == ACCEPTED
    bench.tick()
    bench.heard.clear()
    assert bench.command(mav.MAV_CMD_NAV_LAND) == []
    assert bench.send(mav.MAVLink_ping_message(1, 1, 0, 0)) == []
    bench.fly(10.0, until=lambda b: b.vehicle.mode == "return")
    assert bench.heard == []
    assert inject(bench, LINK, OK) == ACCEPTED
    bench.fly(1.0)
    assert bench.of("HEARTBEAT")


def test_a_mode_that_the_station_sets_after_a_silence_stays_though_its_heartbeat_is_still_on_its_way(
    vehicle_bench: Any,
) -> None:
    place = (3.0, 0.0, -2.5)
    bench = vehicle_bench().offboard(place)
    bench.fly(10.0, gcs=False, p_ned=place, until=lambda b: b.vehicle.mode == "return")
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 129.0, 6.0, 0.0) == ACCEPTED
    bench.fly(4.0, gcs=False, p_ned=place)
    assert bench.vehicle.mode == "offboard"
    bench.fly(10.0, gcs=False, p_ned=place, until=lambda b: b.vehicle.mode == "return")


def test_a_station_that_sends_commands_but_no_heartbeat_is_not_missed(vehicle_bench: Any) -> None:
    bench = vehicle_bench(start=Start((0.0, 0.0, -5.0), airborne=True))
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 129.0, 4.0, 3.0) == ACCEPTED
    bench.fly(10.0, gcs=False)
    assert bench.vehicle.mode == "hold"


def follow(bench: Any, seconds: float, *, north_m_s: float) -> None:
    """A target that walks north past the origin, reported at 5 Hz."""
    for tick in range(round(10 * seconds)):
        if tick % 2 == 0:
            north = north_m_s * tick / 10.0
            lat, lon, alt = bench.vehicle.frame.to_global(north, 0.0, 0.0)
            place = (round(1e7 * lat), round(1e7 * lon), alt)
            vel = (north_m_s, 0.0, 0.0)
            zero = (0.0,) * 3
            bench.send(mav.MAVLink_follow_target_message(0, 3, *place, vel, zero, (1.0, 0.0, 0.0, 0.0), zero, zero, 0))
        bench.gcs_heartbeat()
        bench.tick()


@pytest.mark.parametrize(("angle", "offset"), [(180.0, (-4.0, 0.0)), (90.0, (0.0, 4.0)), (0.0, (4.0, 0.0))])
def test_followed_target_has_the_vehicle_where_the_parameters_say(
    vehicle_bench: Any, angle: float, offset: tuple[float, float]
) -> None:
    bench = vehicle_bench(params={"FLW_TGT_DST": 4.0, "FLW_TGT_FA": angle, "FLW_TGT_HT": 5.0, "FLW_TGT_RS": 0.0})
    bench.arm()
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 4.0, 8.0) == TEMPORARILY_REJECTED  # on the ground
    bench.in_air()
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 4.0, 8.0) == ACCEPTED
    follow(bench, 20.0, north_m_s=1.0)
    target_north = 20.0
    assert bench.vehicle.p_ned == pytest.approx((target_north + offset[0], offset[1], -5.0), abs=0.3)
    assert bench.vehicle.v_ned == pytest.approx((1.0, 0.0, 0.0), abs=0.1)
    bench.fly(8.0)
    stopped = bench.vehicle.p_ned
    bench.fly(2.0)
    assert math.dist(stopped, bench.vehicle.p_ned) < 30.0
    assert bench.vehicle.mode == "follow"


def test_guided_holds_without_set_points_and_flies_them_when_they_come(vehicle_bench: Any) -> None:
    bench = vehicle_bench(autopilot="ardupilot").in_air_guided()
    held = bench.vehicle.p_ned
    bench.fly(3.0)
    assert math.dist(held, bench.vehicle.p_ned) < 0.05
    bench.fly(4.0, p_ned=(2.0, 1.0, -3.0))
    assert bench.vehicle.p_ned == pytest.approx((2.0, 1.0, -3.0), abs=0.1)
    bench.fly(3.0)
    assert (bench.vehicle.mode, bench.vehicle.armed) == ("guided", True)
    assert {m.custom_mode for m in bench.of("HEARTBEAT")[2:]} == {4}
    assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, 1.0, 0.0, 0.0, place=(0, 0, -2.0), frame=1) == ACCEPTED
    bench.fly(5.0)
    assert bench.vehicle.p_ned == pytest.approx((0.0, 0.0, -2.0), abs=0.1)
    assert bench.vehicle.mode == "guided"


def test_a_guided_vehicle_flies_to_a_place_that_is_given_alone_and_once(vehicle_bench: Any) -> None:
    """ArduCopter's pos_control_run has no time limit; its velaccel_control_run stops where no more comes."""
    bench = vehicle_bench(autopilot="ardupilot").in_air_guided()
    bench.set_point((20.0, 0.0, -3.0), mask=3576)
    bench.fly(15.0)
    assert bench.vehicle.p_ned == pytest.approx((20.0, 0.0, -3.0), abs=0.1)
    lat, lon, _ = bench.vehicle.frame.to_global(10.0, 5.0, 0.0)
    numbers = (round(1e7 * lat), round(1e7 * lon), 5.0, *[NAN] * 8)
    bench.send(mav.MAVLink_set_position_target_global_int_message(0, 1, 1, 6, 3576, *numbers))
    bench.fly(15.0)
    assert bench.vehicle.p_ned == pytest.approx((10.0, 5.0, -5.0), abs=0.1)
    assert (bench.vehicle.mode, bench.vehicle.armed) == ("guided", True)
    for mask, far in ((3527, (0.0, 0.0, 0.0)), (3520, (60.0, 5.0, -5.0))):
        bench.set_point(far, (1.0, 0.0, 0.0), mask=mask)
        bench.fly(8.0)
        assert bench.vehicle.mode == "guided"
        assert bench.vehicle.p_ned[0] < 40.0


def test_set_point_does_not_lift_a_guided_vehicle_off_the_ground(vehicle_bench: Any) -> None:
    bench = vehicle_bench(autopilot="ardupilot")
    bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 4.0)
    bench.arm()
    bench.fly(2.0, p_ned=(0.0, 0.0, -3.0))
    assert bench.vehicle.landed


def test_global_set_points_are_flown_in_both_heights(vehicle_bench: Any) -> None:
    bench = vehicle_bench().offboard()
    lat, lon, _ = bench.vehicle.frame.to_global(3.0, 1.0, 0.0)
    for frame, alt in ((mav.MAV_FRAME_GLOBAL_INT, 491.0), (mav.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT, 3.0)):
        for _ in range(40):
            bench.send(
                mav.MAVLink_set_position_target_global_int_message(
                    0, 1, 1, frame, 3576, round(1e7 * lat), round(1e7 * lon), alt, *[NAN] * 8
                )
            )
            bench.gcs_heartbeat()
            bench.tick()
        assert bench.vehicle.p_ned == pytest.approx((3.0, 1.0, -3.0), abs=0.1)


def test_speed_of_going_somewhere_can_be_changed(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    bench.heard.clear()
    place = (200_000, 0, -2.5)
    assert bench.result(mav.MAV_CMD_DO_REPOSITION, 1.0, 0.0, 0.0, NAN, place=place, frame=1) == ACCEPTED
    bench.fly(4.0)
    assert max(m.vx for m in bench.of("LOCAL_POSITION_NED")) == pytest.approx(1.0, rel=0.1)
    assert bench.result(mav.MAV_CMD_DO_CHANGE_SPEED, 1.0, 3.0, -1.0) == ACCEPTED
    bench.fly(3.0)
    assert bench.vehicle.v_ned[0] == pytest.approx(3.0, rel=0.1)
    for speed in (0.0, math.inf, -3.0):
        assert bench.result(mav.MAV_CMD_DO_CHANGE_SPEED, 1.0, speed) == DENIED


def test_home_can_be_moved_and_is_told_at_once(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    lat, lon, _ = bench.vehicle.frame.to_global(5.0, 2.0, 0.0)
    place = (round(1e7 * lat), round(1e7 * lon), 488.0)
    assert bench.result(mav.MAV_CMD_DO_SET_HOME, 0.0, place=place, frame=mav.MAV_FRAME_GLOBAL_INT) == ACCEPTED
    (home,) = [m for m in bench.tick() if m.get_type() == "HOME_POSITION"]
    assert (home.x, home.y, home.z) == pytest.approx((5.0, 2.0, 0.0), abs=0.02)


def reboot(bench: Any) -> list[Any]:
    """Ask for a reboot and let it pass; all acknowledgements."""
    acks = [m.result for m in bench.command(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1.0)]
    return acks + [m.result for m in bench.tick(12) if m.get_type() == "COMMAND_ACK"]


def test_reboot_is_in_progress_busy_for_others_and_then_done(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    assert bench.result(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1.0) == IN_PROGRESS
    assert bench.result(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1.0) == IN_PROGRESS
    assert bench.arm() == TEMPORARILY_REJECTED
    first = bench.tick()
    assert [m.system_status for m in first if m.get_type() == "HEARTBEAT"] == [mav.MAV_STATE_BOOT]
    done = [m for m in bench.tick(12) if m.get_type() == "COMMAND_ACK"]
    assert [(m.command, m.result) for m in done] == [(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, ACCEPTED)]
    assert bench.arm() == ACCEPTED
    assert bench.texts == ["Rebooting", "Booted"]


def test_armed_vehicle_does_not_reboot(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    assert bench.result(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1.0) == TEMPORARILY_REJECTED
    flying = vehicle_bench(start=Start((0.0, 0.0, -5.0), airborne=True))
    assert flying.result(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1.0) == TEMPORARILY_REJECTED
    assert bench.result(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 0.0) == ACCEPTED
    assert vehicle_bench().result(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 2.0) == UNSUPPORTED


def set_cruise(bench: Any, value: float) -> list[Any]:
    message = mav.MAVLink_param_set_message(1, 1, b"MPC_XY_CRUISE", value, mav.MAV_PARAM_TYPE_REAL32)
    return list(bench.send(message))


def test_reboot_forgets_parameters_plans_and_failures_without_a_state(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1})
    set_cruise(bench, 2.0)
    inject(bench, GPS, OFF)
    bench.send(mav.MAVLink_mission_count_message(1, 1, 1, 0))
    assert reboot(bench) == [IN_PROGRESS, ACCEPTED]
    assert bench.vehicle.parameters["MPC_XY_CRUISE"] == 5.0
    assert bench.vehicle.parameters["SYS_FAILURE_EN"] == 1.0
    assert bench.vehicle.failed == set()


def test_parameters_survive_reboot_and_process_with_a_state(vehicle_bench: Any, tmp_path: Path) -> None:
    store = StateFile(tmp_path / "state", 1)
    bench = vehicle_bench(store=store)
    set_cruise(bench, 2.0)
    assert reboot(bench) == [IN_PROGRESS, ACCEPTED]
    assert bench.vehicle.parameters["MPC_XY_CRUISE"] == 2.0
    assert StateFile(tmp_path / "state", 1).values == {"MPC_XY_CRUISE": 2.0}
    assert StateFile(tmp_path / "state", 2).values == {}
    set_cruise(bench, 99.0)
    assert json.loads(store.path.read_text()) == {"MPC_XY_CRUISE": 2.0}


def test_a_parameter_that_is_set_is_sent_on_all_links_and_one_that_is_refused_to_its_sender(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    other = Connection(1)
    bench.services.connections.append(other)
    for value, on_the_other in ((2.0, [2.0]), (99.0, [])):
        assert set_cruise(bench, value)[-1].param_value == 2.0
        sent = [m for raw in other.frames() for m in mav.MAVLink(None).parse_buffer(raw)]
        assert [m.param_value for m in sent if m.get_type().startswith("PARAM_")] == on_the_other


def test_a_parameter_that_a_full_disk_does_not_take_is_refused_and_the_vehicle_flies_on(
    vehicle_bench: Any, tmp_path: Path
) -> None:
    store = StateFile(tmp_path, 1)
    bench = vehicle_bench(store=store).in_air()
    set_cruise(bench, 2.0)
    (tmp_path / "1.parameters.new").symlink_to("/dev/full")
    messages = set_cruise(bench, 3.0)
    assert [m.get_type() for m in messages] == ["PARAM_ERROR", "PARAM_VALUE"]
    assert (messages[1].param_value, bench.vehicle.parameters["MPC_XY_CRUISE"]) == (2.0, 2.0)
    assert os.listdir(tmp_path) == ["1.parameters.json"]
    assert StateFile(tmp_path, 1).values == store.values == {"MPC_XY_CRUISE": 2.0}
    bench.tick()
    said = "".join(bench.texts)
    assert said.count("MPC_XY_CRUISE") == 1
    assert said.endswith(f"cannot write {store.path}: No space left on device")
    bench.fly(1.0)
    assert bench.vehicle.armed
    assert set_cruise(bench, 3.0)[0].param_value == 3.0


@pytest.mark.parametrize("content", ["", "[]", "{", '{"A": "x"}', '{"A": null}'])
def test_broken_state_is_named(tmp_path: Path, content: str) -> None:
    (tmp_path / "1.parameters.json").write_text(content)
    with pytest.raises(StateError, match=r"1\.parameters\.json holds no parameters"):
        StateFile(tmp_path, 1)


def wrong(bench: Any, unit: int, *numbers: float) -> int:
    return int(bench.result(mav.MAV_CMD_INJECT_FAILURE, float(unit), float(mav.FAILURE_TYPE_WRONG), 0.0, *numbers))


def test_a_battery_loses_joules_at_once_which_count_as_drawn(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1, "SIM_BAT_CAP_J": 24_000.0, "SIM_BAT_INIT_J": 20_000.0})
    bench.tick()
    before = (bench.vehicle.remaining_j, bench.vehicle.drawn_j)
    assert wrong(bench, BATTERY, 5000.0) == ACCEPTED
    assert (bench.vehicle.remaining_j, bench.vehicle.drawn_j) == pytest.approx((before[0] - 5000.0, before[1] + 5000.0))
    assert abs(bench.ledger_gap_j()) < 1e-7
    assert wrong(bench, BATTERY, 1e6) == ACCEPTED
    assert bench.vehicle.remaining_j == 0.0
    assert abs(bench.ledger_gap_j()) < 1e-7
    assert [wrong(bench, BATTERY, joules) for joules in (-1.0, math.nan)] == [DENIED] * 2
    assert wrong(bench, MOTOR, 0.0) == UNSUPPORTED


def test_a_wrong_gps_moves_the_vehicle_the_other_way_and_it_does_not_know(vehicle_bench: Any) -> None:
    """It flies on the place that it believes, so that it comes to rest as far off as the GPS is."""
    bench = vehicle_bench(start=Start((1.0, 2.0, -5.0), airborne=True), params={"SYS_FAILURE_EN": 1})
    bench.set_point((1.0, 2.0, -5.0))
    bench.tick()
    assert wrong(bench, GPS, 0.0, 2.0, -1.0) == ACCEPTED
    assert bench.vehicle.p_ned == pytest.approx((3.0, 1.0, -5.0), abs=0.01)
    for _ in range(100):
        bench.set_point((1.0, 2.0, -5.0))
        bench.tick()
    assert bench.vehicle.p_ned == pytest.approx((1.0, 2.0, -5.0), abs=0.02)
    assert bench.vehicle.true_motion_ned[:3] == pytest.approx((-1.0, 3.0, -5.0), abs=0.02)
    assert inject(bench, GPS, mav.FAILURE_TYPE_OK) == ACCEPTED
    assert bench.vehicle.p_ned == bench.vehicle.true_motion_ned[:3]
    assert wrong(bench, GPS, 0.0, 1e9, 0.0) == DENIED
