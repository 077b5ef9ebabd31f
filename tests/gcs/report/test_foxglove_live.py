"""A session as Foxglove sees it come, by its WebSocket protocol (github.com/foxglove/ws-protocol) read by hand."""

from __future__ import annotations

import json
import queue
import struct
import threading
from collections.abc import Iterator
from typing import Any

import pytest
from feed import session, snapshot
from web import Script, Stopping
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from gcs.report.foxglove_live import serve

BALL = {
    "name": None, "label": "ball 1", "kind": "sphere", "outline_ne": [], "centre_ned": [1.0, 2.0, -3.0],
    "radius_m": 0.5, "bottom_d": -2.5, "top_d": -3.5,
}  # fmt: skip
NOW_NS = 1_800_000_000_000_000_000


@pytest.fixture
def source() -> Script:
    return Script(session(origin=[47.4, 8.5, 400.0], obstacles=[BALL]), snapshot(10.0))


@pytest.fixture
def address(source: Script) -> Iterator[str]:
    addresses: queue.SimpleQueue[str] = queue.SimpleQueue()
    stopping = Stopping(source)
    thread = threading.Thread(target=serve, args=(stopping, addresses.put), kwargs={"clock_ns": lambda: NOW_NS})
    thread.start()
    try:
        yield addresses.get(timeout=30)
    finally:
        stopping.over = True
        thread.join(timeout=30)
        assert not thread.is_alive()


class Foxglove:
    """A client: what is advertised, and the messages of the topics that it subscribes to."""

    def __init__(self, socket: ClientConnection) -> None:
        self.socket = socket
        self.channels: dict[str, Any] = {}
        self.server: Any = {}

    def until(self, *topics: str) -> None:
        while not set(topics) <= self.channels.keys():
            told = json.loads(self.socket.recv(timeout=20))
            if told["op"] == "serverInfo":
                self.server = told
            elif told["op"] == "advertise":
                self.channels |= {one["topic"]: one for one in told["channels"]}

    def subscribe(self, *topics: str) -> None:
        wanted = [{"id": k, "channelId": self.channels[topic]["id"]} for k, topic in enumerate(topics)]
        self.socket.send(json.dumps({"op": "subscribe", "subscriptions": wanted}))

    def message(self) -> tuple[int, int, bytes]:
        """Subscription, time in ns and content of the next one."""
        while isinstance(told := self.socket.recv(timeout=20), str):
            continue
        opcode, subscription, at_ns = struct.unpack_from("<BIQ", told)
        assert opcode == 1
        return subscription, at_ns, told[13:]


def test_every_vehicle_comes_with_its_schema_and_time_and_what_stands_for_who_comes_late(
    source: Script, address: str
) -> None:
    with connect(address, subprotocols=[Subprotocol("foxglove.sdk.v1")], proxy=None) as socket:
        client = Foxglove(socket)
        client.until("/tf", "/scene", "/vehicle/3", "/location/3", "/competition")
        assert client.server["name"] == "Skytender: demo"
        assert client.server["capabilities"] == []
        assert client.channels["/tf"]["schemaName"] == "foxglove.FrameTransforms"
        assert "battery" in json.loads(client.channels["/vehicle/3"]["schema"])["properties"]
        client.subscribe("/scene", "/vehicle/3")
        drawn, rows, t_s = b"", [], 10.0
        while b"ball 1" not in drawn or not rows:
            t_s += 0.1
            source.feed(snapshot(t_s))
            subscription, at_ns, content = client.message()
            if subscription == 0:
                drawn += content
            else:
                rows.append((at_ns, json.loads(content)))
        at_ns, row = rows[0]
        assert row["sysid"] == 3
        begun_ns = NOW_NS - round(10.0e9)
        wanted = {vehicle["sysid"]: vehicle for vehicle in snapshot((at_ns - begun_ns) / 1e9)["vehicles"]}
        assert row["p_ned"] == pytest.approx(wanted[3]["p_ned"], abs=1e-6)


def test_two_at_once_have_two_ports(address: str) -> None:
    addresses: queue.SimpleQueue[str] = queue.SimpleQueue()
    stopping = Stopping(Script(session(obstacles=[]), snapshot(1.0)))
    thread = threading.Thread(target=serve, args=(stopping, addresses.put))
    thread.start()
    assert addresses.get(timeout=30) != address
    stopping.over = True
    thread.join(timeout=30)
    assert not thread.is_alive()
