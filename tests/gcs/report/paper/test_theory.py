"""The scenes of docs/model/planner.md#fuzzy-escape, and a closed form for the loops."""

import numpy as np
import pytest

from gcs.report.paper import theory


def test_the_plain_field_stops_where_the_forces_cancel_on_the_line() -> None:
    trail = theory.walk(theory.LAYOUTS["one obstacle on the line"], escape=False)
    assert len(trail) == theory.STEPS + 1
    assert 4.0 < trail[-1][0] < 5.0
    assert np.abs(trail[:, 1:]).max() == 0.0


def test_the_escape_reaches_the_target_in_about_the_steps_of_the_model() -> None:
    trail = theory.walk(theory.LAYOUTS["one obstacle on the line"], escape=True)
    assert np.linalg.norm(trail[-1] - theory.TARGET) <= theory.ARRIVED_M
    # docs/model/planner.md#fuzzy-escape walked with full steps to the end
    assert len(trail) - 1 == pytest.approx(111, abs=25)


def test_the_attitude_is_slower_than_the_speed_with_the_papers_gains() -> None:
    # s² + (Ap + L K/I) s + Aq is underdamped: its roots' real part is half the damping.
    study = theory.loops()
    assert study.measured["loops-order"].value == pytest.approx((1.5 + 0.0024) / 2 / 3)


def test_no_norm_grows_with_p() -> None:
    assert theory.fig6().measured["fig6-norms"].value == 0
