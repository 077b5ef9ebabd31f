"""The vehicle's only sockets: plain connections to anyone, and the supervised link."""

from __future__ import annotations

import re
import socket
from typing import NamedTuple

from simvehicle.mavlink.connection import Connection

RECEIVE_BYTES = 65535
_ADDRESS = re.compile(r"(udpin|udpout):(\[[0-9A-Fa-f:.]+\]|[^:\s]+):(\d{1,5})")


class AddressError(ValueError):
    """A connection string that is none, or an address that cannot be used; the text says which and why."""


class Address(NamedTuple):
    """A parsed connection string: `udpin` waits for others, `udpout` speaks first."""

    kind: str
    host: str
    port: int

    def __str__(self) -> str:
        return f"{self.kind}:{self.host}:{self.port}"


def parse_address(text: str) -> Address:
    """Read `udpin:HOST:PORT` or `udpout:HOST:PORT`; raises AddressError."""
    match = _ADDRESS.fullmatch(text)
    if match is None or int(match[3]) > 65535 or (match[1] == "udpout" and int(match[3]) == 0):
        raise AddressError(f"'{text}' is no connection; write udpout:HOST:PORT or udpin:HOST:PORT, e.g. udpout:127.0.0.1:14550")
    return Address(match[1], match[2].strip("[]"), int(match[3]))


def open_socket(address: Address) -> socket.socket:
    """A non-blocking UDP socket, bound for udpin and connected for udpout; raises AddressError."""
    try:
        family = socket.getaddrinfo(address.host, address.port, type=socket.SOCK_DGRAM)[0][0]
        made = socket.socket(family, socket.SOCK_DGRAM)
    except OSError as error:
        raise AddressError(f"cannot use {address}: {error.strerror or error}") from error
    try:
        made.setblocking(False)
        if address.kind == "udpin":
            made.bind((address.host, address.port))
        else:
            made.connect((address.host, address.port))
    except OSError as error:
        made.close()
        reason = "the port is in use" if error.errno == 98 else error.strerror or str(error)
        raise AddressError(f"cannot use {address}: {reason}") from error
    return made


class PlainLink:
    """Plain MAVLink for whoever is there, one frame per datagram; a udpin link answers everyone who wrote to it."""

    def __init__(self, address: Address, connection: Connection) -> None:
        self.address = address
        self.connection = connection
        self.socket = open_socket(address)
        self._peers: dict[tuple[str, int], None] = {}

    @property
    def port(self) -> int:
        """The local port."""
        return int(self.socket.getsockname()[1])

    def receive(self) -> list[bytes]:
        """Every datagram that has come."""
        datagrams = []
        while True:
            try:
                datagram, peer = self.socket.recvfrom(RECEIVE_BYTES)
            except BlockingIOError:
                return datagrams
            except OSError:
                continue
            datagrams.append(datagram)
            self._peers.setdefault(peer)

    def flush(self) -> None:
        """Send what waits on the connection; frames with nobody to hear them are dropped."""
        for frame in self.connection.frames():
            try:
                if self.address.kind == "udpout":
                    self.socket.send(frame)
                else:
                    for peer in self._peers:
                        self.socket.sendto(frame, peer)
            except OSError:
                continue


class SupervisedLink:
    """The link to the supervisor: whole datagrams, to and from its address only."""

    def __init__(self, address: Address, connection: Connection) -> None:
        self.connection = connection
        self.socket = open_socket(address)

    def receive(self) -> bytes | None:
        """The next datagram, or None."""
        try:
            return self.socket.recv(RECEIVE_BYTES)
        except OSError:
            return None

    def send(self, datagrams: list[bytes]) -> None:
        """Send; a supervisor that is not there (yet) is no error."""
        for datagram in datagrams:
            try:
                self.socket.send(datagram)
            except OSError:
                return
