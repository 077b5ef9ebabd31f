"""Missions, geofence and rally points: uploaded, downloaded and flown."""

import math
import os
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.mission import Kind
from simvehicle.sitl.storage import StateError, StateFile

ACCEPTED, TEMPORARILY_REJECTED = 0, 1
REL = mav.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT
AMSL, LOCAL = mav.MAV_FRAME_GLOBAL, mav.MAV_FRAME_LOCAL_NED
MISSION, FENCE, RALLY = 0, 1, 2
SUPERVISOR = (255, 190)


def degrees_e7(bench: Any, north: float, east: float) -> tuple[int, int]:
    lat, lon, _ = bench.vehicle.frame.to_global(north, east, 0.0)
    return round(1e7 * lat), round(1e7 * lon)


def item(
    bench: Any,
    command: int,
    place: tuple[float, float, float] | None = None,
    params: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0),
    *,
    frame: int = REL,
    kind: int = MISSION,
) -> Any:
    x, y = degrees_e7(bench, *place[:2]) if place is not None else (0, 0)
    z = place[2] if place is not None else 0.0
    return mav.MAVLink_mission_item_int_message(1, 1, 0, frame, command, 0, 1, *params, x, y, z, kind)


def waypoint(bench: Any, north: float, east: float, height: float, hold_s: float = 0.0) -> Any:
    return item(bench, mav.MAV_CMD_NAV_WAYPOINT, (north, east, height), (hold_s, 0.0, 0.0, 0.0))


def answer(messages: list[Any]) -> Any:
    """The one message of the mission protocol among some."""
    (found,) = [m for m in messages if m.get_type().startswith("MISSION_") and m.get_type() != "MISSION_CURRENT"]
    assert (getattr(found, "target_system", 255), getattr(found, "target_component", 190)) == SUPERVISOR
    return found


def upload(bench: Any, items: list[Any], kind: int = MISSION) -> int:
    """Upload a whole plan; the result in MISSION_ACK."""
    heard = answer(bench.send(mav.MAVLink_mission_count_message(1, 1, len(items), kind)))
    while heard.get_type() == "MISSION_REQUEST_INT":
        items[heard.seq].seq = heard.seq
        heard = answer(bench.send(items[heard.seq]))
    assert (heard.get_type(), heard.mission_type) == ("MISSION_ACK", kind)
    return int(heard.type)


def download(bench: Any, kind: int = MISSION) -> list[Any]:
    count = answer(bench.send(mav.MAVLink_mission_request_list_message(1, 1, kind)))
    assert (count.get_type(), count.mission_type) == ("MISSION_COUNT", kind)
    return [answer(bench.send(mav.MAVLink_mission_request_int_message(1, 1, seq, kind))) for seq in range(count.count)]


def reached(bench: Any) -> list[int]:
    return [m.seq for m in bench.of("MISSION_ITEM_REACHED")]


def mission_mode(bench: Any) -> int:
    return int(bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 4.0, 4.0))


def whole(bench: Any) -> list[Any]:
    return [
        item(bench, mav.MAV_CMD_NAV_TAKEOFF, (0.0, 0.0, 2.0)),
        item(bench, mav.MAV_CMD_DO_CHANGE_SPEED, None, (1.0, 2.0, -1.0, 0.0), frame=mav.MAV_FRAME_MISSION),
        waypoint(bench, 6.0, 0.0, 3.0),
        item(bench, mav.MAV_CMD_NAV_LOITER_TIME, (6.0, 4.0, 3.0), (2.0, 0.0, 0.0, 0.0)),
        item(bench, mav.MAV_CMD_NAV_RETURN_TO_LAUNCH, None, (0.0,) * 4, frame=mav.MAV_FRAME_MISSION),
    ]


def test_what_was_uploaded_is_downloaded(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    sent = whole(bench)
    assert upload(bench, sent) == ACCEPTED
    back = download(bench)
    told = ("seq", "frame", "command", "autocontinue", "param1", "param2", "param3", "param4", "x", "y", "z")
    assert [[getattr(m, name) for name in told] for m in back] == [[getattr(m, name) for name in told] for m in sent]
    assert [m.current for m in back] == [1, 0, 0, 0, 0]
    assert download(bench, FENCE) == download(bench, RALLY) == []


def fence_and_rally(bench: Any) -> tuple[list[Any], list[Any]]:
    circle = mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION
    fence = [item(bench, circle, (0.0, 0.0, 0.0), (30.0, math.nan, math.nan, 0.0), kind=FENCE)]
    return fence, [item(bench, mav.MAV_CMD_NAV_RALLY_POINT, (4.0, -2.0, 3.0), kind=RALLY)]


def told(items: list[Any]) -> list[str]:
    """Items as they stand on the wire."""
    return [m.to_json() for m in items]


@pytest.mark.parametrize("anew", ["reboot", "process"])
def test_plans_survive_reboot_and_process_with_a_state_and_are_flown(
    vehicle_bench: Any, tmp_path: Path, anew: str
) -> None:
    bench = vehicle_bench(store=StateFile(tmp_path, 1))
    fence, rally = fence_and_rally(bench)
    for plan, kind in ((whole(bench), MISSION), (fence, FENCE), (rally, RALLY)):
        assert upload(bench, plan, kind) == ACCEPTED
    before = [told(download(bench, kind)) for kind in (MISSION, FENCE, RALLY)]
    if anew == "reboot":
        bench.command(mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1.0)
        bench.tick(12)
    else:
        bench = vehicle_bench(store=StateFile(tmp_path, 1))
    assert [told(download(bench, kind)) for kind in (MISSION, FENCE, RALLY)] == before
    assert bench.vehicle.fence.breached(31.0, 0.0)
    assert [p[:2] for p in bench.vehicle.rally_ned] == [pytest.approx((4.0, -2.0), abs=0.02)]
    bench.arm()
    assert mission_mode(bench) == ACCEPTED
    bench.fly(20.0, until=lambda b: 2 in reached(b))
    other = vehicle_bench(store=StateFile(tmp_path, 2))
    assert download(other) == []


def test_cleared_and_refused_plans_are_not_kept(vehicle_bench: Any, tmp_path: Path) -> None:
    bench = vehicle_bench(store=StateFile(tmp_path, 1))
    upload(bench, whole(bench))
    upload(bench, fence_and_rally(bench)[1], RALLY)
    assert upload(bench, [item(bench, 9999)]) != ACCEPTED
    bench.send(mav.MAVLink_mission_clear_all_message(1, 1, RALLY))
    again = vehicle_bench(store=StateFile(tmp_path, 1))
    assert [len(download(again, kind)) for kind in (MISSION, FENCE, RALLY)] == [5, 0, 0]


def test_plan_that_a_full_disk_does_not_take_is_refused_and_the_one_in_force_stays(
    vehicle_bench: Any, tmp_path: Path
) -> None:
    store = StateFile(tmp_path, 1)
    bench = vehicle_bench(store=store).in_air()
    items, fence = whole(bench), fence_and_rally(bench)[0]
    upload(bench, fence, FENCE)
    kept = store.plans_path.read_text()
    for kind, plan in ((MISSION, items), (FENCE, fence[:1]), (RALLY, fence_and_rally(bench)[1])):
        (tmp_path / "1.plans.new").symlink_to("/dev/full")
        assert upload(bench, plan, kind) == mav.MAV_MISSION_ERROR
    (tmp_path / "1.plans.new").symlink_to("/dev/full")
    cleared = answer(bench.send(mav.MAVLink_mission_clear_all_message(1, 1, FENCE)))
    assert (cleared.get_type(), cleared.type) == ("MISSION_ACK", mav.MAV_MISSION_ERROR)
    assert os.listdir(tmp_path) == ["1.plans.json"]
    bench.tick()
    why = f"Plan refused: cannot write {store.plans_path}: No space left on device"
    assert "".join(bench.texts).endswith(4 * why)
    assert (bench.vehicle.mission, bench.vehicle.rally_ned) == (None, ())
    assert bench.vehicle.fence.breached(31.0, 0.0)
    assert [len(download(bench, kind)) for kind in (MISSION, FENCE, RALLY)] == [0, len(fence), 0]
    assert store.plans_path.read_text() == kept
    bench.fly(1.0)
    assert bench.vehicle.armed
    assert upload(bench, items) == ACCEPTED
    assert [len(plan) for plan in StateFile(tmp_path, 1).plans.values()] == [len(items), len(fence)]


def test_plan_that_was_kept_for_another_home_is_refused_aloud_and_the_others_stay(
    vehicle_bench: Any, tmp_path: Path
) -> None:
    store = StateFile(tmp_path, 1)
    store.keep_plan(MISSION, [(16, REL, 0.0, 0.0, 0.0, 0.0, -338000000, 1512000000, 3.0, 1)])
    store.keep_plan(RALLY, [(5100, REL, 0.0, 0.0, 0.0, 0.0, 473977420, 85455940, 3.0, 1)])
    bench = vehicle_bench(store=StateFile(tmp_path, 1))
    bench.tick()
    assert bench.texts == ["Plan refused: item 0: farther away than 100 km"]
    assert [len(download(bench, kind)) for kind in (MISSION, FENCE, RALLY)] == [0, 0, 1]


@pytest.mark.parametrize(
    "content",
    [
        "[]",
        "{",
        '{"mission": 5}',
        '{"route": []}',
        '{"mission": [[16]]}',
        '{"rally": [[5100, 3, 0, 0, 0, 0, 0.5, 0, 0, 1]]}',
        '{"fence": [[70000, 3, 0, 0, 0, 0, 0, 0, 0, 1]]}',
        '{"mission": [[16, 3, 1e300, 0, 0, 0, 0, 0, 0, 1]]}',
        '{"mission": [[16, 3, "x", 0, 0, 0, 0, 0, 0, 1]]}',
    ],
)
def test_broken_file_of_plans_is_named(tmp_path: Path, content: str) -> None:
    (tmp_path / "1.plans.json").write_text(content)
    with pytest.raises(StateError, match=r"1\.plans\.json holds no plans"):
        StateFile(tmp_path, 1)


def test_whole_mission_is_flown_from_the_ground_and_back(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"RTL_RETURN_ALT": 3.0})
    upload(bench, whole(bench))
    bench.arm()
    assert mission_mode(bench) == ACCEPTED
    bench.fly(30.0, until=lambda b: b.vehicle.mode == "return")
    bench.tick()
    assert reached(bench) == [0, 1, 2, 3, 4]
    way = [(m.x, m.y, m.z) for m in bench.of("LOCAL_POSITION_NED")]
    for place in ((0.0, 0.0, -2.0), (6.0, 0.0, -3.0), (6.0, 4.0, -3.0)):
        assert min(math.dist(p, place) for p in way) < 0.5
    assert max(math.hypot(m.vx, m.vy) for m in bench.of("LOCAL_POSITION_NED")) == pytest.approx(2.0, abs=0.2)
    held = [p for p in way if math.dist(p, (6.0, 4.0, -3.0)) < 0.6]
    assert len(held) >= 20  # 2 s at 10 Hz
    bench.fly(30.0, until=lambda b: not b.vehicle.armed)
    assert math.hypot(*bench.vehicle.p_ned[:2]) < 0.4
    assert reached(bench) == [0, 1, 2, 3, 4]
    assert bench.of("MISSION_CURRENT")[-1].mission_state == 5


def test_mission_begun_on_the_ground_climbs_before_it_moves(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    upload(bench, [waypoint(bench, 8.0, 0.0, 3.0)])
    bench.result(mav.MAV_CMD_MISSION_START)
    assert bench.vehicle.armed
    bench.fly(20.0, until=lambda b: b.vehicle.mode == "hold")
    low = [m for m in bench.of("LOCAL_POSITION_NED") if -m.z < 2.0]
    assert max(m.x for m in low) < 0.1


def copter_with_mission(vehicle_bench: Any) -> Any:
    bench = vehicle_bench(autopilot="ardupilot")
    assert upload(bench, [waypoint(bench, 0.0, 0.0, 0.0), *whole(bench)]) == ACCEPTED
    return bench


@pytest.mark.parametrize(
    ("number", "mode", "lets"),
    [(3, "mission", False), (6, "return", False), (9, "land", False), (4, "guided", True), (5, "hold", True)],
)
def test_a_copter_arms_and_takes_off_in_modes_that_let_it(
    vehicle_bench: Any, number: int, mode: str, lets: bool
) -> None:
    """By allows_arming and has_user_takeoff of ArduCopter's mode.h."""
    bench = copter_with_mission(vehicle_bench)
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, float(number)) == ACCEPTED
    assert bench.arm() == (ACCEPTED if lets else mav.MAV_RESULT_FAILED)
    bench.fly(1.0)
    assert (bench.vehicle.armed, bench.vehicle.mode, bench.vehicle.landed) == (lets, mode, True)
    assert ([f"Arming refused: not in mode {mode}"] == bench.texts[-1:]) != lets
    assert bench.of("SYS_STATUS")[-1].onboard_control_sensors_health & mav.MAV_SYS_STATUS_PREARM_CHECK
    assert bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, 2989.0) == ACCEPTED
    assert bench.arm() == ACCEPTED
    bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, float(number))
    taken = bench.result(mav.MAV_CMD_NAV_TAKEOFF, *[0.0] * 6, 3.0)
    assert taken == (ACCEPTED if lets else mav.MAV_RESULT_FAILED)


def test_a_copter_begins_no_mission_unless_it_is_armed(vehicle_bench: Any) -> None:
    bench = copter_with_mission(vehicle_bench)
    bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 4.0)
    assert bench.result(mav.MAV_CMD_MISSION_START, 1.0) == mav.MAV_RESULT_DENIED
    assert bench.result(mav.MAV_CMD_MISSION_START) == ACCEPTED
    bench.fly(2.0)
    assert (bench.vehicle.mode, bench.vehicle.armed, bench.vehicle.landed) == ("mission", False, True)
    bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 4.0)
    assert bench.arm() == ACCEPTED
    assert bench.result(mav.MAV_CMD_MISSION_START) == ACCEPTED
    bench.fly(20.0, until=lambda b: 2 in reached(b))


def test_mission_is_paused_continued_and_set_back(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    upload(bench, [waypoint(bench, 3.0, 0.0, 2.5), waypoint(bench, 12.0, 0.0, 2.5), waypoint(bench, 12.0, 3.0, 2.5)])
    assert mission_mode(bench) == ACCEPTED
    bench.fly(10.0, until=lambda b: b.vehicle.mission.index == 1)
    bench.fly(0.5)
    assert bench.result(mav.MAV_CMD_DO_PAUSE_CONTINUE, 0.0) == ACCEPTED
    bench.fly(4.0)
    paused = bench.vehicle.p_ned
    bench.fly(2.0)
    assert math.dist(bench.vehicle.p_ned, paused) < 0.05
    assert paused[0] < 10.0
    assert bench.of("MISSION_CURRENT")[-1].mission_state == 4
    assert bench.result(mav.MAV_CMD_DO_PAUSE_CONTINUE, 1.0) == ACCEPTED
    bench.fly(10.0, until=lambda b: b.vehicle.mission.index == 2)
    bench.send(mav.MAVLink_mission_set_current_message(1, 1, 0))
    bench.tick()
    assert bench.of("MISSION_CURRENT")[-1].seq == 0
    bench.fly(20.0, until=lambda b: b.vehicle.mode == "hold")
    assert reached(bench) == [0, 1, 0, 1, 2]


def test_mission_cleared_in_flight_ends_in_hold(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    upload(bench, [waypoint(bench, 30.0, 0.0, 2.5)])
    mission_mode(bench)
    bench.fly(1.0)
    assert answer(bench.send(mav.MAVLink_mission_clear_all_message(1, 1, MISSION))).type == ACCEPTED
    assert bench.vehicle.mode == "hold"
    assert download(bench) == []
    assert mission_mode(bench) == TEMPORARILY_REJECTED
    bench.tick()
    assert bench.texts[-1] == "Mission refused: there is none"


def test_landing_in_a_mission_ends_on_the_ground_disarmed(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    upload(bench, [item(bench, mav.MAV_CMD_NAV_LAND, (3.0, 2.0, 0.0))])
    mission_mode(bench)
    bench.fly(20.0, until=lambda b: not b.vehicle.armed)
    assert bench.vehicle.p_ned == pytest.approx((3.0, 2.0, 0.0), abs=0.35)
    bench.tick()
    assert reached(bench) == [0]


def test_first_item_of_an_ardupilot_is_home_and_not_flown(vehicle_bench: Any) -> None:
    bench = vehicle_bench(autopilot="ardupilot").in_air_guided()
    home = item(bench, mav.MAV_CMD_NAV_WAYPOINT, (500.0, 500.0, 0.0), frame=mav.MAV_FRAME_GLOBAL)
    upload(bench, [home, waypoint(bench, 3.0, 0.0, 2.5)])
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 3.0) == ACCEPTED
    bench.fly(20.0, until=lambda b: b.vehicle.mode == "hold")
    assert bench.vehicle.p_ned == pytest.approx((3.0, 0.0, -2.5), abs=0.6)


def test_item_0_of_an_ardupilot_reads_as_home_whatever_was_uploaded(vehicle_bench: Any) -> None:
    """AP_Mission::read_cmd_from_storage: a waypoint at home in MAV_FRAME_GLOBAL. It may always be read
    (MissionItemProtocol_Waypoints::get_item), though AP_Mission::clear leaves a count of 0."""

    def reads_as_home(at: Any) -> bool:
        read = answer(bench.send(mav.MAVLink_mission_request_int_message(1, 1, 0, MISSION)))
        return (read.command, read.frame, read.seq, read.x, read.y, read.z) == (
            mav.MAV_CMD_NAV_WAYPOINT, mav.MAV_FRAME_GLOBAL, 0, at.latitude, at.longitude, at.altitude / 1e3
        )  # fmt: skip

    bench = vehicle_bench(autopilot="ardupilot")
    (_, home) = bench.command(mav.MAV_CMD_GET_HOME_POSITION)
    assert download(bench) == []
    assert reads_as_home(home)
    far = waypoint(bench, 500.0, 500.0, 7.0)
    assert upload(bench, [far, waypoint(bench, 3.0, 0.0, 2.5)]) == ACCEPTED
    assert len(download(bench)) == 2
    assert reads_as_home(home)
    assert bench.result(mav.MAV_CMD_DO_SET_HOME, 0.0, 0.0, 0.0, 0.0, 47.4, 8.5, 490.0) == ACCEPTED
    (_, moved) = bench.command(mav.MAV_CMD_GET_HOME_POSITION)
    assert reads_as_home(moved)
    assert answer(bench.send(mav.MAVLink_mission_clear_all_message(1, 1, MISSION))).type == ACCEPTED
    assert download(bench) == []
    assert reads_as_home(moved)


def test_guided_item_is_flown_to_at_once(vehicle_bench: Any) -> None:
    bench = vehicle_bench(autopilot="ardupilot").in_air_guided()
    there = waypoint(bench, 2.0, 1.0, 3.0)
    there.current = 2
    assert answer(bench.send(there)).type == ACCEPTED
    bench.fly(6.0)
    assert bench.vehicle.p_ned == pytest.approx((2.0, 1.0, -3.0), abs=0.1)
    assert bench.vehicle.mode == "guided"
    assert bench.vehicle.mission is None


def test_guided_item_changes_no_mode(vehicle_bench: Any) -> None:
    """ArduCopter 4.6, ModeAuto::do_guided: only in guided mode."""
    bench = vehicle_bench(autopilot="ardupilot").in_air_guided()
    assert bench.result(mav.MAV_CMD_DO_SET_MODE, 1.0, 6.0) == ACCEPTED
    there = waypoint(bench, 20.0, 10.0, 3.0)
    there.current = 2
    assert answer(bench.send(there)).type == mav.MAV_MISSION_ERROR
    assert bench.vehicle.mode == "return"


def test_guided_item_is_none_to_a_px4(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    before_ned = bench.vehicle.p_ned
    there = waypoint(bench, 20.0, 10.0, 3.0)
    there.current = 2
    assert [m.get_type() for m in bench.send(there)] == []
    bench.fly(2.0)
    assert bench.vehicle.p_ned == pytest.approx(before_ned, abs=0.2)


def test_hole_in_a_sequence_is_asked_for_again_and_the_old_mission_stays(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    upload(bench, [waypoint(bench, 1.0, 0.0, 2.0)])
    items = [waypoint(bench, 2.0, i, 2.0) for i in range(3)]
    for i, each in enumerate(items):
        each.seq = i
    assert answer(bench.send(mav.MAVLink_mission_count_message(1, 1, 3, MISSION))).seq == 0
    assert answer(bench.send(items[0])).seq == 1
    assert answer(bench.send(items[2])).seq == 1
    assert bench.send(items[0]) == []
    assert len(download(bench)) == 1
    asked = [m for m in bench.tick(60) if m.get_type() in ("MISSION_REQUEST_INT", "MISSION_ACK")]
    assert [m.get_type() for m in asked] == ["MISSION_REQUEST_INT"] * 5 + ["MISSION_ACK"]
    assert {m.seq for m in asked[:-1]} == {1}
    assert asked[-1].type == mav.MAV_MISSION_OPERATION_CANCELLED
    assert len(download(bench)) == 1
    assert upload(bench, items) == ACCEPTED
    assert len(download(bench)) == 3


def test_lost_request_or_acknowledgement_costs_nothing(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    only = waypoint(bench, 1.0, 0.0, 2.0)
    bench.send(mav.MAVLink_mission_count_message(1, 1, 1, MISSION))
    repeated = [m for m in bench.tick(10) if m.get_type() == "MISSION_REQUEST_INT"]
    assert [m.seq for m in repeated] == [0] * len(repeated)
    assert repeated
    for _ in range(2):
        assert answer(bench.send(only)).type == ACCEPTED
    assert len(download(bench)) == 1
    only.seq = 7
    assert bench.send(only) == []


def test_second_uploader_is_refused_while_the_first_goes_on(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.send(mav.MAVLink_mission_count_message(1, 1, 1, MISSION))
    (refused,) = bench.send(mav.MAVLink_mission_count_message(1, 1, 5, MISSION), source=(9, 9))
    assert (refused.get_type(), refused.type, refused.target_system) == ("MISSION_ACK", mav.MAV_MISSION_ERROR, 9)
    assert answer(bench.send(waypoint(bench, 1.0, 0.0, 2.0))).type == ACCEPTED


def test_an_upload_goes_on_while_another_kind_is_cleared_and_others_may_not_clear(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    rally = mav.MAV_MISSION_TYPE_RALLY
    bench.send(mav.MAVLink_mission_count_message(1, 1, 1, MISSION))
    (refused,) = bench.send(mav.MAVLink_mission_clear_all_message(1, 1, rally), source=(9, 9))
    assert (refused.get_type(), refused.type) == ("MISSION_ACK", mav.MAV_MISSION_ERROR)
    assert answer(bench.send(mav.MAVLink_mission_clear_all_message(1, 1, rally))).type == ACCEPTED
    assert answer(bench.send(mav.MAVLink_mission_count_message(1, 1, 0, mav.MAV_MISSION_TYPE_FENCE))).type == ACCEPTED
    assert answer(bench.send(waypoint(bench, 1.0, 0.0, 2.0))).type == ACCEPTED
    assert len(download(bench)) == 1


def test_a_change_of_speed_by_nothing_changes_nothing(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    speeds = [
        mav.MAVLink_mission_item_int_message(
            1, 1, 0, REL, mav.MAV_CMD_DO_CHANGE_SPEED, 0, 1, 1.0, speed, 0, 0, 0, 0, 0, MISSION
        )
        for speed in (0.5, -1.0)
    ]
    assert upload(bench, [waypoint(bench, 0.0, 0.0, 2.0), *speeds, waypoint(bench, 9.0, 0.0, 2.0)]) == ACCEPTED
    assert [leg.speed_m_s for leg in bench.vehicle.mission.legs] == [None, 0.5, None, None]
    assert [leg.kind for leg in bench.vehicle.mission.legs].count(Kind.SPEED) == 1


@pytest.mark.parametrize(
    ("command", "params", "frame", "xyz", "result"),
    [
        (mav.MAV_CMD_NAV_SPLINE_WAYPOINT, (0.0,) * 4, REL, (0, 0, 2.0), mav.MAV_MISSION_UNSUPPORTED),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, mav.MAV_FRAME_BODY_FRD, (0, 0, 2.0), mav.MAV_MISSION_UNSUPPORTED_FRAME),
        (
            mav.MAV_CMD_NAV_WAYPOINT,
            (math.inf, 0, 0, 0),
            REL,
            (473977420, 85455940, 2.0),
            mav.MAV_MISSION_INVALID_PARAM1,
        ),
        (mav.MAV_CMD_NAV_WAYPOINT, (0, -1.0, 0, 0), REL, (473977420, 85455940, 2.0), mav.MAV_MISSION_INVALID_PARAM2),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, REL, (910000000, 0, 2.0), mav.MAV_MISSION_INVALID_PARAM5_X),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, REL, (0, 1810000000, 2.0), mav.MAV_MISSION_INVALID_PARAM6_Y),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, REL, (0, 0, 2.0), mav.MAV_MISSION_INVALID_PARAM5_X),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, REL, (473977420, 85455940, math.inf), mav.MAV_MISSION_INVALID_PARAM7),
        (mav.MAV_CMD_DO_CHANGE_SPEED, (1, -math.inf, 0, 0), REL, (0, 0, 0.0), mav.MAV_MISSION_INVALID_PARAM2),
        (mav.MAV_CMD_DO_CHANGE_SPEED, (1, 0.0, 0, 0), REL, (0, 0, 0.0), mav.MAV_MISSION_INVALID_PARAM2),
        (mav.MAV_CMD_DO_CHANGE_SPEED, (3, 0.3, 0, 0), REL, (0, 0, 0.0), mav.MAV_MISSION_INVALID_PARAM1),
        (mav.MAV_CMD_NAV_DELAY, (-1.0, 12.0, 30.0, 0), REL, (0, 0, 0.0), mav.MAV_MISSION_INVALID_PARAM1),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, REL, (473977420, 85455940, -2.0), mav.MAV_MISSION_INVALID_PARAM7),
        (mav.MAV_CMD_NAV_TAKEOFF, (0.0,) * 4, REL, (0, 0, -1.0), mav.MAV_MISSION_INVALID_PARAM7),
        (mav.MAV_CMD_NAV_TAKEOFF, (0.0,) * 4, AMSL, (0, 0, 488.2), mav.MAV_MISSION_INVALID_PARAM7),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, AMSL, (473977420, 85455940, 100.0), mav.MAV_MISSION_INVALID_PARAM7),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, 5, (473977420, 85455940, 488.2), mav.MAV_MISSION_INVALID_PARAM7),
        (mav.MAV_CMD_NAV_LOITER_UNLIM, (0.0,) * 4, LOCAL, (100_000, 0, 0.0), mav.MAV_MISSION_INVALID_PARAM7),
        (mav.MAV_CMD_NAV_WAYPOINT, (0.0,) * 4, LOCAL, (100_000, 0, 5.0), mav.MAV_MISSION_INVALID_PARAM7),
    ],
)
def test_item_that_cannot_be_flown_is_refused_by_name_and_the_old_mission_stays(
    vehicle_bench: Any, command: int, params: Any, frame: int, xyz: Any, result: int
) -> None:
    bench = vehicle_bench()
    assert upload(bench, [waypoint(bench, 1.0, 0.0, 2.0)]) == ACCEPTED
    bad = mav.MAVLink_mission_item_int_message(1, 1, 0, frame, command, 0, 1, *params, *xyz, MISSION)
    assert upload(bench, [waypoint(bench, 2.0, 0.0, 2.0), bad]) == result
    assert len(download(bench)) == 1
    bench.tick()
    assert "item 1" in bench.texts[-1]


def test_the_lowest_height_is_counted_from_home_in_every_frame(vehicle_bench: Any) -> None:
    """0.3 m above a home at 488 m, and above one that was moved to 490 m."""
    bench = vehicle_bench()
    x, y = degrees_e7(bench, 3.0, 0.0)

    def lowest(height_m: float) -> list[Any]:
        places = [(REL, x, y, 0.3), (AMSL, x, y, 488.0 + height_m), (LOCAL, 30_000, 0, -height_m)]
        return [
            mav.MAVLink_mission_item_int_message(
                1, 1, 0, frame, mav.MAV_CMD_NAV_WAYPOINT, 0, 1, 0, 0, 0, 0, *place, MISSION
            )
            for frame, *place in places
        ]

    assert upload(bench, lowest(0.3)) == ACCEPTED
    bench.result(mav.MAV_CMD_DO_SET_HOME, place=(x, y, 490.0), frame=mav.MAV_FRAME_GLOBAL)
    assert upload(bench, lowest(2.3)) == ACCEPTED
    assert upload(bench, lowest(2.2)) == mav.MAV_MISSION_INVALID_PARAM7


@pytest.mark.parametrize(
    ("kind", "command"),
    [
        (MISSION, mav.MAV_CMD_DO_JUMP),
        (FENCE, mav.MAV_CMD_NAV_FENCE_RETURN_POINT),
        (RALLY, mav.MAV_CMD_NAV_WAYPOINT),
    ],
)
def test_item_that_no_plan_can_have_is_refused_when_it_comes(vehicle_bench: Any, kind: int, command: int) -> None:
    bench = vehicle_bench()
    bad = item(bench, command, (5.0, 0.0, 2.0), kind=kind)
    bench.send(mav.MAVLink_mission_count_message(1, 1, 3, kind))
    ack = answer(bench.send(bad))
    assert (ack.get_type(), ack.type, ack.mission_type) == ("MISSION_ACK", mav.MAV_MISSION_UNSUPPORTED, kind)
    assert not [m for m in bench.tick(30) if m.get_type() == "MISSION_REQUEST_INT"]
    assert bench.texts[0].startswith("Plan refused: item 0: ")


@pytest.mark.parametrize(("kind", "count", "result"), [(7, 1, 3), (MISSION, 65000, 4)])
def test_plan_of_unknown_kind_or_too_great_is_refused(vehicle_bench: Any, kind: int, count: int, result: int) -> None:
    ack = answer(vehicle_bench().send(mav.MAVLink_mission_count_message(1, 1, count, kind)))
    assert (ack.get_type(), ack.type, ack.mission_type) == ("MISSION_ACK", result, kind)


def test_item_beyond_the_plan_is_told_to_be_none(vehicle_bench: Any) -> None:
    ack = answer(vehicle_bench().send(mav.MAVLink_mission_request_int_message(1, 1, 0, MISSION)))
    assert (ack.get_type(), ack.type) == ("MISSION_ACK", mav.MAV_MISSION_INVALID_SEQUENCE)


def corners(bench: Any, command: int, places: list[tuple[float, float]]) -> list[Any]:
    params = (float(len(places)), 0.0, 0.0, 0.0)
    return [item(bench, command, (*place, 0.0), params, frame=0, kind=FENCE) for place in places]


SQUARE = [(-5.0, -5.0), (-5.0, 5.0), (5.0, 5.0), (5.0, -5.0)]


@pytest.mark.parametrize(("action", "mode"), [(0, "hold"), (1, "hold"), (2, "hold"), (3, "return")])
def test_breached_fence_does_what_its_parameter_says(vehicle_bench: Any, action: int, mode: str) -> None:
    bench = vehicle_bench(params={"GF_ACTION": action}).in_air()
    fence = corners(bench, mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, SQUARE)
    assert upload(bench, fence, FENCE) == ACCEPTED
    assert len(download(bench, FENCE)) == 4
    bench.vehicle.reposition((15.0, 0.0, -2.5))
    bench.fly(3.5)
    assert bench.vehicle.mode == mode
    told = any("eofence" in text for text in bench.texts)
    assert told == (action > 0)
    if action >= 2:
        assert bench.vehicle.p_ned[0] < 12.5  # from 5 m/s at 2.5 m/s2, and 0.4 s until it is seen and acted on
    bench.fly(6.0)
    assert (bench.vehicle.p_ned[0] > 14.0) == (action < 2)
    healthy = bool(bench.of("SYS_STATUS")[-1].onboard_control_sensors_health & mav.MAV_SYS_STATUS_GEOFENCE)
    assert healthy == (action == 3)


@pytest.mark.parametrize("action", [1, 2, 3])
def test_vehicle_that_stands_outside_its_fence_does_not_arm(vehicle_bench: Any, action: int) -> None:
    bench = vehicle_bench(params={"GF_ACTION": action})
    circle = item(bench, mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, (200.0, 0.0, 0.0), (20.0, 0, 0, 0), kind=FENCE)
    fence, ready = mav.MAV_SYS_STATUS_GEOFENCE, mav.MAV_SYS_STATUS_PREARM_CHECK
    bench.fly(1.0)
    assert bench.of("SYS_STATUS")[-1].onboard_control_sensors_health & (fence | ready) == fence | ready
    assert upload(bench, [circle], FENCE) == ACCEPTED
    for _ in range(2):
        assert bench.arm() == TEMPORARILY_REJECTED
        bench.fly(1.0)
    assert bench.texts == 2 * ["Arming refused: outside the geofence"]
    assert bench.of("SYS_STATUS")[-1].onboard_control_sensors_health & (fence | ready) == 0
    bench.vehicle.parameters.set("GF_ACTION", 0)
    assert bench.arm() == ACCEPTED


def test_vehicle_that_is_armed_by_force_outside_its_fence_is_disarmed_every_time(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    circle = item(bench, mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, (200.0, 0.0, 0.0), (20.0, 0, 0, 0), kind=FENCE)
    assert upload(bench, [circle], FENCE) == ACCEPTED
    for _ in range(2):
        assert bench.result(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, 21196.0) == ACCEPTED
        bench.fly(0.3)
        assert not bench.vehicle.armed
    assert bench.texts == 2 * ["Armed", "Geofence breached", "Failsafe on the ground, disarmed"]


def test_circles_and_exclusions_make_a_fence_too(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    circle = item(bench, mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, (0.0, 0.0, 0.0), (50.0, 0, 0, 0), frame=0, kind=FENCE)
    hole = corners(bench, mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION, [(10.0, 0.0), (20.0, 0.0), (15.0, 10.0)])
    assert upload(bench, [circle, *hole], FENCE) == ACCEPTED
    inside = {p: not bench.vehicle.fence.breached(*p) for p in ((0.0, 0.0), (15.0, 3.0), (15.0, -3.0), (51.0, 0.0))}
    assert inside == {(0.0, 0.0): True, (15.0, 3.0): False, (15.0, -3.0): True, (51.0, 0.0): False}
    assert upload(bench, hole[:2], FENCE) == mav.MAV_MISSION_INVALID
    assert len(download(bench, FENCE)) == 4
    assert answer(bench.send(mav.MAVLink_mission_clear_all_message(1, 1, 255))).type == ACCEPTED
    assert not bench.vehicle.fence.breached(51.0, 0.0)


def test_return_goes_to_the_nearest_rally_point(vehicle_bench: Any) -> None:
    bench = vehicle_bench().in_air()
    points = [item(bench, mav.MAV_CMD_NAV_RALLY_POINT, (n, 0.0, 5.0), (0.0,) * 4, kind=RALLY) for n in (8.0, 60.0)]
    assert upload(bench, points, RALLY) == ACCEPTED
    bench.vehicle.reposition((10.0, 0.0, -2.5))
    bench.fly(6.0)
    bench.result(mav.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    bench.fly(40.0, until=lambda b: not b.vehicle.armed)
    assert bench.vehicle.p_ned == pytest.approx((8.0, 0.0, 0.0), abs=0.35)
