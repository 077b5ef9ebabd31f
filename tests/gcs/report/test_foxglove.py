"""Attitudes for Foxglove: NED to ENU, held against scipy's rotations."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from gcs.report.foxglove import _attitude

ENU_OF_NED = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
FLU_OF_FRD = np.diag([1.0, -1.0, -1.0])


@pytest.mark.parametrize("seed", range(3))
def test_an_attitude_turns_a_body_in_enu_as_it_turned_it_in_ned(seed: int) -> None:
    roll, pitch, yaw = np.random.default_rng(seed).uniform((-3.0, -1.5, -6.0), (3.0, 1.5, 6.0))
    ned_of_frd = Rotation.from_euler("ZYX", [yaw, pitch, roll]).as_matrix()
    expected = ENU_OF_NED @ ned_of_frd @ FLU_OF_FRD.T
    told = _attitude(roll, pitch, yaw)
    found = Rotation.from_quat([told["x"], told["y"], told["z"], told["w"]]).as_matrix()
    assert found == pytest.approx(expected, abs=1e-12)


def test_a_level_body_that_looks_north_looks_along_y() -> None:
    told = _attitude(0.0, 0.0, 0.0)
    forward = Rotation.from_quat([told["x"], told["y"], told["z"], told["w"]]).apply([1.0, 0.0, 0.0])
    assert forward == pytest.approx([0.0, 1.0, 0.0])
