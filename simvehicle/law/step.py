"""The flight core: n vehicles, k steps of guidance → outer loop → differentiators → inner loop → plant → energy.

A vehicle is one row: a state, a command and packed parameters (`params.pack`), laid out by the constants below; a
slice for vectors, an integer for scalars. Axes are nwu, units SI. Rows never touch each other.

Everything but the control effort and the two battery accounts starts afresh at every step without running motors, so
that a take-off, or motors started in the air, begins on the present state.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from simvehicle.kernels import INLINED, UNCOUNTED, inner, kernel
from simvehicle.law import controller, differentiator, dynamics, guidance, params, power
from simvehicle.law.params import (
    P_ACCELERATION_MAX,
    P_ANGLE_GAIN,
    P_ANGULAR_MAX,
    P_AVIONICS_W,
    P_BUMPLESS,
    P_DRAG,
    P_EPSILON,
    P_GRAVITY,
    P_GUIDE_DECEL,
    P_GUIDE_GAIN,
    P_HOVER_W,
    P_LITERAL,
    P_OMEGA,
    P_RATE_GAIN,
    P_REFERENCE_GAIN,
    P_ROTATIONAL_DRAG,
    P_SHAPED,
    P_SPEED_GAIN,
    P_SPEED_MAX,
    P_THRUST_MAX,
    P_TILT_SLOPE,
    P_TOLERANCE,
    P_VELOCITY_GAIN,
    P_YAW_RATE,
    PARAMS_SIZE,
    STEP_S,
    VehicleParams,
)

Row = NDArray[np.float64]

# State of a vehicle. The plant comes first, as dynamics.py has it.
POSITION = slice(0, 3)  # m
VELOCITY = slice(3, 6)  # m/s
ATTITUDE = slice(6, 9)  # φ, θ, ψ in rad; ψ in [-π, π]
RATES = slice(9, 12)  # of the Euler angles, rad/s
DIFF_ROLL = slice(12, 15)  # X1, X2, X3
DIFF_PITCH = slice(15, 18)
GUIDE = slice(18, 33)  # guidance.py's memory, three axes each: q m, q' m/s, r1, r2, r3 m
GUIDE_YAW = slice(33, 37)  # rad
LINEAR = slice(37, 42)  # v_d at the set point's arrival, time of arrival, CMD_TIME_S of that set point
REFERENCE_POSITION = slice(42, 45)  # r of the state's time; the vehicle's own position where only v_d is flown
REFERENCE_VELOCITY = slice(45, 48)  # v_d
REFERENCE_ACCELERATION = slice(48, 51)  # v_d'
STARTED = 51  # 1 once X1 has been given its first angle
CONTACT = 52  # 1 while the vehicle stands on the ground
EFFORT = 53  # control effort
DRAWN_J = 54
REMAINING_J = 55
STATE_SIZE = 56

# Command to a vehicle: the last set point and what goes with it.
CMD_POSITION = slice(0, 3)  # m
CMD_VELOCITY = slice(3, 6)  # m/s
CMD_TIME_S = 6  # when the position held: p̂ = p + v (t - CMD_TIME_S). A change of it marks a new set point.
CMD_USE_POSITION = slice(7, 10)  # per axis: 1 position and velocity, 0 velocity alone
CMD_YAW = 10  # rad
CMD_MOTORS = 11  # 1 armed and turning, 0 off
CMD_GROUND = 12  # 1 there is ground at z = 0, 0 there is none
CMD_SPEED_MAX = 13  # m/s, cap of |v*|; the vehicle's own limit holds too
CMD_PERIOD_S = 14  # time that a linear reference takes from its value at arrival to CMD_VELOCITY
COMMAND_SIZE = 15

# Commands are brought within these: far outside what flies, and every square of them is finite.
_FARTHEST_M = 1e9
_FASTEST_M_S = 1e4
_LONGEST_S = 1e5

_X, _V, _ANGLE, _RATE = (part.start for part in (POSITION, VELOCITY, ATTITUDE, RATES))
_ROLL, _PITCH = DIFF_ROLL.start, DIFF_PITCH.start
_GUIDE, _YAW, _LINEAR = GUIDE.start, GUIDE_YAW.start, LINEAR.start
_GUIDE_END, _YAW_END, _LINEAR_END = GUIDE.stop, GUIDE_YAW.stop, LINEAR.stop
_REF_X, _REF_V, _REF_A = (part.start for part in (REFERENCE_POSITION, REFERENCE_VELOCITY, REFERENCE_ACCELERATION))
_CMD_X, _CMD_V, _CMD_USE = CMD_POSITION.start, CMD_VELOCITY.start, CMD_USE_POSITION.start
_LEAST_PERIOD_S = 1e-3


@inner(**INLINED)
def set_reference(s: Row, c: Row, p: Row, guide: Row, linear: Row, t: float) -> None:
    """Write r, v_d and v_d' of the state's time t (docs/model.md#guidance)."""
    for i in range(3):
        if p[P_SHAPED] != 0.0:
            r1, r2, r3 = guide[guidance.R1 + i], guide[guidance.R2 + i], guide[guidance.R3 + i]
            r, rate, acceleration = guidance.reference_axis(r1, r2, r3, p[P_OMEGA])
            s[_REF_X + i] = r
            s[_REF_V + i] = rate + p[P_REFERENCE_GAIN] * (r - s[_X + i])
            s[_REF_A + i] = acceleration + p[P_REFERENCE_GAIN] * (rate - s[_V + i])
        else:
            start, end = linear[guidance.LINEAR_START + i], controller.bounded(c[_CMD_V + i], _FASTEST_M_S)
            elapsed, period = t - linear[guidance.LINEAR_SINCE], max(c[CMD_PERIOD_S], _LEAST_PERIOD_S)
            s[_REF_X + i] = s[_X + i]
            s[_REF_V + i], s[_REF_A + i] = guidance.linear_axis(start, end, elapsed, period)


@inner(**INLINED)
def guide_on(s: Row, c: Row, p: Row, guide: Row, yaw: Row, t: float, dt: float) -> None:
    """Carry the shaped reference from t to t + dt; on the ground it waits for lift-off."""
    age = controller.bounded(t - c[CMD_TIME_S], _LONGEST_S)
    vx = controller.bounded(c[_CMD_V], _FASTEST_M_S)
    vy = controller.bounded(c[_CMD_V + 1], _FASTEST_M_S)
    vz = controller.bounded(c[_CMD_V + 2], _FASTEST_M_S)
    ex = ey = ez = 0.0
    if c[_CMD_USE] != 0.0:
        ex = controller.bounded(c[_CMD_X], _FARTHEST_M) + vx * age - guide[guidance.Q]
    if c[_CMD_USE + 1] != 0.0:
        ey = controller.bounded(c[_CMD_X + 1], _FARTHEST_M) + vy * age - guide[guidance.Q + 1]
    if c[_CMD_USE + 2] != 0.0:
        ez = controller.bounded(c[_CMD_X + 2], _FARTHEST_M) + vz * age - guide[guidance.Q + 2]
    fastest = min(max(c[CMD_SPEED_MAX], 0.0), p[P_SPEED_MAX], _FASTEST_M_S)
    gain, decel, velocity_gain, omega = p[P_GUIDE_GAIN], p[P_GUIDE_DECEL], p[P_VELOCITY_GAIN], p[P_OMEGA]
    guidance.shape(guide, ex, ey, ez, vx, vy, vz, fastest, p[P_ACCELERATION_MAX], gain, decel, velocity_gain, omega, dt)
    guidance.shape_yaw(yaw, c[CMD_YAW], p[P_YAW_RATE], omega, dt)
    if s[CONTACT] != 0.0:
        guidance.start_axis(guide, 0, s[_X], 0.0, omega)
        guidance.start_axis(guide, 1, s[_X + 1], 0.0, omega)
        if guide[guidance.Q_RATE + 2] <= 0.0:
            guidance.start_axis(guide, 2, s[_X + 2], guide[guidance.Q_RATE + 2], omega)
        guidance.start_yaw(yaw, s[_ANGLE + 2], 0.0, omega)


@inner(**UNCOUNTED)
def start_afresh(s: Row, p: Row, guide: Row, yaw: Row, linear: Row) -> None:
    """Bring guidance and differentiators to the present state, as before a first step."""
    for i in range(3):
        guidance.start_axis(guide, i, s[_X + i], s[_V + i], p[P_OMEGA])
        s[_ROLL + i] = s[_PITCH + i] = 0.0
        s[_REF_X + i], s[_REF_V + i], s[_REF_A + i] = s[_X + i], s[_V + i], 0.0
        linear[guidance.LINEAR_START + i] = 0.0
    guidance.start_yaw(yaw, s[_ANGLE + 2], s[_RATE + 2], p[P_OMEGA])
    linear[guidance.LINEAR_SINCE], linear[guidance.LINEAR_STAMP] = 0.0, guidance.NO_STAMP
    s[STARTED] = 0.0


@inner(**INLINED)
def control(s: Row, c: Row, p: Row, yaw: Row, dt: float) -> tuple[float, float, float, float]:
    """Outer loop → differentiators of the new angles → inner loop: (u1, tau2, tau3, tau4)
    (docs/model.md#control-law)."""
    if p[P_LITERAL] != 0.0:
        roll_d, pitch_d, u1 = controller.outer_literal(
            s[_V], s[_V + 1], s[_V + 2], s[_ANGLE + 2],
            s[_REF_V], s[_REF_V + 1], s[_REF_V + 2], s[_REF_A], s[_REF_A + 1], s[_REF_A + 2],
            p[P_SPEED_GAIN], p[P_DRAG], p[P_GRAVITY],
        )  # fmt: skip
    else:
        roll_d, pitch_d, u1 = controller.outer(
            s[_V], s[_V + 1], s[_V + 2], s[_ANGLE + 2],
            s[_REF_V], s[_REF_V + 1], s[_REF_V + 2], s[_REF_A], s[_REF_A + 1], s[_REF_A + 2],
            p[P_SPEED_GAIN], p[P_DRAG], p[P_GRAVITY], p[P_TILT_SLOPE], p[P_THRUST_MAX],
        )  # fmt: skip
    if s[STARTED] == 0.0:
        s[STARTED] = 1.0
        if p[P_BUMPLESS] != 0.0:
            s[_ROLL], s[_PITCH] = roll_d, pitch_d
    r, q = _ROLL, _PITCH
    s[r + 2], s[q + 2] = differentiator.solve_two(
        s[r], s[r + 1], s[r + 2], roll_d, s[q], s[q + 1], s[q + 2], pitch_d, dt, p[P_EPSILON], p[P_TOLERANCE]
    )
    for first in (r, q):
        s[first + 1] += dt * s[first + 2]
        s[first] += dt * s[first + 1]
    yaw_d, yaw_rate, yaw_acceleration = c[CMD_YAW], 0.0, 0.0
    if p[P_SHAPED] != 0.0:
        y1, y2, y3 = yaw[guidance.YAW_R1], yaw[guidance.YAW_R2], yaw[guidance.YAW_R3]
        yaw_d, yaw_rate, yaw_acceleration = guidance.reference_axis(y1, y2, y3, p[P_OMEGA])
    rate_gain, angle_gain, drag, limit = p[P_RATE_GAIN], p[P_ANGLE_GAIN], p[P_ROTATIONAL_DRAG], p[P_ANGULAR_MAX]
    roll_error, pitch_error = s[_ANGLE] - roll_d, s[_ANGLE + 1] - pitch_d
    yaw_error = dynamics.wrap_angle(s[_ANGLE + 2] - yaw_d)
    return (
        u1,
        controller.inner(roll_error, s[_RATE], s[r + 1], s[r + 2], rate_gain, angle_gain, drag, limit),
        controller.inner(pitch_error, s[_RATE + 1], s[q + 1], s[q + 2], rate_gain, angle_gain, drag, limit),
        controller.inner(yaw_error, s[_RATE + 2], yaw_rate, yaw_acceleration, rate_gain, angle_gain, drag, limit),
    )


@inner(**UNCOUNTED)
def _meet_ground(s: Row, c: Row, x: float, y: float) -> None:
    """Stand where there is ground and no lift; x and y are where the step began. Yaw is kept, and wrapped anyway."""
    s[_ANGLE + 2] = dynamics.wrap_angle(s[_ANGLE + 2])
    if c[CMD_GROUND] == 0.0 or s[_X + 2] > 0.0 or s[_V + 2] > 0.0:
        s[CONTACT] = 0.0
        return
    if s[CONTACT] != 0.0:
        s[_X], s[_X + 1] = x, y
    s[_X + 2] = s[_ANGLE] = s[_ANGLE + 1] = 0.0
    for i in range(3):
        s[_V + i] = s[_RATE + i] = 0.0
    s[CONTACT] = 1.0


@inner(**UNCOUNTED)
def draw(s: Row, p: Row, u1: float, dt: float) -> None:
    """Take a step's energy from the battery, at most what is left (docs/model.md#battery)."""
    drawn = min(power.power(u1, p[P_GRAVITY], p[P_HOVER_W], p[P_AVIONICS_W]) * dt, max(s[REMAINING_J], 0.0))
    s[DRAWN_J] += drawn
    s[REMAINING_J] -= drawn


@inner(**INLINED)
def _step(s: Row, c: Row, p: Row, guide: Row, yaw: Row, linear: Row, t: float, dt: float) -> float:
    """One step from t to t + dt; returns u1."""
    u1 = tau2 = tau3 = tau4 = 0.0
    x, y = s[_X], s[_X + 1]
    running = c[CMD_MOTORS] != 0.0 and s[REMAINING_J] > 0.0
    if running:
        set_reference(s, c, p, guide, linear, t)
        u1, tau2, tau3, tau4 = control(s, c, p, yaw, dt)
        guide_on(s, c, p, guide, yaw, t, dt)
    dynamics.plant_step(s, u1, tau2, tau3, tau4, p[P_GRAVITY], p[P_DRAG], p[P_ROTATIONAL_DRAG], dt)
    _meet_ground(s, c, x, y)
    draw(s, p, u1, dt)
    s[EFFORT] += power.effort_rate(u1, tau2, tau3, tau4) * dt
    if not running:
        start_afresh(s, p, guide, yaw, linear)
    return u1


def _compiled(build: int) -> Callable[..., Any]:
    """The core's entry, the only kernel here that numba keeps on disk.

    numba notices a change of the file of a kernel that it kept, not of the files of kernels compiled into it. Closing
    over `build`, a checksum of those, makes them part of the key; a kernel elsewhere is kept only where all that it
    calls is in its own file.
    """

    @kernel(**UNCOUNTED)
    def fly(states: Row, commands: Row, parameters: Row, times: Row, dt: float, thrust: Row) -> None:
        _ = build
        for vehicle in range(states.shape[0]):
            s, c, p = states[vehicle], commands[vehicle], parameters[vehicle]
            guide, yaw, linear = s[_GUIDE:_GUIDE_END], s[_YAW:_YAW_END], s[_LINEAR:_LINEAR_END]
            if linear[guidance.LINEAR_STAMP] != c[CMD_TIME_S]:
                linear[guidance.LINEAR_STAMP] = c[CMD_TIME_S]
                linear[guidance.LINEAR_SINCE] = times[vehicle]
                for i in range(3):
                    linear[guidance.LINEAR_START + i] = s[_REF_V + i]
            for k in range(thrust.shape[1]):
                thrust[vehicle, k] = _step(s, c, p, guide, yaw, linear, times[vehicle] + k * dt, dt)
            if s[STARTED] != 0.0:
                set_reference(s, c, p, guide, linear, times[vehicle] + thrust.shape[1] * dt)

    return fly


def checksum() -> int:
    """Of the files that are compiled into the core, this one among them: for kernels elsewhere that it is compiled
    into."""
    modules = (params, dynamics, differentiator, controller, guidance, power)
    files = (__file__, *(str(module.__file__) for module in modules))
    return zlib.crc32(b"".join(Path(file).read_bytes() for file in files))


fly_rows = _compiled(checksum())
"""(states, commands, parameters, times (n,), dt, thrust (n, k)): as `advance`, but in place and unchecked: all of
float64, in C order."""


def initial_state(
    params: VehicleParams,
    *,
    position_nwu: Sequence[float],
    velocity_nwu: Sequence[float],
    attitude_rad: Sequence[float],
    airborne: bool,
) -> NDArray[np.float64]:
    """State of a vehicle before its first step, (STATE_SIZE,), guidance matched to a start in motion
    (docs/model.md#guidance).

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
    state[GUIDE] = guidance.start(state[POSITION], state[VELOCITY], guidance=params.guidance)[0]
    state[GUIDE_YAW] = state[ATTITUDE][2] = dynamics.wrap_angle(state[ATTITUDE][2])
    state[LINEAR][guidance.LINEAR_STAMP] = guidance.NO_STAMP
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
    """Fly n vehicles k steps on (docs/model.md#vehicle). Pure: the arguments stay as they are.

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
