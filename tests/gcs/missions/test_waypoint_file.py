"""QGC WPL 110 against pymavlink's own readers and writers."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink import mavutil, mavwp
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.missions import waypoint_file
from gcs.missions.errors import MissionFileError
from gcs.missions.files import load, read
from gcs.missions.items import (
    FENCE_COMMANDS,
    GLOBAL,
    GlobalPlace,
    MissionItem,
    MissionPlan,
    fence_items,
    mission_items,
    rally_items,
)

FRAMES = sorted(set(mav.enums["MAV_FRAME"]) - {mav.MAV_FRAME_ENUM_END})
COMMANDS = sorted(
    command
    for command in mav.enums["MAV_CMD"]
    if command not in FENCE_COMMANDS and command not in (mav.MAV_CMD_NAV_RALLY_POINT, mav.MAV_CMD_ENUM_END)
)


@pytest.fixture(autouse=True)
def mavlink_2(monkeypatch: pytest.MonkeyPatch) -> None:
    """pymavlink's loaders write items of the version that it was imported for."""
    monkeypatch.setenv("MAVLINK20", "1")
    mavutil.set_dialect("ardupilotmega")


MICRO = 1e-6


def micros(most: float) -> st.SearchStrategy[float]:
    """Numbers that pymavlink's six decimals hold."""
    return st.integers(round(-most / MICRO), round(most / MICRO)).map(lambda n: float(f"{n * MICRO:.6f}"))


@st.composite
def items(draw: st.DrawFn) -> MissionItem:
    frame, command = draw(st.sampled_from(FRAMES)), draw(st.sampled_from(COMMANDS))
    p1, p2, p3, p4 = (draw(micros(1e4)) for _ in range(4))
    params = (p1, p2, p3, p4, draw(micros(90.0)), draw(micros(180.0)), draw(micros(9e3)))
    return MissionItem(command, frame, params, autocontinue=draw(st.booleans()), current=draw(st.booleans()))


def theirs(item: MissionItem, seq: int) -> Any:
    numbers = item.params[:4], item.params[4:]
    flags = int(item.current), int(item.autocontinue)
    return mavutil.mavlink.MAVLink_mission_item_message(
        1, 1, seq, item.frame, item.command, *flags, *numbers[0], *numbers[1]
    )


def values(message: Any) -> tuple[Any, ...]:
    at = ("param1", "param2", "param3", "param4", "x", "y", "z")
    flags = bool(message.autocontinue), bool(message.current)
    return (message.command, message.frame, tuple(float(getattr(message, name)) for name in at), *flags)


@given(st.lists(items(), max_size=12))
@settings(deadline=None, max_examples=25)
def test_what_pymavlink_writes_is_read_with_its_values(
    tmp_path_factory: pytest.TempPathFactory, mission: list[MissionItem]
) -> None:
    loader = mavwp.MAVWPLoader()
    loader.add(theirs(MissionItem(16, 0, (0.0, 0.0, 0.0, 0.0, -35.363262, 149.165237, 584.0)), 0))
    for seq, item in enumerate(mission, 1):
        loader.add(theirs(item, seq))
    path = tmp_path_factory.mktemp("wpl") / "mission.txt"
    loader.save(str(path))
    plan = load(path)
    assert plan.home == (-35.363262, 149.165237, 584.0, "sea")
    assert [tuple(item) for item in plan.mission] == [values(loader.wp(k)) for k in range(1, loader.count())]


@given(st.lists(items(), max_size=12))
@settings(deadline=None, max_examples=25)
def test_what_is_written_is_read_by_pymavlink_with_equal_values(
    tmp_path_factory: pytest.TempPathFactory, mission: list[MissionItem]
) -> None:
    exact = [item._replace(params=tuple(value / 3.0 for value in item.params)) for item in mission]
    path = tmp_path_factory.mktemp("wpl") / "mission.waypoints"
    path.write_text(waypoint_file.write(mission_items(MissionPlan(tuple(exact)))))
    loader = mavwp.MAVWPLoader()
    assert loader.load(str(path)) == 1 + len(mission)
    assert [values(loader.wp(k)) for k in range(1, loader.count())] == [tuple(item) for item in exact]
    assert load(path).mission == tuple(exact)


@pytest.mark.parametrize("frame", FRAMES)
def test_every_command_is_named_and_placed_as_the_dialect_has_it(frame: int) -> None:
    listed = [MissionItem(command, frame, (1.0, 2.0, 3.0, 4.0, 47.5, 8.25, 30.0)) for command in COMMANDS]
    plan = read(waypoint_file.write([*mission_items(MissionPlan()), *listed]).encode(), "all")
    assert plan.mission == tuple(listed)
    for item in plan.mission:
        entry = mav.enums["MAV_CMD"][item.command]
        assert f"MAV_CMD_{item.name}" == entry.name
        assert f"MAV_FRAME_{item.frame_name}" == mav.enums["MAV_FRAME"][frame].name
        places = {0: "sea", 5: "sea", 3: "home", 6: "home", 10: "terrain", 11: "terrain"}
        if not entry.has_location:
            assert item.place is None
        elif frame in places:
            assert item.place == (47.5, 8.25, 30.0, places[frame])
        else:
            local = {1: ((47.5, 8.25, 30.0),), 4: ((8.25, 47.5, -30.0),)}
            assert item.place == local.get(frame)


def test_nowhere_is_no_place() -> None:
    for x, y in ((0.0, 0.0), (math.nan, math.nan)):
        assert MissionItem(mav.MAV_CMD_NAV_LAND, 3, (0.0, 0.0, 0.0, 0.0, x, y, 0.0)).place is None
    assert MissionItem(31999, 3, (0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0)).name == "command 31999"
    assert MissionItem(16, 30, (0.0,) * 7).frame_name == "frame 30"


FENCE = """QGC WPL 110
# return point
0\t0\t0\t5000\t0\t0\t0\t0\t-35.1\t149.1\t0\t0
1\t0\t0\t5001\t3\t0\t0\t0\t-35.0\t149.0\t0\t0
2\t0\t0\t5001\t3\t0\t0\t0\t-35.0\t149.2\t0\t0
3\t0\t0\t5001\t3\t0\t0\t0\t-35.2\t149.1\t0\t0

4\t0\t3\t5002\t4\t0\t0\t0\t-35.01\t149.01\t0\t0
5\t0\t3\t5002\t4\t0\t0\t0\t-35.01\t149.02\t0\t0
6\t0\t3\t5002\t4\t0\t0\t0\t-35.02\t149.02\t0\t0
7\t0\t3\t5002\t4\t0\t0\t0\t-35.02\t149.01\t0\t0
8\t0\t0\t5003\t250.5\t0\t0\t0\t-35.1\t149.1\t0\t0
9\t0\t0\t5004\t20\t0\t0\t0\t-35.1\t149.15\t0\t0
"""


def test_a_fence_is_areas_and_written_as_its_items(tmp_path: Path) -> None:
    plan = read(FENCE.encode(), "fence")
    assert [(area.inclusion, len(area.corners_deg), area.radius_m) for area in plan.fence] == [
        (True, 3, None), (False, 4, None), (True, 1, 250.5), (False, 1, 20.0),
    ]  # fmt: skip
    assert plan.fence[0].corners_deg == ((-35.0, 149.0), (-35.0, 149.2), (-35.2, 149.1))
    assert plan.fence_return == (-35.1, 149.1)
    assert not plan.mission
    path = tmp_path / "fence.txt"
    path.write_text(waypoint_file.write(fence_items(plan)))
    loader = mavwp.MAVWPLoader()
    loader.load(str(path))
    written = [(item.command, item.param1, item.x, item.y) for item in map(loader.wp, range(loader.count()))]
    assert written == [
        (int(words[3]), float(words[4]), float(words[8]), float(words[9]))
        for words in (line.split() for line in FENCE.splitlines()[1:])
        if words and words[0] != "#"
    ]
    assert load(path) == plan


def test_rally_points_are_read_and_written(tmp_path: Path) -> None:
    text = "QGC WPL 110\n0\t0\t3\t5100\t0\t0\t0\t0\t47.5\t8.5\t40\t0\n1\t0\t0\t5100\t0\t0\t0\t0\t47.6\t8.6\t540\t0\n"
    plan = read(text.encode(), "rally")
    assert plan.rally == (GlobalPlace(47.5, 8.5, 40.0, "home"), GlobalPlace(47.6, 8.6, 540.0, "sea"))
    path = tmp_path / "rally.txt"
    path.write_text(waypoint_file.write(rally_items(plan)))
    loader = mavwp.MAVWPLoader()
    loader.load(str(path))
    assert [(wp.frame, wp.x, wp.y, wp.z) for wp in map(loader.wp, range(2))] == [
        (3, 47.5, 8.5, 40),
        (0, 47.6, 8.6, 540),
    ]


def test_older_lists_are_read_as_pymavlink_writes_them(tmp_path: Path) -> None:
    fence, rally = tmp_path / "fence.txt", tmp_path / "rally.txt"
    points = [(-35.36372, 149.163651), (-35.358795, 149.164734), (-35.359211, 149.160767), (-35.3681, 149.1613)]
    old_fence = mavwp.MAVFenceLoader(1, 1)
    for lat, lon in [*points, points[1]]:
        old_fence.add_latlon(lat, lon)
    old_fence.save(str(fence))
    old_rally = mavwp.MAVRallyLoader(1, 1)
    old_rally.create_and_append_rally_point(round(-35.3631 * 1e7), round(149.1641 * 1e7), 60, 40, 0, 0)
    old_rally.save(str(rally))
    plan = load(fence)
    assert plan.fence_return == pytest.approx(points[0])
    assert len(plan.fence) == 1
    assert plan.fence[0].inclusion
    assert [pytest.approx(corner) for corner in plan.fence[0].corners_deg] == points[1:]
    assert load(rally).rally == (GlobalPlace(pytest.approx(-35.3631), pytest.approx(149.1641), 60.0, "home"),)


def test_home_is_the_first_item_of_110_only() -> None:
    row = "0\t1\t0\t16\t0\t0\t0\t0\t47.5\t8.5\t500\t1\n"
    assert read(f"QGC WPL 110\n{row}".encode(), "a").home == (47.5, 8.5, 500.0, "sea")
    older = read(f"QGC WPL 120\n{row}".encode(), "a")
    assert older.home is None
    assert (len(older.mission), older.first) == (1, 0)
    planner = read(b"QGC WPL 110\r\n0\t1\t0\t0\t0\t0\t0\t0\t47.5\t8.5\t500\t1\r\n", "a")
    assert planner.home == (47.5, 8.5, 500.0, "sea"), "Mission Planner writes home as command 0"
    assert read(b"QGC WPL 110\n0 1 5 22 0 0 0 0 47.4 8.5 15 1\n", "a").mission[0].command == 22, "no way point"


GOOD = "0\t1\t0\t16\t0\t0\t0\t0\t47.5\t8.5\t500\t1"


@pytest.mark.parametrize(("text", "words"), [
    ("", "neither a QGroundControl plan nor a way point file"),
    ("QGC WPL 100\n", "line 1: version 100 is not read, only 110 and 120"),
    ("QGC WPL\n", "line 1: version  is not read"),
    (f"QGC WPL 110\n{GOOD}\n1\t0\t3\n", "line 3: an item has 12 fields, this one 3"),
    (f"QGC WPL 110\n#\n\n{GOOD.replace('8.5', '8,5')}\n", "line 4: y is '8,5', no number"),
    (f"QGC WPL 110\n{GOOD.replace('16', '16.5')}\n", "line 2: command is '16.5', no whole number"),
    (f"QGC WPL 110\n{GOOD.replace('16', '-1')}\n", "line 2: command is -1, not from 0 to 65535"),
    (f"QGC WPL 110\n{GOOD.replace('500', 'inf')}\n", "line 2: z is inf, not finite"),
    (f"QGC WPL 110\n{GOOD.replace('47.5', '97.5')}\n", "line 2: 97.5, 8.5 are no latitude and longitude"),
    (FENCE.replace("5002\t4", "5002\t2"), "line 8: a polygon has 2 corners, not 3 or more"),
    (FENCE.replace("5002\t4", "5002\t5"), "line 11: a polygon of 5 corners ends after 4"),
    (FENCE.replace("5001\t3\t0\t0\t0\t-35.2", "5002\t4\t0\t0\t0\t-35.2"), "line 5: a polygon of 3 .* ends after 2"),
    (FENCE.replace("250.5", "0"), "line 12: a circle's radius is 0 m"),
    (FENCE.replace("250.5", "nan"), "line 12: a circle's radius is nan m"),
    ("QGC WPL 110\n0 0 1 5100 0 0 0 0 1 2 3 0\n", "line 2: a rally point has no place in LOCAL_NED"),
    ("RALLY 47.5 8.5 20\n", "line 1: a line has 6 numbers"),
    ("RALLY 47.5 8.5 20 10 0 0\nRALLY x 8.5 20 10 0 0\n", "line 2: .* are no numbers"),
    ("47.5 8.5\n47.5 8.6\n47.6 8.6\n47.5 8.6\n", "a fence is a return point, 3 corners or more"),
    ("47.5 8.5\n47.5 8.6 3\n", "line 2: a line has 2 numbers"),
])  # fmt: skip
def test_a_broken_file_is_one_sentence_with_its_line(text: str, words: str) -> None:
    with pytest.raises(MissionFileError) as raised:
        read(text.encode(), "site.txt")
    assert re.search(words, str(raised.value)), str(raised.value)
    assert str(raised.value).startswith("site.txt")
    assert str(raised.value).count(". ") == 0


def test_frames_of_the_table_are_the_dialects_global_ones() -> None:
    assert {mav.enums["MAV_FRAME"][frame].name for frame in GLOBAL} == {
        entry.name for entry in mav.enums["MAV_FRAME"].values() if entry.name.startswith("MAV_FRAME_GLOBAL")
    }
