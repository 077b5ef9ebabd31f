"""The fuzzy escape: past an obstacle exactly on the line to the target, by a real vehicle.

The field's minimum in front of such an obstacle is a saddle: a nanometre to the side frees the vehicle. So the scene is
exactly axis-aligned, and lies north of the origin, where the local frames agree to the last bit.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sessions import Outcome, fly, small


def scene(escape: bool) -> dict[str, Any]:
    content = small(
        goal={"duration_s": 40.0, "refuelled_at_least": 0},
        formation={"ring_m": 0.001},
        planner={"escape": escape, "cruise_m_s": 1.0, "safety": False},  # the field alone, without the guide
        obstacles=[{"point_m": [5.0, 0.0, -2.5]}],
        refuelling={"enabled": False},
    )
    pursuer, target = content["vehicles"]["pursuers"][0], content["vehicles"]["targets"][0]
    for vehicle, north in ((pursuer, 0.0), (target, 10.0)):
        vehicle |= {"start_m": [north, 0.0, -2.5], "airborne": True, "battery": {"capacity_j": 60000}}
    target["path_m"] = [[10.0, 0.0, -2.5]]
    content["vehicles"]["tankers"] = []
    return content


def flown(tmp_path: Path, escape: bool) -> Outcome:
    return fly(scene(escape), tmp_path, "--plain")


def test_with_the_fuzzy_escape_it_passes(tmp_path: Path) -> None:
    p_ned = flown(tmp_path, True).truth(1).p_ned
    assert p_ned[-1, 0] > 8.0
    gaps = np.linalg.norm(p_ned - (5.0, 0.0, -2.5), axis=1)
    assert gaps.min() >= 0.3


def test_without_the_fuzzy_escape_it_stops_there(tmp_path: Path) -> None:
    truth = flown(tmp_path, False).truth(1)
    assert truth.p_ned[-1, 0] < 5.0
    assert truth.p_ned[-1] == pytest.approx((4.3, 0.0, -2.5), abs=0.3)
    assert np.linalg.norm(truth.state[-1, 3:6]) < 0.05
