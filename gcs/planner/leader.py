"""Virtual leaders: the planned points that the vehicles follow, moved through the field (docs/model/planner.md#planner;
paper eq. 4, its step a [choice]).

    q += l min(1, |F|/k0) F/|F| + feed-forward,   l = speed · period / steps,   steps = ceil(speed · period / κ)
    q += l F/|F| + feed-forward                   with full steps (the paper's prose); the last ends on the goal

Feed-forward of the goal's velocity v_g [choice]: F alone follows a moving goal at a distance |v_g|/speed · cap. So
v_g dt is added: whole within cap_m of the goal, fading to none at twice that; and whole where nothing repels, fading
to none at |F_o| = k0/4, so that near obstacles the field alone decides. The sum is shortened to l, the speed limit.
"""

from typing import Any, NamedTuple

import cython
import numpy as np
from cython.cimports.gcs.planner.fuzzy_escape import escape_force, memory_at
from cython.cimports.gcs.planner.leader import ARRIVED, GOES_ON, HOLDS
from cython.cimports.gcs.planner.potential_field import attraction_to, field_of, repulsion_of_shape
from cython.cimports.libc import math
from cython.cimports.skytender.geometry import shape_at
from numpy.typing import ArrayLike, NDArray

from gcs.planner.fuzzy_escape import MEMORY_SIZE
from gcs.planner.neighbours import FEW, IntArray, everyone, within_range
from gcs.planner.potential_field import FieldConstants
from skytender import layout
from skytender.geometry import COLUMNS, FloatArray, points

_UNFREE_SHARE = 0.25  # of k0: the repulsion at which nothing is fed forward any more
_FEW_MOVING = 8_000
"""Up to so many pairs of a leader and what moves, looking at each costs less than choosing."""
_ROUNDING_M = 1e-6

BoolArray = NDArray[np.bool_]
_NO_ROWS = np.empty(0, np.int64)


STAYS: int


def advance(
    q_ned: ArrayLike,
    memory: FloatArray,
    goals: ArrayLike,
    goal_velocity: ArrayLike,
    *,
    repulsors: FloatArray,
    moving: ArrayLike,
    radii_m: ArrayLike = 0.0,
    ranges_m: ArrayLike,
    owner: ArrayLike,
    exempt: ArrayLike,
    field: FieldConstants,
    speed_m_s: ArrayLike,
    period_s: float,
    escape: bool,
    attractors: ArrayLike = (),
    attraction_ranges_m: ArrayLike = (),
    drawn: ArrayLike | None = None,
    obstacle_ranges_m: ArrayLike | None = None,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Next positions (n, 3) m, next memory (n, MEMORY_SIZE) and mean velocity (n, 3) m/s of n leaders, NED.

    q_ned, goals, goal_velocity: (n, 3), m and m/s, all at the start of the period; goals move on at their velocity
    within it. memory: `fuzzy.new_memory(n)` at first, then what the last call returned.
    repulsors: obstacle table (m1, COLUMNS) that repels everyone within field.repulsion_range_m.
    moving (m2, 3) m, radii_m (m2,) or one for all, ranges_m (m2,): points or spheres that stand for vehicles and
    traffic, and how far from their surfaces they repel; held where they are for the period
    (widen their ranges for the age of their report). owner (m2,): the leader that each one is, which it does not repel;
    -1 for none. exempt (n, m2): True where a leader is not repelled, as by its target or its partner in a transfer.
    speed_m_s: (n,), or one for all, >= 0. escape: whether the fuzzy escape helps out of local minima.
    attractors (m3, 3) m, attraction_ranges_m (m3,): points beside the goal that draw a leader within their range
    (paper eq. 10), held where they are for the period. drawn (n, m3): the vehicles that they attract, all without it.
    obstacle_ranges_m (n,): how far obstacles repel each leader, instead of field.repulsion_range_m.

    Leaders see each other where they were at the start, so that their order does not matter. The arguments are left as
    they are. ValueError names the argument whose shape is wrong or which holds a value that is not finite.
    """
    q = _array("q_ned", q_ned, (-1, 3))
    n = len(q)
    at = _array("moving", moving, (-1, 3))
    m = len(at)
    following = _array("memory", memory, (n, MEMORY_SIZE)).copy()
    if repulsors.ndim != 2 or repulsors.shape[1] != COLUMNS:
        raise ValueError(f"repulsors has shape {repulsors.shape}; it must be an obstacle table (m, {COLUMNS})")
    speeds = _array("speed_m_s", [speed_m_s] * n if isinstance(speed_m_s, int | float) else speed_m_s, (n,))
    if n and speeds.min() < 0:
        raise ValueError(f"speed_m_s is {speeds.min()!r} for leader {int(speeds.argmin())}; it must be at least 0")
    if not (math.isfinite(period_s) and period_s > 0):
        raise ValueError(f"period_s is {period_s!r}; it must be finite and above 0")
    exempted = np.array(exempt, dtype=np.bool_)
    if exempted.shape != (n, m):
        raise ValueError(f"exempt has shape {exempted.shape}; it must be {(n, m)}: leaders, moving repulsors")
    owners = np.asarray(owner, dtype=np.int64)
    if owners.shape != (m,) or (m and owners.max() >= n):
        raise ValueError(f"owner must give one leader below {n}, or -1, for each of {m} moving repulsors")
    owned = (owners >= 0).nonzero()[0]
    exempted[owners[owned], owned] = True

    others = _array("attractors", attractors, (-1, 3))
    draws = np.ones((n, len(others)), dtype=np.bool_) if drawn is None else np.array(drawn, dtype=np.bool_)
    if draws.shape != (n, len(others)):
        raise ValueError(f"drawn has shape {draws.shape}; it must be {(n, len(others))}: leaders, attractors")

    if obstacle_ranges_m is None:
        reach_of_obstacles = np.full(n, field.repulsion_range_m)
    else:
        reach_of_obstacles = _array("obstacle_ranges_m", obstacle_ranges_m, (n,))
    leaders = LeaderRows(n, reach_of_obstacles, following)
    leaders.q_ned[:], leaders.speed_m_s[:] = q, speeds
    leaders.goal_ned[:] = _array("goals", goals, (n, 3))
    leaders.goal_v_ned[:] = _array("goal_velocity", goal_velocity, (n, 3))
    reaches = _array("attraction_ranges_m", attraction_ranges_m, (len(others),))
    lead(
        leaders,
        np.arange(n),
        q,
        UNLIMITED,
        repulsors,
        Moving(points(at, radii_m), _array("ranges_m", ranges_m, (m,)), exempted),
        Attracting(np.column_stack((others, reaches)), draws),
        field,
        period_s,
        escape=escape,
    )
    return leaders.q_ned.copy(), following, leaders.v_ned.copy()


def _leader_at(table: FloatArray, row: int) -> Any:
    return cython.cast("Leader *", cython.address(table[row, 0]))


_LEADER = _leader_at(layout.COUNTED[np.newaxis], 0)[0]
_PLACES, _WIDTH = layout.places(_LEADER), layout.size(_LEADER)


class LeaderRows:
    """n leaders, a row each, which is the struct Leader of leader.pxd; frame NED. Each part is a view of their table.
    `lead` moves q_ned, v_ned and the memory."""

    def __init__(self, n: int, obstacle_range_m: ArrayLike, memory: FloatArray) -> None:
        """memory: (n, MEMORY_SIZE), `fuzzy_escape.new_memory` at first."""
        self.table = table = np.zeros((n, _WIDTH))
        parts = {name: table[:, place] for name, place in _PLACES.items()}
        self.memory = memory
        self.q_ned: FloatArray = parts["q"]
        """(n, 3) m"""
        self.begin_ned: FloatArray = parts["begin"]
        """(n, 3) m, `q_ned` at the start of the period"""
        self.v_ned: FloatArray = parts["v"]
        """(n, 3) m/s, the mean of the last period"""
        self.begin_and_v: FloatArray = table[:, _PLACES["begin"].start : _PLACES["v"].stop]
        """(n, 6) both"""
        self.goal_ned: FloatArray = parts["goal"]
        """(n, 3) m at the start of the period"""
        self.goal_v_ned: FloatArray = parts["goal_v"]
        """(n, 3) m/s"""
        self.speed_m_s: FloatArray = parts["speed"]
        """(n,) limits, at least 0"""
        self.obstacle_range_m: FloatArray = parts["obstacle_range"]
        """(n,) how far obstacles repel each; none does at 0"""
        self.lowest_d: FloatArray = parts["lowest"]
        """(n,) m, the greatest down; infinite where there is none"""
        self.route_m: FloatArray = parts["route"]
        """(n,) m, the way that is left on a route; NaN where the way is straight"""
        self.obstacle_range_m[:], self.lowest_d[:], self.route_m[:] = obstacle_range_m, np.inf, np.nan


class SpeedLimits(NamedTuple):
    """Limits that lower leaders' speeds: by the leash, leaders wait for vehicles that have fallen behind; by the brake,
    they can stop at their goals."""

    leash_m: float = np.inf
    """inf: they do not wait"""
    lookahead_s: float = 0.0
    """by how much a vehicle is behind its leader anyhow"""
    brake_m_s2: float = np.inf
    """inf: they need not be able to stop"""


UNLIMITED = SpeedLimits()


class Moving(NamedTuple):
    """Spheres that repel k leaders, m of them; held where they are for the period."""

    table: FloatArray
    """obstacle table (m, COLUMNS) of points or spheres"""
    ranges_m: FloatArray
    """(m,) from their surfaces"""
    exempt: BoolArray
    """(k, m) vehicles that each does not repel"""


class Attracting(NamedTuple):
    """Points that draw k leaders beside their goals (paper eq. 10), m of them; held where they are for the period."""

    places: FloatArray
    """(m, 4) where, and their range, m"""
    drawn: BoolArray
    """(k, m) vehicles that each attracts"""


def lead(
    leaders: LeaderRows,
    rows: IntArray,
    here_ned: FloatArray,
    limits: SpeedLimits,
    obstacles: FloatArray,
    moving: Moving,
    attracting: Attracting,
    field: FieldConstants,
    period_s: float,
    *,
    escape: bool,
) -> None:
    """Move the leaders `rows` (k,), whose vehicles are at here_ned (n, 3), by one period, in place, after their speeds
    are lowered to the limits; all else is as `advance` says, and nothing is checked."""
    limit_speeds(rows, leaders.table, here_ned, limits.leash_m, limits.lookahead_s, limits.brake_m_s2)
    count, speed = len(rows), leaders.speed_m_s
    if count * len(obstacles) <= FEW:
        near_obstacles, obstacle_spans = everyone(count, len(obstacles))
    else:
        q = leaders.q_ned[rows]
        near_obstacles, obstacle_spans = within_range(q, speed[rows] * period_s, obstacles, field.repulsion_range_m)
    if count * len(moving.table) <= _FEW_MOVING:
        near_moving, moving_spans = everyone(count, len(moving.table))
    else:
        reach_m = speed[rows] * period_s
        near_moving, moving_spans = within_range(leaders.q_ned[rows], reach_m, moving.table, moving.ranges_m)
    _lead(
        rows, leaders.table, leaders.memory, attracting.places, attracting.drawn, obstacles, near_obstacles,
        obstacle_spans, moving.table, moving.ranges_m, moving.exempt, near_moving, moving_spans,
        field.constants(), period_s, escape,
        np.empty(len(moving.table), np.int64) if len(moving.table) else _NO_ROWS,
    )  # fmt: skip


def _array(name: str, value: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    array = np.ascontiguousarray(value, dtype=np.float64)
    if array.size == 0 and shape[0] in (-1, 0):
        array = array.reshape(0, *shape[1:])
    if array.shape[1:] != shape[1:] or array.ndim == 0 or shape[0] not in (-1, array.shape[0]):
        raise ValueError(f"{name} has shape {array.shape}; it must be {shape}, -1 standing for any number")
    # A sum is finite where all are, unless it overflows: that and a fault are then distinguished.
    if not math.isfinite(array.sum()) and not np.isfinite(array).all():
        row = int(np.argwhere(~np.isfinite(array))[0][0])
        raise ValueError(f"{name} holds a value that is not finite in row {row}; leave that row out or mend its data")
    return array


def _lead(
    rows: IntArray, table: FloatArray, memories: FloatArray, attractors: FloatArray, draws: BoolArray,
    obstacles: FloatArray, obstacle_rows: IntArray, obstacle_spans: IntArray, moving: FloatArray, ranges: FloatArray,
    exempt: BoolArray, moving_rows: IntArray, moving_spans: IntArray, constants: FloatArray, period: float,
    escape: bool, near: IntArray,
) -> None:  # fmt: skip
    """Move leaders in place. Leader rows[i] heeds rows[spans[i, 0]:spans[i, 1]] of obstacles and of moving; near (m,)
    is overwritten."""
    field = field_of(constants)
    for i in range(rows.shape[0]):
        one, memory = _leader_at(table, rows[i]), memory_at(memories, rows[i])
        q, goal, goal_v = one.q, one.goal, one.goal_v
        begin_n, begin_e, begin_d = q[0], q[1], q[2]
        reach = one.speed * period
        steps = cython.cast(cython.Py_ssize_t, math.ceil(reach / field.step - 1e-9))
        full_step, dt = 0.0, 0.0
        if steps > 0:
            full_step, dt = reach / steps, period / steps
        count = 0
        for k in range(moving_spans[i, 0], moving_spans[i, 1] if steps > 0 else moving_spans[i, 0]):
            j = moving_rows[k]
            other = shape_at(moving, j)
            # What is left out stays out of range, and would add nothing.
            n, e, d = q[0] - other.north, q[1] - other.east, q[2] - other.down
            around = reach + ranges[j] + other.size_1 + _ROUNDING_M
            if not exempt[i, j] and n * n + e * e + d * d <= around * around:
                near[count] = j
                count += 1
        for step in range(steps):
            gn = goal[0] + goal_v[0] * dt * step
            ge = goal[1] + goal_v[1] * dt * step
            gd = goal[2] + goal_v[2] * dt * step
            an, ae, ad = attraction_to(gn, ge, gd, math.INFINITY, q[0], q[1], q[2], field)
            for k in range(attractors.shape[0]):
                if draws[i, k]:
                    hn, he, hd = attractors[k, 0], attractors[k, 1], attractors[k, 2]
                    fn, fe, fd = attraction_to(hn, he, hd, attractors[k, 3], q[0], q[1], q[2], field)
                    an += fn
                    ae += fe
                    ad += fd
            on = 0.0
            oe = 0.0
            od = 0.0
            heeded, first = one.obstacle_range, obstacle_spans[i, 0]
            for k in range(first, obstacle_spans[i, 1] if heeded > 0.0 else first):
                fn, fe, fd = repulsion_of_shape(shape_at(obstacles, obstacle_rows[k]), heeded, q[0], q[1], q[2], field)
                on += fn
                oe += fe
                od += fd
            for k in range(count):
                j = near[k]
                fn, fe, fd = repulsion_of_shape(shape_at(moving, j), ranges[j], q[0], q[1], q[2], field)
                on += fn
                oe += fe
                od += fd
            distance = math.sqrt((gn - q[0]) ** 2 + (ge - q[1]) ** 2 + (gd - q[2]) ** 2)
            en = 0.0
            ee = 0.0
            ed = 0.0
            if escape:
                en, ee, ed = escape_force(
                    memory, q[0], q[1], q[2], an, ae, ad, on, oe, od, distance, full_step, field.step
                )
            fn, fe, fd = an + on + en, ae + oe + ee, ad + od + ed
            if field.full_steps != 0.0:
                sn, se, sd = _field_step(fn, fe, fd, min(full_step, distance), 0.0)
            else:
                sn, se, sd = _field_step(fn, fe, fd, full_step, field.k0)
            share = _fed_forward(on, oe, od, distance, field.cap, field.k0)
            sn += share * goal_v[0] * dt
            se += share * goal_v[1] * dt
            sd += share * goal_v[2] * dt
            length = math.sqrt(sn * sn + se * se + sd * sd)
            shorten = full_step / length if length > full_step else 1.0
            q[0] += shorten * sn
            q[1] += shorten * se
            q[2] += shorten * sd
        q[2] = min(q[2], one.lowest)
        one.v[0], one.v[1], one.v[2] = (q[0] - begin_n) / period, (q[1] - begin_e) / period, (q[2] - begin_d) / period


def limit_speeds(
    rows: IntArray, table: FloatArray, here: FloatArray, leash: float, lookahead: float, brake: float
) -> None:
    """Lower the speeds v of leaders, as `SpeedLimits` says, of vehicles at here (n, 3) [choice].

    With b the distance between leader and vehicle, and w the way that is left to the goal or on the route:
    v⁺ = min(v min(max(2 (1 - b/(leash + lookahead v)), 0), 1), |goal's velocity| + √(2 brake w)), 0 with w infinite.
    """
    if leash == math.INFINITY and brake == math.INFINITY:
        return
    for i in range(rows.shape[0]):
        one = _leader_at(table, rows[i])
        n, e, d = one.q[0] - here[rows[i], 0], one.q[1] - here[rows[i], 1], one.q[2] - here[rows[i], 2]
        behind = math.sqrt(n * n + e * e + d * d) / (leash + lookahead * one.speed)
        one.speed *= min(max(2.0 * (1.0 - behind), 0.0), 1.0)
        if brake == math.INFINITY:
            continue
        way = one.route
        if math.isnan(way):
            n, e, d = one.q[0] - one.goal[0], one.q[1] - one.goal[1], one.q[2] - one.goal[2]
            way = math.sqrt(n * n + e * e + d * d)
        n, e, d = one.goal_v[0], one.goal_v[1], one.goal_v[2]
        stops = math.sqrt(n * n + e * e + d * d) + math.sqrt(2.0 * brake * way)
        one.speed = 0.0 if way == math.INFINITY else min(one.speed, stops)


def aim(table: FloatArray, course: IntArray, course_ned: FloatArray, cruise: float, reached: float) -> bool:
    """Set goals of all leaders, which do not move: where each is, or the next of its way points. Whether one that goes
    on is as near to that as `reached`, m.

    table: of `LeaderRows`. course (n,): HOLDS, STAYS, GOES_ON or ARRIVED. course_ned (n, 3): the next way point of
    those that have any left. cruise: speed of all but those that have arrived.
    """
    near = False
    for row in range(course.shape[0]):
        one = _leader_at(table, row)
        one.goal_v[0], one.goal_v[1], one.goal_v[2] = 0.0, 0.0, 0.0
        one.speed = 0.0 if course[row] == ARRIVED else cruise
        if course[row] == HOLDS or course[row] == ARRIVED:
            one.goal[0], one.goal[1], one.goal[2] = one.q[0], one.q[1], one.q[2]
        else:
            one.goal[0], one.goal[1], one.goal[2] = course_ned[row, 0], course_ned[row, 1], course_ned[row, 2]
            n, e, d = one.q[0] - one.goal[0], one.q[1] - one.goal[1], one.q[2] - one.goal[2]
            if course[row] == GOES_ON and math.sqrt(n * n + e * e + d * d) <= reached:
                near = True
    return near


def _field_step(fn: float, fe: float, fd: float, full_step: float, k0: float) -> tuple[float, float, float]:
    """l min(1, |F|/k0) F/|F|; whole with k0 = 0."""
    size = math.sqrt(fn * fn + fe * fe + fd * fd)
    if size == 0.0:
        return 0.0, 0.0, 0.0
    scale = full_step / max(size, k0)
    return scale * fn, scale * fe, scale * fd


def _fed_forward(on: float, oe: float, od: float, distance: float, cap: float, k0: float) -> float:
    """Share of the goal's velocity that is fed forward."""
    within_reach: float = 1.0
    if distance > cap:
        within_reach = max(0.0, 2.0 - distance / cap)
    size = math.sqrt(on * on + oe * oe + od * od)
    free: float = max(0.0, 1.0 - size / (_UNFREE_SHARE * k0))
    return within_reach * free
