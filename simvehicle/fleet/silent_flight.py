"""Flight of a vehicle whose ground station is silent: it holds, or goes where a service needs it
(docs/protocol/onboard.md#flight-without-a-ground-station).

The set points that it gives itself take the way of those that come from outside, and stop as soon as one has come.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from simvehicle.autopilot.maneuvers import AT_REST, OffboardSetPoint, resting_place
from simvehicle.autopilot.modes import STEERED
from simvehicle.autopilot.vectors import Vec3
from simvehicle.autopilot.vehicle import Vehicle
from skytender import elementary

PERIOD_S = 0.1
"""Set points are given ten times a second."""
CORNER_M = 0.3
MOVED_M = 0.3
"""A goal that has moved by less is the same one."""
RETRY_S = 1.0
"""A way that could not be found is looked for again after so long."""
_EVERYWHERE = (True, True, True)

FindRoute = Callable[[Vec3, Vec3], list[Vec3] | None]


class SilentFlight:
    """One vehicle's own set points."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        self._led_s: float | None = None
        self.hold_ned: Vec3 | None = None
        """where it holds, or goes next; None while it is led from outside"""
        self._goal_ned: Vec3 | None = None
        self._corners: list[Vec3] = []
        self._retry_s = -math.inf

    def led(self, now_s: float) -> None:
        """A set point has come from outside."""
        self._led_s, self.hold_ned, self._goal_ned, self._corners = now_s, None, None, []

    def take_over(self, now_s: float) -> bool:
        """Whether the vehicle flies itself: set points have been missing until just before its failsafe would hold."""
        vehicle = self._vehicle
        if self._led_s is None or not vehicle.armed or vehicle.landed or vehicle.mode not in STEERED:
            return False
        if now_s - self._led_s < vehicle.parameters["COM_OF_LOSS_T"] - 1.5 * PERIOD_S:
            return False
        if self.hold_ned is None:
            self.hold_ned = resting_place(vehicle.p_ned, vehicle.v_ned, ground=vehicle.ground, landed=False)
        return True

    def go(self, goal_ned: Vec3 | None, now_s: float, find_route: FindRoute) -> None:
        """Go to a place by corners, or hold where there is no goal or no way; call it only after `take_over`."""
        assert self.hold_ned is not None
        if goal_ned is None:
            if self._goal_ned is not None:
                self._stop()
        elif now_s >= self._retry_s and (
            self._goal_ned is None or elementary.distance(goal_ned, self._goal_ned) > MOVED_M
        ):
            corners = find_route(self._vehicle.p_ned, goal_ned)
            if corners is None:
                self._stop()
                self._retry_s = now_s + RETRY_S
            else:
                self._goal_ned, self._corners = goal_ned, corners
        while self._corners:
            self.hold_ned = self._corners[0]
            if elementary.distance(self._vehicle.p_ned, self.hold_ned) > CORNER_M:
                break
            self._corners.pop(0)
        self._vehicle.set_point(OffboardSetPoint(self.hold_ned, AT_REST, _EVERYWHERE, None, now_s))

    def _stop(self) -> None:
        vehicle = self._vehicle
        self._goal_ned, self._corners = None, []
        self.hold_ned = resting_place(vehicle.p_ned, vehicle.v_ned, ground=vehicle.ground, landed=False)
