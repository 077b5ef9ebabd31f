"""Sessions that go wrong and say so: each way in which one ended as met that was not (real sessions, in lockstep)."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest
from attached import Attached
from sessions import Outcome, Running, fly, merged, small
from ways import at_grants, nearest_m

from gcs.campaign import measures
from gcs.scenario.file import load
from gcs.session.replay import Replay

PLANNERS = '''
class Gather:
    """Everyone flies to one place."""

    def __init__(self, scenario):
        pass

    def plan(self, vehicle, situation):
        return (0.0, 0.0, -6.0), (0.0, 0.0, 0.0)


class Raises:
    def __init__(self, scenario):
        pass

    def plan(self, vehicle, situation):
        raise RuntimeError("nothing comes to mind")
'''


def pursuers(*starts: tuple[float, float], percent: float = 90.0, **more: Any) -> list[dict[str, Any]]:
    return [
        {"sysid": i + 1, "start_m": [n, e, 0.0], "battery": {"capacity_j": 24000, "initial_percent": percent}, **more}
        for i, (n, e) in enumerate(starts)
    ]


def scenario(**changes: Any) -> dict[str, Any]:
    """Three pursuers around a target that stands; nobody is refuelled."""
    content = small(goal={"duration_s": 13.0, "refuelled_at_least": 0}, refuelling={"enabled": False})
    content["vehicles"]["pursuers"] = pursuers((4.0, 0.0), (-4.0, 0.0), (0.0, 4.0))
    del content["vehicles"]["tankers"]
    return merged(content, changes)


def flown(content: dict[str, Any], folder: Path, *options: str) -> Outcome:
    (folder / "planners.py").write_text(PLANNERS)
    return fly(content, folder, "--plain", *options)


def unmet(outcome: Outcome) -> dict[str, dict[str, Any]]:
    assert outcome.status == 1, outcome.stdout + outcome.stderr
    summary = outcome.summary
    found = {part["part"]: part for part in summary["unmet"]}
    assert summary["outcome"] == next(iter(found))
    assert summary["outcome_text"].startswith("not met: ")
    assert summary["outcome_text"] in outcome.stdout.splitlines()
    return found


def violations(outcome: Outcome, part: str) -> list[dict[str, Any]]:
    return [d for d in outcome.decisions if d["kind"] == "violation" and d["part"] == part]


def true_least_m(outcome: Outcome, *sysids: int) -> float:
    """By the truth files, at their records."""
    at = at_grants(outcome, sysids)
    return nearest_m(at[:, (at[:, :, 2] < -0.5).all(axis=0)])


@pytest.fixture(scope="module")
def gathered(tmp_path_factory: pytest.TempPathFactory) -> tuple[Outcome, Path]:
    folder = tmp_path_factory.mktemp("gathered")
    junit = folder / "junit.xml"
    content = scenario(planner={"method": "planners:Gather", "safety": False})
    return flown(content, folder, "--junit", str(junit)), junit


def test_vehicles_that_fly_through_each_other_do_not_meet_the_goal(gathered: tuple[Outcome, Path]) -> None:
    outcome, _ = gathered
    part = unmet(outcome)["separation"]
    least_m = true_least_m(outcome, 1, 2, 3)
    assert part["value"] == outcome.summary["min_separation_m"] <= least_m + 1e-6
    assert part["value"] == pytest.approx(least_m, abs=0.05)
    assert (part["limit"], len(part["sysids"])) == (0.6, 2)
    assert outcome.summary["judged_by"] == "truth"
    assert outcome.summary["believed_min_separation_m"] == pytest.approx(part["value"], abs=0.05)


def test_everyone_tells_it_when_it_happens(gathered: tuple[Outcome, Path]) -> None:
    outcome, junit = gathered
    told = violations(outcome, "separation")
    assert {tuple(d["sysids"]) for d in told} == {(1, 2), (1, 3), (2, 3)}
    for record in told:
        assert f"{record['t_s']:7.1f} s CRITICAL: {record['text']}" in outcome.stdout.splitlines()
    first = min(told, key=lambda d: d["at_s"])
    assert first["t_s"] - 0.1 <= first["at_s"] <= first["t_s"]
    assert "| not met: separation 0." in outcome.stdout
    cases = {case.get("name"): case for case in ET.parse(junit).getroot().iter("testcase")}
    failed = {name: case[0].get("message") for name, case in cases.items() if len(case)}
    part = unmet(outcome)["separation"]
    assert failed == {part["wanted"]: f"not met: separation {part['reached']}"}


def test_a_replay_tells_it_at_its_time(gathered: tuple[Outcome, Path]) -> None:
    outcome, _ = gathered
    part, replay = unmet(outcome)["separation"], Replay(outcome.folder)
    replay.seek(part["t_s"] - 0.3)
    assert replay.snapshot(speed=1.0)["goal"]["broken"] == []
    replay.seek(part["t_s"] + 0.3)
    (broken,) = replay.snapshot(speed=1.0)["goal"]["broken"]
    assert broken["text"] == f"separation {part['reached']}"
    first = min(violations(outcome, "separation"), key=lambda d: d["t_s"])
    replay.seek(first["t_s"] - 0.05)
    replay.snapshot(speed=1.0)
    replay.advance(first["t_s"] + 0.05, float("inf"))
    events = replay.snapshot(speed=1.0)["events"]
    assert first["text"] in [event["text"] for event in events if event["kind"] == "violation"]


def test_what_a_scenario_does_not_ask_is_not_judged(tmp_path: Path) -> None:
    content = scenario(planner={"method": "planners:Gather", "safety": False}, goal={"separation_m": False})
    outcome = flown(content, tmp_path)
    assert (outcome.status, outcome.summary["outcome_text"]) == (0, "met")
    assert not [d for d in outcome.decisions if d["kind"] == "violation"]
    assert outcome.summary["min_separation_m"] < 0.6


def test_a_planner_that_raises_at_every_call_lets_the_target_fly_into_who_is_held(tmp_path: Path) -> None:
    way = {"path_m": [[0.0, 0.0, -2.5], [8.0, 0.0, -2.5]], "speed_m_s": 1.0}
    content = scenario(planner={"method": "planners:Raises", "safety": False})
    content["vehicles"]["targets"][0] |= way
    outcome = flown(content, tmp_path)
    assert unmet(outcome)["separation"]["sysids"] == [1, 101]
    assert [d for d in outcome.decisions if d["kind"] == "policy failed"]


def test_way_points_that_nobody_reaches_are_missed(tmp_path: Path) -> None:
    content = scenario()
    del content["formation"], content["vehicles"]["targets"]
    content["vehicles"]["pursuers"] = [
        {**pursuers((0.0, 0.0))[0], "waypoints_m": [[0.0, 0.0, -3.0], [3.0, 0.0, -3.0], [90.0, 0.0, -3.0]]}
    ]
    part = unmet(flown(content, tmp_path))["waypoints"]
    assert (part["value"], part["sysids"], part["reached"]) == (1.0, [1], "missed (by 1: 1 of 3)")


def test_half_the_fleet_landing_empty_is_a_loss(tmp_path: Path) -> None:
    content = scenario(goal={"duration_s": 40.0})
    for i, pursuer in enumerate(content["vehicles"]["pursuers"]):
        pursuer["battery"] = {"capacity_j": 6000 if i < 2 else 24000, "initial_percent": 100}
    outcome = flown(content, tmp_path)
    assert unmet(outcome)["lost"]["sysids"] == [1, 2]
    assert {d["sysids"][0] for d in violations(outcome, "lost")} == {1, 2}
    assert measures.measure("lost", measures.Flown(outcome.folder, load(outcome.folder / "scenario.yaml"))) == 2.0


def test_an_order_to_hold_does_not_excuse_a_battery_that_runs_low(tmp_path: Path) -> None:
    content = scenario(goal={"duration_s": 60.0}, clock={"mode": "real", "speed": 20.0})
    for i, pursuer in enumerate(content["vehicles"]["pursuers"]):
        pursuer["battery"] = {"capacity_j": 6000 if i < 2 else 24000, "initial_percent": 100}
    running = Running(content, tmp_path, "--json")
    try:
        running.wait_for(lambda _: True)
        client = Attached(running.folder)
        client.until(lambda s: all(v["stage"] == "fly" for v in s["vehicles"]), "all flew")
        assert client.order("hold", sysid=1)["ok"]
        outcome = running.finish()
        client.close()
    finally:
        running.stop()
    lost = {part["part"]: part for part in outcome.summary["unmet"]}["lost"]
    assert sorted(lost["sysids"]) == [1, 2]


def test_a_pursuer_that_sinks_into_its_target_breaks_the_separation(tmp_path: Path) -> None:
    content = scenario(planner={"safety": False}, goal={"pursue": {"within_m": 3.0, "for_s": 2.0}})
    content["vehicles"]["pursuers"] = pursuers((4.0, 0.0))
    del content["formation"]
    part = unmet(flown(content, tmp_path))["separation"]
    assert part["sysids"] == [1, 101]
    assert part["value"] < 0.3


def test_a_session_that_keeps_apart_meets_every_part(tmp_path: Path) -> None:
    content = scenario()
    outcome = flown(content, tmp_path)
    assert (outcome.status, outcome.summary["outcome_text"], outcome.summary["unmet"]) == (0, "met", [])
    names = [part["part"] for part in outcome.summary["goal"]]
    assert names == ["lost", "duration", "separation", "ground"]
