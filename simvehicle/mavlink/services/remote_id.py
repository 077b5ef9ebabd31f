"""Remote ID: which vehicle it is and where it flies, as the Open Drone ID messages that a transmitter or a ground
station takes.

With DID_ENABLE 1 the moving part (LOCATION) goes out once a second on every connection, the others every three, as the
standard asks at least. The vehicle is simulated: its serial number is SKYT5 and its system id in five digits, its
operator SKYTENDER-SIM, placed where it took off. Its accuracies are those of its GPS, and unknown without a fix.
[lineage] https://mavlink.io/en/services/opendroneid.html; ASTM F3411; serial numbers by ANSI/CTA-2063-A
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.codec import message
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.telemetry import message_of
from skytender import elementary
from skytender import mavlink as mav

ENABLE = "DID_ENABLE"
EVERY_MS, OTHERS_EVERY = 1000, 3
UNKNOWN_M = -1000.0
EPOCH_S = 1_546_300_800
"""2019-01-01 in Unix time, from which SYSTEM counts."""
OPERATOR = "SKYTENDER-SIM"
_HORIZONTAL = {
    1.0: mav.MAV_ODID_HOR_ACC_1_METER,
    3.0: mav.MAV_ODID_HOR_ACC_3_METER,
    10.0: mav.MAV_ODID_HOR_ACC_10_METER,
    30.0: mav.MAV_ODID_HOR_ACC_30_METER,
}
_VERTICAL = {
    1.0: mav.MAV_ODID_VER_ACC_1_METER,
    3.0: mav.MAV_ODID_VER_ACC_3_METER,
    10.0: mav.MAV_ODID_VER_ACC_10_METER,
    25.0: mav.MAV_ODID_VER_ACC_25_METER,
    45.0: mav.MAV_ODID_VER_ACC_45_METER,
    150.0: mav.MAV_ODID_VER_ACC_150_METER,
}
_SPEED = {
    0.3: mav.MAV_ODID_SPEED_ACC_0_3_METERS_PER_SECOND,
    1.0: mav.MAV_ODID_SPEED_ACC_1_METERS_PER_SECOND,
    3.0: mav.MAV_ODID_SPEED_ACC_3_METERS_PER_SECOND,
    10.0: mav.MAV_ODID_SPEED_ACC_10_METERS_PER_SECOND,
}
"""Classes of accuracy, by what they are better than, m or m/s."""


def serial_number(sysid: int) -> str:
    """Four letters of a manufacturer, the length of what follows, and that: without O and I, as the standard asks."""
    return f"SKYT5{sysid:05d}"


class RemoteIdService:
    """Remote ID of one vehicle."""

    def __init__(self, vehicle: Vehicle, sysid: int, connections: Iterable[Connection]) -> None:
        self._vehicle, self._sysid, self._connections = vehicle, sysid, connections
        self._due_ms = self._count = 0

    @property
    def at_work(self) -> bool:
        """Whether it is sent."""
        return self._vehicle.parameters[ENABLE] == 1.0

    def report(self) -> None:
        """Queue what is due."""
        if not self.at_work or self._vehicle.time_ms < self._due_ms:
            return
        self._due_ms = self._vehicle.time_ms + EVERY_MS
        contents = [self._location()]
        if self._count % OTHERS_EVERY == 0:
            contents += [self._basic_id(), self._system(), self._operator_id()]
        self._count += 1
        for content in contents:
            for connection in self._connections:
                connection.put(content)

    def _basic_id(self) -> Any:
        return message("OPEN_DRONE_ID_BASIC_ID")(
            id_type=mav.MAV_ODID_ID_TYPE_SERIAL_NUMBER,
            ua_type=mav.MAV_ODID_UA_TYPE_HELICOPTER_OR_MULTIROTOR,
            uas_id=tuple(serial_number(self._sysid).encode().ljust(20, b"\0")),
        )

    def _location(self) -> Any:
        vehicle = self._vehicle
        place, fix = message_of(vehicle, "GLOBAL_POSITION_INT"), message_of(vehicle, "GPS_RAW_INT")
        north, east = place.vx / 100.0, place.vy / 100.0
        towards_cdeg = round(elementary.atan2(east, north) * 18_000.0 / math.pi) % 36_000
        flying = mav.MAV_ODID_STATUS_EMERGENCY if vehicle.failed else mav.MAV_ODID_STATUS_AIRBORNE
        status = mav.MAV_ODID_STATUS_GROUND if vehicle.landed else flying
        unix_s = vehicle.unix_epoch_us / 1e6 + vehicle.time_ms / 1e3
        return message("OPEN_DRONE_ID_LOCATION")(
            status=status,
            direction=towards_cdeg,
            speed_horizontal=min(round(100.0 * elementary.hypot(north, east)), 25_425),
            speed_vertical=min(max(-place.vz, -6200), 6200),
            latitude=place.lat,
            longitude=place.lon,
            altitude_barometric=UNKNOWN_M,
            altitude_geodetic=place.alt / 1e3,
            height_reference=mav.MAV_ODID_HEIGHT_REF_OVER_TAKEOFF,
            height=place.relative_alt / 1e3,
            horizontal_accuracy=_class_of(fix.h_acc, _HORIZONTAL),
            vertical_accuracy=_class_of(fix.v_acc, _VERTICAL),
            barometer_accuracy=mav.MAV_ODID_VER_ACC_UNKNOWN,
            speed_accuracy=_class_of(fix.vel_acc, _SPEED),
            timestamp=unix_s % 3600.0,
            timestamp_accuracy=mav.MAV_ODID_TIME_ACC_0_1_SECOND,
        )

    def _system(self) -> Any:
        home, unix_s = message_of(self._vehicle, "HOME_POSITION"), self._vehicle.unix_epoch_us // 1_000_000
        return message("OPEN_DRONE_ID_SYSTEM")(
            operator_location_type=mav.MAV_ODID_OPERATOR_LOCATION_TYPE_TAKEOFF,
            operator_latitude=home.latitude,
            operator_longitude=home.longitude,
            area_count=1,
            area_ceiling=UNKNOWN_M,
            area_floor=UNKNOWN_M,
            operator_altitude_geo=home.altitude / 1e3,
            timestamp=max(unix_s + self._vehicle.time_ms // 1000 - EPOCH_S, 0),
        )

    def _operator_id(self) -> Any:
        return message("OPEN_DRONE_ID_OPERATOR_ID")(operator_id=OPERATOR)


def _class_of(accuracy_mm: int, classes: Mapping[float, int]) -> int:
    """The best class that an accuracy is within; 0 stands for one that is not known, here and there."""
    return next((number for limit, number in classes.items() if 0 < accuracy_mm < 1e3 * limit), 0)
