"""`gcs monitor`: look at a session that runs already."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import time
from pathlib import Path

import click

from gcs.console.client import SOCKET

BAD_INPUT = 2
WAIT_S = 0.125


@click.command(short_help="Watch a session that runs already.")
@click.argument("session", required=False, type=click.Path(path_type=Path, file_okay=False))
@click.option("--plain", is_flag=True, help="Lines of text instead of the console; also used without a terminal.")
def monitor(session: Path | None, plain: bool) -> int:
    """Open a further console on SESSION, the folder of a session that runs; without it, on the newest in sessions/.

    Any number may watch one session, and command it. Closing one changes nothing for the session or the others. The
    monitor ends by itself when the session does.

    \b
    Examples:
      gcs monitor
      gcs monitor sessions/demo-20260101-120000
      gcs monitor first-flight --plain

    \b
    Exit status:
      0    closed, or the session has ended
      2    no session runs there
      70   an error of the program itself
    """
    folder = session or _newest()
    if folder is None:
        raise click.UsageError("no session runs under sessions/; name the folder of one that does.")
    from gcs.console.client import Client

    try:
        Client(folder).close()
    except OSError:
        raise click.UsageError(f"no session runs in {folder}; `gcs run` starts one.") from None
    from gcs.console.client_source import SessionSource

    source = SessionSource(folder)
    from gcs.terminal import usable

    if plain or not usable():
        return _lines(source)
    from gcs.console.app import show

    return show(source, folder.name)


def _newest() -> Path | None:
    """The folder of the session that opened its socket last."""
    sockets = [path for path in Path("sessions").glob(f"*/{SOCKET}") if path.is_socket()]
    return max(sockets, key=lambda path: path.stat().st_mtime).parent if sockets else None


def _lines(source: object) -> int:
    from gcs.console.client_source import SessionSource
    from gcs.console.plain import PlainView, mute_stdout

    assert isinstance(source, SessionSource)
    view = PlainView(click.echo)
    try:
        while True:
            for message in source.receive():
                if message.get("type") == "snapshot":
                    view.show(message)
                elif message.get("type") == "end":
                    view.close()
                    click.echo(f"outcome: {message.get('outcome') or 'unknown'}")
                    return 0
            view.tick(time.monotonic())
            time.sleep(WAIT_S)
    except (BrokenPipeError, KeyboardInterrupt):
        mute_stdout()
        return 0
    finally:
        source.close()
