"""From set points at the planner's rate to a reference the law can fly (docs/model.md#guidance) [choice].

A step in v_d is a spike in torque, so a set point is first followed by a point q of bounded speed and acceleration,
and q by three first-order lags r1, r2, r3: the reference r = r3 has continuous acceleration and jerk.
The compiled kernels write the memory that they are given.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from simvehicle.kernels import UNCOUNTED, inner, kernel
from simvehicle.law.dynamics import wrap_angle
from simvehicle.law.params import Guidance

Row = NDArray[np.float64]

Q, Q_RATE, R1, R2, R3 = range(0, 15, 3)  # offsets of three axes each in the memory
MEMORY_SIZE = 15
YAW_Q, YAW_R1, YAW_R2, YAW_R3 = range(4)
LINEAR_START, LINEAR_SINCE, LINEAR_STAMP = 0, 3, 4  # v_d at arrival (3), when it arrived, the set point's time
NO_STAMP = -1e30  # time of no set point


@kernel(**UNCOUNTED)
def start_axis(memory: Row, axis: int, position: float, velocity: float, omega: float) -> None:
    """Match one axis to a start in motion: r = position, r' = velocity, r'' = 0."""
    memory[Q + axis] = position + 3.0 * velocity / omega
    memory[Q_RATE + axis] = velocity
    memory[R1 + axis] = position + 2.0 * velocity / omega
    memory[R2 + axis] = position + velocity / omega
    memory[R3 + axis] = position


@kernel(**UNCOUNTED)
def reference_axis(r1: float, r2: float, r3: float, omega: float) -> tuple[float, float, float]:
    """r, r', r'' of one chain of lags."""
    return r3, omega * (r2 - r3), omega * omega * (r1 - 2.0 * r2 + r3)


@kernel(**UNCOUNTED)
def _sqrt_slope(distance: float, gain: float, decel: float) -> float:
    """sqrtctl(e)/e: speed towards a point per metre of distance, with which a decel of `decel` stops there."""
    near = decel / (gain * gain)
    if distance <= near:
        return gain
    return math.sqrt(2.0 * decel * (distance - 0.5 * near)) / distance


@kernel(**UNCOUNTED)
def shape(
    memory: Row,
    ex: float,
    ey: float,
    ez: float,
    vx: float,
    vy: float,
    vz: float,
    speed_max: float,
    accel_max: float,
    gain: float,
    decel: float,
    velocity_gain: float,
    omega: float,
    dt: float,
) -> None:
    """Carry q and its lags over dt towards a set point at q + e that moves at v.

    v* = sat_vmax(v + sqrtctl(e)),   q'' = sat(10 (v* - q')),   r1' = ω(q - r1), r2' = ω(r1 - r2), r3' = ω(r2 - r3)
    """
    slope = _sqrt_slope(math.sqrt(ex * ex + ey * ey + ez * ez), gain, decel)
    wx, wy, wz = vx + slope * ex, vy + slope * ey, vz + slope * ez
    speed = math.sqrt(wx * wx + wy * wy + wz * wz)
    share = speed_max / speed if speed > speed_max else 1.0
    ax = velocity_gain * (wx * share - memory[Q_RATE])
    ay = velocity_gain * (wy * share - memory[Q_RATE + 1])
    az = velocity_gain * (wz * share - memory[Q_RATE + 2])
    size = math.sqrt(ax * ax + ay * ay + az * az)
    share = accel_max / size if size > accel_max else 1.0
    _shape_axis(memory, 0, ax * share, omega, dt)
    _shape_axis(memory, 1, ay * share, omega, dt)
    _shape_axis(memory, 2, az * share, omega, dt)


@kernel(**UNCOUNTED)
def _shape_axis(memory: Row, axis: int, acceleration: float, omega: float, dt: float) -> None:
    q, rate = memory[Q + axis], memory[Q_RATE + axis]
    r1, r2, r3 = memory[R1 + axis], memory[R2 + axis], memory[R3 + axis]
    memory[Q + axis] = q + dt * rate + 0.5 * dt * dt * acceleration
    memory[Q_RATE + axis] = rate + dt * acceleration
    memory[R1 + axis] = r1 + dt * omega * (q - r1)
    memory[R2 + axis] = r2 + dt * omega * (r1 - r2)
    memory[R3 + axis] = r3 + dt * omega * (r2 - r3)


@kernel(**UNCOUNTED)
def start_yaw(memory: Row, yaw: float, rate: float, omega: float) -> None:
    """Match the yaw reference to a yaw that turns."""
    memory[YAW_Q] = yaw + 3.0 * rate / omega
    memory[YAW_R1] = yaw + 2.0 * rate / omega
    memory[YAW_R2] = yaw + rate / omega
    memory[YAW_R3] = yaw


@inner(**UNCOUNTED)
def shape_yaw(memory: Row, yaw: float, rate_max: float, omega: float, dt: float) -> None:
    """Carry the yaw reference over dt towards `yaw`, the shorter way round, no faster than rate_max."""
    q, r1, r2, r3 = memory[YAW_Q], memory[YAW_R1], memory[YAW_R2], memory[YAW_R3]
    rate = min(max(omega * wrap_angle(yaw - q), -rate_max), rate_max)
    r3_next = r3 + dt * omega * (r2 - r3)
    turn = wrap_angle(r3_next) - r3_next  # the whole chain turns together, or its differences would jump
    memory[YAW_Q] = q + dt * rate + turn
    memory[YAW_R1] = r1 + dt * omega * (q - r1) + turn
    memory[YAW_R2] = r2 + dt * omega * (r1 - r2) + turn
    memory[YAW_R3] = r3_next + turn


@kernel(**UNCOUNTED)
def linear_axis(start: float, end: float, elapsed: float, period: float) -> tuple[float, float]:
    """v_d and v_d' of the paper's reference: v_d linear from start to end over the period, then constant."""
    if elapsed >= period:
        return end, 0.0
    slope = (end - start) / period
    return start + slope * elapsed, slope


def start(position: ArrayLike, velocity: ArrayLike, *, guidance: Guidance) -> NDArray[np.float64]:
    """Memory of a start in motion: position and velocity, (n, 3), nwu, m and m/s, give (n, 15)
    (docs/model.md#guidance)."""
    p, v = np.atleast_2d(np.asarray(position, dtype=np.float64)), np.atleast_2d(np.asarray(velocity, dtype=np.float64))
    lead = v / guidance.omega
    return np.concatenate([p + 3.0 * lead, v, p + 2.0 * lead, p + lead, p], axis=1)
