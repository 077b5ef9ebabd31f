"""A .tlog to be played: which frame was sent when, from which sender to which receiver, from any time on.

One compiled pass over the file makes an index: it is cut into blocks, and each block knows the last place of every kind
of message of every sender in it. What was known at a time is then fed from the last of each before its block, and what
the block itself says; however long the recording is, that is a part of it.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from gcs.mavlink import codec, records
from gcs.mavlink.codec import Frame
from gcs.mavlink.gaps import GapCounter, RecordedGaps, resumed
from gcs.mavlink.ids import STATION
from gcs.recording import rotation, tlog_reader, tlog_walk
from gcs.recording.frame_heads import frame_keys, last_of_each
from gcs.recording.tlog_walk import AT, COMPID, MSGID, SEQ, SYSID, T_US, IntArray
from skytender import mavlink as mav

BLOCK_BYTES = 1 << 19
MOST_BLOCKS = 256
READ_BYTES = 1 << 18
WARM_S = 6.0
"""A vehicle's draw is read off so much of what its battery said."""
_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")
_HEARTBEAT = codec.msgid("HEARTBEAT")
_RELAYED = (codec.msgid("FOLLOW_TARGET"), codec.msgid("NAMED_VALUE_INT"))
_BATTERY = codec.msgid("BATTERY_STATUS")
_OF_BATTERIES = [_BATTERY, *map(codec.msgid, ("SYS_STATUS", "NAMED_VALUE_INT", "PARAM_VALUE", "HEARTBEAT"))]


class RecordedFrame(NamedTuple):
    """One frame of a recording: when it came, and whether it went to a vehicle."""

    t_s: float
    frame: Frame
    sent: bool


class Directions:
    """Sender and receiver of each frame.

    Ground stations are known by their HEARTBEAT. In a session of ours a vehicle's own FOLLOW_TARGET or counter behind
    the SYSTEM_TIME that ended its answer has been relayed to another.
    """

    def __init__(self, *, session: bool) -> None:
        self._session = session
        self._stations: set[tuple[int, int]] = {STATION} if session else set()
        self._answered: set[tuple[int, int]] = set()
        self._t_us = -1

    def sent(self, t_us: int, frame: Frame) -> bool:
        """Whether this frame went to a vehicle."""
        sender = (frame.sysid, frame.compid)
        if t_us != self._t_us:
            self._t_us = t_us
            self._answered.clear()
        if frame.msgid == _HEARTBEAT and frame.payload[4:5] == _STATION:
            self._stations.add(sender)
        if sender in self._stations:
            return True
        if self._session and frame.msgid == _SYSTEM_TIME:
            self._answered.add(sender)
        return frame.msgid in _RELAYED and sender in self._answered


_STATION = bytes([mav.MAV_TYPE_GCS])


_NONE = np.empty(0, dtype=np.int64)
_NONE_PLACED = np.empty((0, 2), dtype=np.int64)


class _Block(NamedTuple):
    """A stretch of the file."""

    begin: int
    from_s: float
    counted: tuple[Any, ...]
    """sequence numbers before it, as `RecordedGaps.packed`"""
    keys: IntArray = _NONE
    places: IntArray = _NONE_PLACED
    """(n, 2) of the last frame of each key: place in the file, time in µs"""

    def with_more(self, keys: IntArray, places: IntArray) -> _Block:
        """The same with further frames at its end."""
        keys, places = np.concatenate([self.keys, keys]), np.concatenate([self.places, places])
        last = last_of_each(keys)
        return self._replace(keys=keys[last], places=places[last])


class TlogIndex:
    """One .tlog. Raises OSError where it cannot be read.

    epoch_us: the time that is 0 s; the first frame's without it. block_bytes: of the index; by the file's size without
    it. metered: vehicles whose energy is known only from all that they said of their batteries. `watch` is given
     each stretch of the file as it is read. `problems` says what could not be read.
    """

    def __init__(
        self,
        path: Path,
        *,
        epoch_us: int | None = None,
        session: bool = False,
        block_bytes: int | None = None,
        metered: Collection[int] = (),
        progress: Callable[[float], None] = lambda _: None,
        watch: Callable[[tlog_walk.Chunk], object] = lambda _: None,
    ) -> None:
        self.path = path
        self._session = session
        self._blocks: list[_Block] = []
        self.frames = 0
        block_bytes = block_bytes or max(BLOCK_BYTES, rotation.size(path) // MOST_BLOCKS)
        log = tlog_reader.Tlog(path, chunk_bytes=block_bytes, session=session)
        gaps = RecordedGaps()
        self._metered = frozenset(metered)
        of_batteries = [_NONE_PLACED]
        latest_us, last_us, first_us = -1, -1, None
        for chunk in log.chunks():
            heads = chunk.heads
            if len(heads):
                first_us = int(heads[0, T_US]) if first_us is None else first_us
                epoch_us = first_us if epoch_us is None else epoch_us
                keys, places = frame_keys(chunk.octets, heads, _SUBJECTS), _placed(chunk)
                # A block begins with a new time: whatever came at one time, as a tick's answers, is read together.
                new = int(np.argmax(heads[:, T_US] != last_us)) if self._blocks else 0
                if new or (self._blocks and heads[0, T_US] == last_us):
                    new = new or len(heads)
                    self._blocks[-1] = self._blocks[-1].with_more(keys[:new], places[:new])
                    _count(gaps, heads[:new])
                if new < len(heads):
                    latest_us = max(latest_us, int(heads[new, T_US]))
                    begin = max(int(places[new, 0]) - tlog_walk.TIME_BYTES, 0)
                    from_s = (latest_us - epoch_us) / 1e6
                    block = _Block(begin, from_s, gaps.packed())
                    self._blocks.append(block.with_more(keys[new:], places[new:]))
                    _count(gaps, heads[new:])
                latest_us = max(latest_us, int(heads[:, T_US].max()))
                last_us = int(heads[-1, T_US])
                self.frames += len(heads)
                if metered:
                    mine = np.isin(heads[:, SYSID], list(metered)) & np.isin(heads[:, MSGID], _OF_BATTERIES)
                    of_batteries.append(places[mine])
            watch(chunk)
            progress(chunk.read_share)
        self._of_batteries = np.concatenate(of_batteries)
        self.problems = log.problems
        self._times = log.times
        self._epoch_us = epoch_us or 0
        self.zero_s = self._epoch_us / 1e6
        """stamp of the recording's 0 s, s"""
        self.from_s = 0.0 if first_us is None else (first_us - self._epoch_us) / 1e6
        self.to_s = (latest_us - self._epoch_us) / 1e6 if self.frames else 0.0

    def play(self, from_s: float) -> Iterator[RecordedFrame]:
        """Everything from the block of a time on, in the file's order: what came before that time is among it.

        Times do not fall, also where the recorder's clock was set back.
        """
        block = self._blocks[self._block_of(from_s)]
        directions = Directions(session=self._session)
        log, latest_s = tlog_reader.Tlog(self.path, chunk_bytes=READ_BYTES, times=self._times), block.from_s
        for chunk in log.chunks(block.begin):
            for t_us, frame in chunk.frames():
                latest_s = max(latest_s, (t_us - self._epoch_us) / 1e6)
                yield RecordedFrame(latest_s, frame, directions.sent(t_us, frame))

    def before(self, from_s: float) -> list[RecordedFrame]:
        """Frames known before the block of a time: the last of each kind of message, and of batteries a while more.

        Frames sent to vehicles are among them, as the vehicles' own are.
        """
        at = self._block_of(from_s)
        earlier = self._blocks[:at]
        if not earlier:
            return []
        keys = np.concatenate([block.keys for block in reversed(earlier)])
        places = np.concatenate([block.places for block in reversed(earlier)])
        end = self._blocks[at].begin
        of_batteries = self._of_batteries[self._of_batteries[:, 0] < end]
        found = dict(places[np.unique(keys, return_index=True)[1]].tolist()) | dict(of_batteries.tolist())
        warm_us = (from_s - WARM_S) * 1e6 + self._epoch_us
        first = self._block_of(from_s - WARM_S)
        if first < at:
            log = tlog_reader.Tlog(self.path, chunk_bytes=READ_BYTES, times=self._times)
            for chunk in log.chunks(earlier[first].begin):
                if chunk.begin >= end:
                    break
                heads, placed = chunk.heads, _placed(chunk)
                wanted = (heads[:, MSGID] == _BATTERY) & (heads[:, T_US] >= warm_us) & (placed[:, 0] < end)
                found |= dict(placed[wanted].tolist())
        directions = Directions(session=False)
        frames = []
        with rotation.open_parts(self.path) as file:
            for place, t_us in sorted(found.items()):
                file.seek(place)
                raw = tlog_walk.raw_at(file.read(tlog_reader.LARGEST), 0)
                frame = Frame(raw[5], raw[6], raw[4], int.from_bytes(raw[7:10], "little"), raw)
                frames.append(RecordedFrame((t_us - self._epoch_us) / 1e6, frame, directions.sent(t_us, frame)))
        # Batteries last: their reports are read with what was armed, given and received. Where everything of a vehicle
        # is recorded, that is in the recording too.
        return sorted(frames, key=lambda each: each.frame.msgid == _BATTERY and each.frame.sysid not in self._metered)

    def gaps_before(self, from_s: float) -> GapCounter:
        """The sequence numbers as they had been counted before the block of a time."""
        return resumed(*self._blocks[self._block_of(from_s)].counted)

    def _block_of(self, t_s: float) -> int:
        """The last block that begins before a time."""
        at = 0
        for index, block in enumerate(self._blocks):
            if block.from_s < t_s:
                at = index
        return at


def _placed(chunk: tlog_walk.Chunk) -> IntArray:
    """(n, 2) of each frame its place in the file and its time in µs."""
    return np.column_stack((chunk.begin + chunk.heads[:, AT], chunk.heads[:, T_US]))


def _count(gaps: RecordedGaps, heads: IntArray) -> None:
    gaps.count(heads[:, SYSID], heads[:, COMPID], heads[:, SEQ])


def _subjects() -> IntArray:
    """(message id, where in its payload begins what sets one of them apart from another, and how long that is)."""
    distinguished_by = {
        "NAMED_VALUE_INT": "name",
        "NAMED_VALUE_FLOAT": "name",
        "PARAM_VALUE": "param_id",
        "BATTERY_STATUS": "id",
        "ADSB_VEHICLE": "ICAO_address",
        "SET_POSITION_TARGET_LOCAL_NED": "target_system",
    }
    rows = []
    for message, field in distinguished_by.items():
        shape = codec.layout(message)
        kind, at = dict(records.dtype(shape).fields or {})[field][:2]
        rows.append((shape.msgid, at, kind.itemsize))
    return np.array(rows, dtype=np.int64)


_SUBJECTS = _subjects()
