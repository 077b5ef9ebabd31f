"""Operator control: one ground station at a time may own the vehicle, once it has asked for that; what others send to
change its state is refused then (MAV_CMD_REQUEST_OPERATOR_CONTROL and CONTROL_STATUS of MAVLink's development.xml,
with a single owner). Before the first request every station commands, and nothing is said of it."""

from __future__ import annotations

import math

from simvehicle.autopilot.modes import Severity
from simvehicle.mavlink import message_requests
from simvehicle.mavlink.codec import message
from simvehicle.mavlink.commands import ACCEPTED, DENIED, FAILED, NOT_IN_CONTROL, VehicleCommand
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import ServiceContext
from skytender import mavlink as mav

STATUS_HZ = 1.0
STATE_CHANGING = frozenset(
    {
        mav.MAVLINK_MSG_ID_SET_MODE,
        mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED,
        mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT,
        mav.MAVLINK_MSG_ID_PARAM_SET,
        mav.MAVLINK_MSG_ID_MISSION_COUNT,
        mav.MAVLINK_MSG_ID_MISSION_CLEAR_ALL,
        mav.MAVLINK_MSG_ID_MISSION_WRITE_PARTIAL_LIST,
        mav.MAVLINK_MSG_ID_MISSION_SET_CURRENT,
        mav.MAVLINK_MSG_ID_LOG_ERASE,
    }
)
"""Messages that only the owner's system and the vehicle's own may send."""
_FOR_ALL = frozenset({*message_requests.COMMANDS, mav.MAV_CMD_REQUEST_OPERATOR_CONTROL})
"""Commands that ask for telemetry, and for control itself."""


class OwnerService:
    """Ownership of one vehicle; the owner stands in the vehicle, since telemetry says it."""

    def __init__(self, context: ServiceContext) -> None:
        self._context = context
        self._owners: Connection | None = None
        """the connection on which the owner asked"""

    def bars(self, sysid: int) -> bool:
        """Whether that system may not change the vehicle's state; others learn it, now and then."""
        vehicle = self._context.vehicle
        if vehicle.gcs_main in (0, sysid) or sysid == self._context.sysid:
            return False
        self._context.complain("control", f"Refused: ground station {vehicle.gcs_main} has control")
        return True

    def bars_command(self, request: VehicleCommand) -> bool:
        """The same of a command; what another vehicle orders in a transfer is none of a ground station's."""
        system, component = request.sender
        return component != mav.MAV_COMP_ID_AUTOPILOT1 and request.command not in _FOR_ALL and self.bars(system)

    def request(self, context: ServiceContext, request: VehicleCommand, connection: Connection) -> int:
        """MAV_CMD_REQUEST_OPERATOR_CONTROL: take control, keep it, or give it back."""
        vehicle, asker = context.vehicle, request.sender[0]
        if request.whole(4) != asker or request.params[0] not in (0.0, 1.0) or request.params[1] not in (0.0, 1.0):
            return DENIED
        foreign = vehicle.gcs_main not in (0, asker)
        if request.params[0] == 0.0:
            if foreign:
                return NOT_IN_CONTROL
            self._let(0, allowed=False)
            return ACCEPTED
        if foreign and not vehicle.takeover_allowed:
            self._ask_owner(request)
            return FAILED
        self._owners = connection
        vehicle.receive_gcs_heartbeat()
        self._let(asker, allowed=request.params[1] == 1.0)
        return ACCEPTED

    def watch(self) -> None:
        """Release the vehicle where its owner has been silent for so long that it is lost."""
        vehicle = self._context.vehicle
        if vehicle.gcs_main and vehicle.alone(vehicle.parameters["COM_DL_LOSS_T"]):
            vehicle.announce(Severity.WARNING, f"Ground station {vehicle.gcs_main} lost, nothing has control")
            self._let(0, allowed=False)

    def _let(self, owner: int, *, allowed: bool) -> None:
        vehicle = self._context.vehicle
        if owner not in (0, vehicle.gcs_main):
            vehicle.announce(Severity.INFO, f"Ground station {owner} has control")
        vehicle.gcs_main, vehicle.takeover_allowed = owner, allowed
        self._context.set_rate("CONTROL_STATUS", STATUS_HZ)

    def _ask_owner(self, request: VehicleCommand) -> None:
        """Let the owner know that another asks; it answers by releasing the vehicle or allowing a takeover."""
        if self._owners is None:
            return
        asked = [value if math.isfinite(value) else 0.0 for value in request.params]
        order = message("COMMAND_LONG")(*asked, request.command, self._context.vehicle.gcs_main, 0, 0)
        self._owners.put(order)
