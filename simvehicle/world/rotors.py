"""A rigid body on four rotors (docs/model.md#rotors) [choice]: its motion over one step, as compiled functions.

Axes are nwu for the world and flu for the body. A body is a row of 17 numbers: position (m), velocity (m/s),
quaternion (w, x, y, z) from flu to nwu, body rates (rad/s), rotor speeds (rad/s). Motors are first-order lags, solved
exactly; the rest is one step of RK4.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from simvehicle.kernels import inner, kernel
from simvehicle.world.airframes import (
    A_ALLOCATION,
    A_BODY_DRAG,
    A_FASTEST,
    A_GRAVITY,
    A_INFLOW_DRAG,
    A_IX,
    A_IY,
    A_IZ,
    A_LAG,
    A_MASS,
    A_ROTOR_DRAG,
    A_SPIN,
    A_THRUST,
    A_TORQUE,
    A_X,
    A_Y,
)

Row = NDArray[np.float64]

B_POSITION, B_VELOCITY, B_QUATERNION, B_RATES, B_ROTORS = 0, 3, 6, 10, 13
BODY_SIZE = 17
_MOVING = B_ROTORS  # the numbers before it are integrated
# Sums over the rotors: ω, ωx, ωy, ωxx, ωyy, ωxy, and thrust with its moments.
_S, _SX, _SY, _SXX, _SYY, _SXY, _THRUST, _MX, _MY, _MZ = range(10)
# Scratch of a step: sums at its begin, middle and end, four slopes, and the state that a slope is taken at.
_SUMS, _SLOPES, _AT = 0, 30, 30 + 4 * _MOVING
SCRATCH_SIZE = _AT + _MOVING


@inner(error_model="numpy")
def rotated(q: Row, x: float, y: float, z: float, sign: float) -> tuple[float, float, float]:
    """A vector of the body in the world's axes (sign 1), or one of the world in the body's (sign -1), by q."""
    w, a, b, c = q[0], sign * q[1], sign * q[2], sign * q[3]
    tx, ty, tz = 2.0 * (b * z - c * y), 2.0 * (c * x - a * z), 2.0 * (a * y - b * x)
    return x + w * tx + b * tz - c * ty, y + w * ty + c * tx - a * tz, z + w * tz + a * ty - b * tx


@inner(error_model="numpy")
def rotor_sums(body: Row, wanted: Row, share: float, a: Row, out: Row) -> None:
    """Sums over the rotors once they have come from their speed to the share `share` of what is missing to the wanted
    speed."""
    for i in range(10):
        out[i] = 0.0
    for i in range(4):
        speed = body[B_ROTORS + i] + share * (wanted[i] - body[B_ROTORS + i])
        x, y = a[A_X + i], a[A_Y + i]
        thrust = a[A_THRUST] * speed * speed
        out[_S] += speed
        out[_SX] += speed * x
        out[_SY] += speed * y
        out[_SXX] += speed * x * x
        out[_SYY] += speed * y * y
        out[_SXY] += speed * x * y
        out[_THRUST] += thrust
        out[_MX] += y * thrust
        out[_MY] -= x * thrust
        out[_MZ] -= a[A_SPIN + i] * a[A_TORQUE] * speed * speed


@inner(error_model="numpy")
def wrench(at: Row, sums: Row, wind: Row, a: Row) -> tuple[float, float, float, float, float, float]:
    """Force (N) and moment (N m) of the air in the body's axes: thrust, rotor drag at each hub, body drag.

    F = Σ (0, 0, k_T ω²) - Σ ω diag(k_d, k_d, k_z) (u + Ω x r) - |u| diag(c) u,   u: air speed in the body's axes
    """
    q = at[B_QUATERNION : B_QUATERNION + 4]
    ux, uy, uz = rotated(q, at[3] - wind[0], at[4] - wind[1], at[5] - wind[2], -1.0)
    p, q_rate, r = at[B_RATES], at[B_RATES + 1], at[B_RATES + 2]
    across, along = a[A_ROTOR_DRAG], a[A_INFLOW_DRAG]
    speed = math.sqrt(ux * ux + uy * uy + uz * uz)
    fx = -across * (ux * sums[_S] - r * sums[_SY]) - speed * a[A_BODY_DRAG] * ux
    fy = -across * (uy * sums[_S] + r * sums[_SX]) - speed * a[A_BODY_DRAG + 1] * uy
    fz = sums[_THRUST] - along * (uz * sums[_S] + p * sums[_SY] - q_rate * sums[_SX]) - speed * a[A_BODY_DRAG + 2] * uz
    mx = sums[_MX] - along * (uz * sums[_SY] + p * sums[_SYY] - q_rate * sums[_SXY])
    my = sums[_MY] + along * (uz * sums[_SX] + p * sums[_SXY] - q_rate * sums[_SXX])
    mz = sums[_MZ] - across * (uy * sums[_SX] - ux * sums[_SY] + r * (sums[_SXX] + sums[_SYY]))
    return fx, fy, fz, mx, my, mz


@inner(error_model="numpy")
def _slope(at: Row, sums: Row, wind: Row, a: Row, out: Row) -> None:
    """Time derivative of position, velocity, quaternion and body rates (Newton, Euler)."""
    fx, fy, fz, mx, my, mz = wrench(at, sums, wind, a)
    q = at[B_QUATERNION : B_QUATERNION + 4]
    ax, ay, az = rotated(q, fx, fy, fz, 1.0)
    p, q_rate, r = at[B_RATES], at[B_RATES + 1], at[B_RATES + 2]
    mass, ix, iy, iz = a[A_MASS], a[A_IX], a[A_IY], a[A_IZ]
    out[0], out[1], out[2] = at[3], at[4], at[5]
    out[3], out[4], out[5] = ax / mass, ay / mass, az / mass - a[A_GRAVITY]
    w, x, y, z = q[0], q[1], q[2], q[3]
    out[6] = -0.5 * (x * p + y * q_rate + z * r)
    out[7] = 0.5 * (w * p + y * r - z * q_rate)
    out[8] = 0.5 * (w * q_rate + z * p - x * r)
    out[9] = 0.5 * (w * r + x * q_rate - y * p)
    out[10] = (mx - (iz - iy) * q_rate * r) / ix
    out[11] = (my - (ix - iz) * r * p) / iy
    out[12] = (mz - (iy - ix) * p * q_rate) / iz


@inner(error_model="numpy")
def body_step(body: Row, wanted: Row, wind: Row, a: Row, dt: float, scratch: Row) -> None:
    """One step of dt seconds in place, towards wanted rotor speeds (4,) rad/s, in a wind (3,) nwu, m/s, held meanwhile.

    scratch: (SCRATCH_SIZE,), written.
    """
    half = 1.0 - math.exp(-0.5 * dt / a[A_LAG])
    whole = 1.0 - math.exp(-dt / a[A_LAG])
    begin, middle, end = scratch[0:10], scratch[10:20], scratch[20:30]
    rotor_sums(body, wanted, 0.0, a, begin)
    rotor_sums(body, wanted, half, a, middle)
    rotor_sums(body, wanted, whole, a, end)
    n = _MOVING
    k1, k2 = scratch[_SLOPES : _SLOPES + n], scratch[_SLOPES + n : _SLOPES + 2 * n]
    k3, k4 = scratch[_SLOPES + 2 * n : _SLOPES + 3 * n], scratch[_SLOPES + 3 * n : _SLOPES + 4 * n]
    at = scratch[_AT : _AT + n]
    _slope(body, begin, wind, a, k1)
    for i in range(n):
        at[i] = body[i] + 0.5 * dt * k1[i]
    _slope(at, middle, wind, a, k2)
    for i in range(n):
        at[i] = body[i] + 0.5 * dt * k2[i]
    _slope(at, middle, wind, a, k3)
    for i in range(n):
        at[i] = body[i] + dt * k3[i]
    _slope(at, end, wind, a, k4)
    for i in range(n):
        body[i] += dt / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i])
    for i in range(4):
        body[B_ROTORS + i] += whole * (wanted[i] - body[B_ROTORS + i])
    _normalise(body)


@inner(error_model="numpy")
def _normalise(body: Row) -> None:
    q = body[B_QUATERNION : B_QUATERNION + 4]
    size = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    for i in range(4):
        q[i] /= size


@inner(error_model="numpy")
def meet_ground(body: Row, x: float, y: float, stood: bool) -> bool:
    """Stand level at z = 0 where there is no lift, x and y where the step began if it stood; whether it stands."""
    if body[2] > 0.0 or body[5] > 0.0:
        return False
    _, _, yaw = euler_of(body[B_QUATERNION : B_QUATERNION + 4])
    if stood:
        body[0], body[1] = x, y
    body[2] = 0.0
    for i in range(3):
        body[B_VELOCITY + i] = body[B_RATES + i] = 0.0
    quaternion_of(0.0, 0.0, yaw, body[B_QUATERNION : B_QUATERNION + 4])
    return True


@inner(error_model="numpy")
def euler_of(q: Row) -> tuple[float, float, float]:
    """Roll, pitch and yaw (z, y, x in turn), rad."""
    w, x, y, z = q[0], q[1], q[2], q[3]
    sine = min(max(2.0 * (w * y - z * x), -1.0), 1.0)
    roll = math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
    return roll, math.asin(sine), math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


@kernel(error_model="numpy")
def quaternion_of(roll: float, pitch: float, yaw: float, out: Row) -> None:
    """The quaternion of roll, pitch and yaw, rad, into out (4,)."""
    sr, cr = math.sin(0.5 * roll), math.cos(0.5 * roll)
    sp, cp = math.sin(0.5 * pitch), math.cos(0.5 * pitch)
    sy, cy = math.sin(0.5 * yaw), math.cos(0.5 * yaw)
    out[0] = cr * cp * cy + sr * sp * sy
    out[1] = sr * cp * cy - cr * sp * sy
    out[2] = cr * sp * cy + sr * cp * sy
    out[3] = cr * cp * sy - sr * sp * cy


@inner(error_model="numpy")
def allocate(thrust: float, mx: float, my: float, mz: float, a: Row, out: Row) -> None:
    """Rotor speeds (4,), rad/s, for a thrust (N) and moments (N m) about the body's axes, within what they can turn.

    What cannot all be had is given up in this order: yaw, thrust, roll and pitch together.
    """
    m = a[A_ALLOCATION : A_ALLOCATION + 16]
    most = a[A_THRUST] * a[A_FASTEST] * a[A_FASTEST]
    whole = True
    for i in range(4):
        force = m[4 * i] * thrust + m[4 * i + 1] * mx + m[4 * i + 2] * my + m[4 * i + 3] * mz
        whole = whole and 0.0 <= force <= most
        out[i] = math.sqrt(max(force, 0.0) / a[A_THRUST])
    if not whole:
        _allocate_less(thrust, mx, my, mz, m, most, a[A_THRUST], out)


@inner(error_model="numpy")
def _allocate_less(
    thrust: float, mx: float, my: float, mz: float, m: Row, most: float, coefficient: float, out: Row
) -> None:
    tilt_share = 1.0
    for i in range(4):
        for j in range(4):
            # Two rotors differ by what tilts alone; lifting both by thrust must leave both within 0 and the most.
            lift_i, lift_j = m[4 * i], m[4 * j]
            tilt_i, tilt_j = m[4 * i + 1] * mx + m[4 * i + 2] * my, m[4 * j + 1] * mx + m[4 * j + 2] * my
            # 0 <= tilt_j + lift_j T and tilt_i + lift_i T <= most for one T
            need = tilt_i * lift_j - tilt_j * lift_i
            if need * tilt_share > most * lift_j:
                tilt_share = most * lift_j / need
    low, high = 0.0, 1e30
    for i in range(4):
        tilt = tilt_share * (m[4 * i + 1] * mx + m[4 * i + 2] * my)
        low = max(low, -tilt / m[4 * i])
        high = min(high, (most - tilt) / m[4 * i])
    lift = max(min(thrust, high), low)
    turn_share = 1.0
    for i in range(4):
        base = m[4 * i] * lift + tilt_share * (m[4 * i + 1] * mx + m[4 * i + 2] * my)
        turn = m[4 * i + 3] * mz
        if turn * turn_share > max(most - base, 0.0):
            turn_share = max(most - base, 0.0) / turn
        elif -turn * turn_share > max(base, 0.0):
            turn_share = max(base, 0.0) / -turn
    for i in range(4):
        base = m[4 * i] * lift + tilt_share * (m[4 * i + 1] * mx + m[4 * i + 2] * my)
        force = min(max(base + turn_share * m[4 * i + 3] * mz, 0.0), most)
        out[i] = math.sqrt(force / coefficient)


@inner(error_model="numpy")
def moments_of(
    angles: Row, rates: Row, roll_acc: float, pitch_acc: float, yaw_acc: float, a: Row
) -> tuple[float, float, float]:
    """Moments (N m) about the body's axes that give Euler angles (rad) with rates (rad/s) accelerations (rad/s²):
    the time derivative of p = φ' - ψ' sinθ and its like, in Euler's equations."""
    sr, cr, sp, cp = math.sin(angles[0]), math.cos(angles[0]), math.sin(angles[1]), math.cos(angles[1])
    roll_rate, pitch_rate, yaw_rate = rates[0], rates[1], rates[2]
    p = roll_rate - yaw_rate * sp
    q = pitch_rate * cr + yaw_rate * sr * cp
    r = -pitch_rate * sr + yaw_rate * cr * cp
    p_dot = roll_acc - yaw_acc * sp - yaw_rate * pitch_rate * cp
    q_dot = (
        pitch_acc * cr
        - pitch_rate * roll_rate * sr
        + yaw_acc * sr * cp
        + yaw_rate * (roll_rate * cr * cp - pitch_rate * sr * sp)
    )
    r_dot = (
        -pitch_acc * sr
        - pitch_rate * roll_rate * cr
        + yaw_acc * cr * cp
        - yaw_rate * (roll_rate * sr * cp + pitch_rate * cr * sp)
    )
    ix, iy, iz = a[A_IX], a[A_IY], a[A_IZ]
    return ix * p_dot + (iz - iy) * q * r, iy * q_dot + (ix - iz) * r * p, iz * r_dot + (iy - ix) * p * q
