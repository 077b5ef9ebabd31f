"""`gcs export`: what was recorded, for other programs."""

# ruff: noqa: PLC0415 - so that `gcs --help` and a mistyped option answer at once

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import click

NOT_MADE = 1


@click.command(short_help="Write a session or a .tlog as tables, for pandas, DuckDB, PlotJuggler.")
@click.argument("session", type=click.Path(path_type=Path))
@click.option("--format", "form", type=click.Choice(["parquet", "csv"]), required=True, help="Parquet needs pyarrow.")
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="A new folder.  [default: SESSION/FORMAT, or FILE-FORMAT beside FILE.tlog]",
)
def export(session: Path, form: str, out: Path | None) -> int:
    """Write SESSION, a session's folder or any .tlog file, as tables: one file per message type.

    Columns are SI and say so (x_ned_m, roll_rad, voltage_v, lat_deg); what MAVLink calls unknown is an empty cell.
    Every table begins with time_s, seconds since the session's start (of a .tlog: since its first frame), sysid, compid
    and direction: `from` a vehicle or `to` one. A session's decisions come as decisions_KIND, and what the vehicles
    themselves knew as truth and truth_thrust.

    \b
    Examples:
      gcs export sessions/demo-20260101-120000 --format csv
      gcs export flight.tlog --format parquet --out tables
      duckdb -c "select sysid, max(-z_ned_m) from 'tables/LOCAL_POSITION_NED.parquet' group by sysid"

    \b
    Exit status:
      0    the tables were written; what could not be read is said
      1    they could not be written
      2    bad input; nothing has been written
      130  stopped by Ctrl-C; nothing is left behind
    """
    from rich.console import Console
    from rich.progress import Progress

    from gcs import export as exporter
    from gcs.tables import NO_PARQUET, available, tables

    kind: Any = form
    if not available(kind):
        raise click.UsageError(NO_PARQUET)
    folder = out or (session / form if session.is_dir() else session.with_name(f"{session.stem}-{form}"))
    if folder.exists():
        raise click.UsageError(f"{folder} exists already and is left as it is; give --out a folder that does not.")
    unfinished = folder.with_name(f".{folder.name}.unfinished")
    try:
        shutil.rmtree(unfinished, ignore_errors=True)
        unfinished.mkdir(parents=True)
        written = tables(kind, unfinished)
        console = Console(stderr=True)
        with Progress(console=console, transient=True, disable=not console.is_terminal) as shown:
            task = shown.add_task("exporting", total=1.0)
            try:
                problems = exporter.export(session, written, lambda share: shown.update(task, completed=share))
            finally:
                written.close()
        unfinished.rename(folder)
    except exporter.ExportError as error:
        raise click.UsageError(str(error)) from None
    except OSError as error:
        click.echo(f"gcs: {error.filename or folder}: {error.strerror}", err=True)
        return NOT_MADE
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)
    for problem in problems:
        click.echo(f"gcs: {problem}", err=True)
    width = max(len(name) for name in written.rows)
    for name, rows in sorted(written.rows.items()):
        click.echo(f"{name:<{width}}  {rows:>9} rows")
    click.echo(f"tables: {folder}")
    return 0
