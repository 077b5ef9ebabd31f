"""How far vehicles flew, by the summary and by their own truth (a real session, in lockstep)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from sessions import fly, small


def test_a_way_is_as_long_as_the_vehicles_own_to_the_last_report(tmp_path: Path) -> None:
    content = small(
        goal={"duration_s": 6.0, "refuelled_at_least": 0, "waypoints": "none"}, refuelling={"enabled": False}
    )
    del content["formation"]
    content["vehicles"] = {
        "pursuers": [
            {
                "sysid": 1,
                "start_m": [0.0, 0.0, -30.0],
                "airborne": True,
                "waypoints_m": [[40.0, 0.0, -30.0]],
                "battery": {"capacity_j": 60_000},
            }
        ]
    }
    outcome = fly(content, tmp_path, "--plain")
    assert outcome.status == 0, outcome.stderr
    flown = outcome.truth(1)
    assert (flown.time_s[0], flown.time_s[-1]) == pytest.approx((0.0, 6.0))
    steps_m = np.linalg.norm(np.diff(flown.p_ned, axis=0), axis=1)
    assert steps_m[-1] > 0.1
    assert outcome.vehicle(1)["path_length_m"] == pytest.approx(steps_m.sum(), abs=0.01)
