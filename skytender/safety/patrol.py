"""Motion of other aircraft in a session: along a path of corners at constant speed."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from skytender import elementary

Vec3 = tuple[float, float, float]


def patrol(
    path_ned: Sequence[Vec3], speed_m_s: float, time_s: float, *, closed: bool = False, start_s: float = 0.0
) -> tuple[Vec3, Vec3]:
    """Position (m) and velocity (m/s) at a time, NED. It waits at its first corner until `start_s`; an open path is
    flown to its end and back, a closed one leads from its last corner to its first."""
    corners = [*path_ned, path_ned[0]] if closed else [*path_ned, *path_ned[-2::-1]]
    legs = [(a, b, elementary.distance(a, b)) for a, b in pairwise(corners)]
    around_m = sum(length for _, _, length in legs)
    if time_s <= start_s or around_m == 0.0:
        return path_ned[0], (0.0, 0.0, 0.0)
    way_m = (speed_m_s * (time_s - start_s)) % around_m
    legs = [leg for leg in legs if leg[2] > 0.0]
    for a, b, length in legs:  # noqa: B007 - rounding may leave a rest of way after the last leg: that leg's end
        if way_m <= length:
            break
        way_m -= length
    share = min(way_m / length, 1.0)
    north, east, down = (x + share * (y - x) for x, y in zip(a, b, strict=True))
    vn, ve, vd = (speed_m_s * (y - x) / length for x, y in zip(a, b, strict=True))
    return (north, east, down), (vn, ve, vd)
