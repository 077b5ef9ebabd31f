"""Sessions that a program in Python steps and acts in: whole sessions by real processes."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import psutil
import pytest
import yaml
from commands import gcs as run_gcs
from pages import DOCS, block
from sessions import ROOT, fly, merged, read_truth, small

import gcs

PAGE = DOCS / "how-to" / "act.md"
STILL = (0.0, 0.0, 0.0)
PERIOD_S = 0.1


def five(**changes: Any) -> dict[str, Any]:
    """The page's five vehicles."""
    content: dict[str, Any] = yaml.safe_load(block(PAGE, "five.yaml"))
    return merged(content, changes)


def write(folder: Path, content: dict[str, Any]) -> Path:
    path = folder / "scenario.yaml"
    path.write_text(yaml.safe_dump(content, sort_keys=False), encoding="utf-8")
    return path


def decisions(folder: Path, *kinds: str) -> list[dict[str, Any]]:
    lines = map(json.loads, (folder / "decisions.jsonl").read_text(encoding="utf-8").splitlines())
    return [line for line in lines if line["kind"] in kinds]


def test_the_program_of_the_page_is_short() -> None:
    assert len(block(PAGE, "act.py").splitlines()) <= 30


def test_a_session_that_is_only_stepped_is_that_of_gcs_run(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 12.0, "refuelled_at_least": 0})
    times = []
    with gcs.Session(write(tmp_path, content), lockstep=True, out=tmp_path / "stepped") as session:
        with pytest.raises(gcs.SessionError, match=r"ended at 12 s: it cannot be stepped"):  # noqa: PT012
            while True:
                times.append(session.step().time_s)
        with pytest.raises(gcs.SessionError, match="ended at 12 s: make another one"):
            session.command(1, "hold")
    assert [round(10 * t_s) for t_s in times] == list(range(121))
    assert session.summary.digest == fly(content, tmp_path / "alone", "--quiet").summary["digest"]
    assert not decisions(session.folder, "steered", "command", "inject")


def act(path: Path, folder: Path) -> gcs.Session:
    """Two vehicles are sent to one place, one loses its link for a while, one is held, one is sent a MAV_CMD."""
    seen = []
    with gcs.Session(path, lockstep=True, out=folder) as session:
        snapshot = session.step()
        while snapshot.time_s < 7.0:
            snapshot = session.step()
        hold, speed = session.command(4, "hold"), session.command(5, "DO_CHANGE_SPEED", 1.0, 2.0, math.nan)
        session.inject({"fault": "blackout", "sysid": 3, "for_s": 2.0})
        meeting = {1: ((0.0, 0.0, -6.0), STILL), 2: ([0, 0, -6], [0, 0, 0])}
        while snapshot.time_s < 16.0:
            seen.append(snapshot := session.step(meeting))
        with pytest.raises(gcs.SessionError, match="flies by the plan already"):
            session.step(commands=[(2, "rejoin")])
        truth = session.truth
    assert (hold.outcome, hold.result, speed.outcome) == ("accepted", "ACCEPTED", "accepted")
    assert [one.command for snapshot in seen for one in snapshot.acknowledged] == ["hold", "MAV_CMD_DO_CHANGE_SPEED"]
    assert snapshot.mode[3] == "hold"
    assert np.isnan(snapshot.set_point_p_ned[3]).all()
    assert max(snapshot.heard_s[2] for snapshot in seen) == pytest.approx(2.0, abs=PERIOD_S)
    assert np.linalg.norm(snapshot.p_ned[:2] - (0.0, 0.0, -6.0), axis=1).max() < 2.0
    for row, sysid in enumerate(truth.sysid):
        flown = read_truth(folder / "vehicles" / f"{sysid}.truth")
        at = int(np.flatnonzero(flown.time_s == truth.time_s[row])[0])
        assert truth.time_s[row] == snapshot.time_s
        assert truth.p_ned[row].tolist() == flown.p_ned[at].tolist()
        assert truth.remaining_j[row] == flown.energy[at][-1]
    return session


@pytest.fixture(scope="module")
def acted(tmp_path_factory: pytest.TempPathFactory) -> gcs.Session:
    """That it repeats: the page's program, in tests/system/test_docs_pages.py."""
    folder = tmp_path_factory.mktemp("acted")
    return act(write(folder, five()), folder / "out")


def test_set_points_of_a_program_pass_the_safety_filter(acted: gcs.Session) -> None:
    one, other = (read_truth(acted.folder / "vehicles" / f"{sysid}.truth").p_ned for sysid in (1, 2))
    apart_m = np.linalg.norm(one - other, axis=1)
    assert acted.scenario.planner.separation_m <= apart_m.min() < 1.5
    asked = decisions(acted.folder, "steered")
    assert {tuple(line["n"].values()) for line in asked} == {(0.0, 0.0)}
    sent = [line["p_ned"] for line in decisions(acted.folder, "set_point") if line["t_s"] == asked[-1]["t_s"]]
    assert [0.0, 0.0, -6.0] not in sent


def test_acts_stand_in_the_decisions_and_are_decided_again(acted: gcs.Session) -> None:
    folder = acted.folder
    schema = json.loads((ROOT / "gcs" / "schemas" / "decisions.schema.json").read_text(encoding="utf-8"))
    acts = decisions(folder, "steered", "command", "inject", "operator", "fault")
    for line in acts:
        jsonschema.Draft202012Validator(schema).validate(line)
    told = [(line["kind"], line.get("sysid"), line["t_s"]) for line in acts if line["kind"] != "steered"]
    begin_s = told[0][2]
    assert begin_s == pytest.approx(7.1)
    assert [entry for entry in told if entry[2] == begin_s] == [
        ("command", 5, begin_s), ("inject", 3, begin_s), ("fault", 3, begin_s), ("operator", 4, begin_s),
    ]  # fmt: skip
    again = run_gcs("replay", str(folder), "--decide")
    assert (again.returncode, again.stdout.endswith("agree\n")) == (0, True)
    assert "a program in Python acted in this session (90 ticks with set points, 1 command, 1 fault)" in again.stderr


def test_an_act_that_cannot_be_read_is_not_decided_again(acted: gcs.Session, tmp_path: Path) -> None:
    for name in ("session.tlog", "summary.json", "scenario.yaml"):
        (tmp_path / name).symlink_to(acted.folder / name)
    text = (acted.folder / "decisions.jsonl").read_text()
    (tmp_path / "decisions.jsonl").write_text(text.replace('"fault":"blackout"', '"fault":"black magic"', 1))
    again = run_gcs("replay", str(tmp_path), "--decide")
    assert again.returncode == 2
    assert "holds an act of a program at 7.100 s that cannot be read" in again.stderr


def test_faults_of_process_radio_battery_and_tanker_repeat_and_are_decided_again(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 40.0, "refuelled_at_least": 0})
    content["vehicles"]["pursuers"].append({"sysid": 2, "start_m": [4, 3, 0], "battery": {"capacity_j": 24000}})
    path, digests = write(tmp_path, content), []
    made: dict[str, Callable[..., Any]] = {"keys": dict, "objects": gcs.Fault}
    for name, fault_of in made.items():
        with gcs.Session(path, lockstep=True, out=tmp_path / name) as session:
            while (before := session.step()).time_s < 8.0:
                pass
            for fault in (
                {"fault": "kill", "sysid": 2},
                {"fault": "loss", "share": np.float64(0.4), "for_s": np.float32(3.0)},
                {"fault": "delay", "delay_s": 0.3, "for_s": 2.0, "at_s": 9.0},
                {"fault": "tanker_out", "sysid": 201, "for_s": 2.0},
                {"fault": "battery", "sysid": np.int64(1), "share": 0.1},
                {"fault": "gps_jump", "sysid": 101, "jump_m": np.array([1.0, 2.0]), "for_s": 3.0},
                {"fault": "motor", "sysid": 2, "at_s": 9.5},  # it is dead by then
            ):
                session.inject(fault_of(**fault))
            while (snapshot := session.step()).time_s < 10.0:
                pass
            with pytest.raises(gcs.SessionError, match=r"^The fault is refused: pursuer 2 is dead\.$"):
                session.inject(fault_of(fault="motor", sysid=2))
            truth = session.truth
        digests.append(session.summary.digest)
    assert digests[0] == digests[1]
    assert snapshot.alive.tolist() == [True, False, True, True]
    assert (snapshot.trouble[1], truth.time_s[1]) == (("dead",), pytest.approx(8.1))
    assert snapshot.lost_share.max() > 0.1
    assert before.battery[0] - snapshot.battery[0] > 0.09  # a tenth of it is gone, and reported with its rounding
    assert np.linalg.norm(snapshot.p_ned[2] - truth.p_ned[2]) > 1.0  # it reports, and flies by, another place
    told = [(line["fault"], line["number"]) for line in decisions(session.folder, "fault") if line["state"] == "begins"]
    assert sorted(number for _, number in told) == [1, 2, 3, 4, 5, 6]
    assert [one.fault for one in session.summary.faults if one.sysid == 2] == ["kill"]
    again = run_gcs("replay", str(session.folder), "--decide")
    assert (again.returncode, again.stdout.endswith("agree\n")) == (0, True)


def test_a_set_point_is_where_it_is_to_be_at_the_snapshot_that_is_returned(tmp_path: Path) -> None:
    content = five(planner={"safety": False}, vehicles={"defaults": {"airborne": True}})
    for vehicle in content["vehicles"]["pursuers"]:
        vehicle["start_m"][2] = -5.0
    path, v_ned = write(tmp_path, content), np.array([0.5, -0.25, 0.0])

    def place(time_s: float) -> np.ndarray:
        return (6.0, 0.0, -5.0) + v_ned * time_s

    with gcs.Session(path, lockstep=True, every_s=0.5, out=tmp_path / "out") as session:
        snapshot = session.step()
        for time_s in (0.5, 1.0, 1.5):
            snapshot = session.step({1: (place(time_s), v_ned)})
            assert snapshot.time_s == time_s
            assert snapshot.set_point_p_ned[0].tolist() == place(time_s).tolist()
            assert snapshot.set_point_v_ned[0].tolist() == v_ned.tolist()
        session.step()
    told = decisions(session.folder, "steered")
    assert [round(10 * line["t_s"]) for line in told] == list(range(1, 16))
    for line in told:
        assert [line[axis]["1"] for axis in "ned"] == pytest.approx(place(line["t_s"]))


def test_what_ended_a_session_is_said_again(tmp_path: Path) -> None:
    with gcs.Session(write(tmp_path, five()), lockstep=True, out=tmp_path / "out") as session:
        session.step()
        supervisor = next(one for one in psutil.Process().children() if str(tmp_path) in " ".join(one.cmdline()))
        supervisor.kill()
        calls = [session.step, lambda: session.command(1, "hold"), lambda: list(session), session.stop]
        for call in calls:
            with pytest.raises(gcs.SessionError, match=r"^the supervisor ended with status -9 before"):
                call()


class Interrupted:
    """A planner of which one call is ended by Ctrl-C."""

    def __init__(self, scenario: gcs.Scenario) -> None:
        self.starts = {vehicle.sysid: vehicle.start_m for vehicle in scenario.vehicles.all}

    def plan(self, vehicle: gcs.VehicleView, situation: gcs.Situation) -> tuple[Any, Any]:
        if vehicle.sysid == 2 and situation.time_s == pytest.approx(0.7):
            raise KeyboardInterrupt
        return self.starts[vehicle.sysid], STILL


@pytest.mark.parametrize(
    "act",
    [
        gcs.Session.folder.fget,
        lambda session: session.command(3, "return"),
        lambda session: session.inject({"fault": "blackout", "sysid": 5, "for_s": 1.0}),
        lambda session: session.obstacles.move("pillar", (14.0, 0.0)),
    ],
    ids=["step", "command", "inject", "move"],
)
def test_after_an_interrupt_a_session_goes_on(act: Callable[[gcs.Session], Any], tmp_path: Path) -> None:
    content = five(vehicles={"defaults": {"airborne": True}})
    for vehicle in content["vehicles"]["pursuers"]:
        vehicle["start_m"][2] = -5.0
    with gcs.Session(
        write(tmp_path, content), lockstep=True, every_s=0.5, planner=Interrupted, out=tmp_path / "out"
    ) as session:
        session.step()
        session.step()
        hold = session.command(4, "hold")
        with pytest.raises(KeyboardInterrupt):
            session.step({1: ((7.0, 0.0, -5.0), STILL)})
        act(session)
        seen = [session.step({1: ((north, 0.0, -5.0), STILL)}) for north in (8.0, 9.0)]
    assert [snapshot.time_s for snapshot in seen] == [1.5, 2.0]
    assert seen[0].set_point_p_ned[0, 0] > 7.0
    assert seen[0].acknowledged[0] is hold
    assert hold.outcome == "accepted"
    assert "Hold accepted" in [event.text for event in seen[0].events if event.sysid == 4]
    flown = [line["n"]["1"] for line in decisions(session.folder, "steered")]
    assert flown == [7.0] * 5 + [8.0] * 5 + [9.0] * 5


def test_mistakes_are_one_sentence_each(tmp_path: Path) -> None:
    path = write(tmp_path, five(vehicles_per_process=5))
    with gcs.Session(path, lockstep=True, out=tmp_path / "out") as session:
        with pytest.raises(gcs.SessionError, match="no truth before the first snapshot"):
            _ = session.truth
        session.step()
        for points, sentence in (
            ({77: (STILL, STILL)}, "no vehicle 77 in this session: it has 1 to 5$"),
            ({"one": (STILL, STILL)}, "'one' is no system id"),
            ({1: (STILL, (0.0, math.nan, 0.0))}, "set point of vehicle 1 holds NaN, which is no place or speed"),
            ({1: (STILL, (0.0, 0.0, math.inf))}, "vehicle 1 holds inf"),
            ({1: STILL}, r"vehicle 1 has the shape \(3,\), not \(2, 3\)"),
            ({1: ((0.0, 0.0), STILL)}, r"vehicle 1 is not \(p_ned, v_ned\) of three numbers each"),
            ([STILL], "set_points is a mapping from system id"),
        ):
            with pytest.raises(ValueError, match=sentence):
                session.step(points)  # type: ignore[arg-type]
        for command, sentence in (
            ((9, "hold"), "no vehicle 9"),
            ((1, "holt"), "'holt' is neither an order .* did you mean 'hold'"),
            ((1, "hold", 3.0), "hold takes no parameters"),
            ((1, "retarget"), "needs the system id of the new target"),
            ((1, 1 << 20), "is no MAV_CMD"),
            ((1, "MAV_CMD_NAV_LAND", *[0.0] * 8), "has 8 parameters"),
            ((1, 21, "low"), "parameter 1 of MAV_CMD_NAV_LAND is 'low', and not a number"),
            ((1, 21, 1e300), "more than its float32 holds"),
        ):
            with pytest.raises(ValueError, match=sentence):
                session.command(*command)  # type: ignore[arg-type]
        for commands in (1, "hold", [1, "hold"], [(1,)], [(1, "hold"), None]):
            with pytest.raises(ValueError, match=r"^commands are tuples such as \(1, 'hold'\), and .* is none$"):
                session.step({}, commands)  # type: ignore[arg-type]
        for fault, sentence in (
            ({"fault": "moter", "sysid": 1}, "did you mean 'motor'"),
            ({"fault": "motor"}, "motor needs the sysid"),
            ({"fault": "motor", "sysid": 1, "chance": 0.5}, "has no chance: nothing is drawn in flight"),
            ({"fault": "motor", "sysid": 1, "at_s": 0.0}, "at_s is 0, which is past: the next tick is at 0.1 s"),
            ({"fault": "motor", "sysid": 1, "at_s": 90.0}, "begins at 90 s, which is not before duration_s"),
            ({"fault": "kill", "sysid": 1}, "vehicle 1 shares its process with others: kill needs"),
            (gcs.Fault(fault="motor", sysid=1, chance=0.5), "has no chance: nothing is drawn in flight"),
            ("motor", "a fault is a block of keys"),
        ):
            with pytest.raises(gcs.SessionError, match=sentence):
                session.inject(fault)  # type: ignore[arg-type]
        for key, value in (("at_s", math.nan), ("for_s", math.inf), ("at_s", 10**400), ("jump_m", [0.0, math.nan])):
            with pytest.raises(ValueError, match=f"^{key} of a fault must be a finite number, not"):
                session.inject({"fault": "gps_jump", "sysid": 1, "for_s": 1.0, "jump_m": [1.0, 1.0], key: value})
        for wrong in (
            lambda: session.step({1: ((10**400, 0, -3), (0, 0, 0))}),
            lambda: session.command(1, "MAV_CMD_DO_CHANGE_SPEED", 10**400),
        ):
            with pytest.raises(ValueError, match=r"three numbers|float32"):
                wrong()
        with pytest.raises(gcs.SessionError, match=r"^Pursuer 1 flies by the plan already\.$"):
            session.command(1, "rejoin")
    assert not decisions(session.folder, "steered", "command", "inject")
    again = gcs.Session(path, lockstep=True, out=tmp_path / "out")
    with pytest.raises(gcs.SessionError, match=r"out exists already and is left as it is; give another folder$"):
        again.__enter__()
    with pytest.raises(gcs.SessionError, match=r"^the session does not fly; use it as `with Session"):
        again.step()
    with gcs.Session(path, speed=50.0, out=tmp_path / "real") as session:
        for asks in (session.step, lambda: session.command(1, "hold"), lambda: session.inject({})):
            with pytest.raises(gcs.SessionError, match=r"need Session.*lockstep=True"):
                asks()
