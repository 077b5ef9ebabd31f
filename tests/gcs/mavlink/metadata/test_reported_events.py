"""Events of a scripted vehicle with PX4's habits over a link that loses: their order, and their words by definitions as
PX4 writes them (src/lib/events of PX4, mavlink/libevents libs/test.json)."""

from __future__ import annotations

import json
import random
import struct
from typing import Any

import newer
import pytest
from dialogue import heard, received
from metadata_vehicle import MetadataVehicle, crc32
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink.metadata.event_stream import EventStream
from gcs.mavlink.metadata.event_words import EventDefinitions
from gcs.mavlink.metadata.reported_events import ReportedEvents

PATH = "etc/extras/all_events.json"
U8 = "uint8_t"
DEFINED: dict[int, tuple[str, str, str, list[str]]] = {
    1: ("default", "", "Armed by {1}", ["arm_reason_t"]),
    2: ("default", "append_health_and_arming_messages", "Arming denied: resolve system health failures first", [U8]),
    3: ("arming_check", "summary", "Arming check summary", [U8, U8]),
    4: ("arming_check", "", "Battery {3} unhealthy", ["navigation_mode_group_t", U8, U8]),
    5: ("health", "summary", "Health summary", [U8]),
    6: ("calibration", "", "Calibration progress: {1}%", [U8]),
    7: ("default", "", "Fence at {1:.1m_v}, {2m/s}; see <param>GF_MAX</param>", ["float", "float"]),
    8: ("default", "", '<profile name="dev">raw {1} </profile>Sides left: {1}', ["sides_t"]),
    9: ("default", "", "\\{1} is \\<b> at {9}", []),
    10: ("default", "append_health_and_arming_messages", "Failsafe warning:", [U8]),
}
SPACE = {
    "namespace": "px4",
    "enums": {
        "arm_reason_t": {"type": "uint8_t", "entries": {"1": {"name": "stick", "description": "RC stick"}}},
        "navigation_mode_group_t": {"type": "uint32_t", "is_bitfield": True, "entries": {}},
        "sides_t": {
            "type": "int16_t", "is_bitfield": True, "separator": ", ",
            "entries": {"1": {"name": "t", "description": "tail"}, "4": {"name": "n", "description": "nose"}},
        },
    },
    "event_groups": {
        group: {
            "events": {
                str(number): {
                    "name": f"e{number}", "message": text, "type": kind,
                    "arguments": [{"name": f"a{k}", "type": of} for k, of in enumerate(arguments)],
                }
                for number, (other, kind, text, arguments) in DEFINED.items()
                if other == group
            }
        }
        for group in {row[0] for row in DEFINED.values()}
    },
}  # fmt: skip
CONTENT = json.dumps({"version": 2, "components": {"1": SPACE}}).encode()
WORDS = EventDefinitions(CONTENT)


def event(sequence: int, number: int, arguments: bytes = b"", *, level: int = 6, time_ms: int = 1000) -> Any:
    packed = arguments.ljust(40, b"\0")
    return newer.dialect.MAVLink_event_message(0, 0, 1 << 24 | number, time_ms, sequence, level, packed)


def number(sequence: int, flags: int = 0) -> tuple[str, Any]:
    return received(newer.dialect.MAVLink_current_event_sequence_message(sequence, flags))


@pytest.mark.parametrize(
    ("of", "arguments", "text"),
    [
        (1, b"\x01", "Armed by RC stick"),
        (1, b"\x09", "Armed by 9"),
        (7, struct.pack("<ff", 30.26, 2.5), "Fence at 30.3 m, 2.5 m/s; see GF_MAX"),
        (8, struct.pack("<h", 5), "Sides left: tail, nose"),
        (9, b"", "{1} is <b> at"),
    ],
)
def test_an_event_is_said_by_its_definition(of: int, arguments: bytes, text: str) -> None:
    words = WORDS.words(1 << 24 | of, arguments)
    assert words is not None
    assert words.text == text


def test_what_is_not_defined_has_no_words() -> None:
    assert WORDS.words(2 << 24 | 1, b"\x01") is None
    assert WORDS.words(1 << 24 | 4, b"\x01") is None  # its arguments are longer


@pytest.mark.parametrize("lose", [0.0, 0.3, 0.6])
@pytest.mark.parametrize("first", [1, 65_500])
def test_every_event_comes_once_and_in_order_whatever_the_link_loses(first: int, lose: float) -> None:
    chance, stream, now_s = random.Random(first), EventStream(3, 1), 0.0
    sent = {(first + k) % 65_536: event((first + k) % 65_536, 1) for k in range(80)}
    came = [content.sequence for content in stream.receive(*number((first - 1) % 65_536))]
    order = list(sent)
    for step in range(4000):
        now_s += 0.05
        if step < len(order) and chance.random() >= lose:
            came += [one.sequence for one in stream.receive(*received(sent[order[step]]))]
        if step >= len(order) and step % 20 == 0:
            came += [one.sequence for one in stream.receive(*number(order[-1]))]
        for message in stream.poll(now_s):
            asked = heard(message)
            assert (asked.target_system, asked.first_sequence) == (3, asked.last_sequence)
            if chance.random() >= lose and asked.first_sequence in order[: step + 1]:
                came += [one.sequence for one in stream.receive(*received(sent[asked.first_sequence]))]
    assert sorted([*came]) == sorted(came)
    missing = [sequence for sequence in order if sequence not in came]
    assert len(missing) == stream.lost
    assert came == [sequence for sequence in order if sequence not in missing]
    assert stream.lost <= (0 if lose < 0.5 else 20)


def test_what_the_vehicle_no_longer_has_is_lost_and_counted() -> None:
    stream = EventStream(3, 1)
    stream.receive(*number(10))
    assert [one.sequence for one in stream.receive(*received(event(20, 1)))] == []
    error = newer.dialect.MAVLink_response_event_error_message(255, 190, 11, 19, 0)
    assert stream.receive(*received(error)) == []
    assert stream.lost == 8
    assert [one.sequence for one in stream.receive(*received(event(19, 1)))] == [19, 20]


def test_a_vehicle_that_has_booted_counts_anew() -> None:
    stream = EventStream(3, 1)
    assert len(stream.receive(*received(event(900, 1, time_ms=500_000)))) == 1
    assert [one.sequence for one in stream.receive(*received(event(1, 1, time_ms=900)))] == [1]
    stream.receive(*number(700))
    stream.receive(*number(0, flags=1))
    assert stream.poll(100.0) == []


def test_texts_are_said_once_the_vehicles_own_metadata_has_come() -> None:
    named = [{"type": 4, "uri": f"mftp://{PATH}", "fileCrc": crc32(CONTENT)}]
    vehicle, reported, now_s = MetadataVehicle(named, {PATH: CONTENT}), ReportedEvents(3, 1), 0.0
    report = [
        event(1, 3, b"\0\0"), event(2, 4, b"\1\0\0\0\0\2"), event(3, 5, b"\0"), event(4, 2, b"\0", level=2),
        event(5, 6, b"\5"), event(6, 1, b"\1", level=8), event(7, 1, b"\1"), event(8, 10, b"\0", level=4),
    ]  # fmt: skip
    said = [text for one in report for text in reported.receive(*received(one), now_s)]
    assert said == []
    now_s = 30.0
    ask = mav.MAVLink_command_long_message(3, 1, mav.MAV_CMD_REQUEST_MESSAGE, 0, 397.0, 0, 0, 0, 0, 0, 0)
    waiting = vehicle.hear(ask)
    while reported.definitions is None:
        now_s += 0.05
        assert now_s < 90.0
        for answer in waiting:
            said += reported.receive(*received(answer), now_s)
        waiting = []
        for message in reported.poll(now_s):
            asked = heard(message)
            waiting += vehicle.hear(asked)
    denied = "Arming denied: resolve system health failures first; Battery 2 unhealthy"
    warned = "Failsafe warning: Battery 2 unhealthy"
    assert said == [(2, denied, 0.0), (6, "Armed by RC stick", 0.0), (4, warned, 0.0)]
