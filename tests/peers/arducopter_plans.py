"""Rally points of the scripted ArduCopter: it keeps whole metres of their heights, cut off, as ArduPilot's int16 does.

Fences and missions it does not take, and does not say so.
"""

from __future__ import annotations

from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mav

RALLY = mav.MAV_MISSION_TYPE_RALLY


class RallyPoints:
    """The points that it has, and those that are being written."""

    def __init__(self) -> None:
        self.points: list[tuple[int, int, float]] = []
        self._coming: list[tuple[int, int, float]] = []
        self._count = 0

    def hear(self, m: Any) -> list[Any]:
        """Answers to a message about a plan."""
        to = (m.get_srcSystem(), m.get_srcComponent())
        name = m.get_type()
        if name == "MISSION_REQUEST_LIST":
            count = len(self.points) if m.mission_type == RALLY else 0
            return [mav.MAVLink_mission_count_message(*to, count, m.mission_type)]
        if m.mission_type != RALLY:
            return []
        if name == "MISSION_COUNT":
            self._coming, self._count = [], m.count
        elif name == "MISSION_ITEM_INT" and m.seq == len(self._coming) < self._count:
            self._coming.append((m.x, m.y, float(int(m.z))))
        elif name == "MISSION_REQUEST_INT" and m.seq < len(self.points):
            item = (mav.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT, mav.MAV_CMD_NAV_RALLY_POINT, 0, 1, 0, 0, 0, 0)
            return [mav.MAVLink_mission_item_int_message(*to, m.seq, *item, *self.points[m.seq], RALLY)]
        else:
            return []
        if len(self._coming) < self._count:
            return [mav.MAVLink_mission_request_message(*to, len(self._coming), RALLY)]
        self.points = self._coming
        return [mav.MAVLink_mission_ack_message(*to, mav.MAV_MISSION_ACCEPTED, RALLY)]
