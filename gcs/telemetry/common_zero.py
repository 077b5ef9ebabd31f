"""Where the common frame of a fleet begins that no scenario places: where the first vehicle's does, as high as the
first one that knows its height. It is decided again when that vehicle knows better.

A vehicle's own origin is waited for a while before its mere place. That may be none yet: an ArduPilot without a fix
drifts around 0, 0, and the height of its home follows from two heights that are filtered apart.
"""

from __future__ import annotations

from dataclasses import astuple, replace
from typing import NamedTuple

from gcs.mavlink.common_frame import frame_place
from gcs.telemetry.fleet import GlobalOrigin
from gcs.telemetry.place_claims import CLAIMS, GLOBAL, SEA_LEVEL_M, PlaceClaims
from skytender import elementary

ORIGIN_WITHIN_S = 3.0
FAR_M = 1000.0
"""A zero that was laid at a vehicle's mere place moves no shorter way to the one that it says. [choice]"""


class Moved(NamedTuple):
    """The zero's new place, and a sentence for the vehicle's events; None for the first one."""

    origin: GlobalOrigin
    why: str | None


class CommonZero:
    """The common frame's origin, None until it is known. Times are s."""

    def __init__(self, origin: GlobalOrigin | None = None) -> None:
        self.origin = origin
        self._fixed = self._height_known = origin is not None
        self._by: int | None = None
        """the vehicle at whose mere place it was laid"""
        self._since_s: dict[int, float] = {}

    def learn(self, sysid: int, claims: PlaceClaims, msgid: int, t_s: float) -> Moved | None:
        """Decide by what a vehicle has just claimed; None where the zero stays."""
        if self._fixed or msgid not in CLAIMS:
            return None
        moved = self._lay(sysid, claims, msgid, t_s) if self.origin is None else self._better(sysid, claims, msgid)
        if moved is not None:
            self.origin = moved.origin
        return moved

    def _lay(self, sysid: int, claims: PlaceClaims, msgid: int, t_s: float) -> Moved | None:
        early = t_s - self._since_s.setdefault(sysid, t_s) < ORIGIN_WITHIN_S
        origin = None if early and msgid == GLOBAL else claims.common_origin(msgid)
        if origin is None:
            return None
        self._height_known = claims.altitude_m is not None
        self._by = sysid if msgid == GLOBAL else None
        return Moved(origin, None)

    def _better(self, sysid: int, claims: PlaceClaims, msgid: int) -> Moved | None:
        said = claims.common_origin(msgid) if sysid == self._by and msgid != GLOBAL else None
        if said is not None:
            self._by, self._height_known = None, True
            return self._moved_to(said)
        if not self._height_known and claims.altitude_m is not None:
            self._height_known = True
            return self._raised("Knows its height above the sea", claims.altitude_m)
        return None

    def _moved_to(self, said: GlobalOrigin) -> Moved | None:
        assert self.origin is not None
        away_m = elementary.distance(frame_place(*astuple(said), *astuple(self.origin)).offset_ned[:2], (0.0, 0.0))
        if away_m > FAR_M:
            return Moved(said, f"Says where it begins: {round(away_m / 1e3)} km from its first position")
        if abs(said.alt_m - self.origin.alt_m) > SEA_LEVEL_M:
            return self._raised("Says how high it begins", said.alt_m)
        return None

    def _raised(self, why: str, alt_m: float) -> Moved:
        assert self.origin is not None
        zero = f"heights begin at {round(alt_m)} m, not at {round(self.origin.alt_m)} m"
        return Moved(replace(self.origin, alt_m=alt_m), f"{why}: {zero}")
