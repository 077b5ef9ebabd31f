"""Safety filter: the accelerations nearest to the wanted ones that keep every clearance.

The filter owns the double integrator of every virtual leader. A period T with acceleration u takes it to

    p⁺ = p + T v + T² u/2,   v⁺ = v + T u,   |u| <= a_max,   |v⁺| <= v_max (or slower than now by braking)        (1)

m(p, v, u) is the braking clearance of a constraint (braking_clearance.py): the least distance over this period and over
the braking after it of all vehicles concerned. With u_b the braking of everybody and D the distance required,

    m(p, v, u) >= min(D, m(p, v, u_b))   for every constraint, in every period                                    (2)

is kept whatever is wanted, for u_b itself satisfies it and is always left as the last resort. Since braking does not
lower m, min(D, m) never falls from period to period: who starts apart stays apart for ever, and who is too near does
not come nearer. What others do is assumed (straight on, within a radius that may grow) and looked at for `horizon_s`.

Each period: (a) the wanted velocity, turned a little to the right and up or down by id where it cannot be had, so that
none stand face to face [choice]; (b) the nearest accelerations of all vehicles together that satisfy m >= D, m made
linear at the last result, by Hildreth's and Dykstra's projections in a fixed order and number; (c) every constraint
checked as it is, not linear: who is concerned where (2) fails goes a step towards its braking, until (2) holds
everywhere. [lineage] of (b): Wang, Ames, Egerstedt, Safety barrier certificates for collisions-free multirobot systems,
IEEE T-RO 33(3), 2017, with brakes along the velocity, not along the line of sight, so that all can brake at once
[choice]. Who fell back in (c) is given the most that the others' accelerations leave it, one vehicle after the other.

Frames NED, SI units, no state and no clock. Vehicles are taken in order of id, so that their order does not matter.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.kernels import kernel
from gcs.planner.braking_clearance import FloatArray, IntArray
from gcs.planner.line_of_sight import bounds
from gcs.planner.neighbours import near_pairs
from gcs.planner.safety_constraints import OBSTACLE, OTHER, PAIR, PLANE
from gcs.planner.safety_solver import solve
from gcs.scenario.geometry import COLUMNS, KIND, WALL

KINDS = ("", "vehicle", "other", "obstacle", "wall")
"""Names of `Filtered.binding_kind`; a wall is a side of the fence or the floor: low n, e, d, then high n, e, d."""


def _none() -> FloatArray:
    return np.zeros((0, 3))


@dataclass(frozen=True)
class FilterSettings:
    """Constants of the filter [choice];.

    period_s: from one call to the next. separation_m: wanted between two vehicles, centre to centre, without margins.
    clearance_m: wanted to obstacles' surfaces, without margin. brake_share: of a_max, that brakes may count on.
    horizon_s: how far others are looked at. buffer_m: kept above D where there is room, so that (c) seldom acts.
    recover_m_s: how fast those that are too near part. turn_rad, climb_rad: of a wanted velocity that cannot be had.
    rounds: of making linear, at most; sweeps: of projections in each.
    """

    period_s: float = 0.1
    separation_m: float = 0.6
    clearance_m: float = 0.2
    brake_share: float = 0.8
    horizon_s: float = 3.0
    buffer_m: float = 0.03
    recover_m_s: float = 2.0
    turn_rad: float = 0.9
    climb_rad: float = 0.3
    rounds: int = 6
    sweeps: int = 20

    def __post_init__(self) -> None:
        for item in fields(self):
            value = getattr(self, item.name)
            above = item.name in ("period_s", "brake_share", "horizon_s", "rounds", "sweeps", "separation_m")
            if not (np.isfinite(value) and value >= 0 and (value > 0 or not above)):
                least = "above" if above else "at least"
                raise ValueError(f"rules: {item.name} is {value!r}; it must be finite and {least} 0")
        if self.brake_share > 1.0:
            raise ValueError(f"rules: brake_share is {self.brake_share!r}; it must be at most 1")


@dataclass(frozen=True)
class Leaders:
    """The leaders that the filter moves, n of them; scalars stand for all.

    ids (n,): different from each other. p_ned, v_ned (n, 3): m, m/s. v_max_m_s, a_max_m_s2 (n,): limits, above 0.
    margin_m (n,): tracking error and what latency costs; two vehicles keep separation + both margins.
    low_ned, high_ned (n, 3) or (3,): the fence; high_ned[:, 2] is the floor (down). Infinite where there is none.
    """

    ids: ArrayLike
    p_ned: ArrayLike
    v_ned: ArrayLike
    v_max_m_s: ArrayLike
    a_max_m_s2: ArrayLike
    margin_m: ArrayLike = 0.0
    low_ned: ArrayLike = -np.inf
    high_ned: ArrayLike = np.inf


@dataclass(frozen=True)
class Others:
    """Vehicles that give no way, m of them: traffic, and vehicles that are not steered by this filter, extrapolated to
    now.

    p_ned, v_ned (m, 3); radius_m (m,): distance to be kept now, separation and uncertainty by age included, margins of
    our vehicles not; growth_m_s (m,): how fast that grows on within the horizon.
    """

    p_ned: ArrayLike = field(default_factory=_none)
    v_ned: ArrayLike = field(default_factory=_none)
    radius_m: ArrayLike = 0.0
    growth_m_s: ArrayLike = 0.0


@dataclass(frozen=True)
class Filtered:
    """u_ned, p_next_ned, v_next_ned (n, 3); changed_m_s2 (n,): how far u is from the wanted one within limits.

    binding_kind, binding (n,): index into KINDS and what in it most changed u (index of the vehicle, the other, the
    obstacle, the wall), 0 and -1 where nothing did. checked (n,): 0 as projected, 1 and 2 nearer to braking, 3 braking.
    """

    u_ned: FloatArray
    p_next_ned: FloatArray
    v_next_ned: FloatArray
    changed_m_s2: FloatArray
    binding_kind: IntArray
    binding: IntArray
    checked: IntArray


def filter_step(
    vehicles: Leaders,
    v_wanted_ned: ArrayLike,
    *,
    rules: FilterSettings,
    others: Others | None = None,
    obstacles: FloatArray | None = None,
    beyond: NDArray[np.bool_] | None = None,
    pair_required_m: ArrayLike = (),
    other_required_m: ArrayLike = (),
    apart: bool = True,
) -> Filtered:
    """The next period of all leaders (module docstring).

    v_wanted_ned (n, 3): velocity wanted at the period's end. obstacles: table of gcs/scenario/geometry.py. beyond (n,):
    who is on a wall's wrong side, which no wall of the table keeps there; nobody where it is left out.
    pair_required_m: rows (id, id, m), whole distance between two leaders instead of separation + margins, as for the
    partners of a transfer. other_required_m: rows (id, index of the other, m) instead of radius + margin; 0 for none.
    apart: whether leaders keep apart from each other; else each is filtered as if it were alone.
    ValueError says which argument has a wrong shape or a value that is not finite or out of range.
    """
    ids = np.asarray(vehicles.ids, dtype=np.int64)
    n = len(ids)
    if ids.shape != (n,) or len(np.unique(ids)) != n:
        raise ValueError("ids must be (n,) integers that differ from each other")
    order = np.argsort(ids, kind="stable")
    back = np.argsort(order, kind="stable")
    p = _array("p_ned", vehicles.p_ned, (n, 3))[order]
    v = _array("v_ned", vehicles.v_ned, (n, 3))[order]
    wanted = _array("v_wanted_ned", v_wanted_ned, (n, 3))[order]
    v_max = _array("v_max_m_s", vehicles.v_max_m_s, (n,), least=1e-6)[order]
    a_max = _array("a_max_m_s2", vehicles.a_max_m_s2, (n,), least=1e-6)[order]
    margin = _array("margin_m", vehicles.margin_m, (n,), least=0.0)[order]
    sides = (np.asarray(side, dtype=np.float64) for side in (vehicles.low_ned, vehicles.high_ned))
    walls = np.hstack([np.broadcast_to(side, (n, 3)) for side in sides])
    if np.isnan(walls).any():
        raise ValueError("low_ned and high_ned must be numbers; infinite ones stand for no wall")
    around = others or Others()
    m = len(np.asarray(around.p_ned).reshape(-1, 3))
    moving = np.hstack([_array("others: p_ned", around.p_ned, (m, 3)), _array("others: v_ned", around.v_ned, (m, 3))])
    moving = np.column_stack([
        moving,
        _array("others: radius_m", around.radius_m, (m,), least=0.0),
        _array("others: growth_m_s", around.growth_m_s, (m,), least=0.0),
    ])  # fmt: skip
    table = np.zeros((0, COLUMNS)) if obstacles is None else _array("obstacles", obstacles, (len(obstacles), COLUMNS))
    brake = rules.brake_share * a_max
    speed = np.linalg.norm(v, axis=1) + a_max * rules.period_s
    # No way is longer: the coming period, the braking after it (stop_distance), and what activates below.
    reach = rules.period_s * speed + speed**2 / (2 * brake) + brake * rules.period_s**2 / 8 + rules.buffer_m
    rows = [
        *([_pairs(p, reach, margin, rules, _special(pair_required_m, ids, ids, order, back))] if apart else []),
        _others(p, reach, margin, moving, rules, _special(other_required_m, ids, np.arange(m), order, None)),
        _shapes(p, reach, margin, table, rules, np.zeros(n, dtype=np.bool_) if beyond is None else beyond[order]),
        _walls(p, reach, margin, walls[order]),
    ]
    constraints = np.concatenate(rows)
    u, changed, kind, binding, checked = solve(
        p, v, wanted, v_max, a_max, brake, ids[order], np.ascontiguousarray(constraints[:, :3], dtype=np.int64),
        np.ascontiguousarray(constraints[:, 3]), moving, table, walls[order], rules.period_s, rules.horizon_s,
        rules.buffer_m, rules.recover_m_s, rules.turn_rad, rules.climb_rad, rules.rounds, rules.sweeps,
    )  # fmt: skip
    pairs = kind == PAIR
    binding[pairs] = order[binding[pairs]]
    p_next = p + rules.period_s * v + 0.5 * rules.period_s**2 * u
    v_next = v + rules.period_s * u
    return Filtered(u[back], p_next[back], v_next[back], changed[back], kind[back], binding[back], checked[back])


def _array(name: str, value: ArrayLike, shape: tuple[int, ...], least: float | None = None) -> FloatArray:
    array = np.asarray(value, dtype=np.float64)
    if array.ndim == 0 and len(shape) == 1:
        array = np.broadcast_to(array, shape)
    if array.size == 0 and 0 in shape:
        array = array.reshape(shape)
    if array.shape != shape:
        raise ValueError(f"{name} has shape {array.shape}; it must be {shape}")
    if not np.isfinite(array).all():
        row = int(np.argwhere(~np.isfinite(array))[0][0])
        raise ValueError(f"{name} holds a value that is not finite in row {row}; leave that row out or mend its data")
    if least is not None and (array < least).any():
        raise ValueError(f"{name} holds {array.min()!r}; it must be at least {least!r}")
    return np.ascontiguousarray(array)


def _special(
    rows: ArrayLike, ids: IntArray, seconds: IntArray, order: IntArray, back: IntArray | None
) -> dict[tuple[int, int], float]:
    """Required distances of single pairs by their rows in order of id; pairs with an absent vehicle are passed over."""
    given = np.asarray(rows, dtype=np.float64).reshape(-1, 3)
    if not np.isfinite(given).all() or (given[:, 2] < 0).any():
        raise ValueError("required distances must be rows of two numbers that name a pair and a length of at least 0 m")
    first = {int(sysid): row for row, sysid in enumerate(ids[order])}
    second = first if back is not None else {int(k): int(k) for k in seconds}
    found: dict[tuple[int, int], float] = {}
    for a, b, required in given:
        if int(a) in first and int(b) in second and (back is None or a != b):
            i, j = first[int(a)], second[int(b)]
            found[(min(i, j), max(i, j)) if back is not None else (i, j)] = float(required)
    return found


def _rows(kind: int, i: NDArray[np.int64], j: NDArray[np.int64], required: FloatArray) -> FloatArray:
    """Constraints (k, 4): kind, vehicle, with what, required distance; in order of vehicle, then of what."""
    at = np.lexsort((j, i))
    return np.column_stack([np.full(len(i), float(kind)), i[at], j[at], required[at]])


def _replace(required: FloatArray, i: IntArray, j: IntArray, special: dict[tuple[int, int], float]) -> FloatArray:
    for (a, b), value in special.items():
        required[(i == a) & (j == b)] = value
    return required


def _pairs(
    p: FloatArray, reach: FloatArray, margin: FloatArray, rules: FilterSettings, special: dict[tuple[int, int], float]
) -> FloatArray:
    n = len(p)
    if n < 2:
        return np.zeros((0, 4))
    if n <= 40:
        i, j = (side.astype(np.int64) for side in np.triu_indices(n, 1))
    else:
        most = rules.separation_m + 2 * margin.max() + max(special.values(), default=0.0)
        i, j = near_pairs(p, 2 * reach.max() + most)
    required = _replace(rules.separation_m + margin[i] + margin[j], i, j, special)
    near = np.linalg.norm(p[i] - p[j], axis=1) <= reach[i] + reach[j] + required
    return _rows(PAIR, i[near], j[near], required[near])


def _others(
    p: FloatArray, reach: FloatArray, margin: FloatArray, moving: FloatArray, rules: FilterSettings,
    special: dict[tuple[int, int], float],
) -> FloatArray:  # fmt: skip
    ahead = rules.horizon_s + rules.period_s
    far = np.linalg.norm(moving[:, 3:6], axis=1) * ahead + moving[:, 6] + moving[:, 7] * ahead
    most = max(special.values(), default=0.0) + margin.max(initial=0.0)
    apart = np.sqrt(sum((p[:, None, axis] - moving[None, :, axis]) ** 2 for axis in range(3)))
    i, j = (side.astype(np.int64) for side in np.nonzero(apart <= reach[:, None] + far[None, :] + most))
    free = np.zeros(apart.shape, dtype=bool)
    for pair, required in special.items():
        free[pair] = required == 0.0  # not a distance of 0, which a braking leader would have to keep too
    kept = ~free[i, j]
    i, j = i[kept], j[kept]
    return _rows(OTHER, i, j, _replace(moving[j, 6] + margin[i], i, j, special))


def _shapes(
    p: FloatArray,
    reach: FloatArray,
    margin: FloatArray,
    table: FloatArray,
    rules: FilterSettings,
    beyond: NDArray[np.bool_],
) -> FloatArray:
    if not len(table) or not len(p):
        return np.zeros((0, 4))
    required = rules.clearance_m + margin
    low, high = bounds(table)
    i, j = _within_boxes(p, reach + required, low, high)
    if beyond.any():
        kept = ~(beyond[i] & (table[j, KIND] == WALL))
        i, j = i[kept], j[kept]
    return _rows(OBSTACLE, i, j, required[i])


@kernel()
def _within_boxes(p: FloatArray, within_m: FloatArray, low: FloatArray, high: FloatArray) -> tuple[IntArray, IntArray]:
    """Kernel: rows of places and of boxes that are at most `within_m` (n,) apart."""
    size = 256
    found = np.empty((2, size), dtype=np.int64)
    count = 0
    order = np.argsort(low[:, 0])
    south = low[order, 0]
    widest_m = (high[:, 0] - low[:, 0]).max()
    for i in range(p.shape[0]):
        square_m2 = within_m[i] ** 2
        first = np.searchsorted(south, p[i, 0] - within_m[i] - widest_m)
        last = np.searchsorted(south, p[i, 0] + within_m[i], side="right")
        for at in range(first, last):
            j = order[at]
            apart_m2 = 0.0
            for axis in range(3):
                x = p[i, axis]
                out_m = max(low[j, axis] - x, x - high[j, axis], 0.0)
                apart_m2 += out_m * out_m
            if apart_m2 <= square_m2:
                if count == size:
                    longer = np.empty((2, 2 * size), dtype=np.int64)
                    longer[:, :size] = found
                    found, size = longer, 2 * size
                found[0, count], found[1, count] = i, j
                count += 1
    return found[0, :count].copy(), found[1, :count].copy()


def _walls(p: FloatArray, reach: FloatArray, margin: FloatArray, walls: FloatArray) -> FloatArray:
    clear = np.hstack([p - walls[:, :3], walls[:, 3:] - p])
    i, axis = (side.astype(np.int64) for side in np.nonzero(clear <= (reach + margin)[:, None]))
    return _rows(PLANE, i, axis, margin[i])
