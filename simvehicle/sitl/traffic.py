"""Other aircraft: movers on fixed paths, reported to the supervisor as ADSB_VEHICLE by one process (255/156).

The file is YAML: `origin: {lat_deg, lon_deg, alt_m}` and `movers`, a list of `callsign`, `path_ned_m`, `speed_m_s`,
`closed` and `start_s`. A mover waits at its first point until `start_s`, then flies at constant speed; an open path is
flown to its end and back.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.vectors import Vec3
from simvehicle.mavlink.codec import ReceivedFrame, message
from simvehicle.mavlink.connection import Connection
from simvehicle.sitl.unit import Unit
from skytender import elementary
from skytender import mavlink as mav
from skytender.safety.patrol import patrol

SYSID, COMPID = 255, 156
REPORT_EVERY_MS = 100
HEARTBEAT_EVERY_MS = 1000
FARTHEST_M = 1e6
FASTEST_M_S = 300.0
"""ADSB_VEHICLE holds vertical speeds up to 327 m/s."""


class TrafficError(ValueError):
    """A traffic file that cannot be used; the text names it and says why."""


@dataclass(frozen=True)
class Aircraft:
    """One aircraft on its path; positions NED in m."""

    callsign: str
    path_ned: tuple[Vec3, ...]
    speed_m_s: float
    closed: bool
    start_s: float

    def at(self, time_s: float) -> tuple[Vec3, Vec3]:
        """Position and velocity at a time."""
        return patrol(self.path_ned, self.speed_m_s, time_s, closed=self.closed, start_s=self.start_s)


class Traffic(Unit):
    """All movers of a session as one MAVLink component."""

    def __init__(self, frame: LocalFrame, movers: list[Aircraft], connections: list[Connection]) -> None:
        self._frame = frame
        self._movers = movers
        self._connections = connections
        self._heartbeat_due_ms = 0
        self._report_due_ms = 0

    def hello(self) -> object:
        """HEARTBEAT of an ADS-B receiver."""
        return message("HEARTBEAT")(
            type=mav.MAV_TYPE_ADSB,
            autopilot=mav.MAV_AUTOPILOT_INVALID,
            system_status=mav.MAV_STATE_ACTIVE,
            mavlink_version=3,
        )

    def start_clock(self, time_ms: int, unix_us: int) -> None:
        """Movers know the session's time as it comes; nothing to set."""

    def receive(self, frame: ReceivedFrame, connection: Connection) -> None:
        """Traffic takes no commands."""

    def advance(self, to_ms: int) -> None:
        """Queue what is due at `to_ms`."""
        due: list[Any] = []
        if to_ms >= self._heartbeat_due_ms:
            self._heartbeat_due_ms = to_ms + HEARTBEAT_EVERY_MS
            due.append(self.hello())
        if to_ms >= self._report_due_ms:
            self._report_due_ms = to_ms + REPORT_EVERY_MS
            due.extend(self._report(i, mover, to_ms / 1e3) for i, mover in enumerate(self._movers))
        for connection in self._connections:
            for content in due:
                connection.put(content)

    def _report(self, index: int, mover: Aircraft, time_s: float) -> Any:
        p_ned, v_ned = mover.at(time_s)
        lat_deg, lon_deg, alt_m = self._frame.to_global(*p_ned)
        return message("ADSB_VEHICLE")(
            ICAO_address=index + 1,
            lat=round(1e7 * lat_deg),
            lon=round(1e7 * lon_deg),
            altitude_type=mav.ADSB_ALTITUDE_TYPE_GEOMETRIC,
            altitude=round(1e3 * alt_m),
            heading=round(1e2 * math.degrees(elementary.atan2(v_ned[1], v_ned[0]))) % 36000,
            hor_velocity=round(1e2 * elementary.hypot(v_ned[0], v_ned[1])),
            ver_velocity=round(-1e2 * v_ned[2]),
            callsign=mover.callsign,
            emitter_type=mav.ADSB_EMITTER_TYPE_UAV,
            flags=mav.ADSB_FLAGS_VALID_COORDS
            | mav.ADSB_FLAGS_VALID_ALTITUDE
            | mav.ADSB_FLAGS_VALID_HEADING
            | mav.ADSB_FLAGS_VALID_VELOCITY
            | mav.ADSB_FLAGS_VALID_CALLSIGN
            | mav.ADSB_FLAGS_SIMULATED,
        )


def load(path: Path) -> tuple[LocalFrame, list[Aircraft]]:
    """Read a traffic file; raises TrafficError."""
    try:
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
        origin = content["origin"]
        frame = LocalFrame(float(origin["lat_deg"]), float(origin["lon_deg"]), float(origin["alt_m"]))
        movers = [_mover(mover) for mover in content["movers"]]
    except OSError as error:
        raise TrafficError(f"{path}: {error.strerror}") from error
    except KeyError as error:
        raise TrafficError(f"{path}: no traffic file: {error} is missing") from error
    except (yaml.YAMLError, TypeError, ValueError, OverflowError) as error:
        raise TrafficError(f"{path}: no traffic file: {' '.join(str(error).split())}") from error
    return frame, movers


def _mover(given: dict[str, Any]) -> Aircraft:
    """One checked entry; raises KeyError, TypeError, ValueError."""
    callsign = str(given["callsign"])
    path = tuple((float(n), float(e), float(d)) for n, e, d in given["path_ned_m"])
    speed_m_s, start_s = float(given["speed_m_s"]), float(given.get("start_s", 0.0))
    if not path or not all(abs(x) <= FARTHEST_M for point in path for x in point):
        raise ValueError(f"path_ned_m of {callsign} needs points within {FARTHEST_M:g} m")
    if not 0.0 <= speed_m_s <= FASTEST_M_S:
        raise ValueError(f"speed_m_s of {callsign} is {speed_m_s:g}, not from 0 to {FASTEST_M_S:g}")
    if not math.isfinite(start_s):
        raise ValueError(f"start_s of {callsign} is no time")
    return Aircraft(callsign, path, speed_m_s, bool(given.get("closed", False)), start_s)
