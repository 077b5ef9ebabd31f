"""`gcs params`: parameters over a whole fleet: read, written and verified, compared, saved and loaded."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import fnmatch
import json
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.fleet_options import fleet_at, of_the_fleet
from gcs.cli.options import Refused
from gcs.cli.parameter_writing import LONGEST_NAME, label, why, write
from gcs.cli.parameter_writing import as_json as number_json
from skytender.exit import NOT_DONE

if TYPE_CHECKING:
    from gcs.link.fleet_client import FleetClient
    from gcs.mavlink.parameters.client import ParameterClient
    from gcs.mavlink.parameters.file import Address, Numbers
    from gcs.mavlink.parameters.value import ParameterValue

GLOB = frozenset("*?[")


def _of_components(command: Callable[..., Any]) -> Callable[..., Any]:
    """The option that names components."""
    help = "A component of each vehicle, by its id; may be given again.  [default: 1, the autopilot]"
    return click.option("--compid", "compids", type=click.IntRange(1, 255), multiple=True, help=help)(command)


@click.group(short_help="Read, write, compare, save and load parameters over a fleet.")
def params() -> None:
    """Parameters of every vehicle at an address at once, whatever its autopilot.

    What is written is read back, and counts only when it reads as it was written. What a parameter's type cannot hold,
    or the vehicle's encoding cannot carry, is refused before it is written. Names may have * and ?, in quotes.

    \b
    Examples:
      gcs params get 'RTL_*' --connect udpin:127.0.0.1:14550
      gcs params set FENCE_ENABLE=1 FENCE_RADIUS=80 --dry-run
      gcs params diff
      gcs params save before.params
      gcs params load before.params --sysid 3
      gcs params get --compid 154

    \b
    Exit status:
      0    done; diff: all vehicles agree
      1    a parameter is unknown to a vehicle, was refused, or did not come; diff: they differ
      2    bad input, or no vehicle was received
      130  stopped by Ctrl-C; what was written stays, and is counted
    """


@params.command(short_help="Show parameters.")
@click.argument("patterns", nargs=-1, metavar="NAME...")
@click.option(
    "--describe", is_flag=True, help="Also what each is, by the vehicle's own metadata: unit, range, default."
)
@_of_components
@of_the_fleet
def get(patterns: tuple[str, ...], describe: bool, compids: tuple[int, ...], as_json: bool, **options: Any) -> int:
    """Show the parameters named NAME..., or all, of every vehicle.

    \b
    Examples:
      gcs params get FENCE_ENABLE 'WP_*'
      gcs params get --describe 'MPC_*'
      gcs params get --sysid 3 --json > three.json
    """
    from gcs.cli import parameter_meanings as meanings

    with fleet_at(**options) as fleet:
        clients = _read(fleet, _addresses(fleet, compids), patterns or ("*",))
        meant = meanings.read(fleet, {(c.sysid, c.compid): label(c) for c in clients}) if describe else {}
    found = {label(client): _matching(client, patterns or ("*",)) for client in clients}
    if as_json:
        rows = {of: {name: value.json for name, value in values.items()} for of, values in found.items()}
        click.echo(json.dumps({"vehicles": rows, **({"meanings": meanings.as_json(meant, rows)} if describe else {})}))
    else:
        for name in sorted({name for values in found.values() for name in values}):
            _say(name, {of: values.get(name) for of, values in found.items()})
            for line in meanings.lines(name, meant):
                click.echo(f"{'':<{LONGEST_NAME}}  {line}")
    return _missing(clients, patterns)


@params.command("set", short_help="Write parameters, and read them back.")
@click.argument("settings", nargs=-1, required=True, metavar="NAME=VALUE...")
@click.option("--dry-run", is_flag=True, help="Only say what would change.")
@_of_components
@of_the_fleet
def set_(settings: tuple[str, ...], dry_run: bool, compids: tuple[int, ...], as_json: bool, **options: Any) -> int:
    """Give parameters a value on every vehicle, and verify it by reading it back.

    \b
    Examples:
      gcs params set FENCE_ALT_MAX=60 --dry-run
      gcs params set 'COM_*_ACT=0' --sysid 3
    """
    wanted = dict(_setting(text) for text in settings)
    with fleet_at(**options) as fleet:
        globs = [name for name in wanted if GLOB & set(name)]
        plain = {name: number for name, number in wanted.items() if name not in globs}
        numbers = {address: dict(plain) for address in _addresses(fleet, compids)}
        if globs:
            clients = _read_to_write(fleet, numbers, globs)
            if unmatched := _unmatched(clients, globs):
                raise Refused(f"no vehicle has a parameter named {', '.join(unmatched)}")
            for client in clients:
                for pattern in globs:
                    names = fnmatch.filter(client.known, pattern)
                    numbers[client.sysid, client.compid] |= dict.fromkeys(names, wanted[pattern])
        return write(fleet, numbers, dry_run=dry_run, plain=as_json, loaded=False)


@params.command(short_help="Compare vehicles with each other, or with a file.")
@click.argument("file", required=False, type=click.Path(path_type=Path, dir_okay=False, exists=True))
@_of_components
@of_the_fleet
def diff(file: Path | None, compids: tuple[int, ...], as_json: bool, **options: Any) -> int:
    """Show the parameters in which vehicles differ from each other, or from FILE where it is given.

    Only parameters in FILE are compared with it; a file of one vehicle counts for all of them. A parameter that
    a vehicle does not know is named.
    """
    saved = None if file is None else _load(file)
    with fleet_at(**options) as fleet:
        if saved is None:
            clients = _read(fleet, _addresses(fleet, compids), ("*",))
            rows = _between(clients)
        else:
            numbers = _of_file(saved, fleet, compids)
            clients = _read(fleet, numbers, ("*",))
            rows = _from_file(clients, numbers)
    if as_json:
        shown = {name: {of: number_json(value) for of, value in row.items()} for name, row in rows.items()}
        click.echo(json.dumps({"differences": shown}))
    else:
        for name, row in rows.items():
            _say(name, row)
        if not rows:
            click.echo("no difference")
    return max(_missing(clients), NOT_DONE if rows else 0)


@params.command(short_help="Write the parameters of all vehicles to a file.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@click.argument("patterns", nargs=-1, metavar="[NAME...]")
@_of_components
@of_the_fleet
def save(file: Path, patterns: tuple[str, ...], compids: tuple[int, ...], as_json: bool, **options: Any) -> int:
    """Write all parameters, or those named NAME..., to FILE, which must not exist yet.

    A line holds vehicle, component, name, value and type, as QGroundControl writes and reads it.
    """
    from gcs.mavlink.parameters.file import HEAD, line

    if file.exists():
        raise Refused(f"{file} exists already and is left as it is; give another name")
    with fleet_at(**options) as fleet:
        clients = _read(fleet, _addresses(fleet, compids), patterns or ("*",))
    lines = [HEAD]
    for client in clients:
        for name, value in _matching(client, patterns or ("*",)).items():
            lines.append(line((client.sysid, client.compid), name, value))
    try:
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    except OSError as error:
        raise Refused(f"{file} cannot be written: {error.strerror}") from None
    count, vehicles = len(lines) - 1, len({client.sysid for client in clients})
    if as_json:
        click.echo(json.dumps({"file": str(file), "vehicles": vehicles, "parameters": count}))
    else:
        click.echo(f"{count} parameters of {vehicles} vehicle{'s' * (vehicles != 1)} are in {file}")
    return _missing(clients, patterns)


@params.command(short_help="Write a file's parameters to vehicles, and read them back.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False, exists=True))
@click.option("--dry-run", is_flag=True, help="Only say what would change.")
@click.option(
    "--compid",
    "compids",
    type=click.IntRange(1, 255),
    multiple=True,
    help="Only this component's lines.  [default: all]",
)
@of_the_fleet
def load(file: Path, dry_run: bool, compids: tuple[int, ...], as_json: bool, **options: Any) -> int:
    """Give vehicles the parameters of FILE, and verify them by reading them back.

    Each component of a vehicle gets its own lines; a file of one vehicle counts for all, and lines without ids (NAME
    VALUE, as ArduPilot, MAVProxy and Mission Planner have them) for every autopilot. Those that have the value already
    are not written, and only counted; --json names them too.
    """
    saved = _load(file)
    with fleet_at(**options) as fleet:
        return write(fleet, _of_file(saved, fleet, compids), dry_run=dry_run, plain=as_json, loaded=True)


def _addresses(fleet: FleetClient, compids: Sequence[int]) -> list[Address]:
    """System and component ids of what is asked."""
    from gcs.mavlink.ids import AUTOPILOT

    return [(sysid, compid) for sysid in sorted(fleet.profiles) for compid in sorted(set(compids) or {AUTOPILOT})]


def _read(fleet: FleetClient, addresses: Iterable[Address], patterns: Sequence[str]) -> list[ParameterClient]:
    """Read from these components what these patterns may name."""
    from gcs.mavlink.parameters.client import ParameterClient

    clients = [ParameterClient(*address, fleet.profiles[address[0]]) for address in addresses]
    for client in clients:
        if any(GLOB & set(pattern) for pattern in patterns):
            client.read_all()
        else:
            client.read(patterns)
    fleet.converse(clients)
    return clients


def _read_to_write(fleet: FleetClient, addresses: Iterable[Address], patterns: Sequence[str]) -> list[ParameterClient]:
    """The same, before anything is written."""
    try:
        return _read(fleet, addresses, patterns)
    except KeyboardInterrupt:
        click.echo("gcs: interrupted: nothing was written", err=True)
        raise


def _unmatched(clients: Sequence[ParameterClient], patterns: Sequence[str]) -> list[str]:
    """Patterns that match no parameter: neither a known one nor one that a component was asked for by name."""
    names = {name for client in clients for name in (*client.known, *(result.name for result in client.results))}
    return [pattern for pattern in patterns if not fnmatch.filter(names, pattern)]


def _missing(clients: Sequence[ParameterClient], patterns: Sequence[str] = ()) -> int:
    """Say what did not come, or what of these patterns there is nothing of; the exit status of that."""
    status = 0
    for client in clients:
        for result in client.results:
            if result.outcome != "read":
                click.echo(f"gcs: vehicle {label(client)}: {result.name}: {why(client, result)}", err=True)
                status = NOT_DONE
        if client.incomplete:
            click.echo(f"gcs: vehicle {label(client)}: only {client.incomplete}", err=True)
            status = NOT_DONE
    unmatched = _unmatched(clients, patterns)
    if unmatched and not any(client.incomplete for client in clients):
        click.echo(f"gcs: no vehicle has a parameter named {', '.join(unmatched)}", err=True)
        status = NOT_DONE
    return status


def _between(clients: Sequence[ParameterClient]) -> dict[str, dict[str, ParameterValue | None]]:
    """Values by name and component in which components differ."""
    names = sorted({name for client in clients for name in client.known})
    rows = {name: {label(client): client.known.get(name) for client in clients} for name in names}
    return {name: row for name, row in rows.items() if not _agree(list(row.values()))}


def _from_file(
    clients: Sequence[ParameterClient], numbers: dict[Address, Numbers]
) -> dict[str, dict[str, ParameterValue | None]]:
    """Values by name and component in which components differ from a file. Names that a component does not have are
    added to its results."""
    from gcs.mavlink.parameters.value import given, same_as

    rows: dict[str, dict[str, ParameterValue | None]] = {}
    for client in clients:
        wanted = numbers[client.sysid, client.compid]
        client.expect(wanted)
        for name, number in wanted.items():
            mine = client.known.get(name)
            if mine is None or not same_as(mine, number):
                rows.setdefault(name, {}).update({label(client): mine, "file": given(number, mine)})
    return dict(sorted(rows.items()))


def _matching(client: ParameterClient, patterns: Sequence[str]) -> dict[str, ParameterValue]:
    names = {name for pattern in patterns for name in fnmatch.filter(client.known, pattern)}
    return {name: client.known[name] for name in sorted(names)}


def _say(name: str, values: dict[str, ParameterValue | None]) -> None:
    """A line of one parameter: once where all agree."""
    shown = {of: "-" if value is None else value.text for of, value in values.items()}
    if _agree(list(values.values())):
        click.echo(f"{name:<{LONGEST_NAME}}  {next(iter(shown.values()))}")
    else:
        click.echo(f"{name:<{LONGEST_NAME}}  " + "  ".join(f"{of}: {text}" for of, text in shown.items()))


def _agree(values: Sequence[ParameterValue | None]) -> bool:
    from gcs.mavlink.parameters.value import same

    return all(same(values[0], value) for value in values)


def _setting(text: str) -> tuple[str, int | float]:
    """Name and number of NAME=VALUE. Raises click.UsageError."""
    from gcs.mavlink.parameters.value import parsed

    name, equals, number = (part.strip() for part in text.partition("="))
    if not (name and equals):
        raise click.UsageError(f"{text!r} is no setting; write NAME=VALUE, such as FENCE_RADIUS=80.")
    if len(name) > LONGEST_NAME:
        raise click.UsageError(f"{text!r}: a parameter's name has {LONGEST_NAME} letters at most, not {len(name)}.")
    try:
        return name, parsed(number)
    except ValueError:
        raise click.UsageError(
            f"{text!r}: {number!r} is no number; write NAME=VALUE, such as FENCE_RADIUS=80."
        ) from None


def _load(file: Path) -> dict[Address, Numbers]:
    """Numbers of a parameter file by address. Raises click.ClickException."""
    from gcs.mavlink.parameters.file import FileRefused, read

    try:
        return read(file)
    except FileRefused as error:
        raise Refused(str(error)) from None


def _of_file(saved: dict[Address, Numbers], fleet: FleetClient, compids: Sequence[int]) -> dict[Address, Numbers]:
    """Numbers that each component gets of a file, of these components alone where any are given. Raises
    click.ClickException where that is nothing."""
    from gcs.mavlink.parameters.file import of_vehicle

    numbers = {
        (sysid, compid): wanted
        for sysid in sorted(fleet.profiles)
        for compid, wanted in sorted(of_vehicle(saved, sysid).items())
        if not compids or compid in compids
    }
    if not numbers:
        of = f" and component {', '.join(map(str, compids))}" if compids else ""
        raise Refused(f"the file has no line for vehicle {', '.join(map(str, sorted(fleet.profiles)))}{of}")
    return numbers
