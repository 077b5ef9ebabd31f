"""Sessions whose obstacles, attractors and paths change in flight: whole sessions by real processes."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
import yaml
from commands import gcs as run_gcs
from sessions import ROOT, read_truth

import gcs
from gcs.recording.session_folder import read
from gcs.report.charts import Charts
from gcs.report.findings import Findings
from gcs.scenario.model import Obstacle
from gcs.session.replay import Replay
from skytender import geometry

RISES_S, STANDS_S = 8.0, 16.0
PILLAR_NE, RADIUS_M, CLEARANCE_M = (6.0, 0.0), 0.5, 0.1


def scenario(**changes: Any) -> dict[str, Any]:
    """A pursuer that follows a target north, past a pillar that stands aside."""
    fleet = {
        "defaults": {"battery": {"capacity_j": 60000}},
        "pursuers": [{"sysid": 1, "start_m": [-2, 0, 0]}, {"sysid": 2, "start_m": [-2, 3, 0]}],
        "targets": [{"sysid": 101, "start_m": [0, 0, 0], "speed_m_s": 0.6, "path_m": [[0, 0, -4], [12, 0, -4]]}],
    }
    return {
        "schema": 1,
        "name": "changing",
        "axes": "ned",
        "origin": {"lat_deg": 47.3977, "lon_deg": 8.5456, "alt_m": 488},
        "goal": {"duration_s": 30},
        "vehicles": fleet,
        "formation": {"ring_m": 1.5},
        "obstacles": [{"name": "pillar", "cylinder_m": [30, 30], "radius_m": RADIUS_M, "bottom_m": 0, "top_m": -9}],
        **changes,
    }


def write(folder: Path, content: dict[str, Any]) -> Path:
    path = folder / "scenario.yaml"
    path.write_text(yaml.safe_dump(content, sort_keys=False), encoding="utf-8")
    return path


def change(path: Path, folder: Path) -> gcs.Session:
    """The pillar is put in the way, a ball flies along, and at last the target is led away to the east."""
    with gcs.Session(path, lockstep=True, out=folder) as session:
        while (snapshot := session.step()).time_s < RISES_S:
            pass
        session.obstacles.move("pillar", PILLAR_NE)
        ball = session.obstacles.add({"sphere_m": (-9, -9, -4), "radius_m": 0.4})
        session.attractors.add({"point_m": (5, 5, -4), "range_m": 4.0})
        assert [one.name for one in session.obstacles] == ["pillar", ball.name] == ["pillar", "sphere 2"]
        with pytest.raises(gcs.SessionError, match=r"would be inside or within 0\.3 m of pursuer 1"):
            session.obstacles.move("pillar", snapshot.p_ned[0])
        with pytest.raises(ValueError, match="no obstacle 'piller'"):
            session.obstacles.remove("piller")
        while (snapshot := session.step()).time_s < STANDS_S:
            session.obstacles.move(ball.name, (-9.0 + 0.1 * (snapshot.time_s - RISES_S), -9.0))
        session.obstacles.remove("sphere 2")
        session.set_path(101, [(10, 4, -4), (10, 12, -4)], speed_m_s=0.8)
        assert len(session.obstacles) == 1
        session.finish()
    return session


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> gcs.Session:
    """That it repeats: tests/system/test_own_objects.py."""
    folder = tmp_path_factory.mktemp("changed")
    return change(write(folder, scenario()), folder / "out")


def changes(folder: Path) -> list[dict[str, Any]]:
    lines = map(json.loads, (folder / "decisions.jsonl").read_text(encoding="utf-8").splitlines())
    return [line for line in lines if line["kind"] == "world"]


def test_each_change_is_told_and_is_decided_again(flown: gcs.Session) -> None:
    schema = json.loads((ROOT / "gcs" / "schemas" / "decisions.schema.json").read_text(encoding="utf-8"))
    told = changes(flown.folder)
    for line in told:
        jsonschema.Draft202012Validator(schema).validate(line)
    assert [line["change"] for line in told if line["t_s"] == pytest.approx(8.1)] == ["moved", "added", "added"]
    assert [line["change"] for line in told][-2:] == ["removed", "path"]
    assert sum(line.get("name") == "sphere 2" for line in told) == 2 + 79
    again = run_gcs("replay", str(flown.folder), "--decide")
    assert (again.returncode, again.stdout.endswith("agree\n")) == (0, True)
    assert "84 changes of the world" in again.stderr


def test_vehicles_keep_clear_of_a_pillar_that_was_put_in_their_way(flown: gcs.Session) -> None:
    """The verdict's distance is that of the vehicles' own truth to the place where the pillar was then."""
    session = flown
    least_m, without_m = math.inf, math.inf
    for sysid in (1, 2, 101):
        truth = read_truth(session.folder / "vehicles" / f"{sysid}.truth")
        beside_m = np.linalg.norm(truth.p_ned[:, :2] - PILLAR_NE, axis=1) - RADIUS_M
        after = (truth.time_s >= RISES_S + 0.1) & (truth.p_ned[:, 2] < -1.0)
        least_m = min(least_m, float(beside_m[after].min()))
        without_m = min(without_m, float(np.abs(truth.p_ned[:, 1][after]).min()))
    nearest = session.summary.closest["clearance"]
    assert (nearest.what, nearest.distance_m) == ("pillar", pytest.approx(least_m, abs=0.02))
    assert CLEARANCE_M <= nearest.distance_m < 2.0
    assert session.summary.outcome == "met"
    target = read_truth(session.folder / "vehicles" / "101.truth")
    assert float(target.p_ned[:, 0].max()) > PILLAR_NE[0] + RADIUS_M, "it was on its way past the pillar"
    assert np.linalg.norm(target.p_ned[-1, :2] - (10.0, 12.0)) < 4.0, "it has flown the path that it was given"


def test_page_report_and_replay_show_what_was_there(flown: gcs.Session) -> None:
    folder = flown.folder
    replay = Replay(folder)
    shown = {}
    for t_s in (4.0, 12.0, 20.0):
        replay.seek(t_s)
        line = replay.session()
        shown[t_s] = {one["label"]: tuple(one["centre_ned"][:2]) for one in line["obstacles"]}
        paths = {one["sysid"]: one["path_ned"] for one in line["vehicles"]}
        assert len(paths[101]) == 2
        assert (paths[101][-1] == (10.0, 12.0, -4.0)) == (t_s == 20.0)
    assert shown[4.0] == {"pillar": (30.0, 30.0)}
    assert shown[12.0] == {"pillar": PILLAR_NE, "sphere 2": (pytest.approx(-8.61), -9.0)}
    assert shown[20.0] == {"pillar": PILLAR_NE}
    findings = Findings(read(folder))
    clear_m = findings.nearness.clearance
    assert np.nanmin(clear_m.values) == pytest.approx(flown.summary.closest["clearance"].distance_m, abs=0.1)
    flight = Charts(findings).model()["flight"]
    assert flight is not None
    at = {round(t_s, 1): [flight["solids"][k]["centre_ned"][:2] for k in there] for t_s, there, _ in flight["worlds"]}
    assert [tuple(one) for one in at[0.0]] == [(30.0, 30.0)]
    assert tuple(at[8.1][0]) == PILLAR_NE
    texts = [event["text"] for event in flight["events"]]
    assert sum("sphere 2" in text for text in texts) == 2, "moves in each step are no events"
    assert any("Vehicle 101 flies another path" in text for text in texts)


def test_an_obstacle_of_a_program_alone_is_judged(tmp_path: Path) -> None:
    """A session without any obstacle of its own, and one that a program flies into the fleet: the goal says so."""
    hover = {"defaults": {"battery": {"capacity_j": 60000}}, "pursuers": [{"sysid": 1, "start_m": [0, 0, 0]}]}
    content = scenario(vehicles=hover, obstacles=[], goal={"duration_s": 12}, formation={}, planner={"safety": False})
    with gcs.Session(write(tmp_path, content), lockstep=True, out=tmp_path / "out") as session:
        here = ((0.0, 0.0, -3.0), (0.0, 0.0, 0.0))
        while session.step({1: here}).time_s < 7.0:
            pass
        session.obstacles.add({"name": "ball", "sphere_m": (3, 0, -3), "radius_m": 0.5})
        session.step({1: here})
        session.obstacles.move("ball", session.truth.p_ned[0] + (0.82, 0.0, 0.0))
        session.step({1: here})
        session.obstacles.move("ball", (3, 0))
        for _ in range(10):
            session.step({1: ((1.2, 0.0, -3.0), (0.0, 0.0, 0.0))})
        session.obstacles.remove(0)
        session.step()
        session.finish()
    parts = {part.part: part for part in session.summary.goal}
    flown = read_truth(session.folder / "vehicles" / "1.truth")
    place = Obstacle(sphere_m=tuple(flown.p_ned[np.searchsorted(flown.time_s, 7.099)] + (0.82, 0, 0)), radius_m=0.5)
    during = (flown.time_s > 7.19) & (flown.time_s < 7.21)
    least_m = geometry.clearance(geometry.of_scenario([place]), flown.p_ned[during]).min()
    assert parts["clearance"].value == pytest.approx(least_m, abs=0.05)
    assert parts["clearance"].what == "ball"
    again = run_gcs("replay", str(session.folder), "--decide")
    assert (again.returncode, again.stdout.endswith("agree\n")) == (0, True)
