"""Rates of telemetry: by default, on request, and per connection."""

import math
from collections import Counter
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.telemetry import TELEMETRY, UNPROMPTED

SET, GET = mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAV_CMD_GET_MESSAGE_INTERVAL
ACCEPTED, DENIED, UNSUPPORTED = 0, 2, 3
ATTITUDE = mav.MAVLINK_MSG_ID_ATTITUDE


def count(bench: Any, seconds: int = 10) -> Counter[str]:
    """Messages by name in some seconds, once the streams have found their rhythm."""
    bench.tick(20)
    bench.heard.clear()
    bench.tick(10 * seconds)
    named = (m.name if m.get_type().startswith("NAMED") else m.get_type() for m in bench.heard)
    return Counter(named)


def test_everything_is_streamed_unprompted_at_its_rate(vehicle_bench: Any) -> None:
    told = count(vehicle_bench())
    assert told == {s.key: round(10 * s.rate_hz) for s in TELEMETRY if s.rate_hz}
    least_hz = {"HEARTBEAT": 1.0, "EXTENDED_SYS_STATE": 1.0, "HOME_POSITION": 0.5, "BATTERY_STATUS": 0.5}
    assert all(told[key] >= 10 * rate for key, rate in least_hz.items())


def test_the_present_item_is_streamed_on_plain_links_also_without_a_mission(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for key, rate_hz in UNPROMPTED.items():
        bench.connection.streams.set_default(key, rate_hz)
    assert count(bench)["MISSION_CURRENT"] == 10


def test_interval_is_set_stopped_and_restored(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    default = count(bench)["ATTITUDE"]
    for interval_us, expected in ((200_000.0, 50), (2e6, 5), (-1.0, 0), (0.0, default)):
        assert bench.result(SET, ATTITUDE, interval_us) == ACCEPTED
        assert count(bench)["ATTITUDE"] == expected


def test_default_of_a_silent_stream_is_silence(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    follow = mav.MAVLINK_MSG_ID_FOLLOW_TARGET
    assert bench.result(SET, follow, 100_000.0) == ACCEPTED
    assert count(bench)["FOLLOW_TARGET"] == 100
    assert bench.result(SET, follow, 0.0) == ACCEPTED
    assert count(bench)["FOLLOW_TARGET"] == 0


def test_heartbeat_cannot_be_stopped(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    assert bench.result(SET, mav.MAVLINK_MSG_ID_HEARTBEAT, -1.0) == DENIED
    assert count(bench)["HEARTBEAT"] == 10
    assert bench.result(SET, mav.MAVLINK_MSG_ID_HEARTBEAT, 200_000.0) == ACCEPTED
    assert count(bench)["HEARTBEAT"] == 50


@pytest.mark.parametrize("interval_us", [math.nan, math.inf, -math.inf])
def test_interval_that_is_no_number_changes_nothing(vehicle_bench: Any, interval_us: float) -> None:
    bench = vehicle_bench()
    assert bench.result(SET, ATTITUDE, interval_us) in (ACCEPTED, DENIED)
    assert count(bench, 1)["ATTITUDE"] == 10


@pytest.mark.parametrize("interval_us", [1e-3, 3.9e3, 1e10, 3.4e38])
def test_extreme_interval_is_kept_within_what_can_be_told(vehicle_bench: Any, interval_us: float) -> None:
    bench = vehicle_bench()
    assert bench.result(SET, ATTITUDE, interval_us) == ACCEPTED
    told = bench.command(GET, ATTITUDE)
    assert [m.get_type() for m in told] == ["COMMAND_ACK", "MESSAGE_INTERVAL"]
    assert 4000 <= told[1].interval_us < 2**31
    assert count(bench, 1)["ATTITUDE"] <= 10


@pytest.mark.parametrize("msgid", [-1.0, 9999.0, mav.MAVLINK_MSG_ID_PING, math.nan])
def test_stream_that_is_none_is_unsupported(vehicle_bench: Any, msgid: float) -> None:
    bench = vehicle_bench()
    assert bench.result(SET, msgid, 1e5) == UNSUPPORTED
    assert bench.result(GET, msgid) == UNSUPPORTED
    assert bench.result(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_MESSAGE_INTERVAL, msgid) == UNSUPPORTED


def test_interval_is_told(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for interval_us, told_us in ((0.0, 100_000), (50_000.0, 50_000), (-1.0, -1)):
        bench.command(SET, ATTITUDE, interval_us)
        for asked in ((GET,), (mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_MESSAGE_INTERVAL)):
            ack, told = bench.command(*asked, ATTITUDE)
            assert (ack.result, told.message_id, told.interval_us) == (ACCEPTED, ATTITUDE, told_us)


def test_no_interval_is_told_that_is_shorter_than_a_tick(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.connection.streams.tick_ms = 100
    for interval_us, told_us, sent in ((4e3, 100_000, 100), (1e5, 100_000, 100), (2e5, 200_000, 50), (-1.0, -1, 0)):
        assert bench.result(SET, ATTITUDE, interval_us) == ACCEPTED
        assert bench.command(GET, ATTITUDE)[1].interval_us == told_us
        assert count(bench)["ATTITUDE"] == sent


def test_each_connection_has_its_own_rates_and_numbers(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    other = Connection(1)
    bench.services.connections.append(other)
    bench.command(SET, ATTITUDE, -1.0)
    parser = mav.MAVLink(None)
    for _ in range(20):
        bench.tick()
    messages = [m for raw in other.frames() for m in parser.parse_buffer(raw)]
    assert sum(m.get_type() == "ATTITUDE" for m in messages) == 20
    assert not bench.of("ATTITUDE")
    assert [m.get_seq() for m in messages] == [i % 256 for i in range(len(messages))]
    assert [m.get_seq() for m in bench.heard] == [i % 256 for i in range(len(bench.heard))]
    assert not any(m.get_type() == "COMMAND_ACK" for m in messages)


def test_rate_holds_when_ticks_come_late(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for step_ms in [20, 20, 60, 140, 30, 90] * 20:
        bench.vehicle.advance(bench.vehicle.time_ms + step_ms)
        bench.services.report()
        bench.drain()
    seconds = bench.vehicle.time_ms / 1e3
    assert len(bench.of("GLOBAL_POSITION_INT")) == pytest.approx(5.0 * seconds, abs=3)
    times = [m.time_boot_ms for m in bench.of("ATTITUDE")]
    assert times == sorted(set(times))
