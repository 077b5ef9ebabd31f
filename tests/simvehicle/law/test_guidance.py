import math

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
Q, Q_RATE, R1, R2, R3 = (rows.GUIDE_FIELDS[name].start - rows.GUIDE.start for name in ("q", "q_rate", "r1", "r2", "r3"))


def follow(memory, set_points, *, speed_max_m_s=LIMITS.speed_m_s, use_position=(1.0, 1.0, 1.0)):
    """The memory after every step."""
    row, memory_after = memory[0].copy(), []
    for position, velocity in set_points:
        error = np.array(use_position) * (np.array(position) - row[Q : Q + 3])
        guidance.follow(row, error, np.array(velocity), speed_max_m_s, LIMITS.acceleration_m_s2, LAW, H)
        memory_after.append(row.copy())
    return np.array(memory_after)


def test_a_ten_metre_step_takes_three_and_a_half_seconds_and_does_not_overshoot():
    memory = guidance.start(ZERO, ZERO, guidance=LAW)
    memory_after = follow(memory, [((10.0, 0.0, 0.0), (0.0, 0.0, 0.0))] * 2000)
    r = memory_after[:, R3]
    assert r.max() < 10.001
    assert H * np.argmax(r > 9.85) == pytest.approx(3.6, abs=0.15)
    assert r[-1] == pytest.approx(10.0, abs=1e-4)


def test_a_start_in_motion_is_matched():
    position, velocity = np.array([[1.0, -2.0, 3.0]]), np.array([[0.5, 1.5, -0.25]])
    memory = guidance.start(position, velocity, guidance=LAW)
    for axis in range(3):
        lags = (memory[0, part + axis] for part in (R1, R2, R3))
        r, rate, acceleration = guidance.reference_axis(*lags, LAW.omega)
        assert (r, rate) == pytest.approx((position[0, axis], velocity[0, axis]))
        assert acceleration == pytest.approx(0.0, abs=1e-12)


def test_a_straight_path_is_followed_with_the_delay_of_the_lags():
    memory = guidance.start(ZERO, [[2.0, 0.0, 0.0]], guidance=LAW)
    times = H * np.arange(5000)
    memory_after = follow(memory, [((2.0 * t, 0.0, 0.0), (2.0, 0.0, 0.0)) for t in times])
    behind = 2.0 * (times[-1] + H) - memory_after[-1, R3]
    assert behind / 2.0 == pytest.approx(3.0 / LAW.omega, abs=0.002)


@pytest.mark.parametrize("turn", [0.2, 0.6, 1.0])
def test_a_circle_is_flown_at_the_radius_of_the_linear_transfer_function(turn):
    """q'' = 10 (v + K (p - q) - q') and three lags, all linear within the limits: the gain is known exactly."""
    s = 1j * turn
    k, b, omega = LAW.gain, LAW.velocity_gain, LAW.omega
    gain = abs(b * (s + k) / (s * s + b * s + b * k) * (omega / (s + omega)) ** 3)
    times = H * np.arange(7000)
    points = [
        ((math.cos(turn * t), math.sin(turn * t), 0.0), (-turn * math.sin(turn * t), turn * math.cos(turn * t), 0.0))
        for t in times
    ]
    memory = guidance.start([points[0][0]], [points[0][1]], guidance=LAW)
    memory_after = follow(memory, points)[5000:]
    radius = np.hypot(memory_after[:, R3], memory_after[:, R3 + 1])
    assert radius == pytest.approx(gain, abs=2e-3)


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


def test_the_reference_is_smooth_through_a_jump_of_the_set_point():
    memory = guidance.start(ZERO, ZERO, guidance=LAW)
    memory_after = follow(memory, [((10.0, 0.0, 0.0), (0.0, 0.0, 0.0))] * 1000)
    r1, r2, r3 = (memory_after[:, part] for part in (R1, R2, R3))
    acceleration = LAW.omega**2 * (r1 - 2.0 * r2 + r3)
    jerk = np.diff(acceleration) / H
    assert np.abs(acceleration).max() < 5.0
    assert np.abs(np.diff(jerk)).max() / H < 5.0 * LAW.omega**2


def test_an_axis_without_position_follows_its_velocity_alone():
    """From rest, q lags the velocity by 1/10 s and r lags q by 3/ω; the other axes hold their positions."""
    memory = guidance.start(ZERO, ZERO, guidance=LAW)
    memory_after = follow(memory, [((0.0, 50.0, 0.0), (0.0, 0.5, 0.0))] * 2500, use_position=(1.0, 0.0, 1.0))
    assert memory_after[-1, R3 + 1] == pytest.approx(0.5 * (10.0 - 0.1 - 0.3), abs=0.002)
    assert memory_after[-1, [R3, R3 + 2]].tolist() == [0.0, 0.0]


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
