"""Strangers' software and real vehicle processes for it; `make test` makes its environment, `.venv-peers`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from ports import free_port
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
    """A port of the test's own: peers cannot say which one the system gave them."""
    return free_port()


@pytest.fixture
def fly(tmp_path: Path) -> Iterator[Fly]:
    """`flying` until the test ends."""
    with flying(tmp_path) as start:
        yield start
