"""One file of a vehicle, read by MAVFTP: no socket and no clock here, time is an argument (s).

    reset    ResetSessions → ACK: what an earlier reader left open is closed
    open     OpenFileRO → ACK with a session
    burst    BurstReadFile from behind the last piece that came → pieces …, again and again, until NAK, end of file
    fill     ReadFile, piece by piece → what the burst lost
    close    TerminateSession; its answer is not needed

Every piece but the last has PIECE_BYTES: ArduPilot reads its packed parameters in pieces of one size only.
[lineage] MAVLink File Transfer Protocol, https://mavlink.io/en/services/ftp.html
"""

from __future__ import annotations

import struct
from enum import Enum
from typing import Any

from gcs.mavlink.codec import Message
from gcs.mavlink.ftp.received_ranges import ReceivedRanges
from gcs.mavlink.ftp.requests import (
    BURST,
    END_OF_FILE,
    FIRST_TRIES,
    OPEN,
    PIECE_BYTES,
    READ,
    REPEAT_S,
    RESET,
    TERMINATE,
    TRIES,
    FileAnswer,
    FileRequests,
)

LARGEST_BYTES = 1 << 22
"""A longer file is given up where all that it has is read: that is built in memory, piece by piece."""
_SIZE = struct.Struct("<I")


class _Stage(Enum):
    RESET = RESET
    OPEN = OPEN
    BURST = BURST
    FILL = READ
    DONE = 0


class FileClient:
    """The dialogue with one vehicle about one file."""

    def __init__(self, requests: FileRequests, path: str, first_bytes: int | None = None) -> None:
        """first_bytes: only so much of it is read, and a shorter file is not it; None: all that it has."""
        self.path = path
        self.pieces: list[tuple[int, bytes]] = []
        """(offset, bytes) as they came, until they are taken away"""
        self.is_whole = self.is_short = False
        """whether it has come; whether it turned out to be shorter than what is read of it"""
        self.problem = ""
        """why it did not come, in words"""
        self._stage = _Stage.RESET
        self._requests = requests
        self._session = 0
        self.came = ReceivedRanges()
        """of the file"""
        self._highest = self._begun_at = 0
        self._end = self._wanted = first_bytes
        self._tries = 0
        self._due_s = 0.0
        self._to_close = False

    @property
    def content(self) -> bytes | None:
        """The whole file, of which no piece was taken away; None where it has not come."""
        return b"".join(data for _, data in sorted(self.pieces)) if self.is_whole else None

    @property
    def done(self) -> bool:
        """Whether nothing is open."""
        return self._stage is _Stage.DONE and not self._to_close

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        opened = self._stage in (_Stage.BURST, _Stage.FILL)
        answer = self._requests.answer(name, content, self._stage.value, self._session if opened else None)
        if answer is None or self._stage is _Stage.DONE:
            return
        if answer.refused:
            self._refused(answer)
        elif self._stage is _Stage.RESET:
            self._go_on(_Stage.OPEN)
        elif self._stage is _Stage.OPEN:
            self._session, self._to_close = answer.session, True
            self._go_on(_Stage.BURST)
            if self._wanted is not None and (len(answer.data) != 4 or _SIZE.unpack(answer.data)[0] < self._wanted):
                self.is_short = True
                self._give_up(f"{self.path} is shorter than {self._wanted} bytes")
        else:
            self._put(answer.offset, answer.data)
            self._tries, self._due_s = 0, now_s + REPEAT_S
            if answer.complete or self._stage is _Stage.FILL:
                self._due_s = now_s
            self._look_on()

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        if self._stage is _Stage.DONE:
            if not self._to_close:
                return []
            self._to_close = False
            return [self.end()]
        if now_s < self._due_s:
            return []
        if self._tries >= (FIRST_TRIES if self._stage is _Stage.RESET else TRIES):
            came = f"after {self.came.first_missing} bytes " if self.came.size_bytes else ""
            self._give_up(f"no answer {came}to a request for {self.path}, though it was asked {self._tries} times")
            return self.poll(now_s)
        self._tries += 1
        self._due_s = now_s + REPEAT_S
        if self._stage is _Stage.OPEN:
            return [self._requests.request(OPEN, data=self.path.encode("ascii"))]
        if self._stage is _Stage.RESET:
            return [self._requests.request(RESET)]
        self._begun_at = self._highest if self._stage is _Stage.BURST else self.came.first_missing
        opcode, session = self._stage.value, self._session
        return [self._requests.request(opcode, session=session, offset=self._begun_at, size=PIECE_BYTES)]

    def end(self) -> Message:
        """The message that ends the transfer."""
        return self._requests.request(TERMINATE, session=self._session)

    def _refused(self, answer: FileAnswer) -> None:
        if self._stage is _Stage.RESET:
            self._go_on(_Stage.OPEN)  # it knows none: nothing is open, or it says so of the file
        elif self._stage is _Stage.BURST and answer.reason == END_OF_FILE:
            # The last pieces may be lost, and what the answer says of its place is with some autopilots the last
            # piece's: the end is where it is the first answer.
            if self._requests.answered_first:
                if self._wanted is not None:
                    self.is_short = True
                    self._give_up(f"{self.path} ended after {self._begun_at} of {self._wanted} bytes")
                    return
                self._end = self._begun_at
            self._tries, self._due_s = 0, 0.0
            self._look_on()
        else:
            self._give_up(f"{self.path}: {answer.why}")

    def _put(self, offset: int, data: bytes) -> None:
        """Keep a piece."""
        if self._wanted is not None:
            data = data[: max(self._wanted - offset, 0)]
        if offset % PIECE_BYTES or not data:
            return
        if new := self.came.add(offset, offset + len(data)) - offset:
            self.pieces.append((offset, data[:new]))
        self._highest = max(self._highest, offset + len(data))
        if len(data) < PIECE_BYTES and self._wanted is None:
            self._end = offset + len(data)

    def _look_on(self) -> None:
        """End where everything has come, or there is more than is taken; fill what is missing where the end is
        known."""
        if self._highest > LARGEST_BYTES and self._wanted is None:
            self._give_up(f"{self.path} has more than {LARGEST_BYTES} bytes")
        elif self._end is not None and self.came.first_missing >= self._end:
            self.is_whole, self._stage = True, _Stage.DONE
        elif self._end is not None and self._highest >= self._end and self._stage is _Stage.BURST:
            self._go_on(_Stage.FILL)

    def _go_on(self, stage: _Stage) -> None:
        self._stage, self._tries, self._due_s = stage, 0, 0.0

    def _give_up(self, why: str) -> None:
        self.problem, self._stage = why, _Stage.DONE
