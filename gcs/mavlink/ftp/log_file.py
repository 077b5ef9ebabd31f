"""Logs of one vehicle as files, read by MAVFTP: no socket, file or clock here, time is an argument (s).

named     `@LOG/NUMBER`, which simulated vehicles of ours have
found     in the autopilot's own folder of logs or, newest first, in one of the folders there: the only file as
          long as the log is said to be. LOG_ENTRY has no name
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gcs.mavlink.codec import Message
from gcs.mavlink.ftp.file_client import FileClient
from gcs.mavlink.ftp.folder_client import FolderClient
from gcs.mavlink.ftp.received_ranges import ReceivedRanges
from gcs.mavlink.ftp.requests import FileRequests

MOST_FOLDERS = 8
"""Of days or flights, looked through for one log."""


class LogFile:
    """The dialogue with one vehicle about one log; `is_whole` is False once it is done where it did not come."""

    def __init__(self, requests: FileRequests, number: int, size_bytes: int, roots: Sequence[str]) -> None:
        """`roots`: where its autopilot may keep its logs, the likeliest first."""
        self._requests, self._size_bytes = requests, size_bytes
        self._roots = list(roots)
        self._folders: list[str] = []
        self._below_root = False
        self.came = ReceivedRanges()
        """of the log, as far as the file that is read, or was read last, is known to be it"""
        self._open: FileClient | FolderClient | None = self._read(f"@LOG/{number}")
        self.is_whole = False

    @property
    def done(self) -> bool:
        """Whether nothing is open."""
        return self._open is None

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if self._open is not None:
            self._open.receive(name, content, now_s)

    def taken(self) -> list[tuple[int, bytes]]:
        """(offset, bytes) that came since the last call."""
        if not isinstance(self._open, FileClient):
            return []
        pieces, self._open.pieces = self._open.pieces, []
        return pieces

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        messages = [] if self._open is None else self._open.poll(now_s)
        if self._open is not None and self._open.done:
            if isinstance(self._open, FileClient):
                self.is_whole = self._open.is_whole
                if self._open.is_short:
                    self.came = ReceivedRanges()
                searched = not self.is_whole and self._requests.has_answered
                self._open = self._looked_in(self._roots) if searched else None
            else:
                self._open = self._after(self._open)
        return messages

    def end(self) -> list[Message]:
        """Messages that end what is open."""
        return [self._open.end()] if isinstance(self._open, FileClient) else []

    def _read(self, path: str) -> FileClient:
        file = FileClient(self._requests, path, self._size_bytes)
        self.came = file.came
        return file

    def _looked_in(self, folders: list[str]) -> FolderClient | None:
        return FolderClient(self._requests, folders.pop(0)) if folders else None

    def _after(self, listed: FolderClient) -> FileClient | FolderClient | None:
        """Open what follows a folder that has been listed; None where there is nowhere else to look."""
        fitting = [name for name, size in listed.files.items() if size == self._size_bytes]
        if len(fitting) == 1:
            self._roots, self._folders = [], []  # whatever comes of it
            return self._read(f"{listed.path}/{fitting[0]}")
        if not self._below_root:
            if listed.problem:
                return self._looked_in(self._roots)
            self._below_root = True
            newest = sorted(listed.folders, reverse=True)[:MOST_FOLDERS]
            self._folders = [f"{listed.path}/{name}" for name in newest]
        return self._looked_in(self._folders)
