"""Normal random numbers that are the same to the last bit on every processor (Box and Muller 1958).

NumPy's own generator takes logarithms from the C library, which are not.
"""

from __future__ import annotations

import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from numpy.typing import NDArray


def standard_normal(random: np.random.Generator, rows: int, columns: int) -> NDArray[np.float64]:
    """(rows, columns) of mean 0 and variance 1.

    Each row takes the same count of uniform numbers from the generator, so rows drawn one by one are those drawn at
    once.
    """
    uniform = random.random((rows, (columns + 1) // 2, 2))
    made = np.empty((rows, columns + columns % 2))
    _box_muller(uniform, made)
    return made[:, :columns]


def _box_muller(uniform: NDArray[np.float64], made: NDArray[np.float64]) -> None:
    rows, pairs = uniform.shape[0], uniform.shape[1]
    for i in range(rows):
        for k in range(pairs):
            radius = math.sqrt(-2.0 * elementary.log(1.0 - uniform[i, k, 0]))
            s, c = elementary.sin_cos(2.0 * math.M_PI * uniform[i, k, 1])
            made[i, 2 * k], made[i, 2 * k + 1] = radius * c, radius * s
