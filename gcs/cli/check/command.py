"""Command `gcs check`: tests a vehicle's replies to what MAVSDK, QGroundControl and MAVProxy ask."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import json
import time
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from gcs.cli.options import SECONDS, STATION_OPTION, connect_option, connecting, key_file_option
from gcs.cli.trust import TRUST
from gcs.scenario.endpoint import ONLY_ONCE, Endpoint
from skytender.exit import BAD_INPUT, NOT_DONE

if TYPE_CHECKING:
    from gcs.cli.check.dialogue import CheckFinding, Dialogue

PEER_NAMES = {"mavsdk": "MAVSDK", "qgroundcontrol": "QGroundControl", "mavproxy": "MAVProxy"}


@click.command(short_help="Check a vehicle's MAVLink support, or a scenario's check list.")
@click.argument("scenario", required=False)
@connect_option(
    "Where the vehicle is heard (udpin, tcpin), listens (udpout, tcp) or is plugged in (serial:/dev/ttyUSB0:57600).",
    default="udpin:127.0.0.1:14550",
)
@key_file_option("MAVLink 2 signing: sign every question, and take only answers signed with this key.")
@click.option("--sysid", type=click.IntRange(1, 254), help="The vehicle to ask.  [default: the first that is heard]")
@click.option(
    "--peer",
    "peers",
    multiple=True,
    type=click.Choice(sorted(PEER_NAMES), case_sensitive=False),
    help="Only what this peer asks; may be given again.  [default: all]",
)
@click.option(
    "--arm", is_flag=True, help="Also change the mode, arm and disarm, and take control. Propellers off first."
)
@click.option("--wait", "within", type=SECONDS, default=10.0, show_default=True, help="Seconds to find the vehicle.")
@click.option(
    "--wait-ready",
    type=SECONDS,
    metavar="SECONDS",
    help="At first wait so long until its pre-arm checks pass, as after its start.",
)
@STATION_OPTION
@click.option("--all", "everyone", is_flag=True, help="Every vehicle behind the address, one after the other.")
@click.option("--json", "as_json", is_flag=True, help="One JSON object on stdout, for CI.")
@TRUST
@click.pass_context
def check(
    context: click.Context,
    scenario: str | None,
    connect: Endpoint,
    key_file: Path | None,
    sysid: int | None,
    peers: tuple[str, ...],
    arm: bool,
    within: float,
    wait_ready: float | None,
    station: tuple[int, int],
    everyone: bool,
    as_json: bool,
    trust: bool,
) -> int:
    """Ask a vehicle what MAVSDK, QGroundControl and MAVProxy ask, and name each reply that does not come.

    Any vehicle and any autopilot. Below each finding stands which peer would miss it and what that peer would show. It
    takes about ten seconds where all is well. One parameter is written, with the value that it has; without --arm
    nothing else changes on the vehicle but the rates of its streams.

    With a SCENARIO instead: its check list over its external vehicles, as `gcs run` goes through it before it arms
    them, and no flight. They get the scenario's fence and rally points; no vehicle is armed.

    \b
    Examples:
      gcs check
      gcs check --connect udpin:127.0.0.1:14540 --arm
      gcs check --connect serial:/dev/ttyUSB0:57600 --wait-ready 60
      gcs check --peer qgroundcontrol --json > check.json
      gcs check --connect udpin:0.0.0.0:14550 --all --key-file fleet.key
      gcs check field.yaml --wait-ready 60 --json

    \b
    Outcomes:
      ok       it came
      late     it came slowly, only when it was asked again, or not where peers know to go on; the patient lack nothing
      missing  it never came
      wrong    it came, but not as the peer needs it
      skipped  the question does not apply to this vehicle

    \b
    Exit status:
      0    nothing is missing and nothing is wrong
      1    something is
      2    bad input, or no vehicle was received
      130  stopped by Ctrl-C
    """
    from gcs.cli.check import readiness, report
    from gcs.cli.check.dialogue import Dialogue
    from gcs.cli.check.questions import questions
    from gcs.cli.check.wire import CheckError, Wire
    from gcs.cli.check.wire import check as run

    if scenario is not None:
        return _check_scenario(context, scenario, wait_ready or 0.0, as_json=as_json, trust=trust)
    if everyone and sysid is not None:
        raise click.UsageError("--all and --sysid exclude each other.")
    names = [PEER_NAMES[peer] for peer in peers] or list(PEER_NAMES.values())
    signed = key_file is not None
    asked = questions(names, arm=arm, ready_within_s=wait_ready, now_unix_s=time.time, signed=signed)
    with connecting():
        wire = Wire(connect, key_file, station)
    done: list[Dialogue] = []
    waiting: list[int | None] = [sysid]
    try:
        click.echo(f"waiting for a HEARTBEAT at {connect.text} ...", err=True)
        while waiting:
            dialogue = Dialogue(asked, waiting.pop(0), station)
            shown = partial(_show, dialogue, len(asked), as_json)
            run(dialogue, wire, shown, find_within_s=within)
            done.append(dialogue)
            checked = {one.vehicle.sysid for one in done if one.vehicle is not None}
            if everyone:
                waiting = [*sorted(set().union(*(one.others for one in done)) - checked)]
    except CheckError as error:
        hint = ONLY_ONCE if connect.way == "udpout" else ""
        why = error.why or f"; is the vehicle running, and is that its address?{hint}"
        click.echo(f"gcs: {error} at {connect.text}{why}", err=True)
        return BAD_INPUT
    finally:
        wire.close()
    passed = all(report.passed(one.findings) for one in done)
    if as_json:
        found = [report.as_json(one.vehicle, one.others, one.findings) for one in done if one.vehicle is not None]
        click.echo(json.dumps({"passed": passed, "vehicles": found} if everyone else found[0]))
    elif done[0].others and not everyone:
        also = ", ".join(map(str, sorted(done[0].others)))
        click.echo(f"also heard: vehicle {also}; choose with --sysid, or --all")
    for said in filter(None, map(readiness.hint, () if wait_ready is not None else done)):
        click.echo(said, err=as_json)
    return 0 if passed else NOT_DONE


def _check_scenario(context: click.Context, name: str, ready_within_s: float, *, as_json: bool, trust: bool) -> int:
    """Go through a scenario's check list; the exit status."""
    from gcs.cli.author import load_scenario
    from gcs.cli.check import scenario as lists
    from gcs.link.socket import AddressRefused
    from skytender.key_files import KeyRefused

    given = click.core.ParameterSource.COMMANDLINE
    for option in ("connect", "key_file", "sysid", "peers", "arm", "within", "station", "everyone"):
        if context.get_parameter_source(option) is given:
            flag = {"peers": "peer", "everyone": "all"}.get(option, option).replace("_", "-")
            raise click.UsageError(
                f"--{flag} is for a check without a scenario: the scenario names vehicles and addresses."
            )
    loaded = load_scenario(name, trust=trust, plans=False)
    if not loaded.vehicles.external:
        raise click.UsageError(f"{name} has no external vehicle to check; `gcs validate` checks the scenario itself.")
    try:
        found = lists.check_scenario(loaded, lambda text: click.echo(text, err=True), ready_within_s=ready_within_s)
    except (AddressRefused, KeyRefused) as error:
        raise click.ClickException(f"{error}.") from None
    content = lists.as_json(loaded, found)
    click.echo(json.dumps(content) if as_json else "\n".join(lists.lines(content)))
    return 0 if content["passed"] else NOT_DONE


def _show(dialogue: Dialogue, questions: int, as_json: bool, finding: CheckFinding) -> None:
    """Tell a finding that has come; before the first whose it is, and after the last the number of all."""
    from gcs.cli.check import report

    if finding is dialogue.findings[0] and dialogue.vehicle is not None:
        who = f"vehicle {dialogue.vehicle.sysid}, {dialogue.vehicle.profile.name}"
        click.echo(f"{who}: {questions} questions", err=as_json)
    if as_json:
        return
    click.echo(report.line(finding))
    if finding is dialogue.findings[-1] and dialogue.done:
        counts = report.counted(dialogue.findings)
        click.echo(", ".join(f"{number} {outcome}" for outcome, number in counts.items() if number))
