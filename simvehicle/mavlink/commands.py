"""MAV_CMD requests: COMMAND_LONG and COMMAND_INT in one shape, and the acknowledgement that each gets exactly once.

Parameters that a sender leaves unset arrive as NaN (PX4's habit) or 0 (ArduPilot's): `value` reads the first, and a
handler for which 0 has no meaning of its own reads the second.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from simvehicle.autopilot.energy_transfer import TransferOrder, TransferSide
from simvehicle.mavlink.codec import message
from skytender import mavlink as mav

ACCEPTED: int = mav.MAV_RESULT_ACCEPTED
TEMPORARILY_REJECTED: int = mav.MAV_RESULT_TEMPORARILY_REJECTED
DENIED: int = mav.MAV_RESULT_DENIED
UNSUPPORTED: int = mav.MAV_RESULT_UNSUPPORTED
FAILED: int = mav.MAV_RESULT_FAILED
IN_PROGRESS: int = mav.MAV_RESULT_IN_PROGRESS
NOT_IN_CONTROL: int = mav.MAV_RESULT_NOT_IN_CONTROL


class VehicleCommand(NamedTuple):
    """One command: id, params 1..4, then x, y, z as params 5..7 (degrees for global frames), and its sender.

    `framed`: whether it names its frame, as COMMAND_INT does; COMMAND_LONG is taken as global.
    """

    command: int
    params: tuple[float, ...]
    frame: int
    sender: tuple[int, int]
    framed: bool

    @property
    def altitude_is_relative(self) -> bool:
        """Whether param 7 counts from home and not from mean sea level."""
        return self.frame in RELATIVE_FRAMES

    @property
    def frame_is_known(self) -> bool:
        """Whether params 5..7 stand in a frame that the vehicle can place itself in."""
        return self.frame in _KNOWN_FRAMES

    def value(self, number: int, default: float) -> float:
        """Parameter `number` (1..7), or the default where it is NaN."""
        given = self.params[number - 1]
        return default if math.isnan(given) else given

    def whole(self, number: int, default: int = 0) -> int:
        """Parameter `number` as an integer; NaN and infinities give the default."""
        given = self.params[number - 1]
        return round(given) if math.isfinite(given) else default


def request_from(content: Any, sender: tuple[int, int]) -> VehicleCommand:
    """The request in a COMMAND_LONG or COMMAND_INT."""
    first = (content.param1, content.param2, content.param3, content.param4)
    if hasattr(content, "param7"):
        last = (content.param5, content.param6, content.param7)
        return VehicleCommand(content.command, first + last, mav.MAV_FRAME_GLOBAL, sender, framed=False)
    scale = 1.0
    if content.command in _WITH_A_PLACE:
        scale = 1e-4 if content.frame in _LOCAL_FRAMES else 1e-7
    x, y = (math.nan if number == _UNSET_INT else number * scale for number in (content.x, content.y))
    return VehicleCommand(content.command, (*first, x, y, content.z), content.frame, sender, framed=True)


def transfer_order(request: VehicleCommand) -> TransferOrder | None:
    """The order in a MAV_CMD_USER_1; None where its numbers are none that a transfer can have."""
    numbers, role = request.params[:6], request.whole(2, -1)
    if not all(map(math.isfinite, numbers)) or role not in tuple(TransferSide):
        return None
    limit_j, rate_w = numbers[2:4]
    if role in (TransferSide.GIVE, TransferSide.RECEIVE) and not (limit_j > 0.0 and rate_w > 0.0):
        return None
    if role == TransferSide.SETTLE and limit_j < 0.0:
        return None
    return TransferOrder(
        partner=request.whole(1),
        role=TransferSide(role),
        limit_j=limit_j,
        rate_w=rate_w,
        transfer_id=request.whole(5),
        giver_start_j=request.whole(6),
    )


def command_long(sysid: int, command: int, *params: float) -> Any:
    """COMMAND_LONG to the autopilot of a system; parameters that are not given are 0."""
    numbers = (*map(float, params), *(0.0,) * (7 - len(params)))
    return message("COMMAND_LONG")(*numbers, command, sysid, mav.MAV_COMP_ID_AUTOPILOT1, 0)


def acknowledgement(request: VehicleCommand, result: int) -> Any:
    """COMMAND_ACK to the sender."""
    return message("COMMAND_ACK")(
        command=request.command,
        result=result,
        target_system=request.sender[0],
        target_component=request.sender[1],
    )


_LOCAL_FRAMES = frozenset(
    {mav.MAV_FRAME_LOCAL_NED, mav.MAV_FRAME_LOCAL_ENU, mav.MAV_FRAME_LOCAL_OFFSET_NED, mav.MAV_FRAME_BODY_FRD}
)
RELATIVE_FRAMES = frozenset({mav.MAV_FRAME_GLOBAL_RELATIVE_ALT, mav.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT})
"""Frames whose heights count from home."""
_KNOWN_FRAMES = RELATIVE_FRAMES | {mav.MAV_FRAME_GLOBAL, mav.MAV_FRAME_GLOBAL_INT, mav.MAV_FRAME_LOCAL_NED}
_WITH_A_PLACE = frozenset(
    {
        mav.MAV_CMD_NAV_TAKEOFF,
        mav.MAV_CMD_NAV_LAND,
        mav.MAV_CMD_NAV_LOITER_UNLIM,
        mav.MAV_CMD_DO_REPOSITION,
        mav.MAV_CMD_DO_SET_HOME,
    }
)
"""Commands whose x and y in COMMAND_INT are scaled; those of all others are whole numbers as they are."""
_UNSET_INT = 2**31 - 1
