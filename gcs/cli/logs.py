"""`gcs logs`: the logs that vehicles wrote themselves, listed and downloaded over a whole fleet."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.fleet_options import fleet_at, of_the_fleet
from gcs.cli.options import Refused
from skytender.exit import NOT_DONE

if TYPE_CHECKING:
    from gcs.link.fleet_client import FleetClient
    from gcs.link.log_folder import LogFolder
    from gcs.mavlink.log_client import LogClient, LogEntry

SILENT_FOR_S = 2.0
"""Progress of what takes no longer is not shown."""
DRAW_EVERY_S, LINE_EVERY_S = 0.25, 5.0


@click.group(short_help="List and download the logs of a fleet.")
def logs() -> None:
    """Logs that vehicles wrote themselves, of every vehicle at an address at once, whatever its autopilot.

    ArduPilot sends its logs only while it is disarmed. A vehicle of ours has one if it was started with --truth: its
    truth, so far; those of `gcs launch` have none.

    \b
    Examples:
      gcs logs list --connect udpin:127.0.0.1:14550
      gcs logs get --out flown
      gcs logs get 12 13 --sysid 3 --out flown

    \b
    Exit status:
      0    done
      1    a log, or a list of logs, did not come
      2    bad input, or no vehicle was received
      130  stopped by Ctrl-C; what had come is kept
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
    gave; its SHA-256 is shown. A log that is there already, in that size, is not downloaded again. Of one that does
    not come whole, as of a vehicle that is switched off, what came is kept as NAME-partial.ENDING, with zeros for
    bytes that are missing, until the whole log takes its place.
    """
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Refused(f"--out {out}: {error.strerror}") from None
    from gcs.link.log_folder import LogFolder

    with fleet_at(**options) as fleet:
        clients = _list(fleet)
        folder = LogFolder(out, clients)
        progress = _Progress(folder, say=not as_json)
        for client in clients:
            client.download(folder.missing(client, _wanted(client, numbers, everything=everything)))
        try:
            progress.report()
            fleet.converse(clients, progress.look)
        except KeyboardInterrupt:
            for client in clients:
                for message in client.stop(" until the download was stopped"):
                    fleet.send_to(client.sysid, message)
            raise
        finally:
            progress.close()
            folder.close()
            status = _complain(clients)
    if as_json:
        click.echo(json.dumps(folder.rows()))
    elif not folder.kept and not any(client.failed or client.list_problem for client in clients):
        click.echo("there is no log")
    return status


class _Progress:
    """Tells which logs have come, and how far the others are."""

    def __init__(self, folder: LogFolder, *, say: bool) -> None:
        self._folder, self._say = folder, say
        self._begun_s = time.monotonic()
        self._shown_s = self._begun_s + SILENT_FOR_S - DRAW_EVERY_S
        self._drawn = False
        self._shown = 0

    def look(self) -> None:
        """Keep what has come whole since the last call, and show how far the others are."""
        self._folder.save()
        self.report()
        now_s = time.monotonic()
        terminal = sys.stderr.isatty()
        if now_s - self._shown_s < (DRAW_EVERY_S if terminal or not self._drawn else LINE_EVERY_S):
            return
        self._shown_s, self._drawn = now_s, True
        came = self._folder.bytes_so_far
        rate = came / (now_s - self._begun_s)
        text = f"{came / 1e6:.2f} of {self._folder.wanted_bytes / 1e6:.2f} MB, {rate / 1e3:.0f} kB/s"
        click.echo(f"\r{text:<50}" if terminal else text, nl=not terminal, err=True)

    def report(self) -> None:
        """Print a line for each log that is kept and not printed yet."""
        for log in self._folder.kept[self._shown :] if self._say else ():
            click.echo(log.text)
        self._shown = len(self._folder.kept)

    def close(self) -> None:
        """Leave the line of the progress."""
        if self._drawn and sys.stderr.isatty():
            click.echo(err=True)


def _list(fleet: FleetClient) -> list[LogClient]:
    from gcs.mavlink.ids import AUTOPILOT
    from gcs.mavlink.log_client import LogClient

    clients = [LogClient(s, AUTOPILOT, fleet.profiles[s].log_folders) for s in sorted(fleet.profiles)]
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
        from gcs.link.log_folder import newest

        return newest(client)
    for number in numbers:
        if number not in client.entries and not client.list_problem:
            client.failed[number] = "it has no such log"
    return [client.entries[number] for number in dict.fromkeys(numbers) if number in client.entries]


def _begun(log: LogEntry) -> str | None:
    return f"{datetime.fromtimestamp(log.unix_s, UTC):%Y-%m-%dT%H:%M:%SZ}" if log.unix_s else None


def _complain(clients: Sequence[LogClient]) -> int:
    """Say what did not come; the exit status of that."""
    from gcs.link.log_folder import problems

    found = problems(clients)
    for problem in found:
        click.echo(f"gcs: {problem}", err=True)
    return NOT_DONE if found else 0
