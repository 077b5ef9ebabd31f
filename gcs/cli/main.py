"""`gcs`: the ground station on the command line. Commands load what they need when they run."""

from __future__ import annotations

import errno
import sys
import traceback
from importlib import import_module
from pathlib import Path

import click

from gcs.extras import MissingExtra
from skytender.exit import (
    BAD_INPUT,
    INTERNAL_ERROR,
    INTERRUPTED,
    NOT_DONE,
    RAISE_LIMIT,
    STANDARD_OUTPUT,
    TOO_FEW_FILES,
    Terminated,
    leave,
)
from skytender.loading import uncollected

SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 100}


MODULES = {
    "benchmark": "benchmark",
    "campaign": "campaign.command",
    "check": "check.command",
    "doctor": "author",
    "export": "export",
    "init": "author",
    "key": "key",
    "launch": "launch",
    "list": "listing",
    "logs": "logs",
    "mission": "mission.command",
    "monitor": "monitor",
    "paper": "paper",
    "params": "params",
    "replay": "replay",
    "report": "report",
    "run": "run",
    "schema": "author",
    "validate": "author",
}
"""Where each command stands."""


class _Commands(click.Group):
    """Commands of other modules, each loaded when it, or the list of all, is asked for."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(MODULES)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in MODULES:
            return None
        with uncollected():
            command: click.Command = getattr(import_module(f"gcs.cli.{MODULES[cmd_name]}"), cmd_name)
        return command


@click.group(cls=_Commands, context_settings=SETTINGS)
@click.version_option(package_name="skytender", message="%(prog)s %(version)s")
def cli() -> None:
    """Fly a fleet of simulated quadrotors over real MAVLink, and refuel it in the air.

    \b
    Start here:
      gcs run demo             five pursuers, a moving target and a tanker, in a console in this terminal
      gcs run demo --lockstep  the same as fast as the machine can
      gcs list                 the scenarios that ship with it, and the sessions that were flown here
      gcs launch demo          only its vehicles, for QGroundControl, MAVSDK or MAVProxy
      gcs monitor              a further console on a session that runs, or on any fleet with --connect
      gcs params get 'RTL_*'   parameters of every vehicle of a fleet: get, set, diff, save, load
      gcs logs get             the logs of every vehicle of a fleet, into a folder
      gcs replay               a recorded session, or any .tlog, in the console
      gcs mission get          missions, geofences and rally points of a fleet: get, set, clear, diff; show of a file
      gcs campaign run FILE    a scenario many times, varied: rates, intervals, the worst sessions
      gcs report SESSION       a page of what it recorded: paths, energy, competition, distances
      gcs init                 a scenario of your own to start from; gcs validate draws it
      gcs doctor               what keeps sessions from running here

    A SCENARIO is a YAML file, or the name of one that ships with the program, such as demo.

    `gcs COMMAND --help` explains a command. `simvehicle --help` is one vehicle by itself.
    """


def run_argv(argv: list[str] | None = None) -> int:
    """Run one command line; the exit status."""
    try:
        return int(cli.main(argv, standalone_mode=False) or 0)
    except click.ClickException as error:
        _show(error)
        return error.exit_code
    except (KeyboardInterrupt, click.Abort):
        return INTERRUPTED
    except Terminated as signalled:
        return signalled.status
    except Exception as error:
        if isinstance(error, MissingExtra):
            click.echo(f"gcs: {error}", err=True)
            return BAD_INPUT
        if isinstance(error, OSError) and error.errno in TOO_FEW_FILES:
            click.echo(f"gcs: {RAISE_LIMIT}", err=True)
            return NOT_DONE
        if isinstance(error, OSError) and error.errno == errno.ENOSPC:
            click.echo(f"gcs: {error.filename or STANDARD_OUTPUT} cannot be written: {error.strerror}", err=True)
            return NOT_DONE
        place = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{Path(place.filename).name}:{place.lineno}"
        click.echo(f"gcs: internal error, please report it: {type(error).__name__} at {where}: {error}", err=True)
        return INTERNAL_ERROR


def _show(error: click.ClickException) -> None:
    """Say what is wrong as `gcs: …`, as all errors of the program are said; with the usage where that helps."""
    context = error.ctx if isinstance(error, click.UsageError) else None
    if context is not None:
        click.echo(context.get_usage(), err=True)
        click.echo(f"Try '{context.command_path} {context.help_option_names[0]}' for help.", err=True)
    click.echo(f"gcs: {error.format_message()}", err=True)


def main() -> None:
    """Entry point."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="replace")  # a name that the terminal cannot show must not end a session
    leave(run_argv())
