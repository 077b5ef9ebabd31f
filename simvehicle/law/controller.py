"""Double closed-loop speed tracking: outer loop (docs/model.md#speed-loop) [choice] and inner loop
(docs/model.md#attitude-loop) [lineage]."""

from __future__ import annotations

import math

import numpy as np
from numba import njit
from numpy.typing import ArrayLike, NDArray

from simvehicle.law import differentiator
from simvehicle.law.dynamics import wrap_angle
from simvehicle.law.params import SOLVE_TOLERANCE, Airframe, Gains, Limits

MEMORY_SIZE = 2 * differentiator.ORDER  # X1, X2, X3 of roll, then of pitch
_LEAST_LIFT = 0.3  # of g: floor of W_z
_FARTHEST = 1e6  # m/s² and rad/s²: keeps every number finite, far outside what flies


@njit(cache=True, error_model="numpy")
def bounded(x: float, limit: float) -> float:
    """x within ±limit."""
    return min(max(x, -limit), limit)


@njit(cache=True, error_model="numpy")
def outer(
    vx: float,
    vy: float,
    vz: float,
    yaw: float,
    vdx: float,
    vdy: float,
    vdz: float,
    adx: float,
    ady: float,
    adz: float,
    gain: float,
    drag: float,
    gravity: float,
    tilt_slope: float,
    thrust_max: float,
) -> tuple[float, float, float]:
    """Speed loop: (φ_d, θ_d, u1) (docs/model.md#speed-loop) [choice].

    W = v_d' + (K/m) v + (0, 0, g) - λ (v - v_d). Lift comes first: W_z is floored at 0.3 g and capped at the most
    thrust, then the horizontal part shrinks to what tilt and thrust leave.
    """
    wx = bounded(adx + drag * vx - gain * (vx - vdx), _FARTHEST)
    wy = bounded(ady + drag * vy - gain * (vy - vdy), _FARTHEST)
    wz = bounded(adz + drag * vz - gain * (vz - vdz), _FARTHEST) + gravity
    wz = min(max(wz, _LEAST_LIFT * gravity), thrust_max)
    level = math.sqrt(wx * wx + wy * wy)
    reach = min(wz * tilt_slope, math.sqrt(thrust_max * thrust_max - wz * wz))
    if level > reach:
        wx *= reach / level
        wy *= reach / level
    u1 = min(math.sqrt(wx * wx + wy * wy + wz * wz), thrust_max)
    sin_yaw, cos_yaw = math.sin(yaw), math.cos(yaw)
    pitch = math.atan2(wx * cos_yaw + wy * sin_yaw, wz)
    roll = math.asin(bounded((wx * sin_yaw - wy * cos_yaw) / u1, 1.0))
    return roll, pitch, u1


@njit(cache=True, error_model="numpy")
def inner(
    error: float,
    rate: float,
    rate_d: float,
    acceleration_d: float,
    rate_gain: float,
    angle_gain: float,
    drag: float,
    limit: float,
) -> float:
    """Attitude loop of one angle: tau (docs/model.md#attitude-loop) [lineage], with error = γ - γ_d.

    tau = γ_d'' + (L Kγ/Iγ) γ_d' - Ap (γ' - γ_d') - Aq (γ - γ_d)
    """
    tau = acceleration_d + drag * rate_d - rate_gain * (rate - rate_d) - angle_gain * error
    return bounded(tau, min(limit, _FARTHEST))


def step(
    velocity: ArrayLike,
    attitude: ArrayLike,
    rates: ArrayLike,
    reference_velocity: ArrayLike,
    reference_acceleration: ArrayLike,
    yaw_reference: ArrayLike,
    memory: ArrayLike,
    *,
    dt_s: float,
    gains: Gains,
    airframe: Airframe,
    limits: Limits,
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Both loops and their differentiators, one step (docs/model.md#control-law, paper eqs. 13-21). All axes nwu.

    Args:
        velocity: (n, 3), m/s.
        attitude: (n, 3), roll, pitch, yaw, rad.
        rates: (n, 3), rates of the Euler angles, rad/s.
        reference_velocity: (n, 3), v_d, m/s.
        reference_acceleration: (n, 3), v_d', m/s².
        yaw_reference: (n, 3), ψ_d, ψ_d', ψ_d'' in rad, rad/s, rad/s²; ψ - ψ_d is wrapped.
        memory: (n, 6), X1, X2, X3 of roll and of pitch.
        dt_s: the law's period.
        gains, airframe, limits: the vehicle.

    Returns:
        u1 (n,) in m/s², tau (n, 3) in rad/s², memory (n, 6) for the next step.

    Raises:
        ValueError: an argument whose shape is not (n, 3), or (n, 6) for the memory.
    """
    named = {
        "velocity": velocity,
        "attitude": attitude,
        "rates": rates,
        "reference_velocity": reference_velocity,
        "reference_acceleration": reference_acceleration,
        "yaw_reference": yaw_reference,
        "memory": memory,
    }
    arrays = {name: np.asarray(value, dtype=np.float64) for name, value in named.items()}
    n = arrays["velocity"].shape[0] if arrays["velocity"].ndim else 0
    for name, array in arrays.items():
        shape = (n, MEMORY_SIZE if name == "memory" else 3)
        if array.shape != shape:
            raise ValueError(f"{name} has shape {array.shape}, but needs {shape}")

    u1, tau, memory_next = np.empty(n), np.empty((n, 3)), np.empty((n, MEMORY_SIZE))
    drag = airframe.rotational_drag_1_s
    limit = limits.angular_acceleration_rad_s2
    plant = (airframe.drag_1_s, airframe.gravity_m_s2, limits.tilt_slope, limits.thrust_m_s2)
    for i, rows in enumerate(zip(*(array.tolist() for array in arrays.values()), strict=True)):
        v, angle, rate, v_d, a_d, yaw_d, x = rows
        speed_loop = (*v, angle[2], *v_d, *a_d, gains.speed, *plant)
        roll_d, pitch_d, u1[i] = outer(*speed_loop)
        x1, x2, x3, y1, y2, y3 = x
        x1, x2, x3, _ = differentiator.solve(x1, x2, x3, roll_d, dt_s, gains.epsilon, SOLVE_TOLERANCE)
        y1, y2, y3, _ = differentiator.solve(y1, y2, y3, pitch_d, dt_s, gains.epsilon, SOLVE_TOLERANCE)
        errors = (angle[0] - roll_d, angle[1] - pitch_d, wrap_angle(angle[2] - yaw_d[0]))
        rates_d, accelerations_d = (x2, y2, yaw_d[1]), (x3, y3, yaw_d[2])
        for k in range(3):
            tau[i, k] = inner(errors[k], rate[k], rates_d[k], accelerations_d[k], gains.rate, gains.angle, drag, limit)
        memory_next[i] = (x1, x2, x3, y1, y2, y3)
    return u1, tau, memory_next
