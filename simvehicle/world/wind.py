"""Wind at a vehicle: a mean, turbulence after Dryden, and discrete gusts (docs/model/world.md#wind), nwu, m/s.

Turbulence is what filters make of white noise, each stepped exactly for the speed and height of the moment. Its memory
are five numbers of unit scale: one of the filter along the mean wind, two of each across and up.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.simvehicle.world.rows import GUST_SIZE
from cython.cimports.simvehicle.world.wind import gusts_at
from numpy.typing import NDArray

Row = NDArray[np.float64]

_FOOT_M = 0.3048
_LOWEST_FT, _HIGHEST_FT = 10.0, 1000.0
_LEAST_AIR_SPEED_M_S = 1.0
_ROOT3 = math.sqrt(3.0)
_SMALL = 1e-3


def dryden_scales(height_m: float, w20_m_s: float) -> tuple[float, float, float, float]:
    """σ_u = σ_v and σ_w in m/s, L_u = L_v and L_w in m (MIL-F-8785C, 3.7.3.4, low altitude), of a wind at 20 ft."""
    h = min(max(height_m / _FOOT_M, _LOWEST_FT), _HIGHEST_FT)
    d = 0.177 + 0.000823 * h
    sigma_w = 0.1 * w20_m_s
    return sigma_w / elementary.pow(d, 0.4), sigma_w, h / elementary.pow(d, 1.2) * _FOOT_M, h * _FOOT_M


def _first_order(z: float, a: float, noise: float) -> float:
    """x of unit variance, of which a step leaves the share a."""
    return a * z + math.sqrt(max(1.0 - a * a, 0.0)) * noise


def _second_order(g: Any, i: int, h: float, a: float, n1: float, n2: float) -> float:
    """(1 + √3 T s)/(1 + T s)² of white noise, of unit variance: √3 y1 + (1 - √3) y2 of two lags in a row, exactly.
    A step is the share h of T, and a = e^-h."""
    if h < _SMALL:
        q11, q12, q22 = h, 0.5 * h * h, h * h * h / 3.0
    else:
        b = a * a
        q11 = 0.5 * (1.0 - b)
        q12 = 0.25 * (1.0 - b * (1.0 + 2.0 * h))
        q22 = 0.25 * (1.0 - b * (1.0 + 2.0 * h + 2.0 * h * h))
    c11 = math.sqrt(q11)
    c21 = q12 / c11
    y1 = a * g[i] + c11 * n1
    g[i + 1] = a * g[i + 1] + a * h * g[i] + c21 * n1 + math.sqrt(max(q22 - c21 * c21, 0.0)) * n2
    g[i] = y1
    return _ROOT3 * y1 + (1.0 - _ROOT3) * g[i + 1]


def blow(
    gust: Any, noise: Any, height_m: float, air_speed_m_s: float, w20_m_s: float, dt: float
) -> tuple[float, float, float]:
    """Turbulence along the mean wind, to its left and up, m/s, one step on; gust (GUST_SIZE,) changes in place."""
    sigma, sigma_w, length, length_w = dryden_scales(height_m, w20_m_s)
    speed = max(air_speed_m_s, _LEAST_AIR_SPEED_M_S)
    h, h_w = dt * speed / length, dt * speed / length_w
    a = elementary.exp(-h)
    gust[0] = _first_order(gust[0], a, noise[0])
    v = _second_order(gust, 1, h, a, noise[1], noise[2])
    w = _second_order(gust, 3, h_w, elementary.exp(-h_w), noise[3], noise[4])
    return sigma * gust[0], sigma * v, sigma_w * w


def start_gust(noise: Row) -> Row:
    """Memory (GUST_SIZE,) of turbulence that has blown for long, from as many normal numbers."""
    gust = np.empty(GUST_SIZE)
    gust[0] = noise[0]
    for i in (1, 3):
        gust[i] = math.sqrt(0.5) * noise[i]
        gust[i + 1] = 0.25 / math.sqrt(0.5) * noise[i] + math.sqrt(0.125) * noise[i + 1]
    return gust


def turbulence(
    gust: Row, noise: Row, height_m: float, air_speed_m_s: float, w20_m_s: float, dt: float
) -> tuple[float, float, float]:
    """`blow` of rows: gust (GUST_SIZE,) in place, noise (GUST_NOISE,)."""
    return blow(cython.address(gust[0]), cython.address(noise[0]), height_m, air_speed_m_s, w20_m_s, dt)


def discrete(gusts: Row, t: float) -> tuple[float, float, float]:
    """`discrete_of` a table (k, DISCRETE_SIZE)."""
    return discrete_of(gusts_at(gusts), gusts.shape[0], t)


def discrete_of(gusts: Any, count: int, t: float) -> tuple[float, float, float]:
    """Sum of discrete gusts, m/s: each rises as (1 - cos)/2, holds, and falls as it rose."""
    x = y = z = 0.0
    for i in range(count):
        g = cython.address(gusts[i])
        since, rise = t - g.at, g.rise
        if since <= 0.0 or since >= 2.0 * rise + g.hold:
            continue
        within = min(since, 2.0 * rise + g.hold - since)
        share = 1.0 if within >= rise else 0.5 * (1.0 - elementary.cos(math.M_PI * within / rise))
        x += share * g.x
        y += share * g.y
        z += share * g.z
    return x, y, z
