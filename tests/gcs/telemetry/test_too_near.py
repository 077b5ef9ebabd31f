"""Vehicles that are still too near after a breach: distances by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from scenarios import SMALL, loaded
from views import snapshot, view

from gcs.mavlink.autopilots import FlightMode
from gcs.scenario.model import Scenario
from gcs.telemetry.proximity import too_near

MAST = "obstacles: [{name: mast, cylinder_m: [10, 10], radius_m: 0.5, bottom_m: 0, top_m: -6}]\n"
PAIR = {"part": "separation", "sysids": [1, 2], "what": "", "limit": 1.5}
SHAPE = {"part": "clearance", "sysids": [1], "what": "mast", "limit": 0.4}


@pytest.fixture
def scenario(tmp_path: Path) -> Scenario:
    return loaded(tmp_path / "near.yaml", SMALL + MAST)


@pytest.mark.parametrize(
    ("first", "second", "found"),
    [
        # 0.6 m and 0.8 m make 1 m; 10.8 m north is 0.8 m from the axis, 0.3 m from the surface
        ({"p_ned": (10.8, 10.0, -4.0)}, {"p_ned": (11.4, 10.8, -4.0)}, {1: "0.30 m from mast", 2: "1.00 m from one"}),
        ({"p_ned": (12.0, 10.0, -4.0)}, {"p_ned": (12.6, 10.8, -4.0)}, {1: "1.00 m from two", 2: "1.00 m from one"}),
        ({"p_ned": (12.0, 10.0, -4.0)}, {"p_ned": (13.2, 11.0, -4.0)}, {}),
        ({"p_ned": (12.0, 10.0, -4.0)}, {"p_ned": (12.6, 10.8, -4.0), "armed": False}, {}),
        ({"p_ned": (12.0, 10.0, -4.0)}, {"p_ned": (12.6, 10.8, -4.0), "age_s": 9.0}, {}),
        ({"p_ned": (12.0, 10.0, -4.0)}, {"p_ned": (12.6, 10.8, -4.0), "mode": FlightMode.REFUEL}, {}),
        ({"p_ned": (12.0, 10.0, -4.0), "alive": False}, {"p_ned": (12.6, 10.8, -4.0)}, {}),
    ],
)
def test_who_is_too_near_again_is_named_with_the_distance(
    scenario: Scenario, first: Any, second: Any, found: dict[int, str]
) -> None:
    seen = snapshot(view(1, label="one", **first), view(2, label="two", **second))
    assert too_near([PAIR, SHAPE], seen, scenario) == found
    assert too_near([], seen, scenario) == {}


def test_an_obstacle_that_is_gone_is_near_to_none(scenario: Scenario) -> None:
    seen = snapshot(view(1, p_ned=(10.8, 10.0, -4.0)))
    assert too_near([SHAPE | {"what": "wall"}], seen, scenario) == {}
