"""Vehicles on missions: where one that holds may come back to, and what people read of one that waits."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import yaml
from mission_files import ORIGIN, waypoint, write_plan
from views import snapshot, view

from gcs.refuelling.participation import Participation
from gcs.scenario.file import load
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import Stage
from gcs.supervisor.factory import make_arming_sequences
from gcs.supervisor.mission_watch import SETTLES_S, MissionFlight, MissionWatch

BRAKES = np.array([(0.0, 0.0, -5.0), (7.0, 0.0, -5.0)])


def scenario(folder: Path, *ways_north_m: tuple[float, float]) -> Scenario:
    """Vehicles 1, 2, … that start and end so far north, each by a plan of its own."""
    pursuers = [
        {
            "sysid": sysid, "start_m": [begin_m, 0.0, 0.0], "battery": {"capacity_j": 6e4},
            "mission": write_plan(folder / f"{sysid}.plan", [waypoint(end_m, 0.0, 4.0)]),
        }
        for sysid, (begin_m, end_m) in enumerate(ways_north_m, 1)
    ]  # fmt: skip
    origin = dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True))
    content = {"schema": 1, "name": "m", "axes": "ned", "goal": {"duration_s": 60.0}, "origin": origin}
    path = folder / "scenario.yaml"
    path.write_text(yaml.safe_dump({**content, "vehicles": {"pursuers": pursuers}}), encoding="utf-8")
    return load(path)


def held(folder: Path) -> MissionFlight:
    """One that was ordered to hold at 0 m and may stand until 7 m north."""
    found = scenario(folder, (0.0, 20.0))
    flight = MissionFlight(found.vehicles.pursuers[0], found)
    flight.held_ned = BRAKES
    return flight


def seen(flight: MissionFlight, north_m: float, speed_m_s: float, now_s: float) -> None:
    stands: Any = SimpleNamespace(v_ned=(speed_m_s, 0.0, 0.0), p_now_ned=lambda: (north_m, 0.0, -5.0))
    flight.settle(stands, now_s)


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


def test_a_vehicle_that_an_operator_takes_waits_for_none(tmp_path: Path) -> None:
    found = scenario(tmp_path, (0.0, 3.0), (3.0, 0.0))
    arming = make_arming_sequences(found)
    for one in arming.values():
        one.stage = Stage.FLY
    watch = MissionWatch(found, arming, Participation())
    now = snapshot(view(1, p_ned=(0.0, 0.0, -4.0)), view(2, p_ned=(3.0, 0.0, -4.0)))
    watch.decide(now, may_begin=True)
    notes = {sysid: watch.note(sysid) for sysid in arming}
    (waiting,) = [sysid for sysid, note in notes.items() if "waits for pursuer" in note]
    arming[waiting].stage = Stage.TAKEN
    watch.decide(now, may_begin=True)
    assert watch.note(waiting) == "mission item 1 of 1"
