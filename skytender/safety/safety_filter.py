"""Safety filter: the accelerations nearest to the wanted ones that keep every clearance.

The filter owns the double integrator of every virtual leader. A period T with acceleration u takes it to

    p⁺ = p + T v + T² u/2,   v⁺ = v + T u,   |u| <= a_max,   |v⁺| <= v_max (or slower than now by braking)        (1)

m(p, v, u) is the braking clearance of a constraint (braking_clearance.py): the least distance over this period and over
the braking after it of all vehicles concerned. With u_b the braking of all and D the distance required,

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
from typing import Any

import cython
import numpy as np
from cython.cimports.libc import math
from numpy.typing import ArrayLike, NDArray

from skytender.geometry import COLUMNS
from skytender.safety.braking_clearance import FloatArray, IntArray
from skytender.safety.safety_constraints import PAIR
from skytender.safety.safety_solver import solve

KINDS = ("", "vehicle", "other", "obstacle", "wall", "reach")
"""Names of `Filtered.binding_kind`; a wall is a side of the fence or the floor: low n, e, d, then high n, e, d."""


BRAKE_SHARE = 0.8
"""of the greatest acceleration that brakes may count on"""
LEAST_LIMIT = 1e-6
"""of a leader's speed, m/s, and acceleration, m/s²"""
_LEAST, _SIZE = LEAST_LIMIT, COLUMNS
_NO_SHAPES = np.zeros((0, COLUMNS))


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
    brake_share: float = BRAKE_SHARE
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
            above = item.name in ("period_s", "brake_share", "horizon_s", "rounds", "sweeps")
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
    spread_m (n,): how far each may be from its place as it is known; two keep the root of both spreads' squares more.
    """

    ids: ArrayLike
    p_ned: ArrayLike
    v_ned: ArrayLike
    v_max_m_s: ArrayLike
    a_max_m_s2: ArrayLike
    margin_m: ArrayLike = 0.0
    low_ned: ArrayLike = -np.inf
    high_ned: ArrayLike = np.inf
    spread_m: ArrayLike = 0.0


@dataclass(frozen=True)
class Others:
    """Vehicles that give no way, m of them: traffic, and vehicles that are not steered by this filter, extrapolated to
    now.

    p_ned, v_ned (m, 3); radius_m (m,): distance to be kept now, separation and uncertainty by age included, margins of
    our vehicles not; growth_m_s (m,): how fast that grows on within the horizon. agile_m_s (m,): above 0 for what may
    turn any way at up to so much, whatever its v_ned; vehicles that are as fast leave it (leaving.py) as far as pairs,
    obstacles and walls allow, and the others pass it over; -w for the straight way of one that only they heed.
    """

    p_ned: ArrayLike = field(default_factory=_none)
    v_ned: ArrayLike = field(default_factory=_none)
    radius_m: ArrayLike = 0.0
    growth_m_s: ArrayLike = 0.0
    agile_m_s: ArrayLike = 0.0


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

    v_wanted_ned (n, 3): velocity wanted at the period's end. obstacles: table of skytender/geometry.py. beyond (n,):
    who is on a wall's wrong side, which no wall of the table keeps there; nobody where it is left out.
    pair_required_m: rows (id, id, m), whole distance between two leaders instead of separation + margins, as for the
    partners of a transfer. other_required_m: rows (id, index of the other, m) instead of radius + margin; 0 for none.
    apart: whether leaders keep apart from each other; else each is filtered as if it were alone.
    ValueError says which argument has a wrong shape or a value that is not finite or out of range.
    """
    ids = np.asarray(vehicles.ids, dtype=np.int64)
    n, around = len(ids), others or Others()
    m = np.asarray(around.p_ned).size // 3
    order, back = _order(ids)
    p, v = _array("p_ned", vehicles.p_ned, (n, 3)), _array("v_ned", vehicles.v_ned, (n, 3))
    wanted = _array("v_wanted_ned", v_wanted_ned, (n, 3))
    v_max, a_max = _array("v_max_m_s", vehicles.v_max_m_s, (n,)), _array("a_max_m_s2", vehicles.a_max_m_s2, (n,))
    margin, spread = _array("margin_m", vehicles.margin_m, (n,)), _array("spread_m", vehicles.spread_m, (n,))
    walls = np.empty((n, 6))
    walls[:, :3], walls[:, 3:] = vehicles.low_ned, vehicles.high_ned
    moving = np.empty((m, 9))
    if m:
        moving[:, 0:3] = _array("others: p_ned", around.p_ned, (m, 3))
        moving[:, 3:6] = _array("others: v_ned", around.v_ned, (m, 3))
        moving[:, 6] = _array("others: radius_m", around.radius_m, (m,))
        moving[:, 7] = _array("others: growth_m_s", around.growth_m_s, (m,))
        moving[:, 8] = _array("others: agile_m_s", around.agile_m_s, (m,))
    table = _NO_SHAPES if obstacles is None else _array("obstacles", obstacles, (len(obstacles), COLUMNS))
    if not _sound(p, v, wanted, v_max, a_max, margin, spread, moving, table, walls):
        for name, array, least in (
            ("p_ned", p, None),
            ("v_ned", v, None),
            ("v_wanted_ned", wanted, None),
            ("v_max_m_s", v_max, LEAST_LIMIT),
            ("a_max_m_s2", a_max, LEAST_LIMIT),
            ("margin_m", margin, 0.0),
            ("spread_m", spread, 0.0),
            ("others", moving, None),
            ("obstacles", table, None),
        ):
            _check(name, array, least)
        _check("others: radius_m and growth_m_s", moving[:, 6:8], 0.0)
        raise ValueError("low_ned and high_ned must be numbers; infinite ones stand for no wall")
    pairs = _special(pair_required_m, ids, ids, order, pairs=True)
    singles = _special(other_required_m, ids, np.arange(m), order, pairs=False)
    astray = np.zeros(n, dtype=np.bool_) if beyond is None else beyond
    by_vehicle = [p, v, wanted, v_max, a_max, margin, spread]
    if order is not None:
        by_vehicle = [column[order] for column in by_vehicle]
        ids, astray, walls = ids[order], astray[order], walls[order]
    limits = {
        "separation": rules.separation_m,
        "clearance": rules.clearance_m,
        "brake_share": rules.brake_share,
        "dt": rules.period_s,
        "horizon": rules.horizon_s,
        "buffer": rules.buffer_m,
        "recover": rules.recover_m_s,
        "turn": rules.turn_rad,
        "climb": rules.climb_rad,
        "rounds": rules.rounds,
        "sweeps": rules.sweeps,
        "apart": apart,
    }
    arguments: tuple[Any, ...] = (*by_vehicle, ids, moving, table, astray.view(np.uint8), walls, pairs, singles, limits)
    u, changed, kind, binding, checked = solve(*arguments)
    if order is not None:
        paired = kind == PAIR
        binding[paired] = order[binding[paired]]
        u, changed, kind, binding, checked = u[back], changed[back], kind[back], binding[back], checked[back]
    p_next = p + rules.period_s * v + 0.5 * rules.period_s**2 * u
    v_next = v + rules.period_s * u
    return Filtered(u, p_next, v_next, changed, kind, binding, checked)


@cython.wraparound(True)
def _order(ids: IntArray) -> tuple[IntArray | None, IntArray | None]:
    """Rows in order of id, and the way back; None where they are in order. ValueError where two have the same."""
    if ids.ndim == 1 and (ids[1:] > ids[:-1]).all():
        return None, None
    if ids.ndim != 1 or len(np.unique(ids)) != len(ids):
        raise ValueError("ids must be (n,) integers that differ from each other")
    order = np.argsort(ids, kind="stable")
    return order, np.argsort(order, kind="stable")


def _array(name: str, value: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    array = np.ascontiguousarray(value, dtype=np.float64)
    if array.shape == shape and array.size:
        return array
    if np.ndim(value) == 0 and len(shape) == 1:
        array = np.full(shape, array[0])
    if array.size == 0 and 0 in shape:
        array = array.reshape(shape)
    if array.shape != shape:
        raise ValueError(f"{name} has shape {array.shape}; it must be {shape}")
    return array


def _sound(
    p: FloatArray, v: FloatArray, wanted: FloatArray, v_max: FloatArray, a_max: FloatArray, margin: FloatArray,
    spread: FloatArray, moving: FloatArray, table: FloatArray, walls: FloatArray,
) -> bool:  # fmt: skip
    """Whether all is finite, walls are numbers, and limits and distances not too small."""
    n, m = p.shape[0], moving.shape[0]
    for i in range(n):
        if not (v_max[i] >= _LEAST and a_max[i] >= _LEAST and margin[i] >= 0.0 and spread[i] >= 0.0):
            return False
    for i in range(m):
        if not (moving[i, 6] >= 0.0 and moving[i, 7] >= 0.0):
            return False
    for i in range(6 * n):
        if math.isnan(walls[i // 6, i % 6]):
            return False
    return (
        _finite(cython.address(p[0, 0]), 3 * n)
        and _finite(cython.address(v[0, 0]), 3 * n)
        and _finite(cython.address(wanted[0, 0]), 3 * n)
        and _finite(cython.address(v_max[0]), n)
        and _finite(cython.address(a_max[0]), n)
        and _finite(cython.address(margin[0]), n)
        and _finite(cython.address(spread[0]), n)
        and _finite(cython.address(moving[0, 0]), 9 * m)
        and _finite(cython.address(table[0, 0]), _SIZE * table.shape[0])
    )


def _finite(numbers: Any, count: int) -> bool:
    for i in range(count):  # noqa: SIM110, as a generator is no C loop
        if not math.isfinite(numbers[i]):
            return False
    return True


def _check(name: str, array: FloatArray, least: float | None) -> None:
    if not np.isfinite(array).all():
        row = int(np.argwhere(~np.isfinite(array))[0][0])
        raise ValueError(f"{name} holds a value that is not finite in row {row}; leave that row out or mend its data")
    if least is not None and (array < least).any():
        raise ValueError(f"{name} holds {float(array.min())!r}; it must be at least {least!r}")


def _special(rows: ArrayLike, ids: IntArray, seconds: IntArray, order: IntArray | None, *, pairs: bool) -> FloatArray:
    """Required distances of single pairs (k, 3), by their rows in order of id; pairs with an absent vehicle are passed
    over. pairs: of two vehicles, instead of a vehicle and the row of another."""
    given = np.asarray(rows, dtype=np.float64).reshape(-1, 3)
    if not len(given):
        return given
    if not np.isfinite(given).all() or (given[:, 2] < 0).any():
        raise ValueError("required distances must be rows of two numbers that name a pair and a length of at least 0 m")
    first = {int(sysid): row for row, sysid in enumerate(ids if order is None else ids[order])}
    second = first if pairs else {int(k): int(k) for k in seconds}
    found = []
    for a, b, required in given:
        if int(a) in first and int(b) in second and not (pairs and a == b):
            i, j = first[int(a)], second[int(b)]
            found.append((min(i, j), max(i, j), required) if pairs else (i, j, required))
    return np.array(found, dtype=np.float64).reshape(-1, 3)
