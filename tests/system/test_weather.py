"""Sessions on rotors in wind with gusts and with sensors: their goal is met, and the seed decides what is random."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sessions import Outcome, fly, merged, small


def windy(**changes: Any) -> dict[str, Any]:
    """A refuelling in 8 m/s with light turbulence, in 35 s."""
    wind = {"speed_m_s": 8.0, "from_deg": 250.0, "turbulence_m_s": 7.7}
    content = small(goal={"duration_s": 35.0}, formation={"ring_m": 3.0}, wind=wind, **changes)
    content["vehicles"]["defaults"] = {"plant": "rotors", "sensors": {}}
    return content


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(windy(), tmp_path_factory.mktemp("windy"), "--plain")


def test_a_fleet_is_refuelled_in_wind_with_gusts(flown: Outcome) -> None:
    assert flown.status == 0, flown.stdout
    energy = flown.vehicle(1)["energy"]
    assert energy["received_j"] > 1000
    ledger = energy["initial_j"] + energy["received_j"] - energy["drawn_j"] - energy["given_j"] - energy["lost_j"]
    assert energy["remaining_j"] == pytest.approx(ledger, abs=1.0)


def test_the_wind_tilts_vehicles_into_it_and_drains_their_voltage(flown: Outcome) -> None:
    """Thrust leans to where the wind comes from, as the drag of 0.37 1/s at 8 m/s over gravity asks."""
    tilts = [
        (-m.pitch * np.cos(m.yaw) - m.roll * np.sin(m.yaw), m.roll * np.cos(m.yaw) - m.pitch * np.sin(m.yaw))
        for t, m in flown.messages("ATTITUDE")
        if m.get_srcSystem() == 101 and t > 20.0
    ]
    north, east = np.mean(tilts, axis=0)
    airspeed_share = 0.3706 * 8.0 / 9.80665
    toward = np.radians(250.0)
    assert (north, east) == pytest.approx((airspeed_share * np.cos(toward), airspeed_share * np.sin(toward)), abs=0.04)
    volts = [m.voltage_battery / 1e3 for _, m in flown.messages("SYS_STATUS") if m.get_srcSystem() == 101]
    assert volts[0] > 16.0
    assert min(volts) < volts[0] - 0.5


@pytest.mark.slow
def test_the_same_seed_is_the_same_session_and_another_seed_another(tmp_path: Path) -> None:
    brief = merged(windy(), {"goal": {"duration_s": 8.0}})
    outcomes = [fly(brief, tmp_path / str(k), "--plain", "--seed", seed) for k, seed in enumerate("112")]
    one, again, other = (outcome.summary["digest"] for outcome in outcomes)
    assert one == again != other
