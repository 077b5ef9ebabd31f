"""Bundles of a whole tick in one compiled call: marker, HEARTBEAT, set point and grant of each vehicle.

Most vehicles in most ticks are sent nothing else. These frames differ from vehicle to vehicle in few bytes: the codec
makes each once a tick, as a template, and the call writes number and set point into it, sums it and copies it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from fastcrc.crc16 import mcrf4xx
from numba import njit
from numpy.typing import NDArray

from gcs.kernels import kernel
from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.ids import OUR_HEARTBEAT, STATION
from gcs.mavlink.setpoints import PlacedSetPoints, set_point_message

Bytes = NDArray[np.uint8]
Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

GREETING, SET_POINT, GRANT = 0, 1, 2
"""Rows of the templates."""
NUMBER, SYSID, MARKER_BYTES, POINT, GREETED = range(5)
"""Columns of a vehicle's row: the next sequence number; its system id; the length of its marker; the row of its set
point, NONE or LEFT_OUT; whether a HEARTBEAT is due."""
COLUMNS = 5
NONE, LEFT_OUT = -1, -2
MOST_FRAMES = 3
"""Of one vehicle, its marker aside."""
TEMPLATE_BYTES = 72
MARKER_WIDTH = 32
BUNDLE_BYTES = MARKER_WIDTH + MOST_FRAMES * TEMPLATE_BYTES
"""No bundle is longer."""
VALUES = 6
"""Of a set point: position and velocity."""

_SEQ_AT = 4
_VALUES_AT = codec.HEADER_BYTES + 4  # behind time_boot_ms
_TARGET_AT = codec.HEADER_BYTES + 50
_AT_ONCE = 8


def _crc_tables() -> NDArray[np.int32]:
    """(8, 256): what a byte adds to a checksum in which so many further ones follow it, so that eight are summed at
    once."""
    tables = np.empty((_AT_ONCE, 256), np.int32)
    tables[0] = [mcrf4xx(bytes([byte]), 0) for byte in range(256)]
    for k in range(1, _AT_ONCE):
        tables[k] = tables[k - 1] >> 8 ^ tables[0][tables[k - 1] & 0xFF]
    return tables


_TABLES = _crc_tables()
_BEFORE_MARKER = codec.BEFORE_MARKER


@njit(error_model="numpy")
def _sum(frame: Bytes, size: int, seed: int) -> None:
    """Write the checksum of a frame, CRC-16/MCRF4XX of its bytes and the message's seed."""
    end = size - 2
    frame[end] = seed
    crc = _BEFORE_MARKER
    i = 0
    while i + _AT_ONCE <= end + 1:
        crc = (
            _TABLES[7, frame[i] ^ (crc & 0xFF)]
            ^ _TABLES[6, frame[i + 1] ^ (crc >> 8)]
            ^ _TABLES[5, frame[i + 2]]
            ^ _TABLES[4, frame[i + 3]]
            ^ _TABLES[3, frame[i + 4]]
            ^ _TABLES[2, frame[i + 5]]
            ^ _TABLES[1, frame[i + 6]]
            ^ _TABLES[0, frame[i + 7]]
        )
        i += _AT_ONCE
    while i <= end:
        crc = (crc >> 8) ^ _TABLES[0, (crc & 0xFF) ^ frame[i]]
        i += 1
    frame[end], frame[end + 1] = crc & 0xFF, crc >> 8


@njit(error_model="numpy")
def _aim(frame: Bytes, sysid: int, values: Floats) -> bool:
    """Write whose set point it is, and its values; whether they can be written."""
    floats = np.empty(VALUES, np.float32)
    for i in range(VALUES):
        floats[i] = values[i]
        if math.isinf(floats[i]) and not math.isinf(values[i]):
            return False
    wire = floats.view(np.uint8)
    for i in range(4 * VALUES):
        frame[_VALUES_AT + i] = wire[i]
    frame[_TARGET_AT] = sysid
    return True


@kernel(error_model="numpy")
def write_bundles(
    out: Bytes, rows: Ints, markers: Bytes, values: Floats, templates: Bytes, sizes: Ints, cuts: Ints, spans: Ints
) -> tuple[int, int]:
    """Write the bundles of n vehicles, one behind the other; (where the last one ends, row of a set point that no frame
    can hold, or NONE).

    Args:
        out: (n BUNDLE_BYTES,) at least.
        rows: (n, COLUMNS). NUMBER goes on by the frames written; of those LEFT_OUT nothing is written.
        markers: (n, MARKER_WIDTH).
        values: (k, VALUES) position and velocity of each set point in its vehicle's own frame, NED, m and m/s.
        templates: (MOST_FRAMES, TEMPLATE_BYTES), whole frames; overwritten.
        sizes: (MOST_FRAMES, 2), their lengths and CRC seeds.
        cuts: (n, 3), filled: where each bundle begins and ends, and how many frames there are with it.
        spans: (n MOST_FRAMES, 2), filled: where each frame begins and ends; markers are none.
    """
    at = frames = 0
    for k in range(rows.shape[0]):
        point, number = rows[k, POINT], rows[k, NUMBER]
        cuts[k, 0] = at
        if point != LEFT_OUT:
            for i in range(rows[k, MARKER_BYTES]):
                out[at + i] = markers[k, i]
            at += rows[k, MARKER_BYTES]
            for which in range(MOST_FRAMES):
                if (which == GREETING and not rows[k, GREETED]) or (which == SET_POINT and point == NONE):
                    continue
                frame, size = templates[which], sizes[which, 0]
                if which == SET_POINT and not _aim(frame, rows[k, SYSID], values[point]):
                    return at, point
                if which == SET_POINT or frame[_SEQ_AT] != number:
                    frame[_SEQ_AT] = number
                    _sum(frame, size, sizes[which, 1])
                for i in range(size):
                    out[at + i] = frame[i]
                spans[frames, 0], spans[frames, 1] = at, at + size
                at += size
                frames += 1
                number = (number + 1) & 0xFF
            rows[k, NUMBER] = number
        cuts[k, 1], cuts[k, 2] = at, frames
    return at, NONE


class Bundles(NamedTuple):
    """Bundles of n vehicles."""

    raw: bytes
    """one behind the other"""
    cuts: Ints
    """(n, 3) where each begins and ends, and how many frames there are with it"""
    spans: Ints
    """(m, 2) where each frame begins and ends; markers are none"""


def bundled(rows: Ints, markers: Bytes, points: PlacedSetPoints, grant: Message) -> Bundles:
    """The bundles of n vehicles, their `rows` and `markers` as `write_bundles` takes them, of frames from our station.

    `grant`: the SYSTEM_TIME at the end of each. Raises ValueError, as `codec.frame` does, for a set point that no frame
    can hold.
    """
    count = len(rows)
    templates, sizes = np.zeros((MOST_FRAMES, TEMPLATE_BYTES), np.uint8), np.empty((MOST_FRAMES, 2), np.int64)
    for k, message in enumerate((OUR_HEARTBEAT, set_point_message(points.time_ms, 0, (0.0,) * VALUES), grant)):
        frame = codec.frame(message, 0, *STATION)
        templates[k, : len(frame)] = np.frombuffer(frame, np.uint8)
        sizes[k] = len(frame), codec.seed_of(frame)[0]
    out = np.empty(count * BUNDLE_BYTES, np.uint8)
    cuts, spans = np.empty((count, 3), np.int64), np.empty((count * MOST_FRAMES, 2), np.int64)
    end, refused = write_bundles(out, rows, markers, points.values, templates, sizes, cuts, spans)
    if refused != NONE:
        codec.frame(points.message(list(points.rows)[refused]), 0, *STATION)
    return Bundles(out[:end].tobytes(), cuts, spans[: cuts[-1, 2] if count else 0])
