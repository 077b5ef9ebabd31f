"""Flights on an estimate that errs: the finite-time differentiator against the two others, inside the loop.

The vehicle's law and plant fly a level circle by velocity. What the law knows of the motion errs as by a scenario's
`sensors:` (docs/model/world.md#estimate-errors), so that noise reaches the desired angles, which are differentiated
twice.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from simvehicle.law import controller, differentiator, dynamics
from simvehicle.law.params import NAMED, SOLVE_TOLERANCE, STEP_S
from simvehicle.paper import comparators
from simvehicle.world.error_step import error_step
from simvehicle.world.estimate import EstimateErrors
from simvehicle.world.rows import ERROR_SIZE

Floats = NDArray[np.float64]
Differentiate = Callable[[float], tuple[float, float]]
"""A signal's next sample → its first and second derivative."""

SHARES = (0.0, 0.5, 1.0, 2.0)
"""[choice] Errors relative to the errors of `sensors: {}`."""
SEED = 12
DURATION_S, COUNTED_FROM_S = 40.0, 10.0
SPEED_M_S, TURN_RAD_S = 2.0, 0.6
"""[choice] Of the circle: 3.3 m of radius, 1.2 m/s² towards its middle, 7° of tilt."""


def finite_time() -> Differentiate:
    """The vehicle's own, stepped as it steps it (docs/model/control.md#differentiator)."""
    epsilon = NAMED["default"].gains.epsilon
    x = (0.0, 0.0, 0.0)

    def derivatives(signal: float) -> tuple[float, float]:
        nonlocal x
        x1, x2, x3, _ = differentiator.solve(*x, signal, STEP_S, epsilon, SOLVE_TOLERANCE)
        x = x1, x2, x3
        return x2, x3

    return derivatives


def sliding_mode() -> Differentiate:
    """Levant's; its derivative goes through a second one of its kind
    (docs/model/control.md#comparison-differentiators)."""
    states = [(0.0, 0.0), (0.0, 0.0)]

    def derivatives(signal: float) -> tuple[float, float]:
        found = []
        for k in range(2):
            following, u1, signal = comparators.sliding_mode(
                *states[k], signal, STEP_S, comparators.SLIDING_ALPHA, comparators.SLIDING_LAMBDA
            )
            states[k] = following, u1
            found.append(signal)
        return found[0], found[1]

    return derivatives


def high_gain() -> Differentiate:
    """The linear one; likewise its derivative through a second one
    (docs/model/control.md#comparison-differentiators)."""
    states = [(0.0, 0.0), (0.0, 0.0)]

    def derivatives(signal: float) -> tuple[float, float]:
        found = []
        for k in range(2):
            states[k] = comparators.high_gain(
                *states[k],
                signal,
                STEP_S,
                comparators.HIGH_GAIN_K1,
                comparators.HIGH_GAIN_K2,
                comparators.HIGH_GAIN_ALPHA,
            )
            signal = states[k][1]
            found.append(signal)
        return found[0], found[1]

    return derivatives


DIFFERENTIATORS: dict[str, Callable[[], Differentiate]] = {
    "finite_time": finite_time,
    "sliding_mode": sliding_mode,
    "high_gain": high_gain,
}


def fly(make: Callable[[], Differentiate], share: float) -> tuple[Floats, Floats, Floats]:
    """One flight of DURATION_S.

    Args:
        make: of the differentiators for φ_d and θ_d.
        share: of the estimate's errors, relative to the errors of `sensors: {}`.

    Returns:
        Times (k,) s at the steps' ends, the true velocity minus the wanted one (k, 3) nwu m/s there, and tau (k, 3)
        rad/s² of roll, pitch and yaw over each step.
    """
    vehicle = NAMED["default"]
    gains, airframe, limits = vehicle.gains, vehicle.airframe, vehicle.limits
    drag, damping, gravity = airframe.drag_1_s, airframe.rotational_drag_1_s, airframe.gravity_m_s2
    speed_loop = (gains.speed, drag, gravity, limits.tilt_slope, limits.thrust_m_s2)
    attitude_loop = (gains.rate, gains.angle, damping, limits.angular_acceleration_rad_s2)
    errors = EstimateErrors()
    deviations, decays = share * errors.deviations, np.exp(-STEP_S / errors.times_s)
    steps = round(DURATION_S / STEP_S)
    noise = np.random.default_rng(SEED).standard_normal((steps, ERROR_SIZE))
    error = np.zeros(ERROR_SIZE)
    of_roll, of_pitch = make(), make()
    state = np.zeros(dynamics.PLANT_SIZE)
    state[3] = SPEED_M_S
    off, tau = np.empty((steps, 3)), np.empty((steps, 3))
    for k in range(steps):
        error_step(error, noise[k], deviations, decays)
        vx, vy, vz, roll, pitch, yaw, roll_rate, pitch_rate, yaw_rate = (state[3:] + error[3:]).tolist()
        turned = TURN_RAD_S * STEP_S * k
        cos, sin = math.cos(turned), math.sin(turned)
        wanted = (SPEED_M_S * cos, SPEED_M_S * sin, 0.0)
        towards = (-SPEED_M_S * TURN_RAD_S * sin, SPEED_M_S * TURN_RAD_S * cos, 0.0)
        roll_d, pitch_d, u1 = controller.outer(vx, vy, vz, yaw, *wanted, *towards, *speed_loop)
        torque = (
            controller.inner(roll - roll_d, roll_rate, *of_roll(roll_d), *attitude_loop),
            controller.inner(pitch - pitch_d, pitch_rate, *of_pitch(pitch_d), *attitude_loop),
            controller.inner(dynamics.wrap_angle(yaw), yaw_rate, 0.0, 0.0, *attitude_loop),
        )
        dynamics.plant_step(state, u1, *torque, gravity, drag, damping, STEP_S)
        state[8] = dynamics.wrap_angle(state[8])
        turned += TURN_RAD_S * STEP_S
        off[k] = state[3:6] - (SPEED_M_S * math.cos(turned), SPEED_M_S * math.sin(turned), 0.0)
        tau[k] = torque
    return STEP_S * np.arange(1, steps + 1, dtype=np.float64), off, tau


def study() -> tuple[dict[str, Any], dict[str, Floats]]:
    """Numbers and curves of all flights: differentiators by errors."""
    numbers: dict[str, Any] = {
        "gain_set": "default", "speed_m_s": SPEED_M_S, "turn_rad_s": TURN_RAD_S, "step_s": STEP_S,
        "duration_s": DURATION_S, "counted_from_s": COUNTED_FROM_S, "noise_seed": SEED,
        "torque": "rms over time of roll and pitch together",
        "speed_error": "length of the true velocity minus the wanted one",
    }  # fmt: skip
    cases, curves = [], {}
    for share in SHARES:
        for name, make in DIFFERENTIATORS.items():
            t, off, tau = fly(make, share)
            late = t > COUNTED_FROM_S
            lengths = np.linalg.norm(off[late], axis=1)
            cases.append(
                {
                    "differentiator": name,
                    "errors_over_sensors": share,
                    "torque_rms_rad_s2": float(np.sqrt(np.mean(np.square(tau[late, :2])))),
                    "torque_variation_rad_s2": float(np.abs(np.diff(tau[late, 0])).sum()),
                    "speed_error_rms_m_s": float(np.sqrt(np.mean(np.square(lengths)))),
                    "speed_error_max_m_s": float(lengths.max()),
                }
            )
            if share == 1.0:
                curves[name] = np.column_stack([t, tau])[late]
    return numbers | {"cases": cases}, curves
