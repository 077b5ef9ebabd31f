"""Reads `.tlog` files, ours and other ground stations': per frame 8 bytes of time (µs since the Unix epoch, high byte
first), then the frame; and `.tlog.raw` and `.rlog` files, which have frames alone. Compiled code walks them, so that a
gigabyte takes seconds.

    log = tlog.read(path)
    for t_us, frame in log: ...         # one by one, or
    for chunk in log.chunks(): ...      # many at once, `chunk.table("ATTITUDE")` as a structured array
    log.problems                        # what could not be read, a sentence each, once all of it has been walked

Nothing in a file makes reading raise. A cut end, and bytes that are no frame, are passed over and counted. Times are
judged over the whole file (recorded_clock.py) before the first frame is handed out; a file of
less than a chunk is walked once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.recording import rotation
from gcs.recording.times import tlog_times
from gcs.recording.times.tlog_times import TlogTimes
from gcs.recording.tlog_walk import COLUMNS, TIME_BYTES, Chunk, walk

CHUNK_BYTES = 1 << 24
LARGEST = codec.LARGEST_FRAME


class _WalkTotals(NamedTuple):
    """Counts of a walk over a whole recording, and the bytes that are left behind its last frame."""

    frames: int
    gaps: int
    skipped_bytes: int
    left_bytes: int


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
        self._found: _WalkTotals | None = None

    def __iter__(self) -> Iterator[tuple[int, Frame]]:
        for chunk in self.chunks():
            yield from chunk.frames()

    def chunks(self, begin: int = 0) -> Iterator[Chunk]:
        """The recording, stretch by stretch, from a place in the file on: where a frame's time begins.

        The next one is read and walked beside the consumer of this one, since both hardly need the interpreter.
        """
        walk: Callable[[], Iterable[Chunk]] = partial(self._read_ahead, begin)
        if self.times is None:
            whole = self._whole()
            self.times = tlog_times.judge(whole, session=self._session)
            walk = walk if begin else whole
        for chunk in walk():
            self.times.correct(chunk)
            yield chunk

    @property
    def problems(self) -> list[str]:
        """Sentences on what could not be read, once all of it has been walked."""
        if self._found is None:
            return []
        return list(_problems(self.path.name, self._found, [] if self.times is None else self.times.notes))

    def _whole(self) -> Callable[[], Iterable[Chunk]]:
        """The walk over all of it, to be made again and again. Less than a chunk is kept from the first time on."""
        if rotation.size(self.path) >= self._chunk_bytes:
            return partial(self._read_ahead, 0)
        chunks = list(self._walked(0))
        return lambda: chunks

    def _read_ahead(self, begin: int) -> Iterator[Chunk]:
        walked = self._walked(begin)
        with ThreadPoolExecutor(1) as beside:
            following = beside.submit(next, walked, None)
            while (chunk := following.result()) is not None:
                following = beside.submit(next, walked, None)
                yield chunk

    def _walked(self, begin: int) -> Iterator[Chunk]:
        self._found = None
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
        self._found = _WalkTotals(frames, gaps, skipped, len(octets) - last_end)


def read(path: Path, *, session: bool = False) -> Tlog:
    """The recording at `path`; session: as of `Tlog`. Raises OSError where there is no file that can be read."""
    with rotation.open_parts(path):
        return Tlog(path, session=session)


def _problems(name: str, found: _WalkTotals, notes: list[str]) -> Iterator[str]:
    left = found.left_bytes
    if not found.frames:
        yield f"{name} is empty." if not left else f"{name} holds no MAVLink frame: it is no tlog."
        return
    if found.gaps:
        skipped, times = found.skipped_bytes, "one place" if found.gaps == 1 else f"{found.gaps} places"
        yield f"{name} holds {skipped} bytes in {times} that belong to no MAVLink frame; they were passed over."
    yield from (f"{name}: {note}." for note in notes)
    if 0 < left < TIME_BYTES + LARGEST:
        yield f"{name} ends inside a frame: its last {left} bytes could not be read."
    elif left:
        yield f"{name} ends with {left} bytes that belong to no MAVLink frame; they were passed over."
