"""From set points at the planner's rate to a reference the law can fly (docs/model/control.md#guidance) [choice].

A step in v_d is a spike in torque, so a set point is first followed by a point q of bounded speed and acceleration,
and q by three first-order lags r1, r2, r3: the reference r = r3 has continuous acceleration and jerk.
"""

from __future__ import annotations

from typing import Any

import cython.cimports.simvehicle.law.dynamics as dynamics
import numpy as np
from cython.cimports.libc import math
from cython.cimports.simvehicle.law.guidance import guide_of, guide_yaw_of
from numpy.typing import ArrayLike, NDArray

from simvehicle.law.params import Guidance

NO_STAMP = -1e30  # time of no set point


def start_axis(memory: Any, axis: int, position: float, velocity: float, omega: float) -> None:
    """Match one axis to a start in motion: r = position, r' = velocity, r'' = 0."""
    memory.q[axis] = position + 3.0 * velocity / omega
    memory.q_rate[axis] = velocity
    memory.r1[axis] = position + 2.0 * velocity / omega
    memory.r2[axis] = position + velocity / omega
    memory.r3[axis] = position


def reference_axis(r1: float, r2: float, r3: float, omega: float) -> tuple[float, float, float]:
    """r, r', r'' of one chain of lags."""
    return r3, omega * (r2 - r3), omega * omega * (r1 - 2.0 * r2 + r3)


def _sqrt_slope(distance: float, gain: float, decel: float) -> float:
    """sqrtctl(e)/e: speed towards a point per metre of distance, with which a decel of `decel` stops there."""
    near = decel / (gain * gain)
    if distance <= near:
        return gain
    return math.sqrt(2.0 * decel * (distance - 0.5 * near)) / distance


def shape(
    memory: Any,
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
    ax = velocity_gain * (wx * share - memory.q_rate[0])
    ay = velocity_gain * (wy * share - memory.q_rate[1])
    az = velocity_gain * (wz * share - memory.q_rate[2])
    size = math.sqrt(ax * ax + ay * ay + az * az)
    share = accel_max / size if size > accel_max else 1.0
    _shape_axis(memory, 0, ax * share, omega, dt)
    _shape_axis(memory, 1, ay * share, omega, dt)
    _shape_axis(memory, 2, az * share, omega, dt)


def _shape_axis(memory: Any, axis: int, acceleration: float, omega: float, dt: float) -> None:
    q, rate = memory.q[axis], memory.q_rate[axis]
    r1, r2, r3 = memory.r1[axis], memory.r2[axis], memory.r3[axis]
    memory.q[axis] = q + dt * rate + 0.5 * dt * dt * acceleration
    memory.q_rate[axis] = rate + dt * acceleration
    memory.r1[axis] = r1 + dt * omega * (q - r1)
    memory.r2[axis] = r2 + dt * omega * (r1 - r2)
    memory.r3[axis] = r3 + dt * omega * (r2 - r3)


def start_yaw(memory: Any, yaw: float, rate: float, omega: float) -> None:
    """Match the yaw reference to a yaw that turns."""
    memory.q = yaw + 3.0 * rate / omega
    memory.r1 = yaw + 2.0 * rate / omega
    memory.r2 = yaw + rate / omega
    memory.r3 = yaw


def shape_yaw(memory: Any, yaw: float, rate_max: float, omega: float, dt: float) -> None:
    """Carry the yaw reference over dt towards `yaw`, the shorter way round, no faster than rate_max."""
    q, r1, r2, r3 = memory.q, memory.r1, memory.r2, memory.r3
    rate = min(max(omega * dynamics.wrap_angle(yaw - q), -rate_max), rate_max)
    r3_next = r3 + dt * omega * (r2 - r3)
    turn = dynamics.wrap_angle(r3_next) - r3_next  # the whole chain turns together, or its differences would jump
    memory.q = q + dt * rate + turn
    memory.r1 = r1 + dt * omega * (q - r1) + turn
    memory.r2 = r2 + dt * omega * (r1 - r2) + turn
    memory.r3 = r3_next + turn


def linear_axis(start: float, end: float, elapsed: float, period: float) -> tuple[float, float]:
    """v_d and v_d' of the paper's reference: v_d linear from start to end over the period, then constant."""
    if elapsed >= period:
        return end, 0.0
    slope = (end - start) / period
    return start + slope * elapsed, slope


def follow(
    memory: NDArray[np.float64],
    error: NDArray[np.float64],
    velocity: NDArray[np.float64],
    speed_max: float,
    accel_max: float,
    law: Guidance,
    dt: float,
) -> None:
    """`shape` of a row of memory (15,), towards a set point at q + error that moves at velocity, (3,) each."""
    guide, ex, ey, ez = guide_of(memory), error[0], error[1], error[2]
    vx, vy, vz = velocity[0], velocity[1], velocity[2]
    shape(guide, ex, ey, ez, vx, vy, vz, speed_max, accel_max, law.gain, law.decel, law.velocity_gain, law.omega, dt)


def follow_yaw(memory: NDArray[np.float64], yaw: float, rate_max: float, omega: float, dt: float) -> None:
    """`shape_yaw` of a row of memory (4,)."""
    shape_yaw(guide_yaw_of(memory), yaw, rate_max, omega, dt)


def start(position: ArrayLike, velocity: ArrayLike, *, guidance: Guidance) -> NDArray[np.float64]:
    """Memory of a start in motion: position and velocity, (n, 3), nwu, m and m/s, give (n, 15)
    (docs/model/control.md#guidance)."""
    p, v = np.atleast_2d(np.asarray(position, dtype=np.float64)), np.atleast_2d(np.asarray(velocity, dtype=np.float64))
    lead = v / guidance.omega
    return np.concatenate([p + 3.0 * lead, v, p + 2.0 * lead, p + lead, p], axis=1)
