"""Errors of what a vehicle knows of its motion (docs/model/world.md#estimate-errors) [choice]: first-order
Gauss-Markov."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True)
class EstimateErrors:
    """Standard deviation of each axis, and the time over which it is correlated. Accelerometers matter to an autopilot
    which estimates by itself (sensors.py).

    Raises:
        ValueError: a standard deviation that is negative, a time that is not positive.
    """

    position_m: float = 0.3
    position_s: float = 60.0
    velocity_m_s: float = 0.05
    velocity_s: float = 2.0
    attitude_deg: float = 0.3
    attitude_s: float = 10.0
    rate_deg_s: float = 0.3
    rate_s: float = 0.02
    accel_m_s2: float = 0.1
    accel_s: float = 0.02

    def __post_init__(self) -> None:
        for name in ("position_m", "velocity_m_s", "attitude_deg", "rate_deg_s", "accel_m_s2"):
            value = getattr(self, name)
            if not 0.0 <= value < math.inf:
                raise ValueError(f"sensors.{name} is {value!r}, but it must be 0 or greater, and finite")
        for name in ("position_s", "velocity_s", "attitude_s", "rate_s", "accel_s"):
            if not 0.0 < getattr(self, name) < math.inf:
                raise ValueError(
                    f"sensors.{name} is {getattr(self, name)!r}, but it must be greater than 0, and finite"
                )

    @property
    def deviations(self) -> NDArray[np.float64]:
        """(4,), of position, velocity, angles and rates: m, m/s, rad, rad/s."""
        turning = np.radians([self.attitude_deg, self.rate_deg_s])
        return np.array([self.position_m, self.velocity_m_s, *turning])

    @property
    def times_s(self) -> NDArray[np.float64]:
        """(4,), correlation times of the same."""
        return np.array([self.position_s, self.velocity_s, self.attitude_s, self.rate_s])
