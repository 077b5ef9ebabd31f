"""How the scripted ArduCopter moves, in its own local frame: a double integrator with limits, and what it costs."""

from __future__ import annotations

import math
from collections.abc import Sequence

from pymavlink.dialects.v20 import ardupilotmega as mav

STEP_S = 0.02
HOVER_W, IDLE_W = 350.0, 6.0
FULL_V, EMPTY_V, NOMINAL_V = 16.8, 14.0, 14.8
GAIN_1_S, VELOCITY_GAIN_1_S = 1.5, 5.0
YAW_RATE_RAD_S = 1.5
THERE_M = 0.15

STABILIZE, GUIDED, LOITER, RTL, LAND, BRAKE = 0, 4, 5, 6, 9, 17
MODES = {STABILIZE: "STABILIZE", GUIDED: "GUIDED", LOITER: "LOITER", RTL: "RTL", LAND: "LAND", BRAKE: "BRAKE"}
INT8, INT16, INT32 = mav.MAV_PARAM_TYPE_INT8, mav.MAV_PARAM_TYPE_INT16, mav.MAV_PARAM_TYPE_INT32
REAL32 = mav.MAV_PARAM_TYPE_REAL32
PARAMETERS = {
    "ARMING_CHECK": (INT32, 1),
    "BATT_CAPACITY": (INT32, 0),
    "BATT_MONITOR": (INT8, 4),
    "DISARM_DELAY": (INT8, 10),
    "FRAME_CLASS": (INT8, 1),
    "GUID_TIMEOUT": (REAL32, 3.0),
    "LAND_SPEED": (INT16, 50),
    "LOG_BITMASK": (INT32, 176126),
    "PILOT_SPEED_UP": (INT16, 250),
    "RTL_ALT": (INT32, 1500),
    "SYSID_THISMAV": (INT16, 1),
    "WPNAV_ACCEL": (REAL32, 250.0),
    "WPNAV_SPEED": (REAL32, 500.0),
    "WPNAV_SPEED_DN": (REAL32, 150.0),
}

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


class Copter:
    """The vehicle without its telemetry: state, modes, and how it moves. Time is s since its start."""

    def __init__(self, start_ned: Vec3, battery_wh: float) -> None:
        self.now_s = 0.0
        self.p, self.v, self.a = start_ned, ZERO, ZERO
        self.home, self.yaw = start_ned, 0.0
        self.mode, self.armed, self.flying = STABILIZE, False, False
        self.armed_s = self.target_s = 0.0
        self.target_p: Vec3 | None = None
        self.target_v: Vec3 = ZERO
        self.target_yaw: float | None = None
        self.returning = False
        self.parameters = {name: float(value) for name, (_, value) in PARAMETERS.items()}
        self.parameters["BATT_CAPACITY"] = round(battery_wh / NOMINAL_V * 1000.0)
        self.used_mah = self.used_j = 0.0
        self.told: list[str] = []

    @property
    def remaining(self) -> float:
        """The share of the charge that is left."""
        return max(0.0, 1.0 - self.used_mah / self.parameters["BATT_CAPACITY"])

    @property
    def power_w(self) -> float:
        climb_w = -self.v[2] * 20.0 if self.v[2] < 0.0 else 0.0
        return HOVER_W + climb_w if self.flying else IDLE_W

    @property
    def volts(self) -> float:
        return EMPTY_V + (FULL_V - EMPTY_V) * self.remaining

    def enter(self, mode: int) -> bool:
        """Change the mode; False where it has none of that number."""
        if mode in MODES and mode != self.mode:
            self.mode, self.returning = mode, mode == RTL
            self.hold()
            if mode == RTL:
                high = min(self.p[2], self.home[2] - 0.01 * self.parameters["RTL_ALT"])
                self.target_p = (self.p[0], self.p[1], high)
        return mode in MODES

    def hold(self) -> None:
        """Stay where it stops."""
        self.target_p, self.target_v, self.target_yaw = None, ZERO, None

    def arm(self) -> None:
        self.armed, self.armed_s = True, self.now_s
        self.home = self.p

    def disarm(self) -> None:
        self.armed = self.flying = False
        self.v = self.a = ZERO

    def take_off(self, height_m: float) -> None:
        self.flying = True
        self.target_p, self.target_v = (self.p[0], self.p[1], self.home[2] - height_m), ZERO

    def aim(self, p: Vec3 | None, v: Vec3, yaw: float | None) -> None:
        """A set point; it flies to a place even when no more come, a velocity ends with the time-out."""
        self.target_p, self.target_v, self.target_yaw, self.target_s = p, v, yaw, self.now_s

    def step(self) -> None:
        """STEP_S of flight."""
        self.now_s += STEP_S
        self.used_mah += self.power_w / self.volts * STEP_S / 3.6
        self.used_j += self.power_w * STEP_S
        if self.armed and not self.flying and self.now_s - self.armed_s > self.parameters["DISARM_DELAY"]:
            self.disarm()
        if not self.flying:
            return
        if self.remaining <= 0.0 and self.mode != LAND:
            self.told.append("Battery 1 failsafe")
            self.enter(LAND)
        wanted = self._wanted_velocity()
        most = 0.01 * self.parameters["WPNAV_ACCEL"]
        self.a = limited([VELOCITY_GAIN_1_S * (w - v) for w, v in zip(wanted, self.v, strict=True)], most)
        self.v = tuple(v + a * STEP_S for v, a in zip(self.v, self.a, strict=True))  # type: ignore[assignment]
        self.p = tuple(p + v * STEP_S for p, v in zip(self.p, self.v, strict=True))  # type: ignore[assignment]
        if self.target_yaw is not None:
            turn = math.remainder(self.target_yaw - self.yaw, math.tau)
            self.yaw += math.copysign(min(abs(turn), YAW_RATE_RAD_S * STEP_S), turn)
        if self.p[2] >= self.home[2] and self.v[2] > 0.0:
            self.p, self.v, self.a = (self.p[0], self.p[1], self.home[2]), ZERO, ZERO
            if self.mode == LAND or (self.mode == RTL and not self.returning):
                self.told.append("Disarming motors")
                self.disarm()

    def _wanted_velocity(self) -> Vec3:
        if self.mode == RTL:
            self._return()
        if self.mode == LAND or (self.mode == RTL and not self.returning):
            high = self.home[2] - self.p[2] > 10.0
            down_m_s = 0.01 * (self.parameters["WPNAV_SPEED_DN"] if high else self.parameters["LAND_SPEED"])
            return 0.0, 0.0, down_m_s
        speed_m_s = 0.01 * self.parameters["WPNAV_SPEED"]
        late = self.mode == GUIDED and self.now_s - self.target_s > self.parameters["GUID_TIMEOUT"]
        v = ZERO if late else self.target_v
        if self.target_p is None:
            return limited(v, speed_m_s)
        error = [t - p for t, p in zip(self.target_p, self.p, strict=True)]
        # the fastest approach from which it can still brake at half its acceleration
        stop_m_s = math.sqrt(0.01 * self.parameters["WPNAV_ACCEL"] * math.hypot(*error))
        approach = limited([GAIN_1_S * e for e in error], min(speed_m_s, stop_m_s))
        wanted = limited([a + b for a, b in zip(approach, v, strict=True)], speed_m_s)
        up = 0.01 * self.parameters["PILOT_SPEED_UP"]
        return wanted[0], wanted[1], max(-up, min(wanted[2], 0.01 * self.parameters["WPNAV_SPEED_DN"]))

    def _return(self) -> None:
        """First up, then over home, then down."""
        if self.returning and self.target_p is not None and math.dist(self.p, self.target_p) < THERE_M:
            over_home = (self.home[0], self.home[1], self.target_p[2])
            self.returning = math.dist(self.target_p, over_home) > 1e-9
            self.target_p = over_home
