"""Form of a file, by its first bytes."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path

_LOOKED_AT = 4096


class Form(StrEnum):
    """Kinds of files that are given for recordings; the value names one in a sentence."""

    TLOG = "a recording of MAVLink frames"
    DATAFLASH = "an ArduPilot DataFlash log"
    ULOG = "a PX4 ULog"
    TEXT_LOG = "an ArduPilot log as text"
    PLAN = "a QGroundControl plan"
    WAYPOINTS = "a list of mission items"
    PARAMETERS = "a file of parameters"
    LFS_POINTER = "a pointer of Git LFS to a file: fetch that with `git lfs pull`"
    GZIP = "a gzip archive: unpack it first"
    ZIP = "a zip archive: unpack it first"
    PARQUET = "a Parquet table"
    MCAP = "an MCAP file"
    CAPTURE = "a packet capture"


_BEGINNINGS: tuple[tuple[bytes, Form], ...] = (
    (b"\xa3\x95", Form.DATAFLASH),
    (b"ULog\x01\x12\x35", Form.ULOG),
    (b"FMT, ", Form.TEXT_LOG),
    (b"QGC WPL", Form.WAYPOINTS),
    (b"RALLY ", Form.WAYPOINTS),
    (b"# Onboard parameters", Form.PARAMETERS),
    (b"version https://git-lfs", Form.LFS_POINTER),
    (b"\x1f\x8b", Form.GZIP),
    (b"PK\x03\x04", Form.ZIP),
    (b"PAR1", Form.PARQUET),
    (b"\x89MCAP0\r\n", Form.MCAP),
    (b"\xd4\xc3\xb2\xa1", Form.CAPTURE),
    (b"\x0a\x0d\x0d\x0a", Form.CAPTURE),
)


def form_of(path: Path) -> Form:
    """The form of a file; TLOG where nothing else is seen, for frames may begin anywhere. Raises OSError."""
    with path.open("rb") as file:
        begin = file.read(_LOOKED_AT)
    for marker, form in _BEGINNINGS:
        if begin.startswith(marker):
            return form
    if begin.lstrip().startswith(b"{") and b'"fileType"' in begin:
        return Form.PLAN
    return Form.TLOG
