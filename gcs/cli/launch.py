"""`gcs launch`: a scenario's vehicles alone, for another ground station."""

# ruff: noqa: PLC0415 - so that help and a mistyped option answer at once

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import click

from gcs.cli.author import ScenarioName, load_scenario
from gcs.cli.options import endpoint, out_option
from gcs.cli.trust import TRUST
from gcs.scenario.endpoint import Endpoint


def _checked_address(ctx: click.Context, param: click.Parameter, value: str | None) -> Endpoint | None:
    """A --connect is an address whose host can be found."""
    at = endpoint(ctx, param, value)
    if at is not None and at.way != "serial":
        from gcs.link.socket import AddressRefused, resolve

        try:
            resolve(at)
        except AddressRefused as error:
            raise click.BadParameter(f"{error}.", ctx, param) from None
    return at


@click.command(short_help="Start a scenario's vehicles for another ground station.")
@click.argument("scenario", type=ScenarioName())
@click.option(
    "--connect",
    callback=_checked_address,
    metavar="ADDRESS",
    help="All vehicles are there: they speak to a udpout; at any other address gcs stands between as a router.  "
    "[default: each listens at a port of its own]",
)
@out_option("Keep parameters, and what vehicles print, in this new folder.")
@click.option("--json", "as_json", is_flag=True, help="The vehicles' addresses as one line of JSON.")
@TRUST
@click.option("--until-eof", is_flag=True, help="End them when standard input closes, as when the caller dies.")
def launch(
    scenario: str, connect: Endpoint | None, out: Path | None, as_json: bool, trust: bool, until_eof: bool
) -> int:
    """Start SCENARIO's pursuers, targets and tankers, and nothing else: no supervisor, no traffic, no goal.

    They stand at their starts, on the wall clock, until another ground station commands them, targets included: their
    paths are not flown. All are there from the beginning, also those that would join later. Ctrl-C ends them. A vehicle
    that dies is reported at once with its last lines.

    \b
    Examples:
      gcs launch demo
      gcs launch demo --connect udpout:127.0.0.1:14550    QGroundControl finds them by itself
      gcs launch demo --connect tcpin:127.0.0.1:5760      all of them at one TCP port, as of a router

    Without --connect each vehicle listens on 127.0.0.1 at a port that the system chooses. The table printed says where
    to send to: give it to the ground station as it is, e.g. `mavproxy.py --master=udpout:127.0.0.1:41234`.

    \b
    Exit status:
      0    ended by --until-eof
      130  ended by Ctrl-C (143 by SIGTERM)
      1    every vehicle has died
      2    bad input, or vehicles that could not be started
      70   an error of the program itself
    """
    from gcs.session.launch import launch as start

    resolved = load_scenario(scenario, trust=trust, plans=False)
    for sysid, external in resolved.vehicles.external.items():
        click.echo(f"vehicle {sysid} is not launched: it is expected at {external.where}", err=True)
    if not resolved.vehicles.launched:
        raise click.UsageError(f"{scenario} has nothing to launch: all its vehicles are external.")
    click.echo(f"starting {len(resolved.vehicles.launched)} vehicles ...", err=True)
    return start(resolved, out, connect, _print_json if as_json else _print_addresses, until_eof=until_eof)


def _print_json(vehicles: list[dict[str, Any]]) -> None:
    click.echo(json.dumps({"vehicles": vehicles}))


def _print_addresses(vehicles: list[dict[str, Any]]) -> None:
    rows = [("id", "role", "address"), *((str(v["sysid"]), v["role"], v["address"]) for v in vehicles)]
    for sysid, role, where in rows:
        click.echo(f"{sysid:>3}  {role:<7}  {where}")
    click.echo("Ctrl-C ends them.", err=True)
