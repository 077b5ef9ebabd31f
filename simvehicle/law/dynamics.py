"""The four-rotor UAV as a plant (docs/model/vehicle.md#rigid-body) [lineage], its RK4 step, and the frames it is seen
in.

Axes are the paper's, nwu: x north, y west, z up. The state holds the rates of the Euler angles, not body rates.
A plant state is (x, y, z, x', y', z', φ, θ, ψ, φ', θ', ψ'); inputs are (u1, tau2, tau3, tau4).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.simvehicle.law.dynamics import STAGES
from numpy.typing import ArrayLike, NDArray

from simvehicle.law.params import Airframe
from skytender.elementwise import cosines, sines

Row = NDArray[np.float64]

PLANT_SIZE = 12
INPUT_SIZE = 4


def thrust_direction(roll: float, pitch: float, yaw: float) -> tuple[float, float, float]:
    """Unit vector of thrust in nwu axes (docs/model/vehicle.md#rigid-body) [lineage]."""
    sin_roll, cos_roll = elementary.sin_cos(roll)
    sin_pitch, cos_pitch = elementary.sin_cos(pitch)
    sin_yaw, cos_yaw = elementary.sin_cos(yaw)
    return _thrust_towards(sin_roll, cos_roll, sin_pitch, cos_pitch, sin_yaw, cos_yaw)


def _thrust_towards(
    sin_roll: float, cos_roll: float, sin_pitch: float, cos_pitch: float, sin_yaw: float, cos_yaw: float
) -> tuple[float, float, float]:
    return (
        cos_roll * sin_pitch * cos_yaw + sin_roll * sin_yaw,
        cos_roll * sin_pitch * sin_yaw - sin_roll * cos_yaw,
        cos_roll * cos_pitch,
    )


def rk4_axis(
    x: float, v: float, a1: float, a2: float, a3: float, a4: float, drag: float, dt: float
) -> tuple[float, float, float, float, float]:
    """RK4 of x'' = a - drag x', with a as seen at the four stages; also x at stages 2, 3, 4.

    Every axis of the plant has this form: an angle under its constant tau, a coordinate under a thrust that turns.
    """
    half = 0.5 * dt
    d1 = a1 - drag * v
    v2 = v + half * d1
    d2 = a2 - drag * v2
    v3 = v + half * d2
    d3 = a3 - drag * v3
    v4 = v + dt * d3
    d4 = a4 - drag * v4
    x_next = x + dt / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4)
    v_next = v + dt / 6.0 * (d1 + 2.0 * d2 + 2.0 * d3 + d4)
    return x + half * v, x + half * v2, x + dt * v3, x_next, v_next


def fly_plant(
    s: Any, u1: float, tau2: float, tau3: float, tau4: float, gravity: float, drag: float, rotational_drag: float,
    dt: float,
) -> None:  # fmt: skip
    """One RK4 step of the plant over dt seconds with its inputs held; the 12 numbers at s change in place."""
    roll = cython.declare(cython.double[STAGES])
    pitch = cython.declare(cython.double[STAGES])
    yaw = cython.declare(cython.double[STAGES])
    sin_roll = cython.declare(cython.double[STAGES])
    cos_roll = cython.declare(cython.double[STAGES])
    sin_pitch = cython.declare(cython.double[STAGES])
    cos_pitch = cython.declare(cython.double[STAGES])
    sin_yaw = cython.declare(cython.double[STAGES])
    cos_yaw = cython.declare(cython.double[STAGES])
    x = cython.declare(cython.double[STAGES])
    y = cython.declare(cython.double[STAGES])
    z = cython.declare(cython.double[STAGES])
    roll[0], pitch[0], yaw[0] = s[6], s[7], s[8]
    roll[1], roll[2], roll[3], s[6], s[9] = rk4_axis(s[6], s[9], tau2, tau2, tau2, tau2, rotational_drag, dt)
    pitch[1], pitch[2], pitch[3], s[7], s[10] = rk4_axis(s[7], s[10], tau3, tau3, tau3, tau3, rotational_drag, dt)
    yaw[1], yaw[2], yaw[3], s[8], s[11] = rk4_axis(s[8], s[11], tau4, tau4, tau4, tau4, rotational_drag, dt)
    elementary.sin_cos_of_each(roll, sin_roll, cos_roll)
    elementary.sin_cos_of_each(pitch, sin_pitch, cos_pitch)
    if yaw[0] == yaw[1] == yaw[2] == yaw[3]:  # most vehicles seldom turn
        sin_yaw[0], cos_yaw[0] = elementary.sin_cos(yaw[0])
        for k in range(1, STAGES):
            sin_yaw[k], cos_yaw[k] = sin_yaw[0], cos_yaw[0]
    else:
        elementary.sin_cos_of_each(yaw, sin_yaw, cos_yaw)
    for k in range(STAGES):
        x[k], y[k], z[k] = _thrust_towards(sin_roll[k], cos_roll[k], sin_pitch[k], cos_pitch[k], sin_yaw[k], cos_yaw[k])
    g = gravity
    _, _, _, s[0], s[3] = rk4_axis(s[0], s[3], u1 * x[0], u1 * x[1], u1 * x[2], u1 * x[3], drag, dt)
    _, _, _, s[1], s[4] = rk4_axis(s[1], s[4], u1 * y[0], u1 * y[1], u1 * y[2], u1 * y[3], drag, dt)
    _, _, _, s[2], s[5] = rk4_axis(s[2], s[5], u1 * z[0] - g, u1 * z[1] - g, u1 * z[2] - g, u1 * z[3] - g, drag, dt)


def plant_step(
    s: Row, u1: float, tau2: float, tau3: float, tau4: float, gravity: float, drag: float, rotational_drag: float,
    dt: float,
) -> None:  # fmt: skip
    """`fly_plant` of a row, whose first 12 numbers change in place."""
    fly_plant(cython.address(s[0]), u1, tau2, tau3, tau4, gravity, drag, rotational_drag, dt)


@cython.cdivision(False)
def wrap_angle(angle: float) -> float:
    """The angle's equal in [-π, π], exact however large it is."""
    if -math.M_PI <= angle <= math.M_PI:
        return angle
    rest = angle % (2.0 * math.M_PI)
    return rest - 2.0 * math.M_PI if rest > math.M_PI else rest


def derivative(state: ArrayLike, inputs: ArrayLike, *, airframe: Airframe) -> NDArray[np.float64]:
    """Time derivative of plant states (docs/model/vehicle.md#rigid-body, paper eq. 3) [lineage].

    Args:
        state: (n, 12), nwu axes, m, m/s, rad, rad/s.
        inputs: (n, 4), u1 in m/s² and tau2..tau4 in rad/s².
        airframe: the body.

    Returns:
        (n, 12).

    Raises:
        ValueError: a shape other than (n, 12) and (n, 4).
    """
    s, u = _plant_arrays(state, inputs)
    angles = s[:, 6:9].T
    u1 = u[:, 0]
    rate = np.empty_like(s)
    rate[:, 0:3] = s[:, 3:6]
    sin_roll, sin_pitch, sin_yaw = sines(angles)
    cos_roll, cos_pitch, cos_yaw = cosines(angles)
    rate[:, 3] = u1 * (cos_roll * sin_pitch * cos_yaw + sin_roll * sin_yaw)
    rate[:, 4] = u1 * (cos_roll * sin_pitch * sin_yaw - sin_roll * cos_yaw)
    rate[:, 5] = u1 * cos_roll * cos_pitch - airframe.gravity_m_s2
    rate[:, 3:6] -= airframe.drag_1_s * s[:, 3:6]
    rate[:, 6:9] = s[:, 9:12]
    rate[:, 9:12] = u[:, 1:4] - airframe.rotational_drag_1_s * s[:, 9:12]
    return rate


def body_rates(
    roll: float, pitch: float, roll_rate: float, pitch_rate: float, yaw_rate: float
) -> tuple[float, float, float]:
    """Body rates (p, q, r), rad/s, of nwu Euler angles, rad, and their rates, rad/s (docs/model/vehicle.md#rigid-body)
    [lineage].

    On plain floats: telemetry asks for them in every grant. On the wire they are `ned_from_nwu` of this.
    """
    sin_roll, cos_roll = elementary.sin_cos(roll)
    sin_pitch, cos_pitch = elementary.sin_cos(pitch)
    return (
        roll_rate - yaw_rate * sin_pitch,
        pitch_rate * cos_roll + yaw_rate * sin_roll * cos_pitch,
        -pitch_rate * sin_roll + yaw_rate * cos_roll * cos_pitch,
    )


def ned_from_nwu(v: Sequence[float]) -> tuple[float, float, float]:
    """North, east, down of north, west, up: half a turn about north (docs/protocol/frames.md#frames).

    The same for Euler angles, their rates and body rates: (φ, θ, ψ) gives NED's (φ, -θ, -ψ).
    """
    north, west, up = v
    return north, -west, -up


nwu_from_ned = ned_from_nwu
"""Half a turn is its own inverse."""


def _plant_arrays(state: ArrayLike, inputs: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    s = np.ascontiguousarray(state, dtype=np.float64)
    u = np.asarray(inputs, dtype=np.float64)
    if s.ndim != 2 or s.shape[1] != PLANT_SIZE or u.shape != (s.shape[0], INPUT_SIZE):
        raise ValueError(f"plant states and inputs have shapes {s.shape} and {u.shape}, but need (n, 12) and (n, 4)")
    return s, u
