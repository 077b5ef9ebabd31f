"""`simvehicle traffic`: moving obstacles that report themselves."""

# ruff: noqa: PLC0415 - so that help and a bad command line load nothing that takes long

from __future__ import annotations

from pathlib import Path

import click


@click.command(short_help="Fly the movers of a file and report them by ADSB_VEHICLE.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@click.option("--supervised", metavar="udpout:HOST:PORT", required=True, help="The gcs supervisor to report to.")
def traffic(file: Path, supervised: str) -> None:
    """Fly the movers of FILE and report them by ADSB_VEHICLE (system 255, component 156)."""
    from simvehicle.mavlink.connection import Connection
    from simvehicle.sitl.link import AddressError, SupervisedLink, parse_supervisor
    from simvehicle.sitl.loop import ConnectedUnit
    from simvehicle.sitl.secret import own_secret
    from simvehicle.sitl.supervised import run_supervised
    from simvehicle.sitl.traffic import COMPID, SYSID, Traffic, TrafficError, load

    try:
        connection = Connection(SYSID, COMPID)
        address = parse_supervisor(supervised)
        frame, movers = load(file)
        link = SupervisedLink(address)
    except (AddressError, TrafficError) as error:
        raise click.UsageError(str(error)) from error
    with link:
        run_supervised([ConnectedUnit(Traffic(frame, movers, [connection]), connection, [])], link, own_secret())
