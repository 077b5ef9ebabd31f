"""One file of a vehicle, read by MAVFTP: no socket and no clock here, time is an argument (s).

    reset    ResetSessions → ACK: what an earlier reader left open is closed
    open     OpenFileRO → ACK with a session
    burst    BurstReadFile from behind the last piece that came → pieces …, again and again, until NAK, end of file
    fill     ReadFile, piece by piece → what the burst lost
    close    TerminateSession, whose answer nobody needs

Every piece but the last has PIECE_BYTES: ArduPilot reads its packed parameters in pieces of one size only. A request's
number follows the last number of an answer, for a vehicle answers a number that it knows with what it answered then.
[lineage] MAVLink File Transfer Protocol, https://mavlink.io/en/services/ftp.html
"""

from __future__ import annotations

import struct
from enum import Enum
from typing import Any

from gcs.mavlink import codec
from gcs.mavlink.codec import Message

PIECE_BYTES = 239
REPEAT_S = 0.7
TRIES, FIRST_TRIES = 10, 3
"""Of a request without an answer; of the first, after which it is taken for granted that there is no MAVFTP."""
LARGEST_BYTES = 1 << 22
"""A longer file is given up: it is built in memory, piece by piece."""

TERMINATE, RESET, OPEN, READ, BURST, ACK, NAK = 1, 2, 4, 5, 15, 128, 129
END_OF_FILE = 6
ERRORS = {
    1: "it failed",
    2: "it failed",
    4: "it knows no such session",
    5: "somebody else reads from it",
    7: "it knows no such request",
    9: "it protects the file",
    10: "it has no such file",
}
_HEAD = struct.Struct("<HBBBBBxI")
_SIZE = struct.Struct("<I")
_PAYLOAD_BYTES = 251


class _Stage(Enum):
    RESET = RESET
    OPEN = OPEN
    BURST = BURST
    FILL = READ
    DONE = 0


class FileClient:
    """The dialogue with one vehicle about one file."""

    def __init__(self, sysid: int, compid: int, path: str, first_bytes: int | None = None) -> None:
        """first_bytes: only so much of it is read, and a shorter file is not it; None: all that it has."""
        self.sysid, self.compid, self.path = sysid, compid, path
        self.content: bytes | None = None
        """the whole file, once it has come"""
        self.problem = ""
        """why it did not come, in words"""
        self._stage = _Stage.RESET
        self._number = self._last_number = self._session = 0
        self._asked = (0, 0)
        self._pieces: dict[int, bytes] = {}
        self._first_missing = self._highest = self._begun_at = 0
        self._end = self._wanted = first_bytes
        self._tries = 0
        self._due_s = 0.0
        self._to_close = False

    @property
    def bytes_so_far(self) -> int:
        """Of the file, what has come."""
        return PIECE_BYTES * len(self._pieces)

    @property
    def done(self) -> bool:
        """Whether nothing is open."""
        return self._stage is _Stage.DONE and not self._to_close

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if name != "FILE_TRANSFER_PROTOCOL" or self._stage is _Stage.DONE:
            return
        raw = bytes(content.payload)
        number, session, opcode, size, answers, complete, offset = _HEAD.unpack_from(raw)
        data = raw[_HEAD.size : _HEAD.size + size]
        if opcode not in (ACK, NAK) or answers != self._stage.value:
            return
        if self._stage in (_Stage.BURST, _Stage.FILL) and session != self._session:
            return
        self._last_number = number
        if opcode == NAK:
            self._refused(data)
        elif self._stage is _Stage.RESET:
            self._go_on(_Stage.OPEN)
        elif self._stage is _Stage.OPEN:
            self._session, self._to_close = session, True
            self._go_on(_Stage.BURST)
            if self._wanted is not None and (size != 4 or _SIZE.unpack(data)[0] < self._wanted):
                self._give_up(f"{self.path} is shorter than {self._wanted} bytes")
        else:
            self._put(offset, data)
            self._tries, self._due_s = 0, now_s + REPEAT_S
            if complete or self._stage is _Stage.FILL:
                self._due_s = now_s
            self._look_on()

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        if self._stage is _Stage.DONE:
            if not self._to_close:
                return []
            self._to_close = False
            return [self.end()]
        if now_s < self._due_s:
            return []
        if self._tries >= (FIRST_TRIES if self._stage is _Stage.RESET else TRIES):
            came = f"after {self._first_missing} bytes " if self._first_missing else ""
            self._give_up(f"no answer {came}to a request for {self.path}, though it was asked {self._tries} times")
            return self.poll(now_s)
        self._tries += 1
        self._due_s = now_s + REPEAT_S
        if self._stage is _Stage.OPEN:
            return [self._request(OPEN, data=self.path.encode("ascii"))]
        if self._stage is _Stage.RESET:
            return [self._request(RESET)]
        self._begun_at = self._highest if self._stage is _Stage.BURST else self._first_missing
        return [self._request(self._stage.value, offset=self._begun_at, size=PIECE_BYTES)]

    def end(self) -> Message:
        """The message that ends the transfer."""
        return self._request(TERMINATE)

    def _refused(self, data: bytes) -> None:
        reason = data[0] if data else 0
        if self._stage is _Stage.RESET:
            self._go_on(_Stage.OPEN)  # it knows none: nothing is open, or it says so of the file
        elif self._stage is _Stage.BURST and reason == END_OF_FILE:
            # The last pieces may be lost, and what the answer says of its place is with some autopilots the last
            # piece's: the end is where it is the first answer.
            if self._last_number == (self._number + 1) % (1 << 16):
                if self._wanted is not None:
                    self._give_up(f"{self.path} ended after {self._begun_at} of {self._wanted} bytes")
                    return
                self._end = self._begun_at
            self._tries, self._due_s = 0, 0.0
            self._look_on()
        else:
            self._give_up(f"{self.path}: {ERRORS.get(reason, f'refused ({reason})')}")

    def _put(self, offset: int, data: bytes) -> None:
        """Keep a piece."""
        if self._wanted is not None:
            data = data[: max(self._wanted - offset, 0)]
        if offset % PIECE_BYTES or not data:
            return
        self._pieces.setdefault(offset, data)
        self._highest = max(self._highest, offset + len(data))
        if len(data) < PIECE_BYTES and self._wanted is None:
            self._end = offset + len(data)
        while self._first_missing in self._pieces:
            self._first_missing += len(self._pieces[self._first_missing])

    def _look_on(self) -> None:
        """End where everything has come, or there is more than is taken; fill what is missing where the end is
        known."""
        if self._highest > LARGEST_BYTES and self._wanted is None:
            self._give_up(f"{self.path} has more than {LARGEST_BYTES} bytes")
        elif self._end is not None and self._first_missing >= self._end:
            self.content = b"".join(self._pieces[at] for at in sorted(self._pieces))
            self._stage = _Stage.DONE
        elif self._end is not None and self._highest >= self._end and self._stage is _Stage.BURST:
            self._go_on(_Stage.FILL)

    def _go_on(self, stage: _Stage) -> None:
        self._stage, self._tries, self._due_s = stage, 0, 0.0

    def _give_up(self, why: str) -> None:
        self.problem, self._stage = why, _Stage.DONE

    def _request(self, opcode: int, *, offset: int = 0, size: int = 0, data: bytes = b"") -> Message:
        if self._asked != (opcode, offset):  # else it is repeated, and so is the answer to it
            self._asked, self._number = (opcode, offset), (self._last_number + 1) % (1 << 16)
        session = self._session if opcode in (READ, BURST, TERMINATE) else 0
        head = _HEAD.pack(self._number, session, opcode, size or len(data), 0, 0, offset)
        return codec.message(
            "FILE_TRANSFER_PROTOCOL",
            target_network=0,
            target_system=self.sysid,
            target_component=self.compid,
            payload=list((head + data).ljust(_PAYLOAD_BYTES, b"\0")),
        )
