"""What a vehicle is asked to tell, and what is said of what does not come. Numbers are pymavlink's."""

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink import codec
from gcs.mavlink.stream_requests import CHECK_S, StreamRequests, needs

RATES_HZ = {need.name: need.rate_hz for need in needs(0.1)}


def asked(streams: StreamRequests, now_s: float, known: bool = True) -> dict[str, tuple[int, tuple[float, ...]]]:
    asks, _ = streams.poll(now_s, origin_known=known)
    return {ask.token: (ask.command.command, ask.command.params) for ask in asks}


def old_way(streams: StreamRequests, now_s: float) -> list[tuple[int, int]]:
    _, messages = streams.poll(now_s, origin_known=True)
    names = codec.layout("REQUEST_DATA_STREAM").record._fields
    fields = [dict(zip(names, message.values, strict=True)) for message in messages]
    return [(one["req_stream_id"], one["req_message_rate"]) for one in fields]


def hear(streams: StreamRequests, seconds: float, **left_out: float) -> None:
    for name, rate_hz in (RATES_HZ | left_out).items():
        for _ in range(round(seconds * rate_hz)):
            streams.received(codec.msgid(name), 0.0)


def test_each_message_is_asked_for_once_at_the_rate_that_is_needed() -> None:
    streams = StreamRequests(3, needs(0.1))
    first = asked(streams, 0.0)
    for name, rate_hz in RATES_HZ.items():
        number = float(getattr(mav, f"MAVLINK_MSG_ID_{name}"))
        assert first[f"stream {name}"] == (mav.MAV_CMD_SET_MESSAGE_INTERVAL, (number, pytest.approx(1e6 / rate_hz)))
    assert not any(token.startswith("stream") for token in asked(streams, 0.5))
    assert RATES_HZ["LOCAL_POSITION_NED"] == 10.0
    assert {need.name: need.rate_hz for need in needs(0.5)}["LOCAL_POSITION_NED"] == 2.0


def test_what_is_refused_is_asked_for_by_its_group_and_then_by_all() -> None:
    streams = StreamRequests(3, needs(0.1))
    asked(streams, 0.0)
    assert old_way(streams, 0.1) == []
    streams.answered("stream LOCAL_POSITION_NED", False)
    streams.answered("stream BATTERY_STATUS", False)
    streams.answered("stream ATTITUDE", True)
    position, extra3 = mav.MAV_DATA_STREAM_POSITION, mav.MAV_DATA_STREAM_EXTRA3
    assert old_way(streams, 0.2) == [(position, 10), (extra3, 1)]
    assert old_way(streams, 0.3) == []  # it has a second
    streams.received(codec.msgid("BATTERY_STATUS"), 0.5)
    assert old_way(streams, 1.3) == [(position, 10)]
    status, extra1 = mav.MAV_DATA_STREAM_EXTENDED_STATUS, mav.MAV_DATA_STREAM_EXTRA1
    everything = [(mav.MAV_DATA_STREAM_ALL, 10), (status, 2), (position, 10), (extra1, 4), (extra3, 1)]
    assert old_way(streams, 2.4) == everything  # all streams first, or it would undo the others' rates
    assert old_way(streams, 3.5) == everything
    assert old_way(streams, 4.6) == []


def test_what_does_not_come_or_too_seldom_is_named_once_and_again_when_it_comes() -> None:
    streams = StreamRequests(3, needs(0.1))
    asked(streams, 0.0)
    hear(streams, CHECK_S, BATTERY_STATUS=0.0, ATTITUDE=1.0)
    assert streams.check(CHECK_S - 0.1) == {}
    said = streams.check(CHECK_S)
    assert sorted(said) == [
        "ATTITUDE comes at less than half of the 4 Hz asked for", "BATTERY_STATUS does not come",
    ]  # fmt: skip
    assert streams.missing == ("ATTITUDE", "BATTERY_STATUS")
    hear(streams, CHECK_S, BATTERY_STATUS=0.0, ATTITUDE=1.0)
    assert streams.check(2 * CHECK_S) == {}
    hear(streams, CHECK_S, BATTERY_STATUS=0.0)
    assert streams.check(3 * CHECK_S) == {"ATTITUDE comes as it should now": True}
    assert streams.missing == ("BATTERY_STATUS",)


def test_what_begins_to_come_in_the_midst_of_a_count_is_counted_from_there() -> None:
    """An ArduCopter tells its position from when it has found it."""
    streams = StreamRequests(3, needs(0.1))
    asked(streams, 0.0)
    hear(streams, CHECK_S, LOCAL_POSITION_NED=0.0)
    assert streams.check(CHECK_S) == {"LOCAL_POSITION_NED does not come": False}
    hear(streams, CHECK_S, LOCAL_POSITION_NED=0.0)
    for k in range(10):
        streams.received(codec.msgid("LOCAL_POSITION_NED"), 2 * CHECK_S - 1.0 + 0.1 * k)
    assert streams.check(2 * CHECK_S) == {"LOCAL_POSITION_NED comes as it should now": True}
    hear(streams, CHECK_S, LOCAL_POSITION_NED=2.0)
    assert streams.check(3 * CHECK_S) == {"LOCAL_POSITION_NED comes at less than half of the 10 Hz asked for": False}


def test_what_was_granted_and_does_not_come_is_asked_for_the_old_way_too() -> None:
    streams = StreamRequests(3, needs(0.1))
    asked(streams, 0.0)
    hear(streams, CHECK_S, ATTITUDE=0.0)
    streams.check(CHECK_S)
    assert old_way(streams, CHECK_S + 0.1) == [(mav.MAV_DATA_STREAM_EXTRA1, 4)]


def test_who_says_nothing_of_what_was_asked_for_is_asked_again() -> None:
    """An ArduCopter that has booted sends its HEARTBEAT and little else; whether it flies is in no group."""
    streams = StreamRequests(3, needs(0.1))
    first = asked(streams, 0.0)
    hear(streams, CHECK_S)
    streams.check(CHECK_S)
    assert not any(token.startswith("stream") for token in asked(streams, CHECK_S))
    streams.check(2 * CHECK_S)
    again = asked(streams, 2 * CHECK_S)
    assert {token for token in again if token.startswith("stream")} == {t for t in first if t.startswith("stream")}
    hear(streams, CHECK_S)
    assert len(streams.check(3 * CHECK_S)) == len(RATES_HZ)
    assert not any(token.startswith("stream") for token in asked(streams, 3 * CHECK_S))


def test_the_origin_is_asked_for_until_it_is_known_and_now_and_then_after() -> None:
    streams = StreamRequests(3, needs(0.1))
    tokens = ("origin GPS_GLOBAL_ORIGIN", "origin HOME_POSITION")
    first = asked(streams, 0.0, known=False)
    numbers = [first[token] for token in tokens]
    assert numbers == [(mav.MAV_CMD_REQUEST_MESSAGE, (49.0,)), (mav.MAV_CMD_REQUEST_MESSAGE, (242.0,))]
    assert asked(streams, 1.9, known=False) == {}
    assert set(asked(streams, 2.0, known=False)) == set(tokens)
    assert asked(streams, 5.0) == {}
    assert set(asked(streams, 12.0)) == set(tokens)


def test_who_cannot_be_asked_for_a_message_is_asked_for_home_in_the_old_words() -> None:
    streams = StreamRequests(3, needs(0.1))
    (ask,) = streams.answered("origin HOME_POSITION", False)
    assert ask.command.command == mav.MAV_CMD_GET_HOME_POSITION
    assert streams.answered("origin GPS_GLOBAL_ORIGIN", False) == []
    assert streams.answered(ask.token, False) == []
    assert StreamRequests.owns(ask.token)
    assert not StreamRequests.owns("pilot arm")


def test_after_a_boot_everything_is_asked_for_again() -> None:
    streams = StreamRequests(3, needs(0.1))
    asked(streams, 0.0)
    streams.restart()
    assert {f"stream {name}" for name in RATES_HZ} <= set(asked(streams, 50.0))
