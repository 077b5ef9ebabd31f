"""Elementary functions of each number of an array (`skytender.elementary`)."""

from __future__ import annotations

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.skytender.elementary import TOGETHER
from cython.cimports.skytender.elementwise import _COS, _EXP, _LOG, _SIN
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
    made = np.array(x, dtype=np.float64, order="C")
    _raise(made.reshape(-1), y)
    return made


def _raise(row: NDArray[np.float64], y: float) -> None:
    """Raise the numbers of a row (n,) to the power of y, in place."""
    bases = cython.declare(cython.double[TOGETHER])
    exponents = cython.declare(cython.double[TOGETHER])
    made = cython.declare(cython.double[TOGETHER])
    n = row.shape[0]
    for i in range(TOGETHER):
        bases[i], exponents[i] = 1.0, y
    k = 0
    while k < n:
        count = min(n - k, TOGETHER)
        for i in range(count):
            bases[i] = row[k + i]
        elementary.pow_of_each(bases, exponents, made)
        for i in range(count):
            row[k + i] = made[i]
        k += count


def _of_each(function: int, x: ArrayLike) -> NDArray[np.float64]:
    made = np.array(x, dtype=np.float64, order="C")
    row = made.reshape(-1)
    for k in range(row.shape[0]):
        if function == _SIN:
            row[k] = elementary.sin(row[k])
        elif function == _COS:
            row[k] = elementary.cos(row[k])
        elif function == _EXP:
            row[k] = elementary.exp(row[k])
        else:
            row[k] = elementary.log(row[k])
    return made
