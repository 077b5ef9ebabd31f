"""Strangers' software and real vehicle processes for it; `make test` makes its environment, `.venv-peers`."""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PEERS = ROOT / ".venv-peers"
QUICK = {"MPC_TKO_SPEED": 3.0, "MPC_LAND_SPEED": 1.5, "RTL_RETURN_ALT": 1.0}

Fly = Callable[..., None]


@pytest.fixture(scope="session")
def peers() -> Path:
    """The folder of the peers' programs."""
    missing = PEERS / "missing"
    if missing.exists():
        pytest.skip(missing.read_text(encoding="utf-8").strip())
    if not (PEERS / ".ready").exists():
        pytest.skip("MAVSDK and MAVProxy are not installed: call make test")
    return PEERS / "bin"


@pytest.fixture
def port() -> int:
    """A UDP port that was free a moment ago: peers cannot say which one the system gave them."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@pytest.fixture
def fly(tmp_path: Path) -> Iterator[Fly]:
    """`fly(port, sysid, *argv)` starts a vehicle that speaks to a port, or to an address; it must live until the test
    ends."""
    params = tmp_path / "quick.yaml"
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
