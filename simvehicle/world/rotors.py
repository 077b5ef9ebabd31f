"""A rigid body on four rotors (docs/model/vehicle.md#rotors) [choice]: its motion over one step, as compiled functions.

Axes are nwu for the world and flu for the body. A body is a row of 17 numbers: position (m), velocity (m/s),
quaternion (w, x, y, z) from flu to nwu, body rates (rad/s), rotor speeds (rad/s). Motors are first-order lags, solved
exactly; the rest is one step of RK4.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.simvehicle.world.rotors import Sums, airframe_at, body_at
from cython.cimports.simvehicle.world.rows import MOVING, Body
from numpy.typing import NDArray

Row = NDArray[np.float64]


def rotated(q: Any, x: float, y: float, z: float, sign: float) -> tuple[float, float, float]:
    """A vector of the body in the world's axes (sign 1), or one of the world in the body's (sign -1), by q."""
    w, a, b, c = q[0], sign * q[1], sign * q[2], sign * q[3]
    tx, ty, tz = 2.0 * (b * z - c * y), 2.0 * (c * x - a * z), 2.0 * (a * y - b * x)
    return x + w * tx + b * tz - c * ty, y + w * ty + c * tx - a * tz, z + w * tz + a * ty - b * tx


def rotor_sums(body: Any, wanted: Any, share: float, a: Any, out: Any) -> None:
    """Sums over the rotors once they have come from their speed to the share `share` of what is missing to the wanted
    speed."""
    out.s = out.sx = out.sy = out.sxx = out.syy = out.sxy = 0.0
    out.thrust = out.mx = out.my = out.mz = 0.0
    for i in range(4):
        speed = body.rotors[i] + share * (wanted[i] - body.rotors[i])
        x, y = a.x[i], a.y[i]
        thrust = a.thrust * speed * speed
        out.s += speed
        out.sx += speed * x
        out.sy += speed * y
        out.sxx += speed * x * x
        out.syy += speed * y * y
        out.sxy += speed * x * y
        out.thrust += thrust
        out.mx += y * thrust
        out.my -= x * thrust
        out.mz -= a.spin[i] * a.torque * speed * speed


def wrench(at: Any, sums: Any, wind: Any, a: Any) -> tuple[float, float, float, float, float, float]:
    """Force (N) and moment (N m) of the air in the body's axes: thrust, rotor drag at each hub, body drag.

    F = Σ (0, 0, k_T ω²) - Σ ω diag(k_d, k_d, k_z) (u + Ω x r) - |u| diag(c) u,   u: air speed in the body's axes
    """
    q = at.quaternion
    ux, uy, uz = rotated(q, at.velocity[0] - wind[0], at.velocity[1] - wind[1], at.velocity[2] - wind[2], -1.0)
    p, q_rate, r = at.rates[0], at.rates[1], at.rates[2]
    across, along = a.rotor_drag, a.inflow_drag
    speed = math.sqrt(ux * ux + uy * uy + uz * uz)
    fx = -across * (ux * sums.s - r * sums.sy) - speed * a.body_drag[0] * ux
    fy = -across * (uy * sums.s + r * sums.sx) - speed * a.body_drag[1] * uy
    fz = sums.thrust - along * (uz * sums.s + p * sums.sy - q_rate * sums.sx) - speed * a.body_drag[2] * uz
    mx = sums.mx - along * (uz * sums.sy + p * sums.syy - q_rate * sums.sxy)
    my = sums.my + along * (uz * sums.sx + p * sums.sxy - q_rate * sums.sxx)
    mz = sums.mz - across * (uy * sums.sx - ux * sums.sy + r * (sums.sxx + sums.syy))
    return fx, fy, fz, mx, my, mz


def _slope(at: Any, sums: Any, wind: Any, a: Any, out: Any) -> None:
    """Time derivative of position, velocity, quaternion and body rates (Newton, Euler)."""
    fx, fy, fz, mx, my, mz = wrench(at, sums, wind, a)
    q = at.quaternion
    ax, ay, az = rotated(q, fx, fy, fz, 1.0)
    p, q_rate, r = at.rates[0], at.rates[1], at.rates[2]
    mass, ix, iy, iz = a.mass, a.ix, a.iy, a.iz
    out[0], out[1], out[2] = at.velocity[0], at.velocity[1], at.velocity[2]
    out[3], out[4], out[5] = ax / mass, ay / mass, az / mass - a.gravity
    w, x, y, z = q[0], q[1], q[2], q[3]
    out[6] = -0.5 * (x * p + y * q_rate + z * r)
    out[7] = 0.5 * (w * p + y * r - z * q_rate)
    out[8] = 0.5 * (w * q_rate + z * p - x * r)
    out[9] = 0.5 * (w * r + x * q_rate - y * p)
    out[10] = (mx - (iz - iy) * q_rate * r) / ix
    out[11] = (my - (ix - iz) * r * p) / iy
    out[12] = (mz - (iy - ix) * p * q_rate) / iz


def spin_up(a: Any, dt: float) -> tuple[float, float]:
    """Shares of what rotors lack of their wanted speeds that half a step of dt seconds and a whole one make good."""
    return 1.0 - elementary.exp(-0.5 * dt / a.lag), 1.0 - elementary.exp(-dt / a.lag)


def step_body(body: Any, wanted: Any, wind: Any, a: Any, spin: tuple[float, float], dt: float) -> None:
    """One step of dt seconds in place, towards wanted rotor speeds (4,) rad/s, in a held wind (3,) nwu, m/s; spin:
    `spin_up` of dt."""
    at = cython.declare(Body)
    begin = cython.declare(Sums)
    middle = cython.declare(Sums)
    end = cython.declare(Sums)
    k1 = cython.declare(cython.double[MOVING])
    k2 = cython.declare(cython.double[MOVING])
    k3 = cython.declare(cython.double[MOVING])
    k4 = cython.declare(cython.double[MOVING])
    half, whole = spin
    rotor_sums(body, wanted, 0.0, a, cython.address(begin))
    rotor_sums(body, wanted, half, a, cython.address(middle))
    rotor_sums(body, wanted, whole, a, cython.address(end))
    moved, moving = cython.cast(cython.p_double, body), cython.cast(cython.p_double, cython.address(at))
    _slope(body, cython.address(begin), wind, a, k1)
    for i in range(MOVING):
        moving[i] = moved[i] + 0.5 * dt * k1[i]
    _slope(cython.address(at), cython.address(middle), wind, a, k2)
    for i in range(MOVING):
        moving[i] = moved[i] + 0.5 * dt * k2[i]
    _slope(cython.address(at), cython.address(middle), wind, a, k3)
    for i in range(MOVING):
        moving[i] = moved[i] + dt * k3[i]
    _slope(cython.address(at), cython.address(end), wind, a, k4)
    for i in range(MOVING):
        moved[i] += dt / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i])
    for i in range(4):
        body.rotors[i] += whole * (wanted[i] - body.rotors[i])
    _normalise(body)


def _normalise(body: Any) -> None:
    q = body.quaternion
    size = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    for i in range(4):
        q[i] /= size


def land_body(body: Any, x: float, y: float, stood: bool) -> bool:
    """Stand level at z = 0 where there is no lift, x and y where the step began if it stood; whether it stands."""
    if body.position[2] > 0.0 or body.velocity[2] > 0.0:
        return False
    _, _, yaw = euler_of(body.quaternion)
    if stood:
        body.position[0], body.position[1] = x, y
    body.position[2] = 0.0
    for i in range(3):
        body.velocity[i] = body.rates[i] = 0.0
    quaternion_of(0.0, 0.0, yaw, body.quaternion)
    return True


def euler_of(q: Any) -> tuple[float, float, float]:
    """Roll, pitch and yaw (z, y, x in turn), rad."""
    w, x, y, z = q[0], q[1], q[2], q[3]
    sine = min(max(2.0 * (w * y - z * x), -1.0), 1.0)
    roll = elementary.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
    return roll, elementary.asin(sine), elementary.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


def quaternion_of(roll: float, pitch: float, yaw: float, out: Any) -> None:
    """The quaternion of roll, pitch and yaw, rad, into out (4,)."""
    sr, cr = elementary.sin_cos(0.5 * roll)
    sp, cp = elementary.sin_cos(0.5 * pitch)
    sy, cy = elementary.sin_cos(0.5 * yaw)
    out[0] = cr * cp * cy + sr * sp * sy
    out[1] = sr * cp * cy - cr * sp * sy
    out[2] = cr * sp * cy + sr * cp * sy
    out[3] = cr * cp * sy - sr * sp * cy


def allocate(thrust: float, mx: float, my: float, mz: float, a: Any, out: Any) -> None:
    """Rotor speeds (4,), rad/s, for a thrust (N) and moments (N m) about the body's axes, within what they can turn.

    What cannot all be had is given up in this order: yaw, thrust, roll and pitch together.
    """
    m = a.allocation
    most = a.thrust * a.fastest * a.fastest
    whole = True
    for i in range(4):
        force = m[4 * i] * thrust + m[4 * i + 1] * mx + m[4 * i + 2] * my + m[4 * i + 3] * mz
        whole = whole and 0.0 <= force <= most
        out[i] = math.sqrt(max(force, 0.0) / a.thrust)
    if not whole:
        _allocate_less(thrust, mx, my, mz, m, most, a.thrust, out)


def _allocate_less(
    thrust: float, mx: float, my: float, mz: float, m: Any, most: float, coefficient: float, out: Any
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


def moments_of(
    angles: Any, rates: Any, roll_acc: float, pitch_acc: float, yaw_acc: float, a: Any
) -> tuple[float, float, float]:
    """Moments (N m) about the body's axes that give Euler angles (rad) with rates (rad/s) accelerations (rad/s²):
    the time derivative of p = φ' - ψ' sinθ and its like, in Euler's equations."""
    sr, cr = elementary.sin_cos(angles[0])
    sp, cp = elementary.sin_cos(angles[1])
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
    ix, iy, iz = a.ix, a.iy, a.iz
    return ix * p_dot + (iz - iy) * q * r, iy * q_dot + (ix - iz) * r * p, iz * r_dot + (iy - ix) * p * q


# The same of rows, for what is not compiled: a body (17,), an airframe (AIRFRAME_SIZE,), vectors.


def body_step(body: Row, wanted: Row, wind: Row, airframe: Row, dt: float) -> None:
    """`step_body`."""
    a = airframe_at(airframe)
    step_body(body_at(body), cython.address(wanted[0]), cython.address(wind[0]), a, spin_up(a, dt), dt)


def meet_ground(body: Row, x: float, y: float, stood: bool) -> bool:
    """`land_body`."""
    return land_body(body_at(body), x, y, stood)


def rotor_speeds(thrust: float, mx: float, my: float, mz: float, airframe: Row) -> Row:
    """`allocate`: rotor speeds (4,), rad/s."""
    speeds = np.empty(4)
    out = speeds
    allocate(thrust, mx, my, mz, airframe_at(airframe), cython.address(out[0]))
    return speeds


def moments(angles: Row, rates: Row, accelerations: Row, airframe: Row) -> tuple[float, float, float]:
    """`moments_of` angular accelerations (3,), rad/s²."""
    ax, ay, az = accelerations[0], accelerations[1], accelerations[2]
    return moments_of(cython.address(angles[0]), cython.address(rates[0]), ax, ay, az, airframe_at(airframe))


def in_body_axes(quaternion: Row, x: float, y: float, z: float) -> tuple[float, float, float]:
    """`rotated` of a vector of the world."""
    return rotated(cython.address(quaternion[0]), x, y, z, -1.0)


def quaternion(roll: float, pitch: float, yaw: float) -> Row:
    """`quaternion_of` Euler angles, rad: (4,)."""
    made = np.empty(4)
    out = made
    quaternion_of(roll, pitch, yaw, cython.address(out[0]))
    return made
