"""Events of a vehicle: EVENT, its number, what is missed asked for again; read by pymavlink's generator of MAVLink's
definitions, their words by the definitions in the vehicle's own metadata, as libevents' README reads them."""

from __future__ import annotations

import ast
import re
import struct
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.services import events
from tests.simvehicle.mavlink.test_component_metadata import COMPONENT_METADATA, EVENTS, files

import newer  # isort: skip

SEQUENCE = 411
SIZES = {"uint8_t": "B", "uint16_t": "H", "int32_t": "i", "float": "f"}
SOURCES = Path(events.__file__).parents[1]
FREE_WORDS = ("Plan refused: ", "Transfer refused: ")
"""Announcements whose words are a reason of any kind."""


def listen(bench: Any) -> None:
    assert bench.result(mav.MAV_CMD_REQUEST_MESSAGE, float(SEQUENCE)) == mav.MAV_RESULT_ACCEPTED


def words(definitions: dict[str, Any], event: Any) -> str:
    """The message of an EVENT."""
    component = definitions["components"][str(event.id >> 24)]
    definition = component["event_groups"]["default"]["events"][str(event.id & 0xFFFFFF)]
    at, values = 0, []
    for argument in definition["arguments"]:
        enum = component["enums"].get(argument["type"])
        form = "<" + SIZES[enum["type"] if enum else argument["type"]]
        (value,) = struct.unpack_from(form, bytes(event.arguments), at)
        at += struct.calcsize(form)
        values.append(enum["entries"][str(value)]["description"] if enum else value)
    return re.sub(
        r"\{(\d+)(?::\.(\d+))?\}",
        lambda m: f"{values[int(m[1]) - 1]:.{m[2]}f}" if m[2] else str(values[int(m[1]) - 1]),
        definition["message"],
    )


def of(messages: list[Any], kind: str) -> list[Any]:
    return [message for message in messages if message.get_type() == kind]


def test_nothing_of_them_is_sent_until_a_station_asks(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0)
    bench.tick(30)
    assert not {m.get_msgId() for m in bench.heard} & set(newer.MESSAGES)
    assert [text.text for text in bench.of("STATUSTEXT")] == ["Armed"]


@pytest.mark.parametrize("how", ["metadata", "sequence", "event"])
def test_each_announcement_is_an_event_once_asked_for(vehicle_bench: Any, how: str) -> None:
    bench = vehicle_bench()
    if how == "event":
        bench.send(newer.dialect.MAVLink_request_event_message(1, 1, 1, 1))
    else:
        bench.command(mav.MAV_CMD_REQUEST_MESSAGE, float(SEQUENCE if how == "sequence" else COMPONENT_METADATA))
    bench.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0)
    said = bench.tick()
    (event,), (text,) = of(said, "EVENT"), of(said, "STATUSTEXT")
    assert words(files(bench)[EVENTS], event) == "Armed"
    assert text.text == "Armed\t"  # a station that shows events knows by it that it is the same
    assert (event.sequence, event.log_levels, event.destination_system) == (1, 0x66, 0)
    assert event.event_time_boot_ms == 100


def test_an_arming_that_is_refused_says_why(vehicle_bench: Any) -> None:
    bench = vehicle_bench(params={"SYS_FAILURE_EN": 1})
    listen(bench)
    bench.command(mav.MAV_CMD_INJECT_FAILURE, mav.FAILURE_UNIT_SENSOR_GPS, mav.FAILURE_TYPE_OFF, 0.0)
    bench.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0)
    definitions = files(bench)[EVENTS]
    said = [(words(definitions, event), event.log_levels) for event in bench.of("EVENT")]
    assert said == [("Injected: GPS failed", 0x22), ("Arming refused: GPS failed", 0x44)]


def test_the_number_of_the_last_event_comes_once_a_second(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    listen(bench)
    bench.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0)
    bench.heard.clear()
    bench.tick(50)
    numbers = [message.sequence for message in bench.of("CURRENT_EVENT_SEQUENCE")]
    assert len(numbers) == 5
    assert numbers[-1] == bench.of("EVENT")[-1].sequence


def test_events_are_sent_again_and_those_no_longer_kept_are_named(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for arm in (1.0, 0.0) * 25:
        bench.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, arm)
        bench.tick()
    again = bench.send(newer.dialect.MAVLink_request_event_message(1, 1, 50, 50))
    assert [(m.get_type(), m.sequence) for m in again] == [("EVENT", 50)]
    lost = bench.send(newer.dialect.MAVLink_request_event_message(1, 1, 17, 20))
    assert [(m.get_type(), m.sequence) for m in lost] == [
        ("RESPONSE_EVENT_ERROR", 17), ("RESPONSE_EVENT_ERROR", 18), ("EVENT", 19), ("EVENT", 20),
    ]  # fmt: skip
    assert {(m.sequence_oldest_available, m.target_system, m.target_component) for m in lost[:2]} == {(19, 255, 190)}
    everything = bench.send(newer.dialect.MAVLink_request_event_message(1, 1, 60, 59))
    assert len(everything) == events.KEPT


def announced() -> set[str]:
    """Words that vehicle code announces, with {} for what is put in."""
    found = set()
    for path in sorted(SOURCES.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            name = getattr(node.func, "attr", getattr(node.func, "id", "")) if isinstance(node, ast.Call) else ""
            if name not in ("announce", "complain", "_refuse") or not isinstance(node, ast.Call):
                continue
            text = node.args[-1]
            if isinstance(text, ast.Constant):
                found.add(text.value)
            elif isinstance(text, ast.JoinedStr):
                found.add("".join(part.value if isinstance(part, ast.Constant) else "{}" for part in text.values))
    return found


def test_every_announcement_is_an_event_but_those_in_free_words() -> None:
    plain = announced()
    assert len(plain) > 20
    assert not {w for w in plain if "{" not in w and events.event_of(w) is None}
    forms = {re.sub(r"\{[^}]*\}", "{}", form) for form in events.FORMS}
    parts = {words for words in plain if "{" in words and words != "{}: {}" and not words.startswith(FREE_WORDS)}
    assert {w for w in parts if w not in forms and w.replace("{}", "GPS failed") not in forms} <= {"Arming refused: {}"}
