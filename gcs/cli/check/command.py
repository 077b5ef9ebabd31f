"""Command `gcs check`: tests a vehicle's replies to what MAVSDK, QGroundControl and MAVProxy ask."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import json
from pathlib import Path

import click

from gcs.cli.options import connecting, endpoint
from gcs.exit import BAD_INPUT, NOT_DONE
from gcs.scenario.endpoint import ONLY_ONCE, Endpoint

PEER_NAMES = {"mavsdk": "MAVSDK", "qgroundcontrol": "QGroundControl", "mavproxy": "MAVProxy"}


@click.command(short_help="Check what a vehicle would make its ground stations miss.")
@click.option(
    "--connect",
    default="udpin:127.0.0.1:14550",
    show_default=True,
    callback=endpoint,
    metavar="ADDRESS",
    help="Where the vehicle is heard (udpin, tcpin), listens (udpout, tcp) or is plugged in "
    "(serial:/dev/ttyUSB0:57600).",
)
@click.option(
    "--key-file",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="MAVLink 2 signing: sign every question, and take only answers signed with this key.",
)
@click.option("--sysid", type=click.IntRange(1, 254), help="The vehicle to ask.  [default: the first that is heard]")
@click.option(
    "--peer",
    "peers",
    multiple=True,
    type=click.Choice(sorted(PEER_NAMES), case_sensitive=False),
    help="Only what this peer asks; may be given again.  [default: all]",
)
@click.option("--arm", is_flag=True, help="Also change the mode, arm and disarm. Take the propellers off first.")
@click.option(
    "--within", type=click.FloatRange(0.1), default=10.0, show_default=True, help="Seconds to find the vehicle."
)
@click.option(
    "--wait-ready",
    type=click.FloatRange(0.1),
    metavar="SECONDS",
    help="At first wait so long until its pre-arm checks pass, as after its start.",
)
@click.option("--json", "as_json", is_flag=True, help="One JSON object on stdout, for CI.")
def check(
    connect: Endpoint,
    key_file: Path | None,
    sysid: int | None,
    peers: tuple[str, ...],
    arm: bool,
    within: float,
    wait_ready: float | None,
    as_json: bool,
) -> int:
    """Ask a vehicle what MAVSDK, QGroundControl and MAVProxy ask, and name each reply that does not come.

    Any vehicle and any autopilot. Below each finding stands which peer would miss it and what that peer would show. It
    takes about ten seconds where all is well. One parameter is written, with the value that it has; without --arm
    nothing else changes on the vehicle but the rates of its streams.

    \b
    Examples:
      gcs check
      gcs check --connect udpin:127.0.0.1:14540 --arm
      gcs check --connect serial:/dev/ttyUSB0:57600 --wait-ready 60
      gcs check --peer qgroundcontrol --json > check.json

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
    from gcs.cli.check import report
    from gcs.cli.check.dialogue import CheckFinding, Dialogue
    from gcs.cli.check.questions import questions
    from gcs.cli.check.wire import CheckError, Wire
    from gcs.cli.check.wire import check as run

    names = [PEER_NAMES[peer] for peer in peers] or list(PEER_NAMES.values())
    asked = questions(names, arm=arm, ready_within_s=wait_ready)
    dialogue = Dialogue(asked, sysid)
    known = False

    def show(finding: CheckFinding) -> None:
        nonlocal known
        if not known and dialogue.vehicle is not None:
            known = True
            who = f"vehicle {dialogue.vehicle.sysid}, {dialogue.vehicle.profile.name}"
            click.echo(f"{who}: {len(asked)} questions", err=as_json)
        if not as_json:
            click.echo(report.line(finding))

    with connecting():
        wire = Wire(connect, key_file)
    try:
        click.echo(f"waiting for a HEARTBEAT at {connect.text} ...", err=True)
        run(dialogue, wire, show, find_within_s=within)
    except CheckError as error:
        hint = ONLY_ONCE if connect.way == "udpout" else ""
        why = error.why or f"; is the vehicle running, and is that its address?{hint}"
        click.echo(f"gcs: {error} at {connect.text}{why}", err=True)
        return BAD_INPUT
    finally:
        wire.close()
    assert dialogue.vehicle is not None
    if as_json:
        click.echo(json.dumps(report.as_json(dialogue.vehicle, dialogue.others, dialogue.findings)))
    else:
        counts = report.counted(dialogue.findings)
        click.echo(", ".join(f"{number} {outcome}" for outcome, number in counts.items() if number))
        if dialogue.others:
            also = ", ".join(map(str, sorted(dialogue.others)))
            click.echo(f"also heard: vehicle {also}; choose with --sysid")
    return 0 if report.passed(dialogue.findings) else NOT_DONE
