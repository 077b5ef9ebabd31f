"""Sessions from Python, and with planners and policies of one's own: whole sessions by real processes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import psutil
import pytest
import yaml
from sessions import ROOT, fly, merged, small

import gcs


def write(folder: Path, **changes: Any) -> Path:
    path = folder / "scenario.yaml"
    path.write_text(yaml.safe_dump(small(**changes), sort_keys=False), encoding="utf-8")
    return path


def test_every_tick_is_a_snapshot_and_looking_changes_nothing(tmp_path: Path) -> None:
    path = write(tmp_path, goal={"duration_s": 11.0, "refuelled_at_least": 0})
    with gcs.Session(path, out=tmp_path / "looked") as session:
        seen = list(session)
    assert [round(10 * snapshot.time_s) for snapshot in seen] == list(range(111))
    assert seen[0].sysid.tolist() == [1, 101, 201]
    truth = fly(small(goal={"duration_s": 11.0, "refuelled_at_least": 0}), tmp_path / "alone", "--quiet")
    assert session.summary.digest == truth.summary["digest"]
    assert session.summary.outcome == "met"
    assert (truth.stdout, truth.stderr) == ("", "")
    flown = truth.truth(1)  # every vehicle tells its position in each tick, as float32
    at = np.searchsorted(flown.time_s, 10.0 - 1e-6)
    assert seen[100].p_ned[0] == pytest.approx(flown.p_ned[at], abs=1e-5)
    log = (truth.folder / "session.log").read_text(encoding="utf-8")
    assert "outcome: met" in log
    assert "pursuer 1: Take-off" in log


def test_a_loop_that_is_left_stops_the_session_and_saves_it(tmp_path: Path) -> None:
    with gcs.Session(write(tmp_path), every_s=0.5, out=tmp_path / "out") as session:
        times = []
        for snapshot in session:
            times.append(snapshot.time_s)
            if snapshot.time_s >= 3.0:
                break
        with pytest.raises(gcs.SessionError, match="has not ended"):
            _ = session.summary
    assert np.diff(times).tolist() == pytest.approx([0.5] * 6)
    assert session.summary.outcome == "interrupted"
    assert 3.0 <= session.summary.sim_time_s <= 3.6 + 1e-9  # the fleet flies on to the next snapshot meanwhile
    assert not [p for p in psutil.process_iter(["cmdline"]) if str(tmp_path) in " ".join(p.info["cmdline"] or ())]


def test_an_error_in_the_loop_is_ones_own_and_the_session_ends(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError), gcs.Session(write(tmp_path), out=tmp_path / "out") as session:  # noqa: PT012
        for _ in session:
            _ = 1 / 0
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["outcome"] == "interrupted"


def test_bad_arguments_and_late_questions_are_sentences(tmp_path: Path) -> None:
    with pytest.raises(gcs.ScenarioError, match="did you mean 'demo'"):
        gcs.Session("dmeo")
    with pytest.raises(ValueError, match="exclude each other"):
        gcs.Session("demo", lockstep=True, speed=2.0)
    with pytest.raises(ValueError, match="multiple of the scenario's period"):
        gcs.Session("demo", every_s=0.25)
    with pytest.raises(ValueError, match="speed"):
        gcs.Session("demo", speed=-1.0)
    with pytest.raises(gcs.SessionError, match="as `with Session"):
        next(iter(gcs.Session("demo")))
    with pytest.raises(gcs.SessionError, match="exists already"), gcs.Session("demo", out=tmp_path):
        pass


def test_a_shipped_policy_refuels_in_the_competitions_place(tmp_path: Path) -> None:
    outcome = fly(small(competition={"policy": "optimal"}), tmp_path)
    assert outcome.summary["outcome"] == "met"
    assert {service["by"] for service in outcome.summary["refuelling"]} == {"policy"}


BAD = """
import time

class Planner:
    def __init__(self, scenario):
        print("made")

    def plan(self, vehicle, situation):
        if situation.time_s > 6.0:
            if vehicle.sysid == 1:
                raise KeyError("no way")
            if vehicle.sysid == 2:
                return [[float("nan")] * 3, [0.0] * 3]
            if vehicle.sysid == 3:
                while True:
                    time.sleep(60.0)
        return vehicle.p_ned, (0.0, 0.0, 0.0)

class Policy:
    def __init__(self, scenario):
        pass

    def choose(self, request):
        return float("nan")
"""


def test_who_raises_hangs_or_returns_nan_is_named_and_held_and_the_session_goes_on(tmp_path: Path) -> None:
    (tmp_path / "bad.py").write_text(BAD)
    full = {"capacity_j": 60000}
    pursuers = [{"sysid": i, "start_m": [2.0 * i, 0.0, 0.0], "battery": full} for i in (2, 3, 4)]
    content = merged(small(), {"goal": {"duration_s": 12.0, "refuelled_at_least": 0}})
    content["vehicles"]["pursuers"] += pursuers
    content |= {"planner": "bad:Planner", "competition": "bad:Policy"}
    outcome = fly(content, tmp_path, "--plain")
    assert outcome.status == 1, outcome.stdout + outcome.stderr
    assert [part["part"] for part in outcome.summary["unmet"]] == ["plugins"]
    late = "planner bad:Planner did not answer within 1 s and is not asked again at"
    assert outcome.summary["outcome_text"].startswith(f"not met: plugins failed ({late} 6.")
    told = {d["sysid"]: d for d in outcome.decisions if d["kind"] == "policy failed"}
    assert {sysid: d["problem"].split(" at ")[0].split(",")[0] for sysid, d in told.items()} == {
        1: "raised KeyError",
        2: "returned NaN",
        3: "did not answer within 1 s and is not asked again",
        201: "returned NaN",
    }
    schema = json.loads((ROOT / "gcs" / "schemas" / "decisions.schema.json").read_text(encoding="utf-8"))
    for decision in told.values():
        jsonschema.Draft202012Validator(schema).validate(decision)
    assert "pursuer 3: planner bad:Planner did not answer within 1 s" in outcome.stdout
    for sysid in (1, 2, 3):
        truth = outcome.truth(sysid)
        late = truth.p_ned[truth.time_s > 7.0]
        assert np.ptp(late, axis=0).max() < 0.3
        assert outcome.vehicle(sysid)["final_mode"] == "offboard"
    assert outcome.summary["refuelling"] == []
    assert (outcome.folder / "policies.log").read_text() == "made\n"


def test_a_planner_that_cannot_be_made_is_told_and_nothing_flies(tmp_path: Path) -> None:
    (tmp_path / "odd.py").write_text("class P:\n    def __init__(self, s): s.nothing\n    def plan(self, v, s): pass\n")
    outcome = fly(small(planner="odd:P"), tmp_path, "--plain")
    assert outcome.status == 2
    assert "planner.method: odd:P cannot be made: AttributeError at " in outcome.stderr


def test_importing_gcs_loads_nothing_heavy() -> None:
    program = "import sys, gcs\nsys.exit(str({'numba', 'numpy', 'pydantic', 'click'} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.stderr == "set()\n"
