"""A vehicle that flies, knows where it is, and says so in the messages of its kind, as pymavlink packs them.

The truth is geodesy by pymap3d: a local frame's north and east are those of the plane that touches the ellipsoid at its
origin, down is the difference of heights above the sea.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cache
from typing import Any

import pymap3d

os.environ.setdefault("MAVLINK20", "1")
from pymavlink.dialects.v10 import common as v10
from pymavlink.dialects.v20 import common as v20

from gcs.mavlink import codec

Geodetic = tuple[float, float, float]
PX4, ARDUPILOT, GENERIC = 12, 3, 0
KINDS = ("HOME_POSITION", "GPS_GLOBAL_ORIGIN", "LOCAL_POSITION_NED", "GLOBAL_POSITION_INT")


@cache
def seen_from(common: Geodetic, place: Geodetic) -> tuple[float, float, float]:
    """A place in the frame that begins at `common`, m."""
    north, east, _ = pymap3d.geodetic2ned(place[0], place[1], common[2], *common)
    return float(north), float(east), common[2] - place[2]


@dataclass
class TruthfulVehicle:
    """Flies from its home at a constant velocity; ArduPilot's kind does not know its height before `knows_s`, and then
    says only how high it is above where it was switched on. Times are s."""

    sysid: int
    autopilot: int
    home: Geodetic
    origin_in_home: tuple[float, float, float] = (0.0, 0.0, 0.0)
    v_ned: tuple[float, float, float] = (3.0, -4.0, -0.5)
    knows_s: float = 0.0
    booted_s: float = 0.0
    wire: Any = v20
    armed: bool = True

    def __post_init__(self) -> None:
        self._mav = self.wire.MAVLink(None, srcSystem=self.sysid, srcComponent=1)

    @property
    def origin(self) -> Geodetic:
        """Where its own frame begins."""
        return _beside(self.home, self.origin_in_home)

    def place(self, t_s: float) -> Geodetic:
        """Where it is."""
        return _beside(self.home, self._flown(t_s))

    def reboot(self, t_s: float, knows_s: float) -> None:
        """Switch it off and on: its own frame begins where it is then, and its clock anew."""
        self.booted_s, self.knows_s = t_s, knows_s
        self.origin_in_home = self._flown(t_s)

    def above_start_m(self, t_s: float) -> float:
        """How high it is above where it was switched on."""
        return -(t_s - self.booted_s) * self.v_ned[2]

    def _flown(self, t_s: float) -> tuple[float, float, float]:
        north, east, down = self.v_ned
        return (t_s * north, t_s * east, t_s * down)

    def knows(self, t_s: float) -> bool:
        """Whether it knows its height above the sea."""
        return t_s >= self.knows_s

    def beat(self) -> codec.Frame:
        """Its HEARTBEAT."""
        cls = self.wire.MAVLink_heartbeat_message
        return self._framed(cls(2, self.autopilot, 0x81 if self.armed else 0x01, 0, 4 if self.armed else 3, 3))

    def says(self, kind: str, t_s: float) -> codec.Frame | None:
        """One of KINDS as of that time; None while it can't be said."""
        if kind == "GLOBAL_POSITION_INT":
            return self._global(t_s)
        if not self.knows(t_s):
            return None
        if kind == "LOCAL_POSITION_NED":
            boot_ms = round(1e3 * (t_s - self.booted_s))
            return self._framed(
                self.wire.MAVLink_local_position_ned_message(
                    boot_ms, *seen_from(self.origin, self.place(t_s)), *self.v_ned
                )
            )
        if kind == "GPS_GLOBAL_ORIGIN":
            return self._framed(self.wire.MAVLink_gps_global_origin_message(*_whole(self.origin)))
        local = (0.0, 0.0, 0.0) if self.autopilot == ARDUPILOT else seen_from(self.origin, self.home)
        cls = self.wire.MAVLink_home_position_message
        return self._framed(cls(*_whole(self.home), *local, [1.0, 0.0, 0.0, 0.0], 0.0, 0.0, 0.0))

    def _global(self, t_s: float) -> codec.Frame | None:
        if not self.knows(t_s) and self.autopilot != ARDUPILOT:
            return None
        lat, lon, alt_mm = _whole(self.place(t_s))
        above_mm = round(-1e3 * t_s * self.v_ned[2])
        if not self.knows(t_s):
            alt_mm = above_mm = round(1e3 * self.above_start_m(t_s))
        v = [round(100.0 * axis) for axis in self.v_ned]
        cls = self.wire.MAVLink_global_position_int_message
        return self._framed(cls(round(1e3 * (t_s - self.booted_s)), lat, lon, alt_mm, above_mm, *v, 65535))

    def _framed(self, message: Any) -> codec.Frame:
        raw = bytes(message.pack(self._mav))
        self._mav.seq = (self._mav.seq + 1) % 256
        (frame,) = codec.split(raw).older if self.wire is v10 else codec.split(raw).frames
        return frame


@cache
def _beside(home: Geodetic, ned: tuple[float, float, float]) -> Geodetic:
    lat, lon, _ = pymap3d.ned2geodetic(ned[0], ned[1], 0.0, *home)
    return float(lat), float(lon), home[2] - ned[2]


def _whole(place: Geodetic) -> tuple[int, int, int]:
    return round(1e7 * place[0]), round(1e7 * place[1]), round(1e3 * place[2])
