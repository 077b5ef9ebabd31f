"""Failsafes in a whole session: the radio of one vehicle goes dark, and comes back or does not."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from sessions import Outcome, fly, merged, small

HOME = (6.0, 0.0, 0.0)


def dark(from_s: float, to_s: float) -> dict[str, Any]:
    content = small(
        goal={"duration_s": 60.0, "refuelled_at_least": 0},
        refuelling={"enabled": False},
        radio={"blackouts": [{"sysid": 1, "from_s": from_s, "to_s": to_s}]},
    )
    content["vehicles"]["pursuers"][0] |= {"start_m": list(HOME), "battery": {"capacity_j": 60000}}
    content["vehicles"]["tankers"] = []
    return content


def speed_between(outcome: Outcome, from_s: float, to_s: float) -> float:
    truth = outcome.truth(1)
    rows = (truth.time_s >= from_s) & (truth.time_s <= to_s)
    return float(np.linalg.norm(truth.state[rows, 3:6], axis=1).max())


def texts(outcome: Outcome) -> list[str]:
    return [m.text for _, m in outcome.messages("STATUSTEXT") if m.get_srcSystem() == 1]


def test_after_a_short_blackout_the_vehicle_holds_and_then_goes_on(tmp_path: Path) -> None:
    content = merged(dark(20.0, 23.0), {"goal": {"duration_s": 35.0}})
    outcome = fly(content, tmp_path, "--plain")
    assert speed_between(outcome, 21.6, 23.0) < 0.1
    assert outcome.vehicle(1)["final_mode"] == "offboard"
    truth = outcome.truth(1)
    assert abs(float(np.linalg.norm(truth.p_ned[-1] - outcome.truth(101).p_ned[-1])) - 2.0) < 0.2


def test_without_the_ground_station_it_returns_lands_disarms_and_rejoins_when_it_is_received_again(
    tmp_path: Path,
) -> None:
    outcome = fly(dark(20.0, 55.0), tmp_path, "--plain")
    truth = outcome.truth(1)
    landed = (truth.time_s > 45.0) & (truth.time_s <= 55.0)
    assert np.allclose(truth.p_ned[landed], HOME, atol=0.3)
    assert all(float(truth.thrust[k].max()) == 0.0 for k in np.flatnonzero(landed))
    assert float(truth.thrust[-1].max()) > 0.0
    assert truth.p_ned[-1, 2] < -1.0
    assert outcome.vehicle(1)["final_mode"] in ("takeoff", "hold", "offboard")


def test_an_empty_battery_lands_and_says_so_where_there_is_no_tanker(tmp_path: Path) -> None:
    content = dark(29.0, 29.9) | {"refuelling": {"enabled": True}, "goal": {"duration_s": 30.0}}
    content["vehicles"]["pursuers"][0]["battery"] = {"capacity_j": 24000, "initial_percent": 25}
    outcome = fly(content, tmp_path, "--plain")
    assert outcome.summary["refuelling"] == []
    assert outcome.vehicle(1)["final_mode"] == "land"
    assert any("battery empty" in text for text in texts(outcome))
    assert outcome.truth(1).p_ned[-1, 2] == 0.0
    assert outcome.truth(1).energy[:, 3].min() > 0.0
    assert "battery empty" in outcome.stdout
    assert "battery empty" in (outcome.folder / "vehicles" / "1.log").read_text(encoding="utf-8")
