"""Several recordings as one, on one time."""

from __future__ import annotations

import heapq
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from operator import itemgetter
from pathlib import Path

import numpy as np

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.ids import STATION
from gcs.recording import tlog_reader
from gcs.recording.importing.sources import Opened, opened
from gcs.recording.recorder import TLOG
from gcs.recording.times.recorded_clock import EARLIEST_US
from gcs.recording.times.vehicle_clock import SECOND_US
from gcs.recording.tlog_walk import SYSID, T_US, TIME_BYTES

TOGETHER_US = 86_400 * SECOND_US
"""Recordings that know the date and begin within a day keep their times; others begin together [choice]."""


@contextmanager
def beside(sources: Sequence[Path]) -> Iterator[Opened]:
    """One recording of all of these for the while; the first itself where it is the only one.

    A system id that an earlier one has is the next free one in a later one. Of sessions' folders among several the
    frames alone are shown. Raises ImportFailed for what `opened` refuses, OSError.
    """
    with ExitStack() as stack:
        if len(sources) == 1:
            yield stack.enter_context(opened(sources[0]))
            return
        each = [stack.enter_context(opened(source / TLOG if source.is_dir() else source)) for source in sources]
        logs = [tlog_reader.read(one.path) for one in each]
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="gcs-beside-")))
        target = folder / " + ".join(source.name for source in sources)[:200]
        _write(target, logs)
        yield Opened(
            target, [problem for one, log in zip(each, logs, strict=True) for problem in one.problems + log.problems]
        )


def _write(target: Path, logs: Sequence[tlog_reader.Tlog]) -> None:
    seen = [_seen(log) for log in logs]
    begins_us = [begin_us for begin_us, _ in seen]
    dated = min(begins_us) >= EARLIEST_US and max(begins_us) - min(begins_us) <= TOGETHER_US
    taken: set[int] = set()
    told = []
    for log, (begin_us, sysids) in zip(logs, seen, strict=True):
        told.append(_renumbered(log, 0 if dated else begins_us[0] - begin_us, _free(sysids, taken)))
    with target.open("wb") as file:
        for t_us, raw in heapq.merge(*told, key=itemgetter(0)):
            file.write(t_us.to_bytes(TIME_BYTES, "big") + raw)


def _seen(log: tlog_reader.Tlog) -> tuple[int, list[int]]:
    """When a recording begins, and the system ids in it."""
    begin_us, sysids = -1, np.empty(0, np.int64)
    for chunk in log.chunks():
        if len(chunk.heads):
            begin_us = int(chunk.heads[0, T_US]) if begin_us < 0 else begin_us
            sysids = np.union1d(sysids, chunk.heads[:, SYSID])
    return max(begin_us, 0), sysids.tolist()


def _free(sysids: Sequence[int], taken: set[int]) -> dict[int, int]:
    """An id for each of these that is not taken, which they are then; ids of ground stations stay."""
    others = {}
    for sysid in sysids:
        if sysid >= STATION[0]:
            continue
        free = (number % 254 + 1 for number in range(sysid - 1, sysid + 253))
        others[sysid] = next((one for one in free if one not in taken), sysid)
        taken.add(others[sysid])
    return others


def _renumbered(log: tlog_reader.Tlog, by_us: int, others: dict[int, int]) -> Iterator[tuple[int, bytes]]:
    latest_us = 0
    for t_us, frame in log:
        latest_us = max(latest_us, t_us + by_us)
        yield latest_us, _as(frame, others.get(frame.sysid, frame.sysid)).raw


def _as(frame: Frame, sysid: int) -> Frame:
    return frame if sysid == frame.sysid else codec.sent_by(frame, frame.compid, sysid)
