"""Shapes that repel, as one flat table, and the distance to their surfaces.

A table is float64 of shape (m, COLUMNS), one row per shape, all lengths in metres in the common NED frame:

| kind     | NORTH, EAST, DOWN | SIZE_1     | SIZE_2      | SIZE_3    |
|----------|-------------------|------------|-------------|-----------|
| POINT    | the point         | 0          | 0           | 0         |
| SPHERE   | centre            | radius     | 0           | 0         |
| BOX      | centre            | half north | half east   | half down |
| CYLINDER | centre            | radius     | half height | 0         |
| WALL     | middle            | half north | half east   | half down |

Boxes are axis-aligned, cylinders stand upright and end in flat lids. Distances are signed: positive outside, zero on
the surface, negative within a volume. A point's surface is its centre, so its distance is never negative. A wall is a
stretch of a fence's border, from its middle by plus and minus (half north, half east), whose halves have signs. It is
as high and as deep as the world; DOWN and half down only tell between which heights routes along it are looked for.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol

import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.skytender.geometry import BOX, CYLINDER, POINT, SPHERE, WALL, row_of, shape_at
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]

KIND, NORTH, EAST, DOWN, SIZE_1, SIZE_2, SIZE_3 = range(7)
"""Columns of the table, in the order of the struct Shape in geometry.pxd."""
COLUMNS = 7

FAR_M = 1e6  # where a wall ends, up and down: beyond every scenario

# Nearer than this to a centre or an edge the difference of two positions has no direction left that means anything.
_NO_DIRECTION_M = 1e-9


def point(p_ned: ArrayLike) -> FloatArray:
    """Row (COLUMNS,) of a point at `p_ned` (3,) m. ValueError unless it is three finite numbers."""
    return _row(POINT, _vector("p_ned", p_ned))


def sphere(centre_ned: ArrayLike, radius_m: float) -> FloatArray:
    """Row (COLUMNS,) of a sphere. ValueError unless the centre is finite and radius_m > 0."""
    return _row(SPHERE, _vector("centre_ned", centre_ned), _size("radius_m", radius_m))


def box(low_ned: ArrayLike, high_ned: ArrayLike) -> FloatArray:
    """Row (COLUMNS,) of an axis-aligned box between two opposite corners (3,), m NED, low_ned < high_ned in each axis.

    Down grows downwards: the roof belongs to low_ned. ValueError unless finite and every edge is longer than zero.
    """
    low, high = _vector("low_ned", low_ned), _vector("high_ned", high_ned)
    for axis, edge in zip(("north", "east", "down"), high - low, strict=True):
        _size(f"box: high_ned - low_ned, {axis}", edge)
    return _row(BOX, (low + high) / 2, *((high - low) / 2))


def cylinder(centre_ned: ArrayLike, radius_m: float, height_m: float) -> FloatArray:
    """Row (COLUMNS,) of an upright cylinder about `centre_ned`, the middle of its axis.

    ValueError unless the centre is finite, radius_m > 0 and height_m > 0.
    """
    centre = _vector("centre_ned", centre_ned)
    return _row(CYLINDER, centre, _size("radius_m", radius_m), _size("height_m", height_m) / 2)


def wall(
    from_ne: tuple[float, float], to_ne: tuple[float, float], high_d: float = 0.0, low_d: float = 0.0
) -> FloatArray:
    """Row (COLUMNS,) of a wall between two places (north, east), with routes between two downs, high_d <= low_d.

    ValueError unless finite, and longer than zero.
    """
    a = _vector("from_ne, high_d", (*from_ne, high_d))
    b = _vector("to_ne, low_d", (*to_ne, low_d))
    _size("wall: from from_ne to to_ne", elementary.hypot(b[0] - a[0], b[1] - a[1]))
    return _row(WALL, (a + b) / 2, *((b - a) / 2))


def table(rows: list[FloatArray]) -> FloatArray:
    """Rows of the shapes above, stacked to (m, COLUMNS); no rows give (0, COLUMNS)."""
    return np.array(rows, dtype=np.float64).reshape(len(rows), COLUMNS)


class ObstacleShape(Protocol):
    """Shape by two corners: of a box, else the ends of an axis or the centre, with `radius_m` around it; NED."""

    @property
    def kind(self) -> str: ...
    @property
    def low_m(self) -> tuple[float, float, float]: ...
    @property
    def high_m(self) -> tuple[float, float, float]: ...
    @property
    def radius_m(self) -> float: ...


def of_scenario(shapes: Iterable[ObstacleShape]) -> FloatArray:
    """Table of a scenario's obstacles."""
    return table([solid(shape.kind, shape.low_m, shape.high_m, shape.radius_m) for shape in shapes])


def solid(kind: str, low_ned: ArrayLike, high_ned: ArrayLike, radius_m: float) -> FloatArray:
    """Row (COLUMNS,) of a shape as scenarios describe it: `point`, `sphere`, `box` or `cylinder` between two corners.
    ValueError as of that shape's function."""
    low, high = np.array(low_ned, dtype=np.float64), np.array(high_ned, dtype=np.float64)
    if kind == "box":
        return box(low, high)
    centre = (low + high) / 2.0
    if kind == "point":
        return point(centre)
    if kind == "sphere":
        return sphere(centre, radius_m)
    if kind == "cylinder":
        return cylinder(centre, radius_m, float(high[2] - low[2]))
    raise ValueError(f"kind is {kind!r}; it must be point, sphere, box or cylinder")


def points(positions_ned: ArrayLike, radii_m: ArrayLike = 0.0) -> FloatArray:
    """Table of points at `positions_ned` (m, 3) m, spheres where `radii_m` (m,) > 0. ValueError unless finite."""
    positions = np.asarray(positions_ned, dtype=np.float64).reshape((-1, 3))
    if not (np.isfinite(positions.sum()) or np.isfinite(positions).all()):
        raise ValueError("positions_ned holds a value that is not finite; give every obstacle three finite numbers")
    rows = np.zeros((len(positions), COLUMNS))
    rows[:, NORTH : DOWN + 1] = positions
    rows[:, SIZE_1] = radii_m
    rows[:, KIND] = rows[:, SIZE_1] > 0.0  # SPHERE, else POINT
    return rows


def clearance(table: FloatArray, points_ned: ArrayLike) -> FloatArray:
    """Least signed distance (k,) in m from each of `points_ned` (k, 3) to any surface; inf where there is no shape."""
    at = np.ascontiguousarray(points_ned, dtype=np.float64).reshape((-1, 3))
    least_m = np.empty(len(at))
    fill_clearances(table, at, least_m, np.empty(len(table)))
    return least_m


def bounds(table: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Least and greatest corner (m, 3) of each shape's bounding box."""
    low, high = np.empty((len(table), 3)), np.empty((len(table), 3))
    low_rows, high_rows = low, high
    for i in range(len(table)):
        write_bounds(shape_at(table, i), row_of(low_rows, i), row_of(high_rows, i))
    return low, high


def write_bounds(shape: Any, low: Any, high: Any) -> None:
    """Write the least and the greatest corner (3,) of a shape's bounding box."""
    hn, he, hd = shape.size_1, shape.size_1, shape.size_1
    if shape.kind == BOX:
        he, hd = shape.size_2, shape.size_3
    elif shape.kind == CYLINDER:
        hd = shape.size_2
    elif shape.kind == WALL:
        hn, he, hd = math.fabs(shape.size_1), math.fabs(shape.size_2), FAR_M
    low[0], low[1], low[2] = shape.north - hn, shape.east - he, shape.down - hd
    high[0], high[1], high[2] = shape.north + hn, shape.east + he, shape.down + hd


def _vector(name: str, value: ArrayLike) -> FloatArray:
    vector = np.asarray(value, dtype=np.float64)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ValueError(f"{name} is {value!r}; it must be three finite numbers: north, east, down in metres")
    return vector


def _size(name: str, value: float) -> float:
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"{name} is {value!r}; it must be a finite length above 0 m")
    return float(value)


def _row(kind: float, position_ned: FloatArray, *sizes: float) -> FloatArray:
    row = np.zeros(COLUMNS)
    row[KIND] = kind
    row[NORTH : DOWN + 1] = position_ned
    row[SIZE_1 : SIZE_1 + len(sizes)] = sizes
    return row


def shape_surface(shape: Any, qn: float, qe: float, qd: float) -> tuple[float, float, float, float]:
    """Signed distance in m of a shape's surface, and unit vector (north, east, down) from it to (qn, qe, qd).

    Within a volume the distance is minus the depth and the vector points out by the shortest way; of equally short
    ways north comes before east before down, and from the very centre they lead north, east and up. At a point, and
    at the centre of a sphere, where every way is as short, the vector is up.
    """
    kind = shape.kind
    dn = qn - shape.north
    de = qe - shape.east
    dd = qd - shape.down
    if kind == BOX:
        return _box_surface(dn, de, dd, shape.size_1, shape.size_2, shape.size_3)
    if kind == CYLINDER:
        return _cylinder_surface(dn, de, dd, shape.size_1, shape.size_2)
    if kind == WALL:
        r, gn, ge = _wall_surface(dn, de, shape.size_1, shape.size_2)
        return r, gn, ge, 0.0
    r = math.sqrt(dn * dn + de * de + dd * dd)
    radius = shape.size_1
    if r < _NO_DIRECTION_M:
        return r - radius, 0.0, 0.0, -1.0
    return r - radius, dn / r, de / r, dd / r


def _box_surface(dn: float, de: float, dd: float, hn: float, he: float, hd: float) -> tuple[float, float, float, float]:
    on = dn - min(max(dn, -hn), hn)
    oe = de - min(max(de, -he), he)
    od = dd - min(max(dd, -hd), hd)
    r = math.sqrt(on * on + oe * oe + od * od)
    if r >= _NO_DIRECTION_M:
        return r, on / r, oe / r, od / r
    out_n = math.fabs(dn) - hn
    out_e = math.fabs(de) - he
    out_d = math.fabs(dd) - hd
    if out_n >= out_e and out_n >= out_d:
        return out_n, 1.0 if dn >= 0.0 else -1.0, 0.0, 0.0
    if out_e >= out_d:
        return out_e, 0.0, 1.0 if de >= 0.0 else -1.0, 0.0
    return out_d, 0.0, 0.0, 1.0 if dd > 0.0 else -1.0


def _cylinder_surface(
    dn: float, de: float, dd: float, radius: float, half_height: float
) -> tuple[float, float, float, float]:
    axial = math.sqrt(dn * dn + de * de)
    radial_n, radial_e = (dn / axial, de / axial) if axial >= _NO_DIRECTION_M else (1.0, 0.0)
    down = 1.0 if dd > 0.0 else -1.0
    out_r = axial - radius
    out_d = math.fabs(dd) - half_height
    if out_r > 0.0 and out_d > 0.0:
        r = math.sqrt(out_r * out_r + out_d * out_d)
        if r >= _NO_DIRECTION_M:
            return r, out_r / r * radial_n, out_r / r * radial_e, out_d / r * down
    if out_r >= out_d:
        return out_r, radial_n, radial_e, 0.0
    return out_d, 0.0, 0.0, down


def _wall_surface(dn: float, de: float, hn: float, he: float) -> tuple[float, float, float]:
    square = hn * hn + he * he
    t = min(max((dn * hn + de * he) / square, -1.0), 1.0)
    on, oe = dn - t * hn, de - t * he
    r = math.sqrt(on * on + oe * oe)
    if r < _NO_DIRECTION_M:
        half = math.sqrt(square)
        return r, -he / half, hn / half
    return r, on / r, oe / r


def way_past_wall(table: FloatArray, i: int, start_ne: FloatArray, end_ne: FloatArray) -> Any:
    """`past_wall` of a table's row, for a way from one place (2,) to another."""
    return past_wall(shape_at(table, i), start_ne[0], start_ne[1], end_ne[0], end_ne[1])


def past_wall(shape: Any, n0: float, e0: float, n1: float, e1: float) -> tuple[float, float, float, float]:
    """Least signed distance in m of the way (n0, e0) to (n1, e1) to a wall, where on the way that
    is (0 to 1), and the unit vector (north, east) from the wall to there.

    A way that crosses the wall is as far beyond it as its end is, seen from where it begins.
    """
    hn, he = shape.size_1, shape.size_2
    an, ae = n0 - shape.north, e0 - shape.east
    bn, be = n1 - shape.north, e1 - shape.east
    half = math.sqrt(hn * hn + he * he)
    ln, le = -he / half, hn / half  # to the wall's left
    side_a, side_b = an * ln + ae * le, bn * ln + be * le
    if (side_a > 0.0) != (side_b > 0.0):
        share = side_a / (side_a - side_b)
        along = ((an + share * (bn - an)) * hn + (ae + share * (be - ae)) * he) / half
        if math.fabs(along) <= half:
            sign = 1.0 if side_a > 0.0 else -1.0
            return sign * side_b, 1.0, sign * ln, sign * le
    # They do not cross, so one of the four ends is nearest.
    least, where = math.INFINITY, 0.0
    gn, ge = ln, le
    square = (bn - an) ** 2 + (be - ae) ** 2
    for k in range(4):
        at = float(k)
        if k > 1:
            at = 0.0
            if square > 0.0:
                sign = 1.0 if k == 2 else -1.0
                at = ((sign * hn - an) * (bn - an) + (sign * he - ae) * (be - ae)) / square
                at = min(max(at, 0.0), 1.0)
        r, dn, de = _wall_surface(an + at * (bn - an), ae + at * (be - ae), hn, he)
        if r < least:
            least, where, gn, ge = r, at, dn, de
    return least, where, gn, ge


def fill_clearances(table: FloatArray, at: FloatArray, least: FloatArray, reach: FloatArray) -> None:
    """Fill `least` (k,) with the clearance of each place of `at` (k, 3), as `clearance` gives it; reach: (m,), written,
    as `fill_reach` does."""
    fill_reach(table, reach)
    for k in range(at.shape[0]):
        least[k] = clearance_at(table, reach, at[k, 0], at[k, 1], at[k, 2])


def fill_reach(table: FloatArray, reach: FloatArray) -> None:
    """Write for each shape how far its parts are from its place at most, (m,)."""
    for i in range(table.shape[0]):
        shape = shape_at(table, i)
        reach[i] = math.sqrt(shape.size_1 * shape.size_1 + shape.size_2 * shape.size_2 + shape.size_3 * shape.size_3)


def clearance_at(table: FloatArray, reach: FloatArray, qn: float, qe: float, qd: float) -> float:
    """Clearance of one place. Most shapes are passed over by one coordinate and their `reach` alone; rounding is
    monotonic, so that it never hides the nearest."""
    nearest = math.INFINITY
    for i in range(table.shape[0]):
        shape = shape_at(table, i)
        north, east = math.fabs(qn - shape.north), math.fabs(qe - shape.east)
        if north - reach[i] < nearest and east - reach[i] < nearest:
            nearest = min(nearest, shape_surface(shape, qn, qe, qd)[0])
    return nearest
