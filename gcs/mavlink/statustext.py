"""STATUSTEXT's chunks, put together again.

A text longer than a message comes in chunks of one id, counted up; a chunk that is not full is the last. A sender of
short texts alone leaves the id 0, and so does a PX4 for its first text after boot, in however many chunks; MAVLink 1
has no ids. A PX4 sends nothing after a last chunk that happens to be full. So a text waits for what it lacks, and not
for long: chunks may come out of order, and the place of one that is lost is marked. A text is UTF-8, whose characters
may lie across two chunks.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from gcs.mavlink.codec import Frame

CHUNK_BYTES = 50
MOST_BYTES = 500
"""A text is reported as soon as it is so long; what goes on with it is passed over."""
PATIENCE_S = 0.5
"""The chunks of a text are sent without a pause between them."""
LOST = "…".encode()
"""Stands where chunks are lost."""
_PAYLOAD_BYTES = 1 + CHUNK_BYTES + 3


class TextChunk(NamedTuple):
    """STATUSTEXT's fields, the text as it was sent: up to 50 bytes, and what follows a NUL is none of it."""

    severity: int
    text: bytes
    id: int
    chunk_seq: int


def chunk_of(frame: Frame) -> TextChunk:
    """The fields of a STATUSTEXT, of either version of MAVLink."""
    payload = frame.payload.ljust(_PAYLOAD_BYTES, b"\0")
    text_id = int.from_bytes(payload[CHUNK_BYTES + 1 : CHUNK_BYTES + 3], "little")
    return TextChunk(payload[0], payload[1 : CHUNK_BYTES + 1], text_id, payload[CHUNK_BYTES + 3])


class _Open:
    """A text that is not whole yet."""

    def __init__(self, chunk: TextChunk) -> None:
        self.severity, self.id = chunk.severity, chunk.id
        self.since_s = 0.0
        self.last: int | None = None
        """number of the last chunk, once it has come"""
        self.parts: dict[int, bytes] = {}

    def takes(self, chunk: TextChunk) -> bool:
        """Whether the chunk is of this text: it may have come before, but not as another one."""
        return (
            chunk.id == self.id and self.parts.get(chunk.chunk_seq) in (None, _part(chunk)) and not self._again(chunk)
        )

    def add(self, chunk: TextChunk, time_s: float) -> None:
        part = self.parts[chunk.chunk_seq] = _part(chunk)
        self.since_s = time_s
        if len(part) < CHUNK_BYTES:
            self.last = chunk.chunk_seq if self.last is None else min(self.last, chunk.chunk_seq)

    @property
    def whole(self) -> bool:
        return self.last is not None and all(seq in self.parts for seq in range(self.last + 1))

    def text(self) -> str:
        """As far as it came; trailing white space, with which a PX4 ends it, is cut."""
        joined, follows = b"", 0
        for seq, part in sorted(self.parts.items()):
            joined += part if seq == follows else LOST + part
            follows = seq + 1
        return joined.decode("utf-8", "replace").rstrip()

    def _again(self, chunk: TextChunk) -> bool:
        """Without an id the same first chunk is another text."""
        return chunk.id == 0 and chunk.chunk_seq == 0 and 0 in self.parts


def _part(chunk: TextChunk) -> bytes:
    return chunk.text.partition(b"\0")[0]


class Texts:
    """One vehicle's texts."""

    def __init__(self) -> None:
        self._open: _Open | None = None
        self._cut_id: int | None = None

    def add(self, chunk: TextChunk, time_s: float) -> list[tuple[int, str]]:
        """Take in a chunk received at a session time; (severity, text) of each text that is complete now."""
        if chunk.chunk_seq and chunk.id == self._cut_id:
            return []
        self._cut_id = None
        before = [] if self._open is not None and self._open.takes(chunk) else self.give_up()
        text = self._open = self._open or _Open(chunk)
        text.add(chunk, time_s)
        too_long = sum(map(len, text.parts.values())) >= MOST_BYTES
        if too_long:
            self._cut_id = chunk.id
        return before + (self.give_up() if too_long or text.whole else [])

    @property
    def open(self) -> bool:
        """Whether a text waits for another chunk."""
        return self._open is not None

    def overdue(self, now_s: float) -> list[tuple[int, str]]:
        """The text that has waited too long for another chunk, as far as it came."""
        waited = self._open is not None and now_s - self._open.since_s >= PATIENCE_S
        return self.give_up() if waited else []

    def give_up(self) -> list[tuple[int, str]]:
        """The text that waits, as far as it came."""
        texts = [] if self._open is None else [(self._open.severity, self._open.text())]
        self._open = None
        return texts


def recorded(chunks: Iterable[tuple[float, TextChunk]]) -> Iterator[tuple[float, int, str]]:
    """(session time in s, severity, text) of one vehicle's texts, from their chunks and the times of their
    reception."""
    texts, received_s = Texts(), 0.0
    for time_s, chunk in chunks:
        yield from ((received_s + PATIENCE_S, *text) for text in texts.overdue(time_s))
        received_s = time_s
        yield from ((time_s, *text) for text in texts.add(chunk, time_s))
    yield from ((received_s + PATIENCE_S, *text) for text in texts.give_up())
