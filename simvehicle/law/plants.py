"""The plants that a vehicle may fly on: the paper's, and a rigid body on rotors. Both are flown by the same law.

A plant holds the state of one vehicle as one row. What the law knows stands in it as step.py lays it out; what is true
is the plant's to tell.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from simvehicle.law import rotor_flight, step
from simvehicle.law.params import VehicleParams, pack
from simvehicle.world import airframes
from simvehicle.world.airframes import RotorAirframe

Floats = list[float]


class Plant(Protocol):
    """Plant of one vehicle. `state` is its row, (1, n); `now` the same as plain floats."""

    state: NDArray[np.float64]
    now: Floats

    def tune(self, flight: VehicleParams) -> None:
        """Fly with other parameters from the next step on."""

    def parameters(self, flight: VehicleParams) -> VehicleParams:
        """Parameters as they are in force on this plant."""

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

    def advance(self, command: NDArray[np.float64], *, time_s: float, steps: int) -> NDArray[np.float64]:
        """Fly some steps on; thrust per mass (1, steps), m/s²."""

    @property
    def motion(self) -> Floats:
        """True motion: position, velocity, Euler angles and their rates, nwu."""

    @property
    def standing(self) -> bool:
        """Whether it stands on the ground."""


class PaperPlant:
    """The plant of the paper's eq. 3 (docs/model.md#rigid-body)."""

    def __init__(self) -> None:
        self.state = np.zeros((1, step.STATE_SIZE))
        self.now: Floats = []
        self._packed = np.zeros((1, 0))

    def tune(self, flight: VehicleParams) -> None:
        """As the protocol."""
        self._packed = pack(flight)[np.newaxis]

    def parameters(self, flight: VehicleParams) -> VehicleParams:
        """As the protocol."""
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
        """As the protocol."""
        self.state = step.initial_state(
            flight, position_nwu=position_nwu, velocity_nwu=velocity_nwu, attitude_rad=attitude_rad, airborne=airborne
        )[np.newaxis]
        self.now = self.state[0].tolist()

    def advance(self, command: NDArray[np.float64], *, time_s: float, steps: int) -> NDArray[np.float64]:
        """As the protocol."""
        self.state, thrust = step.advance(self.state, command, self._packed, time_s=time_s, steps=steps)
        self.now = self.state[0].tolist()
        return thrust

    @property
    def motion(self) -> Floats:
        """As the protocol."""
        return self.now

    @property
    def standing(self) -> bool:
        """At rest at or below the ground's height, as it reports itself."""
        return self.now[step.POSITION][2] <= 0.0 and self.now[step.VELOCITY] == [0.0, 0.0, 0.0]


class RotorPlant:
    """A rigid body on four rotors (docs/model.md#rotors)."""

    def __init__(self, airframe: RotorAirframe, *, density_kg_m3: float = airframes.SEA_LEVEL_KG_M3) -> None:
        self.airframe = airframe
        self._density_kg_m3 = density_kg_m3
        self.state = np.zeros((1, rotor_flight.ROTOR_STATE_SIZE))
        self.now: Floats = []
        self._packed = np.zeros((1, 0))
        self._frame = airframes.pack(airframe, density_kg_m3)[np.newaxis]

    def tune(self, flight: VehicleParams) -> None:
        """As the protocol."""
        self._packed = pack(self.parameters(flight))[np.newaxis]

    def parameters(self, flight: VehicleParams) -> VehicleParams:
        """As the protocol. Raises ValueError where its rotors cannot lift it."""
        return rotor_flight.on_rotors(flight, self.airframe, self._density_kg_m3)

    def start(
        self,
        flight: VehicleParams,
        *,
        position_nwu: Sequence[float],
        velocity_nwu: Sequence[float],
        attitude_rad: Sequence[float],
        airborne: bool,
    ) -> None:
        """As the protocol."""
        self.state = rotor_flight.initial_state(
            self.parameters(flight),
            position_nwu=position_nwu,
            velocity_nwu=velocity_nwu,
            attitude_rad=attitude_rad,
            airborne=airborne,
            airframe=self.airframe,
        )[np.newaxis]
        self.now = self.state[0].tolist()

    def advance(self, command: NDArray[np.float64], *, time_s: float, steps: int) -> NDArray[np.float64]:
        """As the protocol."""
        self.state, thrust = rotor_flight.advance(
            self.state, command, self._packed, self._frame, time_s=time_s, steps=steps
        )
        self.now = self.state[0].tolist()
        return thrust

    @property
    def motion(self) -> Floats:
        """As the protocol."""
        return self.now

    @property
    def standing(self) -> bool:
        """As the protocol."""
        return self.now[step.CONTACT] != 0.0
