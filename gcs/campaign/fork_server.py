"""The fork server of supervisors: `python -m gcs.campaign.fork_server FOLDER`, started by gcs/campaign/spawner.py.

An order is {"folder": PATH, "scenario": TEXT, "modules": [...]} for a session in a folder with `vehicles/`, TEXT being
the pickled scenario in base64: the process that writes it has validated it and has started this one. With it come two
descriptors: the supervisor's standard input, whose end ends its session, and the socket of the vehicles' fork server.
The supervisor's output is `output.log` in that folder. FOLDER is removed with this process. `ps` shows `gcs sessions`,
and `gcs session` for a supervisor.
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
from gcs.supervisor import summarise
from skytender.exit import leave
from skytender.fork_server import Child, serve

OUTPUT = "output.log"


def child_of(order: Mapping[str, Any], descriptors: Sequence[int]) -> Child:
    """The supervisor that an order asks for."""
    stdin, vehicles = descriptors
    folder = Path(order["folder"])
    scenario, modules = order["scenario"], list(map(str, order["modules"]))

    def run() -> int:
        server = ForkServer(socket.socket(fileno=vehicles))
        return process.fly(folder, scenario=pickle.loads(base64.b64decode(scenario)), modules=modules, server=server)

    return Child({}, "gcs session", folder / OUTPUT, run, stdin, keep=(vehicles,))


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
