"""A session in which one vehicle cannot take a transfer: a base serves it, while a tanker serves the other."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from sessions import Outcome, fly, merged, small

from gcs.recording.session_folder import read
from gcs.report import page
from gcs.report.charts import Charts
from gcs.report.findings import Findings

EVERYONE = (1, 2, 101, 201)
PAD = (0.0, 6.0, 0.0)
STOCK_J = 50_000.0


def scenario(**changes: Any) -> dict[str, Any]:
    content = small(
        name="base",
        goal={"duration_s": 45.0, "refuelled_at_least": 2},
        bases=[{"name": "pad", "position_m": list(PAD), "stock_j": STOCK_J}],
        competition={"bids": "need"},
    )
    content["vehicles"]["pursuers"].append(
        {
            "sysid": 2,
            "start_m": [0.0, 3.0, 0.0],
            "battery": {"capacity_j": 24000, "initial_percent": 45},
            "transfer": False,
        }
    )
    return merged(content, changes)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(scenario(), tmp_path_factory.mktemp("base"), "--plain")


def services(outcome: Outcome) -> dict[int, dict[str, Any]]:
    return {service["receiver"]: service for service in outcome.summary["refuelling"]}


def assert_ledgers_close(outcome: Outcome) -> None:
    """Each vehicle's truth to 1e-6 of its capacity, and to the joule what base and tanker gave and who received it."""
    for sysid in EVERYONE:
        truth = outcome.truth(sysid)
        assert truth.ledger_error_j() <= 1e-6 * truth.head["capacity_j"], sysid
    (base,) = outcome.summary["bases"]
    assert base["initial_j"] == STOCK_J == base["given_j"] + base["remaining_j"]
    assert base["given_j"] == outcome.truth(2).energy[-1, 1] + base["lost_j"]
    tanker = outcome.vehicle(201)["energy"]
    assert outcome.truth(201).energy[-1, 2] == outcome.truth(1).energy[-1, 1] + tanker["lost_j"]


def test_both_are_served_each_by_who_can(flown: Outcome) -> None:
    assert flown.status == 0, flown.stderr
    served = services(flown)
    assert (served[1]["tanker"], served[1]["base"]) == (201, None)
    assert (served[2]["tanker"], served[2]["base"]) == (None, "pad")
    assert set(flown.summary["refuel_order"]) == {1, 2}
    assert "2 at base pad" in flown.stdout


def test_their_ledgers_and_the_bases_close(flown: Outcome) -> None:
    assert_ledgers_close(flown)
    (base,) = flown.summary["bases"]
    assert base["lost_j"] == 0
    assert services(flown)[2]["energy_j"] == base["given_j"] == flown.truth(2).energy[-1, 1] > 10_000


def test_it_is_charged_on_the_ground_at_the_base_with_its_motors_off_up_to_the_level(flown: Outcome) -> None:
    truth = flown.truth(2)
    flowing = np.flatnonzero(np.diff(truth.energy[:, 1]) > 0) + 1
    assert np.linalg.norm(truth.p_ned[flowing] - np.array(PAD), axis=1).max() <= 1.0
    assert (truth.state[flowing, 3:6] == 0.0).all()
    assert all((truth.thrust[i] == 0.0).all() for i in flowing)
    assert truth.energy[:, 3].max() == pytest.approx(0.9 * 24000, abs=400)
    assert truth.p_ned[-1, 2] < -1.0  # it flies again


def test_the_schedule_says_so(flown: Outcome) -> None:
    about = [d for d in flown.decisions if d.get("receiver") == 2]
    assert [d["kind"] for d in about] == ["unable", "decided", "transfer", "served"]
    assert about[1]["reason"] == "cannot take a transfer: the scenario says so"
    assert all(d["base"] == "pad" and d["tanker"] is None for d in about[1:])
    assert any("at base pad" in line and "cannot take a transfer" in line for line in flown.stdout.splitlines())


def test_the_report_draws_the_competition_for_tankers_and_the_one_for_bases(flown: Outcome) -> None:
    findings = Findings(read(flown.folder))
    figures = Charts(findings).model()["figures"]
    drawn = {
        name: ({line["id"] for line in figures[name]["panels"][0]["lines"]}, [m["id"] for m in figures[name]["marks"]])
        for name in ("contest", "base-contest")
    }
    assert drawn == {"contest": ({1}, [1]), "base-contest": ({2}, [2])}
    assert page.text(findings).count('data-figure="base-contest"') == 1


def test_nobody_calls_it_lost(flown: Outcome) -> None:
    assert "takes no more part" not in flown.stdout
    assert flown.vehicle(2)["final_mode"] == "offboard"
    assert flown.summary["min_separation_m"] >= 0.6


def test_summary_and_decisions_keep_to_their_schemas(flown: Outcome) -> None:
    folder = resources.files("gcs").joinpath("schemas")
    for name, told in (("summary", [flown.summary]), ("decisions", flown.decisions)):
        schema = json.loads(folder.joinpath(f"{name}.schema.json").read_text(encoding="utf-8"))
        validator = jsonschema.Draft202012Validator(schema)
        for one in told:
            if one.get("kind") != "set_point":
                validator.validate(one)
    assert any(d["kind"] == "competition" and d.get("giver") == "base" for d in flown.decisions)


def test_they_close_with_a_fifth_of_all_frames_lost_and_repeat_to_the_last_byte(tmp_path: Path) -> None:
    lossy = scenario(radio={"loss": 0.2}, goal={"duration_s": 60.0})
    first, again = (fly(lossy, tmp_path / name, "--plain") for name in ("first", "again"))
    assert first.summary["link"]["lost"] > 100
    assert services(first)[2]["energy_j"] > 10_000
    assert_ledgers_close(first)
    for sysid in EVERYONE:
        energy, truth = first.vehicle(sysid)["energy"], first.truth(sysid)
        assert energy["drawn_j"] <= truth.energy[-1, 0]
        assert energy["received_j"] <= truth.energy[-1, 1]
    received_j = sum(first.truth(sysid).energy[-1, 1] for sysid in (1, 2, 101))
    assert received_j == sum(service["energy_j"] for service in first.summary["refuelling"])
    assert first.summary["digest"] == again.summary["digest"]
