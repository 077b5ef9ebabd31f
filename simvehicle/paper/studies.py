"""The paper's vehicle-only figures as studies: each flies or differentiates, and gives its numbers and its curves.

    fig5      the finite-time differentiator on 5 sin t (docs/model/control.md#differentiator; paper Fig. 5)
    fig12     it on sin t, against the sliding-mode and the linear high-gain differentiator (paper Fig. 12)
    implicit  why it is stepped implicitly: torque and speed error against step and noise
              (docs/model/control.md#differentiator)
    noise     the three in flight, on an estimate that errs (docs/model/control.md#comparison-differentiators)

Numbers carry their unit in their name; a time of convergence that is never reached is null.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from simvehicle.law import controller, differentiator, dynamics
from simvehicle.law.params import NAMED, SOLVE_TOLERANCE, STEP_S, VehicleParams
from simvehicle.paper import comparators, figures, noisy_flight

Floats = NDArray[np.float64]
Study = tuple[dict[str, Any], dict[str, Floats]]
"""Data of a figure: numbers for vehicle.json, curves by name for drawing."""
Law = Callable[[float, float, float, float], tuple[float, float, float]]

SCHEMA = 1
SETTLED_S = 3.0  # errors count from here (docs/model/control.md#differentiator)
DURATION_S = 20.0
WITHIN = 0.1  # converged: the error stays below this share of the amplitude...
HELD_S = 1.0  # ... for so long
FINE_STEP_S = 1e-4  # where explicit steps of every differentiator are near their limit
NOISE_RAD = 0.01  # standard deviation of each sample of fig12's noisy signal, 1 % of the amplitude
SEED = 12

STEPS_S = (0.001, 0.002, 0.004, 0.008)
NOISES_M_S = (0.0, 0.02)
FLIGHT_S = 40.0
STEADY_S = 30.0  # torque and speed error count from here
VELOCITY_NWU = (1.0, 1.0, 0.2)  # m/s, start and reference of the steady flight
ATTITUDE_RAD = (1.0, 1.0, 1.0)  # the paper's start


def make(out: Path, names: Iterable[str], say: Callable[[str], None]) -> None:
    """Write NAME.svg and NAME.png of each named study, and vehicle.json, to the folder `out`; `say` is called with
    each.

    Raises:
        OSError: a file cannot be written.
    """
    out.mkdir(parents=True, exist_ok=True)
    drawn: dict[str, Any] = {}
    for name in names:
        numbers, curves = STUDIES[name]()
        files = figures.write(name, curves, numbers, out)
        drawn[name] = numbers | {"files": files}
        say(f"{name}: {', '.join(files)}")
    text = json.dumps({"schema": SCHEMA, "figures": drawn}, indent=2, allow_nan=False)
    (out / "vehicle.json").write_text(text + "\n", encoding="utf-8")


def fig5() -> Study:
    """5 sin t, differentiated as the vehicle does it: X(0) = 0, ε = 0.04, implicit steps of 4 ms."""
    epsilon = NAMED["paper"].gains.epsilon
    t = _times(STEP_S, DURATION_S)
    truth = 5.0 * np.stack([np.sin(t), np.cos(t), -np.sin(t)], axis=1)
    x = follow(_implicit(STEP_S, epsilon), truth[:, 0])
    numbers: dict[str, Any] = {
        "signal": "5 sin t",
        "amplitude_rad": 5.0,
        "epsilon_s": epsilon,
        "step_s": STEP_S,
        "duration_s": DURATION_S,
        "settled_after_s": SETTLED_S,
        "converged_within_share_of_amplitude": WITHIN,
        "converged_held_s": HELD_S,
    }
    for k, unit in enumerate(("rad", "rad_s", "rad_s2")):
        error = x[:, k] - truth[:, k]
        late = error[t > SETTLED_S]
        numbers[f"x{k + 1}_error_max_{unit}"] = float(np.abs(late).max())
        numbers[f"x{k + 1}_error_rms_{unit}"] = _rms(late)
        numbers[f"x{k + 1}_convergence_time_s"] = convergence_time(t, error, WITHIN * 5.0)
    numbers["noise_std_rad"], numbers["noise_seed"] = NOISE_RAD, SEED
    numbers["noise_rms_share_of_amplitude"] = {
        f"{amplitude:g} sin t": _noise_shares(amplitude, epsilon) for amplitude in (5.0, 1.0)
    }
    return numbers, {"t": t, "x": x, "truth": truth}


def _noise_shares(amplitude: float, epsilon: float) -> list[float]:
    """Rms that noise of NOISE_RAD adds to X1, X2, X3 from SETTLED_S on, over the signal's amplitude."""
    t = _times(STEP_S, DURATION_S)
    clean = amplitude * np.sin(t)
    noise = NOISE_RAD * np.random.default_rng(SEED).standard_normal(t.size)
    law = _implicit(STEP_S, epsilon)
    added = (follow(law, clean + noise) - follow(law, clean))[t > SETTLED_S]
    return [_rms(added[:, k]) / amplitude for k in range(3)]


def fig12() -> Study:
    """sin t from rest by four differentiators: clean and noisy at 4 ms, and clean at 0.1 ms."""
    cases = {"clean": (STEP_S, 0.0), "noisy": (STEP_S, NOISE_RAD), "clean_fine_step": (FINE_STEP_S, 0.0)}
    numbers: dict[str, Any] = {
        "signal": "sin t",
        "amplitude_rad": 1.0,
        "duration_s": DURATION_S,
        "settled_after_s": SETTLED_S,
        "converged_within_share_of_amplitude": WITHIN,
        "converged_held_s": HELD_S,
        "noise_std_rad": NOISE_RAD,
        "noise_seed": SEED,
        "finite_time": {"epsilon_s": NAMED["paper"].gains.epsilon},
        "sliding_mode": {"alpha_1_s2": comparators.SLIDING_ALPHA, "lambda_1_s": comparators.SLIDING_LAMBDA},
        "high_gain": {
            "k1": comparators.HIGH_GAIN_K1,
            "k2": comparators.HIGH_GAIN_K2,
            "alpha_s": comparators.HIGH_GAIN_ALPHA,
        },
    }
    curves: dict[str, Floats] = {}
    for case, (step_s, noise) in cases.items():
        t = _times(step_s, DURATION_S)
        signal = np.sin(t) + noise * np.random.default_rng(SEED).standard_normal(t.size)
        truth = np.cos(t)
        late = t > SETTLED_S
        entry: dict[str, Any] = {
            "step_s": step_s,
            "truth": {"total_variation_rad_s": _variation(truth), "settled_variation_rad_s": _variation(truth[late])},
        }
        for name, (law, (of_signal, signal_lead), (of_derivative, lead)) in _differentiators(step_s).items():
            x = follow(law, signal)
            estimate = x[:, of_derivative]
            error = estimate - np.cos(t + lead * step_s)
            signal_error = x[:, of_signal] - np.sin(t + signal_lead * step_s)
            entry[name] = {
                "signal_error_max_rad": float(np.abs(signal_error[late]).max()),
                "derivative_error_max_rad_s": float(np.abs(error[late]).max()),
                "derivative_error_rms_rad_s": _rms(error[late]),
                "derivative_peak_rad_s": float(np.abs(estimate).max()),
                "convergence_time_s": convergence_time(t, error, WITHIN),
                "total_variation_rad_s": _variation(estimate),
                "settled_variation_rad_s": _variation(estimate[late]),
            }
            curves[f"{case}_{name}"] = estimate
        numbers[case] = entry
        curves[f"{case}_t"], curves[f"{case}_truth"] = t, truth
    return numbers, curves


def implicit() -> Study:
    """Steady flight of the paper's vehicle: torque and speed error by step, velocity noise and discretisation."""
    vehicle = NAMED["paper"]
    numbers: dict[str, Any] = {
        "gain_set": "paper",
        "reference_velocity_nwu_m_s": list(VELOCITY_NWU),
        "start_attitude_rad": list(ATTITUDE_RAD),
        "duration_s": FLIGHT_S,
        "counted_from_s": STEADY_S,
        "torque": "rms over time of roll and pitch together",
        "speed_error": "length of the velocity error, true velocity",
        "noise_seed": SEED,
    }
    cases, curves = [], {}
    for method in ("explicit", "implicit"):
        for noise in NOISES_M_S:
            for step_s in STEPS_S:
                t, velocity, tau = closed_loop(vehicle, step_s=step_s, noise_m_s=noise, explicit=method == "explicit")
                late = t > STEADY_S
                error = np.sqrt(np.square(velocity[late] - VELOCITY_NWU).sum(axis=1))
                cases.append(
                    {
                        "method": method,
                        "step_s": step_s,
                        "velocity_noise_m_s": noise,
                        "torque_rms_rad_s2": _number(_rms(tau[late, :2])),
                        "speed_error_rms_m_s": _number(_rms(error)),
                        "speed_error_max_m_s": _number(error.max()),
                    }
                )
                if step_s == STEP_S:
                    curves[f"{method}_{noise:g}"] = np.column_stack([t, tau])[late]
    return numbers | {"cases": cases}, curves


def closed_loop(
    vehicle: VehicleParams, *, step_s: float, noise_m_s: float, explicit: bool, duration_s: float = FLIGHT_S
) -> tuple[Floats, Floats, Floats]:
    """Fly the vehicle's own law and plant at VELOCITY_NWU with either discretisation of its differentiators.

    Args:
        vehicle: gains, airframe and limits; the velocity loop flies a constant v_d, X(0) = 0.
        step_s: the law's period and the plant's step, s.
        noise_m_s: standard deviation of the velocity that the law is given, each axis and step on its own.
        explicit: step the differentiators by explicit Euler, else implicitly as the vehicle does.

    Returns:
        Times (k,) s at the steps' ends, velocity (k, 3) nwu m/s there, tau (k, 3) rad/s² of roll, pitch and yaw held
        over each step.
    """
    gains, airframe, limits = vehicle.gains, vehicle.airframe, vehicle.limits
    drag, damping = airframe.drag_1_s, airframe.rotational_drag_1_s
    law = (_explicit if explicit else _implicit)(step_s, gains.epsilon)
    attitude_loop = (gains.rate, gains.angle, damping, limits.angular_acceleration_rad_s2)
    reference = (*VELOCITY_NWU, 0.0, 0.0, 0.0)
    speed_loop = (gains.speed, drag, airframe.gravity_m_s2, limits.tilt_slope, limits.thrust_m_s2)
    t = _times(step_s, duration_s)
    noise = noise_m_s * np.random.default_rng(SEED).standard_normal((t.size, 3))
    velocity, tau = np.empty((t.size, 3)), np.empty((t.size, 3))
    state = np.zeros(dynamics.PLANT_SIZE)
    state[3:6], state[6:9] = VELOCITY_NWU, ATTITUDE_RAD
    of_roll = of_pitch = (0.0, 0.0, 0.0)
    for k, (ex, ey, ez) in enumerate(noise.tolist()):
        vx, vy, vz, roll, pitch, yaw, roll_rate, pitch_rate, yaw_rate = state[3:].tolist()
        measured = (vx + ex, vy + ey, vz + ez, yaw)
        outer = (*measured, *reference, *speed_loop)
        roll_d, pitch_d, u1 = controller.outer(*outer)
        of_roll, of_pitch = law(*of_roll, roll_d), law(*of_pitch, pitch_d)
        torque = (
            controller.inner(roll - roll_d, roll_rate, of_roll[1], of_roll[2], *attitude_loop),
            controller.inner(pitch - pitch_d, pitch_rate, of_pitch[1], of_pitch[2], *attitude_loop),
            controller.inner(dynamics.wrap_angle(yaw), yaw_rate, 0.0, 0.0, *attitude_loop),
        )
        held = (u1, *torque, airframe.gravity_m_s2, drag, damping, step_s)
        dynamics.plant_step(state, *held)
        state[8] = dynamics.wrap_angle(state[8])
        velocity[k], tau[k] = state[3:6], torque
    return t, velocity, tau


def follow(law: Law, signal: Floats) -> Floats:
    """Response of a differentiator that starts at zero to a signal (k,): its state (k, 3) after each sample."""
    x = (0.0, 0.0, 0.0)
    rows = np.empty((signal.size, 3))
    for k, value in enumerate(signal.tolist()):
        x = law(*x, value)
        rows[k] = x
    return rows


def convergence_time(t: Floats, error: Floats, within: float) -> float | None:
    """Start, in s, of the first HELD_S during which |error| (k,) at evenly spaced times t (k,) stays below `within`.

    None where there is no such time. Later peaks do not count: the law has one in X3 wherever X2 crosses zero, since
    sig(ε X2)^(9/7) bends there without bound.
    """
    held = round(HELD_S / (t[1] - t[0]))
    before = np.concatenate([[-1], np.flatnonzero(np.abs(error) >= within), [t.size]])
    long_enough = np.flatnonzero(np.diff(before) > held)
    return float(t[before[long_enough[0]] + 1]) if long_enough.size else None


def _implicit(step_s: float, epsilon: float) -> Law:
    def law(x1: float, x2: float, x3: float, signal: float) -> tuple[float, float, float]:
        x1, x2, x3, _ = differentiator.solve(x1, x2, x3, signal, step_s, epsilon, SOLVE_TOLERANCE)
        return x1, x2, x3

    return law


def _explicit(step_s: float, epsilon: float) -> Law:
    def law(x1: float, x2: float, x3: float, signal: float) -> tuple[float, float, float]:
        return comparators.explicit(x1, x2, x3, signal, step_s, epsilon)

    return law


def _differentiators(step_s: float) -> dict[str, tuple[Law, tuple[int, int], tuple[int, int]]]:
    """By name: a law; where its state has the signal and the derivative, and how many steps after the sample these are.

    An implicit step ends at the sample that it is given, an explicit one begins there.
    """
    epsilon = NAMED["paper"].gains.epsilon
    alpha, lambda_ = comparators.SLIDING_ALPHA, comparators.SLIDING_LAMBDA
    high_gain = (comparators.HIGH_GAIN_K1, comparators.HIGH_GAIN_K2, comparators.HIGH_GAIN_ALPHA)

    def sliding(x: float, u1: float, _u: float, signal: float) -> tuple[float, float, float]:
        return comparators.sliding_mode(x, u1, signal, step_s, alpha, lambda_)

    def linear(x1: float, x2: float, _: float, signal: float) -> tuple[float, float, float]:
        x1, x2 = comparators.high_gain(x1, x2, signal, step_s, *high_gain)
        return x1, x2, 0.0

    return {
        "finite_time": (_implicit(step_s, epsilon), (0, 0), (1, 0)),
        "finite_time_explicit": (_explicit(step_s, epsilon), (0, 1), (1, 1)),
        "sliding_mode": (sliding, (0, 1), (2, 0)),
        "high_gain": (linear, (0, 1), (1, 1)),
    }


def _times(step_s: float, duration_s: float) -> Floats:
    return step_s * np.arange(1, round(duration_s / step_s) + 1, dtype=np.float64)


def _rms(x: Floats) -> float:
    return float(np.sqrt(np.mean(np.square(x))))


def _variation(x: Floats) -> float:
    return float(np.abs(np.diff(x)).sum())


def _number(x: float) -> float | None:
    return float(x) if math.isfinite(x) else None


STUDIES: dict[str, Callable[[], Study]] = {
    "fig5": fig5,
    "fig12": fig12,
    "implicit": implicit,
    "noise": noisy_flight.study,
}
