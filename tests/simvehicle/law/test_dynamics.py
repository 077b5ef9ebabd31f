import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from simvehicle.law import dynamics
from simvehicle.law.params import Airframe

AIRFRAME = Airframe()
HOVER = np.array([[9.8, 0.0, 0.0, 0.0]])
TURNING = np.array([[0.0, 0.0, 0.0, 1.0, -2.0, 0.5, 0.3, -0.4, 0.9, 1.1, -0.7, 0.5]])
TURNING_INPUTS = np.array([[12.0, 3.0, -4.0, 2.0]])


def fly(state, inputs, dt_s, seconds, airframe=AIRFRAME):
    state = state.copy()
    for _ in range(round(seconds / dt_s)):
        dynamics.plant_step(
            state[0], *inputs[0], airframe.gravity_m_s2, airframe.drag_1_s, airframe.rotational_drag_1_s, dt_s
        )
    return state


def exact(state, inputs, seconds, airframe=AIRFRAME):
    """The same flight by scipy's eighth-order adaptive method."""

    def rate(_, y):
        return dynamics.derivative(y[np.newaxis], inputs, airframe=airframe)[0]

    return solve_ivp(rate, (0.0, seconds), state[0], method="DOP853", rtol=1e-13, atol=1e-13).y[:, -1]


def test_free_fall_with_drag_follows_the_closed_form():
    state = fly(np.zeros((1, 12)), np.zeros((1, 4)), 0.004, 10.0)
    k, g = 0.1 / 2.0, 9.8
    decay = math.exp(-k * 10.0)
    assert state[0, 5] == pytest.approx(-g / k * (1.0 - decay), rel=1e-11)
    assert state[0, 2] == pytest.approx(-g / k * (10.0 - (1.0 - decay) / k), rel=1e-11)


def test_a_rotor_disc_that_carries_the_weight_level_hovers():
    assert not dynamics.derivative(np.zeros((1, 12)), HOVER, airframe=AIRFRAME).any()
    assert not fly(np.zeros((1, 12)), HOVER, 0.004, 1.0).any()


def test_rotation_decays_by_its_own_drag():
    spin = np.zeros((1, 12))
    spin[0, 9:12] = (1.0, -2.0, 3.0)
    airframe = Airframe(rotational_drag=2.0)
    decay = math.exp(-0.2 * 2.0 / 1.25 * 3.0)
    assert fly(spin, HOVER, 0.004, 3.0, airframe)[0, 9:12] == pytest.approx(decay * spin[0, 9:12], rel=1e-11)


def test_halving_the_step_divides_the_error_by_sixteen():
    truth = exact(TURNING, TURNING_INPUTS, 1.6)
    errors = [np.abs(fly(TURNING, TURNING_INPUTS, h, 1.6)[0] - truth).max() for h in (0.08, 0.04, 0.02)]
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert orders == pytest.approx([4.0, 4.0], abs=0.3)


def test_a_turning_flight_at_four_milliseconds_is_exact_to_ten_nanometres():
    truth = exact(TURNING, TURNING_INPUTS, 2.0)
    assert np.abs(fly(TURNING, TURNING_INPUTS, 0.004, 2.0)[0] - truth).max() < 1e-8


def test_thrust_points_the_same_way_in_nwu_and_in_ned():
    rng = np.random.default_rng(7)
    for attitude in rng.uniform(-math.pi, math.pi, (200, 3)):
        state = np.zeros((1, 12))
        state[0, 6:9] = attitude
        thrust_nwu = dynamics.derivative(state, HOVER / 9.8, airframe=AIRFRAME)[0, 3:6] + (0.0, 0.0, 9.8)
        roll, pitch, yaw = dynamics.ned_from_nwu(attitude)
        thrust_ned = Rotation.from_euler("ZYX", [yaw, pitch, roll]).apply([0.0, 0.0, -1.0])
        assert dynamics.ned_from_nwu(thrust_nwu) == pytest.approx(thrust_ned, abs=1e-12)


def test_body_rates_turn_the_body_as_its_euler_angles_do():
    rng = np.random.default_rng(8)
    h = 1e-6

    def body_to_ned(attitude):
        roll, pitch, yaw = dynamics.ned_from_nwu(attitude)
        return Rotation.from_euler("ZYX", [yaw, pitch, roll])

    for attitude, rates in zip(rng.uniform(-1.4, 1.4, (50, 3)), rng.uniform(-3.0, 3.0, (50, 3)), strict=True):
        turn = body_to_ned(attitude - 0.5 * h * rates).inv() * body_to_ned(attitude + 0.5 * h * rates)
        body = dynamics.ned_from_nwu(dynamics.body_rates(*attitude[:2], *rates))
        assert body == pytest.approx(turn.as_rotvec() / h, abs=1e-7)


def test_ned_is_a_proper_rotation_of_nwu():
    matrix = [dynamics.ned_from_nwu(axis) for axis in np.eye(3)]
    assert np.linalg.det(matrix) == pytest.approx(1.0)
    assert dynamics.ned_from_nwu([1.0, 2.0, 3.0]) == (1.0, -2.0, -3.0)
    assert dynamics.nwu_from_ned([1.0, -2.0, -3.0]) == (1.0, 2.0, 3.0)


@given(st.floats(-1e6, 1e6))
def test_a_wrapped_angle_is_the_same_direction(angle):
    wrapped = dynamics.wrap_angle(angle)
    assert abs(wrapped) <= math.pi
    assert math.cos(wrapped - angle) == pytest.approx(1.0, abs=1e-9)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_any_finite_angle_wraps(angle):
    assert abs(dynamics.wrap_angle(angle)) <= math.pi


@pytest.mark.parametrize(("state", "inputs"), [((12,), (4,)), ((2, 12), (1, 4)), ((1, 11), (1, 4))])
def test_wrong_shapes_are_refused(state, inputs):
    with pytest.raises(ValueError, match=r"need \(n, 12\) and \(n, 4\)"):
        dynamics.derivative(np.zeros(state), np.zeros(inputs), airframe=AIRFRAME)
