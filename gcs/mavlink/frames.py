"""Frames, and a datagram taken apart into its frames. Nothing that a network sends makes this raise."""

from __future__ import annotations

from typing import Any, NamedTuple

import cython
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.gcs.mavlink.frames import MOST_TRIES
from cython.cimports.skytender.frames import HEADER_BYTES, MAGIC, MAGIC_1
from cython.cimports.skytender.intact_frames import NO_SEED, intact_at, next_marker

from gcs.mavlink import dialect

"""MOST_TRIES: places in a datagram that may look like a frame's beginning and be none, before the rest of it is passed
over."""

_new = tuple.__new__  # fills a named tuple from a tuple without the detour over its constructor


class Frame(NamedTuple):
    """One MAVLink 2 frame: its header's numbers, and `raw`, the whole frame as it stood on the wire."""

    sysid: int
    compid: int
    seq: int
    msgid: int
    raw: bytes

    @property
    def payload(self) -> bytes:
        """Bytes as received: trailing zeros may be cut."""
        return self.raw[HEADER_BYTES : HEADER_BYTES + self.raw[1]]


class Split(NamedTuple):
    """Content of a datagram. `malformed` counts runs of bytes that belong to no frame; `unknown` the frames whose
    message id is not in the dialect, which no table can check or decode."""

    frames: list[Frame]
    malformed: int
    unknown: int
    older: list[Frame]
    """that came in MAVLink 1, in the form of MAVLink 2"""
    end: int
    """where the last frame ends"""


def split(datagram: bytes) -> Split:
    """Take a datagram apart into its frames; never raises.

    A frame counts when its checksum is right. An unknown id's checksum has an unknown seed, so such a frame must fit
    twice over: some seed must explain its checksum, and it must lie without a gap between other frames or the
    datagram's ends. Signed frames are taken, their signature unchecked; any other incompatibility flag is malformed.
    Size, marker and flags are looked at before a checksum is taken, and no more than MOST_TRIES places
    that are no frame are tried: what a stranger can make this cost is bounded.
    """
    frames: list[Frame] = []
    older: list[Frame] = []
    malformed = unknown = tries = frame_end = 0  # frame_end: where the last frame ended
    data = cython.cast("const unsigned char *", PyBytes_AS_STRING(datagram))
    size = len(datagram)
    at = next_marker(data, 0, size)
    while at < size and tries < MOST_TRIES:
        intact = intact_at(data, at, size)
        if intact.end and (intact.seed != NO_SEED or (at == frame_end and _begins_frame(data, intact.end, size))):
            malformed += at != frame_end
            unknown += intact.seed == NO_SEED
            if intact.version == 1:
                raw = dialect.newer_form(datagram, at)
                older.append(_new(Frame, (data[at + 3], data[at + 4], data[at + 2], intact.msgid, raw)))
            else:
                raw = datagram[at : intact.end]
                frames.append(_new(Frame, (data[at + 5], data[at + 6], data[at + 4], intact.msgid, raw)))
            frame_end = intact.end
            at = next_marker(data, frame_end, size)
        else:
            tries += 1
            at = next_marker(data, at + 1, size)
    return _new(Split, (frames, malformed + (frame_end != size), unknown, older, frame_end))


def _begins_frame(data: Any, at: int, size: int) -> bool:
    """Whether the bytes end there, or a frame may begin."""
    return bool(at == size or data[at] == MAGIC or data[at] == MAGIC_1)
