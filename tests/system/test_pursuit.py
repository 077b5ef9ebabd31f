"""Pursuit by competition in a whole session: one vehicle for each target, the others hold, and the roles change."""

from __future__ import annotations

import json
import math
from importlib import resources
from pathlib import Path
from typing import Any

import jsonschema
from sessions import fly


def vehicle(sysid: int, *at: float) -> dict[str, Any]:
    return {"sysid": sysid, "start_m": list(at), "airborne": True, "battery": {"capacity_j": 60000}}


SCENARIO: dict[str, Any] = {
    "schema": 1,
    "name": "hand-over",
    "axes": "ned",
    "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0},
    "clock": {"mode": "lockstep"},
    "goal": {"duration_s": 40.0, "pursue": {"within_m": 3.0, "for_s": 5.0}, "separation_m": False},  # without a ring
    "vehicles": {
        # The target is faster than they are: the first falls behind, the second waits ahead, the third is far aside.
        "pursuers": [vehicle(1, 2.0, 3.0, -5.0), vehicle(2, 28.0, 3.0, -5.0), vehicle(3, 15.0, 40.0, -5.0)],
        "targets": [vehicle(101, 0.0, 0.0, -5.0) | {"path_m": [[0.0, 0.0, -5.0], [30.0, 0.0, -5.0]], "speed_m_s": 1.6}],
    },
    "planner": {"cruise_m_s": 1.2},
    "pursuit": {"by": "competition"},
}


def test_the_target_is_handed_over_to_whom_it_costs_least_while_the_others_hold(tmp_path: Path) -> None:
    outcome = fly(SCENARIO, tmp_path, "--plain")
    assert outcome.status == 0, outcome.stdout
    decisions = outcome.decisions
    changes = [d for d in decisions if d["kind"] == "pursuit"]
    assert [(d["before"], d["pursuer"]) for d in changes] == [(None, 1), (1, 2)]
    schema = json.loads(resources.files("gcs").joinpath("schemas/decisions.schema.json").read_text(encoding="utf-8"))
    for change in changes:
        jsonschema.Draft202012Validator(schema).validate(change)
        efforts = change["efforts"]
        assert efforts[str(change["pursuer"])] == min(efforts.values())
    handed_s = changes[1]["t_s"]
    points = [d for d in decisions if d["kind"] == "set_point"]
    for sysid, from_s, to_s in (
        (3, 0.0, math.inf),
        (2, 0.0, handed_s),
        (1, handed_s + 0.5, math.inf),
    ):  # its leader brakes
        speeds = [math.hypot(*d["v_ned"]) for d in points if d["sysid"] == sysid and from_s <= d["t_s"] < to_s]
        assert len(speeds) > 50
        assert max(speeds) == 0.0
