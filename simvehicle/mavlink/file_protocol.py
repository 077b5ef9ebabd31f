"""MAVFTP without a socket, a file or a clock, read-only: a vehicle's files are its metadata and its log, `@LOG/NUMBER`.

Rules:
1. One session, 0. OpenFileRO opens it for the station that asks, even if another had it before, and says how long
   the file is; a log is read as far as it has been written then. ResetSessions and TerminateSession close it.
2. ReadFile gives one piece. BurstReadFile gives all from a place on, PIECES_A_TICK in each tick, then NAK, end of file.
3. Another file is NAK, file not found; requests to write or to look elsewhere are NAK, unknown command.
[lineage] MAVLink File Transfer Protocol, https://mavlink.io/en/services/ftp.html
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any, NamedTuple

from simvehicle.mavlink.codec import message
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import Call
from simvehicle.mavlink.log_protocol import PIECES_A_TICK, Log
from skytender import mavlink as mav

MESSAGE = mav.MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL
PIECE_BYTES = 239
TERMINATE, RESET, OPEN, READ, BURST, ACK, NAK = 1, 2, 4, 5, 15, 128, 129
INVALID_SESSION, END_OF_FILE, UNKNOWN_COMMAND, NOT_FOUND = 4, 6, 7, 10
_HEAD = struct.Struct("<HBBBBBxI")
_PAYLOAD_BYTES = 251


class _Request(NamedTuple):
    number: int
    session: int
    opcode: int
    size: int
    offset: int
    data: bytes

    @classmethod
    def of(cls, payload: bytes) -> _Request:
        number, session, opcode, size, _, _, offset = _HEAD.unpack_from(payload)
        return cls(number, session, opcode, size, offset, payload[_HEAD.size : _HEAD.size + size])


class FileService:
    """The files of one vehicle, on all its connections."""

    def __init__(self, log: Log | None, metadata: Callable[[str], bytes | None]) -> None:
        """`log`: None where it writes none; `metadata`: content of the other files by their paths."""
        self._log, self._metadata = log, metadata
        self._read: Callable[[int, int], bytes] | None = None
        """the open file's bytes from a place on, so many; None: closed"""
        self._size_bytes = 0
        self._burst: tuple[Connection, tuple[int, int], _Request] | None = None
        self._sent = 0
        """answers to the burst so far"""

    def receive(self, call: Call) -> None:
        """Act on a FILE_TRANSFER_PROTOCOL."""
        asked = _Request.of(bytes(call.content.payload))
        self._burst = None
        to = call.connection, call.sender, asked
        if asked.opcode not in (TERMINATE, RESET, OPEN, READ, BURST):
            _answer(*to, refusal=UNKNOWN_COMMAND)
        elif asked.opcode in (TERMINATE, RESET):
            self._read = None
            _answer(*to)
        elif asked.opcode == OPEN:
            if self._open(asked.data.rstrip(b"\0")):
                _answer(*to, data=struct.pack("<I", min(self._size_bytes, 0xFFFFFFFF)))
            else:
                _answer(*to, refusal=NOT_FOUND)
        elif self._read is None or asked.session:
            _answer(*to, refusal=INVALID_SESSION)
        elif asked.opcode == READ:
            piece = self._piece(asked, asked.offset)
            _answer(*to, data=piece, offset=asked.offset, refusal=0 if piece else END_OF_FILE)
        else:
            self._burst, self._sent = to, 0

    @property
    def at_work(self) -> bool:
        """Whether pieces wait to be sent."""
        return self._burst is not None

    def report(self) -> None:
        """Queue the pieces of this tick."""
        for _ in range(PIECES_A_TICK):
            if self._burst is None:
                return
            asked = self._burst[2]
            offset = asked.offset + self._sent * self._piece_bytes(asked)
            piece = self._piece(asked, offset)
            _answer(*self._burst, data=piece, offset=offset, refusal=0 if piece else END_OF_FILE, later=self._sent)
            self._sent += 1
            if not piece:
                self._burst = None

    def _open(self, path: bytes) -> bool:
        """Open a file; False where there is none of this path, and what was open stays."""
        log = self._log
        if log is not None and path == f"@LOG/{log.number}".encode():
            self._read, self._size_bytes = log.read, log.size_bytes
            return True
        content = self._metadata(path.decode("ascii", "replace"))
        if content is not None:
            self._read, self._size_bytes = lambda at, count: content[at : at + count], len(content)
        return content is not None

    def _piece(self, asked: _Request, offset: int) -> bytes:
        assert self._read is not None
        count = min(self._piece_bytes(asked), self._size_bytes - offset)
        try:
            return self._read(offset, count) if count > 0 else b""
        except OSError:  # it cannot be read any more: it ends here
            return b""

    def _piece_bytes(self, asked: _Request) -> int:
        return min(asked.size, PIECE_BYTES) or PIECE_BYTES


def _answer(
    connection: Connection,
    sender: tuple[int, int],
    asked: _Request,
    *,
    data: bytes = b"",
    offset: int = 0,
    refusal: int = 0,
    later: int = 0,
) -> None:
    """Queue an answer to a request, its first or a `later` one."""
    number = (asked.number + 1 + later) & 0xFFFF
    data = bytes([refusal]) if refusal else data
    head = _HEAD.pack(number, asked.session, NAK if refusal else ACK, len(data), asked.opcode, 0, offset)
    content: Any = message("FILE_TRANSFER_PROTOCOL")(
        target_system=sender[0],
        target_component=sender[1],
        payload=tuple((head + data).ljust(_PAYLOAD_BYTES, b"\0")),
    )
    connection.put(content)
