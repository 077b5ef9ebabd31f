"""`gcs campaign`: many sessions, one answer."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.author import SET, load_scenario
from gcs.cli.campaign.progress_line import ProgressLine
from gcs.cli.options import Refused, out_option
from gcs.cli.trust import TRUST, allow
from skytender.exit import DONE, NOT_DONE

if TYPE_CHECKING:
    from gcs.campaign.engine import Progress
    from gcs.campaign.model import Expectation
    from gcs.campaign.plan import Plan


SEED = click.option("--seed", type=click.IntRange(0), metavar="N", help="Instead of the file's.")
OUT = out_option("A new folder.  [default: campaigns/NAME-TIME]")
FOLDER = click.argument("folder", metavar="DIR", type=click.Path(path_type=Path, file_okay=False))


def _scheduler(ctx: click.Context, param: click.Parameter, value: str | None) -> str | None:
    """The callback of --scheduler: an address that has TLS, with certificates for it."""
    if value is not None:
        from gcs.campaign.cluster import EngineError, check_scheduler

        try:
            check_scheduler(value)
        except EngineError as error:
            raise click.BadParameter(f"{error}.", ctx, param) from None
    return value


SCHEDULER = click.option(
    "--scheduler",
    callback=_scheduler,
    metavar="ADDRESS",
    help="Fly on the workers of this Dask scheduler, by mutual TLS, such as tls://HOST:8786.",
)
WORKERS = click.option(
    "--workers", type=click.IntRange(1, 1024), metavar="N", help="Workers on this machine.  [default: one per core]"
)
PLAIN = click.option("--plain", is_flag=True, help="Lines of text instead of a progress line.")
QUIET = click.option("--quiet", "-q", is_flag=True, help="Say only what goes wrong.")


def flown(command: Callable[..., Any]) -> Callable[..., Any]:
    """The options of every command that flies a campaign's sessions."""
    return SCHEDULER(WORKERS(PLAIN(QUIET(TRUST(command)))))


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
    from gcs.campaign.engine import EngineError
    from gcs.campaign.runner import make_folder

    plan = _planned(file, sessions, seed, trust=trust)
    try:
        folder = make_folder(plan, out)
    except EngineError as error:
        raise Refused(str(error)) from None
    return _fly(folder, plan, **how)


@campaign.command(short_help="Fly what a campaign lacks.")
@FOLDER
@flown
def resume(folder: Path, trust: bool, **how: Any) -> int:
    """Go on with the campaign in DIR: only sessions without a row are flown.

    \b
    Exit status: as of `gcs campaign run`.
    """
    return _fly(folder, _found(folder, trust=trust), **how)


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

    plan = _found(folder)
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

    plan = _found(folder, trust=trust)
    if row >= plan.rows:
        raise click.UsageError(f"there is no row {row}: {plan.campaign.name} has rows 0 to {plan.rows - 1}")
    try:
        scenario, _ = plan.resolved(plan.row(row))
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

    plan = _found(folder)
    require("a campaign's page", NEEDED, "campaign")
    from gcs.campaign import report as pages

    try:
        path = pages.make(folder, plan)
    except OSError as error:
        click.echo(f"{folder}: the page cannot be written: {error.strerror}", err=True)
        return NOT_DONE
    click.echo(f"{path}: written")
    return DONE


@campaign.command(short_help="Look for the worst case.")
@click.argument("file", metavar="FILE")
@click.option("--trials", type=click.IntRange(1), metavar="N", help="Instead of the file's.")
@SEED
@OUT
@flown
def search(
    file: str,
    trials: int | None,
    seed: int | None,
    out: Path | None,
    scheduler: str | None,
    workers: int | None,
    plain: bool,
    quiet: bool,
    trust: bool,
) -> int:
    """Search what FILE, a campaign with `search:`, draws for the worst value of a measure, and write that scenario.

    DIR/worst.yaml is what `gcs run --lockstep` flies; the table has a row per trial.

    \b
    Exit status:
      0    every trial is there
      1    not all could be flown
      2    bad input; nothing has flown
      130  stopped by Ctrl-C
    """
    from gcs.campaign import table
    from gcs.campaign.engine import EngineError
    from gcs.campaign.model import SearchRules
    from gcs.campaign.runner import Runner, make_folder
    from gcs.campaign.search import Search
    from gcs.extras import require
    from gcs.scenario.file import dump

    plan = _planned(file, None, seed, trust=trust)
    rules = plan.campaign.search
    if rules is None:
        raise Refused(f"{file} says nothing of a search: add 'search: {{minimise: min_separation_m, trials: 200}}'")
    if trials is not None:
        rules = SearchRules.model_validate({**rules.model_dump(), "trials": trials})
    each = {key: draw.model_copy(update={"together": True}) for key, draw in plan.campaign.draw.items()}
    changed = {"search": rules, "vary": {}, "keep": "none", "sessions": rules.trials, "draw": each}
    changed["set"] = {**plan.campaign.set, **{k: v for k, v in plan.row(0).values.items() if k in plan.campaign.vary}}
    plan = replace(plan, campaign=plan.campaign.model_copy(update=changed))
    require("a search", {"optuna": "Optuna"}, "campaign")
    try:
        folder = make_folder(plan, out)
        searched = Search(plan, folder)
        shown = ProgressLine(folder, quiet=quiet, plain=plain or not sys.stdout.isatty())

        def notify(progress: Progress, row: dict[str, Any] | None) -> None:
            if row is not None:
                searched.add(row)
            shown.update(progress, None)

        runner = Runner(folder, plan, scheduler=scheduler, workers=workers, notify=notify, rows=searched.rows())
        progress = runner.run()
    except EngineError as error:
        click.echo(f"gcs: {error}", err=True)
        return NOT_DONE
    shown.end()
    name = str(rules.minimise or rules.maximise)
    rows = [row for row in table.read(folder, plan.campaign).to_pylist() if row[name] is not None]
    if rows:
        worst = (min if rules.minimise else max)(rows, key=lambda row: (row[name], row["row"]))
        scenario, _ = plan.resolved(searched.row(worst))
        (folder / "worst.yaml").write_text(dump(scenario), encoding="utf-8")
        if not quiet:
            click.echo(f"{name} {worst[name]:.4g} in trial {worst['row']}: gcs run {folder / 'worst.yaml'} --lockstep")
    if runner.interrupted:
        return 128 + runner.interrupted
    return DONE if progress.done == rules.trials else NOT_DONE


@campaign.command(short_help="Make a failing scenario small.")
@click.argument("scenario", metavar="SCENARIO")
@SET
@click.option(
    "--expect",
    multiple=True,
    metavar="MEASURE>=N",
    help="What it fails: min_separation_m>=0.6 or lost<=0; repeatable.  [default: its goal]",
)
@click.option("--out", type=click.Path(path_type=Path, dir_okay=False), default=Path("small.yaml"), show_default=True)
@QUIET
@TRUST
def shrink(
    scenario: str, settings: tuple[str, ...], expect: tuple[str, ...], out: Path, quiet: bool, trust: bool
) -> int:
    """Take vehicles, obstacles and digits from SCENARIO while its session still fails, and write what is left.

    \b
    Examples:
      gcs campaign shrink worst.yaml --expect 'min_separation_m>=0.6'

    \b
    Exit status:
      0    the small scenario was written
      1    SCENARIO does not fail
      2    it cannot be flown
    """
    from gcs.campaign import shrink as shrinking
    from gcs.campaign.spawner import SessionSpawner, SpawnError
    from gcs.scenario.file import dump

    loaded = load_scenario(scenario, settings, trust=trust, quiet=quiet).flown(lockstep=True)
    wanted = dict(_expectation(text) for text in expect)
    try:
        with SessionSpawner() as sessions:
            small = shrinking.shrink(
                loaded, shrinking.failing(sessions, wanted, (lambda _: None) if quiet else click.echo)
            )
    except ValueError as error:
        click.echo(f"{scenario}: {error}", err=True)
        return NOT_DONE
    except SpawnError as error:
        raise Refused(str(error)) from None
    out.write_text(dump(small), encoding="utf-8")
    if not quiet:
        click.echo(f"{out}: written; gcs run {out} --lockstep flies it")
    return DONE


def _expectation(text: str) -> tuple[str, Expectation]:
    """A measure and its limit, from `MEASURE>=N` or `MEASURE<=N`."""
    from gcs.campaign import measures
    from gcs.campaign.model import Expectation as Limit
    from gcs.scenario.document import did_you_mean

    name, sign, number = (part.strip() for part in re.fullmatch(r"([^<>=]*)([<>]=|)(.*)", text).groups())  # type: ignore[union-attr]
    try:
        limit = float(number)
    except ValueError:
        sign = ""
    if not sign:
        raise click.UsageError(f"--expect {text}: write MEASURE>=N or MEASURE<=N")
    if not measures.exists(name):
        raise click.UsageError(f"--expect: there is no measure {name!r}{did_you_mean(name, measures.NAMES)}")
    return name, Limit(at_least=limit) if sign == ">=" else Limit(at_most=limit)


def _planned(file: str, sessions: int | None, seed: int | None, *, trust: bool) -> Plan:
    """The plan of a campaign's file or name, its first sessions checked."""
    from gcs.campaign import file as files
    from gcs.campaign.plan import make
    from gcs.scenario.model import ScenarioError

    try:
        path = files.find(file)
        loaded = files.load(path)
        changes: dict[str, Any] = {} if sessions is None else {"sessions": sessions}
        changes |= {} if seed is None else {"seed": seed}
        return _allowed(file, make(loaded.model_copy(update=changes), [path.parent]), trust=trust)
    except ScenarioError as error:
        raise Refused(str(error)) from None


def _allowed(name: str, plan: Plan, *, trust: bool) -> Plan:
    """The plan, its first sessions checked, once it may use what it names. Raises ScenarioError, Refused."""
    from gcs.campaign.plan import NotAllowed

    try:
        plan.check()
    except NotAllowed as asks:
        allow(name, asks.named, plan.trusted_by, trust=trust)
        plan = replace(plan, trusted=True)
        plan.check()
    return plan


def _found(folder: Path, *, trust: bool | None = None) -> Plan:
    """The plan in a campaign's folder, broken parts of its table named; with `trust`, once it may use what it names."""
    from gcs.campaign import table
    from gcs.campaign.plan import read
    from gcs.scenario.model import ScenarioError

    try:
        plan = read(folder)
        for path in table.broken(folder, plan.campaign):
            why = f"no rows can be read from it; gcs campaign resume {folder} sets it aside and flies them again"
            click.echo(f"gcs: {path}: {why}", err=True)
    except (OSError, ValueError, KeyError):
        raise Refused(f"{folder} holds no campaign: give the folder that gcs campaign run named") from None
    except ScenarioError as error:
        raise Refused(str(error)) from None
    try:
        return plan if trust is None else _allowed(str(folder), plan, trust=trust)
    except ScenarioError:  # its rows say why they cannot be flown
        return plan


def _fly(folder: Path, plan: Plan, *, scheduler: str | None, workers: int | None, plain: bool, quiet: bool) -> int:
    from gcs.campaign import statistics, table
    from gcs.campaign.engine import EngineError
    from gcs.campaign.runner import NEEDED, Runner
    from gcs.extras import require

    if scheduler is not None and workers is not None:
        raise click.UsageError("--scheduler and --workers exclude each other: its workers are those that it has.")
    require("a campaign", NEEDED, "campaign")
    shown = ProgressLine(folder, quiet=quiet, plain=plain or not sys.stdout.isatty())
    if not quiet:
        click.echo(f"{plan.campaign.name}: {plan.rows} sessions; the campaign's folder is {folder}")
    runner = Runner(folder, plan, scheduler=scheduler, workers=workers, notify=shown.update)
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
