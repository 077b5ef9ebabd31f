"""Truth: the numbers of docs/model/control.md#differentiator, the flight core itself, and hand-made signals."""

import json
import subprocess
import sys
import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest

from simvehicle.cli import run_argv
from simvehicle.law import rows, step
from simvehicle.law.params import NAMED, pack
from simvehicle.paper import studies


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    out = tmp_path_factory.mktemp("paper") / "new" / "folder"
    assert run_argv(["paper", "--out", str(out)]) == 0
    return out, json.loads((out / "vehicle.json").read_text(encoding="utf-8"))


def case(figures, method, step_s, noise):
    wanted = {"method": method, "step_s": step_s, "velocity_noise_m_s": noise}
    (found,) = [c for c in figures["implicit"]["cases"] if wanted.items() <= c.items()]
    return found


@pytest.mark.slow
def test_every_figure_is_there_twice_and_named(made):
    out, document = made
    assert document["schema"] == 1
    assert list(document["figures"]) == ["fig5", "fig12", "implicit", "noise"]
    for name, entry in document["figures"].items():
        assert entry["files"] == [f"{name}.svg", f"{name}.png"]
        assert ET.parse(out / f"{name}.svg").getroot().tag.endswith("svg")
        assert (out / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    assert len(list(out.iterdir())) == 9


def test_five_sin_t_has_the_published_errors(made):
    fig5 = made[1]["figures"]["fig5"]
    assert fig5["x1_error_max_rad"] == pytest.approx(0.126, abs=0.0005)
    assert fig5["x2_error_max_rad_s"] == pytest.approx(0.126, abs=0.0005)
    assert fig5["x3_error_rms_rad_s2"] == pytest.approx(0.19, abs=0.005)
    assert 0.0 < fig5["x2_convergence_time_s"] < fig5["x3_convergence_time_s"] < 1.0


def test_the_finite_time_differentiator_is_the_smooth_and_exact_one_on_a_clean_sine(made):
    clean = made[1]["figures"]["fig12"]["clean"]
    # The variation of cos t is 4 in each period of 2π; 20 s are 3 of them and 20 - 6π s, on which it falls.
    assert clean["truth"]["total_variation_rad_s"] == pytest.approx(12.0 + 1.0 - np.cos(20.0), abs=0.01)
    errors = {name: clean[name]["derivative_error_max_rad_s"] for name in ("finite_time", "sliding_mode", "high_gain")}
    assert min(errors, key=errors.__getitem__) == "finite_time"
    assert clean["finite_time"]["total_variation_rad_s"] == pytest.approx(12.6 + 1.0, abs=0.3)
    assert clean["sliding_mode"]["total_variation_rad_s"] > 100.0


def test_levant_s_chatter_does_not_go_away_with_the_step_but_shrinks(made):
    """It switches every few steps by α times the step: amplitude falls with the step, variation stays."""
    fig12 = made[1]["figures"]["fig12"]
    coarse, fine = fig12["clean"]["sliding_mode"], fig12["clean_fine_step"]["sliding_mode"]
    shrinks = coarse["derivative_error_max_rad_s"] / fine["derivative_error_max_rad_s"]
    assert shrinks == pytest.approx(40.0, rel=0.05)
    assert coarse["total_variation_rad_s"] == pytest.approx(fine["total_variation_rad_s"], rel=0.02)


def test_steady_torque_at_four_milliseconds_is_as_published(made):
    figures = made[1]["figures"]
    assert case(figures, "explicit", 0.004, 0.0)["torque_rms_rad_s2"] == pytest.approx(57.0, rel=0.05)
    assert case(figures, "explicit", 0.004, 0.02)["torque_rms_rad_s2"] == pytest.approx(87.0, rel=0.05)
    assert case(figures, "implicit", 0.004, 0.02)["torque_rms_rad_s2"] == pytest.approx(29.0, rel=0.05)
    quiet = case(figures, "implicit", 0.004, 0.0)
    assert quiet["torque_rms_rad_s2"] < 4e-8
    assert quiet["speed_error_max_m_s"] < 2e-5
    assert len(figures["implicit"]["cases"]) == 16


def test_the_study_flies_what_the_vehicle_flies():
    vehicle = NAMED["paper"]
    state = step.initial_state(
        vehicle,
        position_nwu=(0, 0, 0),
        velocity_nwu=studies.VELOCITY_NWU,
        attitude_rad=studies.ATTITUDE_RAD,
        airborne=True,
    )[np.newaxis]
    command = np.zeros((1, rows.COMMAND_SIZE))
    command[0, rows.CMD_VELOCITY] = studies.VELOCITY_NWU
    command[0, rows.CMD_MOTORS] = 1.0
    flown, _ = step.advance(state, command, pack(vehicle)[np.newaxis], time_s=0.0, steps=1000)
    _, velocity, _ = studies.closed_loop(vehicle, step_s=0.004, noise_m_s=0.0, explicit=False, duration_s=4.0)
    assert velocity[-1] == pytest.approx(flown[0, rows.VELOCITY], abs=1e-12)


def test_explicit_and_implicit_flights_meet_as_the_step_goes_to_zero():
    vehicle = replace(NAMED["default"], bumpless=False)
    ends = [
        studies.closed_loop(vehicle, step_s=5e-4, noise_m_s=0.0, explicit=explicit, duration_s=3.0)[1][-1]
        for explicit in (True, False)
    ]
    assert ends[0] == pytest.approx(ends[1], abs=5e-3)


def test_convergence_begins_the_first_second_within_the_bound():
    t = 0.01 * np.arange(1, 501)
    error = np.where(t < 1.005, 1.0, 0.01)
    assert studies.convergence_time(t, error, 0.1) == pytest.approx(1.01)
    error[300] = 1.0  # a later peak does not count, an earlier one restarts
    assert studies.convergence_time(t, error, 0.1) == pytest.approx(1.01)
    error[150] = 1.0
    assert studies.convergence_time(t, error, 0.1) == pytest.approx(1.52)
    assert studies.convergence_time(t, 0.0 * error, 0.1) == pytest.approx(0.01)
    assert studies.convergence_time(t, 0.0 * error + 1.0, 0.1) is None


@pytest.mark.slow
def test_only_what_is_asked_for_is_made_and_the_same_twice(made, tmp_path):
    assert run_argv(["paper", "--out", str(tmp_path / "a"), "--only", "fig5"]) == 0
    assert sorted(path.name for path in (tmp_path / "a").iterdir()) == ["fig5.png", "fig5.svg", "vehicle.json"]
    for name in ("fig5.png", "fig5.svg"):
        assert (tmp_path / "a" / name).read_bytes() == (made[0] / name).read_bytes()


def test_an_unknown_figure_is_refused_with_the_choices(tmp_path, capsys):
    assert run_argv(["paper", "--out", str(tmp_path), "--only", "fig5,fig6"]) == 2
    assert "there is no figure 'fig6'; choose from fig5, fig12, implicit" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_folder_that_cannot_be_written_is_one_sentence(tmp_path, capsys):
    (tmp_path / "file").write_text("", encoding="utf-8")
    assert run_argv(["paper", "--out", str(tmp_path / "file" / "x"), "--only", "fig5"]) == 74
    assert capsys.readouterr().err.startswith("simvehicle: cannot write ")


def test_what_flies_never_loads_the_drawing():
    code = (
        "import sys; from simvehicle.cli import run_argv; run_argv(['--help']); "
        "from simvehicle.law import step; from simvehicle.sitl import block; "
        "from simvehicle.mavlink import dispatcher; assert 'matplotlib' not in sys.modules"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=False, text=True)
    assert done.returncode == 0, done.stderr


def test_in_flight_both_fly_as_well_as_their_estimate_and_errors_become_torque(made):
    """An error of 0.05 m/s by axis is one of 0.05 √3 m/s in length, whoever differentiates."""
    cases = {(c["differentiator"], c["errors_over_sensors"]): c for c in made[1]["figures"]["noise"]["cases"]}
    for name in ("finite_time", "sliding_mode"):
        assert cases[name, 0.0]["speed_error_max_m_s"] < 1e-3
        for share in (0.5, 1.0, 2.0):
            assert cases[name, share]["speed_error_rms_m_s"] == pytest.approx(0.05 * 3**0.5 * share, rel=0.1)
    torque = {key: case["torque_rms_rad_s2"] for key, case in cases.items()}
    assert torque["finite_time", 0.0] < 0.02 * torque["sliding_mode", 0.0], "on an exact estimate it does not chatter"
    assert torque["finite_time", 1.0] > 2.0 * torque["sliding_mode", 1.0], (
        "on one that errs it does more than the other"
    )
    assert min(torque["high_gain", share] for share in (0.0, 1.0)) > 20.0
