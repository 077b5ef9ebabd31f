"""`gcs init`, `validate`, `schema` and `doctor`: for authors of scenarios, before anything flies."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import json
import re
import shlex
import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.options import STATION_OPTION, connect_option
from gcs.cli.trust import TRUST
from gcs.processes.python import current_folders
from skytender.exit import BAD_INPUT, NOT_DONE
from skytender.loading import uncollected

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from gcs.scenario.endpoint import Endpoint
    from gcs.scenario.model import Scenario
    from gcs.scenario.parts.reach import Reached


class ScenarioName(click.ParamType[str]):
    """A scenario's file or shipped name; a shell completes both."""

    name = "scenario"

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        from click.shell_completion import CompletionItem

        from gcs.scenario.file import shipped_names

        shipped = [CompletionItem(name) for name in shipped_names() if name.startswith(incomplete)]
        return [*shipped, CompletionItem(incomplete, type="file")]


class ScenarioRefused(click.exceptions.Exit):
    """A scenario that cannot be flown: ends the program once its mistakes, `text`, are printed."""

    def __init__(self, text: str) -> None:
        super().__init__(BAD_INPUT)
        self.text = text


SET = click.option(
    "--set",
    "settings",
    multiple=True,
    metavar="KEY=VALUE",
    help="Set a key of the scenario, such as planner.cruise_m_s=2 or vehicles.pursuers.*.battery.initial_percent=60; "
    "null takes it out. Repeatable.",
)


STRICT = click.option("--strict", is_flag=True, help="Refuse a scenario of which anything is warned.")


def show_warnings(scenario: str, checked: Scenario, *, strict: bool = False, starts: bool = False) -> list[str]:
    """Print a scenario's warnings to stderr, and return them. With `strict` they are errors: raises ScenarioRefused if
    there are any. Where the session `starts`, it says plan B's warnings itself, and they are left out here."""
    from gcs.scenario.warnings import warnings

    found = warnings(checked)
    if not starts:
        from gcs.planner.returns.warnings import warnings as return_warnings

        found += return_warnings(checked)
    level = "error" if strict else "warning"
    lines = [f"{scenario}: {level}: {warning.about}: {warning.text}" for warning in found]
    if not lines:
        return []
    click.echo("\n".join(lines), err=True)
    if strict:
        raise ScenarioRefused("\n".join(lines))
    return lines


@uncollected()
def load_scenario(
    scenario: str, settings: Sequence[str] = (), *, trust: bool | None = None, plans: bool = True, quiet: bool = True
) -> Scenario:
    """The scenario of that name or file, with `KEY=VALUE` settings.

    trust: whether what it names beyond the session may be used, which is asked for where it is False
    (gcs/cli/trust.py); None: nothing of it is used. plans: whether code that it names is then imported to see that it
    is there. quiet: do not list what it names.
    Raises ScenarioRefused, once what is wrong has gone to stderr line by line; Refused where it may not be used.
    """
    from gcs.cli.trust import allow
    from gcs.scenario import plugins
    from gcs.scenario.file import find, load
    from gcs.scenario.keys import read_settings
    from gcs.scenario.model import ScenarioError
    from gcs.scenario.parts.trust import digest_of, text
    from gcs.scenario.pydantic_plugins import without_plugins

    try:
        file = find(scenario)
        given = read_settings(settings)
        with without_plugins():
            loaded = load(file, set=given)
        folders = [file.parent, *current_folders()]
        named = named_by_file(loaded, file, given)
        if named and trust is not None:
            allow(scenario, named, digest_of(file), trust=trust)
        if plans and trust is None:
            plugins.check_sources(loaded, file, folders)
        elif plans and any(plugins.named(loaded)):
            from gcs.processes import plugin_process

            plugin_process.check(loaded, file, folders)
        if named and not quiet:
            click.echo(f"gcs: {scenario} names {text(named)}", err=True)
        return loaded
    except ScenarioError as error:
        nowhere = all(problem.line is None for problem in error.problems)
        click.echo(f"gcs: {error}" if nowhere else str(error), err=True)  # else FILE:LINE:COLUMN, for editors
        raise ScenarioRefused(str(error)) from None


def named_by_file(scenario: Scenario, file: Path, given: Mapping[str, Any]) -> list[Reached]:
    """Things that a scenario names beyond its session, but for what the caller has set. Raises ScenarioError."""
    from gcs.scenario.file import load
    from gcs.scenario.parts.reach import reached

    named = reached(scenario)
    if not named or not given:
        return named
    own = {(one.reach, one.value) for one in reached(load(file))}
    return [one for one in named if (one.reach, one.value) in own]


def module_arguments(scenario: str) -> list[str]:
    """The supervisor's arguments that let it find planners and policies where `load_scenario` did."""
    from gcs.scenario.file import find

    folders = find(scenario).parent, *current_folders()
    return [word for folder in folders for word in ("--modules", str(folder.resolve()))]


@click.command(short_help="Check a scenario and draw its plan.")
@click.argument("scenario", type=ScenarioName())
@click.option(
    "--image",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Draw the plan to this file instead of the terminal: .png, .svg or .pdf.",
)
@SET
@STRICT
@TRUST
@click.option("--quiet", "-q", is_flag=True, help="Only say what is wrong.")
@click.option("--json", "as_json", is_flag=True, help="One JSON object on stdout: valid, problems, warnings, facts.")
def validate(
    scenario: str, image: Path | None, settings: tuple[str, ...], strict: bool, trust: bool, quiet: bool, as_json: bool
) -> int:
    """Check SCENARIO and draw what it says: vehicles, targets' paths, obstacles and ranges, seen from above.

    Every mistake is a line with file, line and column. What can be flown and is likely to break the goal is a warning
    on stderr: speed, latency and braking against ranges and separation, places and ways up in obstacles, heights of
    returns without the station, and figures that look like slips; --strict makes them errors.

    Code, programs, key files, devices and addresses beyond this machine that the scenario names are listed on stderr,
    and not used: gcs run asks for them. The source of code is looked for and read; with --trust it is imported, too.

    \b
    Examples:
      gcs validate my-scenario.yaml
      gcs validate demo --image plan.svg
      gcs validate demo --json | jq .warnings

    \b
    Exit status:
      0    the scenario can be flown, also with warnings
      1    the image could not be written
      2    it cannot be flown, or with --strict is warned of; each reason is a line on stderr
    """
    from gcs.planner import failsafes
    from gcs.scenario import plot

    warned: list[str] = []
    try:
        checked = load_scenario(scenario, settings, trust=True if trust else None, quiet=False)
        warned = show_warnings(scenario, checked, strict=strict)
    except ScenarioRefused as refused:
        if as_json:
            problems = refused.text.splitlines()
            found = {"scenario": scenario, "valid": False, "problems": problems, "warnings": [], "facts": []}
            click.echo(json.dumps(found))
        raise
    if image is not None:
        try:
            plot.image(checked, image)
        except (OSError, ValueError) as error:
            why = error.strerror if isinstance(error, OSError) else str(error)
            click.echo(f"{image}: the plan cannot be drawn there: {why}", err=True)
            return NOT_DONE
    facts = [*plot.facts(checked), *failsafes.facts(checked)]
    if as_json:
        found = {"scenario": scenario, "valid": True, "problems": [], "warnings": warned, "facts": facts}
        click.echo(json.dumps(found))
        return 0
    if quiet:
        return 0
    if image is None:
        lines = plot.text(checked, min(shutil.get_terminal_size().columns, 100) - 1)
        for line in lines:
            click.echo(line)
        click.echo(plot.legend("".join(lines[:-1])))
        click.echo()
    for line in facts:
        click.echo(line)
    click.echo(f"{scenario}: valid" + ("" if image is None else f"; its plan is {image}"))
    return 0


@click.command(short_help="Print the JSON Schema of a scenario, for editors.")
def schema() -> int:
    """Print the JSON Schema of scenario files.

    With it an editor completes keys, shows what they mean and underlines mistakes. For one with a YAML language server
    (VS Code's YAML extension, Neovim, Emacs, JetBrains) begin the scenario with the line below.

    \b
    Examples:
      gcs schema > scenario.schema.json
      # yaml-language-server: $schema=scenario.schema.json
    """
    from gcs.scenario.json_schema import editor_schema

    click.echo(json.dumps(editor_schema(), indent=2))
    return 0


@click.command(short_help="Write a scenario to start from.")
@click.argument("name", default="my-scenario")
@connect_option(
    "Make it of the vehicles heard there: their ids, home and battery. udpin, udpout, tcp, tcpin:HOST:PORT, or "
    "serial:DEVICE:BAUD."
)
@STATION_OPTION
@click.pass_context
def init(context: click.Context, name: str, connect: Endpoint | None, station: tuple[int, int]) -> int:
    """Write NAME.yaml: a small scenario that flies, with a comment on each key. NAME is my-scenario if left out.

    \b
    Examples:
      gcs init
      gcs init experiments/first.yaml
      gcs init field --connect udpin:0.0.0.0:14550

    \b
    Exit status:
      0    the file was written
      2    it exists already, or could not be written; or no vehicle was received
    """
    from importlib import resources

    path = Path(name if name.endswith((".yaml", ".yml")) else f"{name}.yaml")
    called = re.sub(r"[^A-Za-z0-9._-]+", "-", path.stem).lstrip("._-")[:64] or "my-scenario"
    text = resources.files("gcs").joinpath("templates", "scenario.yaml").read_text(encoding="utf-8")
    if connect is None and context.get_parameter_source("station") is click.core.ParameterSource.COMMANDLINE:
        raise click.UsageError("--station is for --connect: by it vehicles are asked; in a scenario it is a key.")
    if connect is not None:
        from gcs.cli.init_connect import scenario

        if path.exists():
            raise click.UsageError(f"{path} exists already and is left as it is; give another name")
        text = scenario(connect, _yaml_text(called), station)
    for mark, value in (("{file}", " ".join(str(path).split())), ("{name}", _yaml_text(called))):
        text = text.replace(mark, value)
    try:
        with path.open("x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:
        raise click.UsageError(f"{path} exists already and is left as it is; give another name") from None
    except (OSError, ValueError) as error:
        why = error.strerror if isinstance(error, OSError) else error
        raise click.UsageError(f"cannot write {path}: {why}; give a name in a folder that exists") from None
    word = shlex.quote(str(path))
    click.echo(f"{path}: written. Next: gcs validate {word}, then gcs run {word}")
    return 0


def _yaml_text(word: str) -> str:
    """A word that YAML would read as a number or truth value gets quotes."""
    return word if re.fullmatch(r"[A-Za-z][A-Za-z0-9_-]*", word) and word.lower() not in _WORDS else f'"{word}"'


_WORDS = {"true", "false", "null", "yes", "no", "on", "off"}


@click.command(short_help="Look for what keeps sessions from running here.")
@click.option("--json", "as_json", is_flag=True, help="One JSON object per finding.")
def doctor(as_json: bool) -> int:
    """Check this machine: Python, versions, sockets, receive buffers, ports, folder, terminal.

    Each finding that is not fine says what to do about it. Real autopilots are looked for where SKYTENDER_ARDUCOPTER
    and SKYTENDER_PX4 name them, then on PATH, then where their builds leave them.

    \b
    Exit status:
      0    sessions run here, perhaps less well than they could (notes)
      1    they do not (problems)
    """
    from dataclasses import asdict

    from gcs.cli.doctor import examine

    worst: dict[str, Any] = dict.fromkeys(("note", "problem"), 0)
    for finding in examine():
        if finding.level in worst:
            worst[finding.level] += 1
        if as_json:
            click.echo(json.dumps(asdict(finding)))
            continue
        click.echo(f"{finding.level:<8} {finding.what}: {finding.found}")
        if finding.advice:
            click.echo(f"{'':<8} -> {finding.advice}")
    if not as_json:
        click.echo(", ".join(f"{number} {level}{'s' * (number != 1)}" for level, number in reversed(worst.items())))
    return NOT_DONE if worst["problem"] else 0
