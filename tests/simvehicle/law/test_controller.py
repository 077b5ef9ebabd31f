import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simvehicle.law import controller, dynamics, rows, step
from simvehicle.law.params import NAMED, Airframe, Gains, Limits, VehicleParams, pack

AIRFRAME = Airframe()
PAPER = NAMED["paper"]
DEFAULT = NAMED["default"]
H = 0.004
ZERO = np.zeros((1, 3))


def control(
    *, velocity=ZERO, attitude=ZERO, rates=ZERO, v_d=ZERO, a_d=ZERO, yaw=0.0, memory=None, vehicle=PAPER, dt_s=H
):
    """The core's own control of one vehicle: u1 (1,), tau (1, 3) and the differentiators' memory (1, 6)."""
    state, command = np.zeros(rows.STATE_SIZE), np.zeros(rows.COMMAND_SIZE)
    state[rows.VELOCITY], state[rows.ATTITUDE], state[rows.RATES] = velocity[0], attitude[0], rates[0]
    state[rows.REFERENCE_VELOCITY], state[rows.REFERENCE_ACCELERATION] = v_d[0], a_d[0]
    if memory is not None:
        state[rows.DIFF_ROLL], state[rows.DIFF_PITCH] = memory[0, :3], memory[0, 3:]
    state[rows.STARTED], command[rows.CMD_YAW] = 1.0, yaw
    state[rows.GUIDE_YAW] = yaw
    u1, *tau = step.control_row(state, command, pack(vehicle), dt_s)
    return np.array([u1]), np.array([tau]), np.array([[*state[rows.DIFF_ROLL], *state[rows.DIFF_PITCH]]])


def test_speed_error_decays_at_lambda_where_the_attitude_is_as_asked():
    rng = np.random.default_rng(1)
    for _ in range(50):
        velocity, v_d, a_d = rng.uniform(-2.0, 2.0, (3, 1, 3))
        v_d[0, 2] = velocity[0, 2]
        yaw = rng.uniform(-3.0, 3.0)
        angles = controller.outer(*velocity[0], yaw, *v_d[0], *a_d[0], 3.0, 0.05, 9.8, math.inf, math.inf)
        state = np.concatenate([np.zeros(3), velocity[0], (angles[0], angles[1], yaw), np.zeros(3)])[np.newaxis]
        acceleration = dynamics.derivative(state, [[angles[2], 0.0, 0.0, 0.0]], airframe=AIRFRAME)[0, 3:6]
        assert acceleration - a_d[0] == pytest.approx(-3.0 * (velocity - v_d)[0], abs=1e-12)


@pytest.mark.parametrize(("rate", "angle"), [(1.5, 1.5), (12.0, 36.0), (3.0, 30.0)])
def test_attitude_errors_follow_the_closed_form(rate, angle):
    """γ_e'' + (Ap + LK/I) γ_e' + Aq γ_e = 0 from (γ_e, γ_e') = (0.5, -0.2), the vehicle held in place."""
    dt_s = 0.0005
    vehicle = replace(PAPER, gains=Gains(rate=rate, angle=angle))
    state = np.zeros((1, 12))
    state[0, 6:9], state[0, 9:12] = 0.5, -0.2
    memory = np.zeros((1, 6))
    times = dt_s * np.arange(1, 4001)
    flown = []
    for _ in times:
        u1, tau, memory = control(
            attitude=state[:, 6:9], rates=state[:, 9:12], memory=memory, vehicle=vehicle, dt_s=dt_s
        )
        dynamics.plant_step(state[0], u1[0], *tau[0], 9.8, AIRFRAME.drag_1_s, AIRFRAME.rotational_drag_1_s, dt_s)
        state[0, 0:6] = 0.0
        flown.append(state[0, 6:9].copy())
    damping = rate + 0.2 * 0.015 / 1.25
    roots = np.roots([1.0, damping, angle]).astype(complex)
    first = (-0.2 - roots[1] * 0.5) / (roots[0] - roots[1])
    truth = (first * np.exp(roots[0] * times) + (0.5 - first) * np.exp(roots[1] * times)).real
    assert np.abs(np.array(flown) - truth[:, np.newaxis]).max() < 2e-3


def test_yaw_turns_the_shorter_way():
    _, tau, _ = control(attitude=[[0.0, 0.0, 3.0]], yaw=-3.0)
    assert tau[0, 2] == pytest.approx(1.5 * (2.0 * math.pi - 6.0))


velocity = st.floats(-1e12, 1e12)


@settings(max_examples=300, deadline=None)
@given(st.tuples(velocity, velocity, velocity), st.tuples(velocity, velocity, velocity), st.floats(-4.0, 4.0))
def test_limits_hold_whatever_is_asked(v_d, a_d, yaw):
    u1, tau, memory = control(v_d=[v_d], a_d=[a_d], attitude=[[0.0, 0.0, yaw]], vehicle=DEFAULT)
    roll, pitch, _ = controller.outer(
        0.0, 0.0, 0.0, yaw, *v_d, *a_d, 3.0, 0.05, 9.8, DEFAULT.limits.tilt_slope, DEFAULT.limits.thrust_m_s2
    )
    assert math.acos(min(math.cos(roll) * math.cos(pitch), 1.0)) <= DEFAULT.limits.tilt_rad + 1e-9
    assert 0.3 * 9.8 <= u1[0] <= 19.6
    assert np.abs(tau).max() <= 30.0
    assert np.isfinite(memory).all()


def test_lift_is_kept_when_thrust_runs_out():
    u1, _, _ = control(v_d=[[50.0, 0.0, 1.0]], vehicle=DEFAULT)
    roll, pitch, _ = controller.outer(
        0.0, 0.0, 0.0, 0.0, 50.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0, 0.05, 9.8, DEFAULT.limits.tilt_slope, 19.6
    )
    assert u1[0] * math.cos(roll) * math.cos(pitch) == pytest.approx(9.8 + 3.0)


def test_a_wish_to_fall_keeps_three_tenths_of_the_weight():
    u1, _, _ = control(v_d=[[0.0, 0.0, -100.0]])
    assert u1[0] == pytest.approx(0.3 * 9.8)


def test_remark_1_of_the_paper_is_required():
    with pytest.raises(ValueError, match=r"gains\.angle is 0\.0, but it must be greater than 0"):
        Gains(angle=0.0)
    with pytest.raises(ValueError, match=r"gains\.rate is -0\.0025, but it must be greater than -L\*K/I = -0\.0024"):
        VehicleParams(gains=Gains(rate=-0.0025, angle=1.5))


def test_gains_too_fast_for_the_sampled_law_are_refused():
    with pytest.raises(ValueError, match=r"gains\.rate is 600\.0"):
        VehicleParams(gains=Gains(rate=600.0))
    with pytest.raises(ValueError, match=r"gains\.angle is 1000\.0"):
        VehicleParams(gains=Gains(rate=1.5, angle=1000.0))


@pytest.mark.parametrize(
    ("make", "name"),
    [
        (lambda: Airframe(mass_kg=0.0), "airframe.mass_kg"),
        (lambda: Airframe(inertia=math.nan), "airframe.inertia"),
        (lambda: Airframe(drag_kg_s=-0.1), "airframe.drag_kg_s"),
        (lambda: Gains(epsilon=0.0), "gains.epsilon"),
        (lambda: Gains(speed=math.inf), "gains.speed"),
        (lambda: Limits(tilt_rad=math.pi / 2), "limits.tilt_rad"),
        (lambda: Limits(speed_m_s=-1.0), "limits.speed_m_s"),
        (lambda: VehicleParams(limits=Limits(thrust_m_s2=9.0)), "limits.thrust_m_s2"),
    ],
)
def test_a_bad_parameter_is_named(make, name):
    with pytest.raises(ValueError, match=f"^{name} is .*, but it must be "):
        make()


@given(
    st.tuples(*(st.floats(-20.0, 20.0),) * 3), st.floats(-4.0, 4.0), st.sampled_from([-1.0, 1.0]), st.floats(0.01, 30.0)
)
def test_the_literal_form_gives_every_acceleration_that_is_asked_up_and_down(a_d, yaw, sign, lift):
    """Angles within 90°, signed thrust; what the plant then feels is W, whichever way it points."""
    asked = (a_d[0], a_d[1], sign * lift - 9.8)
    roll, pitch, u1 = controller.outer_literal(*(0.0,) * 3, yaw, *(0.0,) * 3, *asked, 3.0, 0.05, 9.8)
    assert max(abs(roll), abs(pitch)) < math.pi / 2
    assert u1 * lift * sign > 0.0
    state = np.array([[*(0.0,) * 6, roll, pitch, yaw, *(0.0,) * 3]])
    felt = dynamics.derivative(state, [[u1, 0.0, 0.0, 0.0]], airframe=AIRFRAME)[0, 3:6]
    assert felt == pytest.approx(asked, rel=1e-9, abs=1e-7)


def test_the_literal_form_is_the_floored_one_where_there_is_lift_to_spare():
    for v_d in ((1.0, -2.0, 0.5), (0.0, 0.0, 0.0), (-3.0, 1.0, -1.0)):
        arguments = (0.3, -0.2, 0.1, 0.7, *v_d, 0.1, 0.2, 0.3, 3.0, 0.05, 9.8)
        floored = controller.outer(*arguments, math.inf, math.inf)
        assert controller.outer_literal(*arguments) == pytest.approx(floored, rel=1e-12)


@pytest.mark.parametrize("limits", [Limits(tilt_rad=0.6), Limits(thrust_m_s2=20.0)])
def test_the_literal_form_has_no_limits_of_tilt_and_thrust(limits):
    with pytest.raises(ValueError, match="infinite"):
        replace(PAPER, literal=True, limits=limits)
