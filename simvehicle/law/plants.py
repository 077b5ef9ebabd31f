"""The plants that a vehicle may fly on: the paper's, and a rigid body on rotors. Both are flown by the same law.

A plant holds the state of one vehicle as one row. What the law knows stands in it as step.py lays it out; what is true
is the plant's to tell.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from simvehicle.law import rotor_flight, rows, step
from simvehicle.law.params import STEP_S, VehicleParams, pack
from simvehicle.world import airframes
from simvehicle.world.description import STILL_AIR, Air, WorldVehicle
from simvehicle.world.power import usual_resistance_ohm
from simvehicle.world.rows import DISCRETE_SIZE, ERROR_SIZE, GUST_NOISE
from skytender.normal import standard_normal

Floats = list[float]


class Plant:
    """Plant of one vehicle: the paper's, of its eq. 3 (docs/model.md#rigid-body), which others are derived from.

    `state` is its row, (1, n); `now` the same as plain floats.
    """

    def __init__(self) -> None:
        self.state = np.zeros((1, rows.STATE_SIZE))
        self.now: Floats = []
        self._packed = np.zeros((1, 0))
        self._time_s = np.zeros(1)

    def tune(self, flight: VehicleParams) -> None:
        """Fly with other parameters from the next step on."""
        self._packed = pack(self.parameters(flight))[np.newaxis]

    def parameters(self, flight: VehicleParams) -> VehicleParams:
        """Parameters as they are in force on this plant."""
        return flight

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
        self._begin(flight, known, airborne=airborne)
        self.now = self.state[0].tolist()

    def _begin(self, flight: VehicleParams, known: NDArray[np.float64], *, airborne: bool) -> None:
        """Make the row of what the law knows at the start, (STATE_SIZE,)."""
        self.state = known[np.newaxis]

    def advance(self, command: NDArray[np.float64], *, time_s: float, steps: int) -> NDArray[np.float64]:
        """Fly some steps on; thrust per mass (1, steps), m/s²."""
        flown, thrust = self.state.copy(), np.empty((1, steps))
        self._time_s[0] = time_s
        self._fly(flown, command, thrust)
        self.state = flown
        self.now = self.state[0].tolist()
        return thrust

    def go_on_from(self, flown: NDArray[np.float64]) -> None:
        """Be where another has flown it to: its row, (n,)."""
        self.state = flown[np.newaxis].copy()
        self.now = flown.tolist()

    @property
    def packed(self) -> NDArray[np.float64]:
        """Parameters in force, (1, PARAMS_SIZE)."""
        return self._packed

    def _fly(self, flown: NDArray[np.float64], command: NDArray[np.float64], thrust: NDArray[np.float64]) -> None:
        """Fly a copy of the row on in place, and write the thrust of each step."""
        step.fly_rows(flown, command, self._packed, self._time_s, STEP_S, thrust)

    @property
    def motion(self) -> Floats:
        """True motion: position, velocity, Euler angles and their rates, nwu."""
        return self.now

    @property
    def standing(self) -> bool:
        """Whether it stands on the ground: at rest at or below its height, as it reports itself."""
        return self.now[rows.POSITION][2] <= 0.0 and self.now[rows.VELOCITY] == [0.0, 0.0, 0.0]

    @property
    def electric(self) -> tuple[float, float] | None:
        """Voltage in V and current in A at the battery; None where the plant has none."""
        return None

    @property
    def drawn_j(self) -> float:
        """Drawn from the battery since the start."""
        return self.now[rows.DRAWN_J]

    @property
    def remaining_j(self) -> float:
        """Left in the battery."""
        return self.now[rows.REMAINING_J]

    def waste(self, joules: float) -> None:
        """Lose energy at once, as far as there is any; it counts as drawn."""
        gone_j = min(joules, self.remaining_j)
        self.state[0, rows.DRAWN_J] += gone_j
        self.charge(-gone_j)

    def charge(self, joules: float) -> None:
        """Put energy into the battery, or take it out where negative."""
        self.state[0, rows.REMAINING_J] += joules
        self.now = self.state[0].tolist()


_NO_NOISE = np.zeros(rotor_flight.NOISE_SIZE)


class RotorPlant(Plant):
    """A rigid body on four rotors, in weather (docs/model.md#rotors)."""

    def __init__(self, own: WorldVehicle, air: Air = STILL_AIR, *, seed: int = 0, sysid: int = 0) -> None:
        """`seed` and `sysid`: of what is random in its wind and in its estimate, each a stream of its own."""
        super().__init__()
        self.own = own
        self._air = air
        self.state = np.zeros((1, rows.ROTOR_STATE_SIZE))
        self._frame = airframes.pack(own.airframe, air.density_kg_m3)[np.newaxis]
        self._weather = np.zeros((1, 0))
        self._gusts = np.array(air.gusts_nwu, dtype=np.float64).reshape(-1, DISCRETE_SIZE)
        self._wanted, self._force = np.zeros(airframes.ROTORS), np.zeros(3)
        self._random = [np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(sysid, k))) for k in range(2)]
        self._drawn = np.zeros((1, 0, rotor_flight.NOISE_SIZE))

    def tune(self, flight: VehicleParams) -> None:
        """As every plant; and let its weather and its battery be those of now."""
        super().tune(flight)
        capacity_j = flight.battery.capacity_j
        ohm = self.own.resistance_ohm
        self._weather = rotor_flight.weather_row(
            mean_nwu=self._air.mean_nwu,
            w20_m_s=self._air.turbulence_m_s,
            errors=self.own.errors,
            resistance_ohm=usual_resistance_ohm(capacity_j) if ohm is None else ohm,
        )[np.newaxis]
        self.state[0, rows.CAPACITY_J] = capacity_j

    def parameters(self, flight: VehicleParams) -> VehicleParams:
        """As every plant. Raises ValueError where its rotors cannot lift it."""
        return rotor_flight.on_rotors(flight, self.own.airframe, self._air.density_kg_m3)

    def _begin(self, flight: VehicleParams, known: NDArray[np.float64], *, airborne: bool) -> None:
        self.state = rotor_flight.initial_state(flight, known, self.own.airframe, airborne=airborne)[np.newaxis]
        self._blow()
        rotor_flight.start_weather(self.state[0], self._weather[0], self._noise(1)[0, 0])

    def _blow(self) -> None:
        """Let the mean wind of the place blow, where it is not the same everywhere."""
        if self._air.field is not None:
            here = self.state[0, rows.TRUE_POSITION].tolist()
            rotor_flight.set_mean_wind(self._weather[0], self._air.mean_at_nwu(here))

    def _fly(self, flown: NDArray[np.float64], command: NDArray[np.float64], thrust: NDArray[np.float64]) -> None:
        """As every plant. A wind by place is that of the stretch's beginning."""
        self._blow()
        rows = command, self._packed, self._frame, self._weather, self._gusts, self._noise(thrust.shape[1])
        rotor_flight.fly_rows(flown, *rows, self._time_s, STEP_S, thrust)

    def turn(self, wanted_rad_s: Sequence[float], *, time_s: float, dt_s: float) -> Floats:
        """One step by the rotor speeds (4,) that another autopilot wants; it knows its motion exactly. The specific
        force about the body's axes after it, (3,), nwu, m/s²."""
        if self._air.field is not None:
            self._blow()
        state, wanted, force = self.state[0], self._wanted, self._force
        wanted[0], wanted[1], wanted[2], wanted[3] = wanted_rad_s
        noise = self._noise(1)[0, 0] if self._air.turbulence_m_s > 0.0 else _NO_NOISE
        rows = self._packed[0], self._frame[0], self._weather[0], self._gusts
        rotor_flight.turn_row(state, wanted, *rows, noise, time_s, dt_s, force)
        self.now = state.tolist()
        return force.tolist()

    @property
    def still(self) -> bool:
        """Whether nothing random moves it or its estimate: its noise is 0."""
        return not self._air.turbulence_m_s > 0.0 and self.own.errors is None

    @property
    def surroundings(self) -> tuple[NDArray[np.float64], ...] | None:
        """Its packed airframe (1, k), weather (1, WEATHER_SIZE), and the discrete gusts; None where the mean wind is
        another at every place."""
        return None if self._air.field is not None else (self._frame, self._weather, self._gusts)

    def noise_ahead(self, steps: int) -> NDArray[np.float64]:
        """Normal numbers of the next steps, (1, steps, NOISE_SIZE), which are still to be flown: the same however a
        flight is cut into stretches."""
        if (missing := steps - self._drawn.shape[1]) > 0:
            more = np.zeros((1, missing, rotor_flight.NOISE_SIZE))
            if self._air.turbulence_m_s > 0.0:
                more[0, :, :GUST_NOISE] = standard_normal(self._random[0], missing, GUST_NOISE)
            if self.own.errors is not None:
                more[0, :, GUST_NOISE:] = standard_normal(self._random[1], missing, ERROR_SIZE)
            self._drawn = np.concatenate([self._drawn, more], axis=1)
        return self._drawn[:, :steps]

    def leave_behind(self, steps: int) -> None:
        """Numbers of so many steps have been flown."""
        self._drawn = self._drawn[:, steps:]

    def _noise(self, steps: int) -> NDArray[np.float64]:
        """Normal numbers of some steps that are flown now, (1, steps, NOISE_SIZE)."""
        noise = self.noise_ahead(steps)
        self.leave_behind(steps)
        return noise

    @property
    def motion(self) -> Floats:
        """As every plant."""
        now = self.now
        if self.own.errors is None:
            return now
        known = 3 if self.standing else ERROR_SIZE
        return [x - e for x, e in zip(now[:known], now[rows.ERROR], strict=False)] + now[known:ERROR_SIZE]

    @property
    def standing(self) -> bool:
        """As every plant."""
        return self.now[rows.CONTACT] != 0.0

    @property
    def electric(self) -> tuple[float, float]:
        """Voltage in V and current in A at the battery."""
        return self.now[rows.VOLTAGE_V], self.now[rows.CURRENT_A]
