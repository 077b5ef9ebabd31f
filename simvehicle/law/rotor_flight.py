"""The flight core of vehicles on rotors: guidance → outer loop → differentiators → inner loop → allocation → wind →
rotors → estimate → energy (docs/model.md#rotors).

A vehicle is one row: what the law knows, laid out as in step.py, and behind it the body as rotors.py has it, the wind
there, and the errors of what the law knows. The law is the same as on the paper's plant; its angular accelerations
become moments, its thrust and those four rotor speeds. Random numbers are arguments.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from simvehicle.kernels import UNCOUNTED, inner, kernel
from simvehicle.law import controller, dynamics, guidance, power, step
from simvehicle.law.params import P_AVIONICS_W, P_DRAG, P_GRAVITY, P_HOVER_W, Airframe, VehicleParams
from simvehicle.law.step import CONTACT, DRAWN_J, REMAINING_J, STATE_SIZE
from simvehicle.world import airframes, estimate, rotors, wind
from simvehicle.world import power as rotor_power
from simvehicle.world.airframes import A_HOVER_W, A_MASS, A_THRUST, GRAVITY_M_S2, SEA_LEVEL_KG_M3, RotorAirframe
from simvehicle.world.estimate import ERROR_SIZE, EstimateErrors
from simvehicle.world.rotors import B_POSITION, B_QUATERNION, B_RATES, B_ROTORS, B_VELOCITY, BODY_SIZE, SCRATCH_SIZE
from simvehicle.world.wind import GUST_NOISE, GUST_SIZE

Row = NDArray[np.float64]

BODY = slice(STATE_SIZE, STATE_SIZE + BODY_SIZE)
GUST = slice(BODY.stop, BODY.stop + GUST_SIZE)  # memory of the turbulence
WIND = slice(GUST.stop, GUST.stop + 3)  # m/s, nwu
ERROR = slice(WIND.stop, WIND.stop + ERROR_SIZE)  # of what the law knows
VOLTAGE_V, CURRENT_A = ERROR.stop, ERROR.stop + 1
CAPACITY_J = ERROR.stop + 2
OBSERVER = slice(ERROR.stop + 3, ERROR.stop + 9)  # velocity as foreseen, m/s; disturbance, m/s²
ROTOR_STATE_SIZE = OBSERVER.stop
TRUE_POSITION = slice(BODY.start + B_POSITION, BODY.start + B_POSITION + 3)
TRUE_VELOCITY = slice(BODY.start + B_VELOCITY, BODY.start + B_VELOCITY + 3)
TRUE_QUATERNION = slice(BODY.start + B_QUATERNION, BODY.start + B_QUATERNION + 4)
BODY_RATES = slice(BODY.start + B_RATES, BODY.start + B_RATES + 3)
ROTOR_SPEEDS = slice(BODY.start + B_ROTORS, BODY.start + B_ROTORS + 4)
# Weather of a vehicle, and how well it knows its motion.
W_MEAN = slice(0, 3)  # m/s, nwu
W_ALONG = slice(3, 5)  # unit vector of the mean wind, north and west
W_20 = 5  # m/s at 20 ft, which sets the turbulence
W_DEVIATION = slice(6, 10)  # of the estimate: position, velocity, angles, rates
W_TIME_S = slice(10, 14)
W_OHM = 14  # inner resistance of the battery
WEATHER_SIZE = 15
NOISE_SIZE = GUST_NOISE + ERROR_SIZE
"""Normal numbers that a step takes: the wind's, then the estimate's."""
_ANGLE, _RATE = step.ATTITUDE.start, step.RATES.start
_LEAST_COSINE = 1e-6
_OBSERVER = OBSERVER.start
_OBSERVER_1_S = 1.5  # both poles of the disturbance observer
_STRONGEST_M_S2 = 6.0  # disturbance that it believes
_BODY, _BODY_END = BODY.start, BODY.stop
_GUST, _GUST_END, _WIND, _WIND_END = GUST.start, GUST.stop, WIND.start, WIND.stop
_ERROR, _ERROR_END = ERROR.start, ERROR.stop
_W_ALONG, _W_DEVIATION, _W_TIME_S = W_ALONG.start, W_DEVIATION.start, W_TIME_S.start
_GUIDE, _YAW, _LINEAR = step.GUIDE.start, step.GUIDE_YAW.start, step.LINEAR.start
_GUIDE_END, _YAW_END, _LINEAR_END = step.GUIDE.stop, step.GUIDE_YAW.stop, step.LINEAR.stop
_REF_V, _REF_A = step.REFERENCE_VELOCITY.start, step.REFERENCE_ACCELERATION.start


@inner(**UNCOUNTED)
def _see(s: Row, body: Row, error: Row) -> None:
    """Write what the law knows of its motion: the body's, its attitude as Euler angles with their rates, and errors.
    Standing, it knows that it stands, and how."""
    roll, pitch, yaw = rotors.euler_of(body[B_QUATERNION : B_QUATERNION + 4])
    p, q, r = body[B_RATES], body[B_RATES + 1], body[B_RATES + 2]
    sin_roll, cos_roll = np.sin(roll), np.cos(roll)
    yaw_rate = (q * sin_roll + r * cos_roll) / max(np.cos(pitch), _LEAST_COSINE)
    for i in range(6):
        s[i] = body[i]
    s[_ANGLE], s[_ANGLE + 1], s[_ANGLE + 2] = roll, pitch, yaw
    s[_RATE] = p + yaw_rate * np.sin(pitch)
    s[_RATE + 1] = q * cos_roll - r * sin_roll
    s[_RATE + 2] = yaw_rate
    for i in range(3 if s[CONTACT] != 0.0 else ERROR_SIZE):
        s[i] += error[i]
    s[_ANGLE + 2] = dynamics.wrap_angle(s[_ANGLE + 2])


@inner(**UNCOUNTED)
def _observe(s: Row, p: Row, u1: float, dt: float) -> None:
    """Disturbance observer (docs/model.md#rotors) [choice]: v̂' = u1 e - g - (K/m) v + d̂ + 2ω (v - v̂), d̂' = ω² (v - v̂),
    with e the direction of thrust. Standing or falling it believes in none."""
    ex, ey, ez = dynamics.thrust_direction(s[_ANGLE], s[_ANGLE + 1], s[_ANGLE + 2])
    pushed = (u1 * ex, u1 * ey, u1 * ez - p[P_GRAVITY])
    for i in range(3):
        v = s[3 + i]
        if s[CONTACT] != 0.0 or u1 == 0.0:
            s[_OBSERVER + i], s[_OBSERVER + 3 + i] = v, 0.0
            continue
        missed = v - s[_OBSERVER + i]
        foreseen = pushed[i] - p[P_DRAG] * v + s[_OBSERVER + 3 + i] + 2.0 * _OBSERVER_1_S * missed
        s[_OBSERVER + i] += dt * foreseen
        believed = s[_OBSERVER + 3 + i] + dt * _OBSERVER_1_S * _OBSERVER_1_S * missed
        s[_OBSERVER + 3 + i] = controller.bounded(believed, _STRONGEST_M_S2)


@inner(**UNCOUNTED)
def _blow(s: Row, body: Row, w: Row, gusts: Row, noise: Row, t: float, dt: float) -> None:
    """Write the wind of the step that begins at t."""
    now = s[_WIND:_WIND_END]
    x, y, z = wind.discrete(gusts, t)
    if w[W_20] > 0.0:
        dx, dy, dz = body[3] - now[0], body[4] - now[1], body[5] - now[2]
        air_speed = np.sqrt(dx * dx + dy * dy + dz * dz)
        along, left, up = wind.turbulence(s[_GUST:_GUST_END], noise, body[2], air_speed, w[W_20], dt)
        x += w[_W_ALONG] * along - w[_W_ALONG + 1] * left
        y += w[_W_ALONG + 1] * along + w[_W_ALONG] * left
        z += up
    now[0], now[1], now[2] = w[0] + x, w[1] + y, w[2] + z


@inner(**UNCOUNTED)
def _draw(s: Row, body: Row, p: Row, a: Row, w: Row, dt: float) -> float:
    """Take a step's energy from the battery, at most what is left (docs/model.md#rotor-power); the thrust, N."""
    thrust_n = 0.0
    for i in range(4):
        thrust_n += a[A_THRUST] * body[B_ROTORS + i] * body[B_ROTORS + i]
    q = body[B_QUATERNION : B_QUATERNION + 4]
    ux, uy, uz = rotors.rotated(q, body[3] - s[_WIND], body[4] - s[_WIND + 1], body[5] - s[_WIND + 2], -1.0)
    shaft_w = rotor_power.shaft_power(thrust_n, body[B_ROTORS : B_ROTORS + 4], np.sqrt(ux * ux + uy * uy), uz, a)
    power_w = shaft_w * p[P_HOVER_W] / a[A_HOVER_W] + p[P_AVIONICS_W]
    left_j = max(s[REMAINING_J], 0.0)
    if left_j == 0.0:
        power_w = 0.0
    s[VOLTAGE_V], s[CURRENT_A], taken_w = rotor_power.discharge(power_w, left_j / s[CAPACITY_J], w[W_OHM])
    drawn_j = min(taken_w * dt, left_j)
    s[DRAWN_J] += drawn_j
    s[REMAINING_J] -= drawn_j
    return thrust_n


@inner(**UNCOUNTED)
def _step(
    s: Row, c: Row, p: Row, a: Row, w: Row, gusts: Row, noise: Row, decays: Row, t: float, dt: float, scratch: Row
) -> float:
    """One step from t to t + dt; returns the thrust per mass at its end."""
    guide, yaw, linear = s[_GUIDE:_GUIDE_END], s[_YAW:_YAW_END], s[_LINEAR:_LINEAR_END]
    u1 = tau2 = tau3 = tau4 = 0.0
    body, wanted = s[_BODY:_BODY_END], scratch[SCRATCH_SIZE : SCRATCH_SIZE + 4]
    x, y, stood = body[0], body[1], s[CONTACT] != 0.0
    running = c[step.CMD_MOTORS] != 0.0 and s[REMAINING_J] > 0.0
    if running:
        step.set_reference(s, c, p, guide, linear, t)
        for i in range(3):
            s[_REF_A + i] -= s[_OBSERVER + 3 + i]
        u1, tau2, tau3, tau4 = step.control(s, c, p, yaw, dt)
        step.guide_on(s, c, p, guide, yaw, t, dt)
        mx, my, mz = rotors.moments_of(s[_ANGLE : _ANGLE + 3], s[_RATE : _RATE + 3], tau2, tau3, tau4, a)
        rotors.allocate(a[A_MASS] * u1, mx, my, mz, a, wanted)
    else:
        wanted[:] = 0.0
    _observe(s, p, u1, dt)
    _blow(s, body, w, gusts, noise, t, dt)
    rotors.body_step(body, wanted, s[_WIND:_WIND_END], a, dt, scratch)
    s[CONTACT] = 1.0 if c[step.CMD_GROUND] != 0.0 and rotors.meet_ground(body, x, y, stood) else 0.0
    error = s[_ERROR:_ERROR_END]
    estimate.error_step(error, noise[GUST_NOISE:], w[_W_DEVIATION : _W_DEVIATION + 4], decays)
    _see(s, body, error)
    thrust = _draw(s, body, p, a, w, dt)
    s[step.EFFORT] += power.effort_rate(u1, tau2, tau3, tau4) * dt
    if not running:
        step.start_afresh(s, p, guide, yaw, linear)
    thrust_m_s2: float = thrust / a[A_MASS]
    return thrust_m_s2


def _compiled(build: int) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """The entries that numba keeps on disk, with `build` as a part of their key (see step.py)."""

    @kernel(error_model="numpy")
    def fly(
        states: Row,
        commands: Row,
        parameters: Row,
        frames: Row,
        weathers: Row,
        gusts: Row,
        noise: Row,
        times: Row,
        dt: float,
        thrust: Row,
    ) -> None:
        _ = build
        scratch, decays = np.zeros(SCRATCH_SIZE + 4), np.zeros(4)
        for vehicle in range(states.shape[0]):
            s, c, p, a, w = states[vehicle], commands[vehicle], parameters[vehicle], frames[vehicle], weathers[vehicle]
            for i in range(4):
                decays[i] = np.exp(-dt / w[_W_TIME_S + i])
            linear = s[_LINEAR:_LINEAR_END]
            if linear[guidance.LINEAR_STAMP] != c[step.CMD_TIME_S]:
                linear[guidance.LINEAR_STAMP] = c[step.CMD_TIME_S]
                linear[guidance.LINEAR_SINCE] = times[vehicle]
                for i in range(3):
                    linear[guidance.LINEAR_START + i] = s[_REF_V + i]
            for k in range(thrust.shape[1]):
                t = times[vehicle] + k * dt
                thrust[vehicle, k] = _step(s, c, p, a, w, gusts, noise[vehicle, k], decays, t, dt, scratch)
            if s[step.STARTED] != 0.0:
                step.set_reference(s, c, p, s[_GUIDE:_GUIDE_END], linear, times[vehicle] + thrust.shape[1] * dt)

    @kernel(error_model="numpy")
    def turn(
        s: Row, wanted: Row, p: Row, a: Row, w: Row, gusts: Row, noise: Row, t: float, dt: float, force: Row
    ) -> None:
        _ = build
        body, scratch = s[_BODY:_BODY_END], np.zeros(SCRATCH_SIZE)
        x, y, stood = body[0], body[1], s[CONTACT] != 0.0
        vx, vy, vz = body[B_VELOCITY], body[B_VELOCITY + 1], body[B_VELOCITY + 2]
        for i in range(4):
            if s[REMAINING_J] <= 0.0:
                wanted[i] = 0.0
        _blow(s, body, w, gusts, noise, t, dt)
        rotors.body_step(body, wanted, s[_WIND:_WIND_END], a, dt, scratch)
        s[CONTACT] = 1.0 if rotors.meet_ground(body, x, y, stood) else 0.0
        _see(s, body, scratch[:ERROR_SIZE] * 0.0)
        _draw(s, body, p, a, w, dt)
        fx, fy = (body[B_VELOCITY] - vx) / dt, (body[B_VELOCITY + 1] - vy) / dt
        fz = (body[B_VELOCITY + 2] - vz) / dt + GRAVITY_M_S2
        force[0], force[1], force[2] = rotors.rotated(body[B_QUATERNION : B_QUATERNION + 4], fx, fy, fz, -1.0)

    return fly, turn


def checksum() -> int:
    """Of the files that are compiled into the core, this one among them: as `step.checksum`."""
    files = (__file__, *(str(module.__file__) for module in (airframes, rotors, wind, rotor_power, estimate)))
    return zlib.crc32(b"".join(Path(file).read_bytes() for file in files), step.checksum())


fly_rows, turn_row = _compiled(checksum())
"""fly_rows: (states (n, ROTOR_STATE_SIZE), commands, packed params of `on_rotors`, packed airframes, weathers (n,
WEATHER_SIZE), discrete gusts (m, DISCRETE_SIZE) that blow on all, noise (n, k, NOISE_SIZE), times (n,), dt, thrust
(n, k)), as `step.fly_rows`; the rotors' thrust per mass, m/s², is that after every step.

turn_row: one step of a vehicle that another autopilot flies, over ground, from (state (ROTOR_STATE_SIZE,) of known
motion, rotor speeds (4,) that it wants, packed params, packed airframe, weather, gusts, noise (NOISE_SIZE,), time, dt,
force (3,)); in place and unchecked. What is written last is the specific force about the body's axes, m/s²: all that
acts on it but gravity, per mass."""


def on_rotors(flight: VehicleParams, airframe: RotorAirframe, density_kg_m3: float = SEA_LEVEL_KG_M3) -> VehicleParams:
    """Parameters of the law for an airframe: its gravity and drag, and no more thrust than its rotors have to spare.

    Raises:
        ValueError: in air of this density the rotors cannot lift it.
    """
    share = density_kg_m3 / SEA_LEVEL_KG_M3
    spare = airframes.HEADROOM * share * airframe.greatest_thrust_m_s2
    body = Airframe(
        mass_kg=airframe.mass_kg,
        gravity_m_s2=GRAVITY_M_S2,
        drag_kg_s=airframe.hover_drag_1_s * airframe.mass_kg * share**0.5,
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
    state[TRUE_POSITION], state[TRUE_VELOCITY] = state[step.POSITION], state[step.VELOCITY]
    roll, pitch, yaw = (float(angle) for angle in state[step.ATTITUDE])
    rotors.quaternion_of(roll, pitch, yaw, state[TRUE_QUATERNION])
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
    blow(row, mean_nwu)
    row[W_20] = w20_m_s
    row[W_TIME_S] = 1.0
    if errors is not None:
        row[W_DEVIATION], row[W_TIME_S] = errors.deviations, errors.times_s
    row[W_OHM] = resistance_ohm
    return row


def blow(weather: NDArray[np.float64], mean_nwu: Sequence[float]) -> None:
    """Give a weather (WEATHER_SIZE,), in place, another mean wind, m/s."""
    north, west, _ = weather[W_MEAN] = mean_nwu
    speed = float(np.hypot(north, west))
    weather[W_ALONG] = (north / speed, west / speed) if speed > 0.0 else (1.0, 0.0)


def start_weather(state: NDArray[np.float64], weather: NDArray[np.float64], noise: NDArray[np.float64]) -> None:
    """Give a state (ROTOR_STATE_SIZE,), in place, a wind that has blown for long, and errors that have lasted; noise:
    (NOISE_SIZE,) normal numbers."""
    state[GUST] = wind.start_gust(noise[:GUST_NOISE])
    state[WIND] = weather[W_MEAN]
    state[ERROR] = np.repeat(weather[W_DEVIATION], 3) * noise[GUST_NOISE:]
    known = 3 if state[CONTACT] != 0.0 else ERROR_SIZE
    state[:known] += state[ERROR][:known]
    state[step.ATTITUDE][2] = dynamics.wrap_angle(float(state[step.ATTITUDE][2]))
