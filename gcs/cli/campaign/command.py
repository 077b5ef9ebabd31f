"""`gcs campaign`: many sessions, one answer.

`search` and `shrink` look for the worst case (worst_case.py).
"""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.campaign.options import FOLDER, OUT, QUIET, SEED, flown, found, planned
from gcs.cli.campaign.progress_line import ProgressLine
from gcs.cli.campaign.worst_case import fly_search, search, shrink
from gcs.cli.options import Refused, out_option
from gcs.cli.trust import TRUST
from skytender.exit import DONE, NOT_DONE

if TYPE_CHECKING:
    from gcs.campaign.plan import Plan, PlannedRow


@click.group(short_help="Fly a scenario many times, varied, and see what comes of it.")
def campaign() -> None:
    """Fly a scenario many times, varied, and see what comes of it, with its uncertainty.

    \b
    Examples:
      gcs campaign run policies
      gcs campaign run my-campaign.yaml --workers 4 --out first
      gcs campaign status first
      gcs campaign fly first 17
    """


campaign.add_command(search)
campaign.add_command(shrink)


@campaign.command(short_help="Fly a campaign.")
@click.argument("file", metavar="FILE")
@click.option(
    "--sessions", type=click.IntRange(1), metavar="N", help="Draws of each combination, instead of the file's."
)
@SEED
@OUT
@flown
def run(
    file: str,
    sessions: int | None,
    seed: int | None,
    out: Path | None,
    trust: bool,
    **how: Any,
) -> int:
    """Fly FILE, a campaign's file or the name of a shipped one; a row per session, written as rows come.

    Ctrl-C stops it: `gcs campaign resume` flies what is missing. DIR/rows is a folder of Parquet files that pandas and
    DuckDB read, also while the campaign runs.

    \b
    Exit status:
      0    every session is as expected
      1    some are not, or not all could be flown
      2    bad input; nothing has flown
      130  stopped by Ctrl-C (143 by SIGTERM); what was flown is saved
    """
    from gcs.campaign.cluster import EngineError
    from gcs.campaign.runner import make_folder

    plan = planned(file, sessions, seed, trust=trust)
    try:
        folder = make_folder(plan, out)
    except EngineError as error:
        raise Refused(str(error)) from None
    return _fly(folder, plan, **how)


@campaign.command(short_help="Fly what a campaign lacks.")
@FOLDER
@click.option("--errors", is_flag=True, help="Fly also those again that ended with an error.")
@flown
def resume(folder: Path, errors: bool, trust: bool, **how: Any) -> int:
    """Go on with the campaign in DIR: only sessions without a row are flown.

    \b
    Exit status: as of `gcs campaign run`.
    """
    plan = found(folder, trust=trust, resumed=True)
    if errors and plan.is_search:
        raise click.UsageError("--errors: a search went on from what its errors showed, and cannot take one back.")
    return fly_search(folder, plan, **how) if plan.is_search else _fly(folder, plan, errors=errors, **how)


@campaign.command(short_help="How far a campaign is.")
@FOLDER
@click.option("--json", "as_json", is_flag=True, help="One JSON object on stdout.")
def status(folder: Path, as_json: bool) -> int:
    """Say how many sessions of the campaign in DIR are there, and how they went; also while it runs.

    \b
    Exit status:
      0    all are there
      1    some are missing
      2    DIR holds no campaign
    """
    from gcs.campaign import statistics, table

    plan = found(folder)
    rows = table.read(folder, plan.campaign)
    state = DONE if rows.num_rows == plan.rows else NOT_DONE
    if as_json:
        click.echo(json.dumps(statistics.summary(plan, rows)))
        return state
    click.echo(f"{plan.campaign.name}: {rows.num_rows} of {plan.rows} sessions")
    for line in statistics.text(plan, rows):
        click.echo(line)
    return state


@campaign.command(short_help="Fly one session of a campaign again.")
@FOLDER
@click.argument("row", type=click.IntRange(0))
@out_option("The session's folder.")
@click.option("--scenario", "only", is_flag=True, help="Print the scenario instead of flying it.")
@QUIET
@TRUST
def fly(folder: Path, row: int, out: Path | None, only: bool, quiet: bool, trust: bool) -> int:
    """Fly session ROW of the campaign in DIR as `gcs run` would; its digest is the row's.

    \b
    Exit status:
      0    the session's goal was met
      1    it was not, or the digest is another
      2    there is no such row, or it cannot be flown
    """
    import json

    import pyarrow.compute as pc

    from gcs.campaign import table
    from gcs.campaign.plan import RowError
    from gcs.report.page import make as make_report
    from gcs.scenario.file import dump
    from gcs.session import supervised
    from gcs.session.plain_text import PlainView, View

    plan = found(folder, trust=trust)
    if row >= plan.rows:
        raise click.UsageError(f"there is no row {row}: {plan.campaign.name} has rows 0 to {plan.rows - 1}")
    try:
        scenario, _ = plan.resolved(_planned(plan, folder, row))
    except RowError as error:
        raise Refused(str(error)) from None
    if only:
        click.echo(dump(scenario), nl=False)
        return DONE
    session = supervised.make_folder(out, scenario.name)
    supervised.write_scenario(session, scenario)
    if not quiet:
        click.echo(f"{scenario.name}, row {row}: the session's folder is {session}")
    arguments = [word for module in plan.modules for word in ("--modules", module)]
    view = View() if quiet else PlainView(click.echo)
    ended = supervised.run(session, view, str if quiet else click.echo, arguments=arguments)
    rows = table.read(folder, plan.campaign)
    recorded = rows.filter(pc.equal(rows["row"], row)).to_pylist()
    if ended in (DONE, NOT_DONE) and recorded and recorded[0]["digest"] is not None:
        digest = json.loads((session / "summary.json").read_text(encoding="utf-8"))["digest"]
        if digest != recorded[0]["digest"]:
            click.echo(f"the digest is {digest}, the row's {recorded[0]['digest']}: other versions?", err=True)
            return NOT_DONE
    make_report(session)
    return ended


@campaign.command(short_help="Make the page of a campaign.")
@FOLDER
def report(folder: Path) -> int:
    """Write DIR/report.html: rates, distributions, paired differences, each with its interval, and the worst sessions.

    \b
    Exit status:
      0    the page was written
      1    it could not be written
      2    DIR holds no campaign
    """
    from gcs.campaign.runner import NEEDED
    from gcs.extras import require

    plan = found(folder)
    require("a campaign's page", NEEDED, "campaign")
    from gcs.campaign import report as pages

    try:
        path = pages.make(folder, plan)
    except OSError as error:
        click.echo(f"{folder}: the page cannot be written: {error.strerror}", err=True)
        return NOT_DONE
    click.echo(f"{path}: written")
    return DONE


def _planned(plan: Plan, folder: Path, number: int) -> PlannedRow:
    """A row of the campaign in a folder. Raises RowError."""
    from gcs.extras import require

    if not plan.is_search:
        return plan.row(number)
    require("a search", {"optuna": "Optuna"}, "campaign")
    from gcs.campaign.search import Search

    return Search(plan, folder).row(number)


def _fly(
    folder: Path,
    plan: Plan,
    *,
    scheduler: str | None,
    workers: int | None,
    plain: bool,
    quiet: bool,
    errors: bool = False,
) -> int:
    from gcs.campaign import statistics, table
    from gcs.campaign.cluster import EngineError
    from gcs.campaign.runner import NEEDED, Runner
    from gcs.extras import require

    if scheduler is not None and workers is not None:
        raise click.UsageError("--scheduler and --workers exclude each other: its workers are those that it has.")
    require("a campaign", NEEDED, "campaign")
    shown = ProgressLine(folder, quiet=quiet, plain=plain or not sys.stdout.isatty())
    if not quiet:
        click.echo(f"{plan.campaign.name}: {plan.rows} sessions; the campaign's folder is {folder}")
    runner = Runner(folder, plan, scheduler=scheduler, workers=workers, notify=shown.update, errors=errors)
    try:
        progress = runner.run()
    except EngineError as error:
        shown.end()
        click.echo(f"gcs: {error}; what was flown is kept, gcs campaign resume {folder} goes on", err=True)
        return NOT_DONE
    shown.end()
    rows = table.read(folder, plan.campaign)
    if not quiet:
        for line in statistics.text(plan, rows):
            click.echo(line)
    if rows.num_rows:
        _page(folder, plan, quiet=quiet)
    if runner.interrupted:
        click.echo(f"stopped; gcs campaign resume {folder} flies the other {progress.total - progress.done}", err=True)
        return 128 + runner.interrupted
    return DONE if rows.num_rows == plan.rows and all(rows["ok"].to_pylist()) else NOT_DONE


def _page(folder: Path, plan: Plan, *, quiet: bool) -> None:
    """Make the page after a run; that it cannot be written does not undo the run."""
    from gcs.campaign import report as pages

    try:
        path = pages.make(folder, plan)
    except OSError as error:
        click.echo(f"gcs: the page of {folder} cannot be written: {error.strerror}", err=True)
        return
    if not quiet:
        click.echo(f"report: {path}")
