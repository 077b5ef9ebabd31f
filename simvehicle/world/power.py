"""Power of rotors in the air, and a battery with an inner resistance (docs/model/vehicle.md#rotor-power) [choice]."""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.simvehicle.world.power import CELLS
from cython.cimports.simvehicle.world.rotors import airframe_at
from numpy.typing import NDArray

from simvehicle.world import airframes

Row = NDArray[np.float64]

CELL_MEAN_V = 3.804
"""Mean of `cell_v` over the charge."""
CELL_OHM_AH = 0.01
"""Inner resistance of a cell times its capacity [choice]."""
_INDUCED_FACTOR = airframes.INDUCED_FACTOR
_FLATTEST = 4.65
_MOST_EVALUATIONS = 20


def induced_speed(thrust_n: float, across_m_s: float, along_m_s: float, area_m2: float, density_kg_m3: float) -> float:
    """Induced speed of a disc, m/s: v √(V_t² + (V_n + v)²) = T/(2 ρ A) (Glauert), V_n not below 0."""
    if thrust_n <= 0.0:
        return 0.0
    square = thrust_n / (2.0 * density_kg_m3 * area_m2)
    along = max(along_m_s, 0.0)
    v = math.sqrt(square)
    for _ in range(_MOST_EVALUATIONS):
        speed = math.sqrt(across_m_s * across_m_s + (along + v) * (along + v))
        change = (v * speed - square) / (speed + v * (along + v) / speed)
        v -= change
        if math.fabs(change) <= 1e-9 * v:
            break
    return v


def rotor_power(thrust_n: float, speeds: Any, across_m_s: float, along_m_s: float, a: Any) -> float:
    """Power of all rotors at the shaft, W, not below 0: κ T v_i + T V_n + c Σω³ (1 + 4.65 μ²)."""
    v = induced_speed(thrust_n, across_m_s, along_m_s, a.area, a.density)
    cubes = total = 0.0
    for i in range(4):
        cubes += speeds[i] * speeds[i] * speeds[i]
        total += speeds[i]
    tip = 0.25 * total * a.radius
    advance = across_m_s / tip if tip > 1.0 else 0.0
    profile = a.profile * cubes * (1.0 + _FLATTEST * min(advance * advance, 1.0))
    power_w: float = thrust_n * (_INDUCED_FACTOR * v + along_m_s) + profile
    return max(power_w, 0.0)


def shaft_power(thrust_n: float, speeds: Row, across_m_s: float, along_m_s: float, airframe: Row) -> float:
    """`rotor_power` of rows: speeds (4,), airframe (AIRFRAME_SIZE,)."""
    return rotor_power(thrust_n, cython.address(speeds[0]), across_m_s, along_m_s, airframe_at(airframe))


def cell_v(charge: float) -> float:
    """Open-circuit voltage of a lithium-polymer cell by its charge, 0 to 1 (M. Chen, G. A. Rincón-Mora, *Accurate
    electrical battery model capable of predicting runtime and I-V performance*, IEEE TEC 2006)."""
    s = min(max(charge, 0.0), 1.0)
    return -1.031 * elementary.exp(-35.0 * s) + 3.685 + 0.2156 * s - 0.1178 * s * s + 0.3201 * s * s * s


def discharge(power_w: float, charge: float, resistance_ohm: float) -> tuple[float, float, float]:
    """(terminal voltage V, current A, power taken from the cells W) of a battery that is asked for a power, W.

    I is the smaller root of R I² - U_0 I + P = 0; where there is none half of what it gives is lost within it.
    """
    open_v = CELLS * cell_v(charge)
    left = open_v * open_v - 4.0 * resistance_ohm * power_w
    if left <= 0.0:
        return 0.5 * open_v, 2.0 * power_w / open_v, 2.0 * power_w
    current = 2.0 * power_w / (open_v + math.sqrt(left))
    return open_v - resistance_ohm * current, current, open_v * current


def usual_resistance_ohm(capacity_j: float) -> float:
    """Inner resistance of a battery that holds so many joules, by `CELL_OHM_AH`."""
    return CELLS * CELL_OHM_AH * CELLS * CELL_MEAN_V * 3600.0 / capacity_j
