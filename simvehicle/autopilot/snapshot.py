"""A vehicle at one instant, as telemetry is made of it."""

from __future__ import annotations

from typing import NamedTuple

from simvehicle.autopilot.failures import Failure
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import Identity
from simvehicle.autopilot.modes import Mode

Vec3 = tuple[float, float, float]

CELLS = 4
CELL_FULL_V, CELL_EMPTY_V = 4.2, 3.5


class VehicleState(NamedTuple):
    """A vehicle at one instant: SI units, NED axes, angles in rad, time since boot in ms."""

    identity: Identity
    frame: LocalFrame
    time_ms: int
    unix_us: int
    mode: Mode
    armed: bool
    landed: bool
    ready_to_arm: bool
    p_ned: Vec3
    v_ned: Vec3
    attitude_ned: Vec3
    rates_body: Vec3
    target_p_ned: Vec3
    target_v_ned: Vec3
    target_yaw_ned: float
    home_ned: Vec3
    power_w: float
    drawn_j: float
    remaining_j: float
    capacity_j: float
    control_effort: float
    given_j: int
    received_j: int
    failed: frozenset[Failure] = frozenset()
    booting: bool = False
    outside_fence: bool = False
    mission_length: int = 0
    mission_index: int = 0
    mission_landing: bool = False
    electric: tuple[float, float] | None = None
    """voltage in V and current in A where the plant has them"""

    @property
    def voltage_v(self) -> float:
        """Pack voltage: the plant's, else linear in the charge."""
        if self.electric is not None:
            return self.electric[0]
        share = min(max(self.remaining_j / self.capacity_j, 0.0), 1.0)
        return CELLS * (CELL_EMPTY_V + (CELL_FULL_V - CELL_EMPTY_V) * share)

    @property
    def percent(self) -> int:
        """Charge in whole percent."""
        return min(max(round(100.0 * self.remaining_j / self.capacity_j), 0), 100)
