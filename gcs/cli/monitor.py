"""Command `gcs monitor`: opens a console on a running session, or on the MAVLink traffic at an address."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING

import click

from gcs.cli import page
from gcs.cli.options import PLAIN, STATION_OPTION, connect_option, connecting, key_file_option, refuse_two_shows
from gcs.scenario.endpoint import LISTENS, Endpoint
from gcs.session.client import SOCKET

if TYPE_CHECKING:
    from gcs.session.client import MessageSource


@click.command(short_help="Watch a session that runs already, or any fleet.")
@click.argument("session", required=False, type=click.Path(path_type=Path, file_okay=False))
@connect_option(
    "Watch the vehicles heard there instead of a session: any autopilot, any number, nothing to configure. udpin, "
    "udpout, tcp, tcpin:HOST:PORT, or serial:DEVICE:BAUD."
)
@click.option(
    "--control",
    is_flag=True,
    help="With --connect: also speak: ask for streams, order hold, return and land.",
)
@key_file_option(
    "With --connect: MAVLink 2 signing; take only what is signed with this key, and sign what --control sends."
)
@STATION_OPTION
@PLAIN
@click.option("--json", "as_json", is_flag=True, help="One JSON object per second on stdout, for other programs.")
@page.WEB
@page.TILES
@page.FOXGLOVE
@click.pass_context
def monitor(
    context: click.Context,
    session: Path | None,
    connect: Endpoint | None,
    control: bool,
    key_file: Path | None,
    station: tuple[int, int],
    plain: bool,
    as_json: bool,
    web: bool,
    tiles: str | None,
    foxglove: bool,
) -> int:
    """Open a further console on SESSION, the folder of a session that runs; without it, on the newest in sessions/.

    Any number may watch one session, and command it. Closing one changes nothing for the session or the others. The
    monitor ends by itself when the session does.

    With --connect it shows every vehicle that sends a HEARTBEAT to an address, PX4, ArduPilot or others. It only
    listens: not even a HEARTBEAT leaves, unless --control is given.

    \b
    Examples:
      gcs monitor
      gcs monitor sessions/demo-20260101-120000
      gcs monitor --connect udpin:127.0.0.1:14550
      gcs monitor --connect udpin:0.0.0.0:14550 --control
      gcs monitor --connect serial:/dev/ttyUSB0:57600
      gcs monitor --web
      gcs monitor --foxglove

    \b
    Exit status:
      0    closed, also by Ctrl-C, or the session has ended
      2    no session runs there, or the address cannot be had
      70   an error of the program itself
    """
    refuse_two_shows(plain=plain, as_json=as_json, web=web, foxglove=foxglove, tiles=tiles)
    if connect is not None and session is not None:
        raise click.UsageError("SESSION and --connect exclude each other: watch either a session or an address.")
    if control and connect is None:
        raise click.UsageError("--control is for --connect: a session takes its watchers' commands as it is.")
    if key_file is not None and connect is None:
        raise click.UsageError("--key-file is for --connect: a session has the keys of its vehicles itself.")
    if not control and context.get_parameter_source("station") is click.core.ParameterSource.COMMANDLINE:
        raise click.UsageError("--station is for --control: without it nothing is said to any vehicle.")
    report = None
    if connect is None:
        source, folder = _session(session)
        title, report = folder.name, folder / "report.html"
    else:
        source, title = _monitor(connect, control, key_file, station)
    from gcs.console.terminal import usable

    if not (web or foxglove or plain or as_json) and usable():
        from gcs.console.app import show

        return show(source, title)
    from gcs.console.follow import follow

    with contextlib.suppress(KeyboardInterrupt):
        if web:
            page.show(source, commands=connect is None or control, tiles=tiles, report=report)
        elif foxglove:
            page.show_in_foxglove(source)
        else:
            follow(source, click.echo, as_json=as_json, changes_only=connect is not None)
    return 0


def _session(session: Path | None) -> tuple[MessageSource, Path]:
    """The session in a folder and that folder, or the newest one. Raises click.UsageError where none runs."""
    folder = session or _newest()
    if folder is None:
        raise click.UsageError("no session runs under sessions/; name the folder of one that does.")
    from gcs.session.client import Client, SessionSource

    try:
        Client(folder).close()
    except OSError:
        raise click.UsageError(f"no session runs in {folder}; `gcs run` starts one.") from None
    return SessionSource(folder), folder


def _monitor(at: Endpoint, control: bool, key_file: Path | None, station: tuple[int, int]) -> tuple[MessageSource, str]:
    """Monitor of all vehicles received at an address. Raises click.UsageError where it cannot be opened."""
    from gcs.session.monitor import MonitorSource

    with connecting():
        source = MonitorSource(at, control=control, key_file=key_file, station=station)
    if at.way in LISTENS:
        at = at._replace(port=source.port)
        click.echo(f"gcs: listening at {at.text}; Ctrl-C ends it.", err=True)
    return source, at.text


def _newest() -> Path | None:
    """The folder of the session that opened its socket last."""
    sockets = [path for path in Path("sessions").glob(f"*/{SOCKET}") if path.is_socket()]
    return max(sockets, key=lambda path: path.stat().st_mtime).parent if sockets else None
