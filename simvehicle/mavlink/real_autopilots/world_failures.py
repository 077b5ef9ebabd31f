"""Failures that the world does to a vehicle whose autopilot is not ours: MAV_CMD_INJECT_FAILURE, answered for it.

| unit | type | effect [choice] |
|---|---|---|
| motor | OFF, OK | the motor of that instance, 1 to 4, or all with 0, gives no thrust until it is mended |
| battery | WRONG | so many joules (param4) are gone at once, and count as drawn |
| GPS | WRONG, OK | its reported place is off by so many metres north and east (params 5 and 6) |
| GPS | OFF, OK | its receiver has no fix |

Whatever else is asked for is not supported: the autopilot's own simulation has no part in this.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from simvehicle.autopilot.vectors import Vec3
from simvehicle.mavlink import commands
from simvehicle.mavlink.codec import ReceivedFrame, decode
from simvehicle.world.airframes import ROTORS
from skytender import mavlink as mav

FARTHEST_M = 1e5
NOWHERE: Vec3 = (0.0, 0.0, 0.0)
_COMMANDS = frozenset({mav.MAVLINK_MSG_ID_COMMAND_LONG, mav.MAVLINK_MSG_ID_COMMAND_INT})


class WorldFailures:
    """Failures of one vehicle at present."""

    def __init__(self, sysid: int, waste: Callable[[float], object]) -> None:
        """`waste`: takes joules out of its battery."""
        self._sysid, self._waste = sysid, waste
        self.dead_motors: set[int] = set()
        """of 0 to 3"""
        self.position_error_ned = NOWHERE
        self.gnss_lost = False

    def receive(self, frame: ReceivedFrame) -> list[Any] | None:
        """The acknowledgement of a failure's order; None where the frame is none."""
        content: Any = decode(frame) if frame.msgid in _COMMANDS else None
        if content is None or content.command != mav.MAV_CMD_INJECT_FAILURE:
            return None
        if content.target_system not in (0, self._sysid):
            return None
        request = commands.request_from(content, frame.sender)
        return [commands.acknowledgement(request, self._inject(request))]

    def _inject(self, request: commands.VehicleCommand) -> int:
        unit, kind = request.whole(1, -1), request.whole(2, -1)
        if unit == mav.FAILURE_UNIT_SYSTEM_MOTOR and kind in (mav.FAILURE_TYPE_OFF, mav.FAILURE_TYPE_OK):
            instance = request.whole(3)
            if not 0 <= instance <= ROTORS:
                return commands.DENIED
            motors = {instance - 1} if instance else set(range(ROTORS))
            self.dead_motors = self.dead_motors | motors if kind == mav.FAILURE_TYPE_OFF else self.dead_motors - motors
            return commands.ACCEPTED
        if unit == mav.FAILURE_UNIT_SENSOR_GPS and kind == mav.FAILURE_TYPE_OK:
            self.position_error_ned, self.gnss_lost = NOWHERE, False
            return commands.ACCEPTED
        if unit == mav.FAILURE_UNIT_SENSOR_GPS and kind == mav.FAILURE_TYPE_OFF:
            self.gnss_lost = True
            return commands.ACCEPTED
        numbers = request.params[3:6]
        if kind != mav.FAILURE_TYPE_WRONG:
            return commands.UNSUPPORTED
        if not all(map(math.isfinite, numbers)) or numbers[0] < 0.0 or max(map(abs, numbers[1:])) > FARTHEST_M:
            return commands.DENIED
        if unit == mav.FAILURE_UNIT_SYSTEM_BATTERY:
            self._waste(numbers[0])
            return commands.ACCEPTED
        if unit == mav.FAILURE_UNIT_SENSOR_GPS:
            self.position_error_ned = (numbers[1], numbers[2], 0.0)
            return commands.ACCEPTED
        return commands.UNSUPPORTED
