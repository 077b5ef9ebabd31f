"""Logs of one vehicle, listed and downloaded: no socket, file or clock here, time is an argument (s).

    list        LOG_REQUEST_LIST → LOG_ENTRY …
    download    by MAVFTP as a file (ftp/log_file.py), where that is faster: 239 bytes come in a frame instead of 90.
                What this does not bring: LOG_REQUEST_DATA (a range) → LOG_DATA …, then each range that is missing;
                LOG_REQUEST_END after all

One range is open at a time, since a vehicle serves one. What comes is kept wherever it belongs, so a piece that is lost
costs itself, and no more than TRIES requests in a row may bring nothing. Pieces are handed on as they come, and only
which came is remembered, so that a log costs memory neither by the length that is claimed nor by its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.ftp.log_file import LogFile
from gcs.mavlink.ftp.received_ranges import ReceivedRanges
from gcs.mavlink.ftp.requests import FileRequests

PIECE_BYTES = 90
REPEAT_S = 1.0
TRIES = 8
SETTLED_S = 1.0
"""A list during which nothing more has come for so long has come as far as it does by itself."""
NEAR_PIECES = 16
"""Missing ranges with no more pieces than this between them are asked for as one."""
LARGEST_BYTES = 1 << 29
"""A log that is said to be longer is not begun: by MAVLink it would take an hour."""


class LogEntry(NamedTuple):
    """A log that a vehicle has."""

    number: int
    size_bytes: int
    unix_s: int
    """when it began; 0 where the vehicle did not know"""


class LogPiece(NamedTuple):
    """Bytes of a log."""

    number: int
    offset: int
    data: bytes


class LogClient:
    """The dialogue with one vehicle."""

    def __init__(self, sysid: int, compid: int, log_folders: Sequence[str] | None = ()) -> None:
        """`log_folders`: where it may have its logs as files (Profile.log_folders); None: they are not looked for."""
        self.sysid, self.compid = sysid, compid
        self._to = {"target_system": sysid, "target_component": compid}
        self.entries: dict[int, LogEntry] = {}
        """its logs, by number"""
        self.pieces: list[LogPiece] = []
        """in the order in which they came, until they are taken away; a later one replaces what an earlier one holds"""
        self.whole: dict[int, LogEntry] = {}
        """logs that have come whole, by number"""
        self.failed: dict[int, str] = {}
        """why a log did not come, by number"""
        self.parts: dict[int, ReceivedRanges] = {}
        """of those that failed, what had come until then, by number"""
        self.list_problem = ""
        """what the list lacks, in words; empty where nothing"""
        self._listing = False
        self._expected: int | None = None
        self._wanted: list[LogEntry] = []
        self._open: LogEntry | None = None
        self._came = ReceivedRanges()
        """of the open log"""
        self._requests = FileRequests(sysid, compid)
        self._file: LogFile | None = None
        self._log_folders = log_folders
        self._range = (0, 0)
        self._tries = 0
        self._due_s = 0.0
        self._to_end = False

    def list_logs(self) -> None:
        """Ask for its logs."""
        self._listing, self._tries, self._due_s = True, 0, 0.0

    def download(self, entries: list[LogEntry]) -> None:
        """Ask for these logs, one after the other."""
        self._wanted += entries

    @property
    def done(self) -> bool:
        """Whether nothing is open."""
        return not (self._listing or self._wanted or self._open or self._file or self._to_end)

    @property
    def bytes_so_far(self) -> int:
        """Of the logs asked for, what has come."""
        partial = 0 if self._open is None else self._came.size_bytes
        partial += sum(came.size_bytes for came in self.parts.values())
        return partial + sum(entry.size_bytes for entry in self.whole.values())

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if name == "LOG_ENTRY" and self._listing:
            self._expected = content.num_logs
            self._due_s = now_s + SETTLED_S
            if content.num_logs and content.id not in self.entries:
                self._tries = 0
                self.entries[content.id] = LogEntry(content.id, content.size, content.time_utc)
            if len(self.entries) >= content.num_logs:
                self._listing = False
        elif self._file is not None:
            self._file.receive(name, content, now_s)
            if self._open is not None:
                self.pieces += [LogPiece(self._open.number, *piece) for piece in self._file.taken()]
        elif name == "LOG_DATA" and self._open is not None and content.id == self._open.number:
            if self._put(self._open, content.ofs, bytes(content.data[: content.count])):
                self._tries = 0
            self._due_s = max(self._due_s, now_s + REPEAT_S)
            if self._came.size_bytes >= self._open.size_bytes:
                self._end(self._open)
            elif content.ofs + PIECE_BYTES >= self._range[1] or content.count < PIECE_BYTES:
                self._due_s = now_s if self._tries == 0 else self._due_s  # the range has ended: the next gap at once

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        if self._listing:
            return self._poll_list(now_s)
        if self._open is None and self._wanted:
            self._begin(self._wanted.pop(0), now_s)
        if self._file is not None and self._open is not None:
            return self._poll_file(self._file, self._open, now_s)
        if self._open is not None and now_s >= self._due_s:
            if self._tries < TRIES:
                return [self._ask(self._open, now_s)]
            self._fail(self._open, f", then nothing, though it was asked {TRIES} times")
        if self._to_end and not self._wanted and self._open is None:
            self._to_end = False
            return [self._end_of_download()]
        return []

    def stop(self, why: str) -> list[Message]:
        """Give up what has not come; messages that end it on the vehicle. `why` goes on after "… bytes came"."""
        if self.done:
            return []
        file = [] if self._file is None else self._file.end()
        if self._open is not None:
            self._fail(self._open, why)
        self._listing, self._wanted, self._file, self._to_end = False, [], None, False
        return [*file, self._end_of_download()]

    def _end_of_download(self) -> Message:
        """The vehicle, whose list was asked for, goes on writing its log."""
        return codec.message("LOG_REQUEST_END", **self._to)

    def _begin(self, entry: LogEntry, now_s: float) -> None:
        self._to_end = True
        if entry.size_bytes > LARGEST_BYTES:
            self.failed[entry.number] = f"it is said to have {entry.size_bytes} bytes, more than comes over such a link"
        elif entry.size_bytes == 0:
            self.whole[entry.number] = entry
        else:
            self._open, self._came, self._tries, self._due_s = entry, ReceivedRanges(), 0, now_s
            if self._log_folders is not None:
                self._file = LogFile(self._requests, entry.number, entry.size_bytes, self._log_folders)

    def _poll_file(self, file: LogFile, entry: LogEntry, now_s: float) -> list[Message]:
        """Read it as a file; what that does not bring is left to ranges."""
        messages = file.poll(now_s)
        self._came = file.came
        if file.done:
            self._file = None
            if file.is_whole:
                self._end(entry)
            else:
                self._log_folders = None
        return messages

    def _put(self, entry: LogEntry, offset: int, data: bytes) -> bool:
        """Hand a piece on; whether any of it was missing. One that is cut short before the log's end is no piece."""
        end = min(offset + PIECE_BYTES, entry.size_bytes)
        new = self._came.add(offset, end) - offset if 0 < end - offset <= len(data) else 0
        if new:
            self.pieces.append(LogPiece(entry.number, offset, data[:new]))
        return new > 0

    def _end(self, entry: LogEntry) -> None:
        self.whole[entry.number] = entry
        self._close()

    def _fail(self, entry: LogEntry, why: str) -> None:
        first, stop = self._came.missing(entry.size_bytes)
        gap = f"; bytes {first} to {stop - 1} are the first that are missing" if self._came.size_bytes else ""
        self.parts[entry.number] = self._came
        self.failed.setdefault(entry.number, f"{self._came.size_bytes} of {entry.size_bytes} bytes came{why}{gap}")
        self._close()

    def _close(self) -> None:
        self._open, self._tries, self._due_s = None, 0, 0.0

    def _poll_list(self, now_s: float) -> list[Message]:
        if now_s < self._due_s:
            return []
        if self._tries >= TRIES:
            self._listing = False
            came = "no list" if self._expected is None else f"{len(self.entries)} of {self._expected} entries"
            why = "ArduPilot is silent while it is armed" if self._expected is None else "the link loses much"
            self.list_problem = f"{came} of its logs came, though it was asked {TRIES} times: {why}"
            return []
        self._tries += 1
        self._due_s = now_s + REPEAT_S
        return [codec.message("LOG_REQUEST_LIST", **self._to, start=0, end=0xFFFF)]

    def _ask(self, entry: LogEntry, now_s: float) -> Message:
        self._tries += 1
        self._due_s = now_s + REPEAT_S
        first, stop = self._came.missing(entry.size_bytes, NEAR_PIECES * PIECE_BYTES)
        stop = min(stop + (first - stop) % PIECE_BYTES, entry.size_bytes)  # only the log's last piece is shorter
        self._range = first, stop
        return codec.message("LOG_REQUEST_DATA", **self._to, id=entry.number, ofs=first, count=stop - first)
