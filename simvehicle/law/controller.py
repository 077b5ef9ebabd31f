"""Double closed-loop speed tracking: outer loop (docs/model/control.md#speed-loop) [choice], also without its floor,
and inner loop (docs/model/control.md#attitude-loop) [lineage]."""

from __future__ import annotations

import cython.cimports.skytender.elementary as elementary
from cython.cimports.libc import math
from cython.cimports.simvehicle.law.arithmetic import bounded

_LEAST_LIFT = 0.3  # of g: floor of W_z
_LEAST_LIFT_LITERAL = 1e-6  # m/s²: keeps the literal form's quotients finite
_FARTHEST = 1e6  # m/s² and rad/s²: keeps every number finite, far outside what flies


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
    """Speed loop: (φ_d, θ_d, u1) (docs/model/control.md#speed-loop) [choice].

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
    sin_yaw, cos_yaw = elementary.sin_cos(yaw)
    pitch = elementary.atan2(wx * cos_yaw + wy * sin_yaw, wz)
    roll = elementary.asin(bounded((wx * sin_yaw - wy * cos_yaw) / u1, 1.0))
    return roll, pitch, u1


def outer_literal(
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
) -> tuple[float, float, float]:
    """Speed loop without floor and limits, θ_d within ±90° [seed] and thrust with its sign: (φ_d, θ_d, u1)
    (docs/model/control.md#speed-loop) [choice: the form of paper eq. 17, which is lost].

        θ_d = atan((W_x cosψ + W_y sinψ)/W_z)   φ_d = atan(cosθ_d (W_x sinψ - W_y cosψ)/W_z)   u1 = W_z/(cosφ_d cosθ_d)

    For every W with W_z ≠ 0 thrust and angles give exactly W; where W_z changes its sign the angles jump by up to 180°.
    """
    wx = bounded(adx + drag * vx - gain * (vx - vdx), _FARTHEST)
    wy = bounded(ady + drag * vy - gain * (vy - vdy), _FARTHEST)
    wz = bounded(adz + drag * vz - gain * (vz - vdz), _FARTHEST) + gravity
    sin_yaw, cos_yaw = elementary.sin_cos(yaw)
    ahead, aside = wx * cos_yaw + wy * sin_yaw, wx * sin_yaw - wy * cos_yaw
    if abs(wz) < _LEAST_LIFT_LITERAL:
        wz = _LEAST_LIFT_LITERAL if wz >= 0.0 else -_LEAST_LIFT_LITERAL
    pitch = elementary.atan(ahead / wz)
    roll = elementary.atan(elementary.cos(pitch) * aside / wz)
    return roll, pitch, wz / (elementary.cos(roll) * elementary.cos(pitch))


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
    """Attitude loop of one angle: tau (docs/model/control.md#attitude-loop) [lineage], with error = γ - γ_d.

    tau = γ_d'' + (L Kγ/Iγ) γ_d' - Ap (γ' - γ_d') - Aq (γ - γ_d)
    """
    tau = acceleration_d + drag * rate_d - rate_gain * (rate - rate_d) - angle_gain * error
    return bounded(tau, min(limit, _FARTHEST))
