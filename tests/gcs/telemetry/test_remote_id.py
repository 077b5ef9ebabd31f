"""Remote ID as the fleet reads it, for a person; pymavlink writes the messages."""

from __future__ import annotations

from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.session.observer import Observer
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.track import Member

NOBODY, INFO, WARNING = bytes(20), mav.MAV_SEVERITY_INFO, mav.MAV_SEVERITY_WARNING
OUT = mav.MAVLink(None, srcSystem=3, srcComponent=1)


def frame(message: Any) -> codec.Frame:
    return codec.split(bytes(message.pack(OUT))).frames[0]


def basic(own: bytes, of: bytes = NOBODY) -> codec.Frame:
    return frame(mav.MAVLink_open_drone_id_basic_id_message(0, 0, list(of), 1, 2, list(own.ljust(20, b"\0"))))


def location(status: int, of: bytes = NOBODY) -> codec.Frame:
    rest = (0, 0, 0, 0, 0, 0.0, 0.0, 0, 0.0, 0, 0, 0, 0, 0.0, 0)
    return frame(mav.MAVLink_open_drone_id_location_message(0, 0, list(of), status, *rest))


class RemoteIdReader:
    """A fleet of one vehicle, launched by a session or external: both are read by one way."""

    def __init__(self, *, external: bool = False) -> None:
        member = Member(3, "pursuer", "pursuer 3", 1e4, 1e4, external=external)
        self.fleet = Fleet([member], GlobalOrigin(47.4, 8.5, 488.0))

    def read(self, one: codec.Frame) -> list[tuple[int, str]]:
        """(severity, text) of what it makes people know."""
        self.fleet.ingest(one, 0.0)
        return [text[1:] for text in self.fleet.pop_statustexts(0.0)]


@pytest.mark.parametrize("external", [False, True])
def test_id_and_status_are_said_together_and_when_one_changes(external: bool) -> None:
    reader = RemoteIdReader(external=external)
    assert reader.read(location(1)) == []
    assert reader.fleet.remote_id(3) == ""
    assert reader.read(basic(b"SKYT500003")) == [(INFO, "Remote ID SKYT500003: on the ground")]
    assert reader.read(location(1)) == []
    assert reader.read(location(2)) == [(INFO, "Remote ID SKYT500003: airborne")]
    assert reader.fleet.remote_id(3) == "SKYT500003: airborne"
    assert reader.read(location(3)) == [(WARNING, "Remote ID SKYT500003: in an emergency")]
    own = "0102030405060708090a0b0c0d0e0f10"
    assert reader.read(basic(bytes(range(1, 17)))) == [(WARNING, f"Remote ID {own}: in an emergency")]
    assert reader.read(location(9)) == [(INFO, f"Remote ID {own}: status not declared")]


def test_other_aircraft_that_a_transmitter_receives_are_passed_over() -> None:
    reader, other = RemoteIdReader(), b"\x01".ljust(20, b"\0")
    assert reader.read(basic(b"OTHER", other)) + reader.read(location(2, other)) == []
    assert reader.fleet.remote_id(3) == ""


def test_a_monitor_and_a_replay_show_it_with_the_vehicle() -> None:
    observer = Observer("monitor", "fleet")
    observer.receive(frame(mav.MAVLink_heartbeat_message(2, 12, 0, 0, 4, 3)), 0.0)
    assert "remote_id" not in observer.snapshot(0.1, speed=1.0, phase="flying")["vehicles"][0]
    for one in (basic(b"SKYT500003"), location(2)):
        observer.receive(one, 0.2)
    observer.look(0.3)
    line = observer.snapshot(0.3, speed=1.0, phase="flying")
    assert line["vehicles"][0]["remote_id"] == "SKYT500003: airborne"
    assert [event["text"] for event in line["events"]] == ["Remote ID SKYT500003: airborne"]
