"""Handlers of MAV_CMD_INJECT_FAILURE and MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN."""

from __future__ import annotations

import math
from collections.abc import Callable

from simvehicle.autopilot.failures import Failure
from simvehicle.autopilot.maneuvers import AT_REST
from simvehicle.autopilot.modes import Severity
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink import commands
from simvehicle.mavlink.commands import ACCEPTED, DENIED, IN_PROGRESS, TEMPORARILY_REJECTED, UNSUPPORTED, VehicleCommand
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import CommandHandler, ServiceContext
from skytender import elementary
from skytender import mavlink as mav

REBOOT_S = 1.0
REBOOT = 1
FARTHEST_M = 1e5
_WRONG = (Failure.GPS, Failure.BATTERY)
_UNITS = {
    mav.FAILURE_UNIT_SENSOR_GPS: Failure.GPS,
    mav.FAILURE_UNIT_SYSTEM_BATTERY: Failure.BATTERY,
    mav.FAILURE_UNIT_SYSTEM_MOTOR: Failure.MOTOR,
    mav.FAILURE_UNIT_SYSTEM_MAVLINK_SIGNAL: Failure.LINK,
}


def inject_failure(context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
    """MAV_CMD_INJECT_FAILURE: param1 the unit, 2 OFF or OK; the instance (3) does not count: there is one each.

    WRONG is known of the battery, param4 the joules that are gone, and of the GPS, params 5 and 6 how far off it is.
    """
    vehicle = context.vehicle
    failure = _UNITS.get(request.whole(1, -1))
    kind = request.whole(2, -1)
    known = (mav.FAILURE_TYPE_OK, mav.FAILURE_TYPE_OFF, *((mav.FAILURE_TYPE_WRONG,) if failure in _WRONG else ()))
    if failure is None or kind not in known:
        return UNSUPPORTED
    numbers = request.params[3:6]
    if kind == mav.FAILURE_TYPE_WRONG and not (all(map(math.isfinite, numbers)) and numbers[0] >= 0.0):
        return DENIED
    if kind == mav.FAILURE_TYPE_WRONG and max(map(abs, numbers[1:])) > FARTHEST_M:
        return DENIED
    if vehicle.parameters["SYS_FAILURE_EN"] != 1.0:
        vehicle.announce(Severity.WARNING, "Failure refused: SYS_FAILURE_EN is 0")
        return DENIED
    if kind == mav.FAILURE_TYPE_WRONG:
        _go_wrong(vehicle, failure, *numbers)
        return ACCEPTED
    if failure is Failure.GPS and kind == mav.FAILURE_TYPE_OK and vehicle.position_error_ned != AT_REST:
        vehicle.position_error_ned = AT_REST
        vehicle.announce(Severity.INFO, f"Mended: {failure}")
    if (kind == mav.FAILURE_TYPE_OFF) == (failure in vehicle.failed):
        return ACCEPTED
    if kind == mav.FAILURE_TYPE_OFF:
        vehicle.announce(Severity.CRITICAL, f"Injected: {failure} failed")
        vehicle.failed.add(failure)
    else:
        vehicle.announce(Severity.INFO, f"Mended: {failure}")
        vehicle.failed.discard(failure)
    return ACCEPTED


def _go_wrong(vehicle: Vehicle, failure: Failure, joules: float, north_m: float, east_m: float) -> None:
    if failure is Failure.BATTERY:
        vehicle.plant.waste(joules)
        vehicle.announce(Severity.CRITICAL, f"Injected: {joules:.0f} J of the battery are gone")
    else:
        vehicle.position_error_ned = (north_m, east_m, 0.0)
        vehicle.announce(Severity.CRITICAL, f"Injected: {failure} is off by {elementary.hypot(north_m, east_m):.1f} m")


class Reboot:
    """MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN: in progress for a second of the vehicle's time, then done.

    Clock, place and battery go on; mode, failures and set points are forgotten. Parameters come back as they were at
    start or, with a store, as they are; so do plans, and without a store there are none.
    """

    def __init__(self, context: ServiceContext, restart_plans: Callable[[], None]) -> None:
        self._context = context
        self._restart_plans = restart_plans
        self._at_start = context.vehicle.parameters.values()
        self._asked: tuple[VehicleCommand, Connection, float] | None = None

    def ask(self, context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
        """Begin, on the ground and disarmed; asked again, still in progress."""
        vehicle = context.vehicle
        if request.whole(1) == 0 and request.whole(2) == 0:
            return ACCEPTED
        if request.whole(1) != REBOOT:
            return UNSUPPORTED
        if vehicle.armed or not (vehicle.landed or vehicle.booting):
            vehicle.announce(Severity.WARNING, "Reboot refused: armed or in the air")
            return TEMPORARILY_REJECTED
        if self._asked is None:
            vehicle.announce(Severity.INFO, "Rebooting")
            vehicle.booting = True
            self._asked = (request, connection, vehicle.time_s)
            vehicle.on_change()
        return IN_PROGRESS

    @property
    def at_work(self) -> bool:
        """Whether a reboot is under way."""
        return self._asked is not None

    def busy_with(self, request: VehicleCommand) -> bool:
        """Whether a reboot is under way that is not what is asked for."""
        return self._asked is not None and request.command != mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN

    def finish(self) -> None:
        """Let the vehicle come back once it is time, and acknowledge the request."""
        vehicle = self._context.vehicle
        if self._asked is None or vehicle.time_s - self._asked[2] < REBOOT_S:
            return
        request, connection, _ = self._asked
        self._asked = None
        if self._context.store is None:
            vehicle.parameters.restore(self._at_start)
        vehicle.restart()
        self._restart_plans()
        vehicle.booting = False
        vehicle.announce(Severity.INFO, "Booted")
        vehicle.on_change()
        connection.put(commands.acknowledgement(request, ACCEPTED))


COMMANDS: dict[int, CommandHandler] = {mav.MAV_CMD_INJECT_FAILURE: inject_failure}
