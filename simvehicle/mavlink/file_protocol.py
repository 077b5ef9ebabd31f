"""MAVFTP without a socket, a file or a clock, read-only: a vehicle's files are its metadata and its log, `@LOG/NUMBER`.

Rules:
1. Each station has one session, 0, of the last MOST_OPEN that opened one. OpenFileRO opens it and says how long the
   file is; a log is read as far as it has been written then. ResetSessions and TerminateSession close it; with a
   session that is not open TerminateSession, ReadFile and BurstReadFile are NAK, invalid session, and change nothing.
2. ReadFile gives one piece. BurstReadFile gives all from a place on, PIECES_A_TICK in each tick, then NAK, end of file.
3. The last request of a station, come again as it was because its answer was lost, gets that answer again, and changes
   nothing; a burst begins anew.
4. None is ACK. Another file is NAK, file not found; requests to write or to look elsewhere are NAK, unknown command.
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
NONE, TERMINATE, RESET, OPEN, READ, BURST, ACK, NAK = 0, 1, 2, 4, 5, 15, 128, 129
INVALID_SESSION, END_OF_FILE, UNKNOWN_COMMAND, NOT_FOUND = 4, 6, 7, 10
MOST_OPEN = 8
"""[choice] Stations that have a file open at once; a further one takes the place of the one that opened first."""
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


class _OpenFile(NamedTuple):
    read: Callable[[int, int], bytes]
    """bytes from a place on, so many"""
    size_bytes: int

    def piece(self, asked: _Request, offset: int) -> bytes:
        count = min(_piece_bytes(asked), self.size_bytes - offset)
        try:
            return self.read(offset, count) if count > 0 else b""
        except OSError:  # it cannot be read any more: it ends here
            return b""


class _Burst:
    def __init__(self, connection: Connection, asked: _Request, file: _OpenFile) -> None:
        self.connection, self.asked, self.file = connection, asked, file
        self.sent = 0
        """answers so far"""


class FileService:
    """The files of one vehicle, on all its connections."""

    def __init__(self, log: Log | None, metadata: Callable[[str], bytes | None]) -> None:
        """`log`: None where it writes none; `metadata`: content of the other files by their paths."""
        self._log, self._metadata = log, metadata
        self._files: dict[tuple[int, int], _OpenFile] = {}
        """by station"""
        self._bursts: dict[tuple[int, int], _Burst] = {}
        self._answered: dict[tuple[int, int], tuple[_Request, Any]] = {}
        """by station, its last request with the answer"""

    def receive(self, call: Call) -> None:
        """Act on a FILE_TRANSFER_PROTOCOL."""
        asked, sender = _Request.of(bytes(call.content.payload)), call.sender
        before, content = self._answered.pop(sender, (None, None))
        if asked != before:
            content = self._act(asked, sender, call.connection)
        if content is not None:
            if len(self._answered) >= MOST_OPEN:
                del self._answered[next(iter(self._answered))]
            self._answered[sender] = asked, content
            call.connection.put(content)

    def _act(self, asked: _Request, sender: tuple[int, int], connection: Connection) -> Any | None:
        """Do what a new request asks; its answer, or None where a burst answers it."""
        to, file = (sender, asked), self._files.get(sender)
        if asked.opcode in (TERMINATE, READ, BURST) and (file is None or asked.session):
            return _answer(*to, refusal=INVALID_SESSION)
        self._bursts.pop(sender, None)
        if asked.opcode == BURST and file is not None:
            self._bursts[sender] = _Burst(connection, asked, file)
            return None
        if asked.opcode == OPEN:
            return self._open(asked.data.rstrip(b"\0"), *to)
        if asked.opcode == READ and file is not None:
            piece = file.piece(asked, asked.offset)
            return _answer(*to, data=piece, offset=asked.offset, refusal=0 if piece else END_OF_FILE)
        if asked.opcode in (TERMINATE, RESET):
            self._files.pop(sender, None)
        return _answer(*to, refusal=0 if asked.opcode in (NONE, TERMINATE, RESET) else UNKNOWN_COMMAND)

    @property
    def at_work(self) -> bool:
        """Whether pieces wait to be sent."""
        return bool(self._bursts)

    def report(self) -> None:
        """Queue the pieces of this tick."""
        for sender, burst in list(self._bursts.items()):
            for _ in range(PIECES_A_TICK):
                asked = burst.asked
                offset = asked.offset + burst.sent * _piece_bytes(asked)
                piece, ends = burst.file.piece(asked, offset), END_OF_FILE
                content = _answer(
                    sender, asked, data=piece, offset=offset, refusal=0 if piece else ends, later=burst.sent
                )
                burst.connection.put(content)
                burst.sent += 1
                if not piece:
                    del self._bursts[sender]
                    break

    def _open(self, path: bytes, sender: tuple[int, int], asked: _Request) -> Any:
        """Open a file for a station; where there is none of this path, what it had open stays."""
        file = self._found(path)
        if file is None:
            return _answer(sender, asked, refusal=NOT_FOUND)
        self._files.pop(sender, None)
        if len(self._files) >= MOST_OPEN:
            del self._files[next(iter(self._files))]
        self._files[sender] = file
        return _answer(sender, asked, data=struct.pack("<I", min(file.size_bytes, 0xFFFFFFFF)))

    def _found(self, path: bytes) -> _OpenFile | None:
        log = self._log
        if log is not None and path == f"@LOG/{log.number}".encode():
            return _OpenFile(log.read, log.size_bytes)
        content = self._metadata(path.decode("ascii", "replace"))
        return None if content is None else _OpenFile(lambda at, count: content[at : at + count], len(content))


def _piece_bytes(asked: _Request) -> int:
    return min(asked.size, PIECE_BYTES) or PIECE_BYTES


def _answer(
    sender: tuple[int, int],
    asked: _Request,
    *,
    data: bytes = b"",
    offset: int = 0,
    refusal: int = 0,
    later: int = 0,
) -> Any:
    """An answer to a request, its first or a `later` one."""
    number = (asked.number + 1 + later) & 0xFFFF
    data = bytes([refusal]) if refusal else data
    head = _HEAD.pack(number, asked.session, NAK if refusal else ACK, len(data), asked.opcode, 0, offset)
    return message("FILE_TRANSFER_PROTOCOL")(
        target_system=sender[0],
        target_component=sender[1],
        payload=tuple((head + data).ljust(_PAYLOAD_BYTES, b"\0")),
    )
