"""Meanings of parameters, as vehicles' own metadata has them, beside the values that `gcs params get` shows."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import click

from gcs.mavlink.metadata.client import PARAMETER, MetadataClient, MetadataRefused, ParameterMeaning

if TYPE_CHECKING:
    from gcs.link.fleet_client import FleetClient
    from gcs.mavlink.parameters.file import Address

Meanings = Mapping[str, ParameterMeaning]
_NUMBERED = re.compile(r"\d+")


def read(fleet: FleetClient, labels: Mapping[Address, str]) -> dict[str, Meanings]:
    """Read the metadata of components; their parameters' meanings by the component's label. What has none is named."""
    clients = [MetadataClient(*address, (PARAMETER,)) for address in labels]
    fleet.converse(clients)
    found: dict[str, Meanings] = {}
    for client in clients:
        label, problem = labels[client.sysid, client.compid], client.problem
        try:
            found[label] = client.parameters()
        except MetadataRefused as error:
            problem = str(error)
        if problem or not found[label]:
            why = problem or "its metadata does not hold them"
            click.echo(f"gcs: vehicle {label} does not say what its parameters are: {why}", err=True)
    return found


def of(name: str, meanings: Meanings) -> ParameterMeaning | None:
    """The meaning of a parameter, also where it is one of a numbered kind: CAL_ACC{n}_ID."""
    numbered = (f"{name[: at.start()]}{{n}}{name[at.end() :]}" for at in _NUMBERED.finditer(name))
    return next((meanings[one] for one in (name, *numbered) if one in meanings), None)


def lines(name: str, meant: Mapping[str, Meanings]) -> list[str]:
    """Texts of the vehicles about a parameter, each once."""
    found = (of(name, meanings) for meanings in meant.values())
    return list(dict.fromkeys(meaning.text for meaning in found if meaning is not None))


def as_json(meant: Mapping[str, Meanings], names: Mapping[str, Iterable[str]]) -> dict[str, dict[str, Any]]:
    """By the component's label and the parameter's name."""
    rows = {label: {name: of(name, meant.get(label, {})) for name in known} for label, known in names.items()}
    return {
        label: {
            name: {
                "text": meaning.short_desc, "unit": meaning.units, "min": meaning.min, "max": meaning.max,
                "default": meaning.default,
            }
            for name, meaning in row.items()
            if meaning is not None
        }
        for label, row in rows.items()
    }  # fmt: skip
