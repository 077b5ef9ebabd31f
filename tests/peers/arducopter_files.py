"""Files of a scripted ArduCopter by MAVFTP: its parameters, packed. One file is open at a time, a request that is
repeated alone is answered as before, and a burst of pieces ends with its number, or with NAK at the file's end."""

from __future__ import annotations

import random
import struct
from typing import Any

from pymavlink.dialects.v20 import common as mav

PIECE_BYTES = 239
ACK, NAK = 128, 129
TERMINATE, RESET, LIST, OPEN, READ, BURST = 1, 2, 3, 4, 5, 15
FAIL, INVALID_SESSION, END_OF_FILE, UNKNOWN, NOT_FOUND = 1, 4, 6, 7, 10
FORMS = {1: "<b", 2: "<h", 3: "<i", 4: "<f"}


def packed(parameters: dict[str, tuple[float, int]], read_size: int = PIECE_BYTES) -> bytes:
    """As ArduPilot's AP_Filesystem/README.md says, no value across the border of two pieces."""
    raw, before = struct.pack("<HHH", 0x671B, len(parameters), len(parameters)), ""
    for name, (number, kind) in parameters.items():
        shared = next((k for k in range(min(len(name), len(before))) if name[k] != before[k]), len(before))
        shared = min(shared, len(name) - 1, 15)
        value = struct.pack(FORMS[kind], number if kind == 4 else int(number))
        one = bytes([kind, shared | (len(name) - shared - 1) << 4]) + name[shared:].encode() + value
        over = (len(raw) + len(one)) % read_size
        raw += b"\0" * (len(value) - over if 0 < over < len(value) else 0) + one
        before = name
    return raw


class Files:
    """A vehicle's files. A burst has `burst` pieces; what is sent is lost with a chance of `lose`, either way."""

    def __init__(self, files: dict[str, bytes], *, lose: float = 0.0, burst: int = 40, knows: bool = True) -> None:
        self.files, self.lose, self.burst, self.knows = files, lose, burst, knows
        self.random = random.Random(7)
        self.open: bytes | None = None
        self.last: tuple[int, list[Any]] = (-1, [])
        self.asked: list[int] = []

    def hear(self, heard: Any) -> list[Any]:
        """Answers to a FILE_TRANSFER_PROTOCOL."""
        self.asker = heard.get_srcSystem(), heard.get_srcComponent()
        raw = bytes(heard.payload)
        number, session, opcode, size, _, _, offset = struct.unpack_from("<HBBBBBxI", raw)
        if number == self.last[0] and len(self.last[1]) == 1:
            return self.last[1]
        self.asked.append(opcode)
        self.number = number
        answers = self.answers(session, opcode, size, offset, raw[12 : 12 + size])
        self.last = number, answers
        return answers

    def answers(self, session: int, opcode: int, size: int, offset: int, data: bytes) -> list[Any]:
        if not self.knows:
            return [self.say(NAK, opcode, bytes([UNKNOWN]))]
        if opcode in (RESET, TERMINATE):
            self.open = None
            return [self.say(ACK, opcode)]
        if opcode == LIST:
            return [self.listed(data.decode(), offset)]
        if opcode == OPEN:
            if self.open is not None:
                return [self.say(NAK, opcode, bytes([FAIL]))]
            if (content := self.files.get(data.decode())) is None:
                return [self.say(NAK, opcode, bytes([NOT_FOUND]))]
            self.open = content
            return [self.say(ACK, opcode, struct.pack("<I", 1 << 20))]  # of a file that is made as it is read
        if self.open is None:
            return [self.say(NAK, opcode, bytes([INVALID_SESSION]))]
        if opcode == READ:
            piece = self.open[offset : offset + size]
            return [self.say(ACK, opcode, piece, offset) if piece else self.say(NAK, opcode, bytes([END_OF_FILE]))]
        out = []
        for k in range(self.burst):
            at = offset + k * size
            piece = self.open[at : at + size]
            if not piece:
                out.append(self.say(NAK, opcode, bytes([END_OF_FILE]), at - size if k else 0))
                break
            out.append(self.say(ACK, opcode, piece, at, complete=k == self.burst - 1))
        return out

    def listed(self, folder: str, begin: int) -> Any:
        """Entries of a folder from one on, as many as go into a piece; `.` and `..` are kept back, and count."""
        below = {path[len(folder) + 1 :]: len(content) for path, content in self.files.items()
                 if path.startswith(f"{folder}/")}  # fmt: skip
        if not below:
            return self.say(NAK, LIST, bytes([NOT_FOUND]))
        folders = sorted({name.partition("/")[0] for name in below if "/" in name})
        files = [f"F{name}\t{size}" for name, size in below.items() if "/" not in name]
        piece = b""
        for entry in ["S", "S", *(f"D{name}" for name in folders), *files][begin:]:
            if len(piece) + len(entry) + 1 > PIECE_BYTES:
                break
            piece += entry.encode() + b"\0"
        return self.say(ACK, LIST, piece, begin) if piece else self.say(NAK, LIST, bytes([END_OF_FILE]), begin)

    def say(self, answer: int, opcode: int, data: bytes = b"", offset: int = 0, *, complete: bool = False) -> Any:
        self.number = (self.number + 1) % 65536
        head = struct.pack("<HBBBBBxI", self.number, 0, answer, len(data), opcode, complete, offset)
        return mav.MAVLink_file_transfer_protocol_message(0, *self.asker, (head + data).ljust(251, b"\0"))
