"""One step of a vehicle's estimate errors (docs/model/world.md#estimate-errors) [choice]."""

from __future__ import annotations

from typing import Any

import cython
import numpy as np
from cython.cimports.libc import math
from numpy.typing import NDArray

Row = NDArray[np.float64]


def step_errors(error: Any, noise: Any, deviations: Any, decays: Any) -> None:
    """One step of errors (ERROR_SIZE,) in place: e⁺ = a e + σ √(1 - a²) n, with a = exp(-dt/τ), decays (4,).

    deviations: (4,), σ of position, velocity, angles and rates, as the decays; noise: (ERROR_SIZE,), normal numbers.
    """
    for k in range(4):
        a = decays[k]
        push = deviations[k] * math.sqrt(max(1.0 - a * a, 0.0))
        for i in range(3 * k, 3 * k + 3):
            error[i] = a * error[i] + push * noise[i]


def error_step(error: Row, noise: Row, deviations: Row, decays: Row) -> None:
    """`step_errors` of rows."""
    e, n, d = cython.address(error[0]), cython.address(noise[0]), cython.address(deviations[0])
    step_errors(e, n, d, cython.address(decays[0]))
