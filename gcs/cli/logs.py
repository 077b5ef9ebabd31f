"""`gcs logs`: the logs that vehicles wrote themselves, listed and downloaded over a whole fleet."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import hashlib
import json
import os
import sys
import time
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.fleet_options import Refused, fleet_at, of_the_fleet
from gcs.exit import NOT_DONE

if TYPE_CHECKING:
    from gcs.link.asked_fleet import AskedFleet
    from gcs.mavlink.log_client import LogClient, LogEntry

SILENT_FOR_S = 2.0
"""Progress of what takes no longer is not shown."""
DRAW_EVERY_S, LINE_EVERY_S = 0.25, 5.0
ENDINGS = ((b"\xa3\x95", ".bin"), (b"ULog", ".ulg"), (b'{"', ".truth"))
"""By their first bytes: ArduPilot's DataFlash log, PX4's ULog, the truth of a vehicle of ours."""


@click.group(short_help="List and download the logs of a fleet.")
def logs() -> None:
    """Logs that vehicles wrote themselves, of every vehicle at an address at once, whatever its autopilot.

    ArduPilot sends its logs only while it is disarmed. A vehicle of ours has one: its truth, so far.

    \b
    Examples:
      gcs logs list --connect udpin:127.0.0.1:14550
      gcs logs get --out flown
      gcs logs get 12 13 --sysid 3 --out flown

    \b
    Exit status:
      0    done
      1    a log, or a list of logs, did not come
      2    bad input, or no vehicle was heard
      130  stopped by Ctrl-C; logs that had come whole are kept
    """


@logs.command("list", short_help="Show which logs there are.")
@of_the_fleet
def list_(as_json: bool, **options: Any) -> int:
    """Show the logs of every vehicle: number, size, and when each began."""
    with fleet_at(**options) as fleet:
        clients = _list(fleet)
    if as_json:
        told = {
            client.sysid: [
                {"number": log.number, "size_bytes": log.size_bytes, "begun": _begun(log)} for log in _sorted(client)
            ]
            for client in clients
        }
        click.echo(json.dumps({"vehicles": told}))
    else:
        click.echo("vehicle    log        bytes  begun (UTC)")
        for client in clients:
            for log in _sorted(client):
                click.echo(f"{client.sysid:>7} {log.number:>6} {log.size_bytes:>12}  {_begun(log) or '-'}")
            if not client.entries and not client.list_problem:
                click.echo(f"{client.sysid:>7}      - no log")
    return _complain(clients)


@logs.command(short_help="Download logs into a folder.")
@click.argument("numbers", nargs=-1, type=click.IntRange(0, 65535), metavar="[NUMBER...]")
@click.option("--all", "everything", is_flag=True, help="All logs of each vehicle.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("logs"),
    show_default=True,
    help="Folder of the files; made where missing.",
)
@of_the_fleet
def get(numbers: tuple[int, ...], everything: bool, out: Path, as_json: bool, **options: Any) -> int:
    """Download logs: those with these NUMBERs, or each vehicle's newest.

    What a link loses is asked for again. A file appears when its log has come whole, with the size that the vehicle
    gave; its SHA-256 is shown. A log that is there already, in that size, is not downloaded again.
    """
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Refused(f"--out {out}: {error.strerror}") from None
    with fleet_at(**options) as fleet:
        clients = _list(fleet)
        kept = _Kept(out, clients, say=not as_json)
        for client in clients:
            client.download(kept.missing(client, _wanted(client, numbers, everything=everything)))
        try:
            fleet.converse(clients, kept.look)
        except KeyboardInterrupt:
            for client in clients:
                if not client.done:
                    fleet.send_to(client.sysid, client.end())
            raise
        finally:
            kept.close()
    if as_json:
        click.echo(json.dumps({"files": kept.rows}))
    elif not kept.rows and not any(client.failed or client.list_problem for client in clients):
        click.echo("there is no log")
    return _complain(clients)


class _Kept:
    """The folder: logs go there as they come whole, and progress is told."""

    def __init__(self, folder: Path, clients: Sequence[LogClient], *, say: bool) -> None:
        self.rows: list[dict[str, Any]] = []
        self._folder, self._clients, self._say = folder, clients, say
        self._bytes = 0
        self._saved: set[tuple[int, int]] = set()
        self._begun_s = time.monotonic()
        self._shown_s = self._begun_s + SILENT_FOR_S - DRAW_EVERY_S
        self._drawn = False

    def missing(self, client: LogClient, entries: Sequence[LogEntry]) -> list[LogEntry]:
        """Those that are not in the folder yet; the others are told."""
        wanted = []
        for entry in entries:
            there = next(self._folder.glob(f"{_stem(client, entry)}.*"), None)
            if there is None or there.stat().st_size != entry.size_bytes:
                wanted.append(entry)
                self._bytes += entry.size_bytes
            else:
                self._report(client, entry, there, there.read_bytes(), "already")
        return wanted

    def look(self) -> None:
        """Keep what has come whole since the last call, and show how far the others are."""
        for client in self._clients:
            for number, content in client.files.items():
                if (client.sysid, number) not in self._saved:
                    self._saved.add((client.sysid, number))
                    self._save(client, client.entries[number], content)
        now_s = time.monotonic()
        terminal = sys.stderr.isatty()
        if now_s - self._shown_s < (DRAW_EVERY_S if terminal or not self._drawn else LINE_EVERY_S):
            return
        self._shown_s, self._drawn = now_s, True
        came = sum(client.bytes_so_far for client in self._clients)
        rate = came / (now_s - self._begun_s)
        text = f"{came / 1e6:.2f} of {self._bytes / 1e6:.2f} MB, {rate / 1e3:.0f} kB/s"
        click.echo(f"\r{text:<50}" if terminal else text, nl=not terminal, err=True)

    def close(self) -> None:
        """Leave the line of the progress."""
        if self._drawn and sys.stderr.isatty():
            click.echo(err=True)

    def _save(self, client: LogClient, entry: LogEntry, content: bytes) -> None:
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
        self._report(client, entry, path, content, "downloaded")

    def _report(self, client: LogClient, entry: LogEntry, path: Path, content: bytes, outcome: str) -> None:
        checksum = hashlib.sha256(content).hexdigest()
        row = {"sysid": client.sysid, "number": entry.number, "file": str(path), "outcome": outcome}
        self.rows.append({**row, "size_bytes": len(content), "sha256": checksum})
        if self._say:
            words = "is there already" if outcome == "already" else f"{len(content)} bytes"
            click.echo(f"{client.sysid:>3}  log {entry.number}: {path}, {words}, sha256 {checksum}")


def _list(fleet: AskedFleet) -> list[LogClient]:
    from gcs.mavlink.ids import AUTOPILOT
    from gcs.mavlink.log_client import LogClient

    clients = [LogClient(sysid, AUTOPILOT) for sysid in sorted(fleet.profiles)]
    for client in clients:
        client.list_logs()
    fleet.converse(clients)
    return clients


def _sorted(client: LogClient) -> list[LogEntry]:
    return sorted(client.entries.values())


def _wanted(client: LogClient, numbers: Sequence[int], *, everything: bool) -> list[LogEntry]:
    """The logs that are asked for; the newest is the one that began last, else the one with the highest number."""
    if everything:
        return _sorted(client)
    if not numbers:
        return sorted(client.entries.values(), key=_by_time)[-1:]
    for number in numbers:
        if number not in client.entries and not client.list_problem:
            client.failed[number] = "it has no such log"
    return [client.entries[number] for number in dict.fromkeys(numbers) if number in client.entries]


def _by_time(log: LogEntry) -> tuple[int, int]:
    return log.unix_s, log.number


def _stem(client: LogClient, entry: LogEntry) -> str:
    begun = f"-{datetime.fromtimestamp(entry.unix_s, UTC):%Y%m%dT%H%M%SZ}" if entry.unix_s else ""
    return f"vehicle-{client.sysid}-log-{entry.number}{begun}"


def _begun(log: LogEntry) -> str | None:
    return f"{datetime.fromtimestamp(log.unix_s, UTC):%Y-%m-%dT%H:%M:%SZ}" if log.unix_s else None


def _complain(clients: Sequence[LogClient]) -> int:
    """Say what did not come; the exit status of that."""
    for client in clients:
        problems = [f"log {number}: {why}" for number, why in client.failed.items()]
        for problem in [*filter(None, [client.list_problem]), *problems]:
            click.echo(f"gcs: vehicle {client.sysid}: {problem}", err=True)
    return NOT_DONE if any(client.failed or client.list_problem for client in clients) else 0
