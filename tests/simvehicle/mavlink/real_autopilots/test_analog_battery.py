"""Battery monitor of an ArduPilot whose JSON interface takes no battery."""

from __future__ import annotations

import pytest
from pymavlink.dialects.v20 import common

from simvehicle.mavlink.codec import encode
from simvehicle.mavlink.real_autopilots.analog_battery import DEFAULTS, MARK_V, AnalogBattery

COPTER = 7


def measured(battery: AnalogBattery, now_s: float, volts: float, amperes: float) -> dict[str, float]:
    """Parameters that are set, as pymavlink reads them."""
    frames = b"".join(
        encode(content, seq=0, sysid=255, compid=190) for content in battery.settings(now_s, volts, amperes)
    )
    return {m.param_id: m.param_value for m in common.MAVLink(None).parse_buffer(frames) or []}


def test_the_sensor_is_moved_once_a_second_where_its_value_changes() -> None:
    battery = AnalogBattery(COPTER, MARK_V - 0.1)
    values = measured(battery, 10.0, 15.8, 20.4)
    assert values["SIM_BATT_VOLTAGE"] == pytest.approx(15.8)
    # ArduPilot: I = (V_pin - BATT_AMP_OFFSET) BATT_AMP_PERVLT, and its simulation has 0 V at that pin
    assert (0.0 - values["BATT_AMP_OFFSET"]) * DEFAULTS["BATT_AMP_PERVLT"] == pytest.approx(20.4, abs=0.01)
    assert measured(battery, 10.5, 12.0, 5.0) == {}
    assert measured(battery, 11.0, 15.8, 20.4) == {}
    assert measured(battery, 12.0, 15.7, 20.4) == {"SIM_BATT_VOLTAGE": pytest.approx(15.7)}


def test_one_that_reads_the_battery_in_the_answers_is_left_alone() -> None:
    battery = AnalogBattery(COPTER, 16.7)
    assert not battery.by_parameters
    assert measured(battery, 0.0, 15.0, 20.0) == {}
