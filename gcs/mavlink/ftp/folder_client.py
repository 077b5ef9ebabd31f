"""One folder of a vehicle, listed by MAVFTP: no socket and no clock here, time is an argument (s).

    list     ListDirectory from the first entry → entries, again and again from behind the last, until NAK, end of file

An entry is `F` with a file's name, a tabulator and its size, `D` with a folder's name, or `S` for one that is kept back
and counts all the same.
[lineage] MAVLink File Transfer Protocol, https://mavlink.io/en/services/ftp.html
"""

from __future__ import annotations

from typing import Any

from gcs.mavlink.codec import Message
from gcs.mavlink.ftp.requests import END_OF_FILE, LIST, REPEAT_S, TRIES, FileRequests

MOST_ENTRIES = 10_000
"""Beyond them a folder is listed no further."""


class FolderClient:
    """The dialogue with one vehicle about one folder."""

    def __init__(self, requests: FileRequests, path: str) -> None:
        self.path = path
        self.files: dict[str, int] = {}
        """sizes in bytes, by name"""
        self.folders: list[str] = []
        self.problem = ""
        """why it could not be listed, in words"""
        self.done = False
        self._requests = requests
        self._entries = self._tries = 0
        self._due_s = 0.0

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        answer = self._requests.answer(name, content, LIST)
        if answer is None or self.done or not self._requests.answered_first:
            return
        self._tries, self._due_s = 0, now_s
        if answer.refused:
            self.done = True
            self.problem = "" if answer.reason == END_OF_FILE else f"{self.path}: {answer.why}"
            return
        entries = [entry.decode("ascii", "replace") for entry in answer.data.split(b"\0") if entry]
        for entry in entries:
            self._take(entry)
        self._entries += len(entries)
        self.done = not entries or self._entries > MOST_ENTRIES

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        if self.done or now_s < self._due_s:
            return []
        if self._tries >= TRIES:
            self.done, self.problem = True, f"no answer to a request for {self.path}, though it was asked {TRIES} times"
            return []
        self._tries += 1
        self._due_s = now_s + REPEAT_S
        return [self._requests.request(LIST, offset=self._entries, data=self.path.encode("ascii"))]

    def _take(self, entry: str) -> None:
        kind, name = entry[0], entry[1:]
        if kind == "D":
            self.folders.append(name)
        elif kind == "F":
            name, _, size = name.partition("\t")
            if size.isdecimal():
                self.files[name] = int(size)
