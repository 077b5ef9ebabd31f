"""The log protocol without a socket, a file or a clock, for a vehicle that has one log, or none.

Rules:
1. A list is answered by one LOG_ENTRY, also where there is no log: num_logs is 0 then.
2. Data go out in pieces of 90 bytes, PIECES_A_TICK in each tick, so that telemetry keeps its rhythm. A piece that is
   shorter ends the log: one of 0 bytes where a request begins at its end or beyond.
3. A request takes the place of the one before; LOG_REQUEST_END and LOG_ERASE end it.
4. The log grows while the vehicle runs: what is asked for is served as far as it has been written.
"""

from __future__ import annotations

from typing import Protocol

from simvehicle.mavlink.codec import message
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import Call
from simvehicle.mavlink.lockstep import FRAMES_A_TICK
from skytender import mavlink as mav

PIECE_BYTES = 90
PIECES_A_TICK = FRAMES_A_TICK // 4
"""About 140 kB/s where a vehicle lives at 50 ticks a second."""
MESSAGES = frozenset(
    {
        mav.MAVLINK_MSG_ID_LOG_REQUEST_LIST,
        mav.MAVLINK_MSG_ID_LOG_REQUEST_DATA,
        mav.MAVLINK_MSG_ID_LOG_REQUEST_END,
        mav.MAVLINK_MSG_ID_LOG_ERASE,
    }
)


class Log(Protocol):
    """Record of a flight that its vehicle has written."""

    number: int
    """its id on the wire, from 1"""

    @property
    def unix_s(self) -> int:
        """When it began."""

    @property
    def size_bytes(self) -> int:
        """Bytes so far."""

    def read(self, offset: int, count: int) -> bytes:
        """Bytes from a place on, as many as there are of `count`. Raises OSError."""

    def erase(self) -> None:
        """Begin a new log, without anything of before."""


class LogService:
    """The logs of one vehicle, on all its connections; `log` is None where it writes none."""

    def __init__(self, log: Log | None) -> None:
        self._log = log
        self._connection: Connection | None = None
        self._offset = self._stop = 0

    def receive(self, call: Call) -> None:
        """Act on one of MESSAGES."""
        if call.frame.msgid == mav.MAVLINK_MSG_ID_LOG_REQUEST_LIST:
            self._list(call)
        elif self._log is None:
            return
        elif call.frame.msgid == mav.MAVLINK_MSG_ID_LOG_REQUEST_DATA:
            asked = call.content
            if asked.id == self._log.number:
                self._connection = call.connection
                self._offset, self._stop = asked.ofs, asked.ofs + asked.count
        else:
            self._connection = None
            if call.frame.msgid == mav.MAVLINK_MSG_ID_LOG_ERASE:
                self._log.erase()

    @property
    def at_work(self) -> bool:
        """Whether pieces wait to be sent."""
        return self._connection is not None

    def report(self) -> None:
        """Queue the pieces of this tick."""
        if self._log is None or self._connection is None:
            return
        for _ in range(PIECES_A_TICK):
            count = min(PIECE_BYTES, self._stop - self._offset)
            try:
                piece = self._log.read(self._offset, count)
            except OSError:  # it cannot be read any more: what was asked for ends here
                piece = b""
            content = message("LOG_DATA")(
                id=self._log.number,
                ofs=self._offset,
                count=len(piece),
                data=tuple(piece.ljust(PIECE_BYTES, b"\0")),
            )
            self._connection.put(content)
            self._offset += len(piece)
            if len(piece) < PIECE_BYTES or self._offset >= self._stop:
                self._connection = None
                return

    def _list(self, call: Call) -> None:
        log, asked = self._log, call.content
        there = log is not None and asked.start <= log.number <= asked.end
        content = message("LOG_ENTRY")(num_logs=int(there), last_log_num=0 if log is None else log.number)
        if log is not None and there:
            content = content._replace(id=log.number, time_utc=log.unix_s, size=log.size_bytes)
        call.connection.put(content)
