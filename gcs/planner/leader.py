"""Virtual leaders: the planned points that the vehicles follow, moved through the field (docs/model.md#planner; paper
eq. 4, its step a [choice]).

    q += l min(1, |F|/k0) F/|F| + feed-forward,   l = speed · period / steps,   steps = ceil(speed · period / κ)
    q += l F/|F| + feed-forward                   with full steps (the paper's prose); the last ends on the goal

Feed-forward of the goal's velocity v_g [choice]: F alone follows a moving goal at a distance |v_g|/speed · cap. So
v_g dt is added: whole within cap_m of the goal, fading to none at twice that; and whole where nothing repels, fading
to none at |F_o| = k0/4, so that near obstacles the field alone decides. The sum is shortened to l, the speed limit.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gcs.kernels import UNCOUNTED, kernel
from gcs.planner.fuzzy_escape import MEMORY_SIZE, escape_force
from gcs.planner.neighbours import FEW, IntArray, everyone, within_range
from gcs.planner.potential_field import CAP, FULL_STEPS, K0, STEP, FieldConstants, attraction_to, repulsion_of_shape
from gcs.scenario.geometry import COLUMNS, DOWN, EAST, NORTH, SIZE_1, FloatArray, points

_UNFREE_SHARE = 0.25  # of k0: the repulsion at which nothing is fed forward any more
_FEW_MOVING = 8_000
"""Up to so many pairs of a leader and what moves, looking at each costs less than choosing."""
_ROUNDING_M = 1e-6
_SURE = 1.0 - 1e-9
HOLDS, STAYS, GOES_ON, ARRIVED = range(4)
"""Of a leader: it has no way points; it stays at its last one; it may come to one to be left behind; it has left its
last one behind."""
_ONE_THREAD = 8192  # numbers of which OpenBLAS takes a sum without its threads

BoolArray = NDArray[np.bool_]


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
    (paper eq. 10), held where they are for the period. drawn (n, m3): whom they draw, everyone without it.
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


_Q, _BEGIN, _V, _GOAL, _GOAL_V = 0, 3, 6, 9, 12  # each of three columns
_SPEED, _RANGE, _LOWEST, _ROUTE = range(15, 19)
_WIDTH = 19


class LeaderRows:
    """n leaders, a row each; frame NED. They are one table, which kernels take in place of its ten parts; each part
    is a view of it. `lead` moves q_ned, v_ned and the memory."""

    def __init__(self, n: int, obstacle_range_m: ArrayLike, memory: FloatArray) -> None:
        """memory: (n, MEMORY_SIZE), `fuzzy_escape.new_memory` at first."""
        self.table = table = np.zeros((n, _WIDTH))
        self.memory = memory
        self.q_ned: FloatArray = table[:, _Q : _Q + 3]
        """(n, 3) m"""
        self.begin_ned: FloatArray = table[:, _BEGIN : _BEGIN + 3]
        """(n, 3) m, `q_ned` at the start of the period"""
        self.v_ned: FloatArray = table[:, _V : _V + 3]
        """(n, 3) m/s, the mean of the last period"""
        self.begin_and_v: FloatArray = table[:, _BEGIN : _V + 3]
        """(n, 6) both"""
        self.goal_ned: FloatArray = table[:, _GOAL : _GOAL + 3]
        """(n, 3) m at the start of the period"""
        self.goal_v_ned: FloatArray = table[:, _GOAL_V : _GOAL_V + 3]
        """(n, 3) m/s"""
        self.speed_m_s: FloatArray = table[:, _SPEED]
        """(n,) limits, at least 0"""
        self.obstacle_range_m: FloatArray = table[:, _RANGE]
        """(n,) how far obstacles repel each; none does at 0"""
        self.lowest_d: FloatArray = table[:, _LOWEST]
        """(n,) m, the greatest down; infinite where there is none"""
        self.route_m: FloatArray = table[:, _ROUTE]
        """(n,) m, the way that is left on a route; NaN where the way is straight"""
        self.obstacle_range_m[:], self.lowest_d[:], self.route_m[:] = obstacle_range_m, math.inf, math.nan


class LeaderLimits(NamedTuple):
    """Limits of speeds, as far as sums of squares tell of whom it is sure that they have none."""

    limited: IntArray
    """(2, n) filled with the rows of all others: in the second row those who are surely not leashed, but near their
    goals on a straight way"""
    leash_m: float
    """inf: none"""
    lookahead_s: float
    """by how much a vehicle is behind its leader anyhow"""
    brake_m_s2: float
    """inf: they need not"""


UNLIMITED = LeaderLimits(np.zeros((2, 0), np.int64), math.inf, 0.0, math.inf)


class Moving(NamedTuple):
    """Spheres that repel k leaders, m of them; held where they are for the period."""

    table: FloatArray
    """obstacle table (m, COLUMNS) of points or spheres"""
    ranges_m: FloatArray
    """(m,) from their surfaces"""
    exempt: BoolArray
    """(k, m) whom each does not repel"""


class Attracting(NamedTuple):
    """Points that draw k leaders beside their goals (paper eq. 10), m of them; held where they are for the period."""

    places: FloatArray
    """(m, 4) where, and their range, m"""
    drawn: BoolArray
    """(k, m) whom each draws"""


def lead(
    leaders: LeaderRows,
    rows: IntArray,
    here_ned: FloatArray,
    limits: LeaderLimits,
    obstacles: FloatArray,
    moving: Moving,
    attracting: Attracting,
    field: FieldConstants,
    period_s: float,
    *,
    escape: bool,
) -> tuple[int, int]:
    """Move the leaders `rows` (k,), whose vehicles are at here_ned (n, 3), by one period, in place; all is as `advance`
    says, and nothing is checked. How many there are in each row of `limits.limited`: unless none, nobody has moved."""
    count, table, speed = len(rows), leaders.table, leaders.speed_m_s
    if count * len(obstacles) <= FEW:
        near_obstacles = everyone(count, len(obstacles))
    else:
        q = leaders.q_ned[rows]
        near_obstacles = within_range(q, speed[rows] * period_s, obstacles, field.repulsion_range_m)
    if count * len(moving.table) <= _FEW_MOVING:
        near_moving = everyone(count, len(moving.table))
    else:
        near_moving = within_range(leaders.q_ned[rows], speed[rows] * period_s, moving.table, moving.ranges_m)
    asked: tuple[int, int] = _lead(
        rows, table, leaders.memory, here_ned, *limits, attracting.places, attracting.drawn, obstacles,
        *near_obstacles, moving.table, moving.ranges_m, moving.exempt, *near_moving,
        field.constants(), period_s, escape,
    )  # fmt: skip
    return asked


def _array(name: str, value: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    array = np.ascontiguousarray(value, dtype=np.float64)
    if array.size == 0 and shape[0] in (-1, 0):
        array = array.reshape(0, *shape[1:])
    if array.shape[1:] != shape[1:] or array.ndim == 0 or shape[0] not in (-1, array.shape[0]):
        raise ValueError(f"{name} has shape {array.shape}; it must be {shape}, -1 standing for any number")
    # A sum of squares is finite where all are, unless it overflows: that and a fault are then distinguished. Of many,
    # BLAS would take the sum with threads that wait for each other for longer than it takes.
    squares = np.vdot(array, array) if array.size <= _ONE_THREAD else math.nan
    if not math.isfinite(squares) and not np.isfinite(array).all():
        row = int(np.argwhere(~np.isfinite(array))[0][0])
        raise ValueError(f"{name} holds a value that is not finite in row {row}; leave that row out or mend its data")
    return array


@kernel()
def _lead(
    rows: IntArray, table: FloatArray, all_memory: FloatArray, here: FloatArray, limited: IntArray, leash: float,
    lookahead: float, brake: float, attractors: FloatArray, draws: BoolArray, obstacles: FloatArray,
    obstacle_rows: IntArray, obstacle_spans: IntArray, moving: FloatArray, ranges: FloatArray, exempt: BoolArray,
    moving_rows: IntArray, moving_spans: IntArray, constants: FloatArray, period: float, escape: bool,
) -> tuple[int, int]:  # fmt: skip
    """Kernel: moves leaders in place, unless one may be limited: how many `limited` has then, else 0, 0. Leader rows[i]
    heeds rows[spans[i, 0]:spans[i, 1]] of obstacles and of moving."""
    asked, stopping = find_limited(rows, table, here, limited, leash, lookahead, brake)
    if asked + stopping > 0:
        return asked, stopping
    near = np.empty(len(moving), dtype=np.int64)
    for i in range(len(rows)):
        one, memory = table[rows[i]], all_memory[rows[i]]
        q, v, goal, goal_velocity = one[_Q:_BEGIN], one[_V:_GOAL], one[_GOAL:_GOAL_V], one[_GOAL_V:_SPEED]
        begin_n, begin_e, begin_d = q[0], q[1], q[2]
        reach = one[_SPEED] * period
        steps = math.ceil(reach / constants[STEP] - 1e-9)
        full_step, dt = (reach / steps, period / steps) if steps else (0.0, 0.0)
        count = 0
        for k in range(moving_spans[i, 0], moving_spans[i, 1] if steps else moving_spans[i, 0]):
            j = moving_rows[k]
            # What is left out stays out of range, and would add nothing.
            n, e, d = q[0] - moving[j, NORTH], q[1] - moving[j, EAST], q[2] - moving[j, DOWN]
            around = reach + ranges[j] + moving[j, SIZE_1] + _ROUNDING_M
            if not exempt[i, j] and n * n + e * e + d * d <= around * around:
                near[count] = j
                count += 1
        for step in range(steps):
            gn = goal[0] + goal_velocity[0] * dt * step
            ge = goal[1] + goal_velocity[1] * dt * step
            gd = goal[2] + goal_velocity[2] * dt * step
            an, ae, ad = attraction_to(gn, ge, gd, math.inf, q[0], q[1], q[2], constants)
            for k in range(attractors.shape[0]):
                if draws[i, k]:
                    hn, he, hd = attractors[k, 0], attractors[k, 1], attractors[k, 2]
                    reach_m = attractors[k, 3]
                    fn, fe, fd = attraction_to(hn, he, hd, reach_m, q[0], q[1], q[2], constants)
                    an += fn
                    ae += fe
                    ad += fd
            on = 0.0
            oe = 0.0
            od = 0.0
            heeded, first = one[_RANGE], obstacle_spans[i, 0]
            for k in range(first, obstacle_spans[i, 1] if heeded > 0.0 else first):
                fn, fe, fd = repulsion_of_shape(obstacles, obstacle_rows[k], heeded, q[0], q[1], q[2], constants)
                on += fn
                oe += fe
                od += fd
            for k in range(count):
                j = near[k]
                fn, fe, fd = repulsion_of_shape(moving, j, ranges[j], q[0], q[1], q[2], constants)
                on += fn
                oe += fe
                od += fd
            distance = math.sqrt((gn - q[0]) ** 2 + (ge - q[1]) ** 2 + (gd - q[2]) ** 2)
            en = 0.0
            ee = 0.0
            ed = 0.0
            if escape:
                en, ee, ed = escape_force(
                    memory, q[0], q[1], q[2], an, ae, ad, on, oe, od, distance, full_step, constants[STEP]
                )
            fn, fe, fd = an + on + en, ae + oe + ee, ad + od + ed
            if constants[FULL_STEPS] != 0.0:
                sn, se, sd = _field_step(fn, fe, fd, min(full_step, distance), 0.0)
            else:
                sn, se, sd = _field_step(fn, fe, fd, full_step, constants[K0])
            share = _fed_forward(on, oe, od, distance, constants)
            sn += share * goal_velocity[0] * dt
            se += share * goal_velocity[1] * dt
            sd += share * goal_velocity[2] * dt
            length = math.sqrt(sn * sn + se * se + sd * sd)
            shorten = full_step / length if length > full_step else 1.0
            q[0] += shorten * sn
            q[1] += shorten * se
            q[2] += shorten * sd
        q[2] = min(q[2], one[_LOWEST])
        v[0], v[1], v[2] = (q[0] - begin_n) / period, (q[1] - begin_e) / period, (q[2] - begin_d) / period
    return 0, 0


@kernel()
def find_limited(
    rows: IntArray, table: FloatArray, here: FloatArray, limited: IntArray, leash: float, lookahead: float,
    brake: float,
) -> tuple[int, int]:  # fmt: skip
    """Kernel: fills `limited` as `LeaderLimits` says; how many in each of its rows."""
    many = near = 0
    if leash == math.inf and brake == math.inf:
        return many, near
    for row in rows:
        one = table[row]
        n, e, d = one[_Q] - here[row, 0], one[_Q + 1] - here[row, 1], one[_Q + 2] - here[row, 2]
        half = 0.5 * (leash + lookahead * one[_SPEED])
        free = n * n + e * e + d * d <= _SURE * half * half
        stops = False
        if free and brake < math.inf:
            way, straight = one[_ROUTE], math.isnan(one[_ROUTE])
            if straight:
                n, e, d = one[_Q] - one[_GOAL], one[_Q + 1] - one[_GOAL + 1], one[_Q + 2] - one[_GOAL + 2]
                way = math.sqrt(n * n + e * e + d * d)
            free = way < math.inf and one[_SPEED] * one[_SPEED] <= _SURE * 2.0 * brake * way
            stops = straight and not free
        if stops:
            limited[1, near] = row
            near += 1
        elif not free:
            limited[0, many] = row
            many += 1
    return many, near


@kernel(**UNCOUNTED)
def aim(table: FloatArray, course: IntArray, course_ned: FloatArray, cruise: float, square: float) -> bool:
    """Kernel: goals of all leaders, which do not move: where each is, or the next of its way points. Whether one that
    goes on is as near to that as this distance's square.

    table: of `LeaderRows`. course (n,): HOLDS, STAYS, GOES_ON or ARRIVED. course_ned (n, 3): the next way point of who
    has any left. cruise: everyone's speed, but of who has arrived.
    """
    near = False
    for row in range(len(course)):
        one, to = table[row], course_ned[row]
        one[_GOAL_V], one[_GOAL_V + 1], one[_GOAL_V + 2] = 0.0, 0.0, 0.0
        one[_SPEED] = 0.0 if course[row] == ARRIVED else cruise
        if course[row] == HOLDS or course[row] == ARRIVED:
            one[_GOAL], one[_GOAL + 1], one[_GOAL + 2] = one[_Q], one[_Q + 1], one[_Q + 2]
        else:
            one[_GOAL], one[_GOAL + 1], one[_GOAL + 2] = to[0], to[1], to[2]
            n, e, d = one[_Q] - to[0], one[_Q + 1] - to[1], one[_Q + 2] - to[2]
            near |= course[row] == GOES_ON and n * n + e * e + d * d <= square
    return near


@kernel()
def _field_step(fn: float, fe: float, fd: float, full_step: float, k0: float) -> tuple[float, float, float]:
    """Kernel: l min(1, |F|/k0) F/|F|; whole with k0 = 0."""
    size = math.sqrt(fn * fn + fe * fe + fd * fd)
    if size == 0.0:
        return 0.0, 0.0, 0.0
    scale = full_step / max(size, k0)
    return scale * fn, scale * fe, scale * fd


@kernel()
def _fed_forward(on: float, oe: float, od: float, distance: float, constants: FloatArray) -> float:
    """Kernel: the share of the goal's velocity that is fed forward."""
    within_reach: float = 1.0
    if distance > constants[CAP]:
        within_reach = max(0.0, 2.0 - distance / constants[CAP])
    size = math.sqrt(on * on + oe * oe + od * od)
    free: float = max(0.0, 1.0 - size / (_UNFREE_SHARE * constants[K0]))
    return within_reach * free
