"""Parameters of vehicles of ours in a scenario: what a vehicle would refuse at its start, the file's reader refuses."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scenarios import SMALL, changed, loaded, refusal

import gcs
from gcs.scenario.file import load
from gcs.scenario.model import Pursuer, ScenarioError
from gcs.scenario.parts.parameters import parameter_conflicts
from simvehicle.autopilot.parameters import ParameterError, Parameters
from skytender.vehicle.parameters import ROWS

FULL_J = 1000.0
NONE = "our own vehicles have no parameter"


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "s.yaml"


def with_params(params: str, more: str = "") -> str:
    """The small scenario, with parameters of its first vehicle."""
    return changed(SMALL, "{sysid: 1, ", f"{{sysid: 1, params: {{{params}}}, {more}")


@pytest.mark.parametrize(
    ("params", "column", "sentence"),
    [
        ("RTL_RETURN_ALTI: 6", 27, f"{NONE} 'RTL_RETURN_ALTI'; did you mean 'RTL_RETURN_ALT'?"),
        ("rtl_return_alt: 6", 27, f"{NONE} 'rtl_return_alt'; did you mean 'RTL_RETURN_ALT'?"),
        ("NAV_DLL_ACT: 0", 27, f"{NONE} 'NAV_DLL_ACT'"),
        ("RTL_RETURN_ALT: 600", 43, "RTL_RETURN_ALT must be from 1 to 150 m, not 600"),
        ("MPC_THR_MAX_G: 1", 42, "MPC_THR_MAX_G must be from 1.1 to 10, not 1"),
        ("GF_ACTION: 2, COM_DL_LOSS_T: 3600", 56, "COM_DL_LOSS_T must be from 1 to 300 s, not 3600"),
        ("CAL_MAG0_ID: 16777217", 40, "CAL_MAG0_ID must be from 0 to 16777216, not 16777217"),
        (
            "SIM_BAT_CAP_J: 100",
            42,
            "a battery that holds 100 J (SIM_BAT_CAP_J) cannot start with 1000 J (SIM_BAT_INIT_J)",
        ),
        (
            "SIM_BAT_CAP_J: 1200, SIM_BAT_INIT_J: 1300",
            64,
            "a battery that holds 1200 J (SIM_BAT_CAP_J) cannot start with 1300 J (SIM_BAT_INIT_J)",
        ),
    ],
)  # fmt: skip
def test_what_the_vehicle_would_refuse_is_named_with_its_place(
    path: Path, params: str, column: int, sentence: str
) -> None:
    assert refusal(path, with_params(params)) == f"s.yaml:8:{column}: {sentence}"


def test_all_of_them_are_named_beside_other_mistakes_and_once_each_where_they_are_inherited(path: Path) -> None:
    text = changed(SMALL, "vehicles:\n", "vehicles:\n  defaults:\n    params: {GF_ACTON: 2, MPC_LAND_SPEED: 9}\n")
    text = changed(text, "sysid: 2", "sysid: 1")
    assert refusal(path, changed(text, "speed_m_s: 1}", "speed_m_s: -1}")).splitlines() == [
        "s.yaml:8:14: our own vehicles have no parameter 'GF_ACTON'; did you mean 'GF_ACTION'?",
        "s.yaml:8:43: MPC_LAND_SPEED must be from 0.1 to 3 m/s, not 9",
        "s.yaml:11:15: the sysid 1 is given twice (see line 10)",
        "s.yaml:13:112: vehicles.targets[0].speed_m_s must be greater than 0, not -1",
    ]


@pytest.mark.parametrize("key", ["vehicles.defaults.params", "vehicles.defaults.params.RTL_RETURN_ALTI"])
def test_what_is_set_from_outside_is_refused_too(key: str) -> None:
    value: Any = 6 if key.endswith("ALTI") else {"RTL_RETURN_ALTI": 6}
    with pytest.raises(ScenarioError, match=rf"^set {key}=.*: our own .* did you mean 'RTL_RETURN_ALT'\?$"):
        load(gcs.scenario.file.find("demo"), set={key: value})


def test_a_program_is_refused_in_one_sentence() -> None:
    keys: dict[str, Any] = {"sysid": 1, "start_m": (0.0, 0.0, 0.0), "battery": {"capacity_j": FULL_J}}
    with pytest.raises(ValueError, match=r"^Pursuer: GF_ACTION must be from 0 to 3, not 7$"):
        Pursuer(**keys, params={"GF_ACTION": 7.0})


@pytest.mark.parametrize("kind", ["ardupilot", "px4"])
def test_another_autopilot_has_parameters_of_its_own(path: Path, kind: str) -> None:
    text = with_params("WPNAV_SPEED: 500, RTL_RETURN_ALT: 600", f"autopilot: {{{kind}: program}}, ")
    assert loaded(path, text).vehicles.pursuers[0].params == {"WPNAV_SPEED": 500.0, "RTL_RETURN_ALT": 600.0}


def test_an_external_vehicle_is_given_none(path: Path) -> None:
    text = with_params("WPNAV_SPEED: 500", 'external: {connect: "udpin:127.0.0.1:14550"}, ')
    assert refusal(path, text) == "s.yaml:8:26: pursuer 1 is external: params is for launched vehicles; leave it out"


NAMES = st.sampled_from([*ROWS, "NAV_DLL_ACT"])
VALUES = st.sampled_from([row.least for row in ROWS.values()] + [row.most for row in ROWS.values()])


def refuses(values: dict[str, float]) -> bool:
    """Whether the vehicle refuses these; its flight law, which it alone knows, left aside."""
    try:
        Parameters(values)
    except ParameterError as error:
        return "the flight law refuses" not in str(error)
    return False


@given(st.dictionaries(NAMES, VALUES | st.floats(-1e30, 1e30), max_size=3), st.floats(0.0, 1.0))
@example({"SIM_BAT_CAP_J": 1000.0}, 1.0)
@example({"SIM_BAT_INIT_J": 1000.0000001}, 1.0)
def test_the_reader_refuses_what_the_vehicle_refuses_and_nothing_else(params: dict[str, float], share: float) -> None:
    battery = {"SIM_BAT_CAP_J": FULL_J, "SIM_BAT_INIT_J": FULL_J * share}
    conflicts = list(parameter_conflicts(params, capacity_j=FULL_J, initial_j=FULL_J * share))
    assert bool(conflicts) == refuses(battery | params)
