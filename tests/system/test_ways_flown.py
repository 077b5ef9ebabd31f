"""How far and how fast vehicles flew, by summary, report and their own truth (a real session, in lockstep)."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sessions import Outcome, fly, small

from gcs.recording.session_folder import read
from gcs.report import tables
from gcs.report.findings import Findings

CRUISES, RUNS_DRY = 1, 2


@pytest.fixture(scope="module")
def outcome(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    """Two that start in the air, where there is no ground; one of them falls from 3 s on."""
    goal = {"duration_s": 8.0, "refuelled_at_least": 0, "waypoints": "none", "lost_at_most": 1}
    content = small(goal=goal, refuelling={"enabled": False})
    del content["formation"]
    pursuers: list[dict[str, Any]] = [
        {"sysid": sysid, "start_m": [0.0, east_m, -30.0], "airborne": True, "waypoints_m": [[40.0, east_m, -30.0]]}
        for sysid, east_m in ((CRUISES, 0.0), (RUNS_DRY, 30.0))
    ]
    for pursuer, capacity_j in zip(pursuers, (60_000, 600), strict=True):
        pursuer["battery"] = {"capacity_j": capacity_j}
    content["vehicles"] = {"pursuers": pursuers}
    flown = fly(content, tmp_path_factory.mktemp("ways"), "--plain")
    assert flown.status == 0, flown.stdout + flown.stderr
    return flown


def test_a_way_is_as_long_as_the_vehicles_own_to_the_last_report(outcome: Outcome) -> None:
    flown = outcome.truth(CRUISES)
    assert (flown.time_s[0], flown.time_s[-1]) == pytest.approx((0.0, 8.0))
    steps_m = np.linalg.norm(np.diff(flown.p_ned, axis=0), axis=1)
    assert steps_m[-1] > 0.1
    assert outcome.vehicle(CRUISES)["path_length_m"] == pytest.approx(steps_m.sum(), abs=0.01)


def top_speed_m_s(folder: Path, sysid: int) -> float:
    table = tables.numbers(Findings(read(folder)))
    heads = re.findall(r"<th[^>]*>([^<]*)</th>", table[: table.index("</thead>")])
    row = next(row for row in re.findall(r"<tr>(.*?)</tr>", table) if f">pursuer {sysid}<" in row)
    return float(re.findall(r"<td[^>]*>([^<]*)</td>", row)[heads.index("top speed (m/s)")])


def test_a_fall_with_an_empty_battery_is_no_way_and_no_top_speed(outcome: Outcome) -> None:
    flown = outcome.truth(RUNS_DRY)
    speed_m_s = np.linalg.norm(flown.state[:, 3:6], axis=1)
    assert speed_m_s.max() > 30.0
    empty = np.flatnonzero(flown.drawn_from_thrust_j() >= 600.0)[0]
    known = np.searchsorted(flown.time_s, flown.time_s[empty] + 1.0)  # BATTERY_STATUS comes each second at least
    ways_m = np.concatenate([[0.0], np.linalg.norm(np.diff(flown.p_ned, axis=0), axis=1).cumsum()])
    assert ways_m[empty] - 0.3 < outcome.vehicle(RUNS_DRY)["path_length_m"] < ways_m[known] < 0.2 * ways_m[-1]
    assert top_speed_m_s(outcome.folder, RUNS_DRY) < speed_m_s[known] < 0.3 * speed_m_s.max()
    assert top_speed_m_s(outcome.folder, CRUISES) == pytest.approx(1.61, abs=0.05)
