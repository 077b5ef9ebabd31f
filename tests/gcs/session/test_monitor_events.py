"""EVENTs of a vehicle at `gcs monitor`: in words where it may ask for them, named where it may not."""

from __future__ import annotations

import json
import select
import socket
import struct
from typing import Any

import newer
import pytest
from metadata_vehicle import MetadataVehicle, crc32
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.scenario.endpoint import Endpoint
from gcs.session.monitor import MonitorSource

SYSID, METADATA = 3, 397.0
WORDS = "Arming denied: 2.2"
MOST_STEPS = 400


class Vehicle:
    """Answers on its socket, and says one and the same event until it is stopped."""

    def __init__(self, port: int) -> None:
        content = json.dumps({"version": 2, "components": {"1": {"namespace": "px4", "event_groups": {"default": {
            "events": {"7": {"name": "denied", "message": "Arming denied: {1:.1}", "arguments": [
                {"name": "a", "type": "float"}]}}}}}}}).encode()  # fmt: skip
        named = [{"type": 4, "uri": "mftp://events.json", "fileCrc": crc32(content)}]
        self._vehicle = MetadataVehicle(named, {"events.json": content})
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", port))
        self._out = mav.MAVLink(None, srcSystem=SYSID, srcComponent=1)
        self._in = mav.MAVLink(None)
        self.armed = False

    def say(self, *messages: Any) -> None:
        mode = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | (mav.MAV_MODE_FLAG_SAFETY_ARMED if self.armed else 0)
        beat = mav.MAVLink_heartbeat_message(mav.MAV_TYPE_QUADROTOR, mav.MAV_AUTOPILOT_PX4, mode, 0, 4, 3)
        self.socket.send(b"".join(message.pack(self._out) for message in (beat, *messages)))

    def answer(self) -> bool:
        """Answer what has come; whether anything has."""
        some = False
        while select.select([self.socket], [], [], 0.0)[0]:
            some = True
            for message in self._in.parse_buffer(self.socket.recv(4096)) or []:
                wanted = message.get_type() == "COMMAND_LONG" and message.param1 == METADATA
                if wanted or message.get_type() == "FILE_TRANSFER_PROTOCOL":
                    self.say(*self._vehicle.hear(message))
        return some


def event(number: int) -> Any:
    arguments = struct.pack("<f", 2.25).ljust(40, b"\0")
    return newer.dialect.MAVLink_event_message(0, 0, 1 << 24 | 7, 900, number, 0x44, arguments)


@pytest.mark.parametrize("control", [False, True])
def test_events_are_said_in_words_where_the_monitor_may_ask_for_them(control: bool) -> None:
    now = {"s": 0.0}
    source = MonitorSource(Endpoint("udpin", "127.0.0.1", 0), control=control, clock=lambda: now["s"])
    vehicle = Vehicle(source.port)
    twin = mav.MAVLink_statustext_message(4, f"{WORDS}\t".encode())
    said: list[str] = []
    spoken_to = False
    try:
        for step in range(MOST_STEPS):
            now["s"] = 0.1 * step
            new = [twin, event(5), event(6)] if step == 10 else []
            vehicle.say(*new, newer.dialect.MAVLink_current_event_sequence_message(6 if step >= 10 else 4, 0))
            assert select.select([source], [], [], 10.0)[0]
            said += [e["text"] for m in source.receive() if m["type"] == "snapshot" for e in m["events"]]
            spoken_to |= vehicle.answer()
            if said.count(WORDS) == 2:
                break
    finally:
        source.close()
        vehicle.socket.close()
    assert spoken_to is control
    assert said.count(WORDS) == (2 if control else 1)  # the STATUSTEXT, which is the first event's, and the second
    noted = [text for text in said if "Sends events (EVENT)" in text]
    assert len(noted) == (0 if control else 1)


def test_an_event_of_a_flight_is_said_after_it_with_its_age() -> None:
    """While it is armed it is not asked for its words."""
    now = {"s": 0.0}
    source = MonitorSource(Endpoint("udpin", "127.0.0.1", 0), control=True, clock=lambda: now["s"])
    vehicle = Vehicle(source.port)
    said: list[str] = []
    try:
        for step in range(MOST_STEPS):
            now["s"] = 0.1 * step
            vehicle.armed = step < 300
            vehicle.say(*([event(5)] if step == 10 else []))
            assert select.select([source], [], [], 10.0)[0]
            said += [e["text"] for m in source.receive() if m["type"] == "snapshot" for e in m["events"]]
            vehicle.answer()
            if any(WORDS in text for text in said):
                break
    finally:
        source.close()
        vehicle.socket.close()
    assert [text for text in said if WORDS in text] == [f"{WORDS} ({now['s'] - 1.0:.0f} s ago)"]


def test_an_order_to_a_vehicle_that_is_not_armed_is_taken_and_sent_to_none() -> None:
    """As a session takes it."""
    source = MonitorSource(Endpoint("udpin", "127.0.0.1", 0), control=True, clock=lambda: 0.0)
    vehicle = Vehicle(source.port)
    try:
        vehicle.say()
        assert select.select([source], [], [], 10.0)[0]
        source.receive()
        source.send({"command": "hold", "sysid": SYSID, "id": "1"})
        (reply,) = [message for message in source.receive() if message["type"] == "reply"]
        assert (reply["ok"], reply["text"]) == (True, f"copter {SYSID} is not armed, and stays where it is.")
    finally:
        source.close()
        vehicle.socket.close()
