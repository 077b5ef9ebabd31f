"""Attraction and repulsion of the potential field (docs/model/planner.md#potential-field; form [choice], values
[seed]).

    U_g = ½ k0 ρ²,                F_g = k0 min(ρ, cap) towards g
    U_o = 0                                                      ρ > ρ_o
        = ½ k1 (1/ρ - 1/ρ_o)²                                    b ρ_o < ρ <= ρ_o
        = ½ k1 (1/ρ - 1/ρ_o)² + ½ a k1 (1/ρ - 1/(b ρ_o))²        ρ <= b ρ_o
    F_o = -∇U_o

F_g is -∇U_g up to ρ = cap and keeps its size beyond: uncapped, a far target presses the vehicle against obstacles.
Forces are those of the field alone and have no unit; distances are metres, NED.
"""

import functools
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from cython.cimports.libc import math
from cython.cimports.skytender.geometry import shape_surface
from numpy.typing import ArrayLike

from gcs.scenario.rules import SURFACE_FLOOR_M
from skytender.geometry import FloatArray

_FLOOR_M = SURFACE_FLOOR_M


@dataclass(frozen=True)
class FieldConstants:
    """Parameters of the field (docs/model/planner.md#potential-field; values [seed], cap_m [choice]). ValueError names
    what is out of range.

    k0, k1 scale attraction and repulsion; a is the gain and b the share of the repulsion range of the inner term;
    attraction_range_m is the range of way points (tracked targets attract at any distance); repulsion_range_m that of
    obstacles; step_m the longest step of the planned point, and its distance of arrival; cap_m where attraction stops
    growing (inf for the pure gradient). full_steps: no step is shorter than the speed allows but the last, onto a goal.
    """

    k0: float = 15.0
    k1: float = 2.0
    a: float = 0.5
    b: float = 0.5
    attraction_range_m: float = 1.0
    repulsion_range_m: float = 1.0
    step_m: float = 0.1
    cap_m: float = 1.0
    full_steps: bool = False

    def __post_init__(self) -> None:
        for name in (f.name for f in fields(self)):
            value = getattr(self, name)
            if name == "full_steps":
                continue
            if name == "a":
                accepted, condition = math.isfinite(value) and value >= 0, "finite and at least 0"
            elif name == "b":
                accepted, condition = 0 < value < 1, "above 0 and below 1"
            elif name == "cap_m":
                accepted, condition = value > 0, "above 0"
            else:
                accepted, condition = math.isfinite(value) and value > 0, "finite and above 0"
            if not accepted:
                raise ValueError(f"potential field: {name} is {value!r}; it must be {condition}")
        if self.repulsion_range_m * self.b <= SURFACE_FLOOR_M:
            raise ValueError(
                f"potential field: b * repulsion_range_m is {self.b * self.repulsion_range_m!r}; "
                f"it must be above {SURFACE_FLOOR_M} m, where the repulsion stops growing"
            )

    def constants(self) -> FloatArray:
        """The parameters as the row (8,) that the struct Field of potential_field.pxd describes; only to be read."""
        return self._constants

    @functools.cached_property
    def _constants(self) -> FloatArray:
        lengths = (self.attraction_range_m, self.step_m, self.cap_m)
        return np.array([self.k0, self.k1, self.a, self.b, *lengths, float(self.full_steps)])


def widened_range(range_m: ArrayLike, speed_m_s: ArrayLike, age_s: ArrayLike) -> FloatArray:
    """Repulsion range in m of a moving repulsor whose report is `age_s` old: range + speed · age
    (docs/model/planner.md#potential-field).

    Arguments broadcast. A report from the future, as clocks may have it, does not narrow the range.
    """
    return np.asarray(np.add(range_m, np.multiply(speed_m_s, np.maximum(age_s, 0.0))), dtype=np.float64)


def repulsion_size(rho: float, rho_o: float, field: Any) -> float:
    """|F_o| at distance `rho` of a repulsor of range `rho_o`."""
    if rho >= rho_o:
        return 0.0
    near = max(rho, _FLOOR_M)
    size = (1.0 / near - 1.0 / rho_o) / (near * near)
    if near < field.b * rho_o:
        size += field.a * (1.0 / near - 1.0 / (field.b * rho_o)) / (near * near)
    force: float = field.k1 * size
    return max(force, 0.0)


def repulsion_of_shape(
    shape: Any, rho_o: float, qn: float, qe: float, qd: float, field: Any
) -> tuple[float, float, float]:
    """F_o (north, east, down) of a shape of range `rho_o`."""
    rho, n, e, d = shape_surface(shape, qn, qe, qd)
    size = repulsion_size(rho, rho_o, field)
    return size * n, size * e, size * d


def attraction_to(
    gn: float, ge: float, gd: float, reach: float, qn: float, qe: float, qd: float, field: Any
) -> tuple[float, float, float]:
    """F_g (north, east, down) towards (gn, ge, gd); zero when it is farther than `reach`."""
    dn = gn - qn
    de = ge - qe
    dd = gd - qd
    rho = math.sqrt(dn * dn + de * de + dd * dd)
    if rho > reach:
        return 0.0, 0.0, 0.0
    k = field.k0
    if rho > field.cap:
        k *= field.cap / rho
    return k * dn, k * de, k * dd
