"""`gcs params`: parameters over a whole fleet: read, written and verified, compared, saved and loaded."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import contextlib
import fnmatch
import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.fleet_options import fleet_at, of_the_fleet
from gcs.cli.options import Refused
from gcs.exit import NOT_DONE

if TYPE_CHECKING:
    from gcs.link.asked_fleet import AskedFleet
    from gcs.mavlink.parameter_client import ParameterClient, ParameterResult

GLOB = frozenset("*?[")
LONGEST_NAME = 16
WELL = ("read", "kept", "would", "set")


@click.group(short_help="Read, write, compare, save and load parameters over a fleet.")
def params() -> None:
    """Parameters of every vehicle at an address at once, whatever its autopilot.

    What is written is read back, and counts only when it reads as it was written. Names may have * and ?, in quotes.

    \b
    Examples:
      gcs params get 'RTL_*' --connect udpin:127.0.0.1:14550
      gcs params set RTL_ALT=2000 WPNAV_SPEED=300 --dry-run
      gcs params diff
      gcs params save before.params
      gcs params load before.params --sysid 3

    \b
    Exit status:
      0    done; diff: all vehicles agree
      1    a parameter is unknown to a vehicle, was refused, or did not come; diff: they differ
      2    bad input, or no vehicle was heard
      130  stopped by Ctrl-C
    """


@params.command(short_help="Show parameters.")
@click.argument("patterns", nargs=-1, metavar="NAME...")
@of_the_fleet
def get(patterns: tuple[str, ...], as_json: bool, **options: Any) -> int:
    """Show the parameters named NAME..., or all, of every vehicle.

    \b
    Examples:
      gcs params get RTL_ALT 'WPNAV_*'
      gcs params get --sysid 3 --json > three.json
    """
    with fleet_at(**options) as fleet:
        clients = _read(fleet, patterns or ("*",))
    found = {client.sysid: _matching(client, patterns or ("*",)) for client in clients}
    if as_json:
        click.echo(json.dumps({"vehicles": dict(sorted(found.items()))}))
    else:
        for name in sorted({name for numbers in found.values() for name in numbers}):
            _say(name, {sysid: numbers.get(name) for sysid, numbers in sorted(found.items())})
    return _missing(clients)


@params.command("set", short_help="Write parameters, and read them back.")
@click.argument("settings", nargs=-1, required=True, metavar="NAME=VALUE...")
@click.option("--dry-run", is_flag=True, help="Only say what would change.")
@of_the_fleet
def set_(settings: tuple[str, ...], dry_run: bool, as_json: bool, **options: Any) -> int:
    """Give parameters a value on every vehicle, and verify it by reading it back.

    \b
    Examples:
      gcs params set RTL_ALT=2000 --dry-run
      gcs params set 'COM_*_ACT=0' --sysid 3
    """
    wanted = dict(_setting(text) for text in settings)
    with fleet_at(**options) as fleet:
        sysids = sorted(fleet.profiles)
        globs = [name for name in wanted if GLOB & set(name)]
        numbers = {sysid: {n: v for n, v in wanted.items() if n not in globs} for sysid in sysids}
        if globs:
            for client in _read(fleet, globs):
                for pattern in globs:
                    names = fnmatch.filter(client.known, pattern)
                    numbers[client.sysid] |= dict.fromkeys(names, wanted[pattern])
        if not any(numbers.values()):
            raise Refused(f"no vehicle has a parameter named {', '.join(globs)}")
        return _write(fleet, numbers, dry_run=dry_run, as_json=as_json)


@params.command(short_help="Compare vehicles with each other, or with a file.")
@click.argument("file", required=False, type=click.Path(path_type=Path, dir_okay=False, exists=True))
@of_the_fleet
def diff(file: Path | None, as_json: bool, **options: Any) -> int:
    """Show the parameters in which vehicles differ from each other, or from FILE where it is given.

    Only parameters that FILE holds are compared with it; those of a file of one vehicle count for all.
    """
    from gcs.mavlink.parameter_client import same

    saved = None if file is None else _load(file)
    with fleet_at(**options) as fleet:
        clients = _read(fleet, ("*",))
    rows: dict[str, dict[str, float | None]] = {}
    for name in sorted({name for client in clients for name in client.known}):
        for client in clients:
            mine = client.known.get(name)
            number = None if mine is None else mine.number
            if saved is None:
                rows.setdefault(name, {})[str(client.sysid)] = number
            elif (other := _of(saved, client.sysid).get(name)) is not None and (
                number is None or not same(number, other)
            ):
                rows.setdefault(name, {}).update({str(client.sysid): number, "file": other})
    if saved is None:
        rows = {name: row for name, row in rows.items() if not _agree(list(row.values()))}
    if as_json:
        click.echo(json.dumps({"differences": rows}))
    else:
        for name, row in rows.items():
            _say(name, row)
        if not rows:
            click.echo("no difference")
    return max(_missing(clients), NOT_DONE if rows else 0)


@params.command(short_help="Write the parameters of all vehicles to a file.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@click.argument("patterns", nargs=-1, metavar="[NAME...]")
@of_the_fleet
def save(file: Path, patterns: tuple[str, ...], as_json: bool, **options: Any) -> int:
    """Write all parameters, or those named NAME..., to FILE, which must not exist yet.

    A line holds vehicle, component, name, value and type, as QGroundControl writes and reads it.
    """
    if file.exists():
        raise Refused(f"{file} exists already and is left as it is; give another name")
    with fleet_at(**options) as fleet:
        clients = _read(fleet, patterns or ("*",))
    lines = ["# Vehicle-Id Component-Id Name Value Type"]
    for client in clients:
        for name in sorted(_matching(client, patterns or ("*",))):
            number, kind = client.known[name]
            lines.append(f"{client.sysid}\t{client.compid}\t{name}\t{_text(number)}\t{kind}")
    try:
        file.write_text("\n".join(lines) + "\n", encoding="ascii")
    except OSError as error:
        raise Refused(f"{file} cannot be written: {error.strerror}") from None
    count, vehicles = len(lines) - 1, len(clients)
    if as_json:
        click.echo(json.dumps({"file": str(file), "vehicles": vehicles, "parameters": count}))
    else:
        click.echo(f"{count} parameters of {vehicles} vehicle{'s' * (vehicles != 1)} are in {file}")
    return _missing(clients)


@params.command(short_help="Write a file's parameters to vehicles, and read them back.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False, exists=True))
@click.option("--dry-run", is_flag=True, help="Only say what would change.")
@of_the_fleet
def load(file: Path, dry_run: bool, as_json: bool, **options: Any) -> int:
    """Give vehicles the parameters of FILE, and verify them by reading them back.

    Each vehicle gets its own lines; a file of one vehicle, or without system ids (NAME VALUE, as MAVProxy writes it),
    counts for all. Those that have the value already are not written.
    """
    saved = _load(file)
    with fleet_at(**options) as fleet:
        numbers = {sysid: _of(saved, sysid) for sysid in sorted(fleet.profiles)}
        if not any(numbers.values()):
            raise Refused(f"{file} has no line for vehicle {', '.join(map(str, numbers))}")
        return _write(fleet, numbers, dry_run=dry_run, as_json=as_json)


def _read(fleet: AskedFleet, patterns: Sequence[str]) -> list[ParameterClient]:
    """Read from each vehicle what these patterns may name."""
    from gcs.mavlink.parameter_client import ParameterClient

    clients = [ParameterClient(sysid, 1, profile) for sysid, profile in sorted(fleet.profiles.items())]
    for client in clients:
        if any(GLOB & set(pattern) for pattern in patterns):
            client.read_all()
        else:
            client.read(dict.fromkeys(patterns))
    fleet.converse(clients)
    return clients


def _write(fleet: AskedFleet, numbers: dict[int, dict[str, float]], *, dry_run: bool, as_json: bool) -> int:
    from gcs.mavlink.parameter_client import ParameterClient

    clients = []
    for sysid, wanted in numbers.items():
        client = ParameterClient(sysid, 1, fleet.profiles[sysid], dry_run=dry_run)
        client.write(wanted)
        clients.append(client)
    fleet.converse(clients)
    results = [(client.sysid, result) for client in clients for result in client.results]
    if as_json:
        rows = [{"sysid": sysid, **result._asdict()} for sysid, result in results]
        click.echo(json.dumps({"dry_run": dry_run, "results": rows}))
    else:
        for sysid, result in results:
            click.echo(f"{sysid:>3}  {result.name:<{LONGEST_NAME}}  {_words(result, numbers[sysid][result.name])}")
    return 0 if all(result.outcome in WELL for _, result in results) else NOT_DONE


def _words(result: ParameterResult, wanted: float) -> str:
    before = "-" if result.before is None else _text(result.before)
    match result.outcome:
        case "kept":
            return f"{before} already"
        case "would":
            return f"{before} -> {_text(wanted)}, not written: a dry run"
        case "set":
            return f"{before} -> {_text(wanted)}, read back"
        case _:
            return f"{result.outcome}: {result.why}"


def _missing(clients: Sequence[ParameterClient]) -> int:
    """Say what did not come; the exit status of that."""
    status = 0
    for client in clients:
        for result in client.results:
            if result.outcome not in WELL:
                click.echo(f"gcs: vehicle {client.sysid}: {result.name}: {result.why}", err=True)
                status = NOT_DONE
        if client.incomplete:
            click.echo(f"gcs: vehicle {client.sysid}: only {client.incomplete}", err=True)
            status = NOT_DONE
    return status


def _matching(client: ParameterClient, patterns: Sequence[str]) -> dict[str, float]:
    names = {name for pattern in patterns for name in fnmatch.filter(client.known, pattern)}
    return {name: client.known[name].number for name in sorted(names)}


def _say(name: str, numbers: dict[Any, float | None]) -> None:
    """A line of one parameter: once where all agree."""
    values = list(numbers.values())
    shown = {key: "-" if number is None else _text(number) for key, number in numbers.items()}
    if _agree(values):
        click.echo(f"{name:<{LONGEST_NAME}}  {next(iter(shown.values()))}")
    else:
        click.echo(f"{name:<{LONGEST_NAME}}  " + "  ".join(f"{key}: {text}" for key, text in shown.items()))


def _agree(values: Sequence[float | None]) -> bool:
    from gcs.mavlink.parameter_client import same

    first = values[0]
    return all(first is None if value is None else first is not None and same(first, value) for value in values)


def _text(number: float) -> str:
    return f"{number:.0f}" if number == int(number) and abs(number) < 1e9 else f"{number:.9g}"


def _setting(text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    with contextlib.suppress(ValueError):
        if equals and 0 < len(name) <= LONGEST_NAME and math.isfinite(number := float(value)):
            return name, number
    raise click.UsageError(f"{text!r} is no setting; write NAME=VALUE, such as RTL_ALT=2000.")


def _of(saved: dict[int, dict[str, float]], sysid: int) -> dict[str, float]:
    """Part of a file that a vehicle gets."""
    return next(iter(saved.values())) if len(saved) == 1 else saved.get(sysid, {})


def _load(file: Path) -> dict[int, dict[str, float]]:
    """Numbers of a parameter file, by system id (0: of a file without any). Raises click.ClickException."""
    saved: dict[int, dict[str, float]] = {}
    try:
        lines = file.read_text(encoding="ascii", errors="replace").splitlines()
    except OSError as error:
        raise Refused(f"{file} cannot be read: {error.strerror}") from None
    for number, line in enumerate(lines, 1):
        words = line.partition("#")[0].replace(",", " ").split()
        if not words:
            continue
        sysid, name, value = (words[0], words[2], words[3]) if len(words) == 5 else ("0", *words[:2], "")[:3]
        try:
            if len(words) not in (2, 5) or not 0 <= int(sysid) <= 254 or not math.isfinite(float(value)):
                raise ValueError
        except ValueError:
            text = "no parameter: write NAME VALUE, or vehicle, component, name, value and type"
            raise Refused(f"{file}:{number}: {line.strip()[:60]!r} is {text}") from None
        saved.setdefault(int(sysid), {})[name] = float(value)
    if not saved:
        raise Refused(f"{file} holds no parameter")
    return saved
