"""Vehicles that say that they are there and nothing else: ArduPilot tells no more until somebody asks for it."""

from __future__ import annotations

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.codec import Message

QUIET_S = 5.0
"""So long it has before it counts as quiet, and between two askings."""
RATE_HZ = 4
_TELEMETRY = frozenset(map(codec.msgid, ("GLOBAL_POSITION_INT", "LOCAL_POSITION_NED", "ATTITUDE", "SYS_STATUS")))


class Quiet:
    """Who is heard, and whether more than that."""

    def __init__(self) -> None:
        self._due_s: dict[int, float] = {}

    def heard(self, sysid: int, msgid: int, now_s: float) -> None:
        """Take note of a message of a vehicle."""
        if msgid in _TELEMETRY or sysid not in self._due_s:
            self._due_s[sysid] = now_s + QUIET_S

    def due(self, now_s: float) -> list[int]:
        """Whose quiet is to be dealt with now, by system id: at first, and again every QUIET_S."""
        found = sorted(sysid for sysid, due_s in self._due_s.items() if now_s >= due_s)
        self._due_s.update(dict.fromkeys(found, now_s + QUIET_S))
        return found


def everything(sysid: int, compid: int) -> Message:
    """REQUEST_DATA_STREAM for all that it has."""
    return codec.message(
        "REQUEST_DATA_STREAM",
        target_system=sysid,
        target_component=compid,
        req_stream_id=mav.MAV_DATA_STREAM_ALL,
        req_message_rate=RATE_HZ,
        start_stop=1,
    )
