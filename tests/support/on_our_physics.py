"""A fleet of which another autopilot flies one on our physics, and what is asked of any such autopilot's flight."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from sessions import Outcome, small

GUEST, TANKER = 2, 201
START_M = (2.0, 3.0, 0.0)


def mixed(autopilot: dict[str, str], *, duration_s: float = 25.0, **keys: Any) -> dict[str, Any]:
    """One of ours, one that another autopilot flies and that needs energy, their target and a tanker, in wind."""
    goal = {"duration_s": duration_s, "refuelled_at_least": 1, "pursue": {"within_m": 3.5, "for_s": 5.0}}
    content = small(goal=goal, wind={"speed_m_s": 4.0, "from_deg": 200.0, "turbulence_m_s": 5.0})
    content["vehicles"]["pursuers"][0]["battery"]["initial_percent"] = 100
    battery = {"capacity_j": 60000, "initial_percent": 50}
    guest = {"sysid": GUEST, "start_m": list(START_M), "battery": battery, "autopilot": autopilot}
    content["vehicles"]["pursuers"].append({**guest, **keys})
    content["refuelling"] = {"limit_j": 10000}
    return content


def several(content: dict[str, Any], *places: tuple[float, float]) -> dict[str, Any]:
    """That fleet with a guest at each of these places."""
    (first, guest), battery = content["vehicles"]["pursuers"], {"capacity_j": 60000, "initial_percent": 45}
    content["vehicles"]["pursuers"] = [first] + [
        {**guest, "sysid": GUEST + i, "start_m": [*place, 0.0], "battery": battery} for i, place in enumerate(places)
    ]
    content["formation"] = {"ring_m": 4.0}
    content["goal"]["pursue"]["within_m"] = 6.0
    return content


def assert_refuelled(flown: Outcome) -> None:
    """It has taken ten kilojoules in the air, every joule is accounted for, and it flies on."""
    (service, *_) = flown.summary["refuelling"]
    assert (service["receiver"], service["tanker"]) == (GUEST, TANKER)
    assert service["energy_j"] >= 10_000
    guest, tanker = flown.vehicle(GUEST)["energy"], flown.vehicle(TANKER)["energy"]
    assert guest["received_j"] == service["energy_j"]
    assert tanker["given_j"] - tanker["received_j"] == guest["received_j"]  # what did not arrive came back
    assert tanker["lost_j"] == 0.0
    truth = flown.truth(GUEST)
    drawn, received, given, remaining = truth.energy.T
    assert np.abs(truth.head["initial_j"] + received - drawn - given - remaining).max() < 1e-6
    assert received[-1] == guest["received_j"]
    assert guest["drawn_j"] == pytest.approx(drawn[-1], abs=200.0)
    assert truth.p_ned[-1, 2] < -1.0


def assert_reported_where_it_is(flown: Outcome, within_m: float) -> None:
    """Within so much of where our physics has it: a real one estimates it."""
    truth = flown.truth(GUEST)
    reported = [(t, m) for t, m in flown.messages("LOCAL_POSITION_NED") if m.get_srcSystem() == GUEST]
    assert len(reported) > 100
    by_time = {round(t, 1): row for t, row in zip(truth.time_s, truth.p_ned, strict=True)}
    for t, m in reported[20:]:
        north, east, down = by_time[round(t, 1)] - START_M
        assert (m.x, m.y, m.z) == pytest.approx((north, east, down), abs=within_m)
