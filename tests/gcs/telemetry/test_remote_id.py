"""Remote ID as a line for a person; pymavlink writes the messages."""

from __future__ import annotations

from typing import Any

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.telemetry.remote_id import RemoteIds

NOBODY, INFO, WARNING = bytes(20), mav.MAV_SEVERITY_INFO, mav.MAV_SEVERITY_WARNING
OUT = mav.MAVLink(None, srcSystem=3, srcComponent=1)


def frame(message: Any) -> codec.Frame:
    return codec.split(bytes(message.pack(OUT))).frames[0]


def basic(own: bytes, of: bytes = NOBODY) -> codec.Frame:
    return frame(mav.MAVLink_open_drone_id_basic_id_message(0, 0, list(of), 1, 2, list(own.ljust(20, b"\0"))))


def location(status: int, of: bytes = NOBODY) -> codec.Frame:
    rest = (0, 0, 0, 0, 0, 0.0, 0.0, 0, 0.0, 0, 0, 0, 0, 0.0, 0)
    return frame(mav.MAVLink_open_drone_id_location_message(0, 0, list(of), status, *rest))


def test_id_and_status_are_said_together_and_when_one_changes() -> None:
    ids = RemoteIds()
    assert ids.receive(location(1)) is None
    assert ids.receive(basic(b"SKYT500003")) == (INFO, "Remote ID SKYT500003: on the ground")
    assert ids.receive(location(1)) is None
    assert ids.receive(location(2)) == (INFO, "Remote ID SKYT500003: airborne")
    assert ids.receive(location(3)) == (WARNING, "Remote ID SKYT500003: in an emergency")
    assert ids.receive(basic(bytes(range(1, 17)))) == (
        WARNING, "Remote ID 0102030405060708090a0b0c0d0e0f10: in an emergency",
    )  # fmt: skip
    assert ids.receive(location(9)) == (INFO, "Remote ID 0102030405060708090a0b0c0d0e0f10: status not declared")


def test_other_aircraft_that_a_transmitter_receives_are_passed_over() -> None:
    ids = RemoteIds()
    other = b"\x01".ljust(20, b"\0")
    assert [ids.receive(one) for one in (basic(b"OTHER", other), location(2, other))] == [None, None]
    assert ids.receive(frame(mav.MAVLink_heartbeat_message(2, 12, 0, 0, 4, 3))) is None
