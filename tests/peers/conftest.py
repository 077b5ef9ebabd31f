"""Strangers' software and real vehicle processes for it; `make test` makes its environment, `.venv-peers`."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
from quick_vehicles import Fly, flying

ROOT = Path(__file__).resolve().parents[2]
PEERS = ROOT / ".venv-peers"


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
    """`flying` until the test ends."""
    with flying(tmp_path) as start:
        yield start
