"""Faults of a scenario in whole sessions: recorded, the same by seed, and it is said what came of each."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from sessions import ROOT, Outcome, fly, small

from gcs.recording import session_folder
from gcs.report.findings import Findings
from gcs.supervisor.redecide import redecide

PAD = {"capacity_j": 60_000}
FAULTS = [
    {"fault": "battery", "sysid": 1, "share": 0.1, "at_s": 5.0},
    {"fault": "blackout", "sysid": 201, "at_s": 6.0, "for_s": 9.0},
    {"fault": "gps_off", "sysid": 2, "at_s": 7.0, "for_s": 2.0},
    {"fault": "gcs_silent", "at_s": 22.0, "for_s": 7.0},
    {"fault": "loss", "share": 0.3, "between_s": [32.0, 34.0], "for_s": 2.0},
    {"fault": "delay", "delay_s": 0.2, "at_s": 33.0, "for_s": 2.0, "chance": 0.0},
    {"fault": "kill", "sysid": 101, "at_s": 38.0},
    {"fault": "hang", "sysid": 2, "at_s": 39.0},
]


def faulty(**changes: Any) -> dict[str, Any]:
    content = small(goal={"duration_s": 40.0, "refuelled_at_least": 0, "lost_at_most": 2}, faults=FAULTS, **changes)
    content["vehicles"]["pursuers"].append({"sysid": 2, "start_m": [0.0, 3.0, 0.0], "battery": PAD})
    return content


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(faulty(), tmp_path_factory.mktemp("flown"), "--plain")


def test_each_fault_is_a_decision_at_its_time_and_keeps_to_the_schema(flown: Outcome) -> None:
    decided = [d for d in flown.decisions if d["kind"] == "fault"]
    begun = [(d["fault"], d["sysid"]) for d in decided if d["state"] == "begins"]
    assert begun == [
        ("battery", 1), ("blackout", 201), ("gps_off", 2), ("gcs_silent", 0), ("loss", 0), ("kill", 101), ("hang", 2),
    ]  # fmt: skip
    times = {d["fault"]: d["t_s"] for d in decided if d["state"] == "begins"}
    assert 32.0 <= times["loss"] <= 34.1
    assert {name: times[name] for name in ("battery", "gcs_silent", "kill")} == {
        "battery": 5.0, "gcs_silent": 22.0, "kill": 38.0,
    }  # fmt: skip
    assert [d["fault"] for d in decided if d["state"] == "ends"] == ["gps_off", "blackout", "gcs_silent", "loss"]
    schema = json.loads((ROOT / "gcs" / "schemas" / "decisions.schema.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft202012Validator(schema)
    for decision in decided:
        validator.validate(decision)
        assert f"{decision['text']}" in flown.stdout


def test_who_comes_back_after_a_fault_flies_on(flown: Outcome) -> None:
    """The tanker was dark for 9 s, pursuer 2 without GPS for 2 s, nobody heard the ground station for 7 s."""
    for sysid, after_s in ((201, 21.0), (2, 21.0), (1, 36.0), (201, 36.0)):
        truth = flown.truth(sysid)
        later = (truth.time_s > after_s) & (truth.time_s < after_s + 1.0)
        assert truth.p_ned[later, 2].max() < -1.0, sysid
    texts = [message.text for _, message in flown.messages("STATUSTEXT")]
    assert "Failsafe: GPS lost, land" in texts
    assert "Failsafe: ground station lost, return" in texts


def test_a_battery_that_drops_loses_its_share_at_once(flown: Outcome) -> None:
    truth = flown.truth(1)
    steps_j = -np.diff(truth.energy[:, 3])
    assert steps_j.max() == pytest.approx(2400.0, abs=60.0)  # a tenth of 24 kJ, and what it draws in 0.1 s
    assert truth.time_s[1:][steps_j.argmax()] == pytest.approx(5.1, abs=0.11)


def test_the_outcome_says_what_was_survived(flown: Outcome) -> None:
    faults = {one["fault"]: one["survived"] for one in flown.summary["faults"]}
    assert faults == {
        "battery": True, "blackout": True, "gps_off": True, "gcs_silent": True, "loss": True, "kill": False,
        "hang": False,
    }  # fmt: skip
    assert (
        "; 5 of 7 faults survived, not: the process of target 101 is killed at 38.0 s (target 101: "
        in flown.summary["outcome_text"]
    )
    assert flown.summary["outcome_text"].startswith("met; ")
    assert flown.summary["outcome"] == "met"
    assert [v["final_mode"] for v in flown.summary["vehicles"] if v["sysid"] in (2, 101)] == ["dead", "dead"]


def test_the_same_seed_brings_the_same_faults_however_many_fly_in_a_process(flown: Outcome, tmp_path: Path) -> None:
    begun_s = time.monotonic()
    again = fly(faulty(vehicles_per_process=8), tmp_path)
    assert again.summary["digest"] == flown.summary["digest"]
    assert time.monotonic() - begun_s < 60.0  # who hangs by a fault is not waited for as others are


def test_a_session_with_faults_is_decided_again_alike(flown: Outcome) -> None:
    verdict = redecide(flown.folder)
    assert verdict.agrees, verdict.differences[:3]


def test_the_report_draws_the_faults(flown: Outcome) -> None:
    found = Findings(session_folder.read(flown.folder))
    assert len(found.faults) == 7
    assert any(
        "Injected fault, not survived: the process of target 101 is killed" in one.text for one in found.problems
    )


def test_a_crash_and_a_landing_by_failsafe_are_named_apart(tmp_path: Path) -> None:
    faults = [{"fault": "motor", "sysid": 1, "at_s": 9.0}, {"fault": "gps_off", "sysid": 101, "at_s": 12.0}]
    outcome = fly(small(goal={"duration_s": 14.0, "refuelled_at_least": 0}, faults=faults), tmp_path, "--plain")
    texts = [(m.get_srcSystem(), m.text) for _, m in outcome.messages("STATUSTEXT")]
    assert (1, "Crashed, disarmed") in texts
    (lost,) = (part for part in outcome.summary["goal"] if part["part"] == "lost")
    assert ": crashed, or disarmed in flight" in lost["reached"]
    assert ": its failsafe flies it (Land)" in lost["reached"]
    assert "landed by itself" not in lost["reached"]
    assert "Is down, and takes no more part" in outcome.stdout
