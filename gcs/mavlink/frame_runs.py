"""Which frames of the dialect some bytes consist of, by sender: the search that gcs/mavlink/datagram.py and
gcs/link/inbox.py call, and the rows that it fills.

frame_runs.pxd has the rows as structs: Run, of frames of one system that follow each other, and Awaited, of a vehicle
whose answer may come. Arrays of them are (n, COLUMNS) and (vehicles, AWAITED) of int64; the constants below are their
columns.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.gcs.mavlink.payload as payload
from cython.cimports.gcs.mavlink.frame_runs import (
    _BEGINS,
    _RUNS,
    _SYSTEM_TIME,
    _TIME_BOOT_MS,
    HALF,
    MOST_BYTES,
    NO_RUN,
    NO_TIME,
    NOT_GRANTED,
    NOWHERE,
    NUMBERS,
    SMALLEST_FRAME,
    Found,
    run_at,
)
from cython.cimports.skytender.intact_frames import NO_SEED, intact_at

__all__ = [
    "ADDRESS", "AWAITED", "COLUMNS", "COMPID", "COMPID_OF", "FIRST", "GRANTED_MS", "HALF", "HELD", "IN_STEP", "LAST",
    "MOST_BYTES", "NEXT", "NOT_GRANTED", "NOWHERE", "NO_RUN", "NO_TIME", "NUMBERS", "RUN", "SEQ", "SMALLEST_FRAME",
    "SYSID", "TIME_MS", "add_frames", "found_in",
]  # fmt: skip

COLUMNS = 7
FIRST, LAST, SYSID, COMPID, SEQ, IN_STEP, TIME_MS = range(COLUMNS)
AWAITED = 6
NEXT, GRANTED_MS, COMPID_OF, HELD, ADDRESS, RUN = range(AWAITED)


def find(data: Any, at: int, size: int, begins: Any, rows: Any, found: Any) -> Any:
    """Find the frames of data[at:size], and go on filling begins and rows behind the frames and runs that were found
    before. Behind a datagram's last frame stands its end."""
    nothing: Any = Found(-1, -1)
    frames, runs = found.frames, found.runs
    row: Any = cython.address(rows[runs])
    if at == size:
        return nothing
    while at < size:
        intact = intact_at(data, at, size)
        if not intact.end or intact.version != 2 or intact.seed == NO_SEED:
            return nothing
        seq, sysid, compid = data[at + 4], data[at + 5], data[at + 6]
        if runs == found.runs or row.sysid != sysid:
            row = cython.address(rows[runs])
            row.first, row.sysid, row.compid, row.seq, row.in_step = frames, sysid, compid, seq, 1
            runs += 1
        if compid != row.compid or seq != (row.seq + frames - row.first) & 0xFF:
            row.in_step = 0
        row.time_ms = NO_TIME
        if intact.msgid == _SYSTEM_TIME:
            row.time_ms = payload.u32(data, at + _TIME_BOOT_MS, intact.checksum)
        begins[frames] = at
        frames += 1
        row.last = frames
        at = intact.end
    begins[frames] = size
    return Found(frames + 1, runs)


def add_frames(rows: Any, frames: Any) -> None:
    """Add the number of frames of runs (n, COLUMNS) to that of their systems (256,)."""
    for k in range(rows.shape[0]):
        run = run_at(rows, k)
        frames[run.sysid] += run.last - run.first


def found_in(datagram: bytes) -> tuple[list[int], list[tuple[int, ...]]] | None:
    """(where each frame begins, and the last one ends; rows of runs) of a datagram; None where not every byte belongs
    to a frame of the dialect."""
    if len(datagram) > MOST_BYTES:
        return None
    found = find(datagram, 0, len(datagram), _BEGINS, _RUNS, Found(0, 0))
    if found.runs < 0:
        return None
    begins = [_BEGINS[k] for k in range(found.frames)]
    rows: list[tuple[int, ...]] = []
    for k in range(found.runs):
        run: Any = cython.address(_RUNS[k])
        rows.append((run.first, run.last, run.sysid, run.compid, run.seq, run.in_step, run.time_ms))
    return begins, rows
