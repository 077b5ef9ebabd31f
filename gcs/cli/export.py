"""`gcs export`: a recorded session or any recording as tables for other programs."""

# ruff: noqa: PLC0415 - so that `gcs --help` and a mistyped option answer at once

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import click

from gcs.cli.options import out_option
from gcs.cli.progress_bar import progress_bar
from skytender.exit import NOT_DONE


@click.command(short_help="Write a session or a recording as tables, for pandas, DuckDB, PlotJuggler.")
@click.argument("session", type=click.Path(path_type=Path))
@click.argument("others", nargs=-1, type=click.Path(path_type=Path))
@click.option(
    "--format",
    "form",
    type=click.Choice(["parquet", "csv", "mcap"]),
    required=True,
    help="Parquet needs pyarrow, MCAP foxglove-sdk.",
)
@out_option("A new folder, for MCAP a new file.  [default: SESSION/FORMAT, or FILE-FORMAT beside FILE.tlog]")
@click.option("--json", "as_json", is_flag=True, help="What was written, as one JSON object on stdout.")
def export(session: Path, others: tuple[Path, ...], form: str, out: Path | None, as_json: bool) -> int:
    """Write SESSION, a session's folder or any recording, as tables: one file per message type.

    A recording is a .tlog, .tlog.raw or .rlog file. ArduPilot's .BIN and PX4's .ulg are read as the MAVLink that their
    vehicle would have sent, motion ten times a second at most. OTHERS are recordings beside it, as in gcs replay.

    Columns are SI and say so (x_ned_m, roll_rad, voltage_v, lat_deg); what MAVLink's definitions mark as unknown is
    an empty cell. Every table begins with time_s, seconds since the session's start (of a .tlog: since its first
    frame), sysid, compid and direction: `from` a vehicle or `to` one. A session's decisions come as decisions_KIND, and
    what the vehicles themselves knew as truth and truth_thrust.

    MCAP is one file for Foxglove: the fleet in space and on a map, events, and the rows of each vehicle, ten a second.

    \b
    Examples:
      gcs export sessions/demo-20260101-120000 --format csv
      gcs export flight.tlog --format parquet --out tables
      gcs export first-flight --format mcap --out first-flight.mcap
      duckdb -c "select sysid, max(-z_ned_m) from 'tables/LOCAL_POSITION_NED.parquet' group by sysid"

    \b
    Exit status:
      0    the tables were written; what could not be read is said
      1    they could not be written
      2    bad input; nothing has been written
      130  stopped by Ctrl-C; nothing is left behind
    """
    if form == "mcap":
        return _export_mcap(session, others, out, as_json=as_json)
    from gcs.recording import export as exporter
    from gcs.recording.importing import ImportFailed, beside
    from gcs.recording.tables import NO_PARQUET, available, tables

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
        with progress_bar("exporting") as progress, beside([session, *others]) as source:
            try:
                problems = source.problems + exporter.export(source.path, written, progress)
            finally:
                written.close()
        unfinished.rename(folder)
    except (exporter.ExportError, ImportFailed) as error:
        raise click.UsageError(str(error)) from None
    except OSError as error:
        click.echo(f"gcs: {error.filename or folder}: {error.strerror}", err=True)
        return NOT_DONE
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)
    for problem in problems:
        click.echo(f"gcs: {problem}", err=True)
    if as_json:
        click.echo(
            json.dumps({"tables": str(folder), "rows": dict(sorted(written.rows.items())), "problems": problems})
        )
        return 0
    width = max(map(len, written.rows), default=0)
    for name, rows in sorted(written.rows.items()):
        click.echo(f"{name:<{width}}  {rows:>9} rows")
    click.echo(f"tables: {folder}")
    return 0


def _export_mcap(session: Path, others: tuple[Path, ...], out: Path | None, *, as_json: bool) -> int:
    from gcs.recording.importing import ImportFailed, beside
    from gcs.report import foxglove
    from gcs.session.replay import ReplayError

    if not foxglove.available():
        raise click.UsageError(foxglove.MISSING)
    path = out or (session / "session.mcap" if session.is_dir() else session.with_suffix(".mcap"))
    try:
        with progress_bar("exporting") as progress, beside([session, *others]) as source:
            count, problems = foxglove.export(source.path, path, progress)
            problems = source.problems + problems
    except (ReplayError, ImportFailed) as error:
        raise click.UsageError(str(error)) from None
    except FileExistsError:
        raise click.UsageError(
            f"{path} exists already and is left as it is; give --out a file that does not."
        ) from None
    except OSError as error:
        click.echo(f"gcs: {error.filename or path}: {error.strerror}", err=True)
        return NOT_DONE
    for problem in problems:
        click.echo(f"gcs: {problem}", err=True)
    found = json.dumps({"file": str(path), "snapshots": count, "problems": problems})
    click.echo(found if as_json else f"{count} snapshots: {path}")
    return 0
