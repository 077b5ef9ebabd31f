"""The supervisor as a process: `python -m gcs.session.process FOLDER`, started by `gcs run`
(docs/protocol/processes.md#processes).

Reads FOLDER/scenario.yaml, starts the vehicles, runs the session and leaves its files in FOLDER. It ends when its stdin
closes. stdout carries two JSON lines: {"listening": true}, and {"exit", "outcome", "error"} at the end.
"""

from __future__ import annotations

import contextlib
import os
import signal
from collections.abc import Sequence
from pathlib import Path

import click

from gcs.processes import plugin_process
from gcs.processes.fork_server import ForkServer
from gcs.scenario.file import load
from gcs.scenario.model import Scenario
from gcs.scenario.plugins import clients
from gcs.session.own_vehicles import OwnVehicles
from skytender.exit import INTERNAL_ERROR, leave
from skytender.loading import uncollected


@click.command()
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False, exists=True))
@click.option("--drop-datagrams", type=click.FloatRange(0.0, 0.9), default=0.0)
@click.option("--modules", multiple=True)
@click.option("--program", type=int, default=None)
@click.option("--every-ms", type=int, default=None)
@click.option("--objects", type=int, default=None)
def main(
    folder: Path,
    drop_datagrams: float,
    modules: tuple[str, ...],
    program: int | None,
    every_ms: int | None,
    objects: int | None,
) -> None:
    """Run the session in FOLDER (scenario.yaml is there); started by `gcs run`."""
    leave(fly(folder, drop=drop_datagrams, modules=modules, program=program, every_ms=every_ms, objects=objects))


def fly(
    folder: Path,
    *,
    drop: float = 0.0,
    modules: Sequence[str] = (),
    program: int | None = None,
    every_ms: int | None = None,
    objects: int | None = None,
    scenario: Scenario | None = None,
    server: ForkServer | None = None,
) -> int:
    """Fly the session in `folder` in this process and say its last word; the exit status.

    program, every_ms: descriptor of the channel of a program that steps the session, and how often it wants snapshots.
    objects: descriptor on which its own planner and policy are asked. scenario: instead of what the folder's
    scenario.yaml says. server: the vehicles' fork server, where one runs.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.set_blocking(0, False)
    status, error = INTERNAL_ERROR, None
    vehicles: OwnVehicles | None = None
    session = None
    try:
        scenario = scenario or load(folder / "scenario.yaml")
        vehicles = OwnVehicles(scenario, folder, drop, server)
        with uncollected(for_good=True):
            from gcs.session.session_process import SessionProcess  # noqa: PLC0415 - the vehicles come up meanwhile

        with plugin_process.started(scenario, modules, folder, parent=0) as process, contextlib.ExitStack() as stack:
            plugins = clients(scenario, process)
            if objects is not None:
                from gcs.session.program.object_client import ObjectClient  # noqa: PLC0415 - most sessions have none

                own = stack.enter_context(contextlib.closing(ObjectClient(objects, scenario)))
                plugins.update(dict.fromkeys(own.keys, own))
            session = SessionProcess(folder, scenario, vehicles, plugins=plugins)
            signal.signal(signal.SIGTERM, session.terminate)
            if program is not None:
                from gcs.session.program.channel import Program  # noqa: PLC0415 - most sessions have none

                lockstep = scenario.clock.mode == "lockstep"
                session.program = Program(program, every_ms or round(1e3 * scenario.clock.period_s), lockstep=lockstep)
            status = session.run()
            error = session.error
    except Exception as problem:
        from gcs.session.parent import explained  # noqa: PLC0415 - knows the errors of all that flies

        status, error = explained(problem, folder, begun=session is not None and session.begun)
    finally:
        if vehicles is not None:
            vehicles.end()
    from gcs.session.parent import say  # noqa: PLC0415

    say({"exit": status, "outcome": None if session is None else session.outcome, "error": error})
    return status


if __name__ == "__main__":
    main()
