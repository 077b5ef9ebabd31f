"""A vehicle's body: the state that the flight law flies, read in NED and SI, and one stretch of flight."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from simvehicle.autopilot.maneuvers import AT_REST, ManeuverTarget
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.snapshot import Vec3
from simvehicle.law import rows
from simvehicle.law.dynamics import body_rates, ned_from_nwu, nwu_from_ned
from simvehicle.law.plants import Plant

STEP_MS = 4
_POSITION, _VELOCITY = rows.POSITION, rows.VELOCITY
CHUNK_MS = 100
"""Modes, failsafes and transfer are looked at this often at least, however long the step asked for."""


@dataclass(frozen=True)
class Start:
    """Start of a vehicle; `airborne`: armed, in offboard on its own state, and without a ground."""

    p_ned: Vec3 = AT_REST
    v_ned: Vec3 = AT_REST
    attitude_ned_rad: Vec3 = AT_REST
    airborne: bool = False


class Body:
    """State of one quadrotor and its time; what it does is its vehicle's affair."""

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
        self.thrust_m_s2: NDArray[np.float64] = np.empty((1, 0))
        self.power_w = 0.0
        self.position_error_ned: Vec3 = AT_REST
        """what a wrong GPS adds to its place, as it knows and flies it"""
        self._command = np.zeros((1, rows.COMMAND_SIZE))

    def retune(self) -> None:
        """Fly with the parameters' present values from the next step on."""
        flight = self.parameters.flight()
        self.fastest_turn_rad_s = flight.guidance.yaw_rate_rad_s
        self.plant.tune(flight)

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
        n, w, u, v_n, v_w, v_u, roll, pitch, yaw, p, q, r = self.plant.motion[: rows.RATES.stop]
        return n, -w, -u, v_n, -v_w, -v_u, roll, -pitch, -yaw, p, -q, -r

    @property
    def p_ned(self) -> Vec3:
        """Position in the local frame as the vehicle knows it, m."""
        north, west, up = self.plant.now[_POSITION]
        return _shifted((north, -west, -up), self.position_error_ned)

    @property
    def v_ned(self) -> Vec3:
        """Velocity, m/s."""
        north, west, up = self.plant.now[_VELOCITY]
        return north, -west, -up

    @property
    def attitude_ned(self) -> Vec3:
        """Roll, pitch and yaw, rad."""
        return ned_from_nwu(self.plant.now[rows.ATTITUDE])

    @property
    def rates_body(self) -> Vec3:
        """Roll, pitch and yaw rate about the body's own axes (front, right, down), rad/s."""
        roll, pitch, _ = self.plant.now[rows.ATTITUDE]
        return ned_from_nwu(body_rates(roll, pitch, *self.plant.now[rows.RATES]))

    @property
    def reference_ned(self) -> tuple[Vec3, Vec3]:
        """Position and velocity that the guidance really flies."""
        p_ned, v_ned = self.plant.now[rows.REFERENCE_POSITION], self.plant.now[rows.REFERENCE_VELOCITY]
        return _shifted(ned_from_nwu(p_ned), self.position_error_ned), ned_from_nwu(v_ned)

    @property
    def landed(self) -> bool:
        """Standing on the ground."""
        return self.ground and self.plant.standing

    @property
    def remaining_j(self) -> float:
        """Energy in the battery."""
        return self.plant.now[rows.REMAINING_J]

    @property
    def drawn_j(self) -> float:
        """Energy used by motors and avionics since boot."""
        return self.plant.now[rows.DRAWN_J]

    @property
    def capacity_j(self) -> float:
        """Energy in the battery, J."""
        return self.parameters["SIM_BAT_CAP_J"]

    @property
    def control_effort(self) -> float:
        """Integral of the control inputs' sizes."""
        return self.plant.now[rows.EFFORT]

    def fly(self, steps: int, wanted: ManeuverTarget, *, yaw_ned_rad: float, motors: bool) -> None:
        """Fly some steps of 4 ms towards a set point; `time_ms` is the caller's to move."""
        self._command[0] = (  # in the order of flight.CMD_…
            *nwu_from_ned(_shifted(wanted.p_ned, self.position_error_ned, -1.0)),
            *nwu_from_ned(wanted.v_ned),
            wanted.time_s,
            *wanted.use_position,
            -yaw_ned_rad,
            motors,
            self.ground,
            wanted.speed_m_s,
            CHUNK_MS / 1e3,
        )
        drawn_j = self.drawn_j
        self.thrust_m_s2 = self.plant.advance(self._command, time_s=self.time_s, steps=steps)
        self.power_w = (self.drawn_j - drawn_j) / (steps * STEP_MS / 1e3)


def _shifted(p_ned: Vec3, error_ned: Vec3, sign: float = 1.0) -> Vec3:
    """The place itself where there is no error, to the last bit."""
    if error_ned is AT_REST:
        return p_ned
    return (p_ned[0] + sign * error_ned[0], p_ned[1] + sign * error_ned[1], p_ned[2] + sign * error_ned[2])
