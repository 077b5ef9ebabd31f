"""Adapter from any autopilot's telemetry to the messages that `Fleet` reads: position, origin, landed state.

The fleet reads a vehicle's own local frame and the global origin of that. Autopilots report their positions in several
ways, count time since their own start, and some leave out what others say:

- a local position is reported as of the time at which it came;
- the origin, where it is not reported, follows from HOME_POSITION (of an autopilot whose home stands in the local
  frame), or from a global position beside a local one;
- of a vehicle that reports only global positions these are the local ones, in the common frame itself;
- whether it has landed, where EXTENDED_SYS_STATE does not say, follows from HEARTBEAT's system status;
- what its battery holds, where its capacity is unknown, is the share that it reports, of no number of joules.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, Literal

import pymap3d
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink import codec
from gcs.mavlink.autopilots import profile_of
from gcs.mavlink.battery import sys_status
from gcs.mavlink.codec import Frame
from gcs.mavlink.ids import AUTOPILOT
from gcs.telemetry import plausibility
from gcs.telemetry.batteries import Batteries
from gcs.telemetry.fleet import GlobalOrigin
from gcs.telemetry.state import Vec3, VehicleView

TOGETHER_S = 1.0
"""A local and a global position that came within this time are of the same place."""
_HEARTBEAT = codec.msgid("HEARTBEAT")
_LOCAL = codec.msgid("LOCAL_POSITION_NED")
_GLOBAL = codec.msgid("GLOBAL_POSITION_INT")
_ORIGIN = codec.msgid("GPS_GLOBAL_ORIGIN")
_HOME = codec.msgid("HOME_POSITION")
_STATE = codec.msgid("EXTENDED_SYS_STATE")
_BATTERY = codec.msgid("BATTERY_STATUS")
_STATUS = codec.msgid("SYS_STATUS")


class TelemetryAdapter:
    """Adapts one vehicle's telemetry. `translate` gives the frames that the fleet is to read in place of one."""

    def __init__(self, sysid: int, compid: int) -> None:
        self.sysid = sysid
        self.compid = compid
        self.share: float | None = None
        """what the battery holds of its capacity, 0..1; None: not reported"""
        self.power_w: float | None = None
        """what is drawn; None: not measured"""
        self.batteries = Batteries()
        """also those that other components report"""
        self._home_is_local = False
        self._system_status = mav.MAV_STATE_UNINIT
        self._state_reported = False
        self._origin: GlobalOrigin | None = None
        """of its local frame, reported or derived"""
        self._origin_reported = False
        self._reads: Literal["", "local", "global"] = ""
        """by which positions the fleet knows its place"""
        self._local: tuple[float, Vec3] | None = None

    def translate(self, frame: Frame, t_s: float, origin: GlobalOrigin | None) -> Iterator[Frame]:
        """Frames that the fleet, whose common frame begins at `origin`, reads in place of one that came at `t_s`."""
        msgid = frame.msgid
        if msgid == _LOCAL:
            yield from self._receive_local(codec.fields(frame), t_s)
        elif msgid == _GLOBAL:
            yield from self._receive_global(codec.fields(frame), t_s, origin)
        elif msgid == _HOME:
            content = codec.fields(frame)
            if not self._origin_reported and self._home_is_local and _is_place(content.latitude, content.longitude):
                yield from self._own(_origin_under(content))
        elif msgid == _ORIGIN:
            content = codec.fields(frame)
            if _is_place(content.latitude, content.longitude):
                self._origin_reported = True
                yield from self._own(_reported_origin(content))
        else:
            if msgid == _HEARTBEAT:
                content = codec.fields(frame)
                self._home_is_local = profile_of(content.autopilot).home_is_local
                self._system_status = content.system_status
            elif msgid == _STATE:
                self._state_reported = codec.fields(frame).landed_state != mav.MAV_LANDED_STATE_UNDEFINED
            elif msgid == _STATUS:
                self._receive_status(codec.fields(frame), t_s)
            elif msgid == _BATTERY:
                self.receive_battery(frame, t_s)
            yield frame if frame.compid == AUTOPILOT else codec.sent_by(frame, AUTOPILOT)

    def receive_battery(self, frame: Frame, t_s: float) -> None:
        """Take in BATTERY_STATUS, from any component of the vehicle."""
        self.batteries.add(frame.compid, codec.fields(frame), t_s)
        share, power_w = self.batteries.share(t_s), self.batteries.power_w(t_s)
        self.share = self.share if share is None else share
        self.power_w = self.power_w if power_w is None else power_w

    def origin_of(self, frame: Frame) -> GlobalOrigin | None:
        """An origin for a common frame that has none yet, if this frame holds a place on the globe."""
        if frame.msgid not in (_ORIGIN, _HOME, _GLOBAL):
            return None
        content = codec.fields(frame)
        if frame.msgid == _GLOBAL:
            if not _is_place(content.lat, content.lon):
                return None
            return _origin(1e-7 * content.lat, 1e-7 * content.lon, 1e-3 * (content.alt - content.relative_alt))
        if not _is_place(content.latitude, content.longitude):
            return None
        return _origin_under(content) if frame.msgid == _HOME and self._home_is_local else _reported_origin(content)

    def seen(self, view: VehicleView) -> tuple[VehicleView, float | None]:
        """The fleet's view with what it could not know, and the share that the battery holds; None: not reported.

        A battery of unknown capacity holds that share of 100, its draw 0.
        """
        if not self._state_reported:
            flying = (mav.MAV_STATE_ACTIVE, mav.MAV_STATE_CRITICAL, mav.MAV_STATE_EMERGENCY)
            view = view._replace(landed=not (view.armed and self._system_status in flying))
        if math.isfinite(view.remaining_j) and view.capacity_j > 0.0:
            return view, view.remaining_j / view.capacity_j
        share = self.share
        view = view._replace(
            capacity_j=100.0,
            initial_j=100.0 * (1.0 if share is None else share),
            drawn_j=0.0,
            received_j=0,
            given_j=0,
            power_w=0.0,
            energy_source="none" if share is None else "battery_remaining",
        )
        return view, share

    def _receive_local(self, content: Any, t_s: float) -> Iterator[Frame]:
        at = (content.x, content.y, content.z)
        if not all(abs(axis) <= plausibility.FARTHEST_M for axis in at):
            return
        self._local = (t_s, at)
        if self._origin is None:
            return
        if self._reads != "local":
            self._reads = "local"
            yield self._origin_frame(self._origin)
        yield self._position(t_s, at, (content.vx, content.vy, content.vz))

    def _receive_global(self, content: Any, t_s: float, origin: GlobalOrigin | None) -> Iterator[Frame]:
        if origin is None or not _is_place(content.lat, content.lon):
            return
        lat_deg, lon_deg, alt_m = 1e-7 * content.lat, 1e-7 * content.lon, 1e-3 * content.alt
        if self._local is not None and t_s - self._local[0] <= TOGETHER_S:
            if self._origin is None:
                n, e, d = self._local[1]
                found = _origin(*pymap3d.ned2geodetic(-n, -e, -d, lat_deg, lon_deg, alt_m))
                self._origin = found if _can_be(found) else None
            return
        if self._reads != "global":
            self._reads = "global"
            yield self._origin_frame(origin)
        n, e, d = pymap3d.geodetic2ned(lat_deg, lon_deg, alt_m, origin.lat_deg, origin.lon_deg, origin.alt_m)
        v_ned = (0.01 * content.vx, 0.01 * content.vy, 0.01 * content.vz)
        yield self._position(t_s, (float(n), float(e), float(d)), v_ned)

    def _own(self, origin: GlobalOrigin) -> Iterator[Frame]:
        """Its local frame begins here, if it can."""
        if not _can_be(origin):
            return
        self._origin = origin
        if self._reads == "local":
            yield self._origin_frame(origin)

    def _receive_status(self, content: Any, t_s: float) -> None:
        """SYS_STATUS, which speaks of one battery, counts where no battery speaks for itself."""
        report = sys_status(content, t_s)
        if report.remaining is not None and self.batteries.share(t_s) is None:
            self.share = report.remaining
        if report.power_w is not None and self.batteries.power_w(t_s) is None:
            self.power_w = report.power_w

    def _position(self, t_s: float, at: Vec3, v_ned: Vec3) -> Frame:
        names = ("x", "y", "z", "vx", "vy", "vz")
        return self._frame(
            _LOCAL, time_boot_ms=round(1e3 * t_s) % (1 << 32), **dict(zip(names, (*at, *v_ned), strict=True))
        )

    def _origin_frame(self, origin: GlobalOrigin) -> Frame:
        return self._frame(
            _ORIGIN,
            latitude=round(1e7 * origin.lat_deg),
            longitude=round(1e7 * origin.lon_deg),
            altitude=round(1e3 * origin.alt_m),
        )

    def _frame(self, msgid: int, **fields: Any) -> Frame:
        return Frame(self.sysid, AUTOPILOT, 0, msgid, codec.encode(msgid, 0, self.sysid, AUTOPILOT, **fields))


def _is_place(lat: int, lon: int) -> bool:
    """Autopilots without a fix report 0, 0."""
    return (lat, lon) != (0, 0) and abs(lat) <= 900_000_000 and abs(lon) <= 1_800_000_000


def _can_be(origin: GlobalOrigin) -> bool:
    """Whether an origin is no farther up or down than anything is believed to be."""
    return abs(origin.alt_m) <= plausibility.FARTHEST_M


def _reported_origin(content: Any) -> GlobalOrigin:
    return _origin(1e-7 * content.latitude, 1e-7 * content.longitude, 1e-3 * content.altitude)


def _origin_under(home: Any) -> GlobalOrigin:
    """The origin of the local frame in which HOME_POSITION's x, y, z stand."""
    at = (home.x, home.y, home.z)
    at = at if all(abs(axis) <= plausibility.FARTHEST_M for axis in at) else (0.0, 0.0, 0.0)
    lat_deg, lon_deg, alt_m = 1e-7 * home.latitude, 1e-7 * home.longitude, 1e-3 * home.altitude
    return _origin(*pymap3d.ned2geodetic(-at[0], -at[1], -at[2], lat_deg, lon_deg, alt_m))


def _origin(lat_deg: Any, lon_deg: Any, alt_m: Any) -> GlobalOrigin:
    return GlobalOrigin(float(lat_deg), float(lon_deg), float(alt_m))
