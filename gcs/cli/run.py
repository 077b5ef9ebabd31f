"""`gcs run`: a scenario flown, shown in the terminal or the browser, and kept."""

# ruff: noqa: PLC0415 - so that help and a mistyped option answer at once

from __future__ import annotations

import contextlib
import json
import os
import threading
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli import author, page, report
from gcs.cli.author import ScenarioName, ScenarioRefused, load_scenario, module_arguments, show_warnings
from gcs.cli.options import ONE_STDOUT, PLAIN, key_file_option, limits, out_option, speed_option
from gcs.cli.trust import TRUST
from skytender.exit import BAD_INPUT, DONE, INTERRUPTED, NOT_DONE
from skytender.loading import uncollected

if TYPE_CHECKING:
    from gcs.scenario.model import Scenario
    from gcs.session.plain_text import View


@click.command(short_help="Fly a scenario and watch it.")
@click.argument("scenario", type=ScenarioName())
@click.option("--lockstep", is_flag=True, help="As fast as the machine can; the result does not depend on its load.")
@speed_option("Session seconds per second on the wall, above 0 and up to 1000.")
@click.option(
    "--seed",
    type=int,
    callback=limits("a whole number from 0 to 2^63 - 1", lambda seed: 0 <= seed < 1 << 63),
    metavar="N",
    help="Of everything random, instead of the scenario's.",
)
@author.SET
@author.STRICT
@TRUST
@out_option("The session's folder, which must not exist yet.  [default: sessions/NAME-TIME]")
@key_file_option(
    "MAVLink 2 signing: the key of all external vehicles, instead of what the scenario says (gcs key new)."
)
@click.option(
    "--forward",
    "forwards",
    multiple=True,
    metavar="ADDRESS",
    help="Everything that vehicles say also goes there, such as udpout:127.0.0.1:14550 for QGroundControl; repeatable.",
)
@click.option(
    "--forward-control",
    is_flag=True,
    help="Allow control from these stations: a vehicle that one of them commands is theirs until it rejoins.",
)
@click.option(
    "--logs",
    is_flag=True,
    help="After the flight download each external vehicle's newest log into the session's folder.",
)
@PLAIN
@click.option("--json", "as_json", is_flag=True, help="One JSON object per second on stdout, for other programs.")
@page.WEB
@page.TILES
@click.option(
    "--vehicles-per-process",
    type=int,
    callback=limits("a number from 1 to 254", lambda number: 1 <= number <= 254),
    metavar="K",
    help="Fly up to K vehicles in each process, instead of the scenario's number: lighter and faster, and the same to "
    "the last bit.",
)
@click.option(
    "--drop-datagrams",
    type=float,
    callback=limits("a share from 0 to 0.9", lambda share: 0.0 <= share <= 0.9),
    default=0.0,
    metavar="SHARE",
    help="For tests: drop this share (0 to 0.9) of the supervised link's datagrams, both ways; they are sent again and "
    "the flight must not change.",
)
@click.option(
    "--junit",
    type=click.Path(dir_okay=False, writable=True, path_type=Path),
    metavar="FILE",
    help="Write the outcome as JUnit XML, a test case for each part of the goal.",
)
@click.option("--no-report", is_flag=True, help="Leave out report.html; gcs report makes it later.")
@click.option("--verbose", "-v", is_flag=True, help="Lines of text, with every vehicle's state.")
@click.option(
    "--quiet",
    "-q",
    is_flag=True,
    help="Say only what went wrong, at the end, on stderr; the exit status tells the rest.",
)
def run(
    scenario: str,
    lockstep: bool,
    speed: float | None,
    seed: int | None,
    settings: tuple[str, ...],
    strict: bool,
    trust: bool,
    out: Path | None,
    key_file: Path | None,
    forwards: tuple[str, ...],
    forward_control: bool,
    logs: bool,
    plain: bool,
    as_json: bool,
    web: bool,
    tiles: str | None,
    vehicles_per_process: int | None,
    drop_datagrams: float,
    junit: Path | None,
    no_report: bool,
    verbose: bool,
    quiet: bool,
) -> int:
    """Fly SCENARIO: start its vehicles, command them over MAVLink, and keep a record of everything.

    In a terminal a console shows fleet, map, competition and events, and takes an operator's commands; `?` there
    explains it. Closing it (q) or losing it leaves the session flying, reported in lines; `gcs monitor` opens it again.
    Ctrl-C stops the session and saves it (the console asks first), then makes the report; a second Ctrl-C waits for
    neither.

    With --web the session is a page in the browser instead, in space and on a map, with the same commands; the terminal
    tells it in lines. Where the page was opened it stays after the session's end, with the report, until Ctrl-C.

    \b
    Examples:
      gcs run demo
      gcs run demo --web
      gcs run demo --speed 2 --out first-flight
      gcs run my-scenario.yaml --lockstep --seed 7 --plain
      gcs run demo --forward udpout:127.0.0.1:14550
      gcs run demo --set planner.cruise_m_s=2 --set 'vehicles.pursuers.*.battery.initial_percent=60'

    Code, programs, key files, devices and addresses beyond this machine that SCENARIO names are listed, and asked for
    once; without a terminal to ask at, --trust lets it use them.

    The session's folder holds the resolved scenario (scenario.yaml), every MAVLink frame (session.tlog), every decision
    with its reasons (decisions.jsonl), what was said here (session.log), the vehicles' logs (vehicles/), the result
    (summary.json) and a page that shows it all (report.html).

    \b
    Exit status:
      0    the scenario's goal was met
      1    it was not met, or the session broke off
      2    bad input, or nowhere to write; nothing has flown
      130  stopped by Ctrl-C (143 by SIGTERM); what was flown is saved
      70   an error of the program itself
    """
    if lockstep and speed is not None:
        raise click.UsageError("--lockstep and --speed exclude each other: lockstep is as fast as the machine can.")
    if plain and as_json:
        raise click.UsageError(ONE_STDOUT)
    page.refuse_tiles(tiles, web=web)
    if quiet and (verbose or as_json or plain or web):
        raise click.UsageError("--quiet excludes --verbose, --plain, --json and --web.")
    if verbose and as_json:
        raise click.UsageError("--verbose and --json exclude each other: choose what goes to stdout.")
    if junit is not None and not junit.parent.is_dir():
        raise click.UsageError(f"--junit: there is no folder {junit.parent}.")
    if junit is not None:
        session = (out or Path("sessions", "NAME-TIME")).resolve()
        if junit.resolve() in (session, *session.parents):
            raise click.UsageError(f"--junit: {junit} will be a folder, as the session's folder is there; name a file.")
    from gcs.processes.fork_server import early
    from gcs.processes.forked import can_fork
    from skytender.processes import printable

    lines = plain or as_json or quiet or verbose or web or not os.isatty(1)  # else its errors are the console's
    server = click.get_current_context().with_resource(early(lines and can_fork()))
    with uncollected():
        from gcs.scenario.plugins import named
        from gcs.session.plain_text import logged, mute
        from gcs.session.supervised import SupervisorFork, new_folder, write_scenario
        from gcs.session.supervised import run as fly

    try:
        key_path = None if key_file is None else str(key_file.resolve())
        resolved = load_scenario(scenario, settings, trust=trust, quiet=quiet).flown(
            lockstep=lockstep,
            speed=speed,
            seed=seed,
            key_file=key_path,
            forward=forwards,
            forward_control=forward_control,
            logs=logs,
        )
        if strict:
            show_warnings(scenario, resolved, strict=True)
    except ScenarioRefused as refusal:
        if junit is not None:
            from gcs.report.junit import refused

            _write_junit(junit, refused(scenario, refusal.text))
        raise
    except ValueError as refusal:
        raise click.UsageError(f"{refusal}.") from None
    if forward_control and not resolved.forward.to:
        raise click.UsageError("--forward-control needs --forward: there is no station to forward to.")
    if vehicles_per_process is not None:
        resolved = resolved.model_copy(update={"vehicles_per_process": vehicles_per_process})
    if resolved.vehicles.external:
        _try_keys(resolved)
    with contextlib.ExitStack() as stack:
        folder = stack.enter_context(new_folder(out, resolved.name))
        by_chance = resolved.radio.random or resolved.random_weather or any(fault.random for fault in resolved.faults)
        if seed is not None and not quiet and not (by_chance or any(named(resolved))):
            why = "without loss and the like in radio: and faults:, turbulence and sensors nothing here is random"
            click.echo(f"gcs: --seed changes nothing: {why}", err=True)
        if not quiet:
            try:
                click.echo(f"{resolved.name}: starting; the session's folder is {folder}", err=as_json)
            except OSError:
                mute(1)
        shown, said = _view(folder, resolved.name, plain or web, as_json, verbose=verbose, quiet=quiet)
        arguments = ["--drop-datagrams", str(drop_datagrams), *module_arguments(scenario)]
        fork = None
        own = bool(resolved.vehicles.launched or resolved.traffic)
        forks = can_fork() and not any(named(resolved))
        if server is not None and not (own and forks):
            server.discard()
            server = None
        if forks:
            fork = SupervisorFork(folder, resolved, drop_datagrams, server)
        else:
            write_scenario(folder, resolved)
        if not (strict or quiet):
            show_warnings(scenario, resolved, starts=True)  # while the supervisor starts

        error: str | None = None
        hurry = threading.Event()

        def begun() -> None:
            if fork is not None:
                write_scenario(folder, resolved)

        def finish(verdict: dict[str, Any]) -> None:
            nonlocal error
            error = verdict.get("error")
            if as_json:
                click.echo(json.dumps({"type": "end", **verdict, "session": printable(folder)}))

        view, echo = stack.enter_context(logged(shown, said, folder))

        def complain(line: str) -> None:
            if quiet:
                click.echo(line, err=True)

        shown_page = None
        if web:
            from gcs.web.process import page_server

            shown_page = stack.enter_context(page_server(folder, tiles))
            page.print_links(shown_page.links, err=as_json)
        stderr = getattr(shown, "stderr", None)
        status = fly(
            folder,
            view,
            echo,
            arguments=arguments,
            fork=fork,
            begun=begun,
            finish=finish,
            complain=complain,
            stderr=stderr,
            hurry=hurry.set,
        )
        if resolved.logs and status != BAD_INPUT and not hurry.is_set():
            from gcs.session.fetched_logs import fetch_logs

            for problem in fetch_logs(resolved, folder, echo):
                echo(f"gcs: {problem}")
                complain(f"gcs: {problem}")
        if junit is not None:
            from gcs.report.junit import flown

            if not _write_junit(junit, flown(folder, resolved, error)):
                status = status or NOT_DONE
        if not no_report:
            report.after_run(folder, echo, status, hurried=hurry.is_set(), last=shown_page is None)
        if shown_page is not None and status in (DONE, NOT_DONE, INTERRUPTED) and not hurry.is_set():
            what = "the page stays, with the report" if (folder / report.FILE).is_file() else "the page stays"
            shown_page.stay(lambda: click.echo(f"gcs: {what}; Ctrl-C ends it", err=True))
    return status


def _try_keys(scenario: Scenario) -> None:
    """Raise click.UsageError for a signing key that cannot be used, before anything is started."""
    from skytender.key_files import KeyRefused, read_key

    try:
        for block in scenario.vehicles.external.values():
            if block.signing is not None:
                read_key(Path(block.signing.key_file))
    except KeyRefused as error:
        raise click.UsageError(f"{error}.") from None


def _write_junit(path: Path, xml: str) -> bool:
    """Write the file for CI; whether that worked."""
    try:
        path.write_text(xml, encoding="utf-8")
    except OSError as problem:
        click.echo(f"gcs: {path} could not be written: {problem.strerror}", err=True)
        return False
    return True


def _view(
    folder: Path, name: str, plain: bool, as_json: bool, *, verbose: bool, quiet: bool
) -> tuple[View, Callable[[str], object]]:
    """View of the session, and the writer of its last lines."""
    from gcs.session.plain_text import JsonView, PlainView, VerboseView, View

    if quiet or verbose:
        return (View(), str) if quiet else (VerboseView(click.echo), click.echo)
    if as_json:
        return JsonView(click.echo), lambda line: click.echo(line, err=True)
    from gcs.console.terminal import ConsoleView, usable

    if plain or not usable():
        return PlainView(click.echo), click.echo
    return ConsoleView(folder, name, PlainView(click.echo), click.echo), click.echo
