"""One plan of 20 items for nine vehicles, which six others cross: three ArduCopters and three PX4s in lockstep beside
three of ours where SKYTENDER_ARDUCOPTER and SKYTENDER_PX4 name them, else nine of ours."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from mission_files import ORIGIN, waypoint, write_plan
from sessions import fly_apart
from ways import at_grants, nearest_m

ARDUCOPTER, PX4 = os.environ.get("SKYTENDER_ARDUCOPTER", ""), os.environ.get("SKYTENDER_PX4", "")
PATIENCE_S = 1200.0
"""Wall time of a session: with real autopilots it takes two minutes on two cores that are free."""
SEPARATION_M = 1.0
ROWS, EACH, CROSSING = 10, 3, 6
OURS: dict[str, Any] = {"params": {"MPC_XY_CRUISE": 4.0}}
FLEETS = [
    pytest.param([OURS, OURS, OURS], id="ours"),
    pytest.param(
        [OURS, {"autopilot": {"ardupilot": ARDUCOPTER}}, {"autopilot": {"px4": PX4}}],
        marks=pytest.mark.skipif(
            not (ARDUCOPTER and PX4), reason="SKYTENDER_ARDUCOPTER and SKYTENDER_PX4 do not name both"
        ),
        id="real",
    ),
]


@pytest.mark.slow
@pytest.mark.timeout(PATIENCE_S + 60.0)
@pytest.mark.parametrize("kinds", FLEETS)
def test_nine_fly_one_plan_of_20_items_which_six_others_cross(tmp_path: Path, kinds: list[dict[str, Any]]) -> None:
    """The nine mow ten rows of 20 m; the six go to and fro across the rows."""
    corners = [((0.0, 4.0 * k), (20.0, 4.0 * k))[:: 1 if k % 2 else -1] for k in range(ROWS)]
    plan = write_plan(tmp_path / "mow.plan", [waypoint(n, e, 4.0) for row in corners for n, e in row])
    pursuers: list[dict[str, Any]] = [
        {"sysid": 1 + EACH * k + i, "start_m": [-6.0 - 3.0 * i, -4.0 - 4.0 * k, 0.0], "mission": plan, **kind}
        for k, kind in enumerate(kinds)
        for i in range(EACH)
    ]
    mowing = [one["sysid"] for one in pursuers]
    for j in range(CROSSING):
        north, east = (-8.0 if j % 2 else 28.0), 2.0 + 7.2 * j
        way = [[north if k % 2 else 20.0 - north, east + (0.0, 3.0, 0.0, -3.0)[k % 4], -4.0] for k in range(8)]
        pursuers.append({"sysid": 50 + j, "start_m": [north, east, 0.0], "waypoints_m": way})
    content = {
        "schema": 1, "name": "mowing", "axes": "ned", "clock": {"mode": "lockstep"},
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "goal": {"duration_s": 400.0}, "planner": {"cruise_m_s": 2.5, "separation_m": SEPARATION_M},
        "vehicles": {"defaults": {"battery": {"capacity_j": 400_000}, "takeoff_m": 4}, "pursuers": pursuers},
    }  # fmt: skip
    outcome = fly_apart(content, tmp_path, "--plain", patience_s=PATIENCE_S)
    assert outcome.status == 0, outcome.summary["outcome_text"]
    nearest = nearest_m(at_grants(outcome, [one["sysid"] for one in pursuers]))
    print(f"nearest: {nearest:.2f} m; {outcome.summary['digest']}; {outcome.summary['wall_time_s']:.0f} s of wall time")
    assert nearest >= SEPARATION_M
    for sysid in mowing:
        vehicle = outcome.vehicle(sysid)
        assert (vehicle["mission"]["items"], vehicle["mission"]["reached"]) == (2 * ROWS, 2 * ROWS)
        assert "mission uploaded and read back" in [item["text"] for item in vehicle["check_list"]]
    assert sum(outcome.vehicle(sysid)["mission"]["holds"] for sysid in mowing)  # else the test would show nothing
