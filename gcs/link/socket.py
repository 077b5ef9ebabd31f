"""Sockets at the addresses that people write, and what the kernel grants and loses of them."""

from __future__ import annotations

import errno
import socket
import struct
from typing import Any

from gcs.scenario.endpoint import Endpoint

RECEIVE_BYTES = 4096
"""Longer datagrams are cut: no MAVLink sender makes any."""
MOST_AT_ONCE = 4096
"""Datagrams of one socket that are taken in before anything else has its turn."""
BUFFER_BYTES = 4 << 20
_ADVICE = {
    errno.EADDRINUSE: "; another program listens there: end it, or let it forward to another port",
    errno.EADDRNOTAVAIL: "; this machine has no such address: 0.0.0.0 listens at all that it has",
}

# Linux, asm-generic/socket.h and linux/sock_diag.h: nine numbers of a socket's memory, the last what it dropped.
_SO_MEMINFO = 55
_MEMORY, _DROPS = struct.Struct("9I"), 8

Where = tuple[Any, ...]
"""As `socket` gives it: host and port, and two more numbers with IPv6."""


class AddressRefused(Exception):
    """An address that cannot be had here; one sentence: which, why and, where that helps, what to do."""


def resolve(at: Endpoint, kind: socket.SocketKind = socket.SOCK_DGRAM) -> tuple[socket.AddressFamily, Where]:
    """The family and the numbers of an address. Raises AddressRefused where its host cannot be found."""
    try:
        family, _, _, _, where = socket.getaddrinfo(at.host, at.port, type=kind)[0]
    except (OSError, UnicodeError) as error:
        reason = getattr(error, "strerror", None) or "it is no name of a host"
        raise AddressRefused(f"{at.text}: the host {at.host} cannot be found: {reason}") from None
    return family, where


def open_udp(at: Endpoint) -> tuple[socket.socket, Where]:
    """A socket that never waits, with as large a receive buffer as is granted, and the numbers of `at`.

    It listens there for udpin; for udpout it has a free port and receives from any sender to that. Raises
    AddressRefused.
    """
    family, where = resolve(at)
    made = socket.socket(family, socket.SOCK_DGRAM)
    try:
        made.setblocking(False)
        widen(made)
        made.bind(where if at.way == "udpin" else ("::" if family == socket.AF_INET6 else "", 0))
    except OSError as error:
        made.close()
        raise refused_to_listen(at, error) from None
    return made, where


def refused_to_listen(at: Endpoint, error: OSError) -> AddressRefused:
    """Error to raise where an address cannot be listened at."""
    advice = _ADVICE.get(error.errno or 0, "")
    return AddressRefused(f"{at.text} cannot be listened at: {error.strerror}{advice}")


def widen(of: socket.socket) -> None:
    """Ask the kernel for as much of a receive buffer as it grants, up to 4 MiB."""
    for size in (BUFFER_BYTES, BUFFER_BYTES // 4, BUFFER_BYTES // 16):
        of.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, size)
        if of.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) // 2 >= size:
            break


def kernel_drops(of: socket.socket) -> int:
    """Datagrams that the kernel dropped because this socket was not read in time; 0 where the kernel does not say."""
    try:
        return _MEMORY.unpack(of.getsockopt(socket.SOL_SOCKET, _SO_MEMINFO, _MEMORY.size))[_DROPS]
    except (OSError, struct.error):
        return 0
