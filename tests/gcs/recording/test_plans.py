"""Missions, fences and rally points in recordings that pymavlink encodes, as replay and `gcs mission` show them."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import autopilot_logs as logs
import pymap3d
import pytest
from commands import gcs
from mission_tapes import ALT_M, AWAY_DEG, LAT_DEG, LON_DEG, STATION, VEHICLE, Tape, north
from pymavlink import mavutil, mavwp
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.session.replay import Replay


@pytest.fixture(autouse=True)
def mavlink_2(monkeypatch: pytest.MonkeyPatch) -> None:
    """pymavlink's loaders write items of the version that it was imported for."""
    monkeypatch.setenv("MAVLINK20", "1")
    mavutil.set_dialect("ardupilotmega")


def plans(path: Path, t_s: float) -> list[dict[str, Any]]:
    replay = Replay(path)
    replay.seek(t_s)
    replay.snapshot(speed=1.0)
    session = replay.session()
    json.dumps(session, allow_nan=False)
    return session.get("plans", [])  # type: ignore[no-any-return]


def test_an_upload_is_shown_from_its_acknowledgement_on(tmp_path: Path) -> None:
    tape = Tape()
    tape.fly(3.0)
    tape.upload([north(1), north(2, 30.0)])
    tape.fly(3.0)
    tape.upload([north(5)], result=mav.MAV_MISSION_DENIED)
    tape.fly(3.0)
    tape.upload([north(3), north(4), north(5)])
    tape.fly(3.0)
    path = tape.write(tmp_path / "flight.tlog")
    assert plans(path, 2.0) == []
    (first,) = plans(path, 5.0)
    assert (first["source"], first["sysid"], first["home_ned"]) == ("vehicle 3", 3, None)
    assert [item["number"] for item in first["items"]] == [0, 1]
    for item, k, height_m in zip(first["items"], (1, 2), (10.0, 30.0), strict=True):
        ned = pymap3d.geodetic2ned(LAT_DEG + k * AWAY_DEG, LON_DEG, ALT_M, LAT_DEG, LON_DEG, ALT_M)
        assert item["p_ned"] == pytest.approx((ned[0], ned[1], -height_m), abs=0.02)
        assert (item["height_m"], item["above"], item["command"]) == (height_m, "home", "NAV_WAYPOINT")
    assert plans(path, 8.0) == [first], "what was denied is not there"
    assert len(plans(path, 11.0)[0]["items"]) == 3


def test_a_replay_that_plays_tells_the_session_anew_when_a_plan_has_come(tmp_path: Path) -> None:
    tape = Tape()
    tape.fly(2.0)
    tape.upload([north(1)])
    tape.fly(2.0)
    replay = Replay(tape.write(tmp_path / "flight.tlog"))
    replay.advance(1.5, math.inf)
    replay.session()
    replay.snapshot(speed=1.0)
    assert not replay.observer.changed
    replay.advance(3.0, math.inf)
    replay.snapshot(speed=1.0)
    assert replay.observer.changed
    assert len(replay.session()["plans"]) == 1
    replay.snapshot(speed=1.0)
    assert not replay.observer.changed


def test_a_download_gives_mission_fence_and_rally_points(tmp_path: Path) -> None:
    """As an ArduPilot has them: item 0 is home, whose height the others are above."""
    tape = Tape(mav.MAV_AUTOPILOT_ARDUPILOTMEGA)
    tape.fly(1.0)
    tape.count(VEHICLE, 4)
    tape.item(VEHICLE, 0, mav.MAV_CMD_NAV_WAYPOINT, 0, north(0, ALT_M + 2.0))
    tape.item(VEHICLE, 1, mav.MAV_CMD_NAV_TAKEOFF, 3, (0.0, 0.0, 20.0))
    tape.item(VEHICLE, 2, mav.MAV_CMD_DO_SET_ROI_LOCATION, 0, north(1, ALT_M))
    tape.item(VEHICLE, 3, mav.MAV_CMD_NAV_WAYPOINT, 3, north(2, 20.0))
    tape.count(VEHICLE, 4, mav.MAV_MISSION_TYPE_FENCE)
    for seq, k in enumerate((1, 2, 3)):
        at = (LAT_DEG + k * AWAY_DEG, LON_DEG + (k % 2) * AWAY_DEG, 0.0)
        tape.item(VEHICLE, seq, mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, 0, at, mav.MAV_MISSION_TYPE_FENCE, 3.0)
    tape.item(VEHICLE, 3, mav.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION, 0, north(1, 0.0), mav.MAV_MISSION_TYPE_FENCE, 25.0)
    tape.count(VEHICLE, 1, mav.MAV_MISSION_TYPE_RALLY)
    tape.item(VEHICLE, 0, mav.MAV_CMD_NAV_RALLY_POINT, 3, north(-1, 15.0), mav.MAV_MISSION_TYPE_RALLY)
    tape.say(VEHICLE, mav.MAVLink_mission_current_message(3))
    tape.fly(1.0)
    path = tape.write(tmp_path / "flight.tlog")
    (shown,) = plans(path, 1.9)
    assert [(item["number"], item["flown"], item["p_ned"] is None) for item in shown["items"]] == [
        (1, True, True), (2, False, False), (3, True, False),
    ]  # fmt: skip
    assert shown["home_ned"] == pytest.approx((0.0, 0.0, -2.0), abs=0.01)
    assert shown["items"][2]["p_ned"][2] == pytest.approx(-22.0)
    assert [(area["inside"], len(area["outline_ne"])) for area in shown["fence"]] == [(True, 4), (False, 73)]
    (middle, _, _) = pymap3d.geodetic2ned(LAT_DEG + AWAY_DEG, LON_DEG, ALT_M, LAT_DEG, LON_DEG, ALT_M)
    for at_north, at_east in shown["fence"][1]["outline_ne"]:
        assert math.hypot(at_north - middle, at_east) == pytest.approx(25.0, abs=0.02)
    assert shown["rally_ned"][0][2] == pytest.approx(-17.0)
    replay = Replay(path)
    replay.advance(1.9, math.inf)
    assert replay.snapshot(speed=1.0)["vehicles"][0]["mission_item"] == 3


def test_home_is_what_the_vehicle_says(tmp_path: Path) -> None:
    tape = Tape()
    tape.fly(1.0)
    at = round(1e7 * LAT_DEG), round(1e7 * LON_DEG), round(1e3 * (ALT_M + 7.0))
    tape.say(VEHICLE, mav.MAVLink_home_position_message(*at, 0, 0, 0, [1, 0, 0, 0], 0, 0, 0))
    tape.upload([north(1, 10.0)])
    tape.fly(1.0)
    (shown,) = plans(tape.write(tmp_path / "flight.tlog"), 1.9)
    assert shown["items"][0]["p_ned"][2] == pytest.approx(-17.0)


def test_parts_orders_and_erasures(tmp_path: Path) -> None:
    tape = Tape()
    tape.fly(1.0)
    tape.item(STATION, 0, mav.MAV_CMD_NAV_WAYPOINT, 3, north(9), current=2)  # ArduPilot's way to go there at once
    tape.upload([north(1), north(2), north(3)])
    tape.fly(1.0)
    tape.say(STATION, mav.MAVLink_mission_write_partial_list_message(*VEHICLE, 1, 1, 0))
    tape.item(STATION, 1, mav.MAV_CMD_NAV_WAYPOINT, 3, north(7))
    tape.ack()
    tape.fly(1.0)
    tape.say(STATION, mav.MAVLink_mission_clear_all_message(*VEHICLE, mav.MAV_MISSION_TYPE_ALL))
    tape.ack(kind=mav.MAV_MISSION_TYPE_ALL)
    tape.fly(1.0)
    path = tape.write(tmp_path / "flight.tlog")
    norths = [item["p_ned"][0] / 111.19 for item in plans(path, 2.5)[0]["items"]]
    assert norths == pytest.approx([1.0, 7.0, 3.0], rel=1e-3)
    assert plans(path, 3.5) == []


def test_a_part_of_a_plan_is_shown_and_named(tmp_path: Path) -> None:
    tape = Tape()
    tape.fly(1.0)
    tape.count(VEHICLE, 5)
    tape.item(VEHICLE, 2, mav.MAV_CMD_NAV_WAYPOINT, 3, north(1))
    tape.fly(1.0)
    (shown,) = plans(tape.write(tmp_path / "flight.tlog"), 1.9)
    assert len(shown["items"]) == 1
    assert shown["left_out"] == ["4 items were not recorded"]


def test_a_dataflash_log_shows_what_it_lists(tmp_path: Path) -> None:
    path = tmp_path / "flight.BIN"
    logs.dataflash(path, mission=True)
    listed = gcs("mission", "show", str(path), "--json")
    assert listed.returncode == 0, listed.stderr
    plan = json.loads(listed.stdout)
    assert plan["source"] == "vehicle 7"
    assert plan["home"]["lat_deg"] == pytest.approx(logs.LAT_DEG, abs=1e-6)
    assert [(item["number"], item["name"], item["frame"]) for item in plan["mission"]] == [
        (1, "NAV_TAKEOFF", "GLOBAL_RELATIVE_ALT"), (2, "NAV_WAYPOINT", "GLOBAL_TERRAIN_ALT"),
    ]  # fmt: skip
    assert plan["mission"][1]["params"][4:] == pytest.approx([logs.LAT_DEG + 0.001, logs.LON_DEG, 25.0])
    assert [(area["inclusion"], len(area["corners_deg"]), area["radius_m"]) for area in plan["fence"]] == [
        (True, 3, None), (False, 1, 30.0),
    ]  # fmt: skip
    assert plan["rally"][0] == {"lat_deg": 47.4, "lon_deg": 8.55, "height_m": 40.0, "above": "home"}
    played = gcs("replay", str(path), "--json")
    snapshots = [line for line in map(json.loads, played.stdout.splitlines()) if line["type"] == "snapshot"]
    assert snapshots[-1]["vehicles"][0]["mission_item"] == 2


@pytest.mark.parametrize(
    ("later", "heights_m", "left_out"),
    [
        (((1, 2, 3), 4), [31.0, 32.0, 33.0], []),
        (((1, 2), 4), [31.0, 32.0], ["one item was not recorded"]),
        (((1, 2), 3), [31.0, 32.0], []),
    ],
)
def test_a_mission_that_came_while_a_log_was_written_is_the_one_whose_items_are_begun(
    tmp_path: Path, later: tuple[tuple[int, ...], int], heights_m: list[float], left_out: list[str]
) -> None:
    """ArduPilot lists a mission when logging begins; of one that is sent then, the log has what is begun."""
    path = tmp_path / "flight.BIN"
    logs.dataflash(path, mission=True, later=later)
    plan = json.loads(gcs("mission", "show", str(path), "--json").stdout)
    assert [item["params"][6] for item in plan["mission"]] == heights_m
    assert plan["left_out"] == left_out
    assert plan["home"]["lat_deg"] == pytest.approx(logs.LAT_DEG, abs=1e-6)


def test_a_recordings_mission_becomes_a_file_that_pymavlink_reads(tmp_path: Path) -> None:
    tape = Tape()
    tape.fly(1.0)
    tape.upload([north(1), north(2)])
    tape.fly(1.0)
    path, out = tape.write(tmp_path / "flight.tlog"), tmp_path / "out.waypoints"
    assert gcs("mission", "show", str(path), "--out", str(out)).returncode == 0
    loader = mavwp.MAVWPLoader()
    assert loader.load(str(out)) == 3
    assert [loader.wp(k).x for k in (1, 2)] == pytest.approx([LAT_DEG + AWAY_DEG, LAT_DEG + 2 * AWAY_DEG], abs=1e-7)
    again = gcs("mission", "show", str(path), "--out", str(out))
    assert again.returncode == 2
    assert "exists already" in again.stderr
