"""Places of a struct's fields in the row of float64 that it is read from."""

from __future__ import annotations

from typing import Any

import numpy as np

COUNTED = np.arange(256.0)
"""A row whose numbers are their own places: a struct read from it tells where its fields are."""


def places(fields: dict[str, Any]) -> dict[str, Any]:
    """Place of each field of a struct that was read from `COUNTED`: an integer for a number, else a slice."""
    return {name: int(field) if isinstance(field, float) else _span(field) for name, field in fields.items()}


def size(fields: dict[str, Any]) -> int:
    """Numbers of a struct."""
    return _span(fields).stop


def _span(field: Any) -> slice:
    numbers = _numbers(field)
    return slice(int(min(numbers)), int(max(numbers)) + 1)


def _numbers(field: Any) -> list[float]:
    if isinstance(field, float):
        return [field]
    parts = field.values() if isinstance(field, dict) else field
    return [number for part in parts for number in _numbers(part)]
