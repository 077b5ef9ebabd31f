"""A vehicle's body: the state that the flight law flies, read in NED and SI, and one stretch of flight."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import cython
import numpy as np
from cython.cimports.simvehicle.autopilot.body import CHUNK_MS, STEP_MS
from numpy.typing import NDArray

from simvehicle.autopilot.maneuvers import AT_REST, ManeuverTarget
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vectors import Vec3
from simvehicle.law.dynamics import body_rates, nwu_from_ned
from simvehicle.law.plants import Plant

"""Modes, failsafes and transfer are looked at every CHUNK_MS at least, however long the step asked for."""
CELLS = 4
CELL_FULL_V, CELL_EMPTY_V = 4.2, 3.5


@dataclass(frozen=True)
class Start:
    """Start of a vehicle; `airborne`: armed, in offboard on its own state, and without a ground."""

    p_ned: Vec3 = AT_REST
    v_ned: Vec3 = AT_REST
    attitude_ned_rad: Vec3 = AT_REST
    airborne: bool = False


class Body:
    """State of one quadrotor and its time; what it does is its vehicle's affair."""

    parameters: Parameters
    plant: Plant
    time_ms: int
    ground: bool
    initial_j: float
    fastest_turn_rad_s: float
    power_w: float
    lift_m_s2: float
    full_m_s2: float
    steps: int
    """of the last flight"""
    shift_ned: Any
    shifted: bool
    command: Any
    thrust: Any
    room: int
    _thrust: NDArray[np.float64]

    def __init__(self, parameters: Parameters, start: Start, plant: Plant | None = None) -> None:
        """`plant`: what it flies on; without one the paper's. Raises ValueError where that cannot fly so."""
        self.parameters = parameters
        self.plant = Plant() if plant is None else plant
        self.time_ms = 0
        self.ground = not start.airborne
        initial = parameters.flight()
        self.initial_j = initial.battery.initial_j
        self.retune()
        self.plant.start(
            initial,
            position_nwu=nwu_from_ned(start.p_ned),
            velocity_nwu=nwu_from_ned(start.v_ned),
            attitude_rad=nwu_from_ned(start.attitude_ned_rad),
            airborne=start.airborne,
        )
        self.have_room(CHUNK_MS // STEP_MS)
        self.steps = 0
        self.power_w = self.lift_m_s2 = 0.0
        self.shifted = False

    def retune(self) -> None:
        """Fly with the parameters' present values from the next step on."""
        flight = self.parameters.flight()
        self.fastest_turn_rad_s = flight.guidance.yaw_rate_rad_s
        self.plant.tune(flight)
        self.full_m_s2 = self.plant.full_thrust_m_s2(self.parameters["MPC_THR_MAX_G"] * flight.airframe.gravity_m_s2)

    @property
    def time_s(self) -> float:
        """Seconds since boot."""
        return self.time_ms / 1e3

    @property
    def state(self) -> NDArray[np.float64]:
        """The plant's own row, (1, n)."""
        return self.plant.state

    @property
    def true_motion_ned(self) -> tuple[float, ...]:
        """True motion, 12 numbers: position, velocity, Euler angles and their rates; m, m/s, rad, rad/s."""
        m = cython.declare(cython.double[12])
        self.plant.true_motion(m)
        return m[0], -m[1], -m[2], m[3], -m[4], -m[5], m[6], -m[7], -m[8], m[9], -m[10], -m[11]

    @property
    def position_error_ned(self) -> Vec3:
        """Error that a wrong GPS adds to its place, as it knows and flies it, m."""
        return self.shift_ned[0], self.shift_ned[1], self.shift_ned[2]

    @position_error_ned.setter
    def position_error_ned(self, error_ned: Vec3) -> None:
        self.shift_ned[0], self.shift_ned[1], self.shift_ned[2] = error_ned
        self.shifted = error_ned != AT_REST

    def seen(self, x: float, y: float, z: float) -> Vec3:
        """A place of nwu in NED, as it knows it: without an error the place itself, to the last bit."""
        if not self.shifted:
            return x, -y, -z
        return x + self.shift_ned[0], -y + self.shift_ned[1], -z + self.shift_ned[2]

    @property
    def p_ned(self) -> Vec3:
        """Position in the local frame as the vehicle knows it, m."""
        p = self.plant.row.position
        return self.seen(p[0], p[1], p[2])

    @property
    def v_ned(self) -> Vec3:
        """Velocity, m/s."""
        v = self.plant.row.velocity
        return v[0], -v[1], -v[2]

    @property
    def attitude_ned(self) -> Vec3:
        """Roll, pitch and yaw, rad."""
        angles = self.plant.row.attitude
        return angles[0], -angles[1], -angles[2]

    @property
    def rates_body(self) -> Vec3:
        """Roll, pitch and yaw rate about the body's own axes (front, right, down), rad/s."""
        angles, rates = self.plant.row.attitude, self.plant.row.rates
        p, q, r = body_rates(angles[0], angles[1], rates[0], rates[1], rates[2])
        return p, -q, -r

    def stands(self) -> bool:
        """`landed`."""
        return self.ground and self.plant.stands()

    @property
    def landed(self) -> bool:
        """Standing on the ground."""
        return self.stands()

    @property
    def remaining_j(self) -> float:
        """Energy in the battery."""
        return self.plant.row.remaining_j

    @property
    def drawn_j(self) -> float:
        """Energy used by motors and avionics since boot."""
        return self.plant.row.drawn_j

    @property
    def capacity_j(self) -> float:
        """Energy that the battery holds, J."""
        return self.parameters["SIM_BAT_CAP_J"]

    @property
    def thrust_m_s2(self) -> NDArray[np.float64]:
        """Thrust per mass after each step of the last flight, (1, steps)."""
        return self._thrust[:, : self.steps].copy()

    def throttle(self) -> float:
        """Thrust as a share of what there is at full throttle, 0 to 1."""
        return min(max(self.lift_m_s2 / self.full_m_s2, 0.0), 1.0)

    def have_room(self, steps: int) -> None:
        """Have room for the thrust of some steps."""
        self._thrust, self.room = np.zeros((1, steps)), steps
        view = cython.declare(cython.double[:, ::1], self._thrust)
        self.thrust = cython.address(view[0, 0])

    def put_target(self, wanted: ManeuverTarget) -> None:
        """Command what a mode wants, but for yaw and motors."""
        command = cython.address(self.command)
        for i in range(3):
            sign = 1.0 if i == 0 else -1.0
            place = wanted.p_ned[i]
            command.position[i] = sign * (place - self.shift_ned[i] if self.shifted else place)
            command.velocity[i] = sign * wanted.v_ned[i]
            command.use_position[i] = wanted.use_position[i]
        command.time_s = wanted.time_s
        command.speed_max = wanted.speed_m_s

    def fly(self, steps: int, yaw_ned_rad: float, motors: bool) -> None:
        """Fly some steps of 4 ms as commanded, their thrust behind that of the steps before; `time_ms` is the caller's
        to move."""
        command = cython.address(self.command)
        command.yaw, command.motors, command.ground = -yaw_ned_rad, motors, self.ground
        command.period_s = CHUNK_MS / 1e3
        drawn_j = self.plant.row.drawn_j
        self.plant.fly(command, self.time_ms / 1e3, steps, self.thrust + self.steps)
        self.steps += steps
        self.lift_m_s2 = self.thrust[self.steps - 1] if motors else 0.0
        self.power_w = (self.plant.row.drawn_j - drawn_j) / (steps * STEP_MS / 1e3)
