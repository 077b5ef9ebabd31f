"""The vehicle's only sockets: plain connections to anyone, and the supervised link."""

from __future__ import annotations

import errno
import re
import socket
from typing import NamedTuple, Self

from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.connection import Connection

RECEIVE_BYTES = 65535
MAGICS = (b"\xfd", b"\xfe")
MOST_PEERS = 32
"""A udpin link answers this many, those who spoke last."""
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
        example = "write udpout:HOST:PORT or udpin:HOST:PORT, e.g. udpout:127.0.0.1:14550"
        raise AddressError(f"'{text}' is no connection; {example}")
    return Address(match[1], match[2].strip("[]"), int(match[3]))


def parse_supervisor(text: str) -> Address:
    """Read the supervisor's address, `udpout:HOST:PORT`: a vehicle speaks to it first. Raises AddressError."""
    address = parse_address(text)
    if address.kind != "udpout":
        spoken_to = f"udpout:{address.host}:{address.port or 'PORT'}"
        raise AddressError(
            f"'{text}' waits for others, but a vehicle speaks to its supervisor first: write {spoken_to}"
        )
    return address


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
        reason = "the port is in use" if error.errno == errno.EADDRINUSE else error.strerror or str(error)
        raise AddressError(f"cannot use {address}: {reason}") from error
    return made


class _Link:
    """A socket with a connection on it; its context's end closes the socket."""

    def __init__(self, address: Address, connection: Connection) -> None:
        self.connection = connection
        self.socket = open_socket(address)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()


class PlainLink(_Link):
    """Plain MAVLink for whoever is there, one frame per datagram; udpin answers everyone who spoke MAVLink to it."""

    def __init__(self, address: Address, connection: Connection) -> None:
        super().__init__(address, connection)
        self.address = address
        self._peers: dict[tuple[str, int], None] = {}

    @property
    def port(self) -> int:
        """The local port."""
        return int(self.socket.getsockname()[1])

    def receive(self) -> list[ReceivedFrame]:
        """Every intact frame that has come; whoever sent something like one is answered from now on.

        Ground stations that know both begin with MAVLink 1 and change when they receive MAVLink 2.
        """
        frames: list[ReceivedFrame] = []
        while True:
            try:
                datagram, peer = self.socket.recvfrom(RECEIVE_BYTES)
            except ConnectionError:
                continue
            except OSError:
                return frames
            frames += split(datagram)
            if datagram[:1] in MAGICS:
                self._peers.pop(peer, None)
                self._peers[peer] = None
                if len(self._peers) > MOST_PEERS:
                    del self._peers[next(iter(self._peers))]

    def flush(self) -> None:
        """Send what waits on the connection; frames without a receiver are dropped."""
        for frame in self.connection.frames():
            try:
                if self.address.kind == "udpout":
                    self.socket.send(frame)
                else:
                    for peer in self._peers:
                        self.socket.sendto(frame, peer)
            except OSError:
                continue


class SupervisedLink(_Link):
    """The link to the supervisor: whole datagrams, to and from its address only."""

    @property
    def waiting(self) -> bool:
        """Whether a datagram has come that was not received yet."""
        try:
            self.socket.recv(1, socket.MSG_PEEK)
        except OSError:
            return False
        return True

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
