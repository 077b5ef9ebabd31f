"""Ports for programs that must know a port before either end has opened it.

The kernel gives a port of its own range to every socket that asks for none, vehicles' too. A port of that range may be
given away between the moment it is found free and the moment the program opens it; a port outside may not.
"""

from __future__ import annotations

import itertools
import os
import socket
from contextlib import ExitStack
from pathlib import Path

_WORKER, _WORKERS = (
    int(os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw")),
    int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1")),
)
# Above the ports that MAVLink's programs open by default.
_LOWEST, _HIGHEST = 15_000, 65_535
_KERNELS_FIRST, _KERNELS_LAST = map(int, Path("/proc/sys/net/ipv4/ip_local_port_range").read_text().split())
_PORTS = [
    port
    for port in range(_LOWEST, _HIGHEST + 1)
    if not _KERNELS_FIRST <= port <= _KERNELS_LAST and port % _WORKERS == _WORKER
]
# Two runs beside each other begin at different places; none is given twice, since a vehicle of the test before may
# still speak to it.
_left = itertools.islice(itertools.cycle(_PORTS), os.getpid() % len(_PORTS), None)


def free_port(host: str = "127.0.0.1") -> int:
    """A port that neither UDP nor TCP has open at `host`, for this test alone."""
    for port in itertools.islice(_left, len(_PORTS)):
        with ExitStack() as opened:
            try:
                for kind in (socket.SOCK_DGRAM, socket.SOCK_STREAM):
                    one = opened.enter_context(socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, kind))
                    one.bind((host, port))
            except OSError:
                continue
            return port
    raise OSError("every port outside the kernel's own range is in use")
