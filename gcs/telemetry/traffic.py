"""Other aircraft by their ADSB_VEHICLE, in the common frame."""

from __future__ import annotations

import math
from typing import Any

from gcs.mavlink.common_frame import FramePlace, turned
from gcs.telemetry.state import TrafficView, Vec3
from skytender import elementary

TRAFFIC_FORGOTTEN_S = 10.0
"""An aircraft that has been silent for so long could be anywhere: its range would fill the sky."""
MOST_TRAFFIC = 256
"""Aircraft that are kept at once; of further ones nothing is."""


class KnownTraffic:
    """The aircraft that have been heard lately."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[str, Vec3, Vec3, float]] = {}

    def __len__(self) -> int:
        return len(self._known)

    def receive(self, content: Any, p_ned: Vec3, time_s: float) -> None:
        """Take an ADSB_VEHICLE, whose place in the common frame that is (m), which was delivered at a session time."""
        if content.ICAO_address not in self._known and len(self._known) >= MOST_TRAFFIC:
            known = self._known.items()
            self._known = {icao: one for icao, one in known if time_s - one[3] <= TRAFFIC_FORGOTTEN_S}
            if len(self._known) >= MOST_TRAFFIC:
                return
        heading_rad = math.radians(0.01 * content.heading)
        speed_m_s = 0.01 * content.hor_velocity
        sin, cos = elementary.sin_cos(heading_rad)
        v_ned = (speed_m_s * cos, speed_m_s * sin, -0.01 * content.ver_velocity)
        self._known[content.ICAO_address] = (content.callsign, p_ned, v_ned, time_s - content.tslc)

    def move(self, place: FramePlace) -> None:
        """Let all of them lie in a new common frame, in which the old one lies at `place`."""
        self._known = {
            icao: (callsign, place.moved(at_ned), turned(v_ned, place.turn_rad), seen_s)
            for icao, (callsign, at_ned, v_ned, seen_s) in self._known.items()
        }

    def at(self, time_s: float) -> tuple[TrafficView, ...]:
        """All of them at a session time, in order of their addresses."""
        if not self._known:
            return ()
        return tuple(
            TrafficView(callsign, p_ned, v_ned, max(time_s - seen_s, 0.0))
            for _, (callsign, p_ned, v_ned, seen_s) in sorted(self._known.items())
            if time_s - seen_s <= TRAFFIC_FORGOTTEN_S
        )
