"""The scripted ArduCopter without a word of MAVLink: its modes, what it flies in each, and what that costs."""

from __future__ import annotations

import math

from motion import STEP_S, ZERO, Body, Vec3, limited
from pymavlink.dialects.v20 import ardupilotmega as mav

HOVER_W, IDLE_W = 350.0, 6.0
FULL_V, EMPTY_V, NOMINAL_V = 16.8, 14.0, 14.8
THERE_M = 0.15
LIFTS_AFTER_S = 3.0
"""From arming until it can leave the ground: two seconds of delay, and its motors' spooling up."""
RUNTIME_EVERY_S = 30.0

STABILIZE, GUIDED, LOITER, RTL, LAND, BRAKE = 0, 4, 5, 6, 9, 17
MODES = {STABILIZE: "STABILIZE", GUIDED: "GUIDED", LOITER: "LOITER", RTL: "RTL", LAND: "LAND", BRAKE: "BRAKE"}
INT8, INT16, INT32 = mav.MAV_PARAM_TYPE_INT8, mav.MAV_PARAM_TYPE_INT16, mav.MAV_PARAM_TYPE_INT32
REAL32 = mav.MAV_PARAM_TYPE_REAL32
PARAMETERS = {
    "AHRS_EKF_TYPE": (INT8, 3),
    "ARMING_CHECK": (INT32, 1),
    "BATT_CAPACITY": (INT32, 0),
    "BATT_MONITOR": (INT8, 4),
    "DISARM_DELAY": (INT8, 10),
    "FS_GCS_ENABLE": (INT8, 0),
    "FS_GCS_TIMEOUT": (REAL32, 5.0),
    "FENCE_AUTOENABLE": (INT8, 0),
    "FENCE_ENABLE": (INT8, 0),
    "FRAME_CLASS": (INT8, 1),
    "GUID_TIMEOUT": (REAL32, 3.0),
    "LAND_SPEED": (INT16, 50),
    "LOG_BITMASK": (INT32, 176126),
    "PILOT_SPEED_UP": (INT16, 250),
    "RTL_ALT": (INT32, 1500),
    "RTL_CLIMB_MIN": (INT16, 0),
    "RTL_CONE_SLOPE": (REAL32, 3.0),
    "RTL_LOIT_TIME": (INT32, 5000),
    "STAT_RUNTIME": (INT32, 0),
    "SYSID_THISMAV": (INT16, 1),
    "WPNAV_ACCEL": (REAL32, 250.0),
    "WPNAV_SPEED": (REAL32, 500.0),
    "WPNAV_SPEED_DN": (REAL32, 150.0),
}
SHALLOWEST_CONE, LEAST_CLIMB_M = 0.5, 2.5
"""RTL_MIN_CONE_SLOPE; RTL_ABS_MIN_CLIMB, 2.5 m."""


class Copter:
    """The vehicle without its telemetry: state, modes, and how it moves. Time is s since its start."""

    def __init__(self, start_ned: Vec3, battery_wh: float) -> None:
        self.now_s = 0.0
        self.body = Body(start_ned, start_ned[2])
        self.home = start_ned
        self.mode, self.armed, self.flying = STABILIZE, False, False
        self.armed_s = self.target_s = 0.0
        self.target_p: Vec3 | None = None
        self.target_v: Vec3 = ZERO
        self.target_yaw: float | None = None
        self.returning = False
        self.over_home_s: float | None = None
        """since when it waits there before it comes down"""
        self.station_s: float | None = None
        """when the last HEARTBEAT of its ground station came"""
        self.lift_m: float | None = None
        """the height of a take-off that has been accepted and has not left the ground yet"""
        self.climbing = False
        self.parameters = {name: float(value) for name, (_, value) in PARAMETERS.items()}
        self.parameters["BATT_CAPACITY"] = round(battery_wh / NOMINAL_V * 1000.0)
        self.used_mah = self.used_j = 0.0
        self.told: list[str] = []

    @property
    def remaining(self) -> float:
        """The share of the charge that is left."""
        return max(0.0, 1.0 - self.used_mah / self.parameters["BATT_CAPACITY"])

    @property
    def landing(self) -> bool:
        """Whether it goes down to land."""
        return self.flying and (self.mode == LAND or (self.mode == RTL and not self.returning))

    @property
    def power_w(self) -> float:
        climb_w = -self.body.v[2] * 20.0 if self.body.v[2] < 0.0 else 0.0
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
                self.over_home_s = None
                self.target_p = (self.body.p[0], self.body.p[1], self.home[2] - self._return_height_m())
        return mode in MODES

    def _return_height_m(self) -> float:
        """Above home: no lower than it is, and near home no higher than the cone over it lets it."""
        own_m, values = self.home[2] - self.body.p[2], self.parameters
        high_m = max(own_m + max(0.0, 0.01 * values["RTL_CLIMB_MIN"]), 0.01 * values["RTL_ALT"])
        if values["RTL_CONE_SLOPE"] >= SHALLOWEST_CONE:
            away_m = math.dist(self.body.p[:2], self.home[:2])
            high_m = min(high_m, max(away_m * values["RTL_CONE_SLOPE"], own_m + LEAST_CLIMB_M))
        return max(own_m, high_m)

    def hold(self) -> None:
        """Stay where it stops."""
        self.lift_m, self.climbing = None, False
        self.target_p, self.target_v, self.target_yaw = None, ZERO, None

    def arm(self) -> None:
        self.armed, self.armed_s = True, self.now_s
        self.home = self.body.p

    def disarm(self) -> None:
        self.armed = self.flying = self.climbing = False
        self.lift_m = None
        self.body.stop()

    def take_off(self, height_m: float) -> None:
        """As soon as its motors let it; until then it can be told so again."""
        self.lift_m = height_m

    def _lift(self, height_m: float) -> None:
        self.flying = self.climbing = True
        self.lift_m = None
        self.target_p, self.target_v = (self.body.p[0], self.body.p[1], self.home[2] - height_m), ZERO

    def aim(self, p: Vec3 | None, v: Vec3, yaw: float | None) -> None:
        """A set point; it flies to a place even when no more come, a velocity ends with the time-out."""
        self.climbing = False
        self.target_p, self.target_v, self.target_yaw, self.target_s = p, v, yaw, self.now_s

    def step(self) -> None:
        """STEP_S of flight."""
        self.now_s += STEP_S
        self.used_mah += self.power_w / self.volts * STEP_S / 3.6
        self.used_j += self.power_w * STEP_S
        if self.armed and not self.flying and self.now_s - self.armed_s > self.parameters["DISARM_DELAY"]:
            self.disarm()
        if self.lift_m is not None and self.now_s - self.armed_s >= LIFTS_AFTER_S:
            self._lift(self.lift_m)
        if not self.flying:
            return
        self.climbing = self.climbing and math.dist(self.body.p, self.target_p or self.body.p) > THERE_M
        if self.remaining <= 0.0 and self.mode != LAND:
            self.told.append("Battery 1 failsafe")
            self.enter(LAND)
        silent_s = 0.0 if self.station_s is None else self.now_s - self.station_s
        lost = self.parameters["FS_GCS_ENABLE"] == 1 and silent_s > self.parameters["FS_GCS_TIMEOUT"]
        if lost and self.mode not in (RTL, LAND):
            self.told.append("GCS Failsafe")
            self.enter(RTL)
        if self.target_yaw is not None:
            self.body.turn(self.target_yaw)
        down = self.landing
        if self.body.follow(self._wanted_velocity(), 0.01 * self.parameters["WPNAV_ACCEL"]) and down:
            self.told.append("Disarming motors")
            self.disarm()

    def _wanted_velocity(self) -> Vec3:
        if self.mode == RTL:
            self._return()
        if self.landing:
            high = self.home[2] - self.body.p[2] > 10.0
            down_m_s = 0.01 * (self.parameters["WPNAV_SPEED_DN"] if high else self.parameters["LAND_SPEED"])
            return 0.0, 0.0, down_m_s
        speed_m_s = 0.01 * self.parameters["WPNAV_SPEED"]
        late = (
            self.mode == GUIDED and not self.climbing and self.now_s - self.target_s > self.parameters["GUID_TIMEOUT"]
        )
        v = ZERO if late else self.target_v
        if self.target_p is None:
            return limited(v, speed_m_s)
        wanted = self.body.towards(self.target_p, v, speed_m_s, 0.01 * self.parameters["WPNAV_ACCEL"])
        up = 0.01 * self.parameters["PILOT_SPEED_UP"]
        return wanted[0], wanted[1], max(-up, min(wanted[2], 0.01 * self.parameters["WPNAV_SPEED_DN"]))

    def _return(self) -> None:
        """First up, then over home, a while there, then down."""
        if not self.returning or self.target_p is None or math.dist(self.body.p, self.target_p) >= THERE_M:
            return
        over_home = (self.home[0], self.home[1], self.target_p[2])
        if math.dist(self.target_p, over_home) > 1e-9:
            self.target_p = over_home
            return
        self.over_home_s = self.now_s if self.over_home_s is None else self.over_home_s
        self.returning = self.now_s - self.over_home_s < 0.001 * self.parameters["RTL_LOIT_TIME"]
