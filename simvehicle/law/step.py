"""The flight core: n vehicles, k steps of guidance → outer loop → differentiators → inner loop → plant → energy.

A vehicle is one row: a state, a command and packed parameters (`params.pack`), laid out by the constants below; a
slice for vectors, an integer for scalars. Axes are nwu, units SI. Rows never touch each other.

Everything but the control effort and the two battery accounts starts afresh at every step without running motors, so
that a take-off, or motors started in the air, begins on the present state.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import cython
import cython.cimports.simvehicle.law.controller as controller
import cython.cimports.simvehicle.law.differentiator as differentiator
import cython.cimports.simvehicle.law.dynamics as dynamics
import cython.cimports.simvehicle.law.guidance as guidance
import cython.cimports.simvehicle.law.power as power
import cython.cimports.simvehicle.law.rows as rows
import numpy as np
from cython.cimports.simvehicle.law.arithmetic import bounded
from numpy.typing import NDArray

from simvehicle.law.guidance import start
from simvehicle.law.params import STEP_S, VehicleParams
from simvehicle.law.rows import (
    ATTITUDE,
    COMMAND_SIZE,
    CONTACT,
    GUIDE,
    GUIDE_YAW,
    LINEAR_STAMP,
    PARAMS_SIZE,
    POSITION,
    REFERENCE_POSITION,
    REFERENCE_VELOCITY,
    REMAINING_J,
    STATE_SIZE,
    VELOCITY,
)

# Commands are brought within these: far outside what flies, and every square of them is finite.
_FARTHEST_M = 1e9
_FASTEST_M_S = 1e4
_LONGEST_S = 1e5
_LEAST_PERIOD_S = 1e-3


def set_reference(s: Any, c: Any, p: Any, t: float) -> None:
    """Write r, v_d and v_d' of the state's time t (docs/model/control.md#guidance)."""
    for i in range(3):
        if p.shaped != 0.0:
            r1, r2, r3 = s.guide.r1[i], s.guide.r2[i], s.guide.r3[i]
            r, rate, acceleration = guidance.reference_axis(r1, r2, r3, p.omega)
            s.reference_position[i] = r
            s.reference_velocity[i] = rate + p.reference_gain * (r - s.position[i])
            s.reference_acceleration[i] = acceleration + p.reference_gain * (rate - s.velocity[i])
        else:
            begin, end = s.linear.start[i], bounded(c.velocity[i], _FASTEST_M_S)
            elapsed, period = t - s.linear.since_s, max(c.period_s, _LEAST_PERIOD_S)
            s.reference_position[i] = s.position[i]
            s.reference_velocity[i], s.reference_acceleration[i] = guidance.linear_axis(begin, end, elapsed, period)


def guide_on(s: Any, c: Any, p: Any, t: float, dt: float) -> None:
    """Carry the shaped reference from t to t + dt; on the ground it waits for lift-off."""
    age = bounded(t - c.time_s, _LONGEST_S)
    vx = bounded(c.velocity[0], _FASTEST_M_S)
    vy = bounded(c.velocity[1], _FASTEST_M_S)
    vz = bounded(c.velocity[2], _FASTEST_M_S)
    ex = ey = ez = 0.0
    if c.use_position[0] != 0.0:
        ex = bounded(c.position[0], _FARTHEST_M) + vx * age - s.guide.q[0]
    if c.use_position[1] != 0.0:
        ey = bounded(c.position[1], _FARTHEST_M) + vy * age - s.guide.q[1]
    if c.use_position[2] != 0.0:
        ez = bounded(c.position[2], _FARTHEST_M) + vz * age - s.guide.q[2]
    fastest = min(max(c.speed_max, 0.0), p.speed_max, _FASTEST_M_S)
    gain, decel, velocity_gain, omega = p.guide_gain, p.guide_decel, p.velocity_gain, p.omega
    guide, guide_yaw = cython.address(s.guide), cython.address(s.guide_yaw)
    most = p.acceleration_max
    guidance.shape(guide, ex, ey, ez, vx, vy, vz, fastest, most, gain, decel, velocity_gain, omega, dt)
    guidance.shape_yaw(guide_yaw, c.yaw, p.yaw_rate, omega, dt)
    if s.contact != 0.0:
        guidance.start_axis(guide, 0, s.position[0], 0.0, omega)
        guidance.start_axis(guide, 1, s.position[1], 0.0, omega)
        if s.guide.q_rate[2] <= 0.0:
            guidance.start_axis(guide, 2, s.position[2], s.guide.q_rate[2], omega)
        guidance.start_yaw(guide_yaw, s.attitude[2], 0.0, omega)


def start_afresh(s: Any, p: Any) -> None:
    """Bring guidance and differentiators to the present state, as before a first step."""
    for i in range(3):
        guidance.start_axis(cython.address(s.guide), i, s.position[i], s.velocity[i], p.omega)
        s.diff_roll[i] = s.diff_pitch[i] = 0.0
        s.reference_position[i], s.reference_velocity[i] = s.position[i], s.velocity[i]
        s.reference_acceleration[i] = 0.0
        s.linear.start[i] = 0.0
    guidance.start_yaw(cython.address(s.guide_yaw), s.attitude[2], s.rates[2], p.omega)
    s.linear.since_s, s.linear.stamp_s = 0.0, guidance.NO_STAMP
    s.started = 0.0


def control(s: Any, c: Any, p: Any, dt: float) -> tuple[float, float, float, float]:
    """Outer loop → differentiators of the new angles → inner loop: (u1, tau2, tau3, tau4)
    (docs/model/control.md#control-law)."""
    v, v_d, a_d = s.velocity, s.reference_velocity, s.reference_acceleration
    if p.literal != 0.0:
        roll_d, pitch_d, u1 = controller.outer_literal(
            v[0], v[1], v[2], s.attitude[2], v_d[0], v_d[1], v_d[2], a_d[0], a_d[1], a_d[2],
            p.speed_gain, p.drag, p.gravity,
        )  # fmt: skip
    else:
        roll_d, pitch_d, u1 = controller.outer(
            v[0], v[1], v[2], s.attitude[2], v_d[0], v_d[1], v_d[2], a_d[0], a_d[1], a_d[2],
            p.speed_gain, p.drag, p.gravity, p.tilt_slope, p.thrust_max,
        )  # fmt: skip
    if s.started == 0.0:
        s.started = 1.0
        if p.bumpless != 0.0:
            s.diff_roll[0], s.diff_pitch[0] = roll_d, pitch_d
    roll, pitch = s.diff_roll, s.diff_pitch
    roll[2], pitch[2], _ = differentiator.solve_two(
        roll[0], roll[1], roll[2], roll_d, pitch[0], pitch[1], pitch[2], pitch_d, dt, p.epsilon, p.tolerance
    )
    roll[1] += dt * roll[2]
    roll[0] += dt * roll[1]
    pitch[1] += dt * pitch[2]
    pitch[0] += dt * pitch[1]
    yaw_d, yaw_rate, yaw_acceleration = c.yaw, 0.0, 0.0
    if p.shaped != 0.0:
        y1, y2, y3 = s.guide_yaw.r1, s.guide_yaw.r2, s.guide_yaw.r3
        yaw_d, yaw_rate, yaw_acceleration = guidance.reference_axis(y1, y2, y3, p.omega)
    rate_gain, angle_gain, drag, limit = p.rate_gain, p.angle_gain, p.rotational_drag, p.angular_max
    roll_error, pitch_error = s.attitude[0] - roll_d, s.attitude[1] - pitch_d
    yaw_error = dynamics.wrap_angle(s.attitude[2] - yaw_d)
    return (
        u1,
        controller.inner(roll_error, s.rates[0], roll[1], roll[2], rate_gain, angle_gain, drag, limit),
        controller.inner(pitch_error, s.rates[1], pitch[1], pitch[2], rate_gain, angle_gain, drag, limit),
        controller.inner(yaw_error, s.rates[2], yaw_rate, yaw_acceleration, rate_gain, angle_gain, drag, limit),
    )


def control_row(state: Any, command: Any, parameters: Any, dt: float) -> tuple[float, float, float, float]:
    """`control` of rows: state (STATE_SIZE,) in place, command (COMMAND_SIZE,), packed params."""
    s, c = cython.cast("State *", cython.address(state[0])), cython.cast("const Command *", cython.address(command[0]))
    return control(s, c, cython.cast("const Parameters *", cython.address(parameters[0])), dt)


def _meet_ground(s: Any, c: Any, x: float, y: float) -> None:
    """Stand where there is ground and no lift; x and y are where the step began. Yaw is kept, and wrapped anyway."""
    s.attitude[2] = dynamics.wrap_angle(s.attitude[2])
    if c.ground == 0.0 or s.position[2] > 0.0 or s.velocity[2] > 0.0:
        s.contact = 0.0
        return
    if s.contact != 0.0:
        s.position[0], s.position[1] = x, y
    s.position[2] = s.attitude[0] = s.attitude[1] = 0.0
    for i in range(3):
        s.velocity[i] = s.rates[i] = 0.0
    s.contact = 1.0


def draw(s: Any, p: Any, u1: float, dt: float) -> None:
    """Take a step's energy from the battery, at most what is left (docs/model/vehicle.md#battery)."""
    drawn = min(power.power(u1, p.gravity, p.hover_w, p.avionics_w) * dt, max(s.remaining_j, 0.0))
    s.drawn_j += drawn
    s.remaining_j -= drawn


def _step(s: Any, c: Any, p: Any, t: float, dt: float) -> float:
    """One step from t to t + dt; returns u1."""
    u1 = tau2 = tau3 = tau4 = 0.0
    x, y = s.position[0], s.position[1]
    running = c.motors != 0.0 and s.remaining_j > 0.0
    if running:
        set_reference(s, c, p, t)
        u1, tau2, tau3, tau4 = control(s, c, p, dt)
        guide_on(s, c, p, t, dt)
    dynamics.fly_plant(s.position, u1, tau2, tau3, tau4, p.gravity, p.drag, p.rotational_drag, dt)
    _meet_ground(s, c, x, y)
    draw(s, p, u1, dt)
    s.effort += power.effort_rate(u1, tau2, tau3, tau4) * dt
    if not running:
        start_afresh(s, p)
    return u1


def take_command(s: Any, c: Any, t: float) -> None:
    """Begin a new linear reference at t where the command is a new set point."""
    if s.linear.stamp_s != c.time_s:
        s.linear.stamp_s = c.time_s
        s.linear.since_s = t
        for i in range(3):
            s.linear.start[i] = s.reference_velocity[i]


def fly_rows(
    states: NDArray[np.float64],
    commands: NDArray[np.float64],
    parameters: NDArray[np.float64],
    times: NDArray[np.float64],
    dt: float,
    thrust: NDArray[np.float64],
) -> None:
    """As `advance`, but in place and unchecked: states, commands, parameters, times (n,), thrust (n, k)."""
    steps = thrust.shape[1]
    for vehicle in range(states.shape[0]):
        s, c, p = (
            rows.state_of(states, vehicle),
            rows.command_of(commands, vehicle),
            rows.parameters_of(parameters, vehicle),
        )
        fly_row(s, c, p, times[vehicle], dt, steps, cython.address(thrust[vehicle, 0]))


def fly_row(s: Any, c: Any, p: Any, t: float, dt: float, steps: int, thrust: Any) -> None:
    """Fly a vehicle some steps on from t; the thrust of each is written."""
    take_command(s, c, t)
    for k in range(steps):
        thrust[k] = _step(s, c, p, t + k * dt, dt)
    if s.started != 0.0:
        set_reference(s, c, p, t + steps * dt)


def initial_state(
    params: VehicleParams,
    *,
    position_nwu: Sequence[float],
    velocity_nwu: Sequence[float],
    attitude_rad: Sequence[float],
    airborne: bool,
) -> NDArray[np.float64]:
    """State of a vehicle before its first step, (STATE_SIZE,), guidance matched to a start in motion
    (docs/model/control.md#guidance).

    Args:
        params: the vehicle.
        position_nwu, velocity_nwu: (3,), m, m/s.
        attitude_rad: (3,), roll, pitch, yaw, nwu.
        airborne: False stands on the ground where z <= 0, level and at rest at z = 0, whatever else is asked.

    Raises:
        ValueError: a vector that is not three finite numbers.
    """
    state = np.zeros(STATE_SIZE)
    given = {"position_nwu": position_nwu, "velocity_nwu": velocity_nwu, "attitude_rad": attitude_rad}
    for part, (name, value) in zip((POSITION, VELOCITY, ATTITUDE), given.items(), strict=True):
        vector = np.asarray(value, dtype=np.float64)
        if vector.shape != (3,) or not np.isfinite(vector).all():
            raise ValueError(f"{name} is {value!r}, but it must be three finite numbers")
        state[part] = vector
    if not airborne and state[POSITION][2] <= 0.0:
        state[POSITION][2] = 0.0
        state[VELOCITY] = 0.0
        state[ATTITUDE][:2] = 0.0
        state[CONTACT] = 1.0
    state[GUIDE] = start(state[POSITION], state[VELOCITY], guidance=params.guidance)[0]
    state[GUIDE_YAW] = state[ATTITUDE][2] = dynamics.wrap_angle(state[ATTITUDE][2])
    state[LINEAR_STAMP] = guidance.NO_STAMP
    state[REFERENCE_POSITION] = state[POSITION]
    state[REFERENCE_VELOCITY] = state[VELOCITY]
    state[REMAINING_J] = params.battery.initial_j
    return state


def advance(
    state: NDArray[np.float64],
    command: NDArray[np.float64],
    packed_params: NDArray[np.float64],
    *,
    time_s: float | NDArray[np.float64],
    steps: int,
    dt_s: float = STEP_S,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Fly n vehicles k steps on (docs/model/vehicle.md#vehicle). Pure: the arguments stay as they are.

    Args:
        state: (n, STATE_SIZE).
        command: (n, COMMAND_SIZE), finite; values far outside what flies are brought within it.
        packed_params: (n, PARAMS_SIZE), from `params.pack`.
        time_s: time of the state, s, one for all or (n,).
        steps: k.
        dt_s: a step, s.

    Returns:
        state (n, STATE_SIZE) at time_s + k dt_s, and u1 (n, k) in m/s² of every step.

    Raises:
        ValueError: an array of another shape, or a negative number of steps.
    """
    n = state.shape[0]
    given = (state.shape, command.shape, packed_params.shape)
    if given != (needed := ((n, STATE_SIZE), (n, COMMAND_SIZE), (n, PARAMS_SIZE))):
        for name, shape, wanted in zip(("state", "command", "packed_params"), given, needed, strict=True):
            if shape != wanted:
                raise ValueError(f"{name} has shape {shape}, but needs {wanted}")
    if steps < 0:
        raise ValueError(f"steps is {steps}, but it must be 0 or greater")
    flown = np.array(state, dtype=np.float64, order="C")
    thrust = np.empty((n, steps))
    times = np.empty(n)
    times[:] = time_s
    fly_rows(flown, _plain(command), _plain(packed_params), times, float(dt_s), thrust)
    return flown, thrust


def _plain(array: NDArray[np.float64]) -> NDArray[np.float64]:
    """The array as the one kind that the core is compiled for: float64, C order, writeable."""
    if array.flags.c_contiguous and array.flags.writeable and array.dtype == np.float64:
        return array
    return np.array(array, dtype=np.float64, order="C")
