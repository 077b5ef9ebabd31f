"""Bundles of a whole tick in one compiled call: marker, HEARTBEAT, set point and grant of each vehicle.

Most vehicles in most ticks are sent nothing else. These frames differ from vehicle to vehicle in few bytes: the codec
makes each once a tick, as a template, and the call writes number and set point into it, sums it and copies it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gcs.kernel_files import checksum
from gcs.kernels import UNCOUNTED, inner, kernel
from gcs.mavlink import codec, datagram
from gcs.mavlink.codec import Message
from gcs.mavlink.datagram import CRC_TABLE, crc_of
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


@inner(**UNCOUNTED)
def _sum(frame: Bytes, size: int, seed: int) -> None:
    """Write the checksum of a frame."""
    end = size - codec.CRC_BYTES
    crc = crc_of(frame, 1, end, CRC_TABLE)
    crc = crc >> 8 ^ np.int64(CRC_TABLE[0, (crc ^ seed) & 0xFF])
    frame[end], frame[end + 1] = crc & 0xFF, crc >> 8


@inner(**UNCOUNTED)
def _aim(frame: Bytes, sysid: int, values: Floats) -> bool:
    """Write whose set point it is, and its values; whether they can be written."""
    for i in range(VALUES):
        value = np.float32(values[i])
        if math.isinf(value) and not math.isinf(values[i]):
            return False
        bits = np.int64(value.view(np.uint32))
        for k in range(4):
            frame[_VALUES_AT + 4 * i + k] = (bits >> (8 * k)) & 0xFF
    frame[_TARGET_AT] = sysid
    return True


def _compiled(build: int) -> Callable[..., tuple[int, int]]:
    """The entry, kept by numba; `build`: checksum of the other file that it is made of."""

    @kernel(**UNCOUNTED)
    def write(
        out: Bytes, rows: Ints, markers: Bytes, values: Floats, templates: Bytes, sizes: Ints, cuts: Ints, spans: Ints
    ) -> tuple[int, int]:
        _ = build
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

    return write


write_bundles = _compiled(checksum(datagram))
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
