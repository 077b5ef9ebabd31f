"""`simvehicle ardupilot`: a real ArduPilot on our physics."""

# ruff: noqa: PLC0415 - so that help and a bad command line cost no compiler's start

from __future__ import annotations

import sys
from pathlib import Path

import click

from simvehicle.exit import AUTOPILOT_GONE


@click.command(short_help="Fly a real ArduPilot on our physics.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@click.option("--sysid", type=click.IntRange(1, 254), metavar="N", required=True, help="MAVLink system id.")
@click.option("--supervised", metavar="udpout:HOST:PORT", help="The gcs supervisor that gives it time.")
@click.option("--connect", metavar="ADDRESS", help="udpin:HOST:PORT or udpout:HOST:PORT, to live on the wall clock.")
def ardupilot(file: Path, sysid: int, supervised: str | None, connect: str | None) -> int:
    """Start the ArduPilot of FILE and be its simulation, in the time that a supervisor grants, or on the wall clock.

    `gcs run` and `gcs launch` write FILE for a vehicle with `autopilot: {ardupilot: PATH}`.
    """
    import yaml

    from simvehicle.mavlink.connection import Connection
    from simvehicle.sitl.ardupilot import ArduPilotUnit
    from simvehicle.sitl.autopilot_process import AutopilotError, read_wanted
    from simvehicle.sitl.link import AddressError, PlainLink, SupervisedLink, parse_address, parse_supervisor
    from simvehicle.sitl.loop import ConnectedUnit, run_free, run_supervised
    from simvehicle.sitl.secret import from_hatch

    if (supervised is None) == (connect is None):
        raise click.UsageError("give either --supervised or --connect")
    try:
        connection = Connection(sysid)
        wanted, plant = read_wanted(yaml.safe_load(file.read_text(encoding="utf-8")), sysid)
        with ArduPilotUnit(wanted, plant, connection) as unit:
            if supervised is not None:
                with SupervisedLink(parse_supervisor(supervised), connection) as link:
                    run_supervised([ConnectedUnit(unit, link, [])], from_hatch())
            elif connect is not None:
                with PlainLink(parse_address(connect), connection) as plain:
                    print(f"vehicle {sysid}: {plain.address} (local port {plain.port})", flush=True)
                    run_free([ConnectedUnit(unit, None, [plain])])
    except (AddressError, OSError, yaml.YAMLError) as error:
        raise click.UsageError(f"{file}: {error}") from error
    except AutopilotError as error:
        print(f"vehicle {sysid}: {error}", file=sys.stderr)
        return AUTOPILOT_GONE
    return 0
