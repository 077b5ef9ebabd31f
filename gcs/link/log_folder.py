"""A folder of logs downloaded from vehicles: each appears there when it has come whole, under a name that tells it."""

from __future__ import annotations

import contextlib
import hashlib
import os
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

from gcs.mavlink.log_client import LogClient, LogEntry, LogPiece

ENDINGS = ((b"\xa3\x95", ".bin"), (b"ULog", ".ulg"), (b'{"', ".truth"))
"""By their first bytes: ArduPilot's DataFlash log, PX4's ULog, the truth of a vehicle of ours."""

COMPARED_BYTES = 1 << 20


class KeptLog(NamedTuple):
    """A log in the folder."""

    sysid: int
    number: int
    file: str
    outcome: str
    """`downloaded`, or `already` there"""
    size_bytes: int
    sha256: str

    @property
    def text(self) -> str:
        """For a person."""
        words = "is there already" if self.outcome == "already" else f"{self.size_bytes} bytes"
        return f"{self.sysid:>3}  log {self.number}: {self.file}, {words}, sha256 {self.sha256}"


class LogFolder:
    """The folder, which must exist, and the dialogues whose logs go there."""

    def __init__(self, folder: Path, clients: Sequence[LogClient]) -> None:
        self.kept: list[KeptLog] = []
        self.wanted_bytes = 0
        self._folder, self._clients = folder, clients
        self._saved: set[tuple[int, int]] = set()

    @property
    def bytes_so_far(self) -> int:
        """Of those wanted, what has come."""
        return sum(client.bytes_so_far for client in self._clients)

    def missing(self, client: LogClient, entries: Sequence[LogEntry]) -> list[LogEntry]:
        """Those that are not there yet; the others are kept."""
        wanted = []
        for entry in entries:
            there = next(self._folder.glob(f"{_stem(client, entry)}.*"), None)
            if there is None or there.stat().st_size != entry.size_bytes:
                wanted.append(entry)
                self.wanted_bytes += entry.size_bytes
            else:
                self._keep(client, entry, there, "already")
        return wanted

    def save(self) -> list[KeptLog]:
        """Write what has come since the last call, and name what is whole; why one cannot be is its dialogue's
        failure."""
        before = len(self.kept)
        for client in self._clients:
            pieces, client.pieces = client.pieces, []
            for number, of_log in groupby(pieces, lambda piece: piece.number):
                if number not in client.failed:
                    self._write(client, number, of_log)
            for number in client.whole:
                if (client.sysid, number) not in self._saved:
                    self._saved.add((client.sysid, number))
                    if number not in client.failed:
                        self._name(client, client.entries[number])
        return self.kept[before:]

    def close(self) -> None:
        """Remove what has not come whole."""
        for client in self._clients:
            for number in client.entries:
                self._part(client, number).unlink(missing_ok=True)

    def _part(self, client: LogClient, number: int) -> Path:
        return self._folder / f".{_stem(client, client.entries[number])}.part"

    def _fail(self, client: LogClient, number: int, why: str) -> None:
        with contextlib.suppress(OSError):
            self._part(client, number).unlink(missing_ok=True)
        client.failed[number] = why

    def _write(self, client: LogClient, number: int, pieces: Iterable[LogPiece]) -> None:
        part = self._part(client, number)
        try:
            with os.fdopen(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_NOFOLLOW, 0o666), "wb", buffering=0) as file:
                for piece in pieces:
                    os.pwrite(file.fileno(), piece.data, piece.offset)
        except OSError as error:
            self._fail(client, number, f"{part} cannot be written: {error.strerror}")

    def _name(self, client: LogClient, entry: LogEntry) -> None:
        """Give a whole log its name."""
        part = self._part(client, entry.number)
        try:
            with part.open("ab") as file:
                file.truncate(entry.size_bytes)
            with part.open("rb") as file:
                begin = file.read(max(len(first) for first, _ in ENDINGS))
            ending = next((ending for first, ending in ENDINGS if begin.startswith(first)), ".log")
            path = self._folder / f"{_stem(client, entry)}{ending}"
            if path.exists() and not _begins_with(part, path):
                why = f"{path} holds another log and is left as it is; give another --out"
                self._fail(client, entry.number, why)
                return
            os.replace(part, path)
            self._keep(client, entry, path, "downloaded")
        except OSError as error:
            self._fail(client, entry.number, f"{part} cannot be written: {error.strerror}")

    def _keep(self, client: LogClient, entry: LogEntry, path: Path, outcome: str) -> None:
        with path.open("rb") as file:
            checksum = hashlib.file_digest(file, "sha256").hexdigest()
        self.kept.append(KeptLog(client.sysid, entry.number, str(path), outcome, path.stat().st_size, checksum))


def _begins_with(path: Path, shorter: Path) -> bool:
    """Whether a file begins with all that another one holds."""
    with path.open("rb") as one, shorter.open("rb") as other:
        while expected := other.read(COMPARED_BYTES):
            if one.read(len(expected)) != expected:
                return False
    return True


def newest(client: LogClient) -> list[LogEntry]:
    """Its newest log, if it has any: the one that began last, else the one with the highest number."""
    return sorted(client.entries.values(), key=lambda log: (log.unix_s, log.number))[-1:]


def problems(clients: Sequence[LogClient]) -> list[str]:
    """Sentences about what did not come."""
    return [
        f"vehicle {client.sysid}: {problem}"
        for client in clients
        for problem in (
            *([client.list_problem] if client.list_problem else ()),
            *(f"log {number}: {why}" for number, why in client.failed.items()),
        )
    ]


def _stem(client: LogClient, entry: LogEntry) -> str:
    begun = f"-{datetime.fromtimestamp(entry.unix_s, UTC):%Y%m%dT%H%M%SZ}" if entry.unix_s else ""
    return f"vehicle-{client.sysid}-log-{entry.number}{begun}"
