"""What a competition on board needs of a scenario, each refused in one sentence at its place."""

from __future__ import annotations

from typing import Any

import pytest
from fleets import on_board
from sessions import merged

from gcs.processes.vehicles import fleet_rules
from gcs.scenario.model import Scenario

FLEET = on_board({1: ((0.0, 0.0, -3.0), 40.0), 2: ((4.0, 0.0, -3.0), 40.0)}, {201: (0.0, 6.0, -8.0)})
MANY = on_board({i: ((3.0 * i, 0.0, -3.0), 40.0) for i in range(1, 41)}, {201: (0.0, 6.0, -8.0)})
BASE = {"name": "A", "position_m": [9.0, 9.0, 0.0], "stock_j": 1e5}


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"vehicles": {"tankers": []}}, "it needs a pursuer, a tanker"),
        ({"refuelling": {"enabled": False}}, "it needs a pursuer, a tanker"),
        ({"bases": [BASE]}, "bases are the supervisor's"),
        ({"competition": {"policy": "optimal"}}, "the policy winner_take_all alone"),
        ({"competition": {"bids": "need"}}, "bids by losses and by time alone"),
        ({"radio": {"ground_blackouts": [{"from_s": 9.0, "to_s": 9.0}]}}, "to_s must be after from_s"),
        ({"radio": {"splits": [{"sysids": [1], "from_s": 9.0, "to_s": 8.0}]}}, "to_s must be after from_s"),
        ({"radio": {"splits": [{"sysids": [1, 7], "from_s": 0.0, "to_s": 8.0}]}}, "there is no vehicle 7"),
        (
            {
                "competition": {"where": "supervisor"},
                "planner": {"safety": False},
                "radio": {"splits": [{"sysids": [1], "from_s": 0.0, "to_s": 8.0}]},
            },
            "splits need launched vehicles that the safety filter keeps apart",
        ),
    ],
)
def test_what_does_not_go_with_it_is_refused(changes: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match="(?s)" + sentence.replace("(", r"\(").replace("{", r"\{")):
        Scenario.model_validate(merged(FLEET, changes))


def test_more_vehicles_than_the_radio_carries_are_refused() -> None:
    with pytest.raises(ValueError, match="at most 40 vehicles"):
        Scenario.model_validate(MANY)


@pytest.mark.parametrize(("pursuers", "every_s"), [(7, 0.2), (15, 0.2), (16, 0.3), (39, 0.5)])
def test_reports_come_as_often_as_eight_fit_a_tick(pursuers: int, every_s: float) -> None:
    content = on_board({i: ((3.0 * i, 0.0, -3.0), 40.0) for i in range(1, pursuers + 1)}, {201: (0.0, 6.0, -8.0)})
    assert fleet_rules(Scenario.model_validate(content))["report_every_s"] == every_s
