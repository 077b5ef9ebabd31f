"""Cost of flying (docs/model/vehicle.md#energy): control effort, as this project defines it, and the battery's
power."""

from __future__ import annotations

from cython.cimports.libc import math


def power(u1: float, gravity: float, hover_w: float, avionics_w: float) -> float:
    """P = P_hover (T/mg)^(3/2) + P_avionics in W (docs/model/vehicle.md#battery) [choice]; T/mg is |u1|/g."""
    load = abs(u1) / gravity
    return hover_w * load * math.sqrt(load) + avionics_w


def effort_rate(u1: float, tau2: float, tau3: float, tau4: float) -> float:
    """Σ |τ_k| with τ_1 = u1 (docs/model/vehicle.md#control-effort) [choice]: m/s² and rad/s² summed."""
    return abs(u1) + abs(tau2) + abs(tau3) + abs(tau4)
