"""Numbers that `gcs params set` and `gcs params load` give to the components of a fleet, and how that ended; also the
words of `gcs params` for a component, a value, and a parameter that has not come."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import difflib
import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import click

from skytender.exit import NOT_DONE

if TYPE_CHECKING:
    from gcs.link.fleet_client import FleetClient
    from gcs.mavlink.parameters.client import ParameterClient, ParameterResult
    from gcs.mavlink.parameters.file import Address, Numbers
    from gcs.mavlink.parameters.value import ParameterValue

LONGEST_NAME = 16
ALIKE = 0.8
"""Of difflib, from which on a name is suggested: a wrong suggestion is worse than none."""
MOST_MISTYPED = 20
"""More unknown names are no slips, but another autopilot's."""
LIST_FROM = 100
"""So many parameters of a component are compared with its whole list: a list comes many times as fast as answers to
names, of which few are under way at once."""
WELL = ("kept", "would", "set")
_COUNTED = {"unknown": "unknown", "refused": "refused", "silent": "without an answer"}


@dataclass
class _Writing:
    """Numbers on their way to one component."""

    client: ParameterClient
    wanted: Numbers
    listed: list[ParameterResult] = field(default_factory=list)
    """results of parameters that its list shows as set already"""

    @property
    def results(self) -> list[ParameterResult]:
        """Ends so far."""
        return [*self.listed, *self.client.results]

    @property
    def open(self) -> tuple[int, int]:
        """How many have been sent and have no end yet, and how many have not been sent."""
        left = self.wanted.keys() - {result.name for result in self.results}
        sent = len(left & self.client.written.keys())
        return sent, len(left) - sent


def write(fleet: FleetClient, numbers: dict[Address, Numbers], *, dry_run: bool, plain: bool, loaded: bool) -> int:
    """Give these components these numbers, and say how that ended, in words or (`plain`) as JSON; the exit status. With
    `loaded`, as from a file, parameters that are set already are counted and not listed."""
    from gcs.mavlink.parameters.client import ParameterClient

    writings = [
        _Writing(ParameterClient(*address, fleet.profiles[address[0]], dry_run=dry_run), wanted)
        for address, wanted in numbers.items()
    ]
    try:
        _converse(fleet, writings)
    except KeyboardInterrupt:
        if not plain:
            _say_each(writings, loaded=loaded)
        _say_interrupted(writings, dry_run=dry_run, loaded=loaded)
        raise
    if plain:
        click.echo(json.dumps({"dry_run": dry_run, "results": [row for one in writings for row in _rows(one)]}))
    else:
        _say_each(writings, loaded=loaded)
        for one in writings if loaded else ():
            of = f"vehicle {label(one.client)}: " if len(writings) > 1 else ""
            click.echo(of + _count(one, dry_run=dry_run, loaded=loaded))
    return 0 if all(result.outcome in WELL for one in writings for result in one.results) else NOT_DONE


def _converse(fleet: FleetClient, writings: Sequence[_Writing]) -> None:
    from gcs.mavlink.parameters.client import ParameterClient, ParameterResult
    from gcs.mavlink.parameters.value import same_as

    many = [one for one in writings if len(one.wanted) >= LIST_FROM]
    readers = [ParameterClient(one.client.sysid, one.client.compid, one.client.profile) for one in many]
    for reader in readers:
        reader.read_all()
    fleet.converse(readers)
    for one, reader in zip(many, readers, strict=True):
        known = {name: reader.known[name] for name in one.wanted if name in reader.known}
        one.listed = [
            ParameterResult(name, "kept", value, value)
            for name, value in known.items()
            if same_as(value, one.wanted[name])
        ]
    for one in writings:
        there = {result.name for result in one.listed}
        one.client.write({name: number for name, number in one.wanted.items() if name not in there})
    fleet.converse([one.client for one in writings])


def _say_each(writings: Sequence[_Writing], *, loaded: bool) -> None:
    for one in writings:
        for result in one.results:
            if not (loaded and result.outcome == "kept"):
                name = f"{label(one.client):>3}  {result.name:<{LONGEST_NAME}}"
                click.echo(f"{name}  {words(one.client, result)}")


def _say_interrupted(writings: Sequence[_Writing], *, dry_run: bool, loaded: bool) -> None:
    """Say how far it came: Ctrl-C leaves what has been written as it is."""
    clauses = []
    for one in writings:
        of = f"vehicle {label(one.client)}: " if len(writings) > 1 else ""
        sent, left = one.open
        sent_too = f", {sent} sent and not read back" if sent else ""
        clauses.append(f"{of}{_count(one, dry_run=dry_run, loaded=loaded)}{sent_too}, {left} not yet")
    click.echo(f"gcs: interrupted: {'; '.join(clauses)}", err=True)


def _count(one: _Writing, *, dry_run: bool, loaded: bool) -> str:
    """`1 written, 1367 already as in the file`."""
    counts = Counter[str](result.outcome for result in one.results)
    texts = [f"{counts['would']} would be written" if dry_run else f"{counts['set']} written"]
    if counts["kept"]:
        texts.append(f"{counts['kept']} already {'as in the file' if loaded else 'so'}")
    return ", ".join([*texts, *(f"{counts[of]} {text}" for of, text in _COUNTED.items() if counts[of])])


def _rows(one: _Writing) -> list[dict[str, object]]:
    client = one.client
    return [
        {
            **{"sysid": client.sysid, "compid": client.compid, "name": result.name, "outcome": result.outcome},
            **{"before": as_json(result.before), "now": as_json(result.now), "why": why(client, result)},
        }
        for result in one.results
    ]


def label(client: ParameterClient) -> str:
    """A component's name: the vehicle's for its autopilot."""
    from gcs.mavlink.ids import AUTOPILOT

    return str(client.sysid) if client.compid == AUTOPILOT else f"{client.sysid}/{client.compid}"


def as_json(value: ParameterValue | None) -> int | float | str | None:
    """A value's number for JSON."""
    return None if value is None else value.json


def why(client: ParameterClient, result: ParameterResult) -> str:
    """Why a parameter has not come, or has not been taken; of an unknown one also the name that may be meant."""
    unknown = [one for one in client.results if one.outcome == "unknown"]
    meant = _meant(client, result.name) if result in unknown and len(unknown) <= MOST_MISTYPED else ""
    return result.why + (f"; did you mean {meant}?" if meant else "")


def words(client: ParameterClient, result: ParameterResult) -> str:
    """How the writing of one parameter has ended."""
    before = "-" if result.before is None else result.before.text
    wanted = "-" if result.wanted is None else result.wanted.text
    match result.outcome:
        case "kept":
            return f"{before} already"
        case "would":
            return f"{before} -> {wanted}, not written: a dry run"
        case "set":
            return f"{before} -> {wanted}, read back"
        case _:
            return f"{result.outcome}: {why(client, result)}"


def _meant(client: ParameterClient, name: str) -> str:
    """The known name nearest to one that a component does not know, else that one in capitals; empty where that is no
    other, or the table of renames answers it. Names are known that the component has said, and by that table."""
    from gcs.mavlink.ids import AUTOPILOT
    from gcs.mavlink.parameters.renames import unknown_name

    table = client.profile.renamed_parameters if client.compid == AUTOPILOT else {}
    if unknown_name(name, table):
        return ""
    known = {*client.known, *table, *(row.now for row in table.values())} - {name}
    upper = name.upper()
    near = difflib.get_close_matches(upper, sorted(known), n=1, cutoff=ALIKE)
    return near[0] if near else upper * (upper != name)
