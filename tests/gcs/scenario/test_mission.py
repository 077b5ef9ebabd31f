"""A pursuer's `mission`: read from a plan, written out whole, and refused by one sentence where it cannot be flown."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from mission_files import ORIGIN, TAKEOFF, item, speed, waypoint, write_plan

from gcs.scenario.document import ScenarioError
from gcs.scenario.file import dump, load
from gcs.scenario.parts.mission import way_of

NEAR = waypoint(10.0, 5.0, 4.0)


def scenario(folder: Path, items: Sequence[dict[str, Any]] | None, pursuer: dict[str, Any], **changes: Any) -> Path:
    if items is not None:
        write_plan(folder / "way.plan", items)
    content = {
        "schema": 1, "name": "m", "axes": "ned", "goal": {"duration_s": 60.0},
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "vehicles": {"pursuers": [
            {"sysid": 1, "start_m": [0.0, 0.0, 0.0], "battery": {"capacity_j": 6e4}, "mission": "way.plan", **pursuer}
        ]},
        **changes,
    }  # fmt: skip
    path = folder / "scenario.yaml"
    path.write_text(yaml.safe_dump(content, sort_keys=False), encoding="utf-8")
    return path


def test_its_items_lead_where_the_file_says_and_are_written_out(tmp_path: Path) -> None:
    takeoff = item(TAKEOFF, [0, 0, 0, None, 0, 0, 6.0])
    sea = item(16, [0, 0, 0, None, *waypoint(20.0, 0.0, 0.0)["params"][4:6], ORIGIN[2] + 9.0], 0)
    path = scenario(tmp_path, [takeoff, speed(2.0), NEAR, sea], {})
    found = load(path)
    (pursuer,) = found.vehicles.pursuers
    expected = [(0.0, 0.0, -6.0), (10.0, 5.0, -4.0), (20.0, 0.0, -9.0)]
    np.testing.assert_allclose(way_of(pursuer, found), expected, atol=0.02)
    (tmp_path / "way.plan").unlink()
    written = tmp_path / "written.yaml"
    written.write_text(dump(found), encoding="utf-8")
    assert load(written) == found


REFUSED: dict[str, tuple[Sequence[dict[str, Any]] | None, dict[str, Any], dict[str, Any], str]] = {
    "missing": (None, {}, {}, "way.plan cannot be read: No such file or directory"),
    "empty": ([], {}, {}, "way.plan holds no mission item"),
    "nowhere": ([speed(2.0)], {}, {}, "the mission leads nowhere: none of its items has a place"),
    "low": ([waypoint(5.0, 0.0, -2.0)], {}, {}, "item 1 of the mission lies -2.0 m above the ground, below 0.3 m"),
    "far": ([waypoint(1500.0, 0.0, 4.0)], {}, {}, "item 1 of the mission lies 1500 m from its start, more than 900 m"),
    "fence": ([NEAR, waypoint(30.0, 0.0, 4.0)], {}, {"fence": {"inside": [{"circle_m": [0.0, 0.0], "radius_m": 20.0}]}},
              "item 2 of the mission lies beyond the fence"),
    "obstacle": ([NEAR], {}, {"obstacles": [{"sphere_m": [5.0, 2.5, -3.3], "radius_m": 0.5, "name": "buoy"}]},
                 "the way to item 1 of the mission passes"),
    "return": ([NEAR, item(20, [0] * 7, 2)], {}, {}, "item 2 of the mission is NAV_RETURN_TO_LAUNCH: the session"),
    "jump": ([NEAR, item(177, [1, 2, 0, 0, 0, 0, 0], 2)], {}, {}, "item 2 of the mission is DO_JUMP, whose way is not"),
    "late": ([NEAR, item(TAKEOFF, [0, 0, 0, None, 0, 0, 6.0])], {}, {}, "item 2 of the mission is a take-off, which"),
    "terrain": ([item(16, [0, 0, 0, None, 47.397742, 8.5456, 4.0], 10)], {}, {},
                "item 1 of the mission has its place in GLOBAL_TERRAIN_ALT: give its height above home or the sea"),
    "waypoints": ([NEAR], {"waypoints_m": [[1.0, 0.0, -3.0]]}, {}, "has a mission and waypoints_m; leave one out"),
    "transfer": ([NEAR], {"transfer": True}, {}, "is not refuelled while it flies its mission"),
    "safety": ([NEAR], {}, {"planner": {"safety": False}}, "a vehicle on a mission is kept apart by the safety filter"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_flown_is_refused_by_one_sentence_at_its_line(tmp_path: Path, case: str) -> None:
    items, pursuer, changes, sentence = REFUSED[case]
    path = scenario(tmp_path, items, pursuer, **changes)
    with pytest.raises(ScenarioError) as refused:
        load(path)
    (problem,) = refused.value.problems
    assert sentence in problem.message
    assert problem.line is not None
    lines = path.read_text(encoding="utf-8").splitlines()
    assert lines[problem.line - 1].strip() == "mission: way.plan"
