"""Where a vehicle is, by all that it says of it: each claim is kept in its own words, and what it means is decided anew
whenever another one comes.

GLOBAL_POSITION_INT names the place itself. LOCAL_POSITION_NED needs the origin of the vehicle's own frame, which is,
the better before the worse:

1. what GPS_GLOBAL_ORIGIN says;
2. what follows from HOME_POSITION, of an autopilot whose x, y, z there stand in that frame;
3. what follows from a global position beside a local one; of several pairs, from that nearest in time.

The local position is finer and is shown, while it comes. A global position beside it is its judge: if they lie more
than AGREE_M apart, its origin is not what it was, and the global one is shown; without a judge the place is uncertain
from a jump of the local position on until the origin is said again.

An autopilot that has not found its height above the sea sends as `alt` what the barometer says above the place where it
was switched on, and its home then lies at sea level by both heights of the message. Such a height is believed where
the vehicle's origin or home lies there too, or where its satellites say the same height: it is at the coast. Else the
place is uncertain, and is shown as high as it says that it is above its home. A vehicle that boots begins with a new
frame, and its old one is uncertain until it says so again.
"""

from __future__ import annotations

import math
from dataclasses import astuple
from enum import IntEnum
from typing import Any, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.boot_clock import BootClock
from gcs.mavlink.common_frame import FramePlace, frame_place, origin_under, turned
from gcs.telemetry import plausibility
from gcs.telemetry.fleet import GlobalOrigin
from gcs.telemetry.state import Vec3
from skytender import elementary
from skytender import mavlink as mav

TOGETHER_S = 1.0
"""A local and a global position that came within this time are held against each other."""
AGREE_M = plausibility.JUMP_M
"""Two claims of one place that are no farther apart agree: positions are as of different moments, and corrected."""
TURNS_M_S2 = 20.0
"""By no more a vehicle's velocity changes between two local positions. [choice]"""
SEA_LEVEL_M = 1.0
"""A home so near to height 0 may be one that the vehicle does not know yet; its two heights are rounded and filtered
apart."""
HEIGHT_UNKNOWN = "it does not know its height above the sea yet"
BOOTED = "it has booted, and has not said since where its frame lies"
CONTRADICTED = "its frame lies elsewhere than it says, by its last global position"
JUMPED = "its local position jumps: where its frame lies it has not said since"
ATTITUDE = codec.msgid("ATTITUDE")
LOCAL = codec.msgid("LOCAL_POSITION_NED")
GLOBAL = codec.msgid("GLOBAL_POSITION_INT")
ORIGIN = codec.msgid("GPS_GLOBAL_ORIGIN")
HOME = codec.msgid("HOME_POSITION")
SATELLITES = codec.msgid("GPS_RAW_INT")
CLAIMS = frozenset({LOCAL, GLOBAL, ORIGIN, HOME})


class ClaimedPlace(NamedTuple):
    """A place and a velocity (m, m/s) in the common frame, and why it is uncertain; empty where it is not."""

    at_ned: Vec3
    v_ned: Vec3
    uncertain: str


class _Local(NamedTuple):
    t_s: float
    boot_s: float
    at: Vec3
    v: Vec3


class _Global(NamedTuple):
    t_s: float
    boot_s: float
    where: GlobalOrigin
    above_home_m: float
    v: Vec3

    @property
    def home_alt_m(self) -> float:
        return self.where.alt_m - self.above_home_m


class _By(IntEnum):
    """By which word the origin is known, the best last."""

    NONE = 0
    EARLIER_BOOT = 1
    PAIR = 2
    HOME = 3
    REPORT = 4


class PlaceClaims:
    """One vehicle's words of its place. Times are s."""

    def __init__(self) -> None:
        self._clock = BootClock()
        self._local: _Local | None = None
        self._global: _Global | None = None
        self._home: Any = None
        self._home_is_local = False
        self._satellites: tuple[float, float] | None = None
        """when satellites gave a height above the sea, and which"""
        self._at_coast = False
        """whether they gave the height that a home at sea level gives"""
        self._origin: GlobalOrigin | None = None
        self._by = _By.NONE
        self._skew_s = math.inf
        """between the two positions of the pair that the origin follows from"""
        self._doubt = ""
        """why its frame may not begin at that origin"""
        self._seen: tuple[GlobalOrigin | None, GlobalOrigin] | None = None
        self._frame: FramePlace | None = None

    @property
    def altitude_m(self) -> float | None:
        """Height above the sea of its origin or home, whichever it knows; None while it knows none."""
        if self._by >= _By.PAIR and self._origin is not None:
            return self._origin.alt_m
        if self._home is not None:
            return 1e-3 * float(self._home.altitude)
        if self._global is not None and self._is_above_sea(self._global):
            return self._global.home_alt_m
        return None

    def identify(self, *, home_is_local: bool) -> None:
        """Take in whether HOME_POSITION's x, y, z stand in its frame, as its HEARTBEAT shows."""
        if home_is_local != self._home_is_local:
            self._home_is_local = home_is_local
            if home_is_local:
                self._offer_home()
            elif self._by is _By.HOME:
                self._origin, self._by = None, _By.NONE

    def booted(self, msgid: int, boot_ms: int, t_s: float) -> None:
        """Take in its own time in a message; a new boot leaves nothing certain."""
        if self._clock.feed(msgid, boot_ms / 1e3, t_s):
            self._local = self._global = self._home = self._satellites = None
            self._at_coast = False
            self._by = _By.NONE if self._origin is None else _By.EARLIER_BOOT
            self._skew_s, self._doubt = math.inf, ""

    def receive(self, msgid: int, content: Any, t_s: float) -> bool:
        """Take in one of CLAIMS that came at `t_s`; whether it names a place."""
        if msgid == LOCAL:
            return self._receive_local(content, t_s)
        if msgid == GLOBAL:
            return self._receive_global(content, t_s)
        if not is_place(content.latitude, content.longitude) or abs(content.altitude) > 1e3 * plausibility.FARTHEST_M:
            return False
        if msgid == HOME:
            self._home = content
            self._offer_home()
        else:
            self._offer(reported(content), _By.REPORT)
        return False

    def judge_by_satellites(self, content: Any, t_s: float) -> None:
        """Take in a GPS_RAW_INT, which judges heights, and places nothing."""
        if content.fix_type >= mav.GPS_FIX_TYPE_3D_FIX and is_place(content.lat, content.lon):
            self._satellites = t_s, 1e-3 * content.alt

    def common_origin(self, msgid: int) -> GlobalOrigin | None:
        """An origin for a common frame that has none, by the last message of this kind."""
        if msgid == GLOBAL and self._global is not None:
            where = self._global.where
            return GlobalOrigin(where.lat_deg, where.lon_deg, self._global.home_alt_m)
        if msgid == HOME and self._home is not None and self._by is not _By.HOME:
            return reported(self._home)
        return self._origin if msgid in (HOME, ORIGIN) and self._by >= _By.HOME else None

    def frame(self, common: GlobalOrigin) -> FramePlace | None:
        """Where its own frame lies in the common one; None while that is unknown."""
        if self._seen != (self._origin, common):
            self._seen = self._origin, common
            self._frame = None if self._origin is None else frame_place(*astuple(self._origin), *astuple(common))
        return self._frame

    def place(self, common: GlobalOrigin, now_s: float) -> ClaimedPlace | None:
        """Where it is by the message that has just come, at `now_s`; None where that brings nothing new."""
        local, globe, frame = self._local, self._global, self.frame(common)
        judged = globe is not None and now_s - globe.t_s <= TOGETHER_S
        if local is None or frame is None or now_s - local.t_s > TOGETHER_S:
            return self._global_place(globe, common) if globe is not None and globe.t_s == now_s else None
        at, v = _added(turned(local.at, frame.turn_rad), frame.offset_ned), turned(local.v, frame.turn_rad)
        if judged and globe is not None:
            self._doubt = "" if self._agree(ClaimedPlace(at, v, ""), local, globe, common) else CONTRADICTED
            if self._doubt:
                self._skew_s = math.inf  # the next pair is a better one
                return self._global_place(globe, common) if globe.t_s == now_s else None
        if local.t_s != now_s:
            return None
        return ClaimedPlace(at, v, BOOTED if self._by is _By.EARLIER_BOOT else self._doubt)

    def _receive_local(self, content: Any, t_s: float) -> bool:
        at, v = (content.x, content.y, content.z), (content.vx, content.vy, content.vz)
        if not all(abs(axis) <= plausibility.FARTHEST_M for axis in at):
            return False
        before, local = self._local, _Local(t_s, content.time_boot_ms / 1e3, at, v)
        if before is not None and local.boot_s < before.boot_s:
            return False
        if before is not None and not _flown(before, local):
            self._doubt = JUMPED
        self._local = local
        self._offer_pair()
        return True

    def _receive_global(self, content: Any, t_s: float) -> bool:
        if not is_place(content.lat, content.lon) or abs(content.alt) > 1e3 * plausibility.FARTHEST_M:
            return False
        boot_s = content.time_boot_ms / 1e3
        if self._global is not None and boot_s < self._global.boot_s:
            return False
        where = GlobalOrigin(1e-7 * content.lat, 1e-7 * content.lon, 1e-3 * content.alt)
        v = (0.01 * content.vx, 0.01 * content.vy, 0.01 * content.vz)
        self._global = _Global(t_s, boot_s, where, 1e-3 * content.relative_alt, v)
        self._offer_pair()
        return True

    def _offer_home(self) -> None:
        home = self._home
        if home is None or not self._home_is_local:
            return
        at = (home.x, home.y, home.z)
        at = at if all(abs(axis) <= plausibility.FARTHEST_M for axis in at) else (0.0, 0.0, 0.0)
        self._offer(_under(reported(home), at), _By.HOME)

    def _offer_pair(self) -> None:
        local, globe = self._local, self._global
        if local is None or globe is None or abs(local.t_s - globe.t_s) > TOGETHER_S or self._by > _By.PAIR:
            return
        ahead_s = _ahead_s(local, globe)
        if not self._is_above_sea(globe) or (self._by is _By.PAIR and abs(ahead_s) >= self._skew_s):
            return
        at = _added(local.at, tuple(-ahead_s * axis for axis in local.v))
        self._offer(_under(globe.where, at), _By.PAIR)
        self._skew_s = abs(ahead_s)

    def _offer(self, origin: GlobalOrigin, by: _By) -> None:
        """Take an origin, unless a better one is known or it cannot be; positions by another one were of that."""
        if by < self._by or not abs(origin.alt_m) <= plausibility.FARTHEST_M:
            return
        if by is not _By.PAIR and origin != self._origin:
            self._local, self._doubt = None, ""
        elif self._doubt == JUMPED:
            self._doubt = ""
        self._origin, self._by = origin, by

    def _is_above_sea(self, globe: _Global) -> bool:
        """Whether a global position's height is known to be counted from the sea."""
        home_m, alt_m = globe.home_alt_m, globe.where.alt_m
        if abs(home_m) > SEA_LEVEL_M:
            return True
        known = [] if self._home is None else [1e-3 * self._home.altitude]
        if self._by >= _By.HOME and self._origin is not None:
            known.append(self._origin.alt_m)
        if self._satellites is not None and abs(globe.t_s - self._satellites[0]) <= TOGETHER_S:
            self._at_coast = self._at_coast or abs(alt_m - self._satellites[1]) <= AGREE_M
        return self._at_coast or any(min(abs(known_m - home_m), abs(known_m - alt_m)) <= AGREE_M for known_m in known)

    def _agree(self, by_local: ClaimedPlace, local: _Local, globe: _Global, common: GlobalOrigin) -> bool:
        ahead_s = _ahead_s(local, globe)
        there = self._global_place(globe, common)
        axes = 2 if there.uncertain else 3
        there_now = _added(there.at_ned, tuple(ahead_s * axis for axis in there.v_ned))
        return elementary.distance(by_local.at_ned[:axes], there_now[:axes]) <= AGREE_M

    def _global_place(self, globe: _Global, common: GlobalOrigin) -> ClaimedPlace:
        frame = frame_place(*astuple(globe.where), *astuple(common))
        north, east, down = frame.offset_ned
        v = turned(globe.v, frame.turn_rad)
        if self._is_above_sea(globe):
            return ClaimedPlace((north, east, down), v, "")
        return ClaimedPlace((north, east, -globe.above_home_m), v, HEIGHT_UNKNOWN)


def is_place(lat_e7: int, lon_e7: int) -> bool:
    """Whether degE7 are a place on the globe; autopilots without a fix report 0, 0."""
    return (lat_e7, lon_e7) != (0, 0) and abs(lat_e7) <= 900_000_000 and abs(lon_e7) <= 1_800_000_000


def reported(content: Any) -> GlobalOrigin:
    """The place in a GPS_GLOBAL_ORIGIN or a HOME_POSITION."""
    return GlobalOrigin(1e-7 * content.latitude, 1e-7 * content.longitude, 1e-3 * content.altitude)


def _under(where: GlobalOrigin, at: Vec3) -> GlobalOrigin:
    return GlobalOrigin(*origin_under(where.lat_deg, where.lon_deg, where.alt_m, at))


def _flown(before: _Local, after: _Local) -> bool:
    """Whether a vehicle can have come from one local position to the next one, by the velocities that it says."""
    elapsed_s = after.t_s - before.t_s
    mean_v = [(a + b) / 2.0 for a, b in zip(before.v, after.v, strict=True)]
    there = _added(before.at, tuple(elapsed_s * axis for axis in mean_v))
    return elementary.distance(there, after.at) <= AGREE_M + TURNS_M_S2 * elapsed_s * elapsed_s / 2.0


def _ahead_s(local: _Local, globe: _Global) -> float:
    """How much later the local position is than the global one: by the vehicle's clock, where it fills in both."""
    by_vehicle_s = local.boot_s - globe.boot_s
    filled = local.boot_s > 0.0 and globe.boot_s > 0.0 and abs(by_vehicle_s) <= 2.0 * TOGETHER_S
    return by_vehicle_s if filled else local.t_s - globe.t_s


def _added(a: Vec3, b: tuple[float, ...]) -> Vec3:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
