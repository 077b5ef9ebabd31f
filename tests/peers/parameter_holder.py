"""A vehicle that holds parameters of every MAV_PARAM_TYPE, and a component beside its autopilot with its own.

Its frames are put together here by struct, and read byte by byte, so that no library rounds them. Integers stand in
PARAM_VALUE by their bytes (px4) or cast to a float (ardupilot). It says on stdout what it holds after each PARAM_SET:
the bytes, in hexadecimal. It has no files.
"""

from __future__ import annotations

import argparse
import math
import select
import socket
import struct
import time

from pymavlink.dialects.v20 import common as mav
from pymavlink.generator.mavcrc import x25crc

FORMS = dict(zip(range(1, 11), "BbHhIiQqfd", strict=True))
EACH = 16
"""Parameters of each type."""
READ_ONLY = "LOCKED"
COMPANION = 154
PERMISSION_DENIED, DOES_NOT_EXIST = 3, 1
NAK = 129


class Component:
    """Its parameters: name → (type, bytes)."""

    def __init__(self, compid: int, kinds: dict[str, int]) -> None:
        self.compid = compid
        self.held = {name: (kind, bytes(struct.calcsize(FORMS[kind]))) for name, kind in kinds.items()}


class Holder:
    """The vehicle at its socket."""

    def __init__(self, port: int, sysid: int, autopilot: int) -> None:
        self.sysid, self.autopilot = sysid, autopilot
        self.bytewise = autopilot == mav.MAV_AUTOPILOT_PX4
        kinds = {
            f"{mav.enums['MAV_PARAM_TYPE'][kind].name.removeprefix('MAV_PARAM_TYPE_')}_{number}": kind
            for kind, form in FORMS.items()
            for number in range(EACH)
            if not self.bytewise or struct.calcsize(form) <= 4
        }
        kinds[READ_ONLY] = 6
        self.components = {1: Component(1, kinds), COMPANION: Component(COMPANION, {"U8": 1, "F32": 9})}
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", port))
        self.seq = 0
        self.reader = mav.MAVLink(None)
        self.reader.robust_parsing = True

    def send(self, compid: int, cls: type[mav.MAVLink_message], payload: bytes) -> None:
        payload = payload.rstrip(b"\0") or b"\0"
        head = struct.pack("<BBBBBBHB", len(payload), 0, 0, self.seq, self.sysid, compid, cls.id & 0xFFFF, cls.id >> 16)
        crc = x25crc(head + payload + bytes([cls.crc_extra])).crc
        self.seq = (self.seq + 1) % 256
        self.socket.send(b"\xfd" + head + payload + struct.pack("<H", crc))

    def beat(self) -> None:
        self.send(1, mav.MAVLink_heartbeat_message, struct.pack("<IBBBBB", 0, 2, self.autopilot, 1, 3, 3))
        invalid = mav.MAV_AUTOPILOT_INVALID
        self.send(COMPANION, mav.MAVLink_heartbeat_message, struct.pack("<IBBBBB", 0, 18, invalid, 0, 4, 3))

    def value(self, of: Component, name: str) -> None:
        kind, raw = of.held[name]
        index = list(of.held).index(name)
        if not self.bytewise:
            (number,) = struct.unpack("<" + FORMS[kind], raw)
            raw = single(number)
        payload = raw.ljust(4, b"\0") + struct.pack("<HH16sB", len(of.held), index, name.encode(), kind)
        self.send(of.compid, mav.MAVLink_param_value_message, payload)

    def error(self, of: Component, name: str, index: int, code: int) -> None:
        payload = struct.pack("<hBB16sB", index, 255, 190, name.encode(), code)
        self.send(of.compid, mav.MAVLink_param_error_message, payload)

    def hear(self, heard: mav.MAVLink_message) -> None:
        of = self.components.get(getattr(heard, "target_component", -1))
        if of is None or heard.target_system != self.sysid:
            return
        frame = bytes(heard.get_msgbuf())
        payload = frame[10 : 10 + frame[1]].ljust(32, b"\0")
        match heard.get_type():
            case "PARAM_REQUEST_LIST":
                for name in of.held:
                    self.value(of, name)
            case "PARAM_REQUEST_READ":
                names = list(of.held)
                index = heard.param_index
                name = names[index] if 0 <= index < len(names) else heard.param_id
                if name in of.held:
                    self.value(of, name)
                else:
                    self.error(of, name, index, DOES_NOT_EXIST)
            case "FILE_TRANSFER_PROTOCOL":
                seq, session, opcode = struct.unpack_from("<HBB", payload, 3)
                head = struct.pack("<BBBHBBBBBBIB", 0, 255, 190, seq + 1 & 0xFFFF, session, NAK, 1, opcode, 0, 0, 0, 10)
                self.send(of.compid, mav.MAVLink_file_transfer_protocol_message, head)
            case "PARAM_SET":
                self.change(of, heard.param_id, payload[:4])

    def change(self, of: Component, name: str, raw: bytes) -> None:
        if name == READ_ONLY:
            self.error(of, name, -1, PERMISSION_DENIED)
        elif name in of.held:
            kind, _ = of.held[name]
            size = struct.calcsize(FORMS[kind])
            held = raw[:size]
            if not self.bytewise:
                (number,) = struct.unpack("<f", raw)
                held = raw if kind == 9 else struct.pack("<" + FORMS[kind], number if kind == 10 else int(number))
            of.held[name] = kind, held
            print("SET", of.compid, name, held.hex(), flush=True)
        if name in of.held:
            self.value(of, name)


def single(number: float) -> bytes:
    """A number's bytes as the float of C that it is cast to."""
    try:
        return struct.pack("<f", number)
    except OverflowError:
        return struct.pack("<f", math.copysign(math.inf, number))


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--port", type=int, required=True)
    options.add_argument("--sysid", type=int, required=True)
    options.add_argument("--autopilot", choices=("px4", "ardupilot"), required=True)
    given = options.parse_args()
    autopilot = mav.MAV_AUTOPILOT_PX4 if given.autopilot == "px4" else mav.MAV_AUTOPILOT_ARDUPILOTMEGA
    holder = Holder(given.port, given.sysid, autopilot)
    beat_s = 0.0
    while True:
        if time.monotonic() - beat_s >= 0.25:
            beat_s = time.monotonic()
            try:
                holder.beat()
            except ConnectionRefusedError:  # nobody listens yet
                continue
        if select.select([holder.socket], [], [], 0.05)[0]:
            try:
                data = holder.socket.recv(4096)
            except ConnectionRefusedError:
                continue
            for heard in holder.reader.parse_buffer(data) or []:
                holder.hear(heard)


if __name__ == "__main__":
    main()
