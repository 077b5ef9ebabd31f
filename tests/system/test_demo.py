"""The shipped demo, flown whole by real processes over loopback UDP, against what the vehicles themselves know."""

from __future__ import annotations

import itertools
import json
from pathlib import Path

import numpy as np
import pytest
from sessions import DIGESTS, SIMPLER, Outcome, demo, fly, fly_apart, small
from yaml import safe_load

PURSUERS, TARGET, TANKER = (1, 2, 3, 4, 5), 101, 201
EVERYONE = (*PURSUERS, TARGET, TANKER)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("OPENBLAS_NUM_THREADS")  # the fork server forks beside OpenBLAS's threads, as it does for a user
        for name, value in SIMPLER.items():
            patch.setenv(name, value)
        return fly_apart(demo(), tmp_path_factory.mktemp("demo"), "--plain")


def test_it_meets_its_goal_and_has_its_digest_on_a_simpler_processor(flown: Outcome) -> None:
    summary = flown.summary
    assert (flown.status, summary["outcome_text"], summary["unmet"]) == (0, "met", []), flown.stderr
    assert summary["digest"].startswith(f"sha256:{DIGESTS['demo']}")


def test_at_least_three_are_refuelled_by_the_competition(flown: Outcome) -> None:
    assert len(set(flown.summary["refuel_order"])) >= 3
    first = flown.summary["refuelling"][0]
    assert (first["receiver"], first["by"]) == (5, "competition")
    assert first["end_s"] < 45.0


def test_without_the_competition_nobody_is_refuelled(tmp_path: Path) -> None:
    """With it the same vehicle is: tests/system/test_transfer.py."""
    outcome = fly(small(competition={"enabled": False}), tmp_path, "--plain")
    assert outcome.summary["refuel_order"] == []
    assert [part["part"] for part in outcome.summary["unmet"]] == ["refuelled"]
    assert outcome.status == 1


def test_nobody_runs_empty_and_everybody_is_in_the_air_at_the_end(flown: Outcome) -> None:
    for sysid in EVERYONE:
        assert flown.vehicle(sysid)["final_mode"] in {"offboard", "refuel"}
        assert flown.truth(sysid).energy[:, 3].min() > 0.05 * flown.truth(sysid).head["capacity_j"]


def test_every_pursuer_stays_on_the_ring(flown: Outcome) -> None:
    target = flown.truth(TARGET)
    for sysid in PURSUERS:
        own = flown.truth(sysid)
        assert np.array_equal(own.time_s, target.time_s)
        distance, late = np.linalg.norm(own.p_ned - target.p_ned, axis=1), own.time_s > 20.0
        assert np.median(distance[late]) == pytest.approx(2.0, abs=0.25)
        evades = np.zeros_like(late)  # who an aircraft flies at leaves the ring, and comes back
        for told in flown.decisions:
            if told["kind"] == "safety" and told["sysid"] == sysid and told["by"].startswith("traffic"):
                evades |= (own.time_s >= told["t_s"]) & (own.time_s < told["t_s"] + 10.0)
        assert distance[late & ~evades].max() < 3.5
        assert distance[late].max() < 6.0


def test_nothing_comes_closer_than_allowed_by_the_vehicles_own_knowledge(flown: Outcome) -> None:
    """Positions from the truth files, obstacles from the YAML file: no code of the ground station in between."""
    content = safe_load(Path("configs/demo.yaml").read_text(encoding="utf-8"))
    points = np.array([entry["point_m"] for entry in content["obstacles"]]) * (1.0, -1.0, -1.0)
    truths = {sysid: flown.truth(sysid) for sysid in EVERYONE}
    for truth in truths.values():
        gaps = np.linalg.norm(truth.p_ned[:, None, :] - points[None], axis=2)
        assert gaps.min() >= 0.3
    services = [(r["tanker"], r["receiver"], r["decided_at_s"], r["end_s"]) for r in flown.summary["refuelling"]]
    for a, b in itertools.combinations(EVERYONE, 2):
        gap = np.linalg.norm(truths[a].p_ned - truths[b].p_ned, axis=1)
        time_s = truths[a].time_s
        apart = np.ones(len(gap), dtype=bool)
        for tanker, receiver, from_s, to_s in services:
            if {a, b} == {tanker, receiver}:
                apart &= (time_s < from_s) | (time_s > (to_s if to_s is not None else np.inf))
        assert gap[apart].min() >= content["planner"]["separation_m"], (a, b)


def test_moving_obstacles_are_passed_at_a_distance(flown: Outcome) -> None:
    """ADSB_VEHICLE as recorded, against the vehicles' own positions at the same time."""
    origin = (47.397742, 8.545594, 488.0)
    metres_per_deg = 111_195.0  # at this latitude to 0.2 %, which is 3 cm at the edge of the field
    gaps: list[float] = []
    truths = {sysid: flown.truth(sysid) for sysid in EVERYONE}
    for t_s, report in flown.messages("ADSB_VEHICLE"):
        north = (report.lat * 1e-7 - origin[0]) * metres_per_deg
        east = (report.lon * 1e-7 - origin[1]) * metres_per_deg * np.cos(np.radians(origin[0]))
        there = np.array((north, east, -(report.altitude * 1e-3 - origin[2])))
        for truth in truths.values():
            row = int(np.searchsorted(truth.time_s, t_s - 1e-6))
            if truth.p_ned[row, 2] < -0.5:
                gaps.append(float(np.linalg.norm(truth.p_ned[row] - there)))
    assert gaps
    assert min(gaps) >= 0.3


def test_the_summary_agrees_with_what_the_vehicles_know(flown: Outcome) -> None:
    for sysid in EVERYONE:
        energy, truth = flown.vehicle(sysid)["energy"], flown.truth(sysid)
        drawn, received, given, remaining = truth.energy[-1]
        assert energy["drawn_j"] == pytest.approx(drawn, abs=100.0 + 0.5 * 250.0)  # hJ, told twice a second
        assert energy["received_j"] == received
        assert energy["given_j"] == given
        assert energy["initial_j"] == truth.head["initial_j"]
        assert energy["remaining_j"] == pytest.approx(remaining, abs=225.0)
        assert energy["source"] == "energy_consumed"
    total_given = sum(flown.vehicle(sysid)["energy"]["given_j"] for sysid in EVERYONE)
    total_received = sum(flown.vehicle(sysid)["energy"]["received_j"] for sysid in EVERYONE)
    lost = sum(flown.vehicle(sysid)["energy"]["lost_j"] for sysid in EVERYONE)
    assert total_given == total_received + lost


def test_every_ledger_closes_with_power_from_the_recorded_thrust(flown: Outcome) -> None:
    for sysid in EVERYONE:
        truth = flown.truth(sysid)
        assert truth.ledger_error_j() <= 1e-6 * truth.head["capacity_j"]


def test_the_recorded_frames_agree_with_the_summary(flown: Outcome) -> None:
    drawn_hj: dict[int, int] = {}
    effort: dict[int, float] = {}
    counters: dict[tuple[int, str], int] = {}
    seen = sent = 0
    for _, message in flown.messages():
        ours = (message.get_srcSystem(), message.get_srcComponent()) == (255, 190)
        sent += ours
        seen += not ours
        if message.get_type() == "BATTERY_STATUS":
            drawn_hj[message.get_srcSystem()] = message.energy_consumed
        elif message.get_type() == "NAMED_VALUE_FLOAT":
            effort[message.get_srcSystem()] = message.value
        elif message.get_type() == "NAMED_VALUE_INT":
            counters[message.get_srcSystem(), message.name] = message.value
    for sysid in EVERYONE:
        vehicle = flown.vehicle(sysid)
        assert vehicle["energy"]["drawn_j"] == 100.0 * drawn_hj[sysid]
        assert vehicle["energy"]["received_j"] == counters[sysid, "XferIn"]
        assert vehicle["energy"]["given_j"] == counters[sysid, "XferOut"]
        assert vehicle["control_effort"] == pytest.approx(effort[sysid])
    link = flown.summary["link"]
    assert seen + sent == link["received"] + link["sent"]
    assert (link["lost"], link["malformed"], link["overflowed"]) == (0, 0, 0)


def test_every_set_point_of_a_decision_was_sent(flown: Outcome) -> None:
    planned = [d for d in flown.decisions if d["kind"] == "set_point"]
    sent = [m for _, m in flown.messages("SET_POSITION_TARGET_LOCAL_NED")]
    assert len(planned) == len(sent)
    for decision, message in zip(planned[::50], sent[::50], strict=True):
        assert message.target_system == decision["sysid"]
        assert (message.x, message.y, message.z) == pytest.approx(
            decision["p_ned"], abs=0.02
        )  # origins travel in degE7
        assert message.type_mask == 0b110111000000


def test_decisions_say_why(flown: Outcome) -> None:
    decided = [d for d in flown.decisions if d["kind"] == "decided"]
    assert len(decided) == len(flown.summary["refuelling"])
    for decision in decided:
        assert decision["by"] in {"competition", "unopposed"}
        assert set(decision["bids"]) == set(decision["need"]) == set(decision["v"])
        if decision["by"] == "competition":
            assert decision["share"] >= 0.9
            winner = str(decision["receiver"])
            tie = 2.0 / 60.0  # of the scale of time
            assert decision["bids"][winner] >= max(decision["bids"].values()) - tie
    assert sum(decision["by"] == "competition" for decision in decided) >= 3


def test_the_session_folder_is_as_promised(flown: Outcome) -> None:
    assert {path.name for path in flown.folder.iterdir()} == {
        "session.tlog",
        "session.log",
        "decisions.jsonl",
        "scenario.yaml",
        "summary.json",
        "vehicles",
    }
    again = safe_load((flown.folder / "scenario.yaml").read_text(encoding="utf-8"))
    assert again["axes"] == "ned"
    assert {f"{sysid}.truth" for sysid in EVERYONE} <= {path.name for path in (flown.folder / "vehicles").iterdir()}
    assert json.loads((flown.folder / "summary.json").read_text(encoding="utf-8"))["schema"] == 1


def test_the_competition_competes(flown: Outcome) -> None:
    competitors = [len(told["v"]) for told in flown.decisions if told["kind"] == "competition"]
    assert max(competitors) >= 2
    assert sum(count >= 2 for count in competitors) >= 100
