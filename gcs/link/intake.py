"""Answers to a tick's grants as they come in: most fill a datagram with others of their kind, and are taken in by
compiled code; all the rest goes to the link."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from cython.cimports.gcs.link.inbox import ALONE, SHARED_BY
from cython.cimports.gcs.mavlink.frame_runs import NOT_GRANTED, NOWHERE, NUMBERS, awaited_at

from gcs.link.inbox import Inbox, Ints
from gcs.link.link import Key
from gcs.mavlink.datagram import AnswerRuns
from gcs.mavlink.frame_runs import ADDRESS, AWAITED
from gcs.mavlink.sequence import TickCollector

BUFFER_BYTES = 1 << 20
"""A tick's answers that do not fit are read one by one."""


class Intake:
    """A tick's datagrams, and the answers that were found in them, of vehicles that have been enrolled."""

    def __init__(self, most_datagrams: int, room_bytes: int, unknown_bytes: int) -> None:
        """As `Inbox`."""
        self.inbox = Inbox(BUFFER_BYTES, most_datagrams, room_bytes, unknown_bytes)
        self._table = np.empty((0, AWAITED), np.int64)
        self._row_by_sysid = np.full(NUMBERS, -1)
        self._keys: list[Key] = []

    def enrol(self, vehicles: Sequence[tuple[Key, TickCollector, int]]) -> None:
        """Know these vehicles from now on, in their order: key, collector, number of the address, or NOWHERE."""
        self._keys = [key for key, *_ in vehicles]
        table, row_by_sysid = np.empty((len(vehicles), AWAITED), np.int64), np.full(NUMBERS, -1)
        for k, (key, collector, number) in enumerate(vehicles):
            collector.live_in(table[k])
            table[k, ADDRESS] = number
            row_by_sysid[key[0]] = k
        self._table, self._row_by_sysid = table, row_by_sysid

    def begin(self, keys: Sequence[Key], t_ms: int) -> bool:
        """Let all that are enrolled wait for the answer to a grant at once; False where these are others, or an earlier
        answer has not been taken; then none waits."""
        return keys == self._keys and _begin(self._table, t_ms)

    def dismiss(self, key: Key) -> None:
        """Take in nothing more of a vehicle."""
        if key in self._keys:
            self._table[self._keys.index(key), ADDRESS] = NOWHERE

    def receive(self, fd: int, most: int, left: int, *, yields: int = 0, lost: bool = False) -> int:
        """As `Inbox.receive`; whose answers were found is in `answered`."""
        return self.inbox.receive(fd, most, left, self._table, self._row_by_sysid, yields=yields, lost=lost)

    def answered(self) -> list[Key]:
        """Vehicles whose answers the last call of `receive` has found."""
        return [self._keys[row] for row in self.inbox.answered.tolist()]

    def answers(self) -> Iterator[tuple[Sequence[Key], AnswerRuns]]:
        """The answers that were found, in order of the vehicles; they are handed out once."""
        if self.inbox.answers:
            rows, runs = self.inbox.pop_answers(self._table)
            if len(rows) == len(self._keys):
                yield self._keys, runs
            elif len(rows):
                yield [self._keys[row] for row in rows.tolist()], runs


def numbered(count: int, *, shared: bool) -> int:
    """Number of the address that is counted so: as datagrams from there are marked."""
    return count << 1 | (SHARED_BY if shared else ALONE)


def _begin(table: Ints, t_ms: int) -> bool:
    """As `Intake.begin`, for all of the table."""
    for k in range(table.shape[0]):
        if awaited_at(table, k).granted_ms != NOT_GRANTED:
            return False
    for k in range(table.shape[0]):
        awaited_at(table, k).granted_ms = t_ms
    return True
