"""The program's options and commands. What flies is imported where it is needed."""

# ruff: noqa: PLC0415 - so that help and a bad command line cost no compiler's start

from __future__ import annotations

import errno
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import click

from skytender.exit import BAD_INPUT, CANNOT_WRITE, INTERRUPTED, STANDARD_OUTPUT

COMMANDS = ("ardupilot", "fork-server", "paper", "px4", "traffic")
"""Each in a module of its name, with `_` for `-`."""
_FILE = click.Path(path_type=Path, dir_okay=False)


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


class _LazyCommands(click.Group):
    """Commands, each loaded when it, or the list of all, is asked for."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        name = cmd_name.replace("-", "_")
        return getattr(import_module(f"simvehicle.cli.{name}"), name)


@click.group(
    cls=_LazyCommands,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
@click.version_option(package_name="skytender", prog_name="simvehicle")
@click.option("--sysid", type=click.IntRange(1, 254), metavar="N", help="MAVLink system id.")
@click.option(
    "--connect",
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
@click.option("--airborne", is_flag=True, help="Start flying, in offboard; no ground.")
@click.option(
    "--home",
    type=_Triple("LAT,LON,ALT"),
    default="47.397742,8.545594,488",
    show_default=True,
    help="Origin of the local frame: degrees, degrees, m above mean sea level.",
)
@click.option("--params", type=_FILE, multiple=True, help="MAVLink parameters, YAML, NAME: number.")
@click.option(
    "--autopilot",
    type=click.Choice(["px4", "ardupilot", "generic"]),
    default="px4",
    show_default=True,
    help="The autopilot that the vehicle says it is.",
)
@click.option("--truth", type=_FILE, multiple=True, help="New file for what is true, per step.")
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
@click.option("--key-file", type=_FILE, metavar="FILE", help="Sign frames; obey only what this key signed.")
@click.option("--fleet", type=_FILE, metavar="FILE", help="Rules to compete on board by, YAML.")
@click.option("--separation", type=_FILE, hidden=True, help="Rules to keep apart from peers by, JSON.")  # for sessions
@click.option("--world", type=_FILE, metavar="FILE", help="Weather and rotors, YAML; else the paper's.")
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
        from simvehicle.cli.vehicle import fly

        ctx.exit(fly(**options))


def run_argv(argv: Sequence[str]) -> int:
    """Run one command line in this process; the exit status."""
    return reported(lambda: cli.main(list(argv), prog_name="simvehicle", standalone_mode=False))


def reported(run: Callable[[], int | None]) -> int:
    """Run, and say in one sentence what click refuses, or that the disk is full; the exit status."""
    try:
        status = run()
    except click.ClickException as error:
        print(f"simvehicle: {' '.join(error.format_message().split())}", file=sys.stderr)
        return BAD_INPUT
    except (KeyboardInterrupt, click.Abort):
        return INTERRUPTED
    except OSError as error:
        if error.errno != errno.ENOSPC:
            raise
        unwritten = error.filename or STANDARD_OUTPUT
        print(f"simvehicle: cannot write {unwritten}: {error.strerror}", file=sys.stderr)
        return CANNOT_WRITE
    return int(status or 0)


def main() -> None:
    """Entry point."""
    sys.exit(run_argv(sys.argv[1:]))
