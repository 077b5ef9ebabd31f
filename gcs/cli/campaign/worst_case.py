"""`gcs campaign search` and `shrink`: the worst session of a campaign, and a failing scenario made small."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import math
import re
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.author import SET, load_scenario
from gcs.cli.campaign.options import OUT, QUIET, SEED, flown, planned
from gcs.cli.campaign.progress_line import ProgressLine
from gcs.cli.options import Refused
from gcs.cli.trust import TRUST
from skytender.exit import DONE, NOT_DONE

if TYPE_CHECKING:
    from gcs.campaign.engine import Progress
    from gcs.campaign.model import Expectation
    from gcs.campaign.plan import Plan


@click.command(short_help="Look for the worst case.")
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
    from gcs.campaign.cluster import EngineError
    from gcs.campaign.model import SearchRules
    from gcs.campaign.runner import make_folder

    plan = planned(file, None, seed, trust=trust)
    rules = plan.campaign.search
    if rules is None:
        raise Refused(f"{file} says nothing of a search: add 'search: {{minimise: min_separation_m, trials: 200}}'")
    if trials is not None:
        rules = SearchRules.model_validate({**rules.model_dump(), "trials": trials})
    each = {key: draw.model_copy(update={"together": True}) for key, draw in plan.campaign.draw.items()}
    changed = {"search": rules, "vary": {}, "keep": "none", "sessions": rules.trials, "draw": each}
    changed["set"] = {**plan.campaign.set, **{k: v for k, v in plan.row(0).values.items() if k in plan.campaign.vary}}
    plan = replace(plan, campaign=plan.campaign.model_copy(update=changed), is_search=True)
    try:
        folder = make_folder(plan, out)
    except EngineError as error:
        raise Refused(str(error)) from None
    return fly_search(folder, plan, scheduler=scheduler, workers=workers, plain=plain, quiet=quiet)


def fly_search(
    folder: Path, plan: Plan, *, scheduler: str | None, workers: int | None, plain: bool, quiet: bool
) -> int:
    """Fly what the search in a folder lacks, and write its worst case; the exit status."""
    from gcs.campaign import table
    from gcs.campaign.cluster import EngineError
    from gcs.campaign.runner import Runner
    from gcs.campaign.search import Search
    from gcs.extras import require
    from gcs.scenario.file import dump

    rules = plan.campaign.search
    assert rules is not None
    require("a search", {"optuna": "Optuna"}, "campaign")
    searched = Search(plan, folder)
    shown = ProgressLine(folder, quiet=quiet, plain=plain or not sys.stdout.isatty())

    def notify(progress: Progress, row: dict[str, Any] | None) -> None:
        if row is not None:
            searched.add(row)
        shown.update(progress, None)

    try:
        runner = Runner(folder, plan, scheduler=scheduler, workers=workers, notify=notify, rows=searched.rows())
        progress = runner.run()
    except EngineError as error:
        shown.end()
        click.echo(f"gcs: {error}; what was flown is kept, gcs campaign resume {folder} goes on", err=True)
        return NOT_DONE
    shown.end()
    name = str(rules.minimise or rules.maximise)
    rows = [row for row in table.read(folder, plan.campaign).to_pylist() if row[name] is not None]
    if rows:
        worst = (min if rules.minimise else max)(rows, key=lambda row: (row[name], row["row"]))
        scenario, _ = plan.resolved(searched.row(int(worst["row"])))
        (folder / "worst.yaml").write_text(dump(scenario), encoding="utf-8")
        if not quiet:
            click.echo(f"{name} {worst[name]:.4g} in trial {worst['row']}: gcs run {folder / 'worst.yaml'} --lockstep")
    if runner.interrupted:
        click.echo(f"stopped; gcs campaign resume {folder} flies the other {rules.trials - progress.done}", err=True)
        return 128 + runner.interrupted
    if not rows:
        click.echo(f"gcs: no trial has a value of {name}: its scenario has nothing of that kind", err=True)
        return NOT_DONE
    return DONE if progress.done == rules.trials else NOT_DONE


@click.command(short_help="Make a failing scenario small.")
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
    from gcs.scenario.file import dump
    from gcs.session.spawning.spawner import SessionSpawner, SpawnError

    if out.exists():
        raise Refused(f"{out} exists already and is left as it is; give --out another file")
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

    name, sign, number = (part.strip() for part in re.fullmatch(r"([^<>=]*)([<>]=|)(.*)", text).groups())  # type: ignore[union-attr]
    try:
        limit = float(number)
    except ValueError:
        limit = math.nan
    if not sign or not math.isfinite(limit):
        raise click.UsageError(f"--expect {text}: write MEASURE>=N or MEASURE<=N")
    if fault := measures.fault(name, number=True):
        raise click.UsageError(f"--expect: {fault}")
    return name, Limit(at_least=limit) if sign == ">=" else Limit(at_most=limit)
