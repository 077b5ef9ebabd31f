"""Vehicles' own truth of their places, from a session's `vehicles/SYSID.truth` (docs/protocol.md#truth)."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gcs.kernels import kernel

FOLDER = "vehicles"


def read(folder: Path, sysid: int) -> NDArray[np.float64] | None:
    """(k, COLUMNS) of a vehicle's records, one per grant; None where it left none that can be read."""
    path = folder / FOLDER / f"{sysid}.truth"
    try:
        with path.open("rb") as file:
            head = json.loads(file.readline())
            names = ["time_s", "steps", *head["state"], *head["energy"]]
            columns = np.array([names.index(name) for name in ("time_s", "n", "e", "d", "vn", "ve", "vd")])
            return _records(np.fromfile(file, dtype=np.float64), len(names), columns)
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None


def load() -> None:
    """Load what the first reading of a process is done with."""
    _records(np.empty(0), 1, np.empty(0, dtype=np.int64))


@kernel()
def record_end(numbers: NDArray[np.float64], at: int, width: int) -> int:
    """Kernel: where the record at a place ends, which says itself how long it is; -1 where it is no whole record."""
    if at + width > numbers.size:
        return -1
    steps = numbers[at + 1]
    if not 0.0 <= steps <= numbers.size:  # also what is no number
        return -1
    end = at + width + int(steps)
    return end if end <= numbers.size else -1


@kernel()
def _records(numbers: NDArray[np.float64], width: int, columns: NDArray[np.int64]) -> NDArray[np.float64]:
    """Kernel: the wanted columns of each whole record; one is `width` numbers and as many more as it has steps."""
    count = at = 0
    end = record_end(numbers, at, width)
    while end >= 0:
        at = end
        count += 1
        end = record_end(numbers, at, width)
    rows = np.empty((count, columns.size))
    at = 0
    for k in range(count):
        for c in range(columns.size):
            rows[k, c] = numbers[at + columns[c]]
        at = record_end(numbers, at, width)
    return rows
