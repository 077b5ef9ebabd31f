"""A folder of logs downloaded from vehicles: each appears there when it has come whole, under a name that tells it.

Of one that did not, what came stays as NAME-partial.ENDING: bytes where they belong, and zeros for those that are
missing. The whole log takes its place.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from gcs.mavlink.ftp.received_ranges import ReceivedRanges
from gcs.mavlink.log_client import LogClient, LogEntry, LogPiece

ENDINGS = ((b"\xa3\x95", ".bin"), (b"ULog", ".ulg"), (b'{"', ".truth"))
"""By their first bytes: ArduPilot's DataFlash log, PX4's ULog, the truth of a vehicle of ours."""

CHUNK_BYTES = 1 << 20


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


class KeptPart(NamedTuple):
    """A part of a log that did not come whole, in the folder."""

    sysid: int
    number: int
    file: str
    came_bytes: int
    claimed_bytes: int
    first_gap: tuple[int, int]
    """the first byte that is missing, and the first one behind these"""


class LogFolder:
    """The folder, which must exist, and the dialogues whose logs go there."""

    def __init__(self, folder: Path, clients: Sequence[LogClient]) -> None:
        self.kept: list[KeptLog] = []
        self.parts: list[KeptPart] = []
        """of logs that failed, once the folder is closed"""
        self.wanted_bytes = 0
        self._folder, self._clients = folder, clients
        self._settled: set[tuple[int, int]] = set()
        """system id and number of those that have a name, or cannot be written"""

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
            for number, of_log in groupby(client.pieces, lambda piece: piece.number):
                if (client.sysid, number) not in self._settled:
                    self._write(client, number, of_log)
            client.pieces = []  # once they are written: a Ctrl-C until then loses none
            for number in client.whole:
                if (client.sysid, number) not in self._settled:
                    self._settled.add((client.sysid, number))
                    self._name(client, client.entries[number])
        return self.kept[before:]

    def rows(self) -> dict[str, list[dict[str, Any]]]:
        """Rows of what is in the folder: `files` that are whole and `parts`, once it is closed."""
        return {"files": [log._asdict() for log in self.kept], "parts": [part._asdict() for part in self.parts]}

    def close(self) -> None:
        """Keep what came of logs that failed, and say where in their dialogue's failure; what is still open is
        removed."""
        self.save()
        for client in self._clients:
            for number, entry in client.entries.items():
                came = client.parts.get(number)
                if came is not None and came.size_bytes and (client.sysid, number) not in self._settled:
                    self._settled.add((client.sysid, number))
                    client.failed[number] += f"; {self._keep_part(client, entry, came)}"
                with contextlib.suppress(OSError):
                    self._part(client, number).unlink(missing_ok=True)

    def _part(self, client: LogClient, number: int) -> Path:
        return self._folder / f".{_stem(client, client.entries[number])}.part"

    def _fail(self, client: LogClient, number: int, why: str) -> None:
        with contextlib.suppress(OSError):
            self._part(client, number).unlink(missing_ok=True)
        client.failed[number] = why
        self._settled.add((client.sysid, number))

    def _write(self, client: LogClient, number: int, pieces: Iterable[LogPiece]) -> None:
        part = self._part(client, number)
        try:
            with _opened(part) as file:
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
            path = self._folder / f"{_stem(client, entry)}{_ending(part)}"
            if path.exists() and not _begins_with(part, path):
                why = f"{path} holds another log and is left as it is; give another --out"
                self._fail(client, entry.number, why)
                return
            os.replace(part, path)
            self._keep(client, entry, path, "downloaded")
            for earlier in self._parts_there(client, entry):
                if _agree(path, earlier):
                    earlier.unlink()
        except OSError as error:
            self._fail(client, entry.number, f"{part} cannot be written: {error.strerror}")

    def _keep_part(self, client: LogClient, entry: LogEntry, came: ReceivedRanges) -> str:
        """Give what came of a log its name, if nothing there is better; a clause about where it is."""
        written = self._part(client, entry.number)
        copy = written.with_suffix(".copy")
        try:
            _copy_ranges(written, copy, came)
            there = self._parts_there(client, entry)
            for earlier in there:
                if not _agree(copy, earlier):
                    return f"{earlier} holds a part of another log and is left as it is; give another --out"
                if earlier.stat().st_size > copy.stat().st_size:
                    return f"a longer part, which came earlier, is in {earlier}"
            for earlier in there:
                earlier.unlink()
            path = self._folder / f"{_stem(client, entry)}-partial{_ending(copy)}"
            os.replace(copy, path)
        except OSError as error:
            return f"what came cannot be kept in {self._folder}: {error.strerror}"
        finally:
            with contextlib.suppress(OSError):
                copy.unlink(missing_ok=True)
        sizes = came.size_bytes, entry.size_bytes
        self.parts.append(KeptPart(client.sysid, entry.number, str(path), *sizes, came.missing(entry.size_bytes)))
        return f"what came is in {path}"

    def _parts_there(self, client: LogClient, entry: LogEntry) -> list[Path]:
        return list(self._folder.glob(f"{_stem(client, entry)}-partial.*"))

    def _keep(self, client: LogClient, entry: LogEntry, path: Path, outcome: str) -> None:
        with path.open("rb") as file:
            checksum = hashlib.file_digest(file, "sha256").hexdigest()
        self.kept.append(KeptLog(client.sysid, entry.number, str(path), outcome, path.stat().st_size, checksum))


def _opened(path: Path) -> io.FileIO:
    """A file to write in, made where missing; what it has stays."""
    return io.FileIO(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_NOFOLLOW, 0o666), "w")


def _ending(path: Path) -> str:
    with path.open("rb") as file:
        begin = file.read(max(len(first) for first, _ in ENDINGS))
    return next((ending for first, ending in ENDINGS if begin.startswith(first)), ".log")


def _copy_ranges(path: Path, to: Path, ranges: ReceivedRanges) -> None:
    """Copy these bytes of a file to where they are in it; zeros are between them."""
    with path.open("rb") as source, _opened(to) as file:
        file.truncate(0)
        for start, stop in ranges:
            for offset in range(start, stop, CHUNK_BYTES):
                os.pwrite(file.fileno(), os.pread(source.fileno(), min(CHUNK_BYTES, stop - offset), offset), offset)


def _agree(path: Path, other: Path) -> bool:
    """Whether two files may hold parts of one log: as far as both go, where they differ one of them has zeros."""
    with path.open("rb") as one, other.open("rb") as two:
        while (a := one.read(CHUNK_BYTES)) and (b := two.read(CHUNK_BYTES)):
            size = min(len(a), len(b))
            first, second = np.frombuffer(a, np.uint8, size), np.frombuffer(b, np.uint8, size)
            if np.any((first != second) & (first != 0) & (second != 0)):
                return False
    return True


def _begins_with(path: Path, shorter: Path) -> bool:
    """Whether a file begins with all that another one holds."""
    with path.open("rb") as one, shorter.open("rb") as other:
        while expected := other.read(CHUNK_BYTES):
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
