"""The station's id in a scenario: its default, and ids that somebody else has."""

from __future__ import annotations

from typing import Any

import pytest

from gcs.scenario.model import Scenario, ScenarioError

MADE: dict[str, Any] = {
    "schema": 1,
    "name": "ids",
    "axes": "ned",
    "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
    "goal": {"duration_s": 10},
    "vehicles": {"pursuers": [{"sysid": 3, "start_m": [0, 0, 0], "battery": {"capacity_j": 9000}}]},
}


def test_it_is_qgroundcontrols_system_and_a_component_of_its_own_unless_said() -> None:
    assert Scenario.model_validate(MADE).station.ids == (255, 190)
    said = Scenario.model_validate(MADE | {"station": {"sysid": 245, "compid": 25}})
    assert said.station.ids == (245, 25)


@pytest.mark.parametrize(
    ("station", "words"),
    [
        ({"sysid": 3}, "3 is the sysid of a vehicle"),
        ({"compid": 156}, "255/156 is the traffic's"),
        ({"compid": 1}, "greater than or equal to 2"),
        ({"sysid": 0}, "greater than or equal to 1"),
        ({"sysid": 256}, "less than or equal to 255"),
    ],
)
def test_an_id_that_somebody_else_has_is_refused(station: dict[str, int], words: str) -> None:
    with pytest.raises((ScenarioError, ValueError), match=words):
        Scenario.model_validate(MADE | {"station": station})
