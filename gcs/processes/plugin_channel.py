"""Questions to, and answers of, the process of a user's planner and policy: frames on a socket pair, and their content.

Questions are pickled by the supervisor, of plain tuples. Answers come from a process that runs a user's code:
they are rows of a fixed size, and text.

| frame | content |
|---|---|
| first question | the scenario, the folders of its modules, whether to make what it names or only to look for it |
| first answer, made | JSON: `made`, by key whether it has a method `assign`; or `error`, one sentence |
| first answer, looked for | JSON: `missing`, key and sentence of each that cannot be used |
| question | key, and what is asked |
| answer | whether it is the last one to this question, number of rows, rows, faults as JSON |
"""

from __future__ import annotations

import json
import pickle
import socket
import struct
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from gcs.mavlink.autopilots import PROFILES, FlightMode
from gcs.planner.request import Situation
from gcs.scenario.guard import PluginFault
from gcs.scenario.model import Scenario
from gcs.scenario.plugins import PLANNER, POLICY
from gcs.telemetry.state import FleetSnapshot, TrafficView, VehicleView

ROWS = {PLANNER: struct.Struct("<i6d"), POLICY: struct.Struct("<ii")}
_LENGTH = struct.Struct("<I")
_HEAD = struct.Struct("<?I")
_PROFILE, _MODE = VehicleView._fields.index("profile"), VehicleView._fields.index("mode")
_MODES = {mode.value: mode for mode in FlightMode}
READ_BYTES = 1 << 18


class PluginChannel:
    """One end of the socket pair; every frame has its length before it."""

    def __init__(self, end: socket.socket) -> None:
        self._end = end
        self._pending = bytearray()

    def send(self, content: bytes) -> None:
        """Send a frame; raises OSError."""
        self._end.sendall(_LENGTH.pack(len(content)) + content)

    def read(self) -> bool:
        """Take in what there is, waiting for it; False where the other end is closed. Raises OSError."""
        chunk = self._end.recv(READ_BYTES)
        self._pending += chunk
        return bool(chunk)

    def pop(self) -> bytes | None:
        """The next frame that is whole."""
        if len(self._pending) < _LENGTH.size:
            return None
        end = _LENGTH.size + _LENGTH.unpack_from(self._pending)[0]
        if len(self._pending) < end:
            return None
        content = bytes(self._pending[_LENGTH.size : end])
        del self._pending[:end]
        return content


def _rows(views: Iterable[VehicleView]) -> list[tuple[Any, ...]]:
    """Views as plain tuples, which are pickled ten times as fast."""
    return [(*v[:_PROFILE], v.profile.name, v.mode.value, *v[_MODE + 1 :]) for v in views]


def _views(rows: Iterable[Sequence[Any]]) -> tuple[VehicleView, ...]:
    make = VehicleView._make
    return tuple([make((*r[:_PROFILE], PROFILES[r[_PROFILE]], _MODES[r[_MODE]], *r[_MODE + 1 :])) for r in rows])


def question(key: str, asked: Any, scenario: Scenario) -> bytes:
    """The frame of a question, as `gcs.scenario.plugins.PluginClient.ask` is given it; the other end has the same
    scenario."""
    content: tuple[Any, ...]
    if key == PLANNER:
        sysids, situation = asked
        snapshot = situation.snapshot
        traffic = [(one.callsign, one.p_ned, one.v_ned, one.age_s) for one in snapshot.traffic]
        views = _rows(snapshot.vehicles)
        obstacles = None if situation.obstacles == scenario.obstacles else situation.obstacles
        content = (sysids, situation.time_s, situation.period_s, dict(situation.pursuing), views, traffic, obstacles)
    else:
        content = (
            asked.time_s,
            *map(_rows, (asked.candidates, asked.free_tankers, asked.later)),
            dict(asked.speed_m_s),
            asked.givers,
            asked.times,
            asked.left_s,
        )
    return pickle.dumps((key, content), pickle.HIGHEST_PROTOCOL)


def planner_question(content: tuple[Any, ...], scenario: Scenario) -> tuple[list[VehicleView], Situation]:
    """Vehicles to plan for, and the situation, of a planner's question."""
    sysids, time_s, period_s, pursuing, rows, traffic, obstacles = content
    snapshot = FleetSnapshot(time_s, _views(rows), tuple(TrafficView(*one) for one in traffic))
    there = scenario.obstacles if obstacles is None else obstacles
    situation = Situation(time_s, period_s, snapshot, pursuing, there)
    return [snapshot.vehicle(sysid) for sysid in sysids], situation


def policy_question(content: tuple[Any, ...], scenario: Scenario) -> Any:
    """The RefuellingRequest of a policy's question."""
    from gcs.refuelling.policies import RefuellingRequest  # noqa: PLC0415 - a planner alone needs none of it

    time_s, candidates, free_tankers, later, speed_m_s, givers, times, left_s = content
    free = _views(free_tankers)
    return RefuellingRequest(
        time_s, free[0], _views(candidates), free, speed_m_s, scenario.refuelling, givers, _views(later), times, left_s
    )


def answer(key: str, rows: Iterable[tuple[Any, ...]], faults: Iterable[PluginFault], *, last: bool) -> bytes:
    """The frame of an answer."""
    packed = [ROWS[key].pack(*row) for row in rows]
    text = json.dumps([[fault.sysid, fault.problem] for fault in faults]).encode()
    return b"".join((_HEAD.pack(last, len(packed)), *packed, text))


def read_answer(
    key: str, policies: Mapping[str, str], content: bytes
) -> tuple[bool, list[tuple[Any, ...]], list[PluginFault]]:
    """Whether an answer is the last one, its rows and faults; `policies`: names for people by key. Raises ValueError,
    struct.error, TypeError."""
    last, count = _HEAD.unpack_from(content)
    end = _HEAD.size + count * ROWS[key].size
    rows = list(ROWS[key].iter_unpack(content[_HEAD.size : end]))
    faults = [PluginFault(int(sysid), policies[key], str(problem)) for sysid, problem in json.loads(content[end:])]
    return last, rows, faults
