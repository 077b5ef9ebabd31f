"""The supervisor as a process: `python -m gcs.session.process FOLDER`, started by `gcs run`
(docs/protocol.md#processes).

Reads FOLDER/scenario.yaml, starts the vehicles, runs the session and leaves its files in FOLDER. It ends when its stdin
closes. stdout carries two JSON lines: {"listening": true}, and {"exit", "outcome", "error"} at the end.
"""

from __future__ import annotations

import contextlib
import os
import signal
import traceback
from collections.abc import Sequence
from pathlib import Path

import click

from gcs.link.keys import KeyRefused
from gcs.link.socket import AddressRefused
from gcs.processes import plugin_process
from gcs.processes.hatch import Hatch, LaunchError
from gcs.recording.recorder import RecorderError
from gcs.scenario.file import load
from gcs.scenario.model import Scenario, ScenarioError
from gcs.session.arrival import BadVehicleError, SessionFailed
from gcs.session.ordered import Ordered
from gcs.session.server import Reader
from gcs.session.session_process import SessionProcess, say
from skytender.exit import BAD_INPUT, INTERNAL_ERROR, NOT_DONE, leave

ELSEWHERE = "Free space there, or give --out another place."


@click.command()
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False, exists=True))
@click.option("--drop-datagrams", type=click.FloatRange(0.0, 0.9), default=0.0)
@click.option("--modules", multiple=True)
@click.option("--reader", type=int, default=None)
@click.option("--every-ms", type=int, default=None)
def main(
    folder: Path,
    drop_datagrams: float,
    modules: tuple[str, ...],
    reader: int | None,
    every_ms: int | None,
) -> None:
    """Run the session in FOLDER (scenario.yaml is there); started by `gcs run`."""
    leave(fly(folder, drop=drop_datagrams, modules=modules, reader=reader, every_ms=every_ms))


def fly(
    folder: Path,
    *,
    drop: float = 0.0,
    modules: Sequence[str] = (),
    reader: int | None = None,
    every_ms: int | None = None,
    scenario: Scenario | None = None,
    hatch: Hatch | None = None,
    ordered: Ordered | None = None,
) -> int:
    """Fly the session in `folder` in this process and say its last word; the exit status.

    scenario: instead of what the folder's scenario.yaml says.
    hatch: one that is running already and goes on afterwards, instead of one of the session's own.
    ordered: what that hatch has been told to start already.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.set_blocking(0, False)
    status, outcome, error = INTERNAL_ERROR, "", None
    try:
        scenario = scenario or load(folder / "scenario.yaml")
        with plugin_process.started(scenario, modules, folder, parent=0) as plugins:
            session = SessionProcess(folder, scenario, drop=drop, hatch=hatch, ordered=ordered, plugins=plugins)
            signal.signal(signal.SIGTERM, session.terminate)
            if reader is not None:
                session.reader = Reader(reader, every_ms or round(1e3 * scenario.clock.period_s))
            status, outcome = session.run()
    except (ScenarioError, BadVehicleError, AddressRefused, KeyRefused) as problem:
        status, error = BAD_INPUT, str(problem)
    except RecorderError as problem:
        status, error = NOT_DONE, f"{problem} What was flown until then is kept. {ELSEWHERE}"
    except (SessionFailed, LaunchError) as problem:
        status, error = NOT_DONE, str(problem)
    except OSError as problem:
        status, error = NOT_DONE, f"{problem.filename or folder}: {problem.strerror}; give --out another place"
    except Exception:
        log = folder / "supervisor.log"
        with contextlib.suppress(OSError):
            log.write_text(traceback.format_exc(), encoding="utf-8")
        error = f"this is a bug of the supervisor: please report it with {log}"
    say({"exit": status, "outcome": outcome, "error": error})
    return status


if __name__ == "__main__":
    main()
