"""MAV_CMD requests: COMMAND_LONG and COMMAND_INT in one shape, and the acknowledgement that each gets exactly once.

Parameters that a sender leaves unset arrive as NaN (PX4's habit) or 0 (ArduPilot's); `value` reads both.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.codec import message

ACCEPTED: int = mav.MAV_RESULT_ACCEPTED
TEMPORARILY_REJECTED: int = mav.MAV_RESULT_TEMPORARILY_REJECTED
DENIED: int = mav.MAV_RESULT_DENIED
UNSUPPORTED: int = mav.MAV_RESULT_UNSUPPORTED


class Request(NamedTuple):
    """One command: id, params 1..4, then x, y, z as params 5..7 (degrees for global frames), and who asked."""

    command: int
    params: tuple[float, ...]
    frame: int
    sender: tuple[int, int]

    def value(self, number: int, default: float) -> float:
        """Parameter `number` (1..7), or the default where it is NaN."""
        given = self.params[number - 1]
        return default if math.isnan(given) else given

    def whole(self, number: int, default: int = 0) -> int:
        """Parameter `number` as an integer; NaN and infinities give the default."""
        given = self.params[number - 1]
        return round(given) if math.isfinite(given) else default


def request_from(content: Any, sender: tuple[int, int]) -> Request:
    """The request in a COMMAND_LONG or COMMAND_INT."""
    first = (content.param1, content.param2, content.param3, content.param4)
    if hasattr(content, "param7"):
        last = (content.param5, content.param6, content.param7)
        return Request(content.command, first + last, mav.MAV_FRAME_GLOBAL, sender)
    scale = 1e-7 if content.frame not in _LOCAL_FRAMES else 1e-4
    last = (content.x * scale, content.y * scale, content.z)
    return Request(content.command, first + last, content.frame, sender)


def acknowledgement(request: Request, result: int) -> Any:
    """COMMAND_ACK to the one who asked."""
    return message("COMMAND_ACK")(
        command=request.command,
        result=result,
        progress=0,
        result_param2=0,
        target_system=request.sender[0],
        target_component=request.sender[1],
    )


_LOCAL_FRAMES = frozenset(
    {mav.MAV_FRAME_LOCAL_NED, mav.MAV_FRAME_LOCAL_ENU, mav.MAV_FRAME_LOCAL_OFFSET_NED, mav.MAV_FRAME_BODY_FRD}
)
