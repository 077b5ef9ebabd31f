"""The fork server of supervisors: `python -m gcs.session.spawning.fork_server FOLDER`, started by the spawner.

An order is {"sysid": NUMBER, "folder": PATH, "scenario": TEXT, "modules": [...], "every_ms", "log", "given": [...]} for
a session in a folder with `vehicles/`, TEXT being the pickled scenario in base64: the process that writes it has
validated it and has started this one. NUMBER stands in the reports on the session. With an order come descriptors: the
supervisor's standard input, whose end ends its session, its standard output, the socket of the vehicles' fork server,
and one for each name in `given`, which are arguments of gcs.session.process.fly. FOLDER is removed with this process.
`ps` shows `gcs sessions`, and `gcs session` for a supervisor.
"""

from __future__ import annotations

import base64
import pickle
import shutil
import socket
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from setproctitle import setproctitle

from gcs.processes.fork_server import ForkServer
from gcs.session import parent, process, session_process  # noqa: F401 - loaded here, once, for all supervisors
from gcs.session.program import channel, object_client  # noqa: F401
from gcs.supervisor import summarise
from skytender.exit import leave
from skytender.fork_server import Child, serve

ENDS_WITHIN_S = 10.0
"""[choice] For a session that has lost the program that began it, to save what was flown."""


def child_of(order: Mapping[str, Any], descriptors: Sequence[int]) -> Child:
    """The supervisor that an order asks for."""
    stdin, stdout, vehicles, *others = descriptors
    folder, log = Path(order["folder"]), order["log"]
    given = dict(zip(map(str, order["given"]), others, strict=True))
    modules, every_ms = list(map(str, order["modules"])), order["every_ms"]

    def run() -> int:
        server = ForkServer(socket.socket(fileno=vehicles))
        scenario = pickle.loads(base64.b64decode(order["scenario"]))
        return process.fly(folder, scenario=scenario, modules=modules, every_ms=every_ms, server=server, **given)

    log = None if log is None else Path(log)
    return Child(
        {"sysid": int(order["sysid"])},
        "gcs session",
        log,
        run,
        stdin,
        stdout,
        [vehicles, *others],
        patience_s=ENDS_WITHIN_S,
    )


def main() -> None:
    """Entry point."""
    setproctitle("gcs sessions")
    summarise.load()
    try:
        status = serve(child_of)
    finally:
        shutil.rmtree(sys.argv[1], ignore_errors=True)
    leave(status)


if __name__ == "__main__":
    main()
