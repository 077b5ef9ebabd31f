"""The winner-take-all law over a time with its inputs constant, exactly, in logarithms
(docs/model/competition.md#exact-solution; paper eqs. 1, 2) [lineage].

With w = v^p, a = p c, and k the largest of w_i e^(a τ_i t):

    ln w_i = z_i - ln(e^(-x_k)/w_k + Σ_j e^(z_j) (1 - e^(-x_j))/τ_j),  x_j = a τ_j t,  z_i = ln(w_i/w_k) + x_i - x_k
"""

from __future__ import annotations

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def advanced(ln_v: FloatArray, tau: FloatArray, at: float, p: float) -> FloatArray:
    """ln v (n,) after a time t, of n > 0 competitors; `at`: a t. An infinite ln v, of v = 0, stays; one is finite."""
    made = np.empty((2, len(ln_v)))
    _advance(ln_v, tau, at, p, made[0], made[1])
    return made[0]


def all_at_least(x: FloatArray, least: float) -> bool:
    """Whether all numbers of x (n,) are finite, and none is below `least`."""
    fit = True
    for i in range(x.shape[0]):
        fit = fit and least <= x[i] < math.INFINITY
    return fit


def _advance(ln_v: FloatArray, tau: FloatArray, at: float, p: float, z: FloatArray, shares: FloatArray) -> None:
    n = ln_v.shape[0]
    k = 0
    for i in range(1, n):
        if p * ln_v[i] + at * tau[i] > p * ln_v[k] + at * tau[k]:
            k = i
    ln_w_k, tau_k = p * ln_v[k], tau[k]
    start = -(ln_w_k + at * tau_k)
    top = start
    for i in range(n):
        z[i] = (p * ln_v[i] - ln_w_k) + at * (tau[i] - tau_k)
        shares[i] = z[i] + elementary.log(-elementary.expm1(-at * tau[i])) - elementary.log(tau[i])
        top = max(top, shares[i])
    total = cython.declare(cython.double, 0.0)
    for i in range(n):
        total += elementary.exp(shares[i] - top)
    ln_sum = top + elementary.log(elementary.exp(start - top) + total)
    for i in range(n):
        z[i] = (z[i] - ln_sum) / p
