"""The paper's competition with noise, and with every state heard late: explicit Euler steps (docs/paper.md)."""

from __future__ import annotations

import numpy as np
from cython.cimports.libc.math import pow
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def noisy(
    v: Floats,
    tau: Floats,
    noise: Floats,
    p: float,
    rate: float,
    step_s: float,
    counted_from: int,
    total: Floats,
    squares: Floats,
) -> None:
    """Change v (n,) by steps with noise (steps, n); v and v² of those from `counted_from` on are summed, (n,) each."""
    for k in range(noise.shape[0]):
        norm = 0.0
        for i in range(v.shape[0]):
            norm += v[i] * v[i] if p == 2.0 else pow(v[i], p)
        for i in range(v.shape[0]):
            v[i] = max(v[i] + step_s * (rate * (tau[i] - norm) * v[i] + noise[k, i]), 0.0)
            if k >= counted_from:
                total[i] += v[i]
                squares[i] += v[i] * v[i]


def delayed(
    v0: Floats, tau: Floats, delays: NDArray[np.int64], p: float, rate: float, step_s: float, steps: int
) -> Floats:
    """States (n,) after so many steps; delays (n,) in steps."""
    window = int(delays.max()) + 1
    v = v0.copy()
    _step_delayed(v, tau, delays, np.zeros((window, len(v0))), np.zeros(window), p, rate, step_s, steps)
    return v


def _step_delayed(
    v: Floats, tau: Floats, delays: NDArray[np.int64], past: Floats, norms: Floats, p: float, rate: float,
    step_s: float, steps: int,
) -> None:  # fmt: skip
    window = norms.shape[0]
    for k in range(steps):
        slot = k % window
        norm = 0.0
        for i in range(v.shape[0]):
            past[slot, i] = v[i]
            norm += pow(v[i], p)
        norms[slot] = norm
        for i in range(v.shape[0]):
            at = max(k - delays[i], 0) % window
            v[i] = max(v[i] + step_s * rate * (tau[i] - norms[at]) * past[at, i], 0.0)
