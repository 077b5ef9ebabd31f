"""`simvehicle`: one simulated quadrotor on the command line, the hatch that makes many, and traffic.

What flies is imported where it is needed, so that help and a bad command line cost no compiler's start.
"""

# ruff: noqa: PLC0415

from __future__ import annotations

import sys
from collections.abc import Sequence
from contextlib import ExitStack
from importlib.metadata import version
from itertools import pairwise
from math import radians
from pathlib import Path
from typing import Any

import click

EXIT_BAD_INPUT = 2
EXIT_OUTPUT_LOST = 74


class _Triple(click.ParamType[tuple[float, float, float]]):
    """Three numbers with commas between them."""

    name = "N,E,D"

    def __init__(self, name: str) -> None:
        self.name = name

    def convert(
        self, value: object, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[float, float, float]:
        if isinstance(value, tuple):
            return value
        try:
            first, second, third = (float(part) for part in str(value).split(","))
        except ValueError:
            self.fail(f"'{value}' is not three numbers; write {self.name}, e.g. 0,5,-2", param, ctx)
        if not all(abs(number) < 1e7 for number in (first, second, third)):
            self.fail(f"'{value}' holds a number that is no place or speed", param, ctx)
        return first, second, third


@click.group(
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog=(
        "Example: simvehicle --sysid 1 --connect udpout:127.0.0.1:14550 flies one vehicle that QGroundControl, MAVSDK "
        "and MAVProxy find at once. Give several vehicles different --sysid; they may share one ground station's port."
    ),
)
@click.version_option(version("skytender"), prog_name="simvehicle")
@click.option("--sysid", type=click.IntRange(1, 254), metavar="1..254", help="MAVLink system id of the vehicle.")
@click.option(
    "--connect",
    "connect",
    multiple=True,
    metavar="udpout:HOST:PORT|udpin:HOST:PORT",
    help="Plain MAVLink: speak to a ground station (udpout) or wait for one (udpin). May be given several times.",
)
@click.option("--supervised", metavar="udpout:HOST:PORT", help="Take time and orders from a gcs supervisor.")
@click.option("--position", type=_Triple("N,E,D"), default="0,0,0", help="Start in the local frame, m.")
@click.option("--velocity", type=_Triple("N,E,D"), default="0,0,0", help="Velocity at start, m/s.")
@click.option("--attitude", type=_Triple("R,P,Y"), default="0,0,0", help="Roll, pitch and yaw at start, deg.")
@click.option("--airborne", is_flag=True, help="Start armed and in offboard, flying its own state; there is no ground.")
@click.option(
    "--home",
    type=_Triple("LAT,LON,ALT"),
    default="47.397742,8.545594,488",
    show_default=True,
    help="Origin of the local frame: degrees, degrees, m above mean sea level.",
)
@click.option("--params", type=click.Path(path_type=Path, dir_okay=False), help="YAML file of MAVLink parameters.")
@click.option(
    "--autopilot",
    type=click.Choice(["px4", "ardupilot", "generic"]),
    default="px4",
    show_default=True,
    help="The autopilot that the vehicle says it is.",
)
@click.option("--truth", type=click.Path(path_type=Path, dir_okay=False), help="New file for what is true, per step.")
@click.pass_context
def cli(ctx: click.Context, /, **options: Any) -> None:
    """Fly one simulated quadrotor that speaks MAVLink 2 over UDP as PX4 would.

    The vehicle flies a double-loop controller with a finite-time differentiator at 250 Hz, in real time, or, when
    --supervised, in the time that a gcs supervisor grants. It obeys arm, take-off, land, return, mode changes and
    offboard set points, and ends with Ctrl-C.
    """
    if ctx.invoked_subcommand is None:
        ctx.exit(_fly(**options))


def _fly(
    *,
    sysid: int | None,
    connect: tuple[str, ...],
    supervised: str | None,
    position: tuple[float, float, float],
    velocity: tuple[float, float, float],
    attitude: tuple[float, float, float],
    airborne: bool,
    home: tuple[float, float, float],
    params: Path | None,
    autopilot: str,
    truth: Path | None,
) -> int:
    from simvehicle.geo import LocalFrame
    from simvehicle.link import AddressError, PlainLink, SupervisedLink, parse_address
    from simvehicle.mavlink.connection import Connection
    from simvehicle.mavlink.identity import IDENTITIES
    from simvehicle.mavlink.parameters import ParameterError, Parameters
    from simvehicle.process import run_free, run_supervised
    from simvehicle.services import Services
    from simvehicle.truth import TruthWriter
    from simvehicle.unit import VehicleUnit
    from simvehicle.vehicle import Start, Vehicle

    if sysid is None:
        raise click.UsageError("--sysid is missing: give the vehicle a MAVLink system id from 1 to 254.")
    if not connect and supervised is None:
        raise click.UsageError("nobody would hear it: give --connect udpout:127.0.0.1:14550 or another address.")
    if position[2] > 0.0 and not airborne:
        raise click.UsageError("--position lies below the ground: down must be 0 or negative.")
    try:
        parameters = Parameters(_read_params(params))
    except ParameterError as error:
        raise click.UsageError(f"--params {params}: {error}") from error
    try:
        frame = LocalFrame(*home)
    except ValueError as error:
        raise click.UsageError(f"--home {error}") from error
    roll, pitch, yaw = attitude
    start = Start(position, velocity, (radians(roll), radians(pitch), radians(yaw)), airborne)
    vehicle = Vehicle(IDENTITIES[autopilot], parameters, frame, start)
    with ExitStack() as opened:
        try:
            connections = [Connection(sysid) for _ in connect]
            plain = [
                opened.enter_context(PlainLink(parse_address(text), connection))
                for text, connection in zip(connect, connections, strict=True)
            ]
            link = None
            if supervised is not None:
                link = opened.enter_context(SupervisedLink(parse_address(supervised), Connection(sysid)))
                connections.insert(0, link.connection)
            writer = opened.enter_context(TruthWriter(truth, sysid, vehicle)) if truth else None
        except AddressError as error:
            raise click.UsageError(str(error)) from error
        except FileExistsError as error:
            raise click.UsageError(f"--truth {truth} exists already; name a new file.") from error
        except OSError as error:
            raise click.UsageError(f"--truth {truth}: {error.strerror}") from error
        unit = VehicleUnit(vehicle, Services(vehicle, sysid, connections), writer)
        try:
            for other in plain:
                print(f"vehicle {sysid}: {other.address} (local port {other.port})", flush=True)
            if link is not None:
                run_supervised(unit, link, plain)
            else:
                run_free(unit, plain)
        except OSError as error:
            print(f"vehicle {sysid}: cannot write {error.filename or truth}: {error.strerror}", file=sys.stderr)
            return EXIT_OUTPUT_LOST
    return 0


def _read_params(path: Path | None) -> dict[str, float]:
    """The file's values by name; one sentence with the file's name, and line where there is one, for what is wrong."""
    import yaml

    if path is None:
        return {}
    try:
        root = yaml.compose(path.read_text(encoding="utf-8"), Loader=yaml.SafeLoader)
    except OSError as error:
        raise click.UsageError(f"--params {path}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise click.UsageError(f"--params {path} is no text file") from error
    except yaml.YAMLError as error:
        raise click.UsageError(f"--params {path}: {' '.join(str(error).split())}") from error
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


@cli.command(short_help="Make many vehicles, one per JSON line on stdin.")
def hatch() -> None:
    """Make many vehicles: one JSON line on stdin each, {"argv": [...], "log": PATH}; ends with stdin.

    Modules are loaded and the flight law is compiled once; every vehicle is then a fork of this process.
    """
    from simvehicle import flight, hatch, services  # noqa: F401 - loaded here, once, for all vehicles
    from simvehicle.preload import warm_up

    warm_up()
    sys.exit(hatch.run(run_argv, sysid_of))


@cli.command(short_help="Fly the movers of a file and report them by ADSB_VEHICLE.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@click.option("--supervised", metavar="udpout:HOST:PORT", required=True, help="The gcs supervisor to report to.")
def traffic(file: Path, supervised: str) -> None:
    """Fly the movers of FILE and report them by ADSB_VEHICLE (system 255, component 156)."""
    from simvehicle.link import AddressError, SupervisedLink, parse_address
    from simvehicle.mavlink.connection import Connection
    from simvehicle.process import run_supervised
    from simvehicle.traffic import COMPID, SYSID, Traffic, TrafficError, load

    try:
        connection = Connection(SYSID, COMPID)
        address = parse_address(supervised)
        frame, movers = load(file)
        link = SupervisedLink(address, connection)
    except (AddressError, TrafficError) as error:
        raise click.UsageError(str(error)) from error
    with link:
        run_supervised(Traffic(frame, movers, [connection]), link, [])


@cli.command(short_help="Draw the paper's vehicle-only figures.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="Folder for vehicle.json and figures.",
)
@click.option("--only", metavar="NAME,NAME", help="Some of fig5, fig12, implicit; all by default.")
def paper(out: Path, only: str | None) -> None:
    """Measure and draw the paper's figures that need one vehicle alone, as SVG and PNG, numbers in vehicle.json.

    fig5 is the differentiator on 5 sin t, fig12 its comparison with two others, implicit why it is stepped implicitly.
    """
    from simvehicle.paper import STUDIES, make

    names = list(STUDIES) if only is None else [name.strip() for name in only.split(",")]
    for name in names:
        if name not in STUDIES:
            raise click.UsageError(f"--only: there is no figure '{name}'; choose from {', '.join(STUDIES)}.")
    try:
        make(out, names, click.echo)
    except OSError as error:
        print(f"simvehicle: cannot write {error.filename or out}: {error.strerror}", file=sys.stderr)
        click.get_current_context().exit(EXIT_OUTPUT_LOST)


def sysid_of(argv: Sequence[str]) -> int:
    """The system id that an argv stands for; 255 for traffic, 0 where it names none."""
    if argv and argv[0] == "traffic":
        return 255
    for word, following in pairwise(argv):
        if word == "--sysid" and following.isdecimal():
            return int(following)
    return 0


def run_argv(argv: Sequence[str]) -> int:
    """Run one command line in this process; the exit status."""
    try:
        status = cli.main(list(argv), prog_name="simvehicle", standalone_mode=False)
    except click.ClickException as error:
        print(f"simvehicle: {' '.join(error.format_message().split())}", file=sys.stderr)
        return EXIT_BAD_INPUT
    except (KeyboardInterrupt, click.Abort):
        return 130
    return int(status or 0)


def main() -> None:
    """Entry point."""
    sys.exit(run_argv(sys.argv[1:]))
