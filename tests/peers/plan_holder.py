"""A vehicle that holds a mission, a fence and rally points, as an ArduCopter or a PX4 does (kept_items.py).

One transfer at a time: an ArduCopter answers another station DENIED meanwhile, a PX4 ERROR. It answers each message
only after --late seconds, and once more after twice that; with --strays it also says, to another ground station, items
and counts of another mission. With --shared a second vehicle of the next system id speaks at the same socket, so that
their answers come interleaved.
"""

from __future__ import annotations

import argparse
import heapq
import select
import socket
import time
from collections.abc import Iterator
from typing import Any

from kept_items import FENCE, FIELDS, MISSION, Refused, arducopter, px4
from pymavlink.dialects.v20 import ardupilotmega as mav

ACCEPTED = mav.MAV_MISSION_ACCEPTED
HOME = {"frame": 0, "command": 16, "autocontinue": 1, "x": 473977420, "y": 85455940, "z": 488.0}
OTHER_STATION = (250, 190)
GIVEN_UP_S = 5.0
Peer = tuple[int, int]


class PlanHolder:
    """One vehicle. It makes answers; when they are sent is not its matter."""

    def __init__(self, sysid: int, options: argparse.Namespace) -> None:
        self.sysid, self.options = sysid, options
        self.ardupilot = options.autopilot == "ardupilot"
        self.plans: dict[int, list[dict[str, Any]]] = {kind: [] for kind in (0, 1, 2)}
        self.coming: list[dict[str, Any]] | None = None
        self.peer: Peer = (0, 0)
        self.kind = self.count = 0
        self.last_s = 0.0

    def held(self, kind: int) -> list[dict[str, Any]]:
        """Items as they are read: an ArduCopter's mission begins with its own home."""
        items = self.plans[kind]
        return [HOME, *items[1:]] if self.ardupilot and kind == MISSION and items else items

    def hear(self, m: Any, now_s: float) -> Iterator[mav.MAVLink_message]:
        to = (m.get_srcSystem(), m.get_srcComponent())
        kind = m.mission_type
        if now_s - self.last_s > GIVEN_UP_S:
            self.coming = None
        name = m.get_type()
        busy = self.coming is not None and self.peer != to
        if name != "MISSION_ACK" and busy:
            yield self.ack(to, mav.MAV_MISSION_DENIED if self.ardupilot else mav.MAV_MISSION_ERROR, kind)
            return
        match name:
            case "MISSION_REQUEST_LIST":
                yield mav.MAVLink_mission_count_message(*to, len(self.held(kind)), kind)
                if self.options.strays:
                    yield mav.MAVLink_mission_count_message(*OTHER_STATION, 3, kind)
            case "MISSION_REQUEST_INT":
                if self.options.strays:
                    yield self.item(OTHER_STATION, m.seq, HOME | {"z": 1000.0 + m.seq}, kind)
                items = self.held(kind)
                if m.seq < len(items):
                    yield self.item(to, m.seq, items[m.seq], kind)
                else:
                    yield self.ack(to, mav.MAV_MISSION_INVALID_SEQUENCE, kind)
            case "MISSION_CLEAR_ALL" if self.ardupilot and self.options.armed and kind == MISSION:
                yield self.ack(to, mav.MAV_MISSION_ERROR, kind)  # AP_Mission::clear: not while it is flown
            case "MISSION_CLEAR_ALL":
                self.plans[kind] = []
                yield self.ack(to, ACCEPTED, kind)
            case "MISSION_COUNT":
                self.last_s = now_s
                if m.count > self.options.room:
                    yield self.ack(to, mav.MAV_MISSION_NO_SPACE, kind)
                    return
                self.coming, self.peer, self.kind, self.count = [], to, kind, m.count
                if self.replaces(kind):
                    del self.plans[kind][m.count :]
                yield self.request()
            case "MISSION_ITEM_INT":
                yield from self.take(m, to, now_s)

    def take(self, m: Any, to: Peer, now_s: float) -> Iterator[mav.MAVLink_message]:
        if self.coming is None:
            return
        self.last_s = now_s
        if m.seq != len(self.coming):
            if self.ardupilot:
                yield self.ack(to, mav.MAV_MISSION_INVALID_SEQUENCE, self.kind)
            return
        try:
            self.coming.append(arducopter(m) if self.ardupilot else px4(m, new=self.options.new))
        except Refused as refused:
            self.coming = None
            yield self.ack(to, refused.result, self.kind)
            return
        if self.replaces(self.kind):
            self.plans[self.kind][m.seq : m.seq + 1] = self.coming[-1:]
        if len(self.coming) < self.count:
            yield self.request()
            return
        self.plans[self.kind], self.coming = self.coming, None
        yield self.ack(to, ACCEPTED, self.kind)

    def replaces(self, kind: int) -> bool:
        """Whether items replace what it has one by one, as they come: AP_Mission and AP_Rally do, AC_Fence does not."""
        return self.ardupilot and kind != FENCE

    def request(self) -> mav.MAVLink_message:
        assert self.coming is not None
        ask = mav.MAVLink_mission_request_message if self.ardupilot else mav.MAVLink_mission_request_int_message
        return ask(*self.peer, len(self.coming), self.kind)

    def ack(self, to: Peer, result: int, kind: int) -> mav.MAVLink_message:
        return mav.MAVLink_mission_ack_message(*to, result, kind)

    def item(self, to: Peer, seq: int, kept: dict[str, Any], kind: int) -> mav.MAVLink_message:
        values = {field: kept.get(field, 0) for field in FIELDS}
        frame, command, autocontinue = (values.pop(field) for field in FIELDS[:3])
        return mav.MAVLink_mission_item_int_message(
            *to, seq, frame, command, 0, autocontinue, *values.values(), mission_type=kind
        )


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--port", type=int, required=True)
    options.add_argument("--sysid", type=int, required=True)
    options.add_argument("--autopilot", choices=("px4", "ardupilot"), required=True)
    options.add_argument("--new", action="store_true", help="PX4 from 1.18 on")
    options.add_argument("--late", type=float, default=0.0)
    options.add_argument("--strays", action="store_true")
    options.add_argument("--shared", action="store_true")
    options.add_argument("--room", type=int, default=700)
    options.add_argument("--busy", action="store_true", help="another station's upload never ends")
    options.add_argument("--armed", action="store_true")
    given = options.parse_args()
    link = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    link.connect(("127.0.0.1", given.port))
    reader = mav.MAVLink(None)
    reader.robust_parsing = True
    ids = range(given.sysid, given.sysid + 1 + given.shared)
    vehicles = {sysid: (PlanHolder(sysid, given), mav.MAVLink(None, sysid, 1)) for sysid in ids}
    autopilot = mav.MAV_AUTOPILOT_PX4 if given.autopilot == "px4" else mav.MAV_AUTOPILOT_ARDUPILOTMEGA
    mode = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | (mav.MAV_MODE_FLAG_SAFETY_ARMED if given.armed else 0)
    beat_s = 0.0
    due: list[tuple[float, int, bytes]] = []
    number = 0
    while True:
        now_s = time.monotonic()
        out = [heapq.heappop(due)[2] for _ in range(len(due)) if due[0][0] <= now_s]
        if now_s - beat_s >= 0.25:
            beat_s = now_s
            out += [m.heartbeat_encode(2, autopilot, mode, 0, 4).pack(m) for _, m in vehicles.values()]
        try:
            for frame in out:
                link.send(frame)
            wait_s = min(0.05, max(0.0, due[0][0] - time.monotonic())) if due else 0.05
            data = link.recv(4096) if select.select([link], [], [], wait_s)[0] else b""
        except ConnectionRefusedError:  # nobody listens yet
            time.sleep(0.05)
            continue
        for heard in reader.parse_buffer(data) or [] if data else []:
            if not hasattr(heard, "mission_type") or heard.target_system not in vehicles or heard.target_component != 1:
                continue
            vehicle, m = vehicles[heard.target_system]
            if given.busy:
                vehicle.coming, vehicle.peer, vehicle.last_s = [], OTHER_STATION, now_s
            for answer in vehicle.hear(heard, now_s):
                frame = answer.pack(m)
                for late_s in {given.late, 2.0 * given.late}:
                    number += 1
                    heapq.heappush(due, (now_s + late_s, number, frame))


if __name__ == "__main__":
    main()
