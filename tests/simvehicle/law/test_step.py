import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simvehicle.law import rows, step
from simvehicle.law.params import NAMED, BatteryParams, Gains, pack

H = 0.004
DEFAULT, PAPER = NAMED["default"], NAMED["paper"]
GAIN_SETS = [DEFAULT, replace(DEFAULT, gains=PAPER.gains), replace(DEFAULT, gains=Gains(speed=1.5))]
REST = (0.0, 0.0, 0.0)


def start(params, position=REST, velocity=REST, attitude=REST, *, airborne=True):
    where = {"position_nwu": position, "velocity_nwu": velocity, "attitude_rad": attitude}
    return step.initial_state(params, **where, airborne=airborne)[np.newaxis]


def order(position=REST, velocity=REST, *, time_s=0.0, ground=False, motors=True, yaw=0.0, use=1.0, speed=5.0):
    command = np.zeros((1, rows.COMMAND_SIZE))
    command[0, rows.CMD_POSITION], command[0, rows.CMD_VELOCITY] = position, velocity
    command[0, rows.CMD_TIME_S], command[0, rows.CMD_USE_POSITION] = time_s, use
    command[0, rows.CMD_YAW], command[0, rows.CMD_SPEED_MAX] = yaw, speed
    command[0, rows.CMD_MOTORS], command[0, rows.CMD_GROUND] = motors, ground
    command[0, rows.CMD_PERIOD_S] = 0.1
    return command


def fly(params, state, command, seconds, *, time_s=0.0, tolerance=None):
    """State after every step, the first included: (steps + 1, STATE_SIZE)."""
    packed = pack(params)[np.newaxis]
    if tolerance is not None:
        packed[0, rows.PARAMETERS["tolerance"]] = tolerance
    path = [state[0]]
    for k in range(round(seconds / H)):
        state, _ = step.advance(state, command, packed, time_s=time_s + k * H, steps=1)
        path.append(state[0])
    return np.array(path)


def fly_path(params, path, seconds, state, **options):
    """Fly set points given at 10 Hz by path(t) → position, velocity."""
    flown = [state]
    for k in range(round(seconds * 10)):
        time_s = k / 10
        position, velocity = path(time_s)
        command = order(position, velocity, time_s=time_s)
        flown.append(fly(params, flown[-1][-1:], command, 0.1, time_s=time_s, **options)[1:])
    return np.concatenate(flown)


def torque(path):
    """tau that explains the change of the rates from step to step, under the airframe's own damping."""
    k = 0.2 * 0.015 / 1.25
    rates = path[:, rows.RATES]
    return (rates[1:] - rates[:-1] * math.exp(-k * H)) * k / (1.0 - math.exp(-k * H))


def rounded_corner(speed, leg=10.0, radius=5.0):
    """North, a quarter circle to the west, west: path(t), and the distance of points to its line."""

    def path(t):
        s = speed * t
        if s < leg:
            return (s, 0.0, 5.0), (speed, 0.0, 0.0)
        turn = (s - leg) / radius
        if turn < math.pi / 2:
            position = (leg + radius * math.sin(turn), radius * (1.0 - math.cos(turn)), 5.0)
            return position, (speed * math.cos(turn), speed * math.sin(turn), 0.0)
        return (leg + radius, radius + s - leg - radius * math.pi / 2, 5.0), (0.0, speed, 0.0)

    def distance(points):
        x, y = points[:, 0], points[:, 1]
        on_arc = np.abs(np.hypot(x - leg, y - radius) - radius)
        return np.where(x < leg, np.abs(y), np.where(y > radius, np.abs(x - leg - radius), on_arc))

    return path, distance


# the law in flight


def test_the_paper_s_vehicle_from_one_radian_of_each_angle_reaches_its_speed():
    state = start(PAPER, (0.0, 0.0, 5.0), REST, (1.0, 1.0, 1.0))
    path = fly(PAPER, state, order(velocity=(1.0, 1.0, 0.2)), 40.0)
    error = np.abs(path[:, rows.VELOCITY] - (1.0, 1.0, 0.2)).max(axis=1)
    assert error[: round(2.0 / H)].max() > 2.0
    assert error[round(30.0 / H)] < 2e-5
    assert np.abs(path[-1, rows.ATTITUDE][2]) < 1e-6


@pytest.mark.parametrize("speed", [(0, 0, 0), (1, 3, 2), (2, 2, 2), (1, 3, 6), (1, 2, 4)])
def test_with_signed_thrust_and_no_floor_the_paper_s_five_starts_reach_their_speed_too(speed):
    literal = NAMED["paper_literal"]
    state = start(literal, (0.0, 0.0, 5.0), speed, (1.0, 1.0, 1.0))
    flown, thrust = step.advance(
        state, order(velocity=(1.0, 1.0, 0.2)), pack(literal)[np.newaxis], time_s=0.0, steps=10_000
    )
    assert np.abs(flown[0, rows.VELOCITY] - (1.0, 1.0, 0.2)).max() < 1e-7
    assert ((thrust < 0.0).any()) == (speed != (0, 0, 0))  # the others do pull downward
    drawn_w = 200.0 * np.abs(thrust / 9.8) ** 1.5 + 10.0
    assert flown[0, rows.DRAWN_J] == pytest.approx(drawn_w.sum() * H)


def test_torque_rests_in_steady_flight():
    for params in (PAPER, DEFAULT):
        path = fly(params, start(params, REST, (1.0, 1.0, 0.2)), order(velocity=(1.0, 1.0, 0.2)), 40.0)
        assert np.sqrt(np.mean(torque(path[-2500:]) ** 2)) < 4e-8


def test_tightening_the_solve_does_not_change_the_flight():
    path, _ = rounded_corner(3.0)
    for params in (DEFAULT, PAPER):
        state = start(params, (0.0, 0.0, 5.0), (3.0, 0.0, 0.0))
        usual, tight = (fly_path(params, path, 12.0, state, tolerance=t) for t in (None, 1e-14))
        assert np.abs(usual[:, :6] - tight[:, :6]).max() < 1e-9


@pytest.mark.parametrize("params", GAIN_SETS)
def test_a_ten_metre_step_takes_three_and_a_half_seconds_and_does_not_overshoot(params):
    path = fly(params, start(params), order((10.0, 0.0, 0.0)), 8.0)
    x = path[:, 0]
    assert x.max() < 10.003
    assert H * np.argmax(x > 9.85) == pytest.approx(3.6, abs=0.15)
    assert np.abs(torque(path)).max() < 15.0


@pytest.mark.parametrize("params", GAIN_SETS)
@pytest.mark.parametrize(("speed", "cross_track", "peak"), [(1.0, 0.03, 5.0), (3.0, 0.12, 11.0)])
def test_a_curved_path_is_held(params, speed, cross_track, peak):
    path, distance = rounded_corner(speed)
    flown = fly_path(params, path, 24.0 / speed, start(params, (0.0, 0.0, 5.0), (speed, 0.0, 0.0)))
    settled = flown[round(2.0 / H) :]
    assert distance(settled).max() < cross_track
    assert np.abs(torque(settled)).max() < peak
    assert np.abs(flown[:, 2] - 5.0).max() < 0.02


def test_limits_hold_in_flight():
    rng = np.random.default_rng(5)
    state = start(DEFAULT, (0.0, 0.0, 50.0), (3.0, 0.0, 0.0), (1.0, 1.0, 1.0))
    for k in range(40):
        command = order(rng.uniform(-50, 50, 3), rng.uniform(-5, 5, 3), time_s=0.5 * k, yaw=rng.uniform(-3, 3))
        path = fly(DEFAULT, state, command, 0.5, time_s=0.5 * k)
        state = path[-1:]
        assert np.abs(torque(path)).max() < 30.0 + 1e-6


def test_the_linear_reference_goes_from_set_point_to_set_point():
    first = fly(PAPER, start(PAPER), order(velocity=(1.0, 0.0, 0.0)), 0.2)
    v_d = first[:, rows.REFERENCE_VELOCITY][:, 0]
    assert v_d[1:26] == pytest.approx(np.linspace(0.04, 1.0, 25))
    assert v_d[26:] == pytest.approx(1.0)
    second = fly(PAPER, first[10:11], order(velocity=(-1.0, 0.0, 0.0), time_s=0.04), 0.1, time_s=0.04)
    assert second[1:, rows.REFERENCE_VELOCITY][:, 0] == pytest.approx(np.linspace(0.4, -1.0, 26)[1:])
    assert second[1, rows.REFERENCE_ACCELERATION][0] == pytest.approx(-14.0)


def test_a_set_point_is_extrapolated_with_its_velocity():
    stale = order((5.0, 0.0, 0.0), (1.0, 0.0, 0.0), time_s=2.0)
    path = fly(DEFAULT, start(DEFAULT, (5.0, 0.0, 0.0), (1.0, 0.0, 0.0)), stale, 20.0, time_s=2.0)
    assert path[-1, 0] == pytest.approx(25.0 - 0.3, abs=0.01)
    assert path[-1, rows.VELOCITY] == pytest.approx([1.0, 0.0, 0.0], abs=1e-4)


def test_a_start_in_motion_is_flown_on_without_a_jolt():
    velocity = (2.0, -1.0, 0.5)
    path = fly(DEFAULT, start(DEFAULT, REST, velocity), order(velocity=velocity, use=0.0), 3.0)
    assert np.abs(path[:, rows.VELOCITY] - velocity).max() < 0.02
    assert np.abs(torque(path)).max() < 5.0


def test_yaw_turns_the_shorter_way_and_stays_wrapped():
    path = fly(DEFAULT, start(DEFAULT, attitude=(0.0, 0.0, 3.0)), order(yaw=-3.0), 6.0)
    yaw = path[:, rows.ATTITUDE][:, 2]
    assert np.abs(yaw).min() > 2.99
    assert np.abs(yaw).max() <= math.pi
    assert yaw[-1] == pytest.approx(-3.0, abs=1e-4)


# the ground


def test_on_the_ground_nothing_moves():
    state = start(DEFAULT, (3.0, 4.0, 0.0), (1.0, 1.0, 1.0), (0.2, 0.1, 0.7), airborne=False)
    off = fly(DEFAULT, state, order((9.0, 9.0, 9.0), ground=True, motors=False), 5.0)
    pressed = fly(DEFAULT, off[-1:], order((9.0, 9.0, 0.0), (0.0, 0.0, -0.5), ground=True, use=(1, 1, 0)), 5.0)
    for path in (off, pressed):
        assert (path[:, :12] == (3.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0)).all()
        assert (path[:, rows.CONTACT] == 1.0).all()


def test_take_off_is_smooth_and_sideways_motion_waits_for_it():
    state = fly(DEFAULT, start(DEFAULT, airborne=False), order(ground=True, motors=False), 1.0)[-1:]
    path = fly(DEFAULT, state, order((5.0, 0.0, 3.0), ground=True), 10.0)
    assert path[:, 2].min() == 0.0
    assert path[:, 2].max() < 3.01
    assert path[-1, rows.POSITION] == pytest.approx([5.0, 0.0, 3.0], abs=1e-3)
    assert not path[path[:, 2] == 0.0, 0].any()
    assert np.abs(torque(path)).max() < 15.0


def test_a_landing_ends_at_rest_on_the_ground_and_can_take_off_again():
    down = order((0.0, 0.0, 0.0), (0.0, 0.0, -0.7), ground=True, use=(1, 1, 0))
    path = fly(DEFAULT, start(DEFAULT, (0.0, 0.0, 3.0)), down, 10.0)
    touched = np.argmax(path[:, rows.CONTACT])
    assert path[touched - 1, rows.VELOCITY][2] == pytest.approx(-0.7, abs=0.01)
    assert not path[touched:, 2:6].any()
    again = fly(DEFAULT, path[-1:], order((0.0, 0.0, 2.0), ground=True, time_s=10.0), 6.0, time_s=10.0)
    assert again[-1, 2] == pytest.approx(2.0, abs=1e-3)


def test_motors_off_in_the_air_is_a_fall_and_motors_on_catch_it_smoothly():
    fall = fly(DEFAULT, start(DEFAULT, (0.0, 0.0, 50.0)), order(motors=False), 1.0)
    assert fall[-1, rows.VELOCITY][2] == pytest.approx(-9.8 / 0.05 * (1.0 - math.exp(-0.05)), rel=1e-10)
    caught = fly(DEFAULT, fall[-1:], order(velocity=REST, use=0.0), 10.0)
    assert caught[-1, rows.VELOCITY] == pytest.approx(REST, abs=1e-4)
    assert np.abs(torque(caught)).max() < 1.0


# the battery


def test_the_account_closes_and_power_is_that_of_the_thrust():
    rng = np.random.default_rng(2)
    state, packed = start(DEFAULT, airborne=False), pack(DEFAULT)[np.newaxis]
    thrust = []
    for k in range(100):
        command = order(rng.uniform(0, 10, 3), rng.uniform(-2, 2, 3), time_s=k / 10, ground=True, motors=k % 50 > 5)
        state, u1 = step.advance(state, command, packed, time_s=k / 10, steps=25)
        thrust.append(u1[0])
    drawn = np.sum(200.0 * (np.concatenate(thrust) / 9.8) ** 1.5 + 10.0) * H
    assert state[0, rows.DRAWN_J] == pytest.approx(drawn, rel=1e-12)
    assert state[0, rows.DRAWN_J] + state[0, rows.REMAINING_J] == pytest.approx(24_000.0, abs=1e-9)


# the arrays


def fleet(n=6):
    rng = np.random.default_rng(4)
    params = [
        replace((DEFAULT, PAPER)[i % 2], battery=BatteryParams(initial_j=(200.0, 24_000.0)[i % 3 > 0]))
        for i in range(n)
    ]
    starts = [start(p, rng.uniform(0, 5, 3), rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3)) for p in params]
    orders = [
        order(rng.uniform(0, 5, 3), rng.uniform(-1, 1, 3), yaw=i, ground=i % 2 == 0, motors=i != 3) for i in range(n)
    ]
    return np.concatenate(starts), np.concatenate(orders), np.stack([pack(p) for p in params])


def test_vehicles_together_fly_as_each_alone_to_the_bit():
    state, command, packed = fleet()
    times = np.linspace(0.0, 1.0, len(state))
    together, thrust = step.advance(state, command, packed, time_s=times, steps=500)
    for i in range(len(state)):
        row = slice(i, i + 1)
        alone, u1 = step.advance(state[row], command[row], packed[row], time_s=float(times[i]), steps=500)
        assert np.array_equal(alone[0], together[i])
        assert np.array_equal(u1[0], thrust[i])


def test_many_steps_in_one_call_are_the_same_to_the_bit():
    state, command, packed = fleet()
    at_once, thrust = step.advance(state, command, packed, time_s=0.5, steps=500)
    for k in range(500):
        state, u1 = step.advance(state, command, packed, time_s=0.5 + k * H, steps=1)
        assert np.array_equal(u1[:, 0], thrust[:, k])
    assert np.array_equal(state, at_once)


def test_advance_leaves_its_arguments_alone_and_takes_read_only_ones():
    arrays = fleet()
    before = [array.copy() for array in arrays]
    for array in arrays:
        array.flags.writeable = False
    step.advance(*arrays, time_s=0.0, steps=25)
    for array, copy in zip(arrays, before, strict=True):
        assert np.array_equal(array, copy)


def test_no_steps_change_nothing_that_flies():
    state, command, packed = fleet()
    same, thrust = step.advance(state, command, packed, time_s=0.0, steps=0)
    assert thrust.shape == (6, 0)
    assert np.array_equal(same[:, : rows.LINEAR.start], state[:, : rows.LINEAR.start])


anything = st.floats(allow_nan=False, allow_infinity=False)


@settings(max_examples=200, deadline=None)
@given(st.lists(st.lists(anything, min_size=15, max_size=15), min_size=1, max_size=5), st.sampled_from(sorted(NAMED)))
def test_no_finite_command_makes_a_state_that_is_not_finite(commands, name):
    params = NAMED[name]
    state, packed = start(params, (1.0, 2.0, 0.5), REST, (0.1, 0.2, 0.3)), pack(params)[np.newaxis]
    for k, row in enumerate(commands):
        command = np.array([row])
        command[0, rows.CMD_MOTORS] = 1.0
        state, thrust = step.advance(state, command, packed, time_s=k / 2, steps=125)
        assert np.isfinite(state).all()
        assert np.isfinite(thrust).all()


def test_wrong_arguments_are_refused():
    state, command, packed = fleet()
    with pytest.raises(
        ValueError, match=rf"packed_params has shape \(5, {rows.PARAMS_SIZE}\), but needs \(6, {rows.PARAMS_SIZE}\)"
    ):
        step.advance(state, command, packed[1:], time_s=0.0, steps=1)
    with pytest.raises(ValueError, match="steps is -1"):
        step.advance(state, command, packed, time_s=0.0, steps=-1)
    with pytest.raises(ValueError, match=r"velocity_nwu is .* three finite numbers"):
        start(DEFAULT, velocity=(0.0, math.nan, 0.0))
