"""Errors of the sensor readings for an autopilot that estimates its motion by itself (docs/model/world.md#sensors)
[choice]: first-order Gauss-Markov, as an estimate's errors."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from simvehicle.world.estimate import EstimateErrors
from skytender import elementwise
from skytender.normal import standard_normal

Floats = list[float]


class SensorErrors:
    """Errors of GNSS and barometer (position), GNSS (velocity), compass (angles), gyros and accelerometers of one
    vehicle, three axes each: NED for the first two, the body's (front, right, down) for the others."""

    def __init__(self, errors: EstimateErrors, dt_s: float, *, seed: int, sysid: int) -> None:
        """`dt_s`: a step. `seed` and `sysid`: of the stream that they are drawn from."""
        deviations = np.repeat([*errors.deviations, errors.accel_m_s2], 3)
        decays = elementwise.exponentials(-dt_s / np.repeat([*errors.times_s, errors.accel_s], 3))
        self._random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(sysid, 2)))
        self._decays, self._pushes = decays, deviations * np.sqrt(1.0 - decays * decays)
        self._now: NDArray[np.float64] = deviations * standard_normal(self._random, 1, deviations.size)[0]

    def step(self) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """One step of them: position m, velocity m/s, angles rad, rates rad/s, specific force m/s², each (3,)."""
        self._now = self._decays * self._now + self._pushes * standard_normal(self._random, 1, self._now.size)[0]
        e = self._now.tolist()
        return e[0:3], e[3:6], e[6:9], e[9:12], e[12:15]


class Noise(NamedTuple):
    """White noise of one reading of each sensor: accelerometers m/s², gyros rad/s, magnetometers T, three axes of the
    body each, and barometer Pa."""

    accel: Floats
    rates: Floats
    field: Floats
    pressure_pa: float


ACCEL_NOISE_M_S2, RATE_NOISE_RAD_S, FIELD_NOISE_T, PRESSURE_NOISE_PA = 0.02, 0.002, 5e-8, 0.5
_BLOCK = 250


class SensorNoise:
    """Noise of the readings of one vehicle's sensors [choice], far below any error that matters: an autopilot that
    reads the same number again and again takes a sensor for dead."""

    def __init__(self, *, seed: int, sysid: int) -> None:
        """`seed` and `sysid`: of the stream that it is drawn from."""
        self._random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(sysid, 3)))
        deviations = (ACCEL_NOISE_M_S2, RATE_NOISE_RAD_S, FIELD_NOISE_T)
        self._deviations = np.array([*np.repeat(deviations, 3), PRESSURE_NOISE_PA])
        self._drawn: list[Floats] = []

    def step(self) -> Noise:
        """Noise of one reading."""
        if not self._drawn:
            normal = standard_normal(self._random, _BLOCK, self._deviations.size)
            self._drawn = (normal * self._deviations).tolist()
        e = self._drawn.pop()
        return Noise(e[0:3], e[3:6], e[6:9], e[9])
