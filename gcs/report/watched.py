"""A recorded fleet as a replay would show it: changes of links, failsafes, and health of vehicles over time.

An observer, as of `gcs replay`, receives the frames from which these follow, and is looked at again and again.
"""

from __future__ import annotations

import contextlib
import heapq
from collections.abc import Iterator
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.codec import Frame
from gcs.mavlink.gaps import GapCounter
from gcs.processes.looks import SETTLED_S, Looks
from gcs.recording import tlog_walk
from gcs.recording.session_folder import Recorded
from gcs.session.observer import Observer
from gcs.session.timeline import Moments
from gcs.telemetry.events import Event
from gcs.telemetry.health import NO_ISSUES, SILENT_S, Health

EVERY_S = 0.5
MOST_LOOKS = 100_000
"""At vehicles, one by one: a longer flight of many is looked at more seldom."""
LOOKS_BETWEEN = 5
"""So many times as often changes are looked for, which takes a fleet as one: each 0.1 s, as a session does."""
KINDS = frozenset({"link", "failsafe"})
"""Of events that no decision holds; modes are shown beside them, and vehicles' texts are read from the recording."""


class Watched:
    """Link events and health of a recorded fleet."""

    def __init__(self, recorded: Recorded) -> None:
        self.events: list[Event] = []
        """in order of time"""
        self.health: dict[int, list[tuple[float, Health]]] = {}
        """by system id: from when on, and the health from then on"""
        if not any(len(chunk.heads) for chunk in recorded.health_frames):
            return
        self._observer = Observer("replay", "", scenario=recorded.scenario)
        self._gaps = GapCounter()
        self._observer.resume(self._gaps, 0.0)
        self._moments, self._done = _moments(recorded), 0
        self._link = _link(recorded)
        self._counted = next(self._link, None)
        vehicles = max(len(recorded.traffic_count), 1)
        every_s = max(EVERY_S, recorded.end_s * vehicles / MOST_LOOKS)
        self._looks = Looks(every_s / LOOKS_BETWEEN, after_s=recorded.begin_s, settled_s=SETTLED_S)
        # Where the first parts were not kept, vehicles have said all only some time after the rest begins.
        self._judged = Looks(every_s, after_s=recorded.begin_s + SILENT_S if recorded.begin_s else 0.0)
        latest_s = 0.0
        for chunk in recorded.health_frames:
            data, heads = chunk.octets.tobytes(), chunk.heads
            # A stamp may be years away.
            seconds = np.maximum.accumulate(np.append(latest_s, heads[:, tlog_walk.T_US] / 1e6))[1:]
            times_s = np.minimum(seconds, recorded.end_s)
            begin = 0
            while begin < len(heads):
                due_s = min(self._looks.due_s, self._judged.due_s)
                end = int(np.searchsorted(times_s, due_s, side="right"))
                if begin < end:
                    self._receive(data, heads[begin:end], times_s[begin:end])
                    begin = end
                if begin < len(heads):
                    self._look_before(float(times_s[begin]))
            latest_s = float(times_s[-1]) if len(heads) else latest_s
        self._look_before(recorded.end_s)
        self._look(recorded.end_s)
        self._judge(recorded.end_s)

    def _receive(self, data: bytes, heads: NDArray[np.int64], times_s: NDArray[np.float64]) -> None:
        def frame(k: int) -> Frame:
            _, at, *numbers = heads[k].tolist()
            return Frame._make((*numbers, tlog_walk.raw_at(data, at)))

        self._observer.receive_dated(data, heads[:, [tlog_walk.AT, tlog_walk.SYSID]], times_s, frame)

    def _look_before(self, t_s: float) -> None:
        looks = ((due_s, self._look) for due_s in self._looks.before(t_s))
        judged = ((due_s, self._judge) for due_s in self._judged.before(t_s))
        for due_s, act in heapq.merge(looks, judged, key=itemgetter(0)):
            act(due_s)

    def _look(self, t_s: float) -> None:
        self._go_on(t_s)
        self._observer.look(t_s)
        self.events += [event for event in self._observer.pop_events() if event.kind in KINDS]

    def _judge(self, t_s: float) -> None:
        self._go_on(t_s)
        for sysid, found in self._observer.health(t_s).items():
            known = self.health.get(sysid)
            if known is None:
                known = self.health[sysid] = [(0.0, NO_ISSUES)]
            if found != known[-1][1]:
                known.append((t_s, found))

    def _go_on(self, t_s: float) -> None:
        observer = self._observer
        self._done = self._moments.let_happen(observer, self._done, t_s)
        self._moments.show(observer, t_s)
        while self._counted is not None and self._counted[0] <= t_s:
            at_s, sysid, received, lost = self._counted
            self._gaps.lost_of[sysid] = self._gaps.lost_of.get(sysid, 0) + lost
            observer.quality.count(sysid, received, at_s)
            self._counted = next(self._link, None)


def _moments(recorded: Recorded) -> Moments:
    scenario = recorded.scenario
    moments = Moments(() if scenario is None else [one.sysid for one in scenario.vehicles.on_missions])
    for record in recorded.decisions:
        with contextlib.suppress(KeyError, TypeError, ValueError):  # of another version
            moments.take(float(record["t_s"]), record)
    moments.see_landings(recorded)
    return moments


def _link(recorded: Recorded) -> Iterator[tuple[float, int, int, int]]:
    """(end of a bin in s, system id, frames received in it that may be lost, and lost) in order of time."""
    own = {one.sysid for one in recorded.scenario.vehicles.launched} if recorded.scenario is not None else set()
    bins = {}
    for sysid, received in recorded.traffic_count.items():
        counted = received - recorded.traffic_exempt[sysid][: len(received)] if sysid in own else received
        bins[sysid] = counted.tolist(), recorded.traffic_lost[sysid].tolist()
    for k in range(max(map(len, recorded.traffic_count.values()), default=0)):
        at_s = min((k + 1.0) * recorded.traffic_bin_s, recorded.end_s)
        for sysid, (counted, lost) in bins.items():
            if k < len(counted):
                yield at_s, sysid, counted[k], lost[k]
