"""Requests of MAVFTP to one vehicle and its answers, numbered over all dialogues with it.

A request's number follows the last one, of an answer or a request, for a vehicle answers a number that it knows with
what it answered then; a request that is repeated keeps its number, unless its answer is that to another request, which
had the number before.
[lineage] MAVLink File Transfer Protocol, https://mavlink.io/en/services/ftp.html
"""

from __future__ import annotations

import struct
from typing import Any, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.codec import Message

PIECE_BYTES = 239
REPEAT_S = 0.7
TRIES, FIRST_TRIES = 10, 3
"""Of a request without an answer; of the first, after which it is taken for granted that there is no MAVFTP."""

TERMINATE, RESET, LIST, OPEN, READ, BURST, ACK, NAK = 1, 2, 3, 4, 5, 15, 128, 129
END_OF_FILE = 6
ERRORS = {
    1: "it failed",
    2: "it failed",
    4: "it knows no such session",
    5: "another client reads from it",
    7: "it knows no such request",
    9: "it protects the file",
    10: "it has no such file",
}
_HEAD = struct.Struct("<HBBBBBxI")
_PAYLOAD_BYTES = 251
_NOTHING = (0, 0, b"")


class FileAnswer(NamedTuple):
    """Answer of a vehicle."""

    refused: bool
    session: int
    complete: bool
    """whether a burst ends here"""
    offset: int
    data: bytes

    @property
    def reason(self) -> int:
        """Of a refusal, one of MAVFTP's errors; 0 where it gives none."""
        return self.data[0] if self.data else 0

    @property
    def why(self) -> str:
        """Of a refusal, for a person."""
        return ERRORS.get(self.reason, f"refused ({self.reason})")


class FileRequests:
    """The numbers of all requests to one vehicle."""

    def __init__(self, sysid: int, compid: int) -> None:
        self.sysid, self.compid = sysid, compid
        self._number = self._answered = self._last = 0
        """of the last request, the last answer, and the later one of the two"""
        self._asked = _NOTHING
        self.has_answered = False
        """whether the vehicle has ever answered"""

    @property
    def answered_first(self) -> bool:
        """True where the last answer was the first to the last request, not a later one of a burst."""
        return self._answered == (self._number + 1) % (1 << 16)

    def answer(self, name: str, content: Any, opcode: int, of_session: int | None = None) -> FileAnswer | None:
        """The answer to a request with this opcode, of one session where one is given, in a message of the vehicle's,
        its name and fields; None where the message is none."""
        if name != "FILE_TRANSFER_PROTOCOL":
            return None
        raw = bytes(content.payload)
        number, session, kind, size, answers, complete, offset = _HEAD.unpack_from(raw)
        if kind in (ACK, NAK) and answers != opcode and number == (self._number + 1) % (1 << 16):
            self._last, self._asked = number, _NOTHING
        if kind not in (ACK, NAK) or answers != opcode or of_session not in (None, session):
            return None
        self._answered = self._last = number
        self.has_answered = True
        return FileAnswer(kind == NAK, session, bool(complete), offset, raw[_HEAD.size : _HEAD.size + size])

    def request(self, opcode: int, *, session: int = 0, offset: int = 0, size: int = 0, data: bytes = b"") -> Message:
        """A request."""
        if self._asked != (opcode, offset, data):  # else it is repeated, and so is the answer to it
            self._asked, self._number = (opcode, offset, data), (self._last + 1) % (1 << 16)
            self._last = self._number
        head = _HEAD.pack(self._number, session, opcode, size or len(data), 0, 0, offset)
        return codec.message(
            "FILE_TRANSFER_PROTOCOL",
            target_network=0,
            target_system=self.sysid,
            target_component=self.compid,
            payload=list((head + data).ljust(_PAYLOAD_BYTES, b"\0")),
        )
