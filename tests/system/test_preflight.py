"""Before the flight: fence and rally points in the vehicles, and who fails its check list stays on the ground."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pymap3d
import pytest
import yaml
from commands import gcs
from hypothesis import given
from hypothesis import strategies as st
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from sessions import Running, fly
from strangers import ARDUCOPTER, SIMVEHICLE, strangers

from gcs.missions import files, qgc_plan
from gcs.missions.items import FenceArea, GlobalPlace, MissionPlan
from gcs.scenario.model import Scenario
from gcs.supervisor.preflight import fence_items, rally_items

ORIGIN = {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0}
TARGET = {
    "sysid": 101,
    "start_m": [0, 0, 0],
    "battery": {"capacity_j": 60000},
    "speed_m_s": 1.5,
    "path_m": [[0, 0, -3], [30, 0, -3]],
}
FENCE = {
    "inside": [{"polygon_m": [[-9, -9], [9, -9], [9, 9], [-9, 9]]}],
    "outside": [{"circle_m": [-6, -6], "radius_m": 1.5}],
}


def scenario(**more: Any) -> dict[str, Any]:
    return {
        "schema": 1, "name": "fenced", "axes": "ned", "origin": ORIGIN, "goal": {"duration_s": 20},
        "vehicles": {"targets": [TARGET]}, "fence": FENCE, "rally_m": [[4, 3], [-4, 3]], **more,
    }  # fmt: skip


def test_items_lie_where_the_ellipsoid_says() -> None:
    made = Scenario.model_validate(scenario())
    fence, rally = fence_items(made), rally_items(made)
    origin = tuple(ORIGIN.values())
    places = [pymap3d.geodetic2ned(1e-7 * i.x, 1e-7 * i.y, origin[2], *origin)[:2] for i in (*fence, *rally)]
    wanted = [(-9, -9), (9, -9), (9, 9), (-9, 9), (-6, -6), (4, 3), (-4, 3)]
    for place, meant in zip(places, wanted, strict=True):
        assert math.dist([float(x) for x in place], meant) < 0.01
    assert [i.param1 for i in fence] == [4.0] * 4 + [1.5]
    inclusion, exclusion = mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, mav.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION
    assert [i.command for i in fence] == [inclusion] * 4 + [exclusion]


def test_no_set_point_leads_beyond_the_fence(tmp_path: Path) -> None:
    """A target whose path leads out to the north, and a pursuer with a keep-out circle between its two way points: by
    their own truth both stay inside, the pursuer gets around, and the target stops near the border."""
    pursuer = {"sysid": 1, "start_m": [-6.0, -8.0, 0.0], "battery": {"capacity_j": 60000},
               "waypoints_m": [[-6.0, -8.0, -3.0], [-6.0, -3.0, -3.0]]}  # fmt: skip
    made = scenario(vehicles={"targets": [TARGET], "pursuers": [pursuer]}, goal={"duration_s": 25})
    flown = fly(made, tmp_path, "--lockstep")
    said = (flown.folder / "session.log").read_text(encoding="utf-8")
    assert "Geofence breached" not in said
    rules = Scenario.model_validate(made).fence
    for sysid in (1, 101):
        for north_m, east_m, _ in flown.truth(sysid).p_ned[::5].tolist():
            assert rules.allows(north_m, east_m), (sysid, north_m, east_m)
    assert 8.0 < flown.truth(101).p_ned[:, 0].max() < 9.0
    assert math.dist(flown.truth(1).p_ned[-1], (-6.0, -3.0, -3.0)) < 0.5


def test_a_launched_vehicle_takes_fence_and_rally_points_and_keeps_the_fence(tmp_path: Path) -> None:
    """Its path leads out of the fence 9 m to the north: there it holds by itself, over a radio that loses. Without the
    safety layer, whose set points would stay inside."""
    flown = fly(scenario(radio={"loss": 0.1}, planner={"safety": False}), tmp_path, "--lockstep")
    checked = {item["key"]: (item["passed"], item["text"]) for item in flown.vehicle(101)["check_list"]}
    assert checked == {
        "fence": (True, "fence uploaded and read back"),
        "rally": (True, "rally points uploaded and read back"),
    }
    said = (flown.folder / "session.log").read_text(encoding="utf-8")
    assert "Check list: fence uploaded and read back; rally points uploaded and read back" in said
    breached_s = next(t for t, m in flown.messages("STATUSTEXT") if m.text == "Geofence breached")
    north_m = [m.x for t, m in flown.messages("LOCAL_POSITION_NED") if abs(t - breached_s) < 0.05]
    assert north_m == [pytest.approx(9.0, abs=0.3)]
    arming = [t for t, m in flown.messages("COMMAND_LONG") if m.command == mav.MAV_CMD_COMPONENT_ARM_DISARM]
    read = [t for t, m in flown.messages("MISSION_ITEM_INT") if m.get_srcSystem() == 101]
    assert max(read) <= min(arming)


def test_an_external_vehicle_that_does_not_answer_stays_on_the_ground(tmp_path: Path) -> None:
    """The scripted ArduCopter knows no missions."""
    port = free_port()
    external = {"connect": f"udpin:127.0.0.1:{port}", "sysid": 3, "capacity_j": 250_000, "arm_within_s": 40}
    made = scenario(rally_m=[], goal={"duration_s": 40}, clock={"mode": "real", "speed": 1})
    made["vehicles"] = {"targets": [{"external": external, "path_m": [[0, 0, -3], [5, 0, -3]], "speed_m_s": 0.5}]}
    running = Running(made, tmp_path, "--json")
    with strangers(tmp_path / "said", [*ARDUCOPTER, "--sysid", "3", "--connect", f"udpout:127.0.0.1:{port}"]):
        try:
            seen = running.wait_for(lambda seen: seen["vehicles"][0]["stage"] == "down")
        finally:
            running.stop()
    assert not seen["vehicles"][0]["armed"]
    texts = (running.folder / "session.log").read_text(encoding="utf-8")
    listed = "fence not answered (no answer, though it was asked 6 times)"
    assert f"Check list: clock right; {listed}" in texts
    assert f"Fails its check list and is not armed: {listed}" in texts


def test_an_autopilot_that_keeps_whole_metres_takes_rally_points_at_any_height(tmp_path: Path) -> None:
    port = free_port()
    external = {"connect": f"udpin:127.0.0.1:{port}", "sysid": 2, "capacity_j": 250_000}
    made = scenario(clock={"mode": "real", "speed": 1}, fence={})
    made["vehicles"] = {"pursuers": [{"external": external, "takeoff_m": 2.5, "waypoints_m": [[0, 4, -3]]}]}
    file = tmp_path / "field.yaml"
    file.write_text(yaml.safe_dump(made), encoding="utf-8")
    with strangers(tmp_path / "said", [*ARDUCOPTER, "--sysid", "2", "--connect", f"udpout:127.0.0.1:{port}"]):
        done = gcs("check", str(file), "--json")
    (found,) = json.loads(done.stdout)["vehicles"]
    rally = next(item for item in found["check_list"] if item["key"] == "rally")
    assert (rally["passed"], rally["text"]) == (True, "rally points uploaded and read back")


@given(takeoff_m=st.floats(0.5, 100.0))
def test_rally_points_lie_in_whole_metres_no_lower_than_a_take_off(takeoff_m: float) -> None:
    made = scenario(vehicles={"targets": [{**TARGET, "takeoff_m": takeoff_m}]})
    for item in rally_items(Scenario.model_validate(made)):
        assert takeoff_m <= item.z < takeoff_m + 1.0
        assert item.z == int(item.z)


def test_the_check_list_is_gone_through_without_a_flight(tmp_path: Path) -> None:
    """A PX4 of ours that is well, a scripted ArduCopter that knows no fence and has one of two links, nobody at all."""
    ports = [free_port() for _ in range(4)]
    at = [f"udpin:127.0.0.1:{port}" for port in ports]
    common = {"capacity_j": 250_000, "found_within_s": 8}
    file = tmp_path / "field.yaml"
    made = scenario(clock={"mode": "real", "speed": 1}, rally_m=[])
    made["vehicles"] = {"pursuers": [
        {"external": {"connect": connect, "sysid": sysid, **common}, "waypoints_m": [[0, 4 * sysid, -3]]}
        for sysid, connect in ((1, at[0]), (2, at[1:3]), (3, at[3]))
    ]}  # fmt: skip
    file.write_text(yaml.safe_dump(made), encoding="utf-8")
    well = [*SIMVEHICLE, "--sysid", "1", "--connect", f"udpout:127.0.0.1:{ports[0]}"]
    copter = [*ARDUCOPTER, "--sysid", "2", "--connect", f"udpout:127.0.0.1:{ports[1]}"]
    with strangers(tmp_path / "said", well, copter):
        done = gcs("check", str(file), "--json")
    found = json.loads(done.stdout)
    assert (done.returncode, found["passed"]) == (1, False)
    lists = {one["sysid"]: {item["key"]: item for item in one["check_list"]} for one in found["vehicles"]}
    assert [one["passed"] for one in found["vehicles"]] == [True, False, False]
    assert lists[1]["fence"]["text"] == "fence uploaded and read back"
    assert [key for key, item in lists[2].items() if not item["passed"]] == ["link", "fence"]
    assert lists[2]["link"]["text"] == f"not heard at {at[2]}"
    assert lists[3].keys() == {"heard"}
    assert f"no HEARTBEAT at {at[3]}" in lists[3]["heard"]["text"]
    assert gcs("check", str(file), "--arm").returncode == 2


def test_plans_that_a_session_replaces_are_kept_in_its_folder(tmp_path: Path) -> None:
    port = free_port()
    corners = ((47.3976, 8.5454), (47.3979, 8.5454), (47.3979, 8.5458))
    before = MissionPlan(fence=(FenceArea(True, corners),), rally=(GlobalPlace(47.3977, 8.5456, 12.0, "home"),))
    file = tmp_path / "before.plan"
    file.write_text(qgc_plan.write(before), encoding="utf-8")
    made = scenario(clock={"mode": "real", "speed": 1}, goal={"duration_s": 8})
    external = {"connect": f"udpin:127.0.0.1:{port}", "sysid": 1, "capacity_j": 250_000}
    made["vehicles"] = {"pursuers": [{"external": external, "waypoints_m": [[0, 4, -3]]}]}
    with strangers(tmp_path / "said", [*SIMVEHICLE, "--sysid", "1", "--connect", f"udpout:127.0.0.1:{port}"]):
        assert gcs("mission", "set", str(file), "--connect", external["connect"]).returncode == 0
        folder = fly(made, tmp_path, "--no-report").folder
    log = (folder / "session.log").read_text(encoding="utf-8")
    assert "fence uploaded and read back, the one before it is in plan-before-1.plan" in log
    kept = files.load(folder / "plan-before-1.plan")
    assert (kept.fence, kept.rally) == (before.fence, before.rally)
