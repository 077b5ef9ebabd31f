"""One message that a vehicle would have sent."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from gcs.mavlink.statustext import CHUNK_BYTES


class ImportFailed(Exception):
    """A file that cannot be read as a recording; one sentence."""


class Sample(NamedTuple):
    """A MAVLink message by its name and fields, in MAVLink's own units, as of a time."""

    t_us: int
    """µs since the Unix epoch where the log knows it, else since the vehicle's start"""
    sysid: int
    message: str
    fields: Mapping[str, Any]


def chunks(severity: int, text: str, number: int) -> Iterator[dict[str, Any]]:
    """Fields of STATUSTEXT for a text of any length; `number` tells a long one from those before it."""
    raw = text.encode()
    if len(raw) <= CHUNK_BYTES:
        yield {"severity": severity, "text": raw}
        return
    for seq, at in enumerate(range(0, len(raw) + 1, CHUNK_BYTES)):
        part = raw[at : at + CHUNK_BYTES]
        yield {"severity": severity, "text": part, "id": 1 + number % 65535, "chunk_seq": seq}
