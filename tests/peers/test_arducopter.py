"""The scripted ArduCopter by itself: pymavlink alone flies it, and it keeps to ArduCopter's habits."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav
from station import ACCEPTED, POSITION, VELOCITY, Station

PROGRAM = Path(__file__).with_name("arducopter.py")
GUIDED, RTL, LAND = 4, 6, 9
CUSTOM = 1.0
QUICK = ("--param", "LAND_SPEED=200", "--param", "RTL_ALT=100")
pytestmark = pytest.mark.timeout(60)


@contextmanager
def copter(*argv: str, sysid: int = 7) -> Iterator[Station]:
    """A ground station that hears a copter's process, which ends with its stdin."""
    with Station(sysid) as station:
        to = f"udpout:127.0.0.1:{station.port}"
        command = [sys.executable, str(PROGRAM), "--sysid", str(sysid), "--connect", to, *QUICK, *argv]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            try:
                station.hear("HEARTBEAT")
                yield station
            finally:
                _, said = process.communicate(timeout=5.0)
        assert (process.returncode, said) == (0, b"")


def there(*wanted: float) -> object:
    return lambda m: math.dist((m.x, m.y, m.z), wanted) < 0.3


def test_it_is_flown_in_guided_and_returns() -> None:
    with copter("--start", "1,2,0", "--origin", "47.4,8.5,400", "--refuse-arming-s", "1.5") as station:
        first = station.datagrams[0]
        assert first != b""
        assert mav.PROTOCOL_MARKER_V2 not in first
        beat = station.all_of("HEARTBEAT")[0]
        assert (beat.autopilot, beat.type) == (mav.MAV_AUTOPILOT_ARDUPILOTMEGA, mav.MAV_TYPE_QUADROTOR)
        refused = station.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1, until=None)
        assert refused == mav.MAV_RESULT_FAILED
        assert station.hear("STATUSTEXT").text.startswith(("PreArm:", "Arm:"))
        origin = station.hear("GPS_GLOBAL_ORIGIN")
        assert (origin.latitude, origin.longitude, origin.altitude) == (474000000, 85000000, 400000)
        station.hear("HOME_POSITION")
        unasked = station.hear("PARAM_VALUE")
        assert (unasked.param_id, unasked.param_index) == ("STAT_RUNTIME", 65535)
        kinds = {message.get_type() for message in station.heard} - {"COMMAND_ACK", "STATUSTEXT", "PARAM_VALUE"}
        assert kinds == {"HEARTBEAT", "GPS_GLOBAL_ORIGIN", "HOME_POSITION"}
        assert station.command(mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_LOCAL_POSITION_NED, 1e5) == ACCEPTED
        assert station.command(mav.MAV_CMD_SET_MESSAGE_INTERVAL, 245, 5e5) == ACCEPTED
        assert station.command(mav.MAV_CMD_USER_1, 1, until=None) == mav.MAV_RESULT_UNSUPPORTED
        assert station.command(mav.MAV_CMD_DO_SET_MODE, CUSTOM, GUIDED) == ACCEPTED
        assert station.command(mav.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 2, until=None) == mav.MAV_RESULT_FAILED
        station.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1)
        takeoff = mav.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 1.5
        assert station.command(*takeoff) == ACCEPTED
        assert station.command(*takeoff) == ACCEPTED
        station.hear("EXTENDED_SYS_STATE", lambda m: m.landed_state == mav.MAV_LANDED_STATE_TAKEOFF)
        assert station.command(*takeoff, until=None) == mav.MAV_RESULT_FAILED
        station.hear("EXTENDED_SYS_STATE", lambda m: m.landed_state == mav.MAV_LANDED_STATE_IN_AIR)
        station.hear("LOCAL_POSITION_NED", there(1.0, 2.0, -1.5))
        station.aim(POSITION, (2.0, 1.0, -1.5))
        station.hear("LOCAL_POSITION_NED", there(2.0, 1.0, -1.5))
        station.aim(VELOCITY, (0.0, 1.0, 0.0))
        station.hear("LOCAL_POSITION_NED", lambda m: abs(m.vy - 1.0) < 0.1)
        station.set_point = None
        station.hear("LOCAL_POSITION_NED", lambda m: abs(m.vy) < 0.1)
        assert station.command(mav.MAV_CMD_NAV_RETURN_TO_LAUNCH) == ACCEPTED
        station.hear("HEARTBEAT", lambda m: m.custom_mode == RTL)
        station.hear("HEARTBEAT", lambda m: not m.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED)
        station.hear("LOCAL_POSITION_NED", there(1.0, 2.0, 0.0))


def test_streams_come_only_by_groups_where_intervals_are_unknown() -> None:
    with copter("--refuse-intervals", "--refuse-arming-s", "0", "--battery-wh", "20") as station:
        interval = mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_ATTITUDE, 1e5
        assert station.command(*interval, until=None) == mav.MAV_RESULT_UNSUPPORTED
        station.send(mav.MAVLink_request_data_stream_message(7, 1, mav.MAV_DATA_STREAM_ALL, 4, 1))
        for kind in ("ATTITUDE", "SYS_STATUS", "GLOBAL_POSITION_INT", "LOCAL_POSITION_NED"):
            station.hear(kind)
        battery = station.hear("BATTERY_STATUS")
        assert battery.energy_consumed == -1
        assert battery.current_battery > 0
        assert 14000 < battery.voltages[0] <= 16800
        assert station.all_of("EXTENDED_SYS_STATE") == []
        station.send(mav.MAVLink_param_request_read_message(7, 1, b"BATT_CAPACITY", -1))
        told = station.hear("PARAM_VALUE", lambda m: m.param_id == "BATT_CAPACITY")
        assert (told.param_type, told.param_value) == (mav.MAV_PARAM_TYPE_INT32, round(20 / 14.8 * 1000))
        station.send(mav.MAVLink_param_request_list_message(7, 1))
        count = station.hear("PARAM_VALUE").param_count
        station.hear("PARAM_VALUE", lambda m: m.param_index == count - 1)
