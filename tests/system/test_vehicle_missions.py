"""Vehicles that fly their own missions, among others: watched, kept apart by the truth that vehicles wrote, and let go
on; and what their autopilots are sent for that."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from mission_files import ORIGIN, speed, waypoint, write_plan
from ports import free_port
from pymavlink.dialects.v20 import ardupilotmega as mav
from sessions import Outcome, fly
from strangers import SIMVEHICLE, strangers
from ways import at_grants, nearest_m

import gcs

SEPARATION_M = 1.0
ROWS = 4


def scenario(pursuers: Sequence[dict[str, Any]], duration_s: float, **changes: Any) -> dict[str, Any]:
    return {
        "schema": 1, "name": "missions", "axes": "ned", "clock": {"mode": "lockstep"},
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "goal": {"duration_s": duration_s}, "planner": {"cruise_m_s": 2.5, "separation_m": SEPARATION_M},
        "vehicles": {"defaults": {"battery": {"capacity_j": 200_000}, "takeoff_m": 4}, "pursuers": list(pursuers)},
        **changes,
    }  # fmt: skip


def reached(outcome: Outcome, sysid: int) -> list[int]:
    """Items that a vehicle says it has reached, in its order."""
    return [m.seq for _, m in outcome.messages("MISSION_ITEM_REACHED") if m.get_srcSystem() == sysid]


def states(outcome: Outcome, sysid: int) -> list[str]:
    return [one["state"] for one in outcome.decisions if one["kind"] == "mission" and one["sysid"] == sysid]


def crossed(folder: Path) -> dict[str, Any]:
    """Three vehicles mow four rows of 20 m by one plan; two others go to and fro across the rows."""
    corners = [((0.0, 4.0 * k), (20.0, 4.0 * k))[:: 1 if k % 2 else -1] for k in range(ROWS)]
    plan = write_plan(folder / "mow.plan", [waypoint(n, e, 4.0) for row in corners for n, e in row])
    pursuers: list[dict[str, Any]] = [
        {"sysid": i + 1, "start_m": [-6.0 - 2 * i, -4.0 - 3 * (i % 2), 0.0], "mission": plan,
         "params": {"MPC_XY_CRUISE": 4.0}}
        for i in range(3)
    ]  # fmt: skip
    for j in range(2):
        east = 2.0 + 8.0 * j
        north = -8.0 if j % 2 else 28.0
        way = [[north if k % 2 else 20.0 - north, east + (0.0, 3.0, 0.0, -3.0)[k % 4], -4.0] for k in range(4)]
        pursuers.append({"sysid": 50 + j, "start_m": [north, east, 0.0], "waypoints_m": way})
    return scenario(pursuers, 100.0)


def test_a_fleet_on_one_plan_is_crossed_by_another(tmp_path: Path) -> None:
    one = fly(crossed(tmp_path), tmp_path)
    assert one.status == 0, one.summary["outcome_text"]
    assert nearest_m(at_grants(one, [1, 2, 3, 50, 51])) >= SEPARATION_M
    held = 0
    for sysid in (1, 2, 3):
        assert reached(one, sysid) == list(range(2 * ROWS))
        mission = one.vehicle(sysid)["mission"]
        assert (mission["items"], mission["reached"]) == (2 * ROWS, 2 * ROWS)
        assert mission["holds"] == states(one, sysid).count("held")
        held += mission["holds"]
        assert [item["text"] for item in one.vehicle(sysid)["check_list"]] == ["mission uploaded and read back"]
    assert held  # else the test would show nothing


@pytest.mark.parametrize(
    "starts",
    [
        [(-6.0 - 3 * (i % 3), -4.0 - 4.0 * (i // 3)) for i in range(5)],
        pytest.param(
            [(10.0 + 8.0 * math.cos(0.25 * math.pi * i), 8.0 * math.sin(0.25 * math.pi * i)) for i in range(8)],
            marks=pytest.mark.slow,
        ),
    ],
    ids=["rows", "ring"],
)
def test_many_that_begin_one_plan_together_all_fly_it(tmp_path: Path, starts: list[tuple[float, float]]) -> None:
    plan = write_plan(tmp_path / "mow.plan", [waypoint(n, e, 4.0) for n, e in ((20, 0), (0, 0), (0, 4), (20, 4))])
    pursuers = [
        {"sysid": i, "start_m": [north, east, 0.0], "mission": plan, "params": {"MPC_XY_CRUISE": 4.0}}
        for i, (north, east) in enumerate(starts, 1)
    ]
    outcome = fly(scenario(pursuers, 120.0), tmp_path)
    assert outcome.status == 0, outcome.summary["outcome_text"]
    assert nearest_m(at_grants(outcome, range(1, len(starts) + 1))) >= SEPARATION_M


def head_on(folder: Path, cruise_m_s: float) -> list[dict[str, Any]]:
    """Two that fly along one line, 30 m, each to where the other starts."""
    ends = {1: (0.0, 30.0), 2: (30.0, 0.0)}
    plans = {i: [speed(cruise_m_s), waypoint(0.0, to_m, 4.0)] for i, (_, to_m) in ends.items()}
    return [
        {"sysid": i, "start_m": [0.0, from_m, 0.0], "mission": write_plan(folder / f"{i}.plan", plans[i])}
        for i, (from_m, _) in ends.items()
    ]


@pytest.mark.parametrize("cruise_m_s", [2.0, 5.0])
def test_of_two_head_on_one_is_held_and_steps_aside_and_both_finish(tmp_path: Path, cruise_m_s: float) -> None:
    outcome = fly(scenario(head_on(tmp_path, cruise_m_s), 45.0), tmp_path)
    assert outcome.status == 0, outcome.summary["outcome_text"]
    assert nearest_m(at_grants(outcome, [1, 2])) >= SEPARATION_M
    assert states(outcome, 2) == ["begins", "held", "steps aside", "goes on", "flown"]
    assert states(outcome, 1)[0] == "begins"
    assert states(outcome, 1)[-1] == "flown"
    assert reached(outcome, 1) == reached(outcome, 2) == [0, 1]
    assert np.linalg.norm(outcome.truth(1).p_ned[-1] - (0.0, 30.0, -4.0)) < 1.0


def test_without_a_separation_they_meet(tmp_path: Path) -> None:
    """The other tests rest on this: their ways alone do not keep them apart."""
    content = scenario(
        head_on(tmp_path, 2.0), 30.0, planner={"separation_m": 0.05}, goal={"duration_s": 30.0, "separation_m": 0.05}
    )
    assert nearest_m(at_grants(fly(content, tmp_path), [1, 2])) < 0.6


def test_an_operator_takes_one_from_its_mission_and_it_goes_on_with_the_same_item(tmp_path: Path) -> None:
    plan = write_plan(tmp_path / "way.plan", [speed(2.0), *(waypoint(0.0, 8.0 * k, 4.0) for k in range(1, 4))])
    tanker = {"sysid": 201, "start_m": [-9.0, 0.0, 0.0]}
    content = scenario([{"sysid": 1, "start_m": [0.0, 0.0, 0.0], "mission": plan}], 45.0)
    content["vehicles"]["tankers"] = [tanker]
    path = tmp_path / "scenario.yaml"
    path.write_text(yaml.safe_dump(content), encoding="utf-8")
    orders = [(11.0, "hold"), (16.0, "rejoin"), (20.0, "refuel")]
    modes: list[str] = []
    said = ""
    with gcs.Session(path, out=tmp_path / "session") as session:
        for snapshot in session:
            if orders and snapshot.time_s >= orders[0][0]:
                modes.append(str(snapshot.mode[snapshot.row(1)]))
                try:
                    session.command(1, orders.pop(0)[1])
                except gcs.SessionError as error:
                    said = str(error)
    outcome = Outcome(0, tmp_path / "session", "", "")
    assert modes == ["mission", "hold", "mission"]
    assert said == "Pursuer 1 is on its mission: it is refuelled when it has flown it."
    assert reached(outcome, 1) == [0, 1, 2, 3]
    assert outcome.summary["outcome"] == "met"


SENT = {
    "px4": [(mav.MAV_CMD_DO_SET_MODE, (4, 4)), (mav.MAV_CMD_DO_SET_MODE, (4, 3))],
    "ardupilot": [(mav.MAV_CMD_MISSION_START, (0, 0)), (mav.MAV_CMD_DO_SET_MODE, (17, 0))],
}
"""Commands by which each autopilot begins or goes on, and holds: custom mode AUTO.MISSION, AUTO.LOITER; BRAKE."""


@pytest.mark.slow
def test_px4s_and_ardupilots_that_others_started_get_their_plans_and_their_own_commands(tmp_path: Path) -> None:
    """Two pairs, one of each autopilot, head-on along lines 20 m apart; in each pair the second is held."""
    port = free_port()
    kinds = {1: "px4", 2: "ardupilot", 3: "ardupilot", 4: "px4"}
    pursuers, commands = [], []
    parameters = tmp_path / "parameters.yaml"
    parameters.write_text(yaml.safe_dump({"MPC_XY_CRUISE": 3.0, "SIM_BAT_CAP_J": 200_000}), encoding="utf-8")
    for sysid, kind in kinds.items():
        north, begins, ends = 20.0 * (sysid > 2), *((0.0, 30.0) if sysid % 2 else (30.0, 0.0))
        plan = write_plan(tmp_path / f"{sysid}.plan", [waypoint(north, 15.0, 4.0), waypoint(north, ends, 4.0)])
        external = {"connect": f"udpin:127.0.0.1:{port}", "sysid": sysid, "capacity_j": 200_000}
        pursuers.append({"external": external, "mission": plan})
        commands.append([*SIMVEHICLE, "--sysid", str(sysid), "--autopilot", kind, "--params", str(parameters),
                         "--connect", f"udpout:127.0.0.1:{port}", "--position", f"{north},{begins},0",
                         "--home", ",".join(map(str, ORIGIN))])  # fmt: skip
    content = scenario(pursuers, 45.0, clock={"mode": "real"})
    del content["vehicles"]["defaults"]["battery"]
    with strangers(tmp_path / "logs", *commands):
        outcome = fly(content, tmp_path)
    assert outcome.status == 0, outcome.summary["outcome_text"]
    assert outcome.summary["min_separation_m"] >= SEPARATION_M  # no one but the supervisor keeps these apart
    for sysid, kind in kinds.items():
        home = int(kind == "ardupilot")
        uploaded = [m for _, m in outcome.messages("MISSION_COUNT") if m.target_system == sysid]
        assert [m.count for m in uploaded] == [2 + home]
        assert "mission uploaded and read back" in [item["text"] for item in outcome.vehicle(sysid)["check_list"]]
        assert reached(outcome, sysid) == [*range(2 + home)] or reached(outcome, sysid) == [1, 2]
        sent = [(m.command, m.param1, m.param2, m.param3) for _, m in outcome.messages("COMMAND_LONG")
                if m.target_system == sysid]  # fmt: skip
        begin, hold = (_sent(sent, *one) for one in SENT[kind])
        held = states(outcome, sysid).count("held")
        assert begin >= 1 + states(outcome, sysid).count("goes on")
        assert hold >= held
        if sysid % 2 == 0:
            assert states(outcome, sysid)[:3] == ["begins", "held", "steps aside"]
        assert states(outcome, sysid)[-1] == "flown"


def _sent(sent: Sequence[tuple[float, ...]], command: int, numbers: tuple[int, int]) -> int:
    """How often a command was sent with these numbers: of DO_SET_MODE main and sub mode, else the first two."""
    at = 2 if command == mav.MAV_CMD_DO_SET_MODE else 1
    return sum(one[0] == command and one[at : at + 2] == numbers for one in sent)
