"""`gcs replay`: a recorded session or any recording, played or decided again."""

# ruff: noqa: PLC0415 - so that `gcs --help` and a mistyped option answer at once

from __future__ import annotations

import contextlib
import json
import math
from pathlib import Path
from typing import TYPE_CHECKING

import click

from gcs.cli import page
from gcs.cli.options import PLAIN, limits, refuse_two_shows, speed_option
from gcs.cli.progress_bar import progress_bar
from gcs.cli.trust import TRUST, allow

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from gcs.scenario.plugins import PluginClient
    from gcs.supervisor.redecide import Comparison

AGREES, DIFFERS = 0, 1
SHOWN = 20
"""Kinds of decision and vehicles whose first difference is printed."""


@click.command(short_help="Play a recorded session, or any recording, in the console.")
@click.argument("session", type=click.Path(path_type=Path))
@click.argument("others", nargs=-1, type=click.Path(path_type=Path))
@speed_option("Recorded seconds per second on the wall, up to 1000.  [default: 1; as lines or JSON: without waiting]")
@click.option(
    "--from",
    "from_s",
    type=float,
    callback=limits("a time in seconds", math.isfinite),
    metavar="T",
    help="Begin T seconds into the recording.",
)
@PLAIN
@click.option("--json", "as_json", is_flag=True, help="One JSON object per recorded second on stdout.")
@page.WEB
@page.TILES
@page.FOXGLOVE
@click.option(
    "--plan",
    "plan_files",
    multiple=True,
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Show a mission, geofence and rally points with it: QGroundControl's .plan, or QGC WPL 110. Repeatable.",
)
@click.option("--decide", is_flag=True, help="Decide everything again, and list where the decisions differ.")
@TRUST
def replay(
    session: Path,
    others: tuple[Path, ...],
    speed: float | None,
    from_s: float | None,
    plain: bool,
    as_json: bool,
    web: bool,
    tiles: str | None,
    foxglove: bool,
    plan_files: tuple[Path, ...],
    decide: bool,
    trust: bool,
) -> int:
    """Play SESSION, a session's folder or any recording, also another ground station's, in the console.

    In the console you pause, change the speed and go to any time. A session's folder shows its obstacles, competition
    and services too. A .tlog shows every vehicle that sends a HEARTBEAT in it, PX4, ArduPilot or others.

    OTHERS are recordings or sessions' folders beside it, on one time: by their dates where all know theirs and begin
    within a day, else all begin together. A system id that an earlier one has is the next free one. Of folders beside
    each other the frames alone are shown.

    Missions, geofences and rally points that went between ground stations and vehicles are shown from then on, those of
    a .BIN as it logs them; --plan adds some from files. `gcs mission show` lists them.

    --decide plays nothing: planner and scheduler run again over the recorded telemetry, and each decision that they
    would make today is held against the recorded one, to the last digit. Use it to see what a change of the code, or
    of the scenario.yaml in the folder, does to a session that has been flown. A planner or policy that the scenario
    names is code, found in the current folder or in the session's: you are asked once before it runs.

    \b
    Examples:
      gcs replay sessions/demo-20260101-120000
      gcs replay flight.tlog --speed 4 --from 120
      gcs replay first-flight --web
      gcs replay first-flight --foxglove
      gcs replay flight.tlog --json > flight.jsonl
      gcs replay one.BIN two.BIN three.ulg --web
      gcs replay first-flight second-flight --web
      gcs replay flight.tlog --plan survey.plan --web
      gcs replay first-flight --decide

    \b
    Exit status:
      0    closed or played to its end; with --decide: all decisions agree
      1    with --decide: some differ
      2    bad input
      130  stopped by Ctrl-C
      70   an error of the program itself
    """
    refuse_two_shows(plain=plain, as_json=as_json, web=web, foxglove=foxglove, tiles=tiles)
    if decide:
        if speed is not None or from_s is not None or web or foxglove or plan_files:
            raise click.UsageError("--decide plays nothing: leave out --speed, --from, --web, --foxglove and --plan.")
        if others:
            raise click.UsageError("--decide decides one session: give no other beside it.")
        return _decide(session, as_json, trust=trust)
    from gcs.console.follow import ReplayPace, Steps, follow
    from gcs.console.terminal import usable
    from gcs.missions.errors import MissionFileError
    from gcs.missions.files import load as load_plan
    from gcs.recording.importing import ImportFailed, beside
    from gcs.session.replay import Replay, ReplayError, ReplaySource

    try:
        plans = {str(path): load_plan(path) for path in plan_files}
        opened = click.get_current_context().with_resource(beside([session, *others]))
        with progress_bar("reading") as progress:
            recording = Replay(opened.path, progress, plans=plans)
        recording.problems[:0] = opened.problems
    except (ReplayError, ImportFailed, MissionFileError) as error:
        raise click.UsageError(str(error)) from None
    except OSError as error:
        raise click.UsageError(f"{error.filename or session}: {error.strerror}.") from None
    for problem in recording.problems if as_json else ():  # else it is the recording's first event
        click.echo(f"gcs: {problem}", err=True)
    in_console = not (plain or as_json) and usable()
    if from_s is not None:
        if not recording.from_s <= from_s <= recording.to_s:
            raise click.UsageError(f"--from: the recording goes from {recording.from_s:g} to {recording.to_s:g} s.")
        looked_at = web or in_console
        recording.seek(
            from_s, reported_s=-math.inf if looked_at else math.inf
        )  # viewers that scroll back find the past
    if not (web or foxglove or in_console):  # what is written is the same at each speed
        steps = Steps()
        wait = (lambda _: None) if speed is None else ReplayPace(recording.t_s, speed)
        source = ReplaySource(recording, speed=None, clock=steps, patience_s=math.inf, reached=wait)
        follow(source, click.echo, as_json=as_json, clock=steps, wait=steps.go_on, over=lambda: recording.ended)
        return 0
    source = ReplaySource(recording, speed=speed or 1.0)
    if web:
        page.show(source, commands=False, tiles=tiles)
    elif foxglove:
        page.show_in_foxglove(source)
    else:
        from gcs.console.app import show

        return show(source, recording.name)
    return 0


def _decide(session: Path, as_json: bool, *, trust: bool) -> int:
    from gcs.processes.plugin_process import started
    from gcs.processes.python import current_folders
    from gcs.recording.missing import SCENARIO
    from gcs.scenario.file import load
    from gcs.scenario.model import ScenarioError
    from gcs.scenario.parts.reach import reached
    from gcs.scenario.parts.trust import digest_of
    from gcs.supervisor.redecide import RedecideError, redecide

    if not session.exists():
        raise click.UsageError(f"--decide: {session} does not exist.")
    if not session.is_dir():
        raise click.UsageError(f"--decide: {session} is no session's folder: a .tlog alone holds no decisions.")
    try:
        file = session / SCENARIO
        scenario = load(file) if file.exists() else None
        plugins: AbstractContextManager[PluginClient | None] = contextlib.nullcontext()
        if scenario is not None and (code := [one for one in reached(scenario) if one.reach == "code"]):
            allow(str(file), code, digest_of(file), trust=trust)
            plugins = started(scenario, [*map(str, current_folders()), str(session)], None)
        with progress_bar("deciding") as progress, plugins as process:
            verdict = redecide(session, progress, process)
    except RedecideError as error:
        raise click.UsageError(str(error)) from None
    except ScenarioError as error:
        raise click.UsageError(f"the scenario cannot be used: {error}") from None
    except OSError as error:
        raise click.UsageError(f"{error.filename or session}: {error.strerror}.") from None
    for problem in verdict.problems:
        click.echo(f"gcs: {problem}", err=True)
    if verdict.objects:
        click.echo(f"gcs: {verdict.objects}", err=True)
    if verdict.acts:
        click.echo(f"gcs: {_acts_text(verdict)}", err=True)
    if not verdict.compared:
        raise click.UsageError(f"{session} holds no decision to compare: was it killed before the first was written?")
    (_print_json if as_json else _print_verdict)(verdict)
    return AGREES if verdict.agrees else DIFFERS


def _acts_text(verdict: Comparison) -> str:
    """A sentence about what a program did."""
    acts = verdict.acts
    did = [
        f"{acts[act]} {name}{'s' if acts[act] > 1 else ''}{more}"
        for act, name, more in (
            ("steered", "tick", " with set points"),
            ("command", "command", ""),
            ("inject", "fault", ""),
            ("world", "change", " of the world"),
        )
        if acts[act]
    ]
    return f"a program in Python acted in this session ({', '.join(did)}): its acts are taken from the recording."


def _print_verdict(verdict: Comparison) -> None:
    if verdict.agrees:
        click.echo(f"all {verdict.compared} decisions up to {verdict.until_s:.1f} s agree")
        return
    kinds = ", ".join(f"{count} {kind}" for kind, count in verdict.by_kind.most_common())
    total = sum(verdict.by_kind.values())
    click.echo(f"{total} differences in {verdict.compared} recorded decisions up to {verdict.until_s:.1f} s: {kinds}")
    click.echo(f"first: {verdict.differences[0].sentence}")
    subjects = list(verdict.subjects.values())
    for about in subjects[:SHOWN]:
        again = f" ({about.count} times, the last at {about.last_s:.1f} s)" if about.count > 1 else ""
        click.echo(f"  {about.first.sentence}{again}")
    if len(subjects) > SHOWN:
        click.echo(f"  and of {len(subjects) - SHOWN} more kinds or vehicles; --json tells each")


def _print_json(verdict: Comparison) -> None:
    for difference in verdict.differences:
        click.echo(json.dumps(difference.record()))
    click.echo(
        json.dumps(
            {
                "type": "verdict",
                "agrees": verdict.agrees,
                "compared": verdict.compared,
                "until_s": verdict.until_s,
                "differences": dict(verdict.by_kind),
            }
        )
    )
