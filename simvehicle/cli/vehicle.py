"""The vehicles that a command line asks for, from its options to their flight."""

# ruff: noqa: PLC0415 - so that help and a bad command line load nothing that takes long

from __future__ import annotations

import sys
from collections.abc import Callable
from math import radians
from pathlib import Path
from typing import Any

import click

from simvehicle.cli.files import open_state, read_fleet_rules, read_parameters, read_plants, read_separation_rules
from skytender.exit import CANNOT_WRITE

LAST_SYSID = 254


def fly(**options: Any) -> int:
    """Fly what the options of `simvehicle` ask for; the exit status. Raises click.UsageError."""
    return prepare(**options)()


def prepare(
    *,
    sysid: int | None,
    connect: tuple[str, ...],
    supervised: str | None,
    position: tuple[tuple[float, float, float], ...],
    velocity: tuple[tuple[float, float, float], ...],
    attitude: tuple[tuple[float, float, float], ...],
    airborne: bool,
    home: tuple[float, float, float],
    params: tuple[Path, ...],
    autopilot: str,
    truth: tuple[Path, ...],
    truth_hz: float | None,
    state: Path | None,
    key_file: Path | None,
    fleet: Path | None,
    separation: Path | None,
    world: Path | None,
    count: int,
) -> Callable[[], int]:
    """Read what the options of `simvehicle` ask for, and build it; the function that flies it and returns the exit
    status, which only the vehicles' own process may call. Both raise click.UsageError."""
    from simvehicle.autopilot.body import Start
    from simvehicle.autopilot.geodesy import LocalFrame
    from simvehicle.autopilot.identity import IDENTITIES
    from simvehicle.sitl.block import Block, Wanted
    from simvehicle.sitl.link import AddressError
    from skytender.key_files import KeyRefused

    if sysid is None:
        raise click.UsageError("--sysid is missing: give the vehicle a MAVLink system id from 1 to 254.")
    if sysid + count - 1 > LAST_SYSID:
        raise click.UsageError(f"--count {count}: system ids end at {LAST_SYSID}; begin at {LAST_SYSID + 1 - count}.")
    if not connect and supervised is None:
        raise click.UsageError("no station would hear it: give --connect udpout:127.0.0.1:14550 or another address.")
    if separation is not None and supervised is None:
        raise click.UsageError("--separation needs --supervised: peers' places come by that link.")
    if any(down > 0.0 for _, _, down in position) and not airborne:
        raise click.UsageError("--position lies below the ground: down must be 0 or negative.")
    if count > 1 and len(truth) == 1:
        raise click.UsageError(f"--truth is one file, but there are {count} vehicles: give it {count} times.")
    try:
        frame = LocalFrame(*home)
    except ValueError as error:
        raise click.UsageError(f"--home {error}") from error
    starts = [
        Start(place, speed, (radians(roll), radians(pitch), radians(yaw)), airborne)
        for place, speed, (roll, pitch, yaw) in zip(
            _each("--position", position, count),
            _each("--velocity", velocity, count),
            _each("--attitude", attitude, count),
            strict=True,
        )
    ]
    files = zip(_each("--params", params or (None,), count), _each("--truth", truth or (None,), count), strict=True)
    wanted = []
    rules = None if fleet is None else read_fleet_rules(fleet)
    apart = None if separation is None else read_separation_rules(separation, range(sysid, sysid + count))
    plants = {} if world is None else read_plants(world)
    for i, (values, own_truth) in enumerate(files):
        store = None if state is None else open_state(state, sysid + i)
        kept = store.values if store is not None else {}
        parameters = read_parameters(values, kept, alone=supervised is None)
        plant = plants.get(sysid + i)
        if plant is not None:
            _check_flies(plant, parameters, world)
        wanted.append(
            Wanted(
                sysid + i,
                starts[i],
                parameters,
                own_truth,
                store,
                key_file,
                state,
                plant,
                rules,
                apart,
                truth_hz=truth_hz,
            )
        )
    try:
        block = Block(wanted, IDENTITIES[autopilot], frame, connect, supervised)
    except AddressError as error:
        raise click.UsageError(str(error)) from error

    def flight() -> int:
        for path in truth:
            if path.exists():
                raise click.UsageError(f"--truth {path} exists already; name a new file.")
            if not path.parent.is_dir():
                raise click.UsageError(f"--truth {path}: No such file or directory")
        try:
            block.fly()
        except (AddressError, KeyRefused) as error:
            raise click.UsageError(str(error)) from error
        except OSError as error:
            unwritten = error.filename or ", ".join(map(str, truth))
            print(f"vehicle {sysid}: cannot write {unwritten}: {error.strerror}", file=sys.stderr)
            return CANNOT_WRITE
        return 0

    return flight


def _each(option: str, values: tuple[Any, ...], count: int) -> tuple[Any, ...]:
    """One value per vehicle: given once it holds for all."""
    if len(values) not in (1, count):
        vehicles = f"each of the {count} vehicles" if count > 1 else "the one vehicle"
        raise click.UsageError(f"{option} is given {len(values)} times: give it once, or once for {vehicles}.")
    return values * count if len(values) == 1 else values


def _check_flies(plant: Any, parameters: Any, world: Path | None) -> None:
    """Refuse rotors that cannot lift their vehicle in this air."""
    try:
        plant.parameters(parameters.flight())
    except ValueError as error:
        raise click.UsageError(f"--world {world}: {plant.own.airframe.name} cannot fly in this air: {error}") from error
