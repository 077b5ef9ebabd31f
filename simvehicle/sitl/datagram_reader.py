"""Receiving on a socket whose next datagram may come in a moment: to be woken costs a vehicle and its supervisor more
than most of a tick, so it is looked for at first, and the processor left to others in between.
"""

from __future__ import annotations

from typing import Any

import cython
from cython.cimports.cpython.bytearray import PyByteArray_AS_STRING
from cython.cimports.cpython.bytes import PyBytes_FromStringAndSize
from cython.cimports.posix.time import CLOCK_MONOTONIC, clock_gettime, timespec
from cython.cimports.simvehicle.sitl.datagram_reader import (
    CROWDED_NS,
    LOOK_NS,
    MOST_SLEEPS,
    SLEEPS,
    UNDISTURBED,
)
from cython.cimports.skytender.system_calls import MSG_DONTWAIT, recv, sched_yield


class DatagramReader:
    """Receives from a socket that waits in `recv`, for a time that is its own."""

    last_ns: int
    """how long the last wait was"""
    sleeps_left: int
    """how many of the next waits are slept through, because other programs keep the processor"""
    _fd: int
    _room: bytearray
    _buffer: Any
    _size: int
    _slept: int
    _looked: int

    def __init__(self, fd: int, most_bytes: int) -> None:
        """`most_bytes`: longer datagrams are cut."""
        self._fd, self._size = fd, most_bytes
        self._room = bytearray(most_bytes)
        self._buffer = PyByteArray_AS_STRING(self._room)
        self.last_ns = self.sleeps_left = self._slept = self._looked = 0

    def receive(self) -> bytes:
        """The next datagram; none where none came in the socket's time, or the system was interrupted."""
        with cython.nogil:
            have = self._wait()
        return PyBytes_FromStringAndSize(self._buffer, have) if have > 0 else b""

    def _wait(self) -> int:
        begun_ns = now_ns = _now_ns()
        have = -1
        if self.sleeps_left > 0:
            self.sleeps_left -= 1
        elif self.last_ns < LOOK_NS:
            self._looked += 1
            while have < 0 and now_ns - begun_ns < LOOK_NS:
                have = recv(self._fd, self._buffer, self._size, MSG_DONTWAIT)
                if have < 0:
                    sched_yield()
                    left_ns, now_ns = now_ns, _now_ns()
                    if now_ns - left_ns >= CROWDED_NS:
                        self._go_on_with_sleep()
        if have < 0:
            have = recv(self._fd, self._buffer, self._size, 0)
            now_ns = _now_ns()
        self.last_ns = now_ns - begun_ns
        return have

    def _go_on_with_sleep(self) -> None:
        again = self._slept > 0 and self._looked < UNDISTURBED
        self._slept = min(2 * self._slept, MOST_SLEEPS) if again else SLEEPS
        self.sleeps_left, self._looked = self._slept, 0


def _now_ns() -> int:
    now = cython.declare(timespec)
    clock_gettime(CLOCK_MONOTONIC, cython.address(now))
    return cython.cast(cython.longlong, now.tv_sec) * 1_000_000_000 + now.tv_nsec
