"""Steps of a competition with noise, delay or changing τ (docs/model/competition.md#noise-and-delay), for
`simulated_competition.simulate`.

    v_i' = c (τ_i(t) - Σ_j |v_j(t)|^p) v_i(t - d_i) + ϑ_i

The classic Runge-Kutta method with ϑ held over a step. A delay is 0 or at least a step, so that what is delayed lies in
steps already made, and is taken there from the cubic through their ends and slopes. A time between two steps is reached
by a shorter step beside the path, so that the path does not depend on what is asked of it.
"""

from __future__ import annotations

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.gcs.refuelling.simulated_steps import DRIFT, NOISE, STATE
from cython.cimports.libc import math
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def _drift(
    v: FloatArray, drive: FloatArray, m: int, part: float, step: int, history: FloatArray, initial: FloatArray,
    delays: FloatArray, p: float, rate: float, slope: FloatArray,
) -> None:  # fmt: skip
    """c (τ_i - Σ_j |v_j|^p) v_i(t - d_i) at `part` of a step, 0..1; `drive[m]` (3, n) is τ at its start, middle,
    end."""
    total = 0.0
    for i in range(v.shape[0]):
        total += elementary.pow(math.fabs(v[i]), p)
    at_start = (1.0 - part) * (1.0 - 2.0 * part)
    at_middle = 4.0 * part * (1.0 - part)
    at_end = part * (2.0 * part - 1.0)
    window = history.shape[1]
    for i in range(v.shape[0]):
        tau = at_start * drive[m, 0, i] + at_middle * drive[m, 1, i] + at_end * drive[m, 2, i]
        past = v[i]
        if delays[i] > 0.0:
            at = step + part - delays[i]
            if at <= 0.0:
                past = initial[i]
            else:
                left = min(cython.cast(cython.Py_ssize_t, math.floor(at)), step - 1)
                a, b = left % window, (left + 1) % window
                s = at - left
                rise = history[STATE, b, i] - history[STATE, a, i]
                bend_a = history[DRIFT, a, i] + history[NOISE, a, i] - rise
                bend_b = history[DRIFT, b, i] + history[NOISE, a, i] - rise
                past = history[STATE, a, i] + s * rise + s * (1.0 - s) * ((1.0 - s) * bend_a - s * bend_b)
        slope[i] = rate * (tau - total) * past


def step_block(
    v: FloatArray,
    history: FloatArray,
    initial: FloatArray,
    drive: FloatArray,
    noise: FloatArray,
    delays: FloatArray,
    wanted: FloatArray,
    out: FloatArray,
    first: int,
    following: int,
    step_s: float,
    p: float,
    rate: float,
) -> int:
    """Make steps `first`, `first` + 1, …, one for each row of `noise` (m, n); time is counted in steps.

    Changes v (n,), history (3, window, n) and out (k, n). drive (m, 3, n) is τ at each step's start, middle and end,
    delays (n,), wanted (k,) the times of out's rows, of which `following` is the next; returns what it is afterwards.
    """
    k1, k2, k3, k4, stage = np.empty((5, len(v)))
    return _step_block(
        v, history, initial, drive, noise, delays, wanted, out, first, following, step_s, p, rate, k1, k2, k3, k4, stage
    )


def _step_block(
    v: FloatArray, history: FloatArray, initial: FloatArray, drive: FloatArray, noise: FloatArray, delays: FloatArray,
    wanted: FloatArray, out: FloatArray, first: int, following: int, step_s: float, p: float, rate: float,
    k1: FloatArray, k2: FloatArray, k3: FloatArray, k4: FloatArray, stage: FloatArray,
) -> int:  # fmt: skip
    """`step_block` with its scratch, (n,) each."""
    n = v.shape[0]
    window = history.shape[1]
    h_rate = rate * step_s
    for m in range(noise.shape[0]):
        step = first + m
        slot = step % window
        _drift(v, drive, m, 0.0, step, history, initial, delays, p, h_rate, k1)
        for i in range(n):
            history[STATE, slot, i] = v[i]
            history[DRIFT, slot, i] = k1[i]
            history[NOISE, slot, i] = step_s * noise[m, i]
        while True:
            beside = following < wanted.shape[0] and wanted[following] < step + 1
            part = max(wanted[following] - step, 0.0) if beside else 1.0
            for i in range(n):
                stage[i] = v[i] + 0.5 * part * (k1[i] + history[NOISE, slot, i])
            _drift(stage, drive, m, 0.5 * part, step, history, initial, delays, p, h_rate, k2)
            for i in range(n):
                stage[i] = v[i] + 0.5 * part * (k2[i] + history[NOISE, slot, i])
            _drift(stage, drive, m, 0.5 * part, step, history, initial, delays, p, h_rate, k3)
            for i in range(n):
                stage[i] = v[i] + part * (k3[i] + history[NOISE, slot, i])
            _drift(stage, drive, m, part, step, history, initial, delays, p, h_rate, k4)
            for i in range(n):
                mean = (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0 + history[NOISE, slot, i]
                stage[i] = v[i] + part * mean
            if not beside:
                break
            for i in range(n):
                out[following, i] = stage[i]
            following += 1
        for i in range(n):
            v[i] = stage[i]
    return following
