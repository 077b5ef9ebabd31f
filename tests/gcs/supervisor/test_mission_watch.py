"""Where a vehicle that holds on its mission may come back to."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import yaml
from mission_files import ORIGIN, waypoint, write_plan

from gcs.scenario import load
from gcs.supervisor.mission_watch import SETTLES_S, MissionFlight

BRAKES = np.array([(0.0, 0.0, -5.0), (7.0, 0.0, -5.0)])


def held(folder: Path) -> MissionFlight:
    """One that was ordered to hold at 0 m and may stand until 7 m north."""
    plan = write_plan(folder / "to.plan", [waypoint(20, 0, 5)])
    content = {
        "schema": 1, "name": "held", "axes": "ned",
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)), "goal": {"duration_s": 60.0},
        "vehicles": {
            "defaults": {"battery": {"capacity_j": 200_000}},
            "pursuers": [{"sysid": 1, "start_m": [0, 0, 0], "mission": plan}],
        },
    }  # fmt: skip
    (folder / "scenario.yaml").write_text(yaml.safe_dump(content), encoding="utf-8")
    scenario = load(folder / "scenario.yaml")
    flight = MissionFlight(scenario.vehicles.pursuers[0], scenario)
    flight.held_ned = BRAKES
    return flight


def seen(flight: MissionFlight, north_m: float, speed_m_s: float, now_s: float) -> None:
    view: Any = SimpleNamespace(v_ned=(speed_m_s, 0.0, 0.0), p_now_ned=lambda: (north_m, 0.0, -5.0))
    flight.settle(view, now_s)


def test_one_that_has_stood_for_a_while_comes_back_to_no_other_place(tmp_path: Path) -> None:
    flight = held(tmp_path)
    seen(flight, 4.0, 2.0, 1.0)
    seen(flight, 5.1, 0.0, 1.5)
    seen(flight, 5.1, 0.0, 1.0 + SETTLES_S - 0.1)
    assert flight.held_ned is BRAKES
    seen(flight, 5.1, 0.0, 1.0 + SETTLES_S)
    np.testing.assert_array_equal(flight.held_ned, [(5.1, 0.0, -5.0)])


def test_one_that_turns_back_has_not_stood(tmp_path: Path) -> None:
    flight = held(tmp_path)
    for now_s, speed_m_s in ((1.0, 2.0), (3.0, 0.0), (3.9, -1.0), (6.0, 0.0)):
        seen(flight, 6.0, speed_m_s, now_s)
    assert flight.held_ned is BRAKES


def test_one_that_does_not_hold_keeps_no_place(tmp_path: Path) -> None:
    flight = held(tmp_path)
    flight.held_ned = BRAKES[:0]
    for now_s in (0.0, 9.0):
        seen(flight, 3.0, 0.0, now_s)
    assert not len(flight.held_ned)
