"""The vehicle's side of the supervised link: docs/protocol/link.md#vehicle-side-of-the-link.

A bundle is one datagram whose last frame is the supervisor's SYSTEM_TIME: the grant. Its rules:
1. The grant's time is new and no number of the supervisor's is missing since the last grant: apply, fly, answer.
2. The grant's time is the present: the last answer goes out again, byte for byte.
3. The grant's time is past, a number is missing, or it is no bundle: nothing happens.
Relayed frames keep their own header and are not numbered by the supervisor.

Vehicles of one process share a socket, and say so in their hellos. There a datagram may hold several bundles, each
behind a PING to its vehicle, which is no part of it; and several answers.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.simvehicle.mavlink.codec as codec
import cython.cimports.simvehicle.mavlink.connection as connections
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.libc.string import memcpy, memset
from cython.cimports.simvehicle.mavlink.lockstep import COMPONENT, FRAMES_A_TICK, SHARED, SYSTEM
from cython.cimports.skytender.messages import PING_ID, SYSTEM_TIME_ID, SYSTEM_TIME_SEED, Ping, SystemTime

from simvehicle.mavlink.codec import ReceivedFrame, message
from simvehicle.mavlink.connection import Connection

SUPERVISOR = (SYSTEM, COMPONENT)
"""A hello's time is SHARED where others speak by the same socket; answers leave there as soon as SHARED_BYTES of them
are ready."""


class Bundle:
    """A grant: frames to apply in order, the time to fly to, and the session's wall clock at it."""

    frames: list[ReceivedFrame]
    time_ms: int
    unix_us: int


class Grants:
    """Which bundle is next, and the bytes of the last answer."""

    _connection: Connection
    number: int
    """of the supervisor's next frame"""
    last_answer: list[bytes]
    time_ms: int
    """of the last grant; -1 before the first"""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self.number = 0
        self.last_answer = []
        self.time_ms = -1

    def hello(self, heartbeat: object, secret: int = 0, *, shared: bool = False) -> bytes:
        """The datagram that is repeated until the first bundle: HEARTBEAT 0, SYSTEM_TIME 1.

        secret: what the supervisor knows its own vehicles by, in the place of the time; 0 without one.
        shared: whether others speak by the same socket.
        """
        self._connection.put(heartbeat)
        self._connection.put(message("SYSTEM_TIME")(time_unix_usec=secret, time_boot_ms=SHARED if shared else 0))
        return b"".join(self._connection.frames())

    def feed(self, frames: list[ReceivedFrame]) -> Bundle | list[bytes] | None:
        """A new bundle, or the datagrams to send again, or None."""
        grant = cython.declare(SystemTime)
        if not frames or not _is_supervisors(frames[len(frames) - 1], SYSTEM_TIME_ID):
            return None
        last = frames[len(frames) - 1]
        memset(cython.address(grant), 0, cython.sizeof(SystemTime))
        size = min(len(last.payload), cython.sizeof(SystemTime))
        memcpy(cython.address(grant), PyBytes_AS_STRING(last.payload), size)
        if grant.time_boot_ms <= self.time_ms:
            return self.last_answer if grant.time_boot_ms == self.time_ms else None
        seq = self.number
        for frame in frames:
            if frame.sysid == SYSTEM and frame.compid == COMPONENT:
                if frame.seq != seq:
                    return None
                seq = seq + 1 & 0xFF
        self.number, self.time_ms = seq, grant.time_boot_ms
        del frames[len(frames) - 1]
        bundle = Bundle.__new__(Bundle)
        bundle.frames, bundle.time_ms, bundle.unix_us = frames, grant.time_boot_ms, grant.time_unix_usec
        return bundle

    def answer(self, bundle: Bundle) -> list[bytes]:
        """Messages that wait on the connection, closed by the own SYSTEM_TIME with the grant's time.

        A tick has at most 127 frames, or a lost datagram could hide in the 8 bits of a number; the rest waits.
        """
        time = cython.declare(SystemTime)
        time.time_unix_usec, time.time_boot_ms = bundle.unix_us, bundle.time_ms
        payload, size = cython.cast("const unsigned char *", cython.address(time)), cython.sizeof(SystemTime)
        frames = self._connection.frames(FRAMES_A_TICK - 1)
        frames.append(self._connection.number(SYSTEM_TIME_ID, SYSTEM_TIME_SEED, payload, size))
        self.last_answer = connections.pack(frames)
        return self.last_answer


def _is_supervisors(frame: Any, msgid: int) -> bool:
    return frame.sysid == SYSTEM and frame.compid == COMPONENT and frame.msgid == msgid


def bundles(datagram: bytes) -> list[tuple[int, list[ReceivedFrame]]]:
    """The bundles of a datagram for a shared socket: whose each is, and its frames."""
    found: list[tuple[int, list[ReceivedFrame]]] = []
    sysid = 0
    frames: list[ReceivedFrame] = []
    for frame in codec.split(datagram):
        if not _is_supervisors(frame, PING_ID):
            frames.append(frame)
            continue
        if frames:
            found.append((sysid, frames))
        sysid, frames = _addressee(frame.payload), []
    if frames:
        found.append((sysid, frames))
    return found


def _addressee(payload: bytes) -> int:
    ping = cython.declare(Ping)
    memset(cython.address(ping), 0, cython.sizeof(Ping))
    memcpy(cython.address(ping), PyBytes_AS_STRING(payload), min(len(payload), cython.sizeof(Ping)))
    return ping.target_system
