"""Mistakes of a program: each is one sentence that says what, where and what to do, as one in a file is."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import gcs
from gcs.scenario.file import find


@pytest.mark.parametrize(
    ("part", "keys", "sentence"),
    [
        (gcs.Fault, {"fault": "moter"}, "Fault: fault must be 'kill'.*not the text 'moter'; did you mean 'motor'\\?$"),
        (gcs.Fault, {"sysid": 3}, "Fault: the fault lacks the key 'fault' \\(kill or .*\\)$"),
        (gcs.Fault, {"fault": "motor", "sysd": 3}, "Fault: unknown key 'sysd' .*; did you mean 'sysid'\\?$"),
        (gcs.Fault, {"fault": "loss", "share": 1.5}, "Fault: share must be less than or equal to 1, not 1.5$"),
        (gcs.Obstacle, {"point_m": (1.0, 2.0)}, "Obstacle: point_m needs more numbers: it has 2$"),
        (gcs.Obstacle, {"radius_m": (1.0,)}, "Obstacle: radius_m must be a number, not a list$"),
        (gcs.Attractor, {}, "Attractor: the attractor lacks the key 'point_m'$"),
        (
            gcs.Scenario,
            {"schema": 1, "name": "x"},
            "Scenario: the scenario lacks the key 'axes' \\(paper or ned\\); the",
        ),
    ],
)
def test_a_part_that_is_made_of_wrong_keys(part: Any, keys: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=f"^{sentence}") as caught:
        part(**keys)
    assert "pydantic" not in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_block_of_keys_in_one_piece() -> None:
    with pytest.raises(TypeError, match=r"^Fault takes its keys by name: Fault\(\*\*keys\) for a block of them$"):
        gcs.Fault({"fault": "motor"})


@pytest.mark.parametrize(
    ("make", "given", "sentence"),
    [
        (
            gcs.Session,
            {"schema": 1},
            "scenario is a block of keys: give a file, the name of a shipped one, or a gcs.Sc",
        ),
        (gcs.Session, None, "scenario is nothing: give a file, the name of a shipped one, or a gcs.Scenario"),
        (gcs.Campaign, 3, "campaign is 3: give a file, the name of a shipped one, or its content as plain data"),
        (gcs.load, 3, "the file is 3: give a path"),
        (gcs.open, b"flown", "the source is a Python bytes: give a session's folder or a recording"),
    ],
)
def test_something_else_than_a_path(make: Any, given: Any, sentence: str) -> None:
    with pytest.raises(TypeError, match=f"^{sentence}"):
        make(given)


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        ({"every_s": "x"}, "every_s is 'x'; it must be a multiple of the scenario's period, 0.1 s"),
        ({"every_s": float("nan")}, "every_s is nan; it must be a multiple of the scenario's period, 0.1 s"),
        ({"out": 3}, "out is 3: give a path"),
    ],
)
def test_options_of_a_session(keys: dict[str, Any], sentence: str) -> None:
    with pytest.raises((TypeError, ValueError), match=f"^{sentence}$"):
        gcs.Session("demo", **keys)


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        ({"sessions": "many"}, "loss: sessions must be a whole number, not the text 'many'"),
        ({"sessions": -3}, "loss: sessions must be greater than or equal to 1, not -3"),
        ({"seed": 0.5}, "loss: seed must be a whole number, not 0.5"),
    ],
)
def test_options_of_a_campaign(keys: dict[str, Any], sentence: str) -> None:
    with pytest.raises(gcs.ScenarioError, match=f"^{sentence}$"):
        gcs.Campaign("loss", **keys)


def test_a_campaign_of_plain_data_is_named_as_what_it_is() -> None:
    with pytest.raises(gcs.ScenarioError, match=r"^campaign: the campaign lacks the key 'name'"):
        gcs.Campaign({"schema": 1})


def test_numpys_numbers_and_arrays_are_taken_as_pythons() -> None:
    one, jump = np.int64(1), np.array([1, 2])
    assert gcs.Fault(fault="gps_jump", sysid=one, jump_m=jump) == gcs.Fault(fault="gps_jump", sysid=1, jump_m=(1, 2))
    assert gcs.Attractor(point_m=[np.float32(0.5), one, 2]) == gcs.Attractor(point_m=(0.5, 1, 2))
    changes = {"vehicles.pursuers.0.start_m": np.array([9, 0, 0]), "planner.cruise_m_s": np.float32(1.5)}
    scenario = gcs.load(find("demo"), set={"seed": np.int64(4), **changes})
    assert (scenario.seed, scenario.planner.cruise_m_s) == (4, 1.5)
    assert scenario.vehicles.pursuers[0].start_m[0] == 9.0
    flown = gcs.Session(scenario, seed=np.int64(3), speed=np.float32(2.0)).scenario  # type: ignore[arg-type]
    assert (flown.seed, flown.clock.speed) == (3, 2.0)
    assert type(flown.seed) is int
    for wrong, shown in ((np.complex128(1), "a Python complex"), (jump, "a list"), (np.float64(1.5), "1.5")):
        with pytest.raises(ValueError, match=f"sysid must be a whole number, not {shown}$"):
            gcs.Fault(fault="motor", sysid=wrong)
    inside: list[Any] = [one]
    inside.append(inside)
    with pytest.raises(ValueError, match=r"^a list or a block of keys holds itself$"):
        gcs.Fault(fault="gps_jump", jump_m=inside)
