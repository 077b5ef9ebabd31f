"""Other aircraft by their ADSB_VEHICLE, and where the safety filter keeps its vehicles from: for the station, and for a
vehicle that flies by itself. NED, SI units."""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Iterable
from dataclasses import dataclass
from typing import Any

from skytender import elementary
from skytender.safety.intruders import Intruder

Vec3 = tuple[float, float, float]

TRAFFIC_FORGOTTEN_S = 10.0
"""An aircraft that has been silent for so long could be anywhere: its range would fill the sky."""
MOST_TRAFFIC = 256
"""Aircraft that are kept at once; of further ones nothing is."""
LEAST_AGILE_M_S = 1.0
"""[choice] Speed at which an aircraft may turn that has hovered."""


@dataclass(frozen=True, slots=True)
class TrafficView:
    """Another aircraft by its ADSB_VEHICLE; common NED frame."""

    callsign: str
    p_ned: Vec3
    v_ned: Vec3
    age_s: float


class KnownTraffic:
    """The aircraft that have been received lately."""

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

    def move(self, moved: Callable[[Vec3, Vec3], tuple[Vec3, Vec3]]) -> None:
        """Let all of them lie in a new common frame; `moved`: place and velocity there of those in the old one."""
        self._known = {
            icao: (callsign, *moved(at_ned, v_ned), seen_s)
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


class TrafficReach:
    """Where aircraft may be, by how fast each has flown since it came into sight."""

    def __init__(self) -> None:
        self._agile_m_s: dict[str, float] = {}

    def intruders(
        self, traffic: Iterable[TrafficView], lag_s: float, radius_m: float, attracting: Container[str] = ()
    ) -> list[Intruder]:
        """Aircraft as the filter takes them, where they will be when vehicles fly where their leaders are now, `lag_s`
        behind those. Each goes straight on, and may turn (skytender/safety/leaving.py) unless it is among `attracting`,
        by callsign."""
        traffic = tuple(traffic)
        speeds = {aircraft.callsign: elementary.norm(aircraft.v_ned) for aircraft in traffic}
        self._agile_m_s = {
            name: max(speed, LEAST_AGILE_M_S, self._agile_m_s.get(name, 0.0)) for name, speed in speeds.items()
        }
        found: list[Intruder] = []
        for aircraft in traffic:
            name, lead_s = f"traffic {aircraft.callsign}", lag_s + aircraft.age_s
            agile_m_s, turns = self._agile_m_s[aircraft.callsign], aircraft.callsign not in attracting
            straight = (aircraft.p_ned, aircraft.v_ned, lead_s, radius_m, aircraft.age_s)
            found.append(Intruder.of(name, None, *straight, -agile_m_s if turns else 0.0))
            if turns:
                found.append(Intruder.turning(name, aircraft.p_ned, agile_m_s, lead_s, radius_m))
        return found
