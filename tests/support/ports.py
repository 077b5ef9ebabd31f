"""Ports for programs that must know a port before either end has opened it.

The kernel gives a port of its own range to every socket that asks for none, vehicles' too. A port of that range may be
given away between the moment it is found free and the moment the program opens it; a port outside may not.
"""

from __future__ import annotations

import functools
import itertools
import os
import socket
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

# Above the ports that MAVLink's programs open by default.
_LOWEST, _HIGHEST = 15_000, 65_535


@functools.cache
def _ports() -> tuple[int, Iterator[int]]:
    """How many are this worker's, and all of them again and again; of the process that asks first, for a worker may be
    a fork of one that has imported this."""
    worker = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw"))
    workers = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    first, last = map(int, Path("/proc/sys/net/ipv4/ip_local_port_range").read_text().split())
    ports = [n for n in range(_LOWEST, _HIGHEST + 1) if not first <= n <= last and n % workers == worker]
    # Two runs beside each other begin at different places; none is given twice, since a vehicle of the test before may
    # still speak to it.
    return len(ports), itertools.islice(itertools.cycle(ports), os.getpid() % len(ports), None)


def free_port(host: str = "127.0.0.1") -> int:
    """A port that neither UDP nor TCP has open at `host`, for this test alone."""
    count, left = _ports()
    for port in itertools.islice(left, count):
        with ExitStack() as opened:
            try:
                for kind in (socket.SOCK_DGRAM, socket.SOCK_STREAM):
                    one = opened.enter_context(socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, kind))
                    one.bind((host, port))
            except OSError:
                continue
            return port
    raise OSError("every port outside the kernel's own range is in use")
