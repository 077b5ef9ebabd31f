"""A folder of logs downloaded from vehicles: each appears there when it has come whole, under a name that tells it."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import NamedTuple

from gcs.mavlink.log_client import LogClient, LogEntry

ENDINGS = ((b"\xa3\x95", ".bin"), (b"ULog", ".ulg"), (b'{"', ".truth"))
"""By their first bytes: ArduPilot's DataFlash log, PX4's ULog, the truth of a vehicle of ours."""


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
                self._keep(client, entry, there, there.read_bytes(), "already")
        return wanted

    def save(self) -> list[KeptLog]:
        """Write what has come whole since the last call; why one cannot be is its dialogue's failure."""
        before = len(self.kept)
        for client in self._clients:
            for number, content in client.files.items():
                if (client.sysid, number) not in self._saved:
                    self._saved.add((client.sysid, number))
                    self._write(client, client.entries[number], content)
        return self.kept[before:]

    def _write(self, client: LogClient, entry: LogEntry, content: bytes) -> None:
        ending = next((ending for first, ending in ENDINGS if content.startswith(first)), ".log")
        path = self._folder / f"{_stem(client, entry)}{ending}"
        part = path.with_suffix(f"{ending}.part")
        try:
            if path.exists() and not content.startswith(path.read_bytes()):
                client.failed[entry.number] = f"{path} holds another log and is left as it is; give another --out"
                return
            part.write_bytes(content)
            os.replace(part, path)
        except OSError as error:
            part.unlink(missing_ok=True)
            client.failed[entry.number] = f"{path} cannot be written: {error.strerror}"
            return
        self._keep(client, entry, path, content, "downloaded")

    def _keep(self, client: LogClient, entry: LogEntry, path: Path, content: bytes, outcome: str) -> None:
        checksum = hashlib.sha256(content).hexdigest()
        self.kept.append(KeptLog(client.sysid, entry.number, str(path), outcome, len(content), checksum))


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
