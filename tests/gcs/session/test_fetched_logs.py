"""Logs that autopilots still write when they are asked for, without a vehicle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from types import SimpleNamespace

from hypothesis import given
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.autopilots import profile_of
from gcs.mavlink.log_client import LogClient
from gcs.session import fetched_logs


class Growing:
    """A fleet of one, with its time: its newest log is written every `every_s`, for the last time at `until_s`."""

    def __init__(self, every_s: float, until_s: float, phase: float = 0.0) -> None:
        self.profiles = {3: profile_of(mav.MAV_AUTOPILOT_PX4)}
        self.now_s = 0.0
        self._every_s, self._until_s, self._phase_s = every_s, until_s, phase * every_s

    @property
    def size(self) -> int:
        writes = math.floor((min(self.now_s, self._until_s) + self._phase_s) / self._every_s)
        return 1000 + writes + (self.now_s >= self._until_s)

    def exchange(self, clients: Sequence[LogClient]) -> None:
        self.now_s += 0.1
        for client in clients:
            for message in client.poll(self.now_s):
                assert codec.name(message.msgid) == "LOG_REQUEST_LIST"
                entry = SimpleNamespace(id=1, num_logs=1, time_utc=9, size=self.size)
                client.receive("LOG_ENTRY", entry, self.now_s)


def listed(fleet: Growing) -> tuple[int, list[int]]:
    """Size in which the log is taken, and the vehicles whose log still grows."""
    (client,), growing = fetched_logs._listed({3: fleet}, lambda: fleet.now_s)  # type: ignore[dict-item]
    return client.entries[1].size_bytes, growing


STANDS_BY_S = fetched_logs.GROWS_FOR_S - fetched_logs.STANDS_FOR_S - 2 * (fetched_logs.LIST_EVERY_S + 0.2)
"""A log that is written for the last time by then is listed as it stays, for as long as it must, before the time is up:
a list comes every LIST_EVERY_S, and takes two rounds."""


@given(every_s=st.floats(0.1, 4.0), until_s=st.floats(0.0, STANDS_BY_S), phase=st.floats(0.0, 0.99))
def test_a_log_is_taken_when_its_size_stands(every_s: float, until_s: float, phase: float) -> None:
    """Also where it is written as seldom as an ArduPilot does, every 2 s, or at half of real time."""
    fleet = Growing(every_s, until_s, phase)
    size, growing = listed(fleet)
    assert growing == []
    assert fleet.now_s <= until_s + 10.0
    fleet.now_s = 1e3
    assert size == fleet.size


def test_one_that_grows_on_is_named() -> None:
    fleet = Growing(every_s=1.0, until_s=1e9)
    _, growing = listed(fleet)
    assert growing == [3]
    assert fleet.now_s < fetched_logs.GROWS_FOR_S + 3.0


def test_one_without_a_log_is_not_waited_for() -> None:
    class Empty(Growing):
        def exchange(self, clients: Sequence[LogClient]) -> None:
            self.now_s += 0.1
            for client in clients:
                client.poll(self.now_s)
                client.receive("LOG_ENTRY", SimpleNamespace(id=0, num_logs=0, time_utc=0, size=0), self.now_s)

    fleet = Empty(1.0, 0.0)
    (client,), growing = fetched_logs._listed({3: fleet}, lambda: fleet.now_s)  # type: ignore[dict-item]
    assert (client.entries, growing) == ({}, [])
    assert fleet.now_s < 3.0
