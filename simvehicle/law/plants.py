"""The plants that a vehicle may fly on: the paper's, and a rigid body on rotors. Both are flown by the same law.

A plant holds the state of one vehicle as one row. What the law knows stands in it as step.py lays it out; what is true
is the plant's to tell.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import cython
import cython.cimports.simvehicle.law.rotor_flight as compiled_rotor_flight
import cython.cimports.simvehicle.law.rows as layout
import cython.cimports.simvehicle.law.step as compiled_step
import numpy as np
from cython.cimports.libc.string import memcpy
from cython.cimports.simvehicle.law.plants import STEPS_AHEAD
from cython.cimports.simvehicle.law.rotor_flight import NOISE_SIZE
from cython.cimports.simvehicle.world.rotors import airframe_at
from cython.cimports.simvehicle.world.wind import gusts_at
from numpy.typing import NDArray

from simvehicle.law import rotor_flight, rows, step
from simvehicle.law.params import STEP_S, VehicleParams, pack
from simvehicle.world import airframes
from simvehicle.world.description import STILL_AIR, Air, WorldVehicle
from simvehicle.world.power import usual_resistance_ohm
from simvehicle.world.rows import DISCRETE_SIZE, ERROR_SIZE, GUST_NOISE
from skytender.normal import standard_normal

Floats = list[float]
Vec3 = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]


class BodyMotion:
    """Motion of a rigid body: place m and velocity m/s in NED, attitude from the body to NED (w first), rates about the
    body's axes, front, right, down, rad/s."""

    p_ned: Vec3
    v_ned: Vec3
    quaternion: Quaternion
    rates_body: Vec3


class Plant:
    """Plant of one vehicle: the paper's, of its eq. 3 (docs/model/vehicle.md#rigid-body), which others are derived
    from."""

    state: NDArray[np.float64]
    """(1, n)"""
    row: Any
    rotors: Any
    place_deviation_m: float
    """standard deviation of each axis of the place that it knows; 0 where it knows its place exactly"""
    velocity_deviation_m_s: float
    _packed: NDArray[np.float64]
    _parameters: Any

    def __init__(self) -> None:
        self._place(np.zeros((1, rows.STATE_SIZE)))

    def _place(self, state: NDArray[np.float64]) -> None:
        view = cython.declare(cython.double[:, ::1], state)
        self.state = state
        self.row = layout.state_of(view, 0)

    def tune(self, flight: VehicleParams) -> None:
        """Fly with other parameters from the next step on."""
        self._packed = pack(self.parameters(flight))[np.newaxis]
        view = cython.declare(cython.double[:, ::1], self._packed)
        self._parameters = layout.parameters_of(view, 0)

    def parameters(self, flight: VehicleParams) -> VehicleParams:
        """Parameters as they are in force on this plant."""
        return flight

    def full_thrust_m_s2(self, allowed_m_s2: float) -> float:
        """Thrust per mass at full throttle: that which is allowed, since the plant has no limit of its own."""
        return allowed_m_s2

    def start(
        self,
        flight: VehicleParams,
        *,
        position_nwu: Sequence[float],
        velocity_nwu: Sequence[float],
        attitude_rad: Sequence[float],
        airborne: bool,
    ) -> None:
        """Place it before its first step."""
        flight = self.parameters(flight)
        known = step.initial_state(
            flight, position_nwu=position_nwu, velocity_nwu=velocity_nwu, attitude_rad=attitude_rad, airborne=airborne
        )
        self._begin(flight, known, airborne)

    def _begin(self, flight: VehicleParams, known: NDArray[np.float64], airborne: bool) -> None:
        """Make the row of what the law knows at the start, (STATE_SIZE,)."""
        self._place(known[np.newaxis])

    def fly(self, command: Any, time_s: float, steps: int, thrust: Any) -> None:
        """Fly some steps on from a time; thrust per mass after each, m/s², is written (steps,)."""
        compiled_step.fly_row(self.row, command, self._parameters, time_s, STEP_S, steps, thrust)

    @property
    def now(self) -> Floats:
        """Its row as floats."""
        return self.state[0].tolist()

    def stands(self) -> bool:
        """Whether it stands on the ground: at rest at or below its height, as it reports itself."""
        v = self.row.velocity
        return self.row.position[2] <= 0.0 and v[0] == 0.0 and v[1] == 0.0 and v[2] == 0.0

    def true_motion(self, motion: Any) -> None:
        """Write true motion, (12,): position, velocity, Euler angles and their rates, nwu."""
        memcpy(motion, self.row, rows.RATES.stop * cython.sizeof(cython.double))

    @property
    def drawn_j(self) -> float:
        """Drawn from the battery since the start."""
        return self.row.drawn_j

    @property
    def remaining_j(self) -> float:
        """Left in the battery."""
        return self.row.remaining_j

    def waste(self, joules: float) -> None:
        """Lose energy at once, as far as there is any; it counts as drawn."""
        gone_j = min(joules, self.row.remaining_j)
        self.row.drawn_j += gone_j
        self.charge(-gone_j)

    def charge(self, joules: float) -> None:
        """Put energy into the battery, or take it out where negative."""
        self.row.remaining_j += joules


class RotorPlant(Plant):
    """A rigid body on four rotors, in weather (docs/model/vehicle.md#rotors)."""

    own: WorldVehicle
    _air: Air
    _frame: NDArray[np.float64]
    _airframe: Any
    _weather: NDArray[np.float64]
    _here: Any
    _gusts: NDArray[np.float64]
    _gust: Any
    _gust_count: int
    _random: list[np.random.Generator]
    _noise: NDArray[np.float64]
    _noise_rows: Any
    _next: int
    _drawn: int
    _gusty: bool
    _errs: bool

    def __init__(self, own: WorldVehicle, air: Air = STILL_AIR, *, seed: int = 0, sysid: int = 0) -> None:
        """`seed` and `sysid`: of what is random in its wind and in its estimate, each a stream of its own."""
        self._place(np.zeros((1, rows.ROTOR_STATE_SIZE)))
        self.own = own
        self._air = air
        self._frame = airframes.pack(own.airframe, air.density_kg_m3)[np.newaxis]
        self._weather = np.zeros((1, 0))
        self._gusts = np.array(air.gusts_nwu, dtype=np.float64).reshape(-1, DISCRETE_SIZE)
        self._random = [np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(sysid, k))) for k in range(2)]
        self._next = self._drawn = 0
        frame, gusts = cython.declare(cython.double[:, ::1]), cython.declare(cython.double[:, ::1])
        frame, gusts = self._frame, self._gusts
        self._airframe, self._gust, self._gust_count = airframe_at(frame[0]), gusts_at(gusts), gusts.shape[0]
        self._gusty, self._errs = air.turbulence_m_s > 0.0, own.errors is not None
        if own.errors is not None:
            self.place_deviation_m, self.velocity_deviation_m_s = own.errors.position_m, own.errors.velocity_m_s

    def _place(self, state: NDArray[np.float64]) -> None:
        """As every plant."""
        view = cython.declare(cython.double[:, ::1], state)
        self.state = state
        self.rotors = layout.rotors_of(view, 0)
        self.row = cython.address(self.rotors.known)

    def tune(self, flight: VehicleParams) -> None:
        """As every plant; and let its weather and its battery be those of now."""
        Plant.tune(self, flight)
        capacity_j = flight.battery.capacity_j
        ohm = self.own.resistance_ohm
        self._weather = rotor_flight.weather_row(
            mean_nwu=self._air.mean_nwu,
            w20_m_s=self._air.turbulence_m_s,
            errors=self.own.errors,
            resistance_ohm=usual_resistance_ohm(capacity_j) if ohm is None else ohm,
        )[np.newaxis]
        weather = cython.declare(cython.double[:, ::1], self._weather)
        self._here = layout.weather_of(weather, 0)
        self.rotors.capacity_j = capacity_j

    def parameters(self, flight: VehicleParams) -> VehicleParams:
        """As every plant. Raises ValueError where its rotors cannot lift it."""
        return rotor_flight.on_rotors(flight, self.own.airframe, self._air.density_kg_m3)

    def full_thrust_m_s2(self, allowed_m_s2: float) -> float:
        """Thrust per mass at full throttle: of all rotors at their fastest, in its air."""
        return self._air.density_kg_m3 / airframes.SEA_LEVEL_KG_M3 * self.own.airframe.greatest_thrust_m_s2

    def _begin(self, flight: VehicleParams, known: NDArray[np.float64], airborne: bool) -> None:
        """As every plant."""
        self._place(rotor_flight.initial_state(flight, known, self.own.airframe, airborne=airborne)[np.newaxis])
        if self._air.field is not None:
            self._blow()
        self._draw_ahead(1)
        rotor_flight.start_weather(self.state[0], self._weather[0], self._noise[self._next])
        self._next += 1

    def _blow(self) -> None:
        """Let the mean wind of the place blow, where it is not the same everywhere."""
        here = self.state[0, rows.TRUE_POSITION].tolist()
        rotor_flight.set_mean_wind(self._weather[0], self._air.mean_at_nwu(here))

    def _draw_ahead(self, steps: int) -> None:
        """Have normal numbers (steps, NOISE_SIZE) from row `_next` on: the same however a flight is cut into
        stretches."""
        missing = self._next + steps - self._drawn
        if missing <= 0:
            return
        more = np.zeros((max(missing, STEPS_AHEAD), NOISE_SIZE))
        if self._gusty:
            more[:, :GUST_NOISE] = standard_normal(self._random[0], len(more), GUST_NOISE)
        if self._errs:
            more[:, GUST_NOISE:] = standard_normal(self._random[1], len(more), ERROR_SIZE)
        self._noise = np.concatenate([self._noise[self._next :], more]) if self._drawn else more
        view = cython.declare(cython.double[:, ::1], self._noise)
        self._noise_rows, self._next, self._drawn = cython.address(view[0, 0]), 0, view.shape[0]

    def fly(self, command: Any, time_s: float, steps: int, thrust: Any) -> None:
        """As every plant. A wind by place is that of the stretch's beginning."""
        if self._air.field is not None:
            self._blow()
        self._draw_ahead(steps)
        compiled_rotor_flight.fly_row(
            self.rotors, command, self._parameters, self._airframe, self._here, self._gust, self._gust_count,
            self._noise_rows + NOISE_SIZE * self._next, time_s, STEP_S, steps, thrust,
        )  # fmt: skip
        self._next += steps

    def turn(self, wanted_rad_s: tuple[float, ...], time_s: float, dt_s: float) -> Vec3:
        """One step by the rotor speeds (4,) that another autopilot wants; it knows its motion exactly. The specific
        force about the body's axes after it, (3,), front, right, down, m/s²."""
        wanted, force = cython.declare(cython.double[4]), cython.declare(cython.double[3])
        wanted[0], wanted[1], wanted[2], wanted[3] = wanted_rad_s
        if self._air.field is not None:
            self._blow()
        self._draw_ahead(1)
        compiled_rotor_flight.turn_row(
            self.rotors, wanted, self._parameters, self._airframe, self._here, self._gust, self._gust_count,
            self._noise_rows + NOISE_SIZE * self._next, time_s, dt_s, force,
        )  # fmt: skip
        self._next += 1
        return force[0], -force[1], -force[2]

    def body(self) -> BodyMotion:
        """True motion of its body."""
        body = cython.address(self.rotors.body)
        p, v, q, r = body.position, body.velocity, body.quaternion, body.rates
        motion = BodyMotion.__new__(BodyMotion)
        motion.p_ned, motion.v_ned = (p[0], -p[1], -p[2]), (v[0], -v[1], -v[2])
        motion.quaternion, motion.rates_body = (q[0], q[1], -q[2], -q[3]), (r[0], -r[1], -r[2])
        return motion

    def true_motion(self, motion: Any) -> None:
        """As every plant."""
        Plant.true_motion(self, motion)
        if self._errs:
            for i in range(3 if self.stands() else ERROR_SIZE):
                motion[i] -= self.rotors.error[i]

    def stands(self) -> bool:
        """As every plant."""
        return self.row.contact != 0.0

    @property
    def electric(self) -> tuple[float, float]:
        """Voltage in V and current in A at the battery."""
        return self.rotors.voltage_v, self.rotors.current_a
