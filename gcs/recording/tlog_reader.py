"""Reads `.tlog` files, ours and other ground stations': per frame 8 bytes of time (µs since the Unix epoch, high byte
first), then the frame; and `.tlog.raw` and `.rlog` files, which have frames alone. Compiled code walks them, so that a
gigabyte takes seconds.

    log = tlog.read(path)
    for t_us, frame in log: ...         # one by one, or
    for chunk in log.chunks(): ...      # many at once, `chunk.table("ATTITUDE")` as a structured array
    log.problems                        # what could not be read, a sentence each, once all of it has been walked

Nothing in a file makes reading raise. A cut end, and bytes that are no frame, are passed over and counted. Times are
judged over the whole file (recorded_clock.py) before the first frame is handed out.
"""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.recording import rotation
from gcs.recording.times import tlog_times
from gcs.recording.times.tlog_times import TlogTimes
from gcs.recording.tlog_walk import (
    AT,
    COLUMNS,
    COMPID,
    MSGID,
    SEQ,
    SYSID,
    T_US,
    TIME_BYTES,
    Chunk,
    raw_at,
    walk,
)

__all__ = ["AT", "COMPID", "MSGID", "SEQ", "SYSID", "TIME_BYTES", "T_US", "Chunk", "Tlog", "raw_at", "read"]

CHUNK_BYTES = 1 << 24
LARGEST = codec.LARGEST_FRAME


class Tlog:
    """A recording; walking it again begins anew. Walking raises OSError where the file cannot be read.

    times: those of another `Tlog` of the same file, so that they are not judged again. session: the stamps are a
    session's own time, at whatever rate the clocks of its vehicles pass.
    """

    def __init__(
        self, path: Path, chunk_bytes: int = CHUNK_BYTES, *, times: TlogTimes | None = None, session: bool = False
    ) -> None:
        self.path = path
        self.times = times
        """None until the file is first walked"""
        self._session = session
        self._chunk_bytes = max(chunk_bytes, 2 * (LARGEST + TIME_BYTES))
        self.problems: list[str] = []

    def __iter__(self) -> Iterator[tuple[int, Frame]]:
        for chunk in self.chunks():
            yield from chunk.frames()

    def chunks(self, begin: int = 0) -> Iterator[Chunk]:
        """The recording, stretch by stretch, from a place in the file on: where a frame's time begins.

        The next one is read and walked beside whoever takes this one in, for both hardly need the interpreter.
        """
        if self.times is None:
            self.times = tlog_times.judge(lambda: self._read_ahead(0), session=self._session)
        for chunk in self._read_ahead(begin):
            self.times.correct(chunk)
            yield chunk

    def _read_ahead(self, begin: int) -> Iterator[Chunk]:
        walked = self._walked(begin)
        with ThreadPoolExecutor(1) as beside:
            following = beside.submit(next, walked, None)
            while (chunk := following.result()) is not None:
                following = beside.submit(next, walked, None)
                yield chunk

    def _walked(self, begin: int) -> Iterator[Chunk]:
        self.problems = []
        carried = np.empty(0, dtype=np.uint8)
        room = np.empty((0, COLUMNS), dtype=np.int64)
        done = begin
        frames = gaps = skipped = 0
        last_end, look_at = 0, TIME_BYTES
        with rotation.open_parts(self.path) as file:
            size = max(rotation.size(self.path), 1)
            file.seek(begin)
            while True:
                octets = np.empty(len(carried) + self._chunk_bytes, dtype=np.uint8)
                octets[: len(carried)] = carried
                count = file.readinto(octets.data[len(carried) :])
                final = count < self._chunk_bytes
                done += count
                octets = octets[: len(carried) + count]
                if len(room) < len(octets) // TIME_BYTES + 1:
                    room = np.empty((len(octets) // TIME_BYTES + 1, COLUMNS), dtype=np.int64)
                found, last_end, look_at, more_gaps, more_skipped = walk(octets, room, last_end, look_at, final)
                heads = room[:found].copy()
                frames += found
                gaps += more_gaps
                skipped += more_skipped
                yield Chunk(octets, heads, min(done / size, 1.0), done - len(octets))
                if final:
                    break
                keep = max(last_end, look_at - TIME_BYTES)
                carried = octets[keep:].copy()
                last_end, look_at = last_end - keep, look_at - keep
        left = len(octets) - last_end
        notes = self.times.notes if self.times is not None else []
        self.problems = list(_problems(self.path.name, frames, gaps, skipped, notes, left))


def read(path: Path, *, session: bool = False) -> Tlog:
    """The recording at `path`; session: as of `Tlog`. Raises OSError where there is no file that can be read."""
    with rotation.open_parts(path):
        return Tlog(path, session=session)


def _problems(name: str, frames: int, gaps: int, skipped: int, notes: list[str], left: int) -> Iterator[str]:
    if not frames:
        yield f"{name} is empty." if not left else f"{name} holds no MAVLink frame: it is no tlog."
        return
    if gaps:
        times = "one place" if gaps == 1 else f"{gaps} places"
        yield f"{name} holds {skipped} bytes in {times} that belong to no MAVLink frame; they were passed over."
    yield from (f"{name}: {note}." for note in notes)
    if 0 < left < TIME_BYTES + LARGEST:
        yield f"{name} ends inside a frame: its last {left} bytes could not be read."
    elif left:
        yield f"{name} ends with {left} bytes that belong to no MAVLink frame; they were passed over."
