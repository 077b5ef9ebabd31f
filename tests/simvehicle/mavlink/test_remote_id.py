"""Remote ID of a vehicle, read by pymavlink, against MAVLink's description of each field and the vehicle's own
telemetry."""

from __future__ import annotations

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.law.plants import RotorPlant
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import WorldVehicle
from simvehicle.world.estimate import EstimateErrors

KINDS = ("BASIC_ID", "LOCATION", "SYSTEM", "OPERATOR_ID")
ON = {"DID_ENABLE": 1.0}


def of(bench: Any, kind: str) -> list[Any]:
    return list(bench.of(f"OPEN_DRONE_ID_{kind}"))


def test_it_is_sent_where_it_is_asked_for_and_nowhere_else(vehicle_bench: Any) -> None:
    quiet = vehicle_bench()
    quiet.tick(40)
    assert not [m for m in quiet.heard if "OPEN_DRONE_ID" in m.get_type()]
    bench = vehicle_bench(7, params=ON)
    bench.tick(90)
    assert {kind: len(of(bench, kind)) for kind in KINDS} == {
        "BASIC_ID": 3, "LOCATION": 9, "SYSTEM": 3, "OPERATOR_ID": 3,
    }  # fmt: skip


def test_the_id_is_a_serial_number_as_the_standard_writes_them(vehicle_bench: Any) -> None:
    bench = vehicle_bench(7, params=ON)
    bench.tick(1)
    (basic,) = of(bench, "BASIC_ID")
    own = bytes(basic.uas_id).rstrip(b"\0").decode()
    assert (basic.id_type, basic.ua_type) == (mav.MAV_ODID_ID_TYPE_SERIAL_NUMBER, 2)
    assert own.isupper()
    assert not set(own) & set("OI")
    assert int(own[4], 16) == len(own[5:])
    assert (own, of(bench, "OPERATOR_ID")[0].operator_id) == ("SKYT500007", "SKYTENDER-SIM")


def test_place_and_motion_are_those_of_its_telemetry(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params=ON)
    bench.vehicle.set_clock(0, 1_700_000_000_000_000)
    bench.tick(1)
    assert of(bench, "LOCATION")[-1].status == mav.MAV_ODID_STATUS_GROUND
    bench = vehicle_bench(params=ON, start=Start((0.0, 0.0, -8.0), (-1.0, -2.0, 0.0), airborne=True))
    bench.vehicle.set_clock(0, 1_700_000_000_000_000)
    bench.tick(11)
    location = of(bench, "LOCATION")[-1]
    at_ms = 1000 * (location.timestamp - 1_700_000_000 % 3600)
    place = min(bench.of("GLOBAL_POSITION_INT"), key=lambda one: abs(one.time_boot_ms - at_ms))
    assert location.status == mav.MAV_ODID_STATUS_AIRBORNE
    assert abs(place.time_boot_ms - at_ms) < 201.0
    assert abs(location.latitude - place.lat) + abs(location.longitude - place.lon) < 100
    assert abs(location.height - place.relative_alt / 1e3) < 0.5
    assert abs(location.altitude_geodetic - place.alt / 1e3) < 0.5
    speed = math.hypot(place.vx, place.vy)
    assert abs(location.speed_horizontal - speed) < 60.0
    assert 0 <= location.direction < 36_000
    if speed > 50.0:
        course = math.degrees(math.atan2(place.vy, place.vx)) % 360.0
        assert abs((location.direction / 100.0 - course + 180.0) % 360.0 - 180.0) < 10.0


def test_a_failure_in_the_air_is_an_emergency(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={**ON, "SYS_FAILURE_EN": 1}, start=Start((0.0, 0.0, -8.0), airborne=True))
    bench.tick(11)
    bench.command(mav.MAV_CMD_INJECT_FAILURE, mav.FAILURE_UNIT_SENSOR_GPS, mav.FAILURE_TYPE_OFF, 0.0)
    bench.tick(11)
    assert of(bench, "LOCATION")[-1].status == mav.MAV_ODID_STATUS_EMERGENCY


def accuracies(bench: Any) -> tuple[int, int, int]:
    location = of(bench, "LOCATION")[-1]
    return location.horizontal_accuracy, location.vertical_accuracy, location.speed_accuracy


def test_accuracies_are_unknown_without_a_fix(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={**ON, "SYS_FAILURE_EN": 1}, start=Start((0.0, 0.0, -8.0), airborne=True))
    for failure, expected in (
        (mav.FAILURE_TYPE_OK, (12, 6, 4)),  # better than 1 m, 1 m and 0.3 m/s
        (mav.FAILURE_TYPE_OFF, (0, 0, 0)),
        (mav.FAILURE_TYPE_OK, (12, 6, 4)),
    ):
        bench.command(mav.MAV_CMD_INJECT_FAILURE, mav.FAILURE_UNIT_SENSOR_GPS, failure, 0.0)
        bench.tick(11)
        assert accuracies(bench) == expected


@pytest.mark.parametrize(
    ("position_m", "velocity_m_s", "expected"),
    [
        (0.3, 0.05, (12, 6, 4)),
        (2.0, 0.5, (11, 5, 3)),  # better than 3 m and 1 m/s
        (20.0, 2.0, (9, 3, 2)),  # better than 30 m, 25 m and 3 m/s
        (200.0, 20.0, (0, 0, 0)),
    ],
)
def test_accuracies_are_those_of_its_sensors(
    vehicle_bench: Any, position_m: float, velocity_m_s: float, expected: tuple[int, int, int]
) -> None:
    errors = EstimateErrors(position_m=position_m, velocity_m_s=velocity_m_s)
    bench = vehicle_bench(params=ON, plant=RotorPlant(WorldVehicle(AIRFRAMES["iris"], errors)))
    bench.tick(1)
    assert accuracies(bench) == expected
