"""Parameters over the wire, and what a change of them does to the flight."""

import math
import struct
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.parameters import Parameters
from simvehicle.law.params import NAMED
from skytender.vehicle.parameters import TABLE

REAL32, INT32 = mav.MAV_PARAM_TYPE_REAL32, mav.MAV_PARAM_TYPE_INT32
OUT_OF_RANGE, READ_ONLY = mav.MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE, mav.MAV_PARAM_ERROR_READ_ONLY
TYPE_MISMATCH = 7
"""MAV_PARAM_ERROR_TYPE_MISMATCH of today's common.xml."""
AIRBORNE = Start(p_ned=(0.0, 0.0, -5.0), airborne=True)
FIXED = ("SIM_BAT_INIT_J", "SIM_GAIN_SET")


def as_float(number: int) -> float:
    return float(struct.unpack("<f", struct.pack("<i", number))[0])


def set_value(bench: Any, name: str, value: float, kind: int = REAL32) -> Any:
    """The PARAM_VALUE that answers a change; a PARAM_ERROR may stand before it."""
    *errors, echo = bench.send(mav.MAVLink_param_set_message(1, 1, name.encode(), value, kind))
    assert [m.get_type() for m in errors] in ([], ["PARAM_ERROR"])
    assert (echo.get_type(), echo.param_id) == ("PARAM_VALUE", name)
    return echo


def refusal(bench: Any, name: str, value: float, kind: int = REAL32) -> int:
    """The code of the PARAM_ERROR that answers a change, the old value following it."""
    before = bench.vehicle.parameters[name]
    error, echo = bench.send(mav.MAVLink_param_set_message(1, 1, name.encode(), value, kind), source=(7, 8))
    assert (error.get_type(), error.param_id, error.param_index) == ("PARAM_ERROR", name, echo.param_index)
    assert (error.target_system, error.target_component) == (7, 8)
    assert bench.vehicle.parameters[name] == before
    return int(error.error)


def read_value(bench: Any, name: str) -> Any:
    (value,) = bench.send(mav.MAVLink_param_request_read_message(1, 1, name.encode(), -1))
    return value


def test_list_gives_each_parameter_once_with_its_index(vehicle_bench: Any) -> None:
    values = vehicle_bench().send(mav.MAVLink_param_request_list_message(1, 1))
    assert [m.param_id for m in values] == [row.name for row in TABLE]
    assert [m.param_index for m in values] == list(range(len(TABLE)))
    assert {m.param_count for m in values} == {len(TABLE)}
    assert all(len(row.name) <= 16 for row in TABLE)


def test_the_tables_defaults_are_the_flight_laws() -> None:
    flown, law = Parameters().flight(), NAMED["default"]
    assert (flown.gains, flown.battery, flown.airframe, flown.guidance) == (
        law.gains,
        law.battery,
        law.airframe,
        law.guidance,
    )
    assert vars(flown.limits) == pytest.approx(vars(law.limits), rel=1e-15)


def test_parameter_is_read_alike_by_name_and_by_index(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for row in TABLE:
        by_name = read_value(bench, row.name)
        (by_index,) = bench.send(mav.MAVLink_param_request_read_message(1, 1, b"", by_name.param_index))
        assert by_name.to_dict() == by_index.to_dict()
        assert by_name.param_type == (INT32 if row.whole else REAL32)


def test_unknown_name_or_index_is_not_answered_with_another_parameter(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for question, name, index in (
        (mav.MAVLink_param_request_read_message(1, 1, b"NO_SUCH", -1), "NO_SUCH", -1),
        (mav.MAVLink_param_request_read_message(1, 1, b"", len(TABLE)), "", len(TABLE)),
        (mav.MAVLink_param_request_read_message(1, 1, b"", 32767), "", 32767),
        (mav.MAVLink_param_set_message(1, 1, b"NO_SUCH", 1.0, REAL32), "NO_SUCH", -1),
    ):
        (error,) = bench.send(question)
        assert (error.get_type(), error.error) == ("PARAM_ERROR", mav.MAV_PARAM_ERROR_DOES_NOT_EXIST)
        assert (error.param_id, error.param_index) == (name, index)
        assert (error.target_system, error.target_component) == (255, 190)


@pytest.mark.parametrize("row", [r for r in TABLE if not r.whole and r.name not in FIXED], ids=lambda row: row.name)
def test_value_is_set_and_kept_where_it_is_out_of_range(vehicle_bench: Any, row: Any) -> None:
    bench = vehicle_bench()
    share = 1.02 if row.name == "SIM_BAT_CAP_J" else 0.98  # a full battery's capacity can only grow
    wanted = struct.unpack("<f", struct.pack("<f", row.default * share or row.least + 0.5))[0]
    assert set_value(bench, row.name, wanted).param_value == pytest.approx(wanted, rel=1e-6)
    bench.tick(60)
    for bad in (row.least - 1.0, row.most * 1.01 + 1.0, math.nan, math.inf):
        assert set_value(bench, row.name, bad).param_value == pytest.approx(wanted, rel=1e-6)
        assert read_value(bench, row.name).param_value == pytest.approx(wanted, rel=1e-6)
    bench.tick()
    assert [text.split(" ")[0] for text in bench.texts] == [row.name]


@pytest.mark.parametrize("end", ["least", "most"])
def test_extreme_values_never_stop_the_telemetry(vehicle_bench: Any, end: str) -> None:
    for row in TABLE:
        bench = vehicle_bench(start=AIRBORNE)
        bench.tick()
        set_value(bench, row.name, getattr(row, end))
        bench.fly(2.0, p_ned=(20.0, 0.0, -5.0))
        assert bench.of("BATTERY_STATUS"), row.name
        assert all(math.isfinite(x) for x in bench.vehicle.state[0]), row.name


def test_a_battery_never_holds_more_than_its_capacity(vehicle_bench: Any) -> None:
    bench = vehicle_bench(start=AIRBORNE)
    holds_j = bench.vehicle.remaining_j
    assert refusal(bench, "SIM_BAT_CAP_J", 0.9 * holds_j) == OUT_OF_RANGE
    bench.tick()
    assert bench.texts == [f"SIM_BAT_CAP_J = {0.9 * holds_j:g}: the battery holds {holds_j:.0f} J"]
    assert set_value(bench, "SIM_BAT_CAP_J", 2.0 * holds_j).param_value == 2.0 * holds_j
    assert set_value(bench, "SIM_BAT_CAP_J", 1.1 * holds_j).param_value == pytest.approx(1.1 * holds_j)


@pytest.mark.parametrize(("autopilot", "bytewise"), [("px4", True), ("generic", True), ("ardupilot", False)])
def test_integers_travel_as_the_identity_does_it(vehicle_bench: Any, autopilot: str, bytewise: bool) -> None:
    bench = vehicle_bench(autopilot=autopilot)
    wire = as_float(4001) if bytewise else 4001.0
    assert read_value(bench, "SYS_AUTOSTART").param_value == wire
    new = as_float(10016) if bytewise else 10016.0
    assert set_value(bench, "SYS_AUTOSTART", new, INT32).param_value == new
    assert bench.vehicle.parameters["SYS_AUTOSTART"] == 10016.0
    flags = bench.command(mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, 1.0)[1].capabilities
    assert bool(flags & mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE) == bytewise
    assert bool(flags & mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST) != bytewise


@pytest.mark.parametrize(
    ("name", "value", "kind", "code", "said"),
    [
        ("MPC_LAND_SPEED", 99.0, REAL32, OUT_OF_RANGE, "MPC_LAND_SPEED = 99 is outside"),
        ("MPC_LAND_SPEED", math.nan, REAL32, OUT_OF_RANGE, "MPC_LAND_SPEED = nan is outside"),
        ("MPC_LAND_SPEED", -math.inf, REAL32, OUT_OF_RANGE, "MPC_LAND_SPEED = -inf is outside"),
        ("SIM_GAIN_RATE", 600.0, REAL32, OUT_OF_RANGE, "SIM_GAIN_RATE = 600 is refused: gains.rate"),  # at 250 Hz
        ("GF_ACTION", as_float(9), INT32, OUT_OF_RANGE, "GF_ACTION = 9 is outside"),
        ("SIM_BAT_INIT_J", 5000.0, REAL32, READ_ONLY, "SIM_BAT_INIT_J can only be given at start"),
        ("SIM_GAIN_SET", as_float(1), INT32, READ_ONLY, "SIM_GAIN_SET can only be given at start"),
        ("MPC_LAND_SPEED", as_float(1), INT32, TYPE_MISMATCH, "MPC_LAND_SPEED is a REAL32: value refused"),
        ("GF_ACTION", 1.0, REAL32, TYPE_MISMATCH, "GF_ACTION is an INT32: value refused"),
        ("GF_ACTION", 1.0, mav.MAV_PARAM_TYPE_UINT8, TYPE_MISMATCH, "GF_ACTION is an INT32: value refused"),
    ],
)
def test_refused_value_is_answered_by_the_reason_and_kept(
    vehicle_bench: Any, name: str, value: float, kind: int, code: int, said: str
) -> None:
    bench = vehicle_bench()
    assert refusal(bench, name, value, kind) == code
    bench.tick()
    assert bench.texts[0].startswith(said)


def test_value_of_another_type_is_taken_by_value(vehicle_bench: Any) -> None:
    bench = vehicle_bench(autopilot="ardupilot")
    set_value(bench, "MPC_XY_CRUISE", 3.0, INT32)
    set_value(bench, "SYS_AUTOSTART", 7.0, REAL32)
    assert bench.vehicle.parameters["MPC_XY_CRUISE"] == 3.0
    assert bench.vehicle.parameters["SYS_AUTOSTART"] == 7.0


def dash(bench: Any, name: str | None = None, value: float = 0.0) -> list[Any]:
    """Fly 30 m north after a change of one parameter; positions reported."""
    bench.fly(0.5, p_ned=(0.0, 0.0, -5.0))
    if name is not None:
        set_value(bench, name, value)
    bench.heard.clear()
    bench.fly(8.0, p_ned=(30.0, 0.0, -5.0))
    return list(bench.of("LOCAL_POSITION_NED"))


def test_speed_limit_of_the_guidance_holds_in_flight(vehicle_bench: Any) -> None:
    fast = dash(vehicle_bench(start=AIRBORNE))
    slow = dash(vehicle_bench(start=AIRBORNE), "MPC_XY_VEL_MAX", 1.0)
    assert max(m.vx for m in fast) == pytest.approx(5.0, rel=0.1)
    assert max(m.vx for m in slow) == pytest.approx(1.0, rel=0.1)


def test_acceleration_and_tilt_limits_hold_in_flight(vehicle_bench: Any) -> None:
    brisk, gentle = vehicle_bench(start=AIRBORNE), vehicle_bench(start=AIRBORNE)
    dash(brisk)
    dash(gentle, "MPC_ACC_HOR", 0.5)
    level = vehicle_bench(start=AIRBORNE)
    dash(level, "MPC_TILTMAX_AIR", 5.0)
    tilt = [max(math.hypot(m.roll, m.pitch) for m in b.of("ATTITUDE")) for b in (brisk, gentle, level)]
    assert tilt[1] < math.atan(1.0 / 9.8) < tilt[0]
    assert tilt[2] < math.radians(7.0) < tilt[0]  # the angle overshoots its own limited reference a little


def test_gains_change_the_flight(vehicle_bench: Any) -> None:
    ends = {
        name: tuple(m.x for m in dash(vehicle_bench(start=AIRBORNE), name, value))
        for name, value in (
            (None, 0.0), ("SIM_GAIN_SPEED", 1.0), ("SIM_GAIN_RATE", 8.0), ("SIM_GAIN_ANGLE", 20.0),
            ("SIM_ANGACC_MAX", 6.0), ("MPC_THR_MAX_G", 1.1),
        )
    }  # fmt: skip
    assert len(set(ends.values())) == len(ends)


def test_heights_and_speeds_of_modes_are_parameters(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"MIS_TAKEOFF_ALT": 1.5, "RTL_RETURN_ALT": 3.0, "MPC_LAND_SPEED": 0.3})
    bench.arm()
    bench.result(mav.MAV_CMD_NAV_TAKEOFF, *[math.nan] * 7)
    bench.fly(10.0, until=lambda b: b.vehicle.mode == "hold")
    bench.fly(2.0)
    assert bench.vehicle.p_ned[2] == pytest.approx(-1.5, abs=0.1)
    bench.result(mav.MAV_CMD_NAV_LAND)
    bench.fly(3.0)
    assert bench.vehicle.v_ned[2] == pytest.approx(0.3, abs=0.02)


def test_battery_parameters_change_the_power(vehicle_bench: Any) -> None:
    for name, value, power_w in (("SIM_BAT_HOVER_W", 100.0, 110.0), ("SIM_BAT_AVION_W", 50.0, 250.0)):
        bench = vehicle_bench(start=AIRBORNE)
        bench.fly(2.0, p_ned=(0.0, 0.0, -5.0))
        set_value(bench, name, value)
        drawn = bench.vehicle.drawn_j
        bench.fly(1.0, p_ned=(0.0, 0.0, -5.0))
        assert bench.vehicle.drawn_j - drawn == pytest.approx(power_w, rel=1e-3)
