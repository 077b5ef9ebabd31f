"""A planner and policy that a program in Python gave its session, as the supervisor asks them: over a socket pair, with
the frames of gcs/processes/plugin_channel.py.

The program makes and calls them in its own process while it waits for the next snapshot, however long that takes. What
they answer is recorded, since they cannot be asked again.

| frame | content |
|---|---|
| first, from the program | JSON: by key of gcs/scenario/plugins.py, `name` and whether it `assigns` |
| question, answer | as with a process of the session's own |
"""

from __future__ import annotations

import json
import socket
import struct
from typing import Any

from gcs.processes.plugin_channel import PluginChannel, question, read_answer
from gcs.scenario.guard import PROCESS, PluginFault
from gcs.scenario.model import Scenario
from gcs.scenario.plugins import PLANNER, PluginClient, policy_of
from gcs.supervisor.recorded_objects import answer_record, object_record


class ObjectClient(PluginClient):
    """See `PluginClient` for the methods."""

    def __init__(self, descriptor: int, scenario: Scenario) -> None:
        self._socket = socket.socket(fileno=descriptor)
        self._channel = PluginChannel(self._socket)
        self._scenario = scenario
        self._ended = False
        self._faults: list[PluginFault] = []
        about = json.loads(self._receive() or b"{}")
        self._assigns = {key: bool(one["assigns"]) for key, one in about.items()}
        self._policies = {key: policy_of(key, one["name"]) for key, one in about.items()}
        self._records = [object_record(key, one["name"], assigns=one["assigns"]) for key, one in about.items()]
        self._time_s = 0.0

    @property
    def keys(self) -> list[str]:
        """The parts that the program brings."""
        return list(self._policies)

    @property
    def ended(self) -> bool:
        return self._ended

    def made(self, key: str) -> bool:
        return self._assigns[key]

    def ask(self, key: str, asked: Any) -> None:
        self._time_s = asked[1].time_s if key == PLANNER else asked.time_s
        if not self._ended:
            try:
                self._channel.send(question(key, asked, self._scenario))
            except OSError:
                self._end()

    def answers(self, key: str) -> list[Any]:
        rows: list[Any] = []
        last = False
        while not last:
            frame = self._receive()
            if frame is None:
                return []
            try:
                last, more, faults = read_answer(key, self._policies, frame)
            except (ValueError, TypeError, struct.error):
                self._end()
                return []
            rows += more
            self._faults += faults
        self._records.append(answer_record(self._time_s, key, rows))
        return rows

    def pop_faults(self) -> list[PluginFault]:
        taken, self._faults = self._faults, []
        return taken

    def pop_records(self) -> list[dict[str, Any]]:
        taken, self._records = self._records, []
        return taken

    def close(self) -> None:
        """Ask nothing any more."""
        self._socket.close()

    def _receive(self) -> bytes | None:
        """The next frame; None where the program has gone."""
        while not self._ended:
            if (frame := self._channel.pop()) is not None:
                return frame
            try:
                if self._channel.read():
                    continue
            except OSError:
                pass
            self._end()
        return None

    def _end(self) -> None:
        self._ended = True
        self._faults += [PluginFault(PROCESS, policy, "is gone with its program") for policy in self._policies.values()]
