"""Bundles of a whole tick in one compiled call: marker, HEARTBEAT, set point and grant of each vehicle.

Most vehicles in most ticks are sent nothing else. These frames differ from vehicle to vehicle, and from tick to tick,
in few bytes: the codec makes each once, as a template, and the call writes times, number and set point into it, sums it
and copies it.
"""

from __future__ import annotations

from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.mavlink.bundle_frames import (
    _CRC_BYTES,
    _GRANT,
    _HEADER_BYTES,
    _HEARTBEAT,
    _SEQ_AT,
    _SET_POINT,
    _TARGET_AT,
    _VALUES_AT,
    BUNDLE_BYTES,
    LEFT_OUT,
    MARKER_WIDTH,
    MOST_FRAMES,
    NONE,
    TEMPLATE_BYTES,
    VALUES,
    vehicle_at,
)
from cython.cimports.gcs.mavlink.payload import put, put_f32
from cython.cimports.libc import math
from cython.cimports.libc.string import memcpy
from cython.cimports.skytender.checksum import crc_of, ended
from numpy.typing import NDArray

from gcs.mavlink import codec
from gcs.mavlink.ids import OUR_HEARTBEAT, STATION
from gcs.mavlink.setpoints import set_point_message

__all__ = [
    "BUNDLE_BYTES", "COLUMNS", "HEARTBEAT_DUE", "LEFT_OUT", "MARKER_BYTES", "MARKER_WIDTH", "MOST_FRAMES", "NONE",
    "NUMBER", "POINT", "SYSID", "Bytes", "Floats", "Ints", "made_templates", "write_bundles",
]  # fmt: skip

Bytes = NDArray[np.uint8]
Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

COLUMNS = 5
NUMBER, SYSID, MARKER_BYTES, POINT, HEARTBEAT_DUE = range(COLUMNS)
"""Columns of a vehicle's row, in the order of the struct Vehicle in bundle_frames.pxd."""


def _sum(frame: Any, size: int, seed: int) -> None:
    """Write the checksum of a frame."""
    put(frame, size - _CRC_BYTES, ended(crc_of(frame, 1, size - _CRC_BYTES), seed), _CRC_BYTES)


def _aim(frame: Any, sysid: int, values: Any) -> bool:
    """Write whose set point it is, and its values; whether they can be written."""
    for i in range(VALUES):
        value = values[i]
        if math.isinf(value) and not math.isinf(values[i]):
            return False
        put_f32(frame, _VALUES_AT + 4 * i, value)
    frame[_TARGET_AT] = sysid
    return True


def _date(templates: Any, sizes: Any, point_ms: int, unix_us: int, grant_ms: int) -> None:
    """Write the times of a tick into set point and grant, which is as long as its last byte that is not 0."""
    put(cython.address(templates[_SET_POINT, 0]), _HEADER_BYTES, point_ms, 4)
    grant = cython.address(templates[_GRANT, 0])
    put(grant, _HEADER_BYTES, unix_us, 8)
    put(grant, _HEADER_BYTES + 8, grant_ms, 4)
    payload = 12
    while payload > 1 and grant[_HEADER_BYTES + payload - 1] == 0:
        payload -= 1
    grant[1] = payload
    sizes[_GRANT, 0] = _HEADER_BYTES + payload + _CRC_BYTES
    _sum(grant, sizes[_GRANT, 0], sizes[_GRANT, 1])


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
) -> tuple[int, int]:
    """Write the bundles of n vehicles, one behind the other; (where the last one ends, row of a set point that no frame
    can hold, or NONE).

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
        vehicle = vehicle_at(rows, k)
        number = vehicle.number
        cuts[k, 0] = at
        if vehicle.point != LEFT_OUT:
            memcpy(cython.address(out[at]), cython.address(markers[k, 0]), vehicle.marker_bytes)
            at += vehicle.marker_bytes
            for which in range(MOST_FRAMES):
                if which == _HEARTBEAT and not vehicle.heartbeat_due:
                    continue
                if which == _SET_POINT and vehicle.point == NONE:
                    continue
                frame = cython.address(templates[which, 0])
                size = sizes[which, 0]
                if which == _SET_POINT and not _aim(frame, vehicle.sysid, cython.address(values[vehicle.point, 0])):
                    return at, vehicle.point
                if which == _SET_POINT or frame[_SEQ_AT] != number:
                    frame[_SEQ_AT] = number
                    _sum(frame, size, sizes[which, 1])
                memcpy(cython.address(out[at]), frame, size)
                spans[frames, 0], spans[frames, 1] = at, at + size
                at += size
                frames += 1
                number = (number + 1) & 0xFF
            vehicle.number = number
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
