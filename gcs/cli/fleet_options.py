"""Commands that ask all vehicles at an address: their options, and the fleet that these stand for."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import contextlib
import functools
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.options import SECONDS, STATION_OPTION, Refused, connect_option, connecting, key_file_option
from gcs.scenario.endpoint import Endpoint
from skytender.exit import NOT_DONE

if TYPE_CHECKING:
    from gcs.link.fleet_client import FleetClient

FIND_WITHIN_S = 10.0
LEFT_OUT, DOUBLED = "gcs.left_out", "gcs.doubled"


def of_the_fleet(command: Callable[..., Any]) -> Callable[..., Any]:
    """The options of every command that asks a fleet; it ends with NOT_DONE where it had to leave a vehicle out."""

    @functools.wraps(command)
    def of_all(*arguments: Any, **options: Any) -> int:
        return max(int(command(*arguments, **options)), _left_out())

    asked: Callable[..., Any] = of_all
    for option in (
        connect_option(
            "Where the vehicles are: udpin, udpout, tcp, tcpin:HOST:PORT, or serial:DEVICE:BAUD.",
            default="udpin:127.0.0.1:14550",
        ),
        click.option(
            "--sysid",
            "sysids",
            type=click.IntRange(1, 254),
            multiple=True,
            help="Only this vehicle; may be given again.  [default: all that are heard]",
        ),
        key_file_option("MAVLink 2 signing: sign, and take only what is signed with this key."),
        click.option(
            "--wait",
            "within",
            type=SECONDS,
            default=10.0,
            show_default=True,
            help="Seconds to find the vehicles.",
        ),
        STATION_OPTION,
        click.option("--json", "as_json", is_flag=True, help="One JSON object on stdout, for other programs."),
    ):
        asked = option(asked)
    return asked


def _left_out() -> int:
    """Name the vehicles that a command for all could not speak to; NOT_DONE where there are some."""
    context = click.get_current_context()
    found: dict[int, str] = context.meta.get(LEFT_OUT, {})
    for sysid, why in sorted(found.items()):
        click.echo(f"gcs: vehicle {sysid} is left out: its messages are refused: {why}", err=True)
    return NOT_DONE if found or context.meta.get(DOUBLED) else 0


@contextlib.contextmanager
def fleet_at(
    connect: Endpoint,
    station: tuple[int, int],
    sysids: tuple[int, ...] = (),
    key_file: Path | None = None,
    within: float = FIND_WITHIN_S,
) -> Iterator[FleetClient]:
    """The vehicles at an address, found. Raises click.ClickException where there is none."""
    from gcs.link.fleet_client import FleetClient

    with connecting():
        fleet = FleetClient(connect, key_file, station)
    try:
        click.echo(f"waiting for a HEARTBEAT at {connect.text}, {within:g} s at most ...", err=True)
        if not fleet.find(sysids, within):
            missing = sorted(set(sysids) - fleet.profiles.keys())
            who = f"vehicle {', '.join(map(str, missing))}" if missing else "any vehicle"
            refused = {sysid: why for sysid, why in fleet.not_understood.items() if not sysids or sysid in sysids}
            why = "; ".join(f"messages of vehicle {sysid} came and were refused: {w}" for sysid, w in refused.items())
            why = why or fleet.listener.silence or "is it running, and is that its address?"
            raise Refused(f"no HEARTBEAT of {who} came within {within:g} s at {connect.text}: {why}")
        yield fleet
        for sysid in sorted(fleet.doubled.keys() & fleet.profiles.keys()):
            second = ":".join(map(str, fleet.doubled[sysid][:2]))
            said = f"two autopilots say that they are vehicle {sysid}; the one at {second} was passed over"
            click.echo(f"gcs: {said}: give it a system id of its own.", err=True)
        if fleet.doubled.keys() & fleet.profiles.keys() and (context := click.get_current_context(silent=True)):
            context.meta[DOUBLED] = True
        if not sysids and (context := click.get_current_context(silent=True)) is not None:
            context.meta[LEFT_OUT] = fleet.not_understood
    finally:
        fleet.close()
