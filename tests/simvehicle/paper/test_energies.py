"""Energies of given plans: a hover by hand, the core's own effort, and files that hold no plans."""

import json

import numpy as np
import pytest

from simvehicle.cli import run_argv
from simvehicle.paper import energies

REST = {"start_velocity_nwu": [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]}


def test_energies_of_a_plan_at_rest_end_on_the_hovers(tmp_path):
    plan = {"name": "rest", "velocity_nwu": [[[0.0, 0.0, 0.0]] * 160] * 2}
    (tmp_path / "plans.json").write_text(json.dumps(REST | {"plans": [plan]}), encoding="utf-8")
    plans = energies.read(tmp_path / "plans.json")
    found = energies.fly(plans, 0.1, [(0, "paper", 1.0), (0, "paper_literal", 0.0)])
    assert found.shape == (2, 2, len(energies.MEASURES), 200)
    last_s = found[..., -1] - found[..., -11]
    hover = [9.8, 9.8, 0.0, 9.8**2, 0.0, 9.8**1.5, 2.0 * 9.8]
    for each in last_s.reshape(-1, len(hover)):
        assert each == pytest.approx(hover, abs=2e-3)
    named = dict(zip(energies.MEASURES, np.moveaxis(found, 2, 0), strict=True))
    assert named["thrust and torques"] == pytest.approx(named["thrust"] + named["torques"])
    assert (named["torques"][..., 20] > 1.0).all()  # from 1 rad of each angle
    assert (np.diff(found, axis=3) >= -1e-9).all()


def test_the_program_writes_them_and_refuses_what_is_no_plan(tmp_path, capsys):
    plan = {"name": "rest", "velocity_nwu": [[[0.0, 0.0, 0.0]]] * 2}
    path = tmp_path / "plans.json"
    path.write_text(json.dumps(REST | {"plans": [plan]}), encoding="utf-8")
    assert run_argv(["paper", "--out", str(tmp_path / "out"), "--plans", str(path)]) == 0
    with np.load(tmp_path / "out" / energies.FILE) as file:
        assert file["energy"].shape == (16, 2, len(energies.MEASURES), 41)
        assert set(file["gain_set"]) == set(energies.GAIN_SETS)
    for content in ("{}", "[", json.dumps(REST | {"plans": [{"name": "a", "velocity_nwu": [[0.0]]}]})):
        path.write_text(content, encoding="utf-8")
        assert run_argv(["paper", "--out", str(tmp_path / "out"), "--plans", str(path)]) == 2
        assert "holds no plans" in capsys.readouterr().err
