"""`simvehicle`: one simulated quadrotor on the command line, the hatch that makes many, and traffic.

What flies is imported where it is needed, so that help and a bad command line cost no compiler's start.
"""

# ruff: noqa: PLC0415

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from importlib.metadata import version
from itertools import pairwise
from math import radians
from pathlib import Path
from typing import Any

import click

from simvehicle.exit import AUTOPILOT_GONE, BAD_INPUT, CANNOT_WRITE, INTERRUPTED
from simvehicle.loading import loaded, uncollected

LAST_SYSID = 254
REAL_AUTOPILOTS = {
    "ardupilot": ("simvehicle.sitl.ardupilot", "ArduPilotUnit"),
    "px4": ("simvehicle.sitl.px4", "Px4Unit"),
}
"""Commands that fly a real autopilot: the module and the class of each."""


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
)
@click.version_option(version("skytender"), prog_name="simvehicle")
@click.option("--sysid", type=click.IntRange(1, 254), metavar="N", help="MAVLink system id.")
@click.option(
    "--connect",
    "connect",
    multiple=True,
    metavar="udpout|udpin:HOST:PORT",
    help="Plain MAVLink: speak to a ground station (udpout) or wait for one. Repeatable.",
)
@click.option("--supervised", metavar="udpout:HOST:PORT", help="Take time and orders from a gcs supervisor.")
@click.option(
    "--position", type=_Triple("N,E,D"), multiple=True, default=("0,0,0",), help="Start in the local frame, m."
)
@click.option("--velocity", type=_Triple("N,E,D"), multiple=True, default=("0,0,0",), help="Velocity at start, m/s.")
@click.option(
    "--attitude", type=_Triple("R,P,Y"), multiple=True, default=("0,0,0",), help="Roll, pitch and yaw at start, deg."
)
@click.option("--airborne", is_flag=True, help="Start flying in offboard; there is no ground.")
@click.option(
    "--home",
    type=_Triple("LAT,LON,ALT"),
    default="47.397742,8.545594,488",
    show_default=True,
    help="Origin of the local frame: degrees, degrees, m above mean sea level.",
)
@click.option(
    "--params",
    type=click.Path(path_type=Path, dir_okay=False),
    multiple=True,
    help="MAVLink parameters, YAML, NAME: number.",
)
@click.option(
    "--autopilot",
    type=click.Choice(["px4", "ardupilot", "generic"]),
    default="px4",
    show_default=True,
    help="The autopilot that the vehicle says it is.",
)
@click.option(
    "--truth",
    type=click.Path(path_type=Path, dir_okay=False),
    multiple=True,
    help="New file for what is true, per step.",
)
@click.option(
    "--truth-hz",
    type=click.FloatRange(0.0, 250.0, min_open=True),
    default=None,
    hidden=True,  # for sessions: `record: {truth_hz}`
    help="Records of truth a second; else one a step.",
)
@click.option(
    "--state",
    type=click.Path(path_type=Path, file_okay=False),
    metavar="DIR",
    help="Folder in which changed parameters (before --params) and plans outlive reboots.",
)
@click.option(
    "--key-file",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="Sign frames; obey only what this key signed.",
)
@click.option(
    "--fleet",
    "fleet",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="Rules to compete on board by, YAML.",
)
@click.option(
    "--world",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="Weather and rotors, YAML; else the paper's.",
)
@click.option(
    "--count",
    type=click.IntRange(1, 254),
    default=1,
    metavar="N",
    help="Fly N vehicles in this process, ids from --sysid on, sockets of their own (udpin ports count up). "
    "--position, --velocity, --attitude, --params, --truth may be given N times, in order; given once, all but "
    "--truth hold for all.",
)
@click.pass_context
def cli(ctx: click.Context, /, **options: Any) -> None:
    """Fly one simulated quadrotor that speaks MAVLink 2 over UDP as PX4 would.

    The vehicle flies a double-loop controller with a finite-time differentiator at 250 Hz, in real time, or, when
    --supervised, in the time that a gcs supervisor grants. It obeys arm, take-off, land, return, modes, missions and
    offboard set points. At udpout:127.0.0.1:14550 QGroundControl, MAVSDK and MAVProxy find it at once.

    \b
    Examples:
      simvehicle --sysid 1 --connect udpout:127.0.0.1:14550
      simvehicle --sysid 2 --connect udpin:127.0.0.1:14540 --autopilot ardupilot
      simvehicle --sysid 1 --count 25 --connect udpout:127.0.0.1:14550

    \b
    Exit status:
      2    bad input; nothing has flown
      74   a file could not be written
      75   its supervisor was silent for ten seconds
      130  ended by Ctrl-C
    """
    if ctx.invoked_subcommand is None:
        ctx.exit(_fly(**options))


def _fly(
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
    world: Path | None,
    count: int,
) -> int:
    from simvehicle.autopilot.body import Start
    from simvehicle.autopilot.geodesy import LocalFrame
    from simvehicle.autopilot.identity import IDENTITIES
    from simvehicle.sitl.block import Wanted, fly
    from simvehicle.sitl.keys import KeyFileError
    from simvehicle.sitl.link import AddressError

    if sysid is None:
        raise click.UsageError("--sysid is missing: give the vehicle a MAVLink system id from 1 to 254.")
    if sysid + count - 1 > LAST_SYSID:
        raise click.UsageError(f"--count {count}: system ids end at {LAST_SYSID}; begin at {LAST_SYSID + 1 - count}.")
    if not connect and supervised is None:
        raise click.UsageError("nobody would hear it: give --connect udpout:127.0.0.1:14550 or another address.")
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
    rules = None if fleet is None else _fleet_rules(fleet)
    plants = {} if world is None else _plants(world)
    for i, (values, own_truth) in enumerate(files):
        store = _state(state, sysid + i)
        parameters = _parameters(values, store.values if store is not None else {})
        plant = plants.get(sysid + i)
        if plant is not None:
            _check_flies(plant, parameters, world)
        wanted.append(
            Wanted(sysid + i, starts[i], parameters, own_truth, store, key_file, state, plant, rules, truth_hz=truth_hz)
        )
    for path in truth:
        if path.exists():
            raise click.UsageError(f"--truth {path} exists already; name a new file.")
        if not path.parent.is_dir():
            raise click.UsageError(f"--truth {path}: No such file or directory")
    try:
        fly(wanted, IDENTITIES[autopilot], frame, connect, supervised)
    except (AddressError, KeyFileError) as error:
        raise click.UsageError(str(error)) from error
    except OSError as error:
        unwritten = error.filename or ", ".join(map(str, truth))
        print(f"vehicle {sysid}: cannot write {unwritten}: {error.strerror}", file=sys.stderr)
        return CANNOT_WRITE
    return 0


def _each(option: str, values: tuple[Any, ...], count: int) -> tuple[Any, ...]:
    """One value per vehicle: given once it holds for all."""
    if len(values) not in (1, count):
        vehicles = f"each of the {count} vehicles" if count > 1 else "the one vehicle"
        raise click.UsageError(f"{option} is given {len(values)} times: give it once, or once for {vehicles}.")
    return values * count if len(values) == 1 else values


def _fleet_rules(path: Path) -> Any:
    import yaml

    from simvehicle.fleet.rules import FleetRulesError, read_rules

    try:
        return read_rules(yaml.safe_load(path.read_text(encoding="utf-8")))
    except OSError as error:
        raise click.UsageError(f"--fleet {path}: {error.strerror}") from error
    except (UnicodeDecodeError, yaml.YAMLError) as error:
        raise click.UsageError(f"--fleet {path}: {' '.join(str(error).split())}") from error
    except FleetRulesError as error:
        raise click.UsageError(f"--fleet {path}: {error}") from error


def _plants(path: Path) -> dict[int, Any]:
    """Plants of the vehicles that the world's file names, by system id."""
    import yaml

    from simvehicle.law.plants import RotorPlant
    from simvehicle.world.description import WorldError, read_world

    try:
        world = read_world(yaml.safe_load(path.read_text(encoding="utf-8")))
    except OSError as error:
        raise click.UsageError(f"--world {path}: {error.strerror}") from error
    except (UnicodeDecodeError, yaml.YAMLError) as error:
        raise click.UsageError(f"--world {path}: {' '.join(str(error).split())}") from error
    except WorldError as error:
        raise click.UsageError(f"--world {path}: {error}") from error
    return {sysid: RotorPlant(one, world.air, seed=world.seed, sysid=sysid) for sysid, one in world.vehicles.items()}


def _check_flies(plant: Any, parameters: Any, world: Path | None) -> None:
    """Refuse rotors that cannot lift their vehicle in this air."""
    try:
        plant.parameters(parameters.flight())
    except ValueError as error:
        raise click.UsageError(f"--world {world}: {plant.own.airframe.name} cannot fly in this air: {error}") from error


def _state(folder: Path | None, sysid: int) -> Any:
    from simvehicle.sitl.storage import StateError, StateFile

    if folder is None:
        return None
    try:
        return StateFile(folder, sysid)
    except StateError as error:
        raise click.UsageError(f"--state {folder}: {error}") from error
    except OSError as error:
        raise click.UsageError(f"--state {folder}: {error.strerror}") from error


def _parameters(path: Path | None, kept: dict[str, float]) -> Any:
    from simvehicle.autopilot.parameters import ParameterError, Parameters

    try:
        given = Parameters(_read_params(path))
    except ParameterError as error:
        raise click.UsageError(f"--params {path}: {error}") from error
    try:
        return given.with_kept(kept)
    except ParameterError as error:
        raise click.UsageError(f"--state: {error}") from error


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
    with uncollected():
        from simvehicle.sitl import forkserver
        from simvehicle.sitl.warmup import warm_up

        warm_up()
        _rehearse_start()
    loaded()
    status = forkserver.run(run_argv, sysid_of, title_of, _prepare)
    sys.stderr.flush()
    os._exit(status)  # nothing is left to be done, and who waits for it need not wait for an interpreter's end


def _prepare(argv: Sequence[str]) -> None:
    """Load the flight core of rotors, once, where a vehicle needs it."""
    real = argv[0] if argv and argv[0] in REAL_AUTOPILOTS else None
    if "--world" in argv or real:
        from simvehicle.sitl.warmup import warm_up_rotors

        warm_up_rotors()
    if real:
        import_module(REAL_AUTOPILOTS[real][0])  # loaded here, once, for all autopilots


def _rehearse_start() -> None:
    """Go the way of a vehicle's process from its argv to its first hello, so that every fork finds it loaded."""
    import tempfile

    from simvehicle.autopilot.geodesy import LocalFrame
    from simvehicle.sitl import block, link, storage, traffic  # noqa: F401 - loaded here, once, for all vehicles

    triples = ("--position", "0,0,-1", "--velocity", "0,0,0", "--attitude", "0,0,0", "--home", "0,0,0")
    cli.make_context("simvehicle", ["--sysid", "1", *triples, "--params", "none", "--airborne"])
    LocalFrame(0.0, 0.0, 0.0)
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        file.write("SIM_BAT_CAP_J: 24000.0\n")
        file.flush()
        _parameters(Path(file.name), {})
    link.open_socket(link.parse_supervisor("udpout:127.0.0.1:9")).close()


@cli.command(short_help="Fly the movers of a file and report them by ADSB_VEHICLE.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@click.option("--supervised", metavar="udpout:HOST:PORT", required=True, help="The gcs supervisor to report to.")
def traffic(file: Path, supervised: str) -> None:
    """Fly the movers of FILE and report them by ADSB_VEHICLE (system 255, component 156)."""
    from simvehicle.mavlink.connection import Connection
    from simvehicle.sitl.link import AddressError, SupervisedLink, parse_supervisor
    from simvehicle.sitl.loop import ConnectedUnit, run_supervised
    from simvehicle.sitl.secret import from_hatch
    from simvehicle.sitl.traffic import COMPID, SYSID, Traffic, TrafficError, load

    try:
        connection = Connection(SYSID, COMPID)
        address = parse_supervisor(supervised)
        frame, movers = load(file)
        link = SupervisedLink(address, connection)
    except (AddressError, TrafficError) as error:
        raise click.UsageError(str(error)) from error
    with link:
        run_supervised([ConnectedUnit(Traffic(frame, movers, [connection]), link, [])], from_hatch())


def _real_autopilot(run: Callable[[Path, int, str | None, str | None], int]) -> click.Command:
    """A command that flies a real autopilot, with its options."""
    run = click.option(
        "--connect", metavar="ADDRESS", help="udpin:HOST:PORT or udpout:HOST:PORT, to live on the wall clock."
    )(run)
    run = click.option("--supervised", metavar="udpout:HOST:PORT", help="The gcs supervisor that gives it time.")(run)
    run = click.option("--sysid", type=click.IntRange(1, 254), metavar="N", required=True, help="MAVLink system id.")(
        run
    )
    run = click.argument("file", type=click.Path(path_type=Path, dir_okay=False))(run)
    return cli.command(short_help=(run.__doc__ or "").partition("\n")[0])(run)


@_real_autopilot
def ardupilot(file: Path, sysid: int, supervised: str | None, connect: str | None) -> int:
    """Fly a real ArduPilot on our physics.

    It starts the ArduPilot of FILE and is its simulation, in the time that a supervisor grants, or on the wall clock.
    `gcs run` and `gcs launch` write FILE for a vehicle with `autopilot: {ardupilot: PATH}`.
    """
    return _fly_autopilot("ardupilot", file, sysid, supervised, connect)


@_real_autopilot
def px4(file: Path, sysid: int, supervised: str | None, connect: str | None) -> int:
    """Fly a real PX4 on our physics.

    It starts the PX4 of FILE and is its simulation, in the time that a supervisor grants, or on the wall clock.
    `gcs run` and `gcs launch` write FILE for a vehicle with `autopilot: {px4: PATH}`.
    """
    return _fly_autopilot("px4", file, sysid, supervised, connect)


def _fly_autopilot(kind: str, file: Path, sysid: int, supervised: str | None, connect: str | None) -> int:
    """Start the autopilot of a file and be its simulation."""
    import yaml

    from simvehicle.mavlink.connection import Connection
    from simvehicle.sitl.autopilot_process import AutopilotError, read_wanted
    from simvehicle.sitl.link import AddressError, PlainLink, SupervisedLink, parse_address, parse_supervisor
    from simvehicle.sitl.loop import ConnectedUnit, run_free, run_supervised
    from simvehicle.sitl.secret import from_hatch

    if (supervised is None) == (connect is None):
        raise click.UsageError("give either --supervised or --connect")
    module, name = REAL_AUTOPILOTS[kind]
    start = getattr(import_module(module), name)
    try:
        connection = Connection(sysid)
        wanted, plant = read_wanted(yaml.safe_load(file.read_text(encoding="utf-8")), sysid)
        with start(wanted, plant, connection) as unit:
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


@cli.command(short_help="Draw the paper's vehicle-only figures.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="Folder for vehicle.json and figures.",
)
@click.option("--only", metavar="NAME,NAME", help="Some of fig5, fig12, implicit, noise; all by default.")
@click.option(
    "--plans",
    type=click.Path(path_type=Path, dir_okay=False, exists=True),
    help="Fly these plans, as gcs paper writes them, instead of drawing: energies.npz.",
)
def paper(out: Path, only: str | None, plans: Path | None) -> None:
    """Measure and draw the paper's figures that need one vehicle alone, as SVG and PNG, numbers in vehicle.json.

    fig5 is the differentiator on 5 sin t, fig12 its comparison with two others, implicit why it is stepped implicitly,
    noise the three in flight on an estimate that errs.
    """
    from simvehicle.paper import energies
    from simvehicle.paper.studies import STUDIES, make

    if plans is not None:
        try:
            click.echo(energies.write(energies.read(plans), out))
        except ValueError as error:
            raise click.UsageError(f"--plans: {error}.") from None
        except OSError as error:
            print(f"simvehicle: cannot write {error.filename or out}: {error.strerror}", file=sys.stderr)
            click.get_current_context().exit(CANNOT_WRITE)
        return
    names = list(STUDIES) if only is None else [name.strip() for name in only.split(",")]
    for name in names:
        if name not in STUDIES:
            raise click.UsageError(f"--only: there is no figure '{name}'; choose from {', '.join(STUDIES)}.")
    try:
        make(out, names, click.echo)
    except OSError as error:
        print(f"simvehicle: cannot write {error.filename or out}: {error.strerror}", file=sys.stderr)
        click.get_current_context().exit(CANNOT_WRITE)


def sysid_of(argv: Sequence[str]) -> int:
    """The system id that an argv stands for; 255 for traffic, 0 where it names none."""
    if argv and argv[0] == "traffic":
        return 255
    for word, following in pairwise(argv):
        if word == "--sysid" and following.isdecimal():
            return int(following)
    return 0


def title_of(argv: Sequence[str]) -> str:
    """Process title of this argv: `simvehicle 3`, a block `simvehicle 3-27`, or `simvehicle traffic`."""
    first = sysid_of(argv)
    if not 0 < first <= LAST_SYSID:
        return "simvehicle traffic" if first else "simvehicle"
    counts = [int(following) for word, following in pairwise(argv) if word == "--count" and following.isdecimal()]
    last = first + (counts[-1] if counts else 1) - 1
    return f"simvehicle {first}" if last == first else f"simvehicle {first}-{last}"


def run_argv(argv: Sequence[str]) -> int:
    """Run one command line in this process; the exit status."""
    try:
        status = cli.main(list(argv), prog_name="simvehicle", standalone_mode=False)
    except click.ClickException as error:
        print(f"simvehicle: {' '.join(error.format_message().split())}", file=sys.stderr)
        return BAD_INPUT
    except (KeyboardInterrupt, click.Abort):
        return INTERRUPTED
    return int(status or 0)


def main() -> None:
    """Entry point."""
    sys.exit(run_argv(sys.argv[1:]))
