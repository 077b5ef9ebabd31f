"""The vehicle's side of the supervised link: docs/protocol.md#vehicle-side-of-the-link.

A bundle is one datagram whose last frame is the supervisor's SYSTEM_TIME: the grant. Its rules:
1. The grant's time is new and no number of the supervisor's is missing since the last grant: apply, fly, answer.
2. The grant's time is the present: the last answer goes out again, byte for byte.
3. The grant's time is past, a number is missing, or it is no bundle: nothing happens.
Relayed frames keep their own header and are not numbered by the supervisor.

Vehicles of one process share a socket, and say so in their hellos. There a datagram may hold several bundles, each
behind a PING to its vehicle, which is no part of it; and several answers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

from simvehicle.mavlink.codec import ReceivedFrame, decode, message, split
from simvehicle.mavlink.connection import Connection, pack
from skytender import mavlink as mav

SUPERVISOR = (255, 190)
FRAMES_A_TICK = 127
SHARED = 1
"""Time in the hello of a vehicle that shares its socket."""
SHARED_BYTES = 4096
"""Answers that leave by a shared socket are sent as soon as they are so long together."""


class Bundle(NamedTuple):
    """A grant: frames to apply in order, the time to fly to, and the session's wall clock at it."""

    frames: tuple[ReceivedFrame, ...]
    time_ms: int
    unix_us: int


class Grants:
    """Which bundle is next, and the bytes of the last answer."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self.number = 0
        """of the supervisor's next frame"""
        self.last_answer: list[bytes] = []
        self.time_ms: int | None = None
        """of the last grant"""

    def hello(self, heartbeat: object, secret: int = 0, *, shared: bool = False) -> bytes:
        """The datagram that is repeated until the first bundle: HEARTBEAT 0, SYSTEM_TIME 1.

        secret: what the supervisor knows its own vehicles by, in the place of the time; 0 without one.
        shared: whether others speak by the same socket.
        """
        self._connection.put(heartbeat)
        self._connection.put(message("SYSTEM_TIME")(time_unix_usec=secret, time_boot_ms=SHARED if shared else 0))
        return b"".join(self._connection.frames())

    def feed(self, frames: Sequence[ReceivedFrame]) -> Bundle | list[bytes] | None:
        """A new bundle, or the datagrams to send again, or None."""
        if not frames or frames[-1].msgid != mav.MAVLINK_MSG_ID_SYSTEM_TIME or frames[-1][:2] != SUPERVISOR:
            return None
        grant = decode(frames[-1])
        assert grant is not None
        if self.time_ms is not None and grant.time_boot_ms <= self.time_ms:
            return self.last_answer if grant.time_boot_ms == self.time_ms else None
        seq = self.number
        for frame in frames:
            if frame[:2] == SUPERVISOR:
                if frame.seq != seq:
                    return None
                seq = (seq + 1) & 0xFF
        self.number = seq
        self.time_ms = grant.time_boot_ms
        return Bundle(tuple(frames[:-1]), grant.time_boot_ms, grant.time_unix_usec)

    def answer(self, bundle: Bundle) -> list[bytes]:
        """Messages that wait on the connection, closed by the own SYSTEM_TIME with the grant's time.

        A tick has at most 127 frames, or a lost datagram could hide in the 8 bits of a number; the rest waits.
        """
        frames = self._connection.frames(FRAMES_A_TICK - 1)
        time = message("SYSTEM_TIME")(time_unix_usec=bundle.unix_us, time_boot_ms=bundle.time_ms)
        self.last_answer = pack([*frames, self._connection.number(time)])
        return self.last_answer


def bundles(datagram: bytes) -> Iterator[tuple[int, list[ReceivedFrame]]]:
    """The bundles of a datagram for a shared socket: whose each is, and its frames."""
    sysid, frames = 0, list[ReceivedFrame]()
    for frame in split(datagram):
        if frame.msgid != mav.MAVLINK_MSG_ID_PING or frame[:2] != SUPERVISOR:
            frames.append(frame)
            continue
        if frames:
            yield sysid, frames
        sysid, frames = _addressee(frame), []
    if frames:
        yield sysid, frames


@lru_cache(maxsize=512)
def _addressee(marker: ReceivedFrame) -> int:
    ping = decode(marker)
    assert ping is not None
    return int(ping.target_system)


def together(answers: Iterable[bytes]) -> Iterator[bytes]:
    """Datagrams of several vehicles, one after the other, in fewer ones."""
    waiting = b""
    for datagram in answers:
        waiting += datagram
        if len(waiting) >= SHARED_BYTES:
            yield waiting
            waiting = b""
    if waiting:
        yield waiting
