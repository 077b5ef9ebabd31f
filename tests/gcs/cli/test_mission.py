"""`gcs mission show` and `gcs replay --plan`: what is listed and written, and what a mistake is answered by."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
from commands import gcs
from mission_tapes import LAT_DEG, LON_DEG, Tape, north
from pymavlink import mavutil, mavwp

from gcs.cli.mission.show import lines, plain
from gcs.missions.items import MissionItem, MissionPlan


@pytest.fixture(autouse=True)
def mavlink_2(monkeypatch: pytest.MonkeyPatch) -> None:
    """pymavlink's loaders write items of the version that it was imported for."""
    monkeypatch.setenv("MAVLINK20", "1")
    mavutil.set_dialect("ardupilotmega")


MISSION = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.5\t8.5\t500\t1\n1\t0\t3\t22\t15\t0\t0\tnan\t47.5\t8.5\t20\t1\n"
SITE = {
    "fileType": "Plan", "version": 1,
    "geoFence": {"circles": [{"circle": {"center": [47.5, 8.5], "radius": 80}, "inclusion": True}], "version": 2},
    "mission": {
        "items": [
            {"type": "SimpleItem", "command": 16, "frame": 10, "params": [5, 0, 0, None, 47.51, 8.5, 30]},
            {"type": "ComplexItem", "complexItemType": "fwLandingPattern"},
        ],
        "plannedHomePosition": [47.5, 8.5, 500], "version": 2,
    },
    "rallyPoints": {"points": [[47.52, 8.52, 40]], "version": 2},
}  # fmt: skip


@pytest.fixture
def site(tmp_path: Path) -> Path:
    path = tmp_path / "site.plan"
    path.write_text(json.dumps(SITE))
    return path


def test_a_plan_is_listed(site: Path) -> None:
    listed = gcs("mission", "show", str(site))
    assert listed.returncode == 0
    words = [" ".join(line.split()) for line in listed.stdout.splitlines()]
    assert words == [
        f"{site}: 1 mission item, 1 fence area, 1 rally point",
        "home: 47.5000000 8.5000000, 500 m above sea",
        "command latitude longitude height parameters",
        "1 NAV_WAYPOINT 47.5100000 8.5000000 30 m above terrain Hold 5",
        "fence: stay inside the circle of 80 m around 47.5000000 8.5000000",
        "rally point: 47.5200000 8.5200000, 40 m above home",
        "left out: mission.items[1]: a fwLandingPattern, whose items QGroundControl makes when it opens the file",
    ]


def test_a_plan_becomes_way_point_files_and_those_a_plan(site: Path, tmp_path: Path) -> None:
    mission, fence, again = (tmp_path / name for name in ("mission.txt", "fence.txt", "again.plan"))
    many = gcs("mission", "show", str(site), "--out", str(mission))
    assert (many.returncode, mission.exists()) == (2, False)
    assert "there are mission, fence, rally: give --part" in many.stderr
    for path, part in ((mission, "mission"), (fence, "fence")):
        written = gcs("mission", "show", str(site), "--out", str(path), "--part", part)
        assert written.returncode == 0
        assert "fwLandingPattern" in written.stderr
    loader = mavwp.MAVWPLoader()
    assert loader.load(str(mission)) == 2
    assert (loader.wp(1).frame, loader.wp(1).param1, loader.wp(1).x, loader.wp(1).z) == (10, 5.0, 47.51, 30.0)
    assert (loader.wp(0).x, loader.wp(0).y, loader.wp(0).z) == (47.5, 8.5, 500.0)
    assert loader.load(str(fence)) == 1
    assert (loader.wp(0).command, loader.wp(0).param1) == (5003, 80.0)
    assert gcs("mission", "show", str(mission), "--out", str(again)).returncode == 0
    back = json.loads(again.read_text())
    assert back["mission"]["items"][0]["params"] == [5.0, 0.0, 0.0, None, 47.51, 8.5, 30.0]
    assert back["mission"]["plannedHomePosition"] == [47.5, 8.5, 500.0]


def test_mistakes_are_answered_by_a_sentence(site: Path, tmp_path: Path) -> None:
    tape = Tape()
    tape.fly(1.0)
    flight, empty = tape.write(tmp_path / "flight.tlog"), tmp_path / "empty.tlog"
    empty.write_bytes(b"")
    broken = tmp_path / "broken.txt"
    broken.write_text(MISSION.replace("22", "x"))
    fence = tmp_path / "fence.txt"
    assert gcs("mission", "show", str(site), "--out", str(fence), "--part", "fence").returncode == 0
    cases = [
        (("mission", "show", str(tmp_path / "none.plan")), "none.plan"),
        (("mission", "show", str(broken)), "broken.txt: line 3: command is 'x', no whole number."),
        (("mission", "show", str(flight)), "flight.tlog holds no mission, geofence or rally point."),
        (("mission", "show", str(flight), "--sysid", "3"), "holds no mission, geofence or rally point of vehicle 3."),
        (("mission", "show", str(empty)), "holds no mission"),
        (("mission", "show", str(tmp_path)), "session.tlog"),
        (("replay", str(flight), "--plan", str(broken), "--json"), "broken.txt: line 3: command is 'x'"),
        (("replay", str(flight), "--plan", str(tmp_path / "no.plan"), "--json"), "no.plan: No such file or directory."),
        (("replay", str(site), "--json"), f"gcs replay RECORDING --plan {site}"),
        (("replay", str(flight), "--plan", str(site), "--decide"), "leave out --speed, --from, --web, --foxglove and"),
        (("mission", str(site)), f"site.plan is no command: `gcs mission show {site}` lists the plan in a file."),
        (("mission", "site"), "No such command 'site'."),
        (("mission", "set", str(site)), "is not understood whole, and no vehicle gets a part of it: mission.items[1]"),
        (("mission", "diff", str(fence), "--part", "rally"), "fence.txt holds no rally"),
        (("mission", "set", str(tmp_path / "none.plan")), "none.plan: No such file or directory"),
    ]
    for command, words in cases:
        refused = gcs(*command)
        said = " ".join(refused.stderr.split())
        assert refused.returncode == 2, (command, said)
        assert words in said, (command, said)
        assert "Traceback" not in said


def test_a_recording_is_listed_by_vehicle(tmp_path: Path) -> None:
    tape = Tape()
    tape.fly(1.0)
    tape.upload([north(1)])
    path = tape.write(tmp_path / "one.tlog")
    listed = " ".join(gcs("mission", "show", str(path)).stdout.split())
    assert listed.startswith("vehicle 3: 1 mission item")
    assert f"1 NAV_WAYPOINT {LAT_DEG + 0.001:.7f} {LON_DEG:.7f} 10 m above home" in listed
    chosen = gcs("mission", "show", str(path), "--sysid", "3", "--json")
    assert json.loads(chosen.stdout)["source"] == "vehicle 3"
    assert gcs("mission", "show", str(path), "--sysid", "4").returncode == 2


def test_items_of_a_vehicle_that_counts_from_0_are_listed_from_1() -> None:
    way = MissionItem(16, 3, (0.0, 0.0, 0.0, math.nan, LAT_DEG, LON_DEG, 10.0))
    jump = MissionItem(177, 2, (0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0))  # to the first item
    plan = MissionPlan(mission=(way, jump), first=0)
    assert [(row["number"], row["params"][0]) for row in plain("vehicle 3", plan)["mission"]] == [(1, 0.0), (2, 1.0)]
    rows = [line.split() for line in lines("vehicle 3", plan)]
    assert [row[:2] for row in rows[-2:]] == [["1", "NAV_WAYPOINT"], ["2", "DO_JUMP"]]
