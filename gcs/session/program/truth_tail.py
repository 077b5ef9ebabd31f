"""Vehicles' own truth at one time of a session that still flies: their files are read as far as they have been written
(docs/protocol/folder.md#truth).

A vehicle writes a record before the answer that reports it, so that in lockstep the record of a snapshot's time is
there, and perhaps the next one, which waits.
"""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from gcs.recording.truth import FOLDER

_STATE = ("n", "e", "d", "vn", "ve", "vd", "roll", "pitch", "yaw", "roll_rate", "pitch_rate", "yaw_rate")
_ENERGY = ("drawn_j", "received_j", "given_j", "remaining_j")
_NAMES = ("time_s", *_STATE, *_ENERGY)
_NUMBER_BYTES = 8
_BEGIN = struct.Struct("<2d")
"""of a record: its time, and how many numbers of thrust follow the others"""
_ROUNDING_S = 1e-6


@dataclass(frozen=True, slots=True)
class Truth:
    """Motion and energy of n vehicles by their own records, not by what they report. NaN before a vehicle's first
    record, and for a vehicle without records. Common NED frame."""

    sysid: NDArray[np.int64]
    """(n,) in order"""
    time_s: NDArray[np.float64]
    """(n,) session time of each vehicle's record: the snapshot's, or the last one before it"""
    p_ned: NDArray[np.float64]
    """(n, 3) m"""
    v_ned: NDArray[np.float64]
    """(n, 3) m/s"""
    attitude_rad: NDArray[np.float64]
    """(n, 3) roll, pitch, yaw"""
    rates_rad_s: NDArray[np.float64]
    """(n, 3) of roll, pitch and yaw"""
    drawn_j: NDArray[np.float64]
    """(n,) energy drawn from the battery"""
    received_j: NDArray[np.float64]
    """(n,) from tankers and bases"""
    given_j: NDArray[np.float64]
    """(n,) to receivers"""
    remaining_j: NDArray[np.float64]
    """(n,) in the battery"""


class TruthTails:
    """The files of a session's vehicles, each read up to where it has been looked at."""

    def __init__(self, folder: Path, sysids: Sequence[int]) -> None:
        self._sysids = list(sysids)
        self._tails = [_Tail(folder / FOLDER / f"{sysid}.truth") for sysid in sysids]

    def at(self, time_s: float) -> Truth:
        """The last records up to a session time, which never falls from call to call."""
        rows = np.array([tail.at(time_s) for tail in self._tails], np.float64).reshape(-1, len(_NAMES))
        return Truth(
            np.array(self._sysids, np.int64),
            rows[:, 0],
            *(rows[:, begin : begin + 3] for begin in range(1, 13, 3)),
            *rows[:, 13:].T,
        )

    def close(self) -> None:
        """Let go of the files."""
        for tail in self._tails:
            tail.close()


class _Tail:
    """One vehicle's file."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file: BinaryIO | None = None
        self._columns: list[int] = []
        self._width = 0
        self._unread = b""
        self._row = [math.nan] * len(_NAMES)

    def at(self, time_s: float) -> list[float]:
        """Numbers of the last record up to a time, as `_NAMES` says."""
        if self._file is None and not self._open():
            return self._row
        assert self._file is not None
        content, at, last = self._unread + self._file.read(), 0, -1
        while at + self._width <= len(content):
            record_s, more = _BEGIN.unpack_from(content, at)
            end = at + self._width + _NUMBER_BYTES * int(more)
            if record_s > time_s + _ROUNDING_S or end > len(content):
                break
            last, at = at, end
        if last >= 0:
            numbers = struct.unpack_from(f"<{self._width // _NUMBER_BYTES}d", content, last)
            self._row = [numbers[column] for column in self._columns]
        self._unread = content[at:]
        return self._row

    def _open(self) -> bool:
        """Whether the file is there, with its head."""
        try:
            self._file = self._path.open("rb", buffering=0)
        except OSError:
            return False
        head, line, rest = self._file.readall().partition(b"\n")
        if not line:
            self.close()
            return False
        about = json.loads(head)
        names = ["time_s", "steps", *about["state"], *about["energy"]]
        self._columns, self._width = [names.index(name) for name in _NAMES], _NUMBER_BYTES * len(names)
        self._unread = rest
        return True

    def close(self) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None
