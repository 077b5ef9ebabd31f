"""Least distances so far, of an interval between two ticks, against closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gcs.scenario.model import Scenario
from gcs.telemetry.proximity import Airspace, Places, Proximity
from skytender import geometry


def scenario() -> Scenario:
    return Scenario.model_validate({
        "schema": 1, "name": "m", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 0.0},
        "goal": {"duration_s": 60.0, "clearance_m": 0.18, "traffic_m": 0.18},
        "vehicles": {"pursuers": [{"sysid": 1, "start_m": (9.0, 0.0, 0.0), "battery": {"capacity_j": 1e4}}]},
        "obstacles": [{"name": "pole", "point_m": (0.0, 0.2, 0.0)}],
        "traffic": [{"callsign": "OTHER", "path_m": [(0.0, 0.2, 0.0)], "speed_m_s": 1.0}],
    })  # fmt: skip


@pytest.mark.parametrize(("curved", "nearest_m"), [(True, 0.175), (False, 0.2)])
def test_clearance_and_traffic_are_measured_on_the_curve_where_velocities_are_known(
    curved: bool, nearest_m: float
) -> None:
    """s = 1/2 a t (T - t) with 5 m/s², T = 0.2 s, towards a pole and an aircraft 0.2 m away: 25 mm nearer half way than
    at both ticks."""
    told = scenario()
    flag, none = np.ones(1, dtype=bool), np.zeros(1, dtype=bool)
    airspace = Airspace(flag, flag, none, np.empty((0, 2), dtype=np.int64), none)
    near = Proximity(told, geometry.of_scenario(told.obstacles))
    breaches = []
    for t_s, east_m_s in ((1.0, 0.5), (1.2, -0.5)):
        more: dict[str, Any] = {"v_ned": np.array([[0.0, east_m_s, 0.0]])} if curved else {}
        places = Places(np.zeros((1, 3)), np.zeros(1), {"OTHER": (0.0, 0.2, 0.0)}, **more)
        breaches += near.update(t_s, airspace, places)
    assert {breach.part for breach in breaches} == ({"clearance", "traffic"} if curved else set())
    for found, what in ((near.clearance, "pole"), (near.traffic, "OTHER")):
        assert (found.m, found.what) == (pytest.approx(nearest_m, abs=1e-4), what)
        assert not curved or found.t_s == pytest.approx(1.1, abs=0.01)
