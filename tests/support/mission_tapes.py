"""Recordings of a vehicle at rest and of what a ground station and it exchange by the mission protocol."""

from __future__ import annotations

import math
import struct
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mav

LAT_DEG, LON_DEG, ALT_M = 47.3977, 8.5456, 488.0
UTC_US = 1_767_225_600_000_000
STATION, VEHICLE = (255, 190), (3, 1)
AWAY_DEG = 0.001


class Tape:
    """A .tlog written frame by frame; the vehicle is heard ten times a second meanwhile."""

    def __init__(self, autopilot: int = mav.MAV_AUTOPILOT_PX4) -> None:
        self.out = b""
        self._autopilot = autopilot
        self._senders: dict[tuple[int, int], Any] = {}
        self.t_s = 0.0

    def say(self, sender: tuple[int, int], message: Any) -> None:
        link = self._senders.setdefault(sender, mav.MAVLink(None, *sender))
        self.out += struct.pack(">Q", UTC_US + round(1e6 * self.t_s)) + message.pack(link)

    def fly(self, seconds: float) -> None:
        for _ in range(round(10 * seconds)):
            self.t_s += 0.1
            boot_ms = round(1000 * self.t_s)
            kinds = mav.MAV_TYPE_QUADROTOR, self._autopilot
            self.say(VEHICLE, mav.MAVLink_heartbeat_message(*kinds, 129, 0, 4, 3))
            self.say(STATION, mav.MAVLink_heartbeat_message(mav.MAV_TYPE_GCS, 8, 0, 0, 4, 3))
            at = round(1e7 * LAT_DEG), round(1e7 * LON_DEG), round(1e3 * ALT_M)
            self.say(VEHICLE, mav.MAVLink_gps_global_origin_message(*at))
            self.say(VEHICLE, mav.MAVLink_local_position_ned_message(boot_ms, 0.0, 0.0, -5.0, 0.0, 0.0, 0.0))

    def item(self, sender: tuple[int, int], seq: int, command: int, frame: int, at: tuple[float, float, float], kind: int = 0, p1: float = 0.0, current: int = 0) -> None:  # fmt: skip  # noqa: E501
        to = VEHICLE if sender == STATION else STATION
        where = round(1e7 * at[0]), round(1e7 * at[1]), at[2]
        self.say(
            sender,
            mav.MAVLink_mission_item_int_message(
                *to, seq, frame, command, current, 1, p1, 0, 0, math.nan, *where, kind
            ),
        )

    def count(self, sender: tuple[int, int], count: int, kind: int = 0) -> None:
        to = VEHICLE if sender == STATION else STATION
        self.say(sender, mav.MAVLink_mission_count_message(*to, count, kind))

    def ack(self, result: int = 0, kind: int = 0) -> None:
        self.say(VEHICLE, mav.MAVLink_mission_ack_message(*STATION, result, kind))

    def upload(self, places: list[tuple[float, float, float]], *, result: int = 0, frame: int = 3) -> None:
        self.count(STATION, len(places))
        for seq, at in enumerate(places):
            self.say(VEHICLE, mav.MAVLink_mission_request_int_message(*STATION, seq, 0))
            self.item(STATION, seq, mav.MAV_CMD_NAV_WAYPOINT, frame, at)
        self.ack(result)

    def write(self, path: Path) -> Path:
        path.write_bytes(self.out)
        return path


def north(k: float, height_m: float = 10.0) -> tuple[float, float, float]:
    return (LAT_DEG + k * AWAY_DEG, LON_DEG, height_m)
