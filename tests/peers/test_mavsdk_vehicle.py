"""The vehicle of MAVSDK's server plugins by itself: pymavlink alone flies it."""

from __future__ import annotations

import math
import subprocess
from pathlib import Path

from pymavlink.dialects.v20 import common as mav
from station import ACCEPTED, POSITION, VELOCITY, Station

PROGRAM = Path(__file__).with_name("mavsdk_vehicle.py")
OFFBOARD, RETURN, LAND = 6 << 16, 4 << 16 | 5 << 24, 4 << 16 | 6 << 24
CUSTOM = 1.0


def test_a_px4_of_mavsdk_is_armed_taken_off_flown_and_landed(peers: Path) -> None:
    with Station(9) as station:
        argv = ["--sysid", "9", "--connect", f"udpout:127.0.0.1:{station.port}", "--refuse-arming-s", "2"]
        argv += ["--origin", "47.4,8.5,400", "--start", "1,2,0"]
        with subprocess.Popen(
            [str(peers / "python"), str(PROGRAM), *argv], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL
        ) as vehicle:
            try:
                fly(station)
            finally:
                vehicle.communicate(timeout=10.0)
    assert vehicle.returncode == 0


def fly(station: Station) -> None:
    beat = station.hear("HEARTBEAT")
    assert (beat.autopilot, beat.type) == (mav.MAV_AUTOPILOT_PX4, mav.MAV_TYPE_QUADROTOR)
    arm = mav.MAV_CMD_COMPONENT_ARM_DISARM
    assert station.command(arm, 1, until=None) == mav.MAV_RESULT_TEMPORARILY_REJECTED
    station.hear("STATUSTEXT", lambda m: m.text.startswith("Preflight Fail"))
    origin = station.hear("GPS_GLOBAL_ORIGIN")
    assert (origin.latitude, origin.longitude, origin.altitude) == (474000000, 85000000, 400000)
    station.command(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_HOME_POSITION)
    assert station.all_of("HOME_POSITION")[-1].altitude == 400000
    battery = station.hear("BATTERY_STATUS")
    assert (battery.energy_consumed, battery.current_battery) == (-1, -1)
    assert 90 < battery.battery_remaining <= 100
    assert station.command(mav.MAV_CMD_USER_1, 1, until=None) == mav.MAV_RESULT_UNSUPPORTED
    offboard = mav.MAV_CMD_DO_SET_MODE, CUSTOM, 6
    assert station.command(*offboard, until=None) != ACCEPTED
    station.command(arm, 1)
    station.hear("HEARTBEAT", lambda m: m.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED)
    station.command(mav.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, math.nan, math.nan, math.nan, 401.5)
    station.hear("EXTENDED_SYS_STATE", lambda m: m.landed_state == mav.MAV_LANDED_STATE_IN_AIR)
    station.hear("LOCAL_POSITION_NED", there(1.0, 2.0, -1.5))
    station.aim(POSITION, (2.0, 1.0, -1.5))
    station.command(*offboard)
    station.hear("HEARTBEAT", lambda m: m.custom_mode == OFFBOARD)
    station.hear("LOCAL_POSITION_NED", there(2.0, 1.0, -1.5))
    station.aim(VELOCITY, (0.0, 1.0, 0.0))
    station.hear("LOCAL_POSITION_NED", lambda m: abs(m.vy - 1.0) < 0.1)
    station.set_point = None
    station.hear("HEARTBEAT", lambda m: m.custom_mode == RETURN)
    station.aim(POSITION, (2.0, 1.0, -1.5))
    station.hear("HEARTBEAT", lambda m: m.custom_mode == OFFBOARD)
    station.command(mav.MAV_CMD_NAV_LAND)
    station.hear("HEARTBEAT", lambda m: m.custom_mode == LAND)
    station.hear("HEARTBEAT", lambda m: not m.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED)


def there(*wanted: float) -> object:
    return lambda m: math.dist((m.x, m.y, m.z), wanted) < 0.3
