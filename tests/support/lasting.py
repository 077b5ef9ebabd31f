"""The vehicles' fork servers of sessions that are flown in this process, forked from one that it keeps.

As campaigns and environments do it (docs/protocol/processes.md#processes): loading the vehicles is a third of what a
short session costs. Where a test has changed the environment, the session starts a fork server of its own.
"""

from __future__ import annotations

import contextlib
import functools
import os
import socket
from collections.abc import Iterator
from unittest import mock

from gcs.processes.fork_server import ForkServer
from gcs.session import process, session_process  # noqa: F401 - what each fork of this process would load

START = ForkServer.of_vehicles
PYTEST = "PYTEST_CURRENT_TEST"


def _surroundings() -> tuple[dict[str, str], str]:
    return {name: value for name, value in os.environ.items() if name != PYTEST}, os.getcwd()


@functools.cache
def _kept() -> tuple[ForkServer, tuple[dict[str, str], str]]:
    """It ends with this process."""
    return START(), _surroundings()


def _forked() -> ForkServer:
    kept, surroundings = _kept()
    if surroundings != _surroundings():
        return START()
    ours, theirs = socket.socketpair()
    with theirs:
        kept.start([{"argv": ["fork-server"]}], [theirs.fileno()])
    kept.events()
    return ForkServer(ours)


@contextlib.contextmanager
def lasting() -> Iterator[None]:
    """Fork the vehicles' fork servers of what is run in here."""
    with mock.patch.object(ForkServer, "of_vehicles", _forked):
        yield
