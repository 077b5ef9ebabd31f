"""Sequence numbers: giving them, and knowing by them when a vehicle's tick is in.

A number is one byte and wraps. Of two numbers the later is the one fewer than 128 steps ahead: that is why a tick holds
at most 127 frames (docs/protocol/link.md#answer).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.datagram import FrameRun
from gcs.mavlink.frame_runs import (
    ADDRESS,
    AWAITED,
    COMPID_OF,
    GRANTED_MS,
    HALF,
    HELD,
    NEXT,
    NO_RUN,
    NOT_GRANTED,
    NOWHERE,
    NUMBERS,
    RUN,
)

FIRST_ANSWER = 2
"""The number of a vehicle's first answer: its hello took 0 (HEARTBEAT) and 1 (SYSTEM_TIME)."""
SHARED = 1
"""Time in the hello of a vehicle that shares its address with others."""

_HEARTBEAT = codec.msgid("HEARTBEAT")
_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")


def sequence_numbers() -> Iterator[int]:
    """The numbers of one connection's outgoing frames: 0 … 255, 0 …"""
    return cycle(range(NUMBERS))


class Hello(NamedTuple):
    """Content of the two frames that a vehicle repeats until its first bundle."""

    secret: int
    """by which the supervisor knows its own vehicles; 0 without one"""
    shared: bool
    """whether others speak from the same address"""


def hello_of(frames: Sequence[Frame]) -> Hello | None:
    """A datagram's frames as a hello; None where they are none."""
    if [(frame.seq, frame.msgid) for frame in frames] != [(0, _HEARTBEAT), (1, _SYSTEM_TIME)]:
        return None
    told = codec.fields(frames[1])
    return Hello(int(told.time_unix_usec), told.time_boot_ms == SHARED)


class TickCollector:
    """One vehicle's answer to one grant, gathered from datagrams that may be lost, split, repeated or out of order.

    The tick is in when the vehicle's own SYSTEM_TIME, at a datagram's end, says the granted time and no number since
    the last tick is missing. Hellos carry numbers before `FIRST_ANSWER` and so are old from the start.

    What of it compiled code needs, which takes in whole answers by itself, is a row (gcs/mavlink/datagram.py).
    """

    def __init__(self, sysid: int, compid: int, next_seq: int = FIRST_ANSWER) -> None:
        self._sender = sysid, compid
        self._row = np.empty(AWAITED, np.int64).data
        self._row[NEXT], self._row[GRANTED_MS], self._row[COMPID_OF] = next_seq % NUMBERS, NOT_GRANTED, compid
        self._row[HELD], self._row[ADDRESS], self._row[RUN] = 0, NOWHERE, NO_RUN
        self._held: dict[int, Frame] = {}  # by steps after the last complete tick
        self._whole: Sequence[Frame] = ()  # the tick, where one datagram holds nothing else
        self._end: int | None = None  # where the answer's SYSTEM_TIME stands
        self.complete = False
        """whether the tick is in"""

    def live_in(self, row: NDArray[np.int64]) -> None:
        """Keep what compiled code needs in this row (AWAITED,) from now on."""
        row[:] = self._row
        self._row = row.data

    @property
    def held(self) -> int:
        """Number of frames of the unfinished tick received: it grows when there is progress."""
        return len(self._whole) or len(self._held)

    def begin(self, t_ms: int) -> None:
        """Wait for the answer to the grant of `t_ms`. Raises RuntimeError while an earlier tick has not been taken."""
        if self._row[GRANTED_MS] != NOT_GRANTED:
            raise RuntimeError(f"tick {self._row[GRANTED_MS]} of vehicle {self._sender[0]} has not been taken yet")
        self._row[GRANTED_MS] = t_ms

    def feed(self, frames: Sequence[Frame]) -> bool:
        """Take in one datagram's frames; True when the tick is complete. Frames of anyone else are passed over."""
        granted_ms = self._row[GRANTED_MS]
        if not frames or granted_ms == NOT_GRANTED:
            return self.complete
        answered_ms = self._answered_ms(frames)
        if answered_ms is not None and answered_ms < granted_ms:
            return self.complete  # repeated so late that its numbers may have come round to new ones
        if not self._held and answered_ms == granted_ms and self._is_whole(frames):
            self._whole, self._end, self.complete, self._row[HELD] = frames, len(frames) - 1, True, 1
            return True
        if self._whole:
            return True
        held, first, (system, component), last = self._held, self._row[NEXT], self._sender, frames[-1]
        for frame in frames:
            sysid, compid, seq, _, _ = frame
            step = (seq - first) % NUMBERS
            if step < HALF - 1 and sysid == system and compid == component:
                held.setdefault(step, frame)
                if frame is last and answered_ms == granted_ms:
                    self._end = step
        end, self._row[HELD] = self._end, len(held) > 0
        self.complete = end is not None and all(map(held.__contains__, range(end + 1)))
        return self.complete

    def pop_frames(self) -> Sequence[Frame]:
        """The tick's frames in the order of their numbers, SYSTEM_TIME last, each once.

        Raises RuntimeError when the tick is not complete.
        """
        if self._end is None or not self.complete:
            raise RuntimeError(f"tick {self._row[GRANTED_MS]} of vehicle {self._sender[0]} is not complete")
        length = self._end + 1
        frames, self._whole = self._whole, ()
        if not frames:
            frames = [self._held.pop(step) for step in range(length)]
            self._held = {step - length: frame for step, frame in self._held.items()}
        row = self._row
        row[NEXT], row[GRANTED_MS], row[HELD] = (row[NEXT] + length) % NUMBERS, NOT_GRANTED, len(self._held) > 0
        self._end, self.complete = None, False
        return frames

    def _answered_ms(self, frames: Sequence[Frame]) -> int | None:
        """The time that the vehicle's own SYSTEM_TIME says at the end of these frames; None where there is none."""
        if isinstance(frames, FrameRun) and frames.in_step:
            return frames.time_ms if frames.sender == self._sender else None
        last = frames[-1]
        if last[:2] == self._sender and last.msgid == _SYSTEM_TIME:
            return int(codec.fields(last).time_boot_ms)
        return None

    def _is_whole(self, frames: Sequence[Frame]) -> bool:
        """Whether these are the next numbers, one after the other, of this sender alone."""
        number, (system, component) = self._row[NEXT], self._sender
        if len(frames) >= HALF:
            return False
        if isinstance(frames, FrameRun) and frames.in_step:
            return frames.first == number and frames.sender == self._sender
        for sysid, compid, seq, _, _ in frames:
            if seq != number or sysid != system or compid != component:
                return False
            number = (number + 1) % NUMBERS
        return True
