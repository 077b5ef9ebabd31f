"""Which vehicle, and which component of it, a frame is of: by system, component and address."""

from __future__ import annotations

import select
import socket
from collections.abc import Iterator
from contextlib import ExitStack
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.scenario.endpoint import Endpoint
from gcs.session.monitor import MonitorSource

INVALID, PX4 = mav.MAV_AUTOPILOT_INVALID, mav.MAV_AUTOPILOT_PX4


class Component:
    """Speaks from a port of its own."""

    def __init__(self, port: int, sysid: int, compid: int, kind: int, autopilot: int = INVALID) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", port))
        self._mav = mav.MAVLink(None, srcSystem=sysid, srcComponent=compid)
        self._beat = mav.MAVLink_heartbeat_message(kind, autopilot, 0, 4 << 16 | 3 << 24, 4, 3)

    def say(self, *messages: Any) -> None:
        for message in (self._beat, *messages):
            self.socket.send(bytes(message.pack(self._mav)))
            self._mav.seq = (self._mav.seq + 1) % 256


def attitude(yaw_rad: float) -> Any:
    return mav.MAVLink_attitude_message(0, 0.0, 0.0, yaw_rad, 0.0, 0.0, 0.0)


NOW = {"s": 0.0}


@pytest.fixture
def source() -> Iterator[MonitorSource]:
    one = MonitorSource(Endpoint("udpin", "127.0.0.1", 0), clock=lambda: NOW["s"])
    yield one
    one.close()


def heard(source: MonitorSource) -> list[Any]:
    """What the monitor says after one datagram more."""
    assert select.select([source], [], [], 10.0)[0]
    return source.receive()


def events(messages: list[Any]) -> list[str]:
    return [event["text"] for m in messages if m["type"] == "snapshot" for event in m["events"]]


def test_every_component_may_have_a_port_of_its_own_and_only_a_second_autopilot_is_another_vehicle(
    source: MonitorSource,
) -> None:
    said: list[Any] = []
    with ExitStack() as stack:

        def component(*of: int) -> Component:
            made = Component(source.port, *of)
            stack.enter_context(made.socket)
            return made

        autopilot = component(1, 1, mav.MAV_TYPE_QUADROTOR, PX4)
        autopilot.say(attitude(0.5))
        said += heard(source)
        kinds = sorted(mav.enums["MAV_TYPE"])
        for compid in range(2, 256):
            for _ in range(2):  # the second from another port than the first
                component(1, compid, kinds[compid % len(kinds)]).say(attitude(2.5))
                said += heard(source)
        autopilot.say(attitude(0.5))
        twin = component(1, 1, mav.MAV_TYPE_QUADROTOR, PX4)
        twin.say(attitude(-1.0))
        while not any("Another vehicle" in text for text in events(said)):
            select.select([source], [], [], 1.0)
            NOW["s"] += 0.2
            said += source.receive()
        port, kept = twin.socket.getsockname()[1], autopilot.socket.getsockname()[1]
    assert [text for text in events(said) if "that it is" in text] == [
        f"Another vehicle says that it is 1, from 127.0.0.1:{port}: ignored, the one at 127.0.0.1:{kept} is kept"
    ]
    (row,) = said[-1]["vehicles"]
    assert row["heading_rad"] == pytest.approx(0.5)
    assert row["lost"] == 0
