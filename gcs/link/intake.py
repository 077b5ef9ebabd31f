"""Answers to a tick's grants as they come in: most fill a datagram with others of their kind, and are taken in by
compiled code; of all the rest the link is told."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from gcs.link.link import Key
from gcs.mavlink.datagram import (
    ADDRESS,
    ALONE,
    AWAITED,
    GRANTED_MS,
    NOT_GRANTED,
    NOWHERE,
    NUMBERS,
    SHARED_BY,
    AnswerRuns,
    DatagramBuffer,
)
from gcs.mavlink.sequence import TickCollector

BUFFER_BYTES = 1 << 20
"""A tick's answers that do not fit are read one by one."""


class Intake:
    """A tick's datagrams, and the answers that were found in them, of vehicles that have been enrolled."""

    def __init__(self, most_datagrams: int, room_bytes: int) -> None:
        """room_bytes: a datagram's, at most."""
        self.buffer = DatagramBuffer(BUFFER_BYTES, most_datagrams, room_bytes)
        self._table = np.empty((0, AWAITED), np.int64)
        self._lanes = np.full(NUMBERS, -1)
        self._keys: list[Key] = []

    def enrol(self, vehicles: Sequence[tuple[Key, TickCollector, int]]) -> None:
        """Know these vehicles from now on, in their order: key, collector, number of the address, or NOWHERE."""
        self._keys = [key for key, *_ in vehicles]
        table, lanes = np.empty((len(vehicles), AWAITED), np.int64), np.full(NUMBERS, -1)
        for k, (key, collector, address) in enumerate(vehicles):
            collector.live_in(table[k])
            table[k, ADDRESS] = address
            lanes[key[0]] = k
        self._table, self._lanes = table, lanes

    def begin(self, keys: Sequence[Key], t_ms: int) -> bool:
        """Let all who are enrolled wait for the answer to a grant at once; False where these are others, or an earlier
        answer has not been taken, and nobody does."""
        granted = self._table[:, GRANTED_MS]
        if keys != self._keys or not (granted == NOT_GRANTED).all():
            return False
        granted[:] = t_ms
        return True

    def dismiss(self, key: Key) -> None:
        """Take in nothing more of a vehicle."""
        if key in self._keys:
            self._table[self._keys.index(key), ADDRESS] = NOWHERE

    def take_in(self) -> NDArray[np.int64]:
        """Look into the datagrams that wait, up to one in which there is more than whole answers, which
        `buffer.stopped` gives; whose answers were found, for `keys`."""
        return self.buffer.take_in(self._table, self._lanes)

    def keys(self, lanes: NDArray[np.int64]) -> list[Key]:
        """Vehicles as `take_in` names them."""
        return [self._keys[lane] for lane in lanes.tolist()]

    def answers(self) -> Iterator[tuple[Sequence[Key], AnswerRuns]]:
        """The answers that were found, in order of the vehicles; they are handed out once."""
        if self.buffer.answers:
            lanes, runs = self.buffer.pop_answers(self._table)
            if len(lanes):
                yield self._keys if len(lanes) == len(self._keys) else self.keys(lanes), runs


def numbered(count: int, *, shared: bool) -> int:
    """Number of the address that is counted so: as datagrams from there are marked."""
    return count << 1 | (SHARED_BY if shared else ALONE)
