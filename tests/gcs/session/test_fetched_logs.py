"""Logs that autopilots still write when they are asked for, without a vehicle."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.autopilots import profile_of
from gcs.mavlink.log_client import LogClient
from gcs.session import fetched_logs


class Growing:
    """A fleet of one whose newest log has another size each time until the last."""

    def __init__(self, *sizes: int) -> None:
        self.profiles = {3: profile_of(mav.MAV_AUTOPILOT_PX4)}
        self._sizes = list(sizes)
        self.asked = 0

    def exchange(self, clients: Sequence[LogClient]) -> None:
        for client in clients:
            for message in client.poll(0.0):
                assert codec.name(message.msgid) == "LOG_REQUEST_LIST"
                self.asked += 1
                size = self._sizes.pop(0) if len(self._sizes) > 1 else self._sizes[0]
                client.receive("LOG_ENTRY", SimpleNamespace(id=1, num_logs=1, time_utc=9, size=size), 0.0)


@pytest.mark.parametrize(("sizes", "asked"), [((70,), 2), ((50, 60, 70), 4), (tuple(range(1, 20)), 8)])
def test_a_log_is_taken_when_its_size_stays(
    sizes: tuple[int, ...], asked: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fetched_logs, "STAYS_S", 0.0)
    fleet = Growing(*sizes)
    (client,) = fetched_logs._listed({3: fleet})  # type: ignore[dict-item]
    assert fleet.asked == asked  # and no more than a bounded number of times
    assert client.entries[1].size_bytes == (sizes[-1] if asked < 8 else 8)
