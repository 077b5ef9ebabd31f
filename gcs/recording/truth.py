"""Vehicles' own truth of their places, from a session's `vehicles/SYSID.truth` (docs/protocol/folder.md#truth)."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import cython
import numpy as np
from numpy.typing import NDArray

FOLDER = "vehicles"
PLACE = ("time_s", "n", "e", "d")
MOTION = (*PLACE, "vn", "ve", "vd")
"""time, s; place, m, and velocity, m/s, in the common NED frame"""


def read(folder: Path, sysid: int, names: Sequence[str] = MOTION) -> NDArray[np.float64] | None:
    """(k, len(names)) of a vehicle's records, one per grant; None where it left none that can be read."""
    path = folder / FOLDER / f"{sysid}.truth"
    try:
        with path.open("rb") as file:
            head = json.loads(file.readline())
            known = ["time_s", "steps", *head["state"], *head["energy"]]
            columns = np.array([known.index(name) for name in names])
            numbers = np.fromfile(file, dtype="<f8")
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None
    return numbers[record_places(numbers, len(known))[:-1, np.newaxis] + columns]


def record_places(numbers: NDArray[np.float64], width: int) -> NDArray[np.int64]:
    """Where each whole record begins, and where the last one ends; one is `width` numbers, the second of which says how
    many more it has."""
    places = np.empty(len(numbers) // width + 1, dtype=np.int64)
    return places[: _find(numbers, width, places) + 1]


def _find(numbers: NDArray[np.float64], width: int, places: NDArray[np.int64]) -> int:
    """Write where each record begins, and where the last one ends; how many there are."""
    n = at = 0
    while at + width <= len(numbers):
        steps = numbers[at + 1]
        if not 0.0 <= steps <= len(numbers) - at - width:  # also what is no number
            break
        places[n] = at
        n += 1
        at += width + cython.cast("Py_ssize_t", steps)
    places[n] = at
    return n
