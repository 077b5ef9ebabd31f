"""`gcs mission` over nine vehicles at once: three that keep items as an ArduCopter, three as PX4s of two generations,
and three of ours. Some answer late and twice, or speak with another ground station meanwhile; pairs share a socket."""

from __future__ import annotations

import contextlib
import json
import math
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import plan_station
import pytest
from commands import gcs
from ports import free_port
from sessions import ROOT
from strangers import SIMVEHICLE, strangers
from survey_plans import LAND, LAT_DEG, LON_DEG, SPEED, TAKEOFF, WAYPOINT, item, plan

from gcs.link.fleet_client import FleetClient

HOLDER = [sys.executable, str(ROOT / "tests" / "peers" / "plan_holder.py")]
ARDUPILOTS, PX4S, OURS = (11, 12, 13), (21, 22, 23), (1, 2, 3)
ALL = (*OURS, *ARDUPILOTS, *PX4S)
WITH_HOME = {2, *ARDUPILOTS}


@pytest.fixture
def site(tmp_path: Path) -> Path:
    path = tmp_path / "site.plan"
    path.write_text(json.dumps(plan()))
    return path


class Missions:
    """The command at the port of the nine."""

    def __init__(self, port: int, sysids: tuple[int, ...]) -> None:
        self.port, self.sysids = port, sysids

    def __call__(self, *argv: str, sysids: tuple[int, ...] = ()) -> Any:
        only = [word for sysid in sysids or self.sysids for word in ("--sysid", str(sysid))]
        return gcs("mission", *argv, "--connect", f"udpin:127.0.0.1:{self.port}", "--wait", "40", *only)


@contextlib.contextmanager
def holders(folder: Path, *lines: tuple[int, str], ours: bool = False) -> Iterator[Missions]:
    port = free_port()
    commands = [[*HOLDER, "--port", str(port), "--sysid", str(sysid), *words.split()] for sysid, words in lines]
    sysids = [one for sysid, words in lines for one in (sysid, sysid + 1)[: 1 + ("--shared" in words)]]
    identities = zip(OURS, ("px4", "ardupilot", "generic"), strict=True) if ours else ()
    for sysid, identity in identities:
        to = ["--connect", f"udpout:127.0.0.1:{port}", "--autopilot", identity, "--sysid", str(sysid)]
        commands.append([*SIMVEHICLE, *to])
    with strangers(folder, *commands):
        yield Missions(port, (*(OURS if ours else ()), *sysids))


@pytest.fixture(scope="module")
def missions(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Missions]:
    lines = (
        (11, "--autopilot ardupilot --shared --late 0.01"),
        (13, "--autopilot ardupilot --strays --late 0.05"),
        (21, "--autopilot px4 --shared --strays"),
        (23, "--autopilot px4 --new --late 0.05 --strays"),
    )
    with holders(tmp_path_factory.mktemp("nine"), *lines, ours=True) as nine:
        yield nine


def by_qgroundcontrol(own: dict[str, Any], *, home: bool) -> list[Sequence[Any]]:
    """Items of a plan's mission as QGroundControl sends them, to an ArduPilot behind its home."""
    first = [(0, WAYPOINT, 0, 1, 0.0, 0.0, 0.0, 0.0, round(1e7 * LAT_DEG), round(1e7 * LON_DEG), 488.0)] if home else []
    for one in own["mission"]["items"]:
        unset, scale = (0.0, 1.0) if one["frame"] == 2 else (math.nan, 1e7)
        *params, x, y, z = [unset if number is None else float(number) for number in one["params"]]
        first.append((one["frame"], one["command"], 0, 1, *params, round(scale * x), round(scale * y), z))
    return [(*item[:2], int(k == 0), *item[3:]) for k, item in enumerate(first)]


def test_one_plan_of_twenty_items_reads_equal_on_all_nine(missions: Missions, site: Path) -> None:
    done = missions("set", str(site))
    assert done.returncode == 0, done.stdout + done.stderr
    lines = {tuple(line.split()[:2]): line for line in done.stdout.splitlines()}
    assert len(lines) == 27
    assert all("items uploaded, read back equal" in line for line in lines.values())
    for sysid in PX4S:
        words = "20 items uploaded, read back equal; not kept as given: item 1 NAV_TAKEOFF: Pitch 15 is 0"
        assert lines[str(sysid), "mission"].endswith(words)
    for sysid in ARDUPILOTS:
        assert "; not kept as given: item 4 NAV_WAYPOINT: Accept Radius 2 is 0;" in lines[str(sysid), "mission"]
    again = missions("set", str(site))
    assert again.returncode == 0
    assert again.stdout.count("there already") == 27
    same = missions("diff", str(site))
    assert (same.returncode, same.stdout) == (0, "".join(f"vehicle {s}: no difference\n" for s in ALL))


def test_qgroundcontrols_sequence_reads_what_was_written(missions: Missions, site: Path) -> None:
    assert missions("set", str(site)).returncode == 0
    items = plan()["mission"]["items"]
    reads = [plan_station.exchange(missions.port, kind, dict.fromkeys(ALL)) for kind in (0, 1, 2)]
    for sysid in ALL:
        mission, fence, rally = (of[sysid] for of in reads)
        read = mission[sysid in WITH_HOME :]
        assert [one.command for one in read] == [one["command"] for one in items]
        for one, own in zip(read, items, strict=True):
            lat_deg, lon_deg, height_m = own["params"][4:]
            if own["frame"] == 2:
                assert one.param2 == own["params"][1]
                continue
            assert (one.x, one.y) == (round(1e7 * lat_deg), round(1e7 * lon_deg))
            assert one.z == pytest.approx(height_m, abs=0.011)
            assert one.frame in ((3, 6) if own["frame"] == 3 else (0, 5))
            assert one.param1 == own["params"][0] or own["command"] == TAKEOFF
            if own["params"][3] == -90.0 and sysid not in ARDUPILOTS:
                assert math.cos(math.radians(one.param4 + 90.0)) == pytest.approx(1.0)
        assert [point.z for point in rally] == [30.0, 41.0 if sysid in WITH_HOME else 40.25]
        assert [one.param1 for one in fence] == [3.0, 3.0, 3.0, 900.5]


def test_a_mission_of_one_vehicle_never_shows_at_another(missions: Missions, tmp_path: Path) -> None:
    """Each has another mission, of QGroundControl's sequence, which writes all nine at once; their answers come
    interleaved, late, twice, and between answers to another station."""
    plans = {sysid: plan(1e-5 * sysid) for sysid in ALL}
    for sysid, own in plans.items():
        takeoff = own["mission"]["items"][0]
        takeoff["params"] = (0, *takeoff["params"][1:])  # a PX4 refuses a pitch
        (tmp_path / f"{sysid}.plan").write_text(json.dumps(own))
    written = {sysid: by_qgroundcontrol(own, home=sysid in WITH_HOME) for sysid, own in plans.items()}
    plan_station.exchange(missions.port, 0, written)
    for _ in range(3):
        got = json.loads(missions("get", "--part", "mission", "--json").stdout)["vehicles"]
        assert got.keys() == set(map(str, ALL))
        for sysid in ALL:
            lats = [
                one["params"][4] for one in got[str(sysid)]["mission"] if one["name"] in ("NAV_WAYPOINT", "NAV_LAND")
            ]
            own = [one["params"][4] for one in plans[sysid]["mission"]["items"] if one["command"] in (16, 21)]
            assert lats == pytest.approx(own, abs=2e-7)
            assert all(one["params"][6] != 1000.0 for one in got[str(sysid)]["mission"])
    for sysid, read in plan_station.exchange(missions.port, 0, dict.fromkeys(ALL)).items():
        own_home = int(sysid in WITH_HOME)
        assert [(one.command, one.x) for one in read[own_home:] if one.command in (WAYPOINT, LAND)] == [
            (item[1], item[8]) for item in written[sysid][own_home:] if item[1] in (WAYPOINT, LAND)
        ]
    differs = missions("diff", str(tmp_path / "11.plan"), "--json")
    assert differs.returncode == 1
    rows = json.loads(differs.stdout)["differences"]
    assert [sysid for sysid, parts in rows.items() if not parts["mission"]] == ["11"]


def test_plans_go_to_files_from_which_they_read_equal(missions: Missions, site: Path, tmp_path: Path) -> None:
    assert missions("set", str(site)).returncode == 0
    folder = tmp_path / "plans"
    got = missions("get", "--out", str(folder))
    assert got.returncode == 0, got.stderr
    assert sorted(path.name for path in folder.iterdir()) == sorted(f"vehicle-{sysid}.plan" for sysid in ALL)
    for sysid in (11, 21, 1):
        same = missions("diff", str(folder / f"vehicle-{sysid}.plan"), sysids=(sysid,))
        assert (same.returncode, same.stdout) == (0, f"vehicle {sysid}: no difference\n"), same.stderr
    homes = [
        json.loads((folder / f"vehicle-{sysid}.plan").read_text())["mission"]["plannedHomePosition"] for sysid in OURS
    ]
    assert homes == [pytest.approx([LAT_DEG, LON_DEG, 488.0], abs=1e-3)] * len(OURS)
    no_home = gcs("mission", "show", str(folder / "vehicle-21.plan")).stdout
    assert "home: not known" in no_home
    one, way_points = tmp_path / "one.plan", tmp_path / "mission.txt"
    assert missions("get", "--out", str(one), sysids=(11,)).stdout.endswith(f", in {one}\n")
    assert json.loads(one.read_text())["mission"]["items"][1]["command"] == SPEED
    assert missions("get", "--out", str(way_points), "--part", "mission", sysids=(11,)).returncode == 0
    assert missions("set", str(way_points), sysids=(12, 13)).stdout.count("20 items, there already") == 2
    for argv in (("get", "--out", str(one)), ("get", "--out", str(folder))):
        refused = missions(*argv, sysids=(11,))
        assert (refused.returncode, refused.stderr.count("exists already and is left as it is")) == (2, 1)
    several = missions("get", "--out", str(tmp_path / "new.plan"), sysids=(11, 12))
    assert "is one file, and there are vehicles 11, 12: name a folder" in several.stderr


def test_a_part_is_cleared_and_the_others_stay(missions: Missions, site: Path) -> None:
    assert missions("set", str(site)).returncode == 0
    cleared = missions("clear", "--part", "fence")
    assert cleared.returncode == 0, cleared.stdout
    assert cleared.stdout.count("fence    cleared, read back") == 9
    assert missions("clear", "--part", "fence").stdout.count("there was none") == 9
    differs = missions("diff", str(site))
    assert differs.stdout == "".join(f"vehicle {sysid}: fence: it has 0 items, the file 4\n" for sysid in ALL)
    assert (differs.returncode, plan_station.exchange(missions.port, 1, {2: None})) == (1, {2: []})
    assert missions("clear", "--station", "245/25").returncode == 0
    assert missions("get", sysids=(2, 11, 21)).stdout == "".join(f"vehicle {s}: nothing\n" for s in (2, 11, 21))


def test_an_items_differences_are_named(missions: Missions, tmp_path: Path, site: Path) -> None:
    assert missions("set", str(site), sysids=(1, 11, 23)).returncode == 0
    other = plan()
    items = other["mission"]["items"]
    items[2]["params"] = (9, *items[2]["params"][1:6], 33.5)
    items[9]["command"], items[9]["params"] = WAYPOINT, (0, 0, 0, 0, LAT_DEG, LON_DEG, 1)
    path = tmp_path / "other.plan"
    path.write_text(json.dumps(other))
    differs = missions("diff", str(path), "--part", "mission", sysids=(1, 11, 23))
    words = "item 3 NAV_WAYPOINT: Hold 9 is 0; item 3 NAV_WAYPOINT: Altitude 33.5 is 20; item 10 NAV_WAYPOINT: command"
    said = differs.stdout.splitlines()
    assert said == [f"vehicle {s}: mission: {words} NAV_WAYPOINT is NAV_DELAY" for s in (1, 11, 23)]
    assert differs.returncode == 1


def test_a_hold_that_is_cut_down_is_named_beside_all_that_is_there(tmp_path: Path) -> None:
    other = plan()
    other["mission"]["items"][2]["params"] = (2.5, *other["mission"]["items"][2]["params"][1:])
    path = tmp_path / "held.plan"
    path.write_text(json.dumps(other))
    with holders(tmp_path, (11, "--autopilot ardupilot")) as missions:
        done = missions("set", str(path), "--part", "mission")
    assert done.returncode == 1
    words = (
        " 11  mission  differs: all 20 items are on the vehicle; not kept as given: item 3 NAV_WAYPOINT: Hold 2.5 is 2;"
    )
    assert done.stdout.startswith(words)


def test_an_item_that_is_not_supported_leaves_the_old_mission(
    missions: Missions, site: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert missions("set", str(site), "--part", "mission", sysids=(11,)).returncode == 0
    other = plan()
    other["mission"]["items"][3]["command"] = 16999
    path = tmp_path / "bad.plan"
    path.write_text(json.dumps(other))
    done = missions("set", str(path), "--part", "mission", sysids=(11,))
    assert done.returncode == 1
    assert done.stdout == (
        " 11  mission  unsupported: it answered MAV_MISSION_UNSUPPORTED to item 4, command 16999; "
        "it still has its old plan, 20 items\n"
    )

    def pressed(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(FleetClient, "exchange", pressed)
    stopped = missions("set", str(site), "--part", "mission", sysids=(11, 12))
    assert stopped.returncode == 130
    assert stopped.stderr.rstrip().endswith("gcs: interrupted: vehicle 11 mission, vehicle 12 mission: as it was")
    assert "interrupted" not in missions("get", sysids=(11,)).stderr  # which changes nothing


def test_a_refusal_is_a_sentence(tmp_path: Path) -> None:
    """What a vehicle answers that has no room, is being written to, or takes no such item, in the air or not."""
    lines = (
        (11, "--autopilot ardupilot --room 10"),
        (12, "--autopilot ardupilot --busy"),
        (14, "--autopilot ardupilot --armed"),
        (21, "--autopilot px4"),
        (23, "--autopilot px4 --new"),
    )
    other = plan()
    other["mission"]["items"][3]["params"] = (0, 0, 7, None, LAT_DEG, LON_DEG, 20)
    other["mission"]["items"][1]["params"] = (1, 4.5, -1, 1, 0, 0, 0)  # relative, to which PX4 pays no heed
    other["mission"]["items"].append(item(177, 2, 5, 0, 0, 0, 0, 0, frame=2))
    path = tmp_path / "passing.plan"
    path.write_text(json.dumps(other))
    with holders(tmp_path, *lines) as missions:
        done = missions("set", str(path), "--part", "mission")
        jump = plan_station.exchange(missions.port, 0, {21: None})[21][20]
        fence = missions("set", str(path), "--part", "fence", sysids=(11,))
        cleared = missions("clear", "--part", "mission", sysids=(14,))
    assert done.returncode == 1
    said = done.stdout.splitlines()
    assert said[0] == (" 11  mission  refused: it answered MAV_MISSION_NO_SPACE: it has no room for so many items")
    assert said[1] == " 12  mission  refused: it answered MAV_MISSION_DENIED: another ground station is writing to it"
    assert "21 items uploaded, read back equal" in said[2]
    assert "21 items uploaded, read back equal" in said[3]
    assert said[3].endswith("item 4 NAV_WAYPOINT: Pass Radius 7 is 0")
    words = "refused: it answered MAV_MISSION_INVALID_PARAM4 to item 2, DO_CHANGE_SPEED; it has none, as before"
    assert said[4] == f" 23  mission  {words}"
    assert "gcs: vehicle 14 is armed: if it flies by its plan, that changes under way.\n" in done.stderr
    assert (jump.command, jump.param1) == (177, 1.0)  # item 2 of the file has number 1 where there is no home
    assert fence.returncode == 0
    busy = "it answered MAV_MISSION_ERROR: it is busy with another transfer, or flies this mission"
    assert (cleared.returncode, cleared.stdout) == (1, f" 14  mission  refused: {busy}\n")


@pytest.mark.slow
def test_a_vehicle_that_falls_silent_is_named_and_the_others_are_done(tmp_path: Path, site: Path) -> None:
    lines = ((11, "--autopilot ardupilot"), (21, "--autopilot px4 --late 60"))
    with holders(tmp_path, *lines) as missions:
        done = missions("set", str(site), "--part", "mission")
        listed = missions("get", "--part", "mission", "--out", str(tmp_path / "plans"))
    assert (done.returncode, listed.returncode) == (1, 1)
    assert done.stdout.splitlines()[1] == " 21  mission  silent: no answer, though it was asked 6 times"
    assert "gcs: vehicle 21: mission: no answer, though it was asked 6 times" in listed.stderr
    assert [path.name for path in (tmp_path / "plans").iterdir()] == ["vehicle-11.plan"]
