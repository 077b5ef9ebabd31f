"""Commands that fly an autopilot of others on our physics: their options, and their life."""

# ruff: noqa: PLC0415 - so that help and a bad command line cost no compiler's start

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from skytender.exit import AUTOPILOT_GONE

if TYPE_CHECKING:
    from simvehicle.sitl.autopilot_unit import AutopilotUnit

Command = Callable[[Path, int, str | None, str | None], int]


def real_autopilot(short_help: str) -> Callable[[Command], click.Command]:
    """Make a function of a file, system id, supervisor and address the command of one kind of autopilot."""

    def made(run: Command) -> click.Command:
        for option in (
            click.option("--connect", metavar="ADDRESS", help="udpin|udpout:HOST:PORT, to live on the wall clock."),
            click.option("--supervised", metavar="udpout:HOST:PORT", help="The gcs supervisor that gives it time."),
            click.option("--sysid", type=click.IntRange(1, 254), metavar="N", required=True, help="MAVLink system id."),
            click.argument("file", type=click.Path(path_type=Path, dir_okay=False)),
        ):
            run = option(run)
        return click.command(short_help=short_help)(run)

    return made


def fly_autopilot(
    kind: type[AutopilotUnit], file: Path, sysid: int, supervised: str | None, connect: str | None
) -> int:
    """Start the autopilot of a file and be its simulation; the exit status."""
    import yaml

    from simvehicle.mavlink.connection import Connection
    from simvehicle.sitl.autopilot_process import AutopilotError, read_wanted
    from simvehicle.sitl.link import AddressError, PlainLink, SupervisedLink, parse_address, parse_supervisor
    from simvehicle.sitl.loop import ConnectedUnit, run_free
    from simvehicle.sitl.secret import own_secret
    from simvehicle.sitl.supervised import run_supervised

    if (supervised is None) == (connect is None):
        raise click.UsageError("give either --supervised or --connect")
    try:
        if supervised is not None:
            # It and its autopilot answer each other hundreds of times in a grant: a process that is woken may wait for
            # its turn, not interrupt another pair or the supervisor. The autopilot inherits it.
            os.sched_setscheduler(0, os.SCHED_BATCH, os.sched_param(0))
        connection = Connection(sysid)
        wanted, plant = read_wanted(yaml.safe_load(file.read_text(encoding="utf-8")), sysid, kind.step_ms / 1e3)
        with kind(wanted, plant, connection) as unit:
            if supervised is not None:
                with SupervisedLink(parse_supervisor(supervised)) as link:
                    run_supervised([ConnectedUnit(unit, connection, [])], link, own_secret())
            elif connect is not None:
                with PlainLink(parse_address(connect), connection) as plain:
                    plain.announce()
                    run_free([ConnectedUnit(unit, None, [plain])])
    except (AddressError, OSError, yaml.YAMLError) as error:
        raise click.UsageError(f"{file}: {error}") from error
    except AutopilotError as error:
        print(f"vehicle {sysid}: {error}", file=sys.stderr)
        return AUTOPILOT_GONE
    return 0
