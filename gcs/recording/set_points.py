"""Reads the set points of decisions.jsonl, nearly all of its lines, typed and many at once: JSON line by line takes ten
times as long."""

from __future__ import annotations

import msgspec
import numpy as np
from numpy.typing import NDArray

P_NED, SYSID, T_S = slice(0, 3), 3, 4
"""Columns of what `scan` returns; a set point's velocity is left out."""
COLUMNS = 5

_BEGIN = b'{"kind":"set_point",'
"""as the recorder writes them, with sorted keys"""


class _SetPoint(msgspec.Struct, tag_field="kind", tag="set_point", gc=False):
    p_ned: tuple[float, float, float]
    sysid: int
    t_s: float


_DECODER = msgspec.json.Decoder(_SetPoint)


def scan(block: bytes) -> tuple[NDArray[np.float64], list[bytes]]:
    """(n, COLUMNS) numbers of the set points in whole lines, and the lines that are none in the recorder's form."""
    lines = [line for line in block.split(b"\n") if line]
    own = [line for line in lines if line.startswith(_BEGIN)]
    others = [line for line in lines if not line.startswith(_BEGIN)]
    try:
        told = _DECODER.decode_lines(b"\n".join(own))
    except msgspec.MsgspecError:  # one is broken: only one by one can the others be had
        told = []
        for line in own:
            try:
                told.append(_DECODER.decode(line))
            except msgspec.MsgspecError:
                others.append(line)
    return np.array([(*point.p_ned, point.sysid, point.t_s) for point in told], dtype=np.float64).reshape(
        -1, COLUMNS
    ), others
