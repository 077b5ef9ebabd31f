"""What the scripted ArduCopter tells of itself: a message of pymavlink's for each name that it knows."""

from __future__ import annotations

import argparse
import math
import time
from typing import Any

from arducopter_motion import Copter
from motion import ZERO, Place
from pymavlink.dialects.v20 import ardupilotmega as mav


class Telemetry:
    """Builds each message from the vehicle as it is; None where it has nothing to put in it yet."""

    def __init__(self, copter: Copter, options: argparse.Namespace) -> None:
        self.copter = copter
        self.options = options
        self.place = Place(options.origin)
        self._unix_s = time.time()

    def knows(self, name: str) -> bool:
        """Whether there is a message of this name."""
        return hasattr(self, f"_{name.lower()}")

    def message(self, name: str) -> Any:
        """A message by its MAVLink name; None where it has none, or nothing to put in it yet."""
        return getattr(self, f"_{name.lower()}", lambda: None)()

    @property
    def _ms(self) -> int:
        return round(1000.0 * self.copter.now_s)

    @property
    def has_origin(self) -> bool:
        return self.copter.now_s >= 0.25 * self.options.refuse_arming_s

    @property
    def looks_ready(self) -> bool:
        """The pre-arm bit, which is set before arming really works."""
        return self.copter.now_s >= 0.6 * self.options.refuse_arming_s

    def _heartbeat(self) -> Any:
        custom, armed = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, mav.MAV_MODE_FLAG_SAFETY_ARMED
        base = custom | (armed if self.copter.armed else 0)
        state = mav.MAV_STATE_ACTIVE if self.copter.armed else mav.MAV_STATE_STANDBY
        kind, autopilot = mav.MAV_TYPE_QUADROTOR, mav.MAV_AUTOPILOT_ARDUPILOTMEGA
        return mav.MAVLink_heartbeat_message(kind, autopilot, base, self.copter.mode, state, 3)

    def _sys_status(self) -> Any:
        sensors = 0x3 | 0x4 | 0x8 | mav.MAV_SYS_STATUS_SENSOR_GPS | mav.MAV_SYS_STATUS_SENSOR_BATTERY
        sensors |= mav.MAV_SYS_STATUS_PREARM_CHECK | mav.MAV_SYS_STATUS_GEOFENCE
        healthy = sensors if self.looks_ready else sensors & ~mav.MAV_SYS_STATUS_PREARM_CHECK
        volts, amps = self.copter.volts, self.copter.power_w / self.copter.volts
        percent = math.floor(100.0 * self.copter.remaining)
        return mav.MAVLink_sys_status_message(
            sensors, sensors, healthy, 100, round(1000 * volts), round(100 * amps), percent, 0, 0, 0, 0, 0, 0
        )

    def _battery_status(self) -> Any:
        copter, told = self.copter, self.options.battery_told
        measured = told != "remaining"
        cells = [round(1000.0 * copter.volts), *[65535] * 9] if measured else [65535] * 10
        return mav.MAVLink_battery_status_message(
            id=0,
            battery_function=mav.MAV_BATTERY_FUNCTION_ALL,
            type=mav.MAV_BATTERY_TYPE_LIPO,
            temperature=32767,
            voltages=cells,
            current_battery=round(100.0 * copter.power_w / copter.volts) if measured else -1,
            current_consumed=round(copter.used_mah) if measured else -1,
            energy_consumed=round(copter.used_j / 100.0) if told == "energy" else -1,
            battery_remaining=math.floor(100.0 * copter.remaining),
        )

    def _attitude(self) -> Any:
        roll, pitch = self.copter.body.tilt
        yaw = math.remainder(self.copter.body.yaw, math.tau)
        return mav.MAVLink_attitude_message(self._ms, roll, pitch, yaw, 0.0, 0.0, 0.0)

    def _local_position_ned(self) -> Any:
        if not self.has_origin:
            return None
        p = self.copter.body.p
        if self.options.lies and self.copter.flying:
            p = (3.0e38, -3.0e38 if self._ms % 2 else 3.0e38, p[2])
        return mav.MAVLink_local_position_ned_message(self._ms, *p, *self.copter.body.v)

    def _global_position_int(self) -> Any:
        if not self.has_origin:
            return mav.MAVLink_global_position_int_message(self._ms, 0, 0, 0, 0, 0, 0, 0, 0)
        lat, lon, alt_m = self.place.to_global(self.copter.body.p)
        v_cm_s = [round(100.0 * v) for v in self.copter.body.v]
        above_mm = round(1000.0 * (self.copter.home[2] - self.copter.body.p[2]))
        heading = round(100.0 * math.degrees(self.copter.body.yaw)) % 36000
        return mav.MAVLink_global_position_int_message(
            self._ms, lat, lon, round(1000.0 * alt_m), above_mm, *v_cm_s, heading
        )

    def _gps_raw_int(self) -> Any:
        lat, lon, alt_m = self.place.to_global(self.copter.body.p)
        us, alt_mm = 1000 * self._ms, round(1000.0 * alt_m)
        return mav.MAVLink_gps_raw_int_message(us, 6, lat, lon, alt_mm, 121, 200, 65535, 65535, 10)

    def _extended_sys_state(self) -> Any:
        state = mav.MAV_LANDED_STATE_IN_AIR
        if not self.copter.flying:
            state = mav.MAV_LANDED_STATE_ON_GROUND
        elif self.copter.landing:
            state = mav.MAV_LANDED_STATE_LANDING
        elif self.copter.climbing:
            state = mav.MAV_LANDED_STATE_TAKEOFF
        return mav.MAVLink_extended_sys_state_message(0, state)

    def _vfr_hud(self) -> Any:
        speed_m_s = math.hypot(*self.copter.body.v[:2])
        heading, alt_m = round(math.degrees(self.copter.body.yaw)) % 360, self.place.to_global(self.copter.body.p)[2]
        return mav.MAVLink_vfr_hud_message(speed_m_s, speed_m_s, heading, 35, alt_m, -self.copter.body.v[2])

    def _mission_current(self) -> Any:
        return mav.MAVLink_mission_current_message(0)

    def _system_time(self) -> Any:
        return mav.MAVLink_system_time_message(round(1e6 * (self._unix_s + self.copter.now_s)), self._ms)

    def _home_position(self) -> Any:
        if not self.has_origin:
            return None
        lat, lon, alt_m = self.place.to_global(self.copter.home)
        return mav.MAVLink_home_position_message(
            lat, lon, round(1000.0 * alt_m), *self.copter.home, [1.0, 0.0, 0.0, 0.0], 0.0, 0.0, 0.0, 1000 * self._ms
        )

    def _gps_global_origin(self) -> Any:
        if not self.has_origin:
            return None
        lat, lon, alt_m = self.place.to_global(ZERO)
        return mav.MAVLink_gps_global_origin_message(lat, lon, round(1000.0 * alt_m), 1000 * self._ms)

    def _autopilot_version(self) -> Any:
        can = mav.MAV_PROTOCOL_CAPABILITY_MAVLINK2 | mav.MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT
        can |= mav.MAV_PROTOCOL_CAPABILITY_MISSION_INT | mav.MAV_PROTOCOL_CAPABILITY_MISSION_FLOAT
        can |= mav.MAV_PROTOCOL_CAPABILITY_COMMAND_INT | mav.MAV_PROTOCOL_CAPABILITY_SET_POSITION_TARGET_LOCAL_NED
        release, none = 4 << 24 | 6 << 16 | 0 << 8 | 255, [0] * 8
        return mav.MAVLink_autopilot_version_message(can, release, 0, 0, 0, none, none, none, 0, 0, self.options.sysid)
