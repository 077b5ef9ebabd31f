"""The vehicle's only sockets: plain connections to anyone, and the supervised link."""

from __future__ import annotations

import encodings.idna  # noqa: F401 - getaddrinfo needs it: it is shared by processes that are forked later
import errno
import re
import socket
import struct
import time
from collections.abc import Callable
from typing import NamedTuple, Self

from simvehicle.mavlink.codec import ReceivedFrame, speaks_mavlink_1, split
from simvehicle.mavlink.connection import Connection
from simvehicle.sitl.keys import Keyring
from skytender.exit import STANDARD_OUTPUT

RECEIVE_BYTES = 2048
"""Longer datagrams are cut: MAVLink has none."""
SUPERVISED_BYTES = 16_384
"""Those of a supervisor to several vehicles are longer."""
MOST_AT_ONCE = 256
"""Datagrams of one link that are taken in before anything else has its turn."""
MOST_PEERS = 32
"""A udpin link answers this many."""
PEER_SILENT_S = 10.0
"""A peer that has been silent for so long is answered no more: a ground station sends HEARTBEAT every second."""
LAST_PORT = 65535
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
    if match is None or int(match[3]) > LAST_PORT or (match[1] == "udpout" and int(match[3]) == 0):
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


def time_of(seconds: float) -> bytes:
    """A `struct timeval`, as SO_RCVTIMEO takes it."""
    whole = int(seconds)
    return struct.pack("ll", whole, round(1e6 * (seconds - whole)))


class _Link:
    """A socket; its context's end closes it."""

    def __init__(self, address: Address) -> None:
        self.socket = open_socket(address)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()


class PlainLink(_Link):
    """Plain MAVLink for all peers, one frame per datagram; udpin answers those that sent MAVLink lately.

    The peer that has spoken for longest keeps its place: newcomers are not answered while there is none free.
    """

    def __init__(
        self,
        address: Address,
        connection: Connection,
        clock: Callable[[], float] = time.monotonic,
        *,
        keyring: Keyring | None = None,
        link_id: int = 0,
    ) -> None:
        super().__init__(address)
        self.address, self.connection = address, connection
        self._keyring = keyring or Keyring(connection.sysid)
        self._link_id = link_id
        self._clock = clock
        self._peers: dict[tuple[str, int], float] = {}
        """when each was heard last, in s of the wall"""

    @property
    def port(self) -> int:
        """The local port."""
        return int(self.socket.getsockname()[1])

    def announce(self) -> None:
        """Say on standard output where the vehicle is. Raises OSError, which names that."""
        try:
            print(f"vehicle {self.connection.sysid}: {self.address} (local port {self.port})", flush=True)
        except OSError as error:
            raise OSError(error.errno, error.strerror, STANDARD_OUTPUT) from None

    def receive(self) -> list[ReceivedFrame]:
        """The intact frames that have come, of MOST_AT_ONCE datagrams at most; their senders are answered from now on.

        Ground stations that know both begin with MAVLink 1 and change when they receive MAVLink 2.
        """
        frames: list[ReceivedFrame] = []
        now_s = self._clock()
        for _ in range(MOST_AT_ONCE):
            try:
                datagram, peer = self.socket.recvfrom(RECEIVE_BYTES)
            except ConnectionError:
                continue
            except OSError:
                break
            received = self._keyring.accepted(list(split(datagram)))
            frames += received
            if (received or self._is_old_speaker(datagram)) and (peer in self._peers or self._has_room(now_s)):
                self._peers[peer] = now_s
        return frames

    def _is_old_speaker(self, datagram: bytes) -> bool:
        """Whether this is MAVLink 1, from a peer that may change to 2 when it hears 2; it cannot be signed."""
        return not self._keyring.has_key and speaks_mavlink_1(datagram)

    def _has_room(self, now_s: float) -> bool:
        """Whether a newcomer can be answered, once those that have gone are forgotten."""
        if len(self._peers) >= MOST_PEERS:
            self._forget(now_s)
        return len(self._peers) < MOST_PEERS

    def _forget(self, now_s: float) -> None:
        gone = [peer for peer, received_s in self._peers.items() if now_s - received_s >= PEER_SILENT_S]
        for peer in gone:
            del self._peers[peer]

    def flush(self) -> None:
        """Send what waits on the connection; frames without a receiver are dropped."""
        self._forget(self._clock())
        for unsigned in self.connection.frames():
            frame = self._keyring.signed(unsigned, self._link_id)
            try:
                if self.address.kind == "udpout":
                    self.socket.send(frame)
                else:
                    for peer in self._peers:
                        self.socket.sendto(frame, peer)
            except OSError:
                continue


class SupervisedLink(_Link):
    """The link of a process to its supervisor: whole datagrams, to and from its address only."""

    def fileno(self) -> int:
        """The socket's, for its receivers."""
        return self.socket.fileno()

    @property
    def waiting(self) -> bool:
        """Whether a datagram has come that was not received yet."""
        try:
            self.socket.recv(1, socket.MSG_PEEK | socket.MSG_DONTWAIT)
        except OSError:
            return False
        return True

    def wait_in_receive(self, most_s: float) -> None:
        """Let a receive wait for a datagram, for so long at most, instead of a poll before it."""
        self.socket.setblocking(True)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, time_of(most_s))

    def receive(self) -> bytes:
        """The next datagram; none where none came in the time of `wait_in_receive`, or the system was interrupted."""
        try:
            return self.socket.recv(SUPERVISED_BYTES)
        except OSError:
            return b""

    def send(self, datagrams: list[bytes]) -> None:
        """Send; a supervisor that is not there (yet) is no error."""
        for datagram in datagrams:
            try:
                self.socket.send(datagram, socket.MSG_DONTWAIT)
            except OSError:
                return
