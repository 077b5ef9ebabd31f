"""How the scripted vehicles move, in a local frame of their own: a double integrator with limits."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

STEP_S = 0.02
GRAVITY_M_S2 = 9.80665
GAIN_1_S, VELOCITY_GAIN_1_S = 1.5, 5.0
YAW_RATE_RAD_S = 1.5

Vec3 = tuple[float, float, float]
ZERO: Vec3 = (0.0, 0.0, 0.0)


def limited(v: Sequence[float], most: float) -> Vec3:
    """A vector no longer than `most`."""
    scale = min(1.0, most / max(math.hypot(*v), 1e-12))
    return v[0] * scale, v[1] * scale, v[2] * scale


class Place:
    """The local frame: north, east, down in m from an origin; WGS 84's radii of curvature there."""

    def __init__(self, origin: Vec3) -> None:
        self.lat_deg, self.lon_deg, self.alt_m = origin
        a_m, e2 = 6378137.0, 6.69437999014e-3
        w = math.sqrt(1.0 - e2 * math.sin(math.radians(self.lat_deg)) ** 2)
        self.north_m_rad = a_m * (1.0 - e2) / w**3 + self.alt_m
        self.east_m_rad = (a_m / w + self.alt_m) * math.cos(math.radians(self.lat_deg))

    def to_global(self, p_ned: Vec3) -> tuple[int, int, float]:
        """Latitude and longitude in 1e-7 degrees, altitude in m above sea level."""
        lat_deg = self.lat_deg + math.degrees(p_ned[0] / self.north_m_rad)
        lon_deg = self.lon_deg + math.degrees(p_ned[1] / self.east_m_rad)
        return round(lat_deg * 1e7), round(lon_deg * 1e7), self.alt_m - p_ned[2]

    def to_local(self, lat_e7: float, lon_e7: float, alt_m: float) -> Vec3:
        north = math.radians(lat_e7 * 1e-7 - self.lat_deg) * self.north_m_rad
        return north, math.radians(lon_e7 * 1e-7 - self.lon_deg) * self.east_m_rad, self.alt_m - alt_m


@dataclass
class Body:
    """Position, velocity and acceleration in NED (m, s), yaw in rad; `ground_d` is how deep it can go."""

    p: Vec3
    ground_d: float
    v: Vec3 = ZERO
    a: Vec3 = ZERO
    yaw: float = 0.0

    @property
    def tilt(self) -> tuple[float, float]:
        """Roll and pitch, rad, that make its acceleration."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        forward, right = cos * self.a[0] + sin * self.a[1], cos * self.a[1] - sin * self.a[0]
        return math.atan2(right, GRAVITY_M_S2), -math.atan2(forward, GRAVITY_M_S2)

    def towards(self, place: Vec3, v: Vec3, speed_m_s: float, most_m_s2: float) -> Vec3:
        """The velocity for a place that itself moves at `v`: as fast as it can still brake at half of what it has."""
        error = [t - p for t, p in zip(place, self.p, strict=True)]
        stop_m_s = math.sqrt(most_m_s2 * math.hypot(*error))
        approach = limited([GAIN_1_S * e for e in error], min(speed_m_s, stop_m_s))
        return limited([a + b for a, b in zip(approach, v, strict=True)], speed_m_s)

    def follow(self, wanted: Vec3, most_m_s2: float) -> bool:
        """STEP_S towards a velocity; whether it stands on the ground after it."""
        self.a = limited([VELOCITY_GAIN_1_S * (w - v) for w, v in zip(wanted, self.v, strict=True)], most_m_s2)
        north, east, down = (v + a * STEP_S for v, a in zip(self.v, self.a, strict=True))
        self.v = (north, east, down)
        self.p = (self.p[0] + north * STEP_S, self.p[1] + east * STEP_S, self.p[2] + down * STEP_S)
        touched = self.p[2] >= self.ground_d and down > 0.0
        if touched:
            self.p = (self.p[0], self.p[1], self.ground_d)
            self.stop()
        return touched

    def stop(self) -> None:
        self.v = self.a = ZERO

    def turn(self, yaw: float) -> None:
        """STEP_S towards a yaw."""
        left = math.remainder(yaw - self.yaw, math.tau)
        self.yaw += math.copysign(min(abs(left), YAW_RATE_RAD_S * STEP_S), left)
