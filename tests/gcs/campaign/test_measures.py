"""What a campaign measures, on places that are written down."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import yaml

from gcs.campaign.measures import SHIPPED, Flown
from gcs.scenario.file import load

BATTERY = {"capacity_j": 40_000, "initial_percent": 90, "hover_w": 200}
SILENCE = {"from_s": 10.0, "to_s": 20.0}


def flown(folder: Path, service: dict[str, Any], near_s: float) -> Any:
    """A tanker and a receiver 3 m apart, and 0.5 m at one time, with one service."""
    text = {
        "schema": 1,
        "name": "near",
        "axes": "ned",
        "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400},
        "vehicles": {
            "pursuers": [
                {"sysid": 1, "start_m": [0, 0, -10], "airborne": True, "battery": BATTERY, "waypoints_m": [[9, 0, -10]]}
            ],
            "tankers": [{"sysid": 201, "start_m": [0, 3, -10], "airborne": True, "battery": BATTERY}],
        },
        "planner": {"separation_m": 0.8},
        "radio": {"ground_blackouts": [SILENCE]},
        "goal": {"duration_s": 60},
        "traffic": [
            {"callsign": "BY", "path_m": [[-10, -1.5, -10], [40, -1.5, -10]], "speed_m_s": 1},
            {"callsign": "BAIT", "path_m": [[0, 0.2, -10], [0.1, 0.2, -10]], "speed_m_s": 1, "attracts": True},
        ],
    }
    path = folder / "scenario.yaml"
    path.write_text(yaml.safe_dump(text))
    times_s = np.arange(0.0, 60.0, 0.1)
    away_m = np.where(np.abs(times_s - near_s) < 0.05, 0.5, 3.0)
    still = np.zeros_like(times_s)
    rows = {
        1: np.stack([times_s, still, still, still - 10.0], axis=1),
        201: np.stack([times_s, still, away_m, still - 10.0], axis=1),
    }
    return SimpleNamespace(scenario=load(path), summary={"refuelling": [service]}, truth=rows.__getitem__)


def test_a_service_under_way_at_the_end_is_no_refuelling_though_its_energy_counts() -> None:
    fed = [{"energy_j": 900.0, "decided_at_s": 1.0, "start_s": 3.0, "end_s": 9.0}]
    fed += [{"energy_j": 500.0, "decided_at_s": 9.0, "start_s": 13.0, "end_s": None}]
    session: Any = SimpleNamespace(summary={"refuelling": fed, "refuel_order": [1]})
    assert [SHIPPED[name][0](session) for name in ("refuelled", "delivered_j", "wait_s")] == [1.0, 1400.0, 3.0]


@pytest.mark.parametrize(
    ("decided_at_s", "end_s", "near_s", "counts"),
    [
        (2.0, 8.0, 11.0, False),  # they part
        (2.0, 8.0, 12.0, True),
        (2.0, 30.0, 13.0, False),  # the silence ends it, and they part
        (2.0, 30.0, 14.0, True),
        (22.0, 40.0, 30.0, False),  # after the silence
        (22.0, 40.0, 44.0, True),
    ],
)
def test_partners_may_be_near_until_they_have_parted_and_no_longer(
    decided_at_s: float, end_s: float | None, near_s: float, counts: bool, tmp_path: Path
) -> None:
    service = {"tanker": 201, "receiver": 1, "decided_at_s": decided_at_s, "end_s": end_s}
    spare, _ = SHIPPED["spare_m"]
    assert spare(flown(tmp_path, service, near_s)) == pytest.approx(0.5 - 0.8 if counts else 3.0 - 0.8)


def test_the_distance_to_aircraft_is_to_where_their_paths_lead(tmp_path: Path) -> None:
    """One passes the receiver at 1.5 m, another one that attracts does not count."""
    aircraft, _ = SHIPPED["aircraft_m"]
    service = {"tanker": 201, "receiver": 1, "decided_at_s": 1.0, "end_s": None}
    assert aircraft(flown(tmp_path, service, 5.0)) == pytest.approx(1.5 - 0.8)


def apart(folder: Path, *, airborne: bool, down_m: float, ends_s: float) -> Any:
    """Vehicle 1 comes by vehicle 2 at 2 m, an obstacle at 1 m and an aircraft at 3 m, at 12 s and in the station's
    silence; 3, which is far away, records until `ends_s` and dies."""
    pursuer = {"battery": BATTERY, "airborne": airborne}
    text = {
        "schema": 1,
        "name": "apart",
        "axes": "ned",
        "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400},
        "vehicles": {
            "pursuers": [
                {"sysid": sysid, "start_m": [0, east_m, 0], "waypoints_m": [[9, east_m, -10]], **pursuer}
                for sysid, east_m in ((1, 0), (2, 10), (3, 80))
            ],
        },
        "planner": {"separation_m": 0.8},
        "radio": {"ground_blackouts": [SILENCE]},
        "obstacles": [{"name": "ball", "sphere_m": [0, -2, down_m], "radius_m": 1}],
        "traffic": [{"callsign": "BY", "path_m": [[0, -3, down_m], [0.1, -3, down_m]], "speed_m_s": 1}],
        "goal": {"duration_s": 20},
    }
    path = folder / "scenario.yaml"
    path.write_text(yaml.safe_dump(text))
    times_s = np.arange(0.0, 20.05, 0.1)
    east_m = 2.0 + np.abs(times_s - 12.0)
    rows = {
        sysid: np.stack([times_s, times_s - 12.0, own_m, down_m + 0.0 * times_s], axis=1)
        for sysid, own_m in ((1, 0.0 * times_s), (2, east_m), (3, 80.0 + 0.0 * times_s))
    }
    rows[3] = rows[3][times_s < ends_s]
    final = {1: "offboard", 2: "offboard", 3: "dead"}
    summary = {
        "refuelling": [],
        "sim_time_s": 20.0,
        "vehicles": [{"sysid": sysid, "final_mode": mode} for sysid, mode in final.items()],
    }
    return SimpleNamespace(scenario=load(path), summary=summary, truth=rows.__getitem__)


WANTED = {"spare_m": 2.0 - 0.8, "solid_m": 1.0, "aircraft_m": 3.0 - 0.8, "aloft": 2.0}


@pytest.mark.parametrize(("name", "value"), WANTED.items())
@pytest.mark.parametrize("ends_s", [5.0, 20.1])
def test_the_living_are_measured_after_the_death_of_another(
    name: str, value: float, ends_s: float, tmp_path: Path
) -> None:
    measure, _ = SHIPPED[name]
    assert measure(apart(tmp_path, airborne=False, down_m=-4.0, ends_s=ends_s)) == pytest.approx(value, abs=0.15)


@pytest.mark.parametrize(("name", "value"), WANTED.items())
def test_vehicles_that_started_airborne_fly_at_any_height(name: str, value: float, tmp_path: Path) -> None:
    measure, _ = SHIPPED[name]
    assert measure(apart(tmp_path, airborne=True, down_m=0.0, ends_s=5.0)) == pytest.approx(value, abs=0.15)


def test_what_a_vehicle_without_truth_did_is_not_known(tmp_path: Path) -> None:
    without = apart(tmp_path, airborne=False, down_m=-4.0, ends_s=0.0)
    assert [SHIPPED[name][0](without) for name in WANTED] == [None] * len(WANTED)


@pytest.mark.parametrize(("ends_s", "stuck"), [(20.1, 1.0), (0.0, None)])
def test_pursuers_that_recorded_nothing_are_not_known_to_be_stuck(
    ends_s: float, stuck: float | None, tmp_path: Path
) -> None:
    """2 stays 10 m away from its way point, or left no truth, and the others stay at theirs."""
    (tmp_path / "vehicles").mkdir()
    scenario = apart(tmp_path, airborne=True, down_m=-10.0, ends_s=20.1).scenario
    places = {1: (9.0, 0.0, -10.0), 2: (9.0, 0.0, -10.0), 3: (9.0, 80.0, -10.0)}
    for sysid, place in places.items():
        times_s = np.arange(0.0, ends_s if sysid == 2 else 20.1, 0.1)
        head = json.dumps({"state": ["n", "e", "d"], "energy": []}).encode() + b"\n"
        records = [[time_s, 0.0, *place] for time_s in times_s]
        (tmp_path / "vehicles" / f"{sysid}.truth").write_bytes(head + np.array(records, dtype="<f8").tobytes())
    assert SHIPPED["stuck"][0](Flown(tmp_path, scenario)) == stuck
