"""Still air by height: the International Standard Atmosphere (ISO 2533) below 11 km, which barometers are read by."""

from __future__ import annotations

from typing import NamedTuple

from skytender import elementary

SEA_LEVEL_PA, SEA_LEVEL_K = 101_325.0, 288.15
LAPSE_K_M = 6.5e-3
_EXPONENT = 9.80665 * 0.0289644 / (8.31432 * LAPSE_K_M)
"""g₀ M/(R L)"""
ZERO_CELSIUS_K = 273.15


class StillAir(NamedTuple):
    """Air at a height: pressure in Pa, temperature in °C."""

    pressure_pa: float
    celsius: float


def air_at(alt_m: float) -> StillAir:
    """Air at a height above mean sea level: T = T₀ - L h, p = p₀ (T/T₀)^(g₀ M/(R L))."""
    kelvin = SEA_LEVEL_K - LAPSE_K_M * alt_m
    return StillAir(SEA_LEVEL_PA * elementary.pow(kelvin / SEA_LEVEL_K, _EXPONENT), kelvin - ZERO_CELSIUS_K)
