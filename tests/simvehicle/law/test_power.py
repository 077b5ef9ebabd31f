import math

import numpy as np
import pytest

from simvehicle.law import power, rows, step
from simvehicle.law.params import NAMED, BatteryParams, VehicleParams, pack


def flown(params, seconds, *, motors=1.0, ground=0.0):
    """A hover in place: final state and every thrust."""
    start = {"position_nwu": (0, 0, 0), "velocity_nwu": (0, 0, 0), "attitude_rad": (0, 0, 0)}
    state = step.initial_state(params, **start, airborne=ground == 0.0)[np.newaxis]
    command = np.zeros((1, rows.COMMAND_SIZE))
    command[0, rows.CMD_USE_POSITION] = 1.0
    command[0, rows.CMD_MOTORS], command[0, rows.CMD_GROUND] = motors, ground
    return step.advance(state, command, pack(params)[np.newaxis], time_s=0.0, steps=round(seconds / 0.004))


def test_hover_draws_hover_power_and_avionics():
    state, thrust = flown(NAMED["default"], 60.0)
    assert thrust == pytest.approx(9.8)
    assert state[0, rows.DRAWN_J] == pytest.approx((200.0 + 10.0) * 60.0, rel=1e-12)


def test_power_grows_with_thrust_to_three_halves():
    drawn_w = [power.power(u1, 9.8, 200.0, 10.0) for u1 in (0.0, 9.8, 4.0 * 9.8)]
    assert drawn_w == pytest.approx([10.0, 210.0, 8.0 * 200.0 + 10.0])


def test_a_vehicle_at_rest_draws_its_avionics_alone():
    state, thrust = flown(NAMED["default"], 10.0, motors=0.0, ground=1.0)
    assert not thrust.any()
    assert state[0, rows.DRAWN_J] == pytest.approx(10.0 * 10.0)
    assert state[0, rows.EFFORT] == 0.0


def test_control_effort_of_a_hover_is_the_weight_times_time():
    state, _ = flown(NAMED["default"], 10.0)
    assert state[0, rows.EFFORT] == pytest.approx(9.8 * 10.0)


def test_an_empty_battery_stops_motors_and_draws_no_more_than_it_had():
    params = VehicleParams(battery=BatteryParams(initial_j=1050.0 + 0.1))
    state, thrust = flown(params, 10.0)
    assert state[0, rows.REMAINING_J] == 0.0
    assert state[0, rows.DRAWN_J] == pytest.approx(1050.1, rel=1e-12)
    last = np.flatnonzero(thrust[0])[-1]
    assert last == 1250
    assert not thrust[0, last + 1 :].any()
    assert state[0, rows.EFFORT] == pytest.approx(9.8 * 1251 * 0.004)
    fall_s = 10.0 - 1251 * 0.004
    assert state[0, rows.VELOCITY][2] == pytest.approx(-9.8 / 0.05 * (1.0 - math.exp(-0.05 * fall_s)), rel=1e-9)


def test_a_battery_is_full_unless_told_otherwise():
    assert BatteryParams(capacity_j=5.0).initial_j == 5.0
    assert BatteryParams(capacity_j=5.0, initial_j=0.0).initial_j == 0.0


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"capacity_j": 0.0}, "battery.capacity_j is 0.0, but it must be greater than 0 and finite"),
        ({"initial_j": 24_001.0}, "battery.initial_j is 24001.0, but it must be from 0 to the capacity, 24000.0"),
        ({"initial_j": -1.0}, "battery.initial_j is -1.0, but it must be from 0 to the capacity, 24000.0"),
        ({"initial_j": math.nan}, "battery.initial_j is nan, but it must be from 0 to the capacity, 24000.0"),
        ({"hover_w": -1.0}, "battery.hover_w is -1.0, but it must be 0 or greater, and finite"),
    ],
)
def test_a_bad_battery_is_named(arguments, sentence):
    with pytest.raises(ValueError, match=f"^{sentence}$"):
        BatteryParams(**arguments)
