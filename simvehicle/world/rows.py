"""Places of the fields in the world's rows, as rows.pxd declares them: a slice for vectors, an integer for scalars."""

from __future__ import annotations

from typing import Any

import cython

from skytender.layout import COUNTED, places, size

GUST_SIZE: int
GUST_NOISE: int
"""Normal numbers that a step of turbulence takes."""
ERROR_SIZE: int
"""Of position, velocity, Euler angles and their rates, three each, nwu."""


def _body_of(row: Any) -> Any:
    return cython.cast("Body *", cython.address(row[0]))[0]


def _airframe_of(row: Any) -> Any:
    return cython.cast("AirframeRow *", cython.address(row[0]))[0]


def _gust_of(row: Any) -> Any:
    return cython.cast("Gust *", cython.address(row[0]))[0]


def _weather_of(row: Any) -> Any:
    return cython.cast("Weather *", cython.address(row[0]))[0]


BODY, AIRFRAME, GUST, WEATHER = (
    places(fields) for fields in (_body_of(COUNTED), _airframe_of(COUNTED), _gust_of(COUNTED), _weather_of(COUNTED))
)
BODY_SIZE, AIRFRAME_SIZE, DISCRETE_SIZE, WEATHER_SIZE = (
    size(fields) for fields in (_body_of(COUNTED), _airframe_of(COUNTED), _gust_of(COUNTED), _weather_of(COUNTED))
)
