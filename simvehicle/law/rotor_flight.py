"""The flight core of vehicles on rotors: guidance → outer loop → differentiators → inner loop → allocation → wind →
rotors → estimate → energy (docs/model/vehicle.md#rotors).

A vehicle is one row: what the law knows, laid out as in step.py, and behind it the body as rotors.py has it, the wind
there, and the errors of what the law knows. The law is the same as on the paper's plant; its angular accelerations
become moments, its thrust and those four rotor speeds. Random numbers are arguments.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import cython
import cython.cimports.simvehicle.law.dynamics as dynamics
import cython.cimports.simvehicle.law.power as power
import cython.cimports.simvehicle.law.step as step
import cython.cimports.simvehicle.world.power as rotor_power
import cython.cimports.simvehicle.world.rotors as rotors
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.simvehicle.law.arithmetic import bounded
from cython.cimports.simvehicle.law.rotor_flight import NOISE_SIZE
from cython.cimports.simvehicle.world.error_step import step_errors
from cython.cimports.simvehicle.world.rows import ERROR_SIZE, GUST_NOISE
from cython.cimports.simvehicle.world.wind import blow, discrete_of
from numpy.typing import NDArray

from simvehicle.law.params import Airframe, VehicleParams
from simvehicle.law.rows import (
    ATTITUDE,
    CAPACITY_J,
    CONTACT,
    ERROR,
    GUST,
    POSITION,
    ROTOR_SPEEDS,
    ROTOR_STATE_SIZE,
    STATE_SIZE,
    TRUE_POSITION,
    TRUE_QUATERNION,
    TRUE_VELOCITY,
    VELOCITY,
    VOLTAGE_V,
    WIND,
)
from simvehicle.world import airframes
from simvehicle.world.airframes import SEA_LEVEL_KG_M3, RotorAirframe
from simvehicle.world.estimate import EstimateErrors
from simvehicle.world.rotors import quaternion
from simvehicle.world.rows import WEATHER, WEATHER_SIZE
from simvehicle.world.wind import start_gust

_GRAVITY_M_S2 = airframes.GRAVITY_M_S2
_LEAST_COSINE = 1e-6
_OBSERVER_1_S = 1.5  # both poles of the disturbance observer
_STRONGEST_M_S2 = 6.0  # disturbance that it believes


def _see(s: Any, error: Any) -> None:
    """Write what the law knows of its motion: the body's, its attitude as Euler angles with their rates, and errors.
    Standing, it knows that it stands, and how."""
    body, known = cython.address(s.body), cython.address(s.known)
    roll, pitch, yaw = rotors.euler_of(body.quaternion)
    p, q, r = body.rates[0], body.rates[1], body.rates[2]
    sin_roll, cos_roll = elementary.sin_cos(roll)
    sin_pitch, cos_pitch = elementary.sin_cos(pitch)
    yaw_rate = (q * sin_roll + r * cos_roll) / max(cos_pitch, _LEAST_COSINE)
    for i in range(3):
        known.position[i], known.velocity[i] = body.position[i], body.velocity[i]
    known.attitude[0], known.attitude[1], known.attitude[2] = roll, pitch, yaw
    known.rates[0] = p + yaw_rate * sin_pitch
    known.rates[1] = q * cos_roll - r * sin_roll
    known.rates[2] = yaw_rate
    motion = cython.cast(cython.p_double, known)
    for i in range(3 if known.contact != 0.0 else ERROR_SIZE):
        motion[i] += error[i]
    known.attitude[2] = dynamics.wrap_angle(known.attitude[2])


def _observe(s: Any, p: Any, u1: float, dt: float) -> None:
    """Disturbance observer (docs/model/vehicle.md#rotors) [choice]: v̂' = u1 e - g - (K/m) v + d̂ + 2ω (v - v̂), d̂' =
    ω² (v - v̂), with e the direction of thrust. Standing or falling it believes in none."""
    angles = s.known.attitude
    pushed = cython.declare(cython.double[3])
    ex, ey, ez = dynamics.thrust_direction(angles[0], angles[1], angles[2])
    pushed[0], pushed[1], pushed[2] = u1 * ex, u1 * ey, u1 * ez - p.gravity
    for i in range(3):
        v = s.known.velocity[i]
        if s.known.contact != 0.0 or u1 == 0.0:
            s.foreseen[i], s.disturbance[i] = v, 0.0
            continue
        missed = v - s.foreseen[i]
        foreseen = pushed[i] - p.drag * v + s.disturbance[i] + 2.0 * _OBSERVER_1_S * missed
        s.foreseen[i] += dt * foreseen
        believed = s.disturbance[i] + dt * _OBSERVER_1_S * _OBSERVER_1_S * missed
        s.disturbance[i] = bounded(believed, _STRONGEST_M_S2)


def _blow(s: Any, w: Any, gusts: Any, count: int, noise: Any, t: float, dt: float) -> None:
    """Write the wind of the step that begins at t."""
    now, v = s.wind, s.body.velocity
    x, y, z = discrete_of(gusts, count, t)
    if w.w20 > 0.0:
        dx, dy, dz = v[0] - now[0], v[1] - now[1], v[2] - now[2]
        air_speed = math.sqrt(dx * dx + dy * dy + dz * dz)
        along, left, up = blow(s.gust, noise, s.body.position[2], air_speed, w.w20, dt)
        x += w.along[0] * along - w.along[1] * left
        y += w.along[1] * along + w.along[0] * left
        z += up
    now[0], now[1], now[2] = w.mean[0] + x, w.mean[1] + y, w.mean[2] + z


def _draw(s: Any, p: Any, a: Any, w: Any, dt: float) -> float:
    """Take a step's energy from the battery, at most what is left (docs/model/vehicle.md#rotor-power); the thrust,
    N."""
    body, wind, thrust_n = cython.address(s.body), s.wind, 0.0
    for i in range(4):
        thrust_n += a.thrust * body.rotors[i] * body.rotors[i]
    v = body.velocity
    ux, uy, uz = rotors.rotated(body.quaternion, v[0] - wind[0], v[1] - wind[1], v[2] - wind[2], -1.0)
    shaft_w = rotor_power.rotor_power(thrust_n, body.rotors, math.sqrt(ux * ux + uy * uy), uz, a)
    power_w = shaft_w * p.hover_w / a.hover_w + p.avionics_w
    left_j = max(s.known.remaining_j, 0.0)
    if left_j == 0.0:
        power_w = 0.0
    s.voltage_v, s.current_a, taken_w = rotor_power.discharge(power_w, left_j / s.capacity_j, w.ohm)
    drawn_j = min(taken_w * dt, left_j)
    s.known.drawn_j += drawn_j
    s.known.remaining_j -= drawn_j
    return thrust_n


def _step(
    s: Any, c: Any, p: Any, a: Any, w: Any, gusts: Any, count: int, noise: Any, decays: Any, spin: tuple[float, float],
    t: float, dt: float,
) -> float:  # fmt: skip
    """One step from t to t + dt; returns the thrust per mass at its end."""
    known, body = cython.address(s.known), cython.address(s.body)
    wanted = cython.declare(cython.double[4])
    u1 = tau2 = tau3 = tau4 = 0.0
    x, y, stood = body.position[0], body.position[1], known.contact != 0.0
    running = c.motors != 0.0 and known.remaining_j > 0.0
    if running:
        step.set_reference(known, c, p, t)
        for i in range(3):
            known.reference_acceleration[i] -= s.disturbance[i]
        u1, tau2, tau3, tau4 = step.control(known, c, p, dt)
        step.guide_on(known, c, p, t, dt)
        mx, my, mz = rotors.moments_of(known.attitude, known.rates, tau2, tau3, tau4, a)
        rotors.allocate(a.mass * u1, mx, my, mz, a, wanted)
    else:
        for i in range(4):
            wanted[i] = 0.0
    _observe(s, p, u1, dt)
    _blow(s, w, gusts, count, noise, t, dt)
    rotors.step_body(body, wanted, s.wind, a, spin, dt)
    known.contact = 1.0 if c.ground != 0.0 and rotors.land_body(body, x, y, stood) else 0.0
    step_errors(s.error, noise + GUST_NOISE, w.deviation, decays)
    _see(s, s.error)
    thrust = _draw(s, p, a, w, dt)
    known.effort += power.effort_rate(u1, tau2, tau3, tau4) * dt
    if not running:
        step.start_afresh(known, p)
    return thrust / a.mass


def fly_row(
    s: Any, c: Any, p: Any, a: Any, w: Any, gusts: Any, count: int, noise: Any, t: float, dt: float, steps: int,
    thrust: Any,
) -> None:  # fmt: skip
    """Fly a vehicle some steps on from t, whose noise is (steps, NOISE_SIZE); the thrust per mass after each is
    written."""
    decays = cython.declare(cython.double[4])
    for i in range(4):
        decays[i] = elementary.exp(-dt / w.time_s[i])
    spin = rotors.spin_up(a, dt)
    known = cython.address(s.known)
    step.take_command(known, c, t)
    for k in range(steps):
        thrust[k] = _step(s, c, p, a, w, gusts, count, noise + k * NOISE_SIZE, decays, spin, t + k * dt, dt)
    if known.started != 0.0:
        step.set_reference(known, c, p, t + steps * dt)


def turn_row(
    s: Any, wanted: Any, p: Any, a: Any, w: Any, gusts: Any, count: int, noise: Any, t: float, dt: float, force: Any
) -> None:
    """One step of a vehicle that another autopilot flies, over ground; in place and unchecked.

    Args:
        s: state, of known motion.
        wanted: rotor speeds (4,), rad/s, that it wants; written where its battery is empty.
        p, a, w, gusts, count: as `fly_row` has them.
        noise: (NOISE_SIZE,).
        t, dt: time and step, s.
        force: (3,), written: the specific force about the body's axes, m/s²: all that acts on it but gravity, per mass.
    """
    body, known = cython.address(s.body), cython.address(s.known)
    x, y, stood = body.position[0], body.position[1], known.contact != 0.0
    vx, vy, vz = body.velocity[0], body.velocity[1], body.velocity[2]
    for i in range(4):
        if known.remaining_j <= 0.0:
            wanted[i] = 0.0
    none = cython.declare(cython.double[ERROR_SIZE])
    for i in range(ERROR_SIZE):
        none[i] = 0.0
    _blow(s, w, gusts, count, noise, t, dt)
    rotors.step_body(body, wanted, s.wind, a, rotors.spin_up(a, dt), dt)
    known.contact = 1.0 if rotors.land_body(body, x, y, stood) else 0.0
    _see(s, none)
    _draw(s, p, a, w, dt)
    fx, fy = (body.velocity[0] - vx) / dt, (body.velocity[1] - vy) / dt
    fz = (body.velocity[2] - vz) / dt + _GRAVITY_M_S2
    force[0], force[1], force[2] = rotors.rotated(body.quaternion, fx, fy, fz, -1.0)


def on_rotors(flight: VehicleParams, airframe: RotorAirframe, density_kg_m3: float = SEA_LEVEL_KG_M3) -> VehicleParams:
    """Parameters of the law for an airframe: its gravity and drag, and no more thrust than its rotors have to spare.

    Raises:
        ValueError: in air of this density the rotors cannot lift it.
    """
    share = density_kg_m3 / SEA_LEVEL_KG_M3
    spare = airframes.HEADROOM * share * airframe.greatest_thrust_m_s2
    body = Airframe(
        mass_kg=airframe.mass_kg,
        gravity_m_s2=_GRAVITY_M_S2,
        drag_kg_s=airframe.hover_drag_1_s * airframe.mass_kg * math.sqrt(share),
        rotational_drag=0.0,
    )
    limits = replace(flight.limits, thrust_m_s2=min(flight.limits.thrust_m_s2, spare))
    return replace(flight, airframe=body, limits=limits)


def initial_state(
    flight: VehicleParams, known: NDArray[np.float64], airframe: RotorAirframe, *, airborne: bool
) -> NDArray[np.float64]:
    """State before the first step, (ROTOR_STATE_SIZE,), with what the law knows by `step.initial_state`; rotors turn
    where it is airborne."""
    state = np.zeros(ROTOR_STATE_SIZE)
    state[:STATE_SIZE] = known
    state[TRUE_POSITION], state[TRUE_VELOCITY] = state[POSITION], state[VELOCITY]
    roll, pitch, yaw = (float(angle) for angle in state[ATTITUDE])
    state[TRUE_QUATERNION] = quaternion(roll, pitch, yaw)
    state[ROTOR_SPEEDS] = airframe.hover_rad_s if airborne else 0.0
    state[CAPACITY_J] = flight.battery.capacity_j
    state[VOLTAGE_V] = rotor_power.CELLS * rotor_power.cell_v(flight.battery.initial_j / flight.battery.capacity_j)
    return state


def weather_row(
    *, mean_nwu: Sequence[float], w20_m_s: float, errors: EstimateErrors | None, resistance_ohm: float
) -> NDArray[np.float64]:
    """Weather of one vehicle (WEATHER_SIZE,): mean wind, m/s; the wind at 20 ft that sets the turbulence, none with 0;
    errors of its estimate, none without; its battery's resistance. Turbulence lies along the mean wind, else north."""
    row = np.zeros(WEATHER_SIZE)
    set_mean_wind(row, mean_nwu)
    row[WEATHER["w20"]] = w20_m_s
    row[WEATHER["time_s"]] = 1.0
    if errors is not None:
        row[WEATHER["deviation"]], row[WEATHER["time_s"]] = errors.deviations, errors.times_s
    row[WEATHER["ohm"]] = resistance_ohm
    return row


def set_mean_wind(weather: NDArray[np.float64], mean_nwu: Sequence[float]) -> None:
    """Give a weather (WEATHER_SIZE,), in place, another mean wind, m/s."""
    north, west, _ = weather[WEATHER["mean"]] = mean_nwu
    speed = math.sqrt(north * north + west * west)
    weather[WEATHER["along"]] = (north / speed, west / speed) if speed > 0.0 else (1.0, 0.0)


def start_weather(state: NDArray[np.float64], weather: NDArray[np.float64], noise: NDArray[np.float64]) -> None:
    """Give a state (ROTOR_STATE_SIZE,), in place, a wind that has blown for long, and errors that have lasted; noise:
    (NOISE_SIZE,) normal numbers."""
    state[GUST] = start_gust(noise[:GUST_NOISE])
    state[WIND] = weather[WEATHER["mean"]]
    state[ERROR] = np.repeat(weather[WEATHER["deviation"]], 3) * noise[GUST_NOISE:]
    known = 3 if state[CONTACT] != 0.0 else ERROR_SIZE
    state[:known] += state[ERROR][:known]
    state[ATTITUDE][2] = dynamics.wrap_angle(float(state[ATTITUDE][2]))
