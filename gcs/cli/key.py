"""`gcs key`: keys of MAVLink 2 signing."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import hashlib
from pathlib import Path

import click

from gcs.cli.fleet_options import FIND_WITHIN_S, fleet_at
from gcs.cli.options import SECONDS, STATION_OPTION, Refused, connect_option, key_file_option
from gcs.scenario.endpoint import Endpoint
from skytender.exit import NOT_DONE


@click.group(short_help="Make keys for MAVLink 2 signing.")
def key() -> None:
    """Keys of MAVLink 2 signing: 32 bytes in a file that only you can read.

    Give the file to `gcs run`, `monitor` and `check` by --key-file, to a scenario's external vehicles by
    `signing: {key_file: ...}`, and to `simvehicle` by --key-file. Where a key is set, only what is signed with it
    counts.
    """


@key.command(short_help="Write a new key to a file.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@click.option(
    "--passphrase",
    is_flag=True,
    help="Ask for a passphrase and take its SHA-256, as MAVProxy, QGroundControl and Mission Planner do.",
)
def new(file: Path, passphrase: bool) -> int:
    """Write a new random key to FILE, which must not exist yet and is readable by you alone.

    \b
    Examples:
      gcs key new fleet.key
      gcs key new fleet.key --passphrase

    \b
    Exit status:
      0    the file was written
      2    it exists already, or could not be written
    """
    from gcs.link.keys import new_key
    from skytender.key_files import KeyRefused

    digest = None
    if passphrase:
        words = click.prompt("Passphrase", hide_input=True, confirmation_prompt=True, err=True)
        digest = hashlib.sha256(str(words).encode()).digest()
    try:
        new_key(file, digest)
    except KeyRefused as error:
        raise click.UsageError(f"{error}.") from None
    click.echo(f"{file}: written. Copy it to both ends of the link over a channel that is not overheard.")
    return 0


@key.command(short_help="Give a vehicle a key, or take it away.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@connect_option("Where the vehicle is: udpin, udpout, tcp, tcpin:HOST:PORT, or serial:DEVICE:BAUD.")
@click.option("--sysid", type=click.IntRange(1, 254), help="The vehicle.  [default: the only one that is heard]")
@click.option("--remove", is_flag=True, help="Take the key of FILE away: the vehicle signs nothing and obeys anyone.")
@key_file_option("The key that the vehicle has now, where FILE is to take its place.")
@click.option(
    "--trust", is_flag=True, help="Send it over a radio or a network too: any listener there has the key then."
)
@click.option("--wait", "within", type=SECONDS, default=FIND_WITHIN_S, show_default=True,
              help="Seconds to find the vehicle.")  # fmt: skip
@STATION_OPTION
def send(
    file: Path,
    connect: Endpoint | None,
    sysid: int | None,
    remove: bool,
    key_file: Path | None,
    trust: bool,
    within: float,
    station: tuple[int, int],
) -> int:
    """Give a vehicle the key in FILE by SETUP_SIGNING, and see that it answers signed with it.

    The key travels in the open: it is sent over this machine's own addresses and an autopilot's USB port (ttyACM),
    over others only with --trust. No key is sent to a vehicle that is armed. From then on every station of the vehicle
    needs the key; FILE is never deleted.

    \b
    Examples:
      gcs key send fleet.key --connect serial:/dev/ttyACM0:115200
      gcs key send new.key --key-file fleet.key --connect udpin:127.0.0.1:14550 --sysid 3
      gcs key send fleet.key --remove --connect serial:/dev/ttyACM0:115200

    \b
    Exit status:
      0    the vehicle answers as it should
      1    it does not
      2    bad input, or no vehicle was received
      130  stopped by Ctrl-C
    """
    from gcs.link.key_setup import KeyNotSet, others_may_read, set_key
    from skytender.key_files import KeyRefused, read_key

    if connect is None:
        raise click.UsageError("--connect is needed: a key is sent to one address alone.")
    if remove and key_file is not None:
        raise click.UsageError("--remove and --key-file exclude each other: FILE is the key that is taken away.")
    if not remove and others_may_read(connect) and not trust:
        raise Refused(
            f"{connect.text} may be a radio or a network, where others read the key: use the autopilot's USB port, or "
            "say --trust"
        )
    before, after = (file, None) if remove else (key_file, file)
    try:
        read_key(file)
        with fleet_at(connect, station, () if sysid is None else (sysid,), before, within) as fleet:
            if len(fleet.profiles) > 1:
                found = ", ".join(map(str, sorted(fleet.profiles)))
                raise Refused(f"vehicles {found} are there: say which by --sysid")
            (one,) = fleet.profiles
            set_key(fleet, one, before, after)
    except KeyRefused as error:
        raise click.UsageError(f"{error}.") from None
    except KeyNotSet as error:
        click.echo(f"gcs: {error}.", err=True)
        return NOT_DONE
    end = "has no key any more, and answers what is not signed" if after is None else f"answers signed with {after}"
    click.echo(f"vehicle {one} {end}.")
    return 0
