"""Energy from a base of the ground station to a vehicle that stands there."""

from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

ACCEPTED, TEMPORARILY_REJECTED = 0, 1
NEED = {"SIM_BAT_CAP_J": 24_000.0, "SIM_BAT_INIT_J": 12_000.0}


def on_the_ground(vehicle_bench: Any, place_ned: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Any:
    """A vehicle that stands at its home, and has heard a base of the ground station's at a place."""
    bench = vehicle_bench(sysid=1, params=NEED)
    hear_base(bench, 0, place_ned)
    return bench


def hear_base(bench: Any, given_j: int, place_ned: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> None:
    lat_deg, lon_deg, alt_m = bench.vehicle.frame.to_global(*place_ned)
    still = [0.0] * 3
    bench.send(
        mav.MAVLink_follow_target_message(
            0, 3, round(1e7 * lat_deg), round(1e7 * lon_deg), alt_m, still, still, [1.0, 0.0, 0.0, 0.0], still, still, 0
        )
    )
    bench.send(mav.MAVLink_named_value_int_message(0, b"XferOut", given_j))


def charge(bench: Any, role: int = 2, limit_j: float = 5000.0) -> int:
    return int(bench.result(mav.MAV_CMD_USER_1, 255.0, float(role), limit_j, 2000.0, 1.0, 0.0))


def test_a_vehicle_on_the_ground_is_charged_by_the_ground_stations_base(vehicle_bench: Any) -> None:
    bench = on_the_ground(vehicle_bench)
    assert charge(bench) == ACCEPTED
    for k in range(1, 11):
        bench.tick()
        hear_base(bench, 200 * k)
    bench.tick()
    vehicle = bench.vehicle
    assert (vehicle.received_j, vehicle.given_j, vehicle.mode, vehicle.armed) == (2000, 0, "hold", False)
    assert vehicle.initial_j + 2000 - vehicle.drawn_j == pytest.approx(vehicle.remaining_j, abs=1e-9)
    assert bench.of("NAMED_VALUE_INT")[-1].value == 2000
    assert charge(bench, role=0) == ACCEPTED
    assert vehicle.transfer is None


def test_arming_ends_a_charge(vehicle_bench: Any) -> None:
    bench = on_the_ground(vehicle_bench)
    assert charge(bench) == ACCEPTED
    bench.arm()
    hear_base(bench, 4000)
    bench.tick()
    assert (bench.vehicle.transfer, bench.vehicle.received_j) == (None, 0)
    assert charge(bench) == TEMPORARILY_REJECTED  # armed, it is no longer one that waits on the ground


def test_a_base_that_is_elsewhere_or_silent_charges_nobody(vehicle_bench: Any) -> None:
    assert charge(on_the_ground(vehicle_bench, (0.0, 3.0, 0.0))) == TEMPORARILY_REJECTED
    bench = on_the_ground(vehicle_bench)
    bench.tick(12)
    assert charge(bench) == TEMPORARILY_REJECTED


def test_nobody_gives_from_the_ground(vehicle_bench: Any) -> None:
    assert charge(on_the_ground(vehicle_bench), role=1) == TEMPORARILY_REJECTED
