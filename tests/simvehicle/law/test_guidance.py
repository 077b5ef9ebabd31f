import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simvehicle.law import guidance, rows
from simvehicle.law.params import Guidance, Limits

LAW = Guidance()
LIMITS = Limits()
H = 0.004
ZERO = np.zeros((1, 3))
Q, Q_RATE = (rows.GUIDE_FIELDS[name].start - rows.GUIDE.start for name in ("q", "q_rate"))


def follow(memory, set_points, *, speed_max_m_s=LIMITS.speed_m_s):
    """The memory after every step."""
    row, memory_after = memory[0].copy(), []
    for position, velocity in set_points:
        error = np.array(position) - row[Q : Q + 3]
        guidance.follow(row, error, np.array(velocity), speed_max_m_s, LIMITS.acceleration_m_s2, LAW, H)
        memory_after.append(row.copy())
    return np.array(memory_after)


number = st.floats(-1e6, 1e6)


@settings(max_examples=50, deadline=None)
@given(st.lists(st.tuples(st.tuples(number, number, number), st.tuples(number, number, number)), max_size=40))
def test_speed_and_acceleration_of_q_stay_within_the_limits(set_points):
    memory = guidance.start(ZERO, ZERO, guidance=LAW)
    memory_after = follow(memory, [point for point in set_points for _ in range(10)], speed_max_m_s=3.0)
    if len(memory_after):
        rate = np.vstack([np.zeros(3), memory_after[:, Q_RATE : Q_RATE + 3]])
        assert np.linalg.norm(rate, axis=1).max() <= 3.0 + 1e-9
        assert np.linalg.norm(np.diff(rate, axis=0), axis=1).max() <= 5.0 * H + 1e-9


def test_yaw_turns_the_shorter_way_within_its_rate():
    memory = np.full(4, 3.0)
    yaws = []
    for _ in range(1500):
        guidance.follow_yaw(memory, -3.0, 1.0, 10.0, H)
        yaws.append(memory[3])
    assert min(abs(yaw) for yaw in yaws) > 2.99
    assert yaws[-1] == pytest.approx(-3.0, abs=1e-6)
    assert np.abs(np.diff(np.unwrap(yaws))).max() <= 1.0 * H + 1e-12


def test_a_gain_of_zero_is_refused():
    with pytest.raises(ValueError, match=r"guidance\.omega is 0\.0"):
        Guidance(omega=0.0)
