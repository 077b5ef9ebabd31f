"""Wind from a table: its mean at places of a grid, and between them in proportion (docs/model/world.md#wind)
[choice]."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from math import isfinite, prod

Triple = tuple[float, float, float]
MOST_PLACES = 2000


@dataclass(frozen=True)
class WindField:
    """Places north, east and above the scenario's height 0, m, each strictly ascending; the wind's velocity to north,
    east and up at each, m/s, height changing first and north last.

    Raises:
        ValueError: an axis without places or not ascending, numbers that are not finite, not one wind for each place.
    """

    north_m: tuple[float, ...]
    east_m: tuple[float, ...]
    height_m: tuple[float, ...]
    wind_m_s: tuple[Triple, ...]

    def __post_init__(self) -> None:
        for name in ("north_m", "east_m", "height_m"):
            axis = getattr(self, name)
            if not axis or not all(map(isfinite, axis)) or any(b <= a for a, b in pairwise(axis)):
                raise ValueError(f"field: {name} must ascend, and have a place at least")
        places = prod(map(len, self._axes))
        if len(self.wind_m_s) != places or places > MOST_PLACES:
            raise ValueError(
                f"field: wind_m_s has {len(self.wind_m_s)} rows for {places} places, at most {MOST_PLACES}"
            )
        if not all(len(row) == 3 and all(map(isfinite, row)) for row in self.wind_m_s):
            raise ValueError("field: each row of wind_m_s must be three numbers: north, east, up")

    @property
    def _axes(self) -> tuple[Sequence[float], ...]:
        return self.north_m, self.east_m, self.height_m

    def at_nwu(self, p_nwu: Sequence[float]) -> Triple:
        """Velocity of the air (nwu, m/s) at a place (nwu, m); beyond the table as at its edge."""
        place = (p_nwu[0], -p_nwu[1], p_nwu[2])
        sides = [_between(axis, x) for axis, x in zip(self._axes, place, strict=True)]
        found = [0.0, 0.0, 0.0]
        for (i, a), (j, b), (k, c) in product(*sides):
            row = self.wind_m_s[(i * len(self.east_m) + j) * len(self.height_m) + k]
            for axis in range(3):
                found[axis] += a * b * c * row[axis]
        return found[0], -found[1], found[2]


def _between(axis: Sequence[float], x: float) -> list[tuple[int, float]]:
    """The places next to x and the share of each."""
    above = bisect_right(axis, x)
    if above == 0:
        return [(0, 1.0)]
    if above == len(axis):
        return [(above - 1, 1.0)]
    share = (x - axis[above - 1]) / (axis[above] - axis[above - 1])
    return [(above - 1, 1.0 - share), (above, share)]
