"""Bundles of a whole tick in one compiled call: marker, HEARTBEAT, set point and grant of each vehicle.

Most vehicles in most ticks are sent nothing else. These frames differ from vehicle to vehicle, and from tick to tick,
in few bytes: the codec makes each once, as a template, and the call writes times, number and set point into it, sums it
and copies it.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.kernels import UNCOUNTED, inner
from gcs.mavlink import codec
from gcs.mavlink.datagram import CRC_TABLE, crc_of
from gcs.mavlink.ids import OUR_HEARTBEAT, STATION
from gcs.mavlink.setpoints import set_point_message

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


@inner(**UNCOUNTED)
def _write_number(frame: Bytes, at: int, number: int, size: int) -> None:
    """Write a whole number, low byte first."""
    for k in range(size):
        frame[at + k] = (number >> (8 * k)) & 0xFF


@inner(**UNCOUNTED)
def _date(templates: Bytes, sizes: Ints, point_ms: int, unix_us: int, grant_ms: int) -> None:
    """Write the times of a tick into set point and grant, which is as long as its last byte that is not 0."""
    _write_number(templates[SET_POINT], codec.HEADER_BYTES, point_ms, 4)
    grant = templates[GRANT]
    _write_number(grant, codec.HEADER_BYTES, unix_us, 8)
    _write_number(grant, codec.HEADER_BYTES + 8, grant_ms, 4)
    payload = 12
    while payload > 1 and grant[codec.HEADER_BYTES + payload - 1] == 0:
        payload -= 1
    grant[1] = payload
    sizes[GRANT, 0] = codec.HEADER_BYTES + payload + codec.CRC_BYTES
    _sum(grant, sizes[GRANT, 0], sizes[GRANT, 1])


@inner(**UNCOUNTED)
def write_bundles(
    out: Bytes,
    rows: Ints,
    markers: Bytes,
    values: Floats,
    templates: Bytes,
    sizes: Ints,
    cuts: Ints,
    spans: Ints,
    point_ms: int,
    unix_us: int,
    grant_ms: int,
) -> Any:
    """Kernel: write the bundles of n vehicles, one behind the other; (where the last one ends, row of a set point that
    no frame can hold, or NONE).

    Args:
        out: (n BUNDLE_BYTES,) at least.
        rows: (n, COLUMNS). NUMBER goes on by the frames written; of those LEFT_OUT nothing is written.
        markers: (n, MARKER_WIDTH).
        values: (k, VALUES) position and velocity of each set point in its vehicle's own frame, NED, m and m/s.
        templates, sizes: as `made_templates` gives them; overwritten.
        cuts: (n, 3), filled: where each bundle begins and ends, and how many frames there are with it.
        spans: (n MOST_FRAMES, 2), filled: where each frame begins and ends; markers are none.
        point_ms: the set points' time since boot, in ms.
        unix_us, grant_ms: the grant's, in µs since 1970 and in ms since boot. Of more than 32 bits, the last count.
    """
    _date(templates, sizes, point_ms, unix_us, grant_ms)
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


def made_templates() -> tuple[Bytes, Ints]:
    """HEARTBEAT, set point and grant from our station: whole frames (MOST_FRAMES, TEMPLATE_BYTES), and the length and
    CRC seed of each (MOST_FRAMES, 2)."""
    templates, sizes = np.zeros((MOST_FRAMES, TEMPLATE_BYTES), np.uint8), np.empty((MOST_FRAMES, 2), np.int64)
    grant = codec.message("SYSTEM_TIME", time_unix_usec=0, time_boot_ms=0)
    for k, message in enumerate((OUR_HEARTBEAT, set_point_message(0, 0, (0.0,) * VALUES), grant)):
        frame = codec.frame(message, 0, *STATION)
        templates[k, : len(frame)] = np.frombuffer(frame, np.uint8)
        sizes[k] = len(frame), codec.seed_of(frame)[0]
    return templates, sizes
