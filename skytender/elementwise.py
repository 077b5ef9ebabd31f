"""Elementary functions of each number of an array (`skytender.elementary`)."""

from __future__ import annotations

import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.skytender.elementwise import _COS, _EXP, _LOG, _POW, _SIN
from numpy.typing import ArrayLike, NDArray


def sines(x: ArrayLike) -> NDArray[np.float64]:
    """Sine of each number of an array."""
    return _of_each(_SIN, x)


def cosines(x: ArrayLike) -> NDArray[np.float64]:
    """Cosine of each number of an array."""
    return _of_each(_COS, x)


def exponentials(x: ArrayLike) -> NDArray[np.float64]:
    """e^x of each number of an array."""
    return _of_each(_EXP, x)


def logarithms(x: ArrayLike) -> NDArray[np.float64]:
    """Natural logarithm of each number of an array."""
    return _of_each(_LOG, x)


def powers(x: ArrayLike, y: float) -> NDArray[np.float64]:
    """x^y of each number of an array, none below 0."""
    return _of_each(_POW, x, y)


def _of_each(function: int, x: ArrayLike, y: float = 0.0) -> NDArray[np.float64]:
    made = np.array(x, dtype=np.float64, order="C")
    row = made.reshape(-1)
    for k in range(row.shape[0]):
        if function == _SIN:
            row[k] = elementary.sin(row[k])
        elif function == _COS:
            row[k] = elementary.cos(row[k])
        elif function == _EXP:
            row[k] = elementary.exp(row[k])
        elif function == _LOG:
            row[k] = elementary.log(row[k])
        else:
            row[k] = elementary.pow(row[k], y)
    return made
