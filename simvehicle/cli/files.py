"""Files that the options of `simvehicle` name, each read with its mistakes as click.UsageError."""

# ruff: noqa: PLC0415 - so that help and a bad command line load nothing that takes long

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from simvehicle.autopilot.parameters import Parameters
    from simvehicle.fleet.rules import FleetRules
    from simvehicle.fleet.separation_rules import SeparationRules
    from simvehicle.law.plants import RotorPlant
    from simvehicle.sitl.storage import StateFile


@contextlib.contextmanager
def _read_for(option: str, path: Path, *refused: type[Exception]) -> Iterator[None]:
    """Turn what goes wrong inside, `refused` or with a YAML file, into a click.UsageError with option and path."""
    import yaml

    problems: tuple[type[Exception], ...] = (yaml.YAMLError, *refused)
    try:
        yield
    except OSError as error:
        raise click.UsageError(f"{option} {path}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise click.UsageError(f"{option} {path} is no text file") from error
    except problems as error:
        raise click.UsageError(f"{option} {path}: {' '.join(str(error).split())}") from error


def read_fleet_rules(path: Path) -> FleetRules:
    """Rules to compete on board by."""
    import yaml

    from simvehicle.fleet.rules import FleetRulesError, read_rules

    with _read_for("--fleet", path, FleetRulesError):
        return read_rules(yaml.safe_load(path.read_text(encoding="utf-8")))


def read_separation_rules(path: Path, sysids: Iterable[int]) -> SeparationRules:
    """Rules by which these vehicles keep apart, in JSON: as YAML those of 254 vehicles take a second to read."""
    import json

    from simvehicle.fleet.separation_rules import SeparationRulesError, read_separation

    with _read_for("--separation", path, json.JSONDecodeError, SeparationRulesError):
        return read_separation(json.loads(path.read_text(encoding="utf-8")), sysids)


def read_plants(path: Path) -> dict[int, RotorPlant]:
    """Plants of the vehicles that the world's file names, by system id."""
    import yaml

    from simvehicle.law.plants import RotorPlant
    from simvehicle.world.description import WorldError, read_world

    with _read_for("--world", path, WorldError):
        world = read_world(yaml.safe_load(path.read_text(encoding="utf-8")))
    return {sysid: RotorPlant(one, world.air, seed=world.seed, sysid=sysid) for sysid, one in world.vehicles.items()}


def open_state(folder: Path, sysid: int) -> StateFile:
    """Where a vehicle's parameters and plans outlive reboots."""
    from simvehicle.sitl.storage import StateError, StateFile

    with _read_for("--state", folder, StateError):
        return StateFile(folder, sysid)


def read_parameters(path: Path | None, kept: dict[str, float], *, alone: bool = False) -> Parameters:
    """Parameters of a vehicle: the file's over the defaults, and over both what was `kept` over a reboot; `alone` as
    `Parameters` has it."""
    from simvehicle.autopilot.parameters import ParameterError, Parameters

    try:
        given = Parameters({} if path is None else _read_params(path), alone=alone)
    except ParameterError as error:
        raise click.UsageError(f"--params {path}: {error}") from error
    try:
        return given.with_kept(kept)
    except ParameterError as error:
        raise click.UsageError(f"--state: {error}") from error


def _read_params(path: Path) -> dict[str, float]:
    """The file's values by name; one sentence with the file's name, and line where there is one, for what is wrong."""
    import yaml

    with _read_for("--params", path, yaml.YAMLError):
        root = yaml.compose(path.read_text(encoding="utf-8"), Loader=yaml.SafeLoader)
    if not isinstance(root, yaml.MappingNode):
        raise click.UsageError(f"--params {path}: write one 'NAME: number' per line.")
    values: dict[str, float] = {}
    for key, value in root.value:
        where = f"--params {path}, line {key.start_mark.line + 1}"
        if not isinstance(key, yaml.ScalarNode) or not isinstance(value, yaml.ScalarNode):
            raise click.UsageError(f"{where}: write 'NAME: number'.")
        if key.value in values:
            raise click.UsageError(f"{where}: {key.value} is given twice")
        try:
            values[key.value] = float(value.value)
        except ValueError as error:
            raise click.UsageError(f"{where}: {key.value} is '{value.value}', which is no number") from error
    return values
