"""The flight core of vehicles on rotors: guidance → outer loop → differentiators → inner loop → allocation → rotors →
energy (docs/model.md#rotors).

A vehicle is one row: what the law knows, laid out as in step.py, and behind it the body as rotors.py has it. The law is
the same as on the paper's plant; its angular accelerations become moments, its thrust and those four rotor speeds.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from simvehicle.kernels import kernel
from simvehicle.law import controller, differentiator, dynamics, guidance, params, power, step
from simvehicle.law.params import PARAMS_SIZE, STEP_S, Airframe, VehicleParams
from simvehicle.law.step import (
    CMD_GROUND,
    CMD_MOTORS,
    CMD_TIME_S,
    COMMAND_SIZE,
    CONTACT,
    EFFORT,
    REMAINING_J,
    STARTED,
    STATE_SIZE,
    control,
    draw,
    guide_on,
    set_reference,
    start_afresh,
)
from simvehicle.world import airframes, rotors
from simvehicle.world.airframes import A_MASS, A_SIZE, A_THRUST, GRAVITY_M_S2, HEADROOM, SEA_LEVEL_KG_M3, RotorAirframe
from simvehicle.world.rotors import (
    B_POSITION,
    B_QUATERNION,
    B_RATES,
    B_ROTORS,
    B_VELOCITY,
    BODY_SIZE,
    SCRATCH_SIZE,
    allocate,
    body_step,
    euler_of,
    meet_ground,
    moments_of,
)

Row = NDArray[np.float64]

BODY = slice(STATE_SIZE, STATE_SIZE + BODY_SIZE)
ROTOR_STATE_SIZE = STATE_SIZE + BODY_SIZE
TRUE_POSITION = slice(BODY.start + B_POSITION, BODY.start + B_POSITION + 3)
TRUE_VELOCITY = slice(BODY.start + B_VELOCITY, BODY.start + B_VELOCITY + 3)
TRUE_QUATERNION = slice(BODY.start + B_QUATERNION, BODY.start + B_QUATERNION + 4)
BODY_RATES = slice(BODY.start + B_RATES, BODY.start + B_RATES + 3)
ROTOR_SPEEDS = slice(BODY.start + B_ROTORS, BODY.start + B_ROTORS + 4)
_ANGLE, _RATE = step.ATTITUDE.start, step.RATES.start
_LEAST_COSINE = 1e-6
_BODY, _BODY_END = BODY.start, BODY.stop
_GUIDE, _YAW, _LINEAR = step.GUIDE.start, step.GUIDE_YAW.start, step.LINEAR.start
_GUIDE_END, _YAW_END, _LINEAR_END = step.GUIDE.stop, step.GUIDE_YAW.stop, step.LINEAR.stop
_REF_V = step.REFERENCE_VELOCITY.start


@njit(error_model="numpy")
def _see(s: Row, body: Row) -> None:
    """Write what the law knows of its motion: the body's, its attitude as Euler angles with their rates."""
    for i in range(6):
        s[i] = body[i]
    roll, pitch, yaw = euler_of(body[B_QUATERNION : B_QUATERNION + 4])
    p, q, r = body[B_RATES], body[B_RATES + 1], body[B_RATES + 2]
    sin_roll, cos_roll = np.sin(roll), np.cos(roll)
    yaw_rate = (q * sin_roll + r * cos_roll) / max(np.cos(pitch), _LEAST_COSINE)
    s[_ANGLE], s[_ANGLE + 1], s[_ANGLE + 2] = roll, pitch, yaw
    s[_RATE] = p + yaw_rate * np.sin(pitch)
    s[_RATE + 1] = q * cos_roll - r * sin_roll
    s[_RATE + 2] = yaw_rate


@njit(error_model="numpy")
def _step(
    s: Row, c: Row, p: Row, a: Row, guide: Row, yaw: Row, linear: Row, t: float, dt: float, wanted: Row, scratch: Row
) -> float:
    """One step from t to t + dt; returns the thrust per mass at its end."""
    u1 = tau2 = tau3 = tau4 = 0.0
    body = s[_BODY:_BODY_END]
    x, y, stood = body[0], body[1], s[CONTACT] != 0.0
    running = c[CMD_MOTORS] != 0.0 and s[REMAINING_J] > 0.0
    if running:
        set_reference(s, c, p, guide, linear, t)
        u1, tau2, tau3, tau4 = control(s, c, p, yaw, dt)
        guide_on(s, c, p, guide, yaw, t, dt)
        mx, my, mz = moments_of(s[_ANGLE : _ANGLE + 3], s[_RATE : _RATE + 3], tau2, tau3, tau4, a)
        allocate(a[A_MASS] * u1, mx, my, mz, a, wanted)
    else:
        wanted[:] = 0.0
    wind = scratch[SCRATCH_SIZE : SCRATCH_SIZE + 3]
    body_step(body, wanted, wind, a, dt, scratch)
    s[CONTACT] = 1.0 if c[CMD_GROUND] != 0.0 and meet_ground(body, x, y, stood) else 0.0
    _see(s, body)
    thrust = 0.0
    for i in range(4):
        thrust += a[A_THRUST] * body[B_ROTORS + i] * body[B_ROTORS + i]
    thrust /= a[A_MASS]
    draw(s, p, thrust, dt)
    s[EFFORT] += power.effort_rate(u1, tau2, tau3, tau4) * dt
    if not running:
        start_afresh(s, p, guide, yaw, linear)
    return thrust


def _compiled(build: int) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """The entries that numba keeps on disk, with `build` as a part of their key (see step.py)."""

    @kernel(error_model="numpy")
    def fly(states: Row, commands: Row, parameters: Row, frames: Row, times: Row, dt: float, thrust: Row) -> None:
        _ = build
        wanted, scratch = np.zeros(4), np.zeros(SCRATCH_SIZE + 3)
        for vehicle in range(states.shape[0]):
            s, c, p, a = states[vehicle], commands[vehicle], parameters[vehicle], frames[vehicle]
            guide, yaw, linear = s[_GUIDE:_GUIDE_END], s[_YAW:_YAW_END], s[_LINEAR:_LINEAR_END]
            if linear[guidance.LINEAR_STAMP] != c[CMD_TIME_S]:
                linear[guidance.LINEAR_STAMP] = c[CMD_TIME_S]
                linear[guidance.LINEAR_SINCE] = times[vehicle]
                for i in range(3):
                    linear[guidance.LINEAR_START + i] = s[_REF_V + i]
            for k in range(thrust.shape[1]):
                t = times[vehicle] + k * dt
                thrust[vehicle, k] = _step(s, c, p, a, guide, yaw, linear, t, dt, wanted, scratch)
            if s[STARTED] != 0.0:
                set_reference(s, c, p, guide, linear, times[vehicle] + thrust.shape[1] * dt)

    @kernel(error_model="numpy")
    def drive(body: Row, wanted: Row, wind: Row, a: Row, dt: float, path: Row) -> None:
        _ = build
        scratch = np.zeros(SCRATCH_SIZE)
        for k in range(path.shape[0]):
            body_step(body, wanted[k], wind[k], a, dt, scratch)
            path[k] = body

    return fly, drive


def _checksum() -> int:
    modules = (params, dynamics, differentiator, controller, guidance, power, step, airframes, rotors)
    return zlib.crc32(b"".join(Path(str(module.__file__)).read_bytes() for module in modules))


_fly, _drive = _compiled(_checksum())


def on_rotors(flight: VehicleParams, airframe: RotorAirframe, density_kg_m3: float = SEA_LEVEL_KG_M3) -> VehicleParams:
    """Parameters of the law for an airframe: its gravity and drag, and no more thrust than its rotors have to spare.

    Raises:
        ValueError: in air of this density the rotors cannot lift it.
    """
    share = density_kg_m3 / SEA_LEVEL_KG_M3
    spare = HEADROOM * share * airframe.greatest_thrust_m_s2
    body = Airframe(
        mass_kg=airframe.mass_kg,
        gravity_m_s2=GRAVITY_M_S2,
        drag_kg_s=airframe.hover_drag_1_s * airframe.mass_kg * share**0.5,
        rotational_drag=0.0,
    )
    limits = replace(flight.limits, thrust_m_s2=min(flight.limits.thrust_m_s2, spare))
    return replace(flight, airframe=body, limits=limits)


def initial_state(
    flight: VehicleParams,
    *,
    position_nwu: Sequence[float],
    velocity_nwu: Sequence[float],
    attitude_rad: Sequence[float],
    airborne: bool,
    airframe: RotorAirframe,
) -> NDArray[np.float64]:
    """State before the first step, (ROTOR_STATE_SIZE,), as `step.initial_state`; rotors turn where it is airborne."""
    state = np.zeros(ROTOR_STATE_SIZE)
    state[:STATE_SIZE] = step.initial_state(
        flight, position_nwu=position_nwu, velocity_nwu=velocity_nwu, attitude_rad=attitude_rad, airborne=airborne
    )
    state[TRUE_POSITION], state[TRUE_VELOCITY] = state[step.POSITION], state[step.VELOCITY]
    rotors.quaternion_of(*(float(angle) for angle in state[step.ATTITUDE]), state[TRUE_QUATERNION])
    state[ROTOR_SPEEDS] = airframe.hover_rad_s if airborne else 0.0
    return state


def advance(
    state: NDArray[np.float64],
    command: NDArray[np.float64],
    packed_params: NDArray[np.float64],
    packed_airframe: NDArray[np.float64],
    *,
    time_s: float,
    steps: int,
    dt_s: float = STEP_S,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Fly n vehicles k steps on. Pure: the arguments stay as they are.

    Args:
        state: (n, ROTOR_STATE_SIZE).
        command: (n, COMMAND_SIZE), as for `step.advance`.
        packed_params: (n, PARAMS_SIZE), of `on_rotors`.
        packed_airframe: (n, A_SIZE), from `airframes.pack`.
        time_s: time of the state, s.
        steps: k.
        dt_s: a step, s.

    Returns:
        state (n, ROTOR_STATE_SIZE) at time_s + k dt_s, and the rotors' thrust per mass (n, k) in m/s² after every step.

    Raises:
        ValueError: an array of another shape.
    """
    n = state.shape[0]
    for name, array, width in (
        ("state", state, ROTOR_STATE_SIZE),
        ("command", command, COMMAND_SIZE),
        ("packed_params", packed_params, PARAMS_SIZE),
        ("packed_airframe", packed_airframe, A_SIZE),
    ):
        if array.shape != (n, width):
            raise ValueError(f"{name} has shape {array.shape}, but needs ({n}, {width})")
    flown = np.array(state, dtype=np.float64, order="C")
    thrust = np.empty((n, steps))
    times = np.full(n, float(time_s))
    _fly(flown, _plain(command), _plain(packed_params), _plain(packed_airframe), times, float(dt_s), thrust)
    return flown, thrust


def drive(
    body: NDArray[np.float64],
    wanted_rad_s: NDArray[np.float64],
    wind_nwu: NDArray[np.float64],
    packed_airframe: NDArray[np.float64],
    *,
    dt_s: float,
) -> NDArray[np.float64]:
    """Motion of a body (BODY_SIZE,) alone, without law or ground, by the rotor speeds wanted in each of k steps (k, 4)
    and the wind in each (k, 3): the body after each, (k, BODY_SIZE)."""
    path = np.empty((len(wanted_rad_s), BODY_SIZE))
    _drive(np.array(body), _plain(wanted_rad_s), _plain(wind_nwu), _plain(packed_airframe), float(dt_s), path)
    return path


def _plain(array: NDArray[np.float64]) -> NDArray[np.float64]:
    """The array as the one kind that the core is compiled for: float64, C order, writeable."""
    if array.flags.c_contiguous and array.flags.writeable and array.dtype == np.float64:
        return array
    return np.array(array, dtype=np.float64, order="C")
