"""What the vehicle does with each command and message."""

import itertools
import math
from typing import Any

import newer
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.mission import Kind, Leg, Place
from simvehicle.mavlink.dispatcher import COMMANDS
from simvehicle.mavlink.telemetry import TELEMETRY

ACCEPTED, TEMPORARILY_REJECTED, DENIED, UNSUPPORTED, FAILED = 0, 1, 2, 3, 4
NAN = math.nan
AIRBORNE = Start(p_ned=(0.0, 0.0, -5.0), airborne=True)
HOME_AMSL = 488.0


def kinds(messages: list[Any]) -> list[str]:
    return [m.get_type() for m in messages]


@pytest.mark.parametrize("command", sorted(COMMANDS))
def test_known_command_gets_one_ack_to_its_sender_whatever_its_parameters(vehicle_bench: Any, command: int) -> None:
    for kind, fill in itertools.product(("long", "int"), (0.0, NAN, math.inf, -1.0, 3.4e38)):
        bench = vehicle_bench()
        for source in ((255, 190), (42, 7)):
            place = (2**31 - 1, -(2**31), fill) if kind == "int" else None
            answers = bench.command(command, *[fill] * (4 if place else 7), place=place, source=source)
            acks = [m for m in answers if m.get_type() == "COMMAND_ACK"]
            asked = (command, *source)
            assert [(m.command, m.target_system, m.target_component) for m in acks] == [asked], (kind, fill)
            assert acks[0].result != UNSUPPORTED or command in (
                mav.MAV_CMD_DO_SET_MODE, mav.MAV_CMD_REQUEST_MESSAGE,
                mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAV_CMD_GET_MESSAGE_INTERVAL,
                mav.MAV_CMD_INJECT_FAILURE,
            ), (kind, fill)  # fmt: skip
        bench.tick(2)


@pytest.mark.parametrize("command", [0, 1, 2001, 31011, 65535])
def test_unknown_command_is_unsupported_and_changes_nothing(vehicle_bench: Any, command: int) -> None:
    bench = vehicle_bench()
    assert bench.result(command, 1.0, 1.0) == UNSUPPORTED
    assert bench.result(command, place=(1, 1, 1.0)) == UNSUPPORTED
    assert (bench.vehicle.mode, bench.vehicle.armed) == ("hold", False)


@pytest.mark.parametrize("repeat", [1, 3])
@pytest.mark.parametrize("kind", ["long", "int"])
def test_repeated_commands_are_answered_alike_and_act_once(vehicle_bench: Any, repeat: int, kind: str) -> None:
    bench = vehicle_bench()
    place = (0, 0, NAN) if kind == "int" else None
    rest = [] if place else [NAN] * 7
    for command, params in (
        (mav.MAV_CMD_COMPONENT_ARM_DISARM, [1.0]),
        (mav.MAV_CMD_NAV_TAKEOFF, rest),
        (mav.MAV_CMD_DO_SET_MODE, [129.0, 4.0, 3.0]),
        (mav.MAV_CMD_NAV_LAND, []),
        (mav.MAV_CMD_NAV_LOITER_UNLIM, []),
        (mav.MAV_CMD_NAV_RETURN_TO_LAUNCH, []),
    ):
        for _ in range(repeat):
            assert bench.result(command, *params, place=place) == ACCEPTED
        bench.tick()
    assert bench.texts == ["Armed", "Take-off", "Hold", "Land", "Hold", "Return to home", "Home reached, land"]


@pytest.mark.parametrize("param1", [NAN, 2.0, -1.0, math.inf, 0.5])
def test_arming_parameter_that_is_neither_0_nor_1_is_denied(vehicle_bench: Any, param1: float) -> None:
    bench = vehicle_bench()
    bench.arm()
    assert bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, param1) == DENIED
    assert bench.vehicle.armed


@pytest.mark.parametrize(
    ("autopilot", "param7", "height_m"),
    [
        ("px4", NAN, 2.5),
        ("px4", 0.0, 2.5),
        ("px4", HOME_AMSL + 4.0, 4.0),
        ("px4", 4.0, None),
        ("px4", HOME_AMSL, None),
        ("ardupilot", NAN, 2.5),
        ("ardupilot", 4.0, 4.0),
        ("generic", NAN, 2.5),
        ("generic", 4.0, 4.0),
        ("generic", -4.0, None),
        ("generic", math.inf, None),
    ],
)
@pytest.mark.parametrize("kind", ["long", "int"])
def test_take_off_altitude_means_what_the_identity_says(
    vehicle_bench: Any, autopilot: str, param7: float, height_m: float | None, kind: str
) -> None:
    bench = vehicle_bench(autopilot=autopilot)
    bench.arm()
    frame = mav.MAV_FRAME_GLOBAL_RELATIVE_ALT if autopilot == "ardupilot" else mav.MAV_FRAME_GLOBAL
    how: dict[str, Any] = {"place": (0, 0, param7), "frame": frame} if kind == "int" else {}
    params = [] if kind == "int" else [0.0] * 6 + [param7]
    result = bench.result(mav.MAV_CMD_NAV_TAKEOFF, *params, **how)
    if height_m is None:
        assert result == DENIED
        assert bench.vehicle.mode == "hold"
        return
    assert result == ACCEPTED
    holding = "guided" if autopilot == "ardupilot" else "hold"
    bench.fly(15.0, until=lambda b: b.vehicle.mode == holding)
    bench.fly(3.0)
    assert -bench.vehicle.p_ned[2] == pytest.approx(height_m, abs=0.1)


def test_take_off_in_a_relative_frame_is_relative_for_px4_too(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.arm()
    place = (0, 0, 4.0)
    assert bench.result(mav.MAV_CMD_NAV_TAKEOFF, place=place, frame=mav.MAV_FRAME_GLOBAL_RELATIVE_ALT) == ACCEPTED
    bench.fly(15.0)
    assert -bench.vehicle.p_ned[2] == pytest.approx(4.0, abs=0.1)


@pytest.mark.parametrize("frame", [0, 1, 2, 4, 5, 6, 10, 11, 12, 21])
def test_an_ardupilot_denies_a_take_off_in_another_frame(vehicle_bench: Any, frame: int) -> None:
    """ArduCopter's handle_MAV_CMD_NAV_TAKEOFF: anything but MAV_FRAME_GLOBAL_RELATIVE_ALT is MAV_RESULT_DENIED."""
    bench = vehicle_bench(autopilot="ardupilot")
    bench.arm()
    assert bench.result(mav.MAV_CMD_NAV_TAKEOFF, place=(0, 0, 498.0), frame=frame) == DENIED
    bench.fly(3.0)
    assert (bench.vehicle.mode, bench.vehicle.landed) == ("hold", True)


def test_an_ardupilot_takes_off_once_and_upwards(vehicle_bench: Any) -> None:
    """ArduCopter's do_user_takeoff: not unless armed, not again before it has landed, and not to below where it is."""
    bench = vehicle_bench(autopilot="ardupilot")

    def take_off(height_m: float) -> int:
        return int(bench.result(mav.MAV_CMD_NAV_TAKEOFF, *[0.0] * 6, height_m))

    assert take_off(3.0) == FAILED
    bench.arm()
    assert take_off(0.0) == take_off(-4.0) == FAILED
    assert bench.vehicle.mode == "hold"
    assert take_off(3.0) == ACCEPTED
    assert take_off(5.0) == FAILED
    bench.fly(20.0, until=lambda b: b.vehicle.mode == "guided")
    for mode in (4.0, 5.0):
        assert bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, mode) == ACCEPTED
        before = bench.vehicle.mode
        assert take_off(8.0) == FAILED
        assert bench.vehicle.mode == before
    bench.fly(3.0)
    assert -bench.vehicle.p_ned[2] == pytest.approx(3.0, abs=0.1)
    bench.result(mav.MAV_CMD_NAV_LAND)
    bench.fly(20.0, until=lambda b: not b.vehicle.armed)
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 4.0) == ACCEPTED
    bench.arm()
    assert take_off(3.0) == ACCEPTED


def test_reposition_flies_to_the_place_in_each_frame(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    lat, lon, _ = bench.vehicle.frame.to_global(6.0, -3.0, 0.0)
    in_degrees = (round(1e7 * lat), round(1e7 * lon))
    for frame, place, down_m in (
        (mav.MAV_FRAME_GLOBAL, (*in_degrees, HOME_AMSL + 5.0), -5.0),
        (mav.MAV_FRAME_GLOBAL_RELATIVE_ALT, (*in_degrees, 4.0), -4.0),
        (mav.MAV_FRAME_LOCAL_NED, (60_000, -30_000, -3.0), -3.0),
    ):
        assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, 0.0, 0.0, NAN, place=place, frame=frame) == ACCEPTED
        bench.fly(8.0)
        assert bench.vehicle.p_ned == pytest.approx((6.0, -3.0, down_m), abs=0.1)
    place = (0, 0, -3.0)
    assert bench.result(mav.MAV_CMD_DO_REPOSITION, place=place, frame=mav.MAV_FRAME_BODY_NED) == DENIED


def test_what_a_reposition_does_not_give_stays_as_it_is(vehicle_bench: Any) -> None:
    """As the standard has it, by NaN and by INT32_MAX: QGroundControl pauses and changes heights so."""
    bench = vehicle_bench().in_air()
    north, east, down = bench.vehicle.p_ned
    assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, 1.0, 0.0, NAN, NAN, NAN, NAN) == ACCEPTED
    bench.fly(3.0)
    assert bench.vehicle.p_ned == pytest.approx((north, east, down), abs=0.1)
    assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, 1.0, 0.0, NAN, NAN, NAN, HOME_AMSL + 8.0) == ACCEPTED
    bench.fly(8.0)
    assert bench.vehicle.p_ned == pytest.approx((north, east, -8.0), abs=0.1)
    unset, frame = 2**31 - 1, mav.MAV_FRAME_GLOBAL_RELATIVE_ALT
    place = (unset, unset, 6.0)
    assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, 0.0, 0.0, NAN, place=place, frame=frame) == ACCEPTED
    bench.fly(8.0)
    assert bench.vehicle.p_ned == pytest.approx((north, east, -6.0), abs=0.1)


def test_reposition_below_home_is_denied_in_each_frame(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    lat, lon, _ = bench.vehicle.frame.to_global(6.0, -3.0, 0.0)
    in_degrees = (round(1e7 * lat), round(1e7 * lon))
    before = bench.vehicle.p_ned
    for frame, place in (
        (mav.MAV_FRAME_GLOBAL, (*in_degrees, 100.0)),
        (mav.MAV_FRAME_GLOBAL_RELATIVE_ALT, (*in_degrees, 0.2)),
        (mav.MAV_FRAME_LOCAL_NED, (60_000, -30_000, 5.0)),
    ):
        assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, 1.0, 0.0, NAN, place=place, frame=frame) == DENIED
    bench.fly(3.0)
    assert bench.vehicle.p_ned == pytest.approx(before, abs=0.1)


@pytest.mark.parametrize("unknown", [4.0, -1.0, 255.0])
def test_reposition_with_flags_or_a_yaw_that_are_none_is_denied(vehicle_bench: Any, unknown: float) -> None:
    bench = vehicle_bench().in_air()
    for flags, yaw in ((unknown, NAN), (1.0, math.inf)):
        assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, flags, 0.0, yaw, NAN, NAN, HOME_AMSL + 3.0) == DENIED


def test_a_reposition_turns_the_vehicle_where_a_yaw_is_given(vehicle_bench: Any) -> None:
    """To a quarter turn from north, by half a turn from there, and not at all."""
    bench = vehicle_bench().in_air()
    absolute, relative = 1.0, 3.0
    for flags, yaw, flown in (
        (absolute, 0.5 * math.pi, 0.5 * math.pi),
        (relative, -math.pi, -0.5 * math.pi),
        (absolute, NAN, -0.5 * math.pi),
    ):
        assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, flags, 0.0, yaw, NAN, NAN, NAN) == ACCEPTED
        bench.fly(8.0)
        assert bench.of("ATTITUDE")[-1].yaw == pytest.approx(flown, abs=0.05)


@pytest.mark.parametrize(
    ("autopilot", "mission", "after"), [("px4", (4.0, 4.0), "hold"), ("ardupilot", (3.0,), "guided")]
)
def test_a_reposition_changes_the_mode_only_where_its_flags_say_so(
    vehicle_bench: Any, autopilot: str, mission: tuple[float, ...], after: str
) -> None:
    """A vehicle that flies its mission goes on with it, as an ArduPilot does; a PX4 refuses too."""
    bench = vehicle_bench(autopilot=autopilot)
    bench.in_air_guided() if autopilot == "ardupilot" else bench.in_air()
    go = (mav.MAV_CMD_DO_REPOSITION, -1.0)
    rest = (0.0, NAN, NAN, NAN, HOME_AMSL + 3.0)
    assert bench.result(*go, 0.0, *rest) == ACCEPTED
    bench.vehicle.load_mission([Leg(Kind.WAYPOINT, Place(30.0, 0.0, 3.0))])
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, *mission) == ACCEPTED
    assert bench.result(*go, 0.0, *rest) == bench.result(*go, 2.0, *rest) == DENIED
    assert bench.vehicle.mode == "mission"
    assert bench.result(*go, 1.0, *rest) == ACCEPTED
    assert bench.vehicle.mode == after


def test_reposition_on_the_ground_is_rejected(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.arm()
    assert bench.result(mav.MAV_CMD_DO_REPOSITION, -1.0, 0.0, 0.0, NAN, 47.3978, 8.5456, 495.0) == TEMPORARILY_REJECTED


def test_offboard_without_fresh_set_points_is_rejected_with_its_reason(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 129.0, 6.0, 0.0) == TEMPORARILY_REJECTED
    bench.tick()
    assert bench.texts[-1] == "Offboard refused: no set points"
    bench.set_point((0.0, 0.0, -2.5))
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 129.0, 6.0, 0.0) == ACCEPTED


@pytest.mark.parametrize(
    ("autopilot", "custom_mode", "mode"),
    [
        ("px4", 4 << 16 | 3 << 24, "hold"),
        ("px4", 3 << 16, "hold"),
        ("px4", 4 << 16 | 5 << 24, "return"),
        ("px4", 4 << 16 | 6 << 24, "land"),
        ("px4", 6 << 16, "offboard"),
        ("px4", 1 << 16, None),
        ("generic", 4 << 16 | 6 << 24, "land"),
        ("ardupilot", 4, "offboard"),
        ("ardupilot", 5, "hold"),
        ("ardupilot", 17, "hold"),
        ("ardupilot", 6, "return"),
        ("ardupilot", 9, "land"),
        ("ardupilot", 2, None),
    ],
)
@pytest.mark.parametrize("way", ["command", "message"])
def test_mode_number_means_what_the_identity_says(
    vehicle_bench: Any, autopilot: str, custom_mode: int, mode: str | None, way: str
) -> None:
    bench = vehicle_bench(autopilot=autopilot)
    bench.set_point()
    if way == "message":
        assert bench.send(mav.MAVLink_set_mode_message(1, 1, custom_mode)) == []
    else:
        main, sub = (custom_mode, 0) if autopilot == "ardupilot" else (custom_mode >> 16 & 255, custom_mode >> 24)
        expected = UNSUPPORTED if mode is None else ACCEPTED
        assert bench.result(mav.MAV_CMD_DO_SET_MODE, 129.0, main, sub) == expected
    assert bench.vehicle.mode == (mode or "hold")
    bench.tick(11)
    heartbeat = bench.of("HEARTBEAT")[-1]
    assert heartbeat.base_mode & mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
    if mode is not None and custom_mode not in (3 << 16, 17):
        assert heartbeat.custom_mode == custom_mode


@pytest.mark.parametrize(("autopilot", "land"), [("px4", (4, 6)), ("generic", (4, 6)), ("ardupilot", (9, 0))])
@pytest.mark.parametrize("base_mode", [0, 4, 128, 220])
def test_a_mode_whose_number_is_not_said_to_be_custom_is_not_entered(
    vehicle_bench: Any, autopilot: str, land: tuple[int, int], base_mode: int
) -> None:
    """MAV_MODE_FLAG_CUSTOM_MODE_ENABLED (1) says that the other numbers count; ArduPilot denies what lacks it."""
    bench = vehicle_bench(autopilot=autopilot)
    main, sub = land
    packed = main if autopilot == "ardupilot" else main << 16 | sub << 24
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, base_mode, main, sub) == DENIED
    assert bench.send(mav.MAVLink_set_mode_message(1, base_mode, packed)) == []
    assert bench.vehicle.mode == "hold"
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, base_mode | 1, main, sub) == ACCEPTED
    assert bench.vehicle.mode == "land"


def test_every_answered_request_message_is_followed_by_the_message(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    sent_by_request = set()
    for msgid in range(513):
        answers = bench.command(mav.MAV_CMD_REQUEST_MESSAGE, float(msgid))
        assert answers[0].get_type() == "COMMAND_ACK"
        ids = {m.get_msgId() for m in answers[1:]}
        assert ids == ({msgid} if answers[0].result == ACCEPTED else set())
        assert answers[0].result in (ACCEPTED, UNSUPPORTED)
        sent_by_request |= ids
    beside_telemetry = {mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION, mav.MAVLINK_MSG_ID_MESSAGE_INTERVAL, *newer.MESSAGES}
    beside_telemetry -= {410, 412, 413}
    assert sent_by_request == {s.msgid for s in TELEMETRY} | beside_telemetry


def test_home_and_version_have_commands_of_their_own(vehicle_bench: Any) -> None:
    bench = vehicle_bench(7)
    assert kinds(bench.command(mav.MAV_CMD_GET_HOME_POSITION)) == ["COMMAND_ACK", "HOME_POSITION"]
    answers = bench.command(mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, 1.0)
    assert kinds(answers) == ["COMMAND_ACK", "AUTOPILOT_VERSION"]
    assert answers[1].uid == 7
    for flag in ("MAVLINK2", "COMMAND_INT", "SET_POSITION_TARGET_LOCAL_NED", "PARAM_ENCODE_BYTEWISE", "FTP"):
        assert answers[1].capabilities & getattr(mav, f"MAV_PROTOCOL_CAPABILITY_{flag}")


@pytest.mark.parametrize("target", [(2, 1), (1, 2), (2, 0), (255, 190), (0, 7)])
def test_message_for_another_target_is_not_obeyed(vehicle_bench: Any, target: tuple[int, int]) -> None:
    bench = vehicle_bench()
    assert bench.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, target=target) == []
    assert bench.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, place=(0, 0, 0.0), target=target) == []
    bench.set_point(target=target)
    assert bench.send(mav.MAVLink_param_request_list_message(*target)) == []
    assert bench.send(mav.MAVLink_param_set_message(*target, b"MPC_XY_CRUISE", 1.0, 9)) == []
    assert not bench.vehicle.armed
    assert not bench.vehicle.setpoints_fresh()
    assert bench.vehicle.parameters["MPC_XY_CRUISE"] == 5.0


def test_mode_message_for_another_system_is_not_obeyed(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.send(mav.MAVLink_set_mode_message(2, 1, 4 << 16 | 6 << 24))
    assert bench.vehicle.mode == "hold"


@pytest.mark.parametrize("target", [(1, 1), (1, 0), (0, 1), (0, 0)])
def test_message_for_this_vehicle_or_for_all_is_obeyed(vehicle_bench: Any, target: tuple[int, int]) -> None:
    bench = vehicle_bench()
    assert bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, target=target) == ACCEPTED
    bench.set_point(target=target)
    assert bench.vehicle.setpoints_fresh()


def test_vehicle_does_not_hear_itself(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    assert bench.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, source=(1, 1)) == []
    assert not bench.vehicle.armed


def test_transfer_by_command_int_reads_whole_numbers(vehicle_bench: Any) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    bench.set_point((0.0, 0.0, -5.0))
    assert bench.result(mav.MAV_CMD_USER_1, 2.0, 1.0, 100.0, 50.0, place=(77, 12, 0.0)) == ACCEPTED
    order = bench.vehicle.transfer.order
    assert (order.partner, order.transfer_id, order.giver_start_j) == (2, 77, 12)


@pytest.mark.parametrize(
    "params",
    [
        (2.0, 4.0, 100.0, 50.0, 1.0, 0.0),
        (2.0, -1.0, 100.0, 50.0, 1.0, 0.0),
        (2.0, 1.0, NAN, 50.0, 1.0, 0.0),
        (2.0, 1.0, 0.0, 50.0, 1.0, 0.0),
        (2.0, 1.0, 100.0, -5.0, 1.0, 0.0),
        (NAN, 0.0, 0.0, 0.0, 0.0, 0.0),
        (2.0, 1.0, math.inf, 50.0, 1.0, 0.0),
    ],
)
def test_transfer_order_with_bad_numbers_is_denied(vehicle_bench: Any, params: tuple[float, ...]) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    assert bench.result(mav.MAV_CMD_USER_1, *params) == DENIED
    assert bench.vehicle.transfer is None


@settings(max_examples=150)
@given(
    st.lists(
        st.tuples(
            st.sampled_from(sorted(COMMANDS)),
            st.lists(st.one_of(st.floats(width=32), st.integers(-3, 300).map(float)), min_size=7, max_size=7),
            st.booleans(),
            st.integers(0, 21),
        ),
        max_size=8,
    )
)
def test_no_sequence_of_commands_stops_a_vehicle(
    vehicle_bench: Any, orders: list[tuple[int, list[float], bool, int]]
) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    for command, p, long, frame in orders:
        if long:
            bench.result(command, *p)
        else:
            x, y = (round(v) if abs(v) < 2**31 else 2**31 - 1 for v in (0.0 if math.isnan(v) else v for v in p[4:6]))
            bench.result(command, *p[:4], place=(x, y, p[6]), frame=frame)
        bench.tick()
    assert all(math.isfinite(x) for x in bench.vehicle.state[0])
    assert abs(bench.ledger_gap_j()) < 1e-6


@settings(max_examples=150)
@given(st.data())
def test_no_message_of_any_kind_or_content_stops_a_vehicle(vehicle_bench: Any, data: st.DataObject) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    writer = mav.MAVLink(None, 255, 190)
    for _ in range(5):
        msgid = data.draw(st.sampled_from(sorted(mav.mavlink_map)))
        cls = mav.mavlink_map[msgid]
        payload = data.draw(st.binary(min_size=1, max_size=cls.unpacker.size))
        bench.feed(bytes(mav.MAVLink_message(msgid, cls.msgname)._pack(writer, cls.crc_extra, payload)))
        bench.tick()
    assert all(math.isfinite(x) for x in bench.vehicle.state[0])
