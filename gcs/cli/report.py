"""`gcs report`: a recorded session as one page."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import contextlib
import json
import os
import signal
import threading
from collections.abc import Callable
from pathlib import Path

import click

from skytender.exit import BAD_INPUT, NOT_DONE, ending, leave

SIGNALLED = 128
"""Exit statuses above it stand for a signal."""
PATIENCE_S = 2.0
MAKING = "making the report ... (Ctrl-C leaves it out)"
FILE = "report.html"


@click.command(short_help="Make a recorded session's report, one page.")
@click.argument("session", type=click.Path(path_type=Path))
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Write the page here.  [default: report.html in the session's folder; FILE.html beside a recording]",
)
@click.option("--quiet", "-q", is_flag=True, help="Say only what goes wrong.")
@click.option("--json", "as_json", is_flag=True, help="The page's place as one JSON object on stdout.")
def report(session: Path, out: Path | None, quiet: bool, as_json: bool) -> int:
    """Make report.html of SESSION, a folder that `gcs run` left: outcome and reasons, paths from above and in space,
    tracking, attitude, energy, competition, refuellings, distances, link, the numbers, and how to reproduce it. Or of
    any recording, .tlog, .tlog.raw, .rlog, .BIN or .ulg: what it holds of these.

    The page is one file that needs no network, for a screen of any width or for paper. `gcs run` makes it too; this
    makes it again, or of a session that was killed: what its files cannot tell, the page says at its top. An older
    report is replaced.

    \b
    Examples:
      gcs report sessions/demo-20260101-120000
      gcs report first-flight --out first-flight.html
      gcs report flight.tlog

    \b
    Exit status:
      0    the report was made
      1    it could not be written
      2    SESSION is no session's folder and no recording
      130  stopped by Ctrl-C; an older report is left as it was
      70   an error of the program itself
    """
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn

    from gcs.recording.importing import ImportFailed
    from gcs.recording.session_folder import NoSession
    from gcs.report.page import make

    if out is not None and not out.parent.is_dir():
        raise click.UsageError(f"--out: there is no folder {out.parent}.")
    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeElapsedColumn())
    console = Console(stderr=True)
    try:
        with Progress(*columns, console=console, transient=True, disable=quiet or not console.is_terminal) as shown:
            task = shown.add_task("reading", total=1.0)
            made = make(session, out, lambda what, share: shown.update(task, description=what, completed=share))
    except (NoSession, ImportFailed) as error:
        click.echo(str(error), err=True)
        return BAD_INPUT
    except OSError as error:
        click.echo(f"{error.filename or session}: {error.strerror}", err=True)
        return NOT_DONE
    if as_json:
        click.echo(json.dumps({"report": str(made)}))
    elif not quiet:
        click.echo(f"report: {made}")
    return 0


def after_run(
    folder: Path, echo: Callable[[str], object], status: int = 0, *, hurried: bool = False, last: bool = False
) -> None:
    """The report at the end of a session that ended with `status`.

    The path is printed; any failure to make it is a warning. Where the user has stopped the session, the terminal says
    at once what is waited for. Ctrl-C, SIGTERM or SIGHUP leaves the report out and ends the process; it is
    left out, too, where that came before (`hurried`). `last`: nothing comes after it, so that each ends the process
    with its status from then on.
    """
    tlog = folder / "session.tlog"
    if not tlog.is_file() or not tlog.stat().st_size:  # nothing was flown: there is nothing to report
        return
    left_out = f"gcs: the report was left out; gcs report {folder} makes it"
    if hurried:
        click.echo(left_out, err=True)
        return
    patience = threading.Timer(PATIENCE_S, echo, [MAKING])
    patience.daemon = True
    made: Path | None = None

    def leave_out(*_: object) -> None:
        (folder / f".{FILE}.{os.getpid()}").unlink(missing_ok=True)
        if made is None:
            with contextlib.suppress(OSError):
                click.echo(left_out, err=True)
        leave(status)

    handlers = {number: signal.signal(number, leave_out) for number in ending()}
    try:
        if status > SIGNALLED:
            echo(f"saved; {MAKING}")
        else:
            patience.start()
        from gcs.report.page import make

        made = make(folder)
        patience.cancel()
        echo(f"report: {made}")
    except Exception as error:  # a session that was flown must not fail by its report
        why = f"{error.strerror}" if isinstance(error, OSError) else str(error) or type(error).__name__
        click.echo(f"gcs: warning: no report was made: {why}; gcs report {folder} tries again", err=True)
    finally:
        patience.cancel()
        for number, handler in handlers.items() if not (last and made) else ():
            signal.signal(number, handler)
