"""Real vehicle processes that climb, land and return fast, for strangers' software."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import yaml

QUICK = {"MPC_TKO_SPEED": 3.0, "MPC_LAND_SPEED": 1.5, "RTL_RETURN_ALT": 1.0}

Fly = Callable[..., None]


@contextmanager
def flying(folder: Path) -> Iterator[Fly]:
    """`fly(port, sysid, *argv)` starts a vehicle that speaks to a port, or to an address; it must live until the
    context ends."""
    params = folder / "quick.yaml"
    params.write_text(yaml.safe_dump(QUICK))
    program = [sys.executable, "-c", "from simvehicle.cli import main; main()", "--params", str(params)]
    started: list[subprocess.Popen[bytes]] = []

    def start(where: int | str, sysid: int = 1, *argv: str) -> None:
        to = where if isinstance(where, str) else f"udpout:127.0.0.1:{where}"
        argv = (*program, "--sysid", str(sysid), "--connect", to, *argv)
        started.append(stack.enter_context(subprocess.Popen(argv, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)))

    with ExitStack() as stack:
        try:
            yield start
            ended = [vehicle.poll() for vehicle in started]
        finally:
            for vehicle in started:
                vehicle.kill()
        said = [vehicle.stderr.read() for vehicle in started if vehicle.stderr is not None]
    assert ended == [None] * len(started)
    assert said == [b""] * len(said)
