"""Fuzzy escape from local minima of the potential field (docs/model/planner.md#fuzzy-escape; form and rules [choice],
domains and terms [seed]).

Inputs: ΔΦ in [-π, π], the angle from attraction to repulsion, signed by the side s to which the repulsion leans;
ΔF = (|F_g| - |F_o|)/(|F_g| + |F_o|) in [-1, 1]. Output: f in [-1, 1]; the escape force has the size 1.3 |F_g| |f| and
is perpendicular to the line to the target. Mamdani inference (min, max), centroid.

The memory of one leader is a row of MEMORY_SIZE floats, the struct Memory of fuzzy_escape.pxd: where it was in its last
ten steps and how long these could have been, whether the escape is on, and how the present one goes.
"""

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.gcs.planner.fuzzy_escape import TERMS, WINDOW
from cython.cimports.libc import math

from skytender import layout
from skytender.geometry import FloatArray

GAIN = 1.3  # size of the force, in |F_g|, at f = 1
STUCK_SHARE = 0.3  # stuck: the window moved less than this share of its steps' full length (3 κ of 10 κ)
NEARER_M = 0.3  # off when nearer to the target than at engagement by this
CLEAR_STEPS = 20  # off after so many steps without repulsion
TURN_STEPS = 25  # stuck for so long on one side: try the next, a quarter turn on


# Terms NB NM S PM PB are 0 to 4. Row: term of ΔΦ; column: term of ΔF [choice]: Table I's entries are not in the text.
_RULES = [
    [0, 0, 0, 1, 2],
    [1, 1, 1, 2, 2],
    [2, 2, 2, 2, 2],
    [3, 3, 3, 2, 2],
    [4, 4, 4, 3, 2],
]  # fmt: skip
_HALF_WIDTH = 0.5  # of the triangles of ΔF and f, whose peaks are at -1, -½, 0, ½, 1; those of f at the ends reach ±1.5


def _memory_of(row: Any) -> Any:
    return cython.cast("Memory *", cython.address(row[0]))[0]


_memory = _memory_of(layout.COUNTED)
ENGAGED: int = layout.places(_memory)["engaged"]
"""Place in a leader's memory that is 1 while its escape is on."""
MEMORY_SIZE = layout.size(_memory)


def new_memory(n: int) -> FloatArray:
    """Memory (n, MEMORY_SIZE) of `n` leaders that have not moved yet."""
    return np.zeros((n, MEMORY_SIZE))


def escape_strength(delta_phi: float, delta_f: float) -> float:
    """Fuzzy output f in [-1, 1] for ΔΦ in rad and ΔF (docs/model/planner.md#fuzzy-escape, Table I); inputs beyond the
    domains are clamped."""
    return _strength(delta_phi, delta_f)


def _membership(x: float, term: int, half_width: float) -> float:
    distance: float = math.fabs(x - (term - 2) * half_width)
    return max(0.0, 1.0 - distance / half_width)


def _strength(delta_phi: float, delta_f: float) -> float:
    """Clip each output term at the strongest of its rules; centroid of the union, exact."""
    phi = min(max(delta_phi, -math.M_PI), math.M_PI)
    df = min(max(delta_f, -1.0), 1.0)
    height = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]  # of each output term, with an empty one beyond either end
    for i in range(TERMS):
        of_phi = _membership(phi, i, math.M_PI / 2)
        for j in range(TERMS):
            term = _RULES[i][j] + 1
            height[term] = max(height[term], min(of_phi, _membership(df, j, _HALF_WIDTH)))
    area = 0.0
    moment = 0.0
    for left in range(TERMS + 1):
        # Between two neighbouring peaks only their own triangles count: t runs from the left one's to the right one's.
        h_left = height[left]
        h_right = height[left + 1]
        knots = [0.0, h_left, 1.0 - h_left, 0.5, h_right, 1.0 - h_right, 1.0]
        for k in range(1, 7):
            knot, at = knots[k], k
            while at > 0 and knots[at - 1] > knot:
                knots[at] = knots[at - 1]
                at -= 1
            knots[at] = knot
        for k in range(6):
            t0 = knots[k]
            t1 = knots[k + 1]
            m0 = max(min(h_left, 1.0 - t0), min(h_right, t0))
            m1 = max(min(h_left, 1.0 - t1), min(h_right, t1))
            x0 = (left - 3 + t0) * _HALF_WIDTH
            x1 = (left - 3 + t1) * _HALF_WIDTH
            area += (x1 - x0) * (m0 + m1) / 2.0
            moment += (x1 - x0) * (m0 * (2.0 * x0 + x1) + m1 * (x0 + 2.0 * x1)) / 6.0
    return min(max(moment / area, -1.0), 1.0)  # at a peak rounding would step over the end


def escape_force(
    memory: Any, qn: float, qe: float, qd: float, gn: float, ge: float, gd: float, on: float, oe: float, od: float,
    goal_distance: float, full_step: float, arrival: float,
) -> tuple[float, float, float]:  # fmt: skip
    """Escape force (north, east, down), in the units of the attraction; changes a leader's memory in place
    (docs/model/planner.md#fuzzy-escape; paper eqs. 8, 9 and Table I) [choice], domains and terms [seed].

    (gn, ge, gd) is F_g and (on, oe, od) F_o at (qn, qe, qd), m NED; called once for every step of the planned point,
    before the step. `full_step` in m is the length of a full step: a slow leader makes shorter ones and is not stuck
    for that. `arrival` in m is the distance at which the goal is reached. The force is zero while the escape is off:

    - on when ten steps moved less than 0.3 of their full length and the goal is not reached;
    - off when 0.3 m nearer to the goal than at engagement, when the goal is reached, or after 20 steps in a row
      without repulsion;
    - side s = F̂_g × up (north when the line is vertical), chosen by the repulsion's lean, a tie is +s, kept while on;
    - after 25 stuck steps in a row the force turns by 90° about the line to the target, upwards first since the
      ground is below [choice].
    """
    stuck = _record(memory, qn, qe, qd, full_step) and goal_distance > arrival
    size_g = math.sqrt(gn * gn + ge * ge + gd * gd)
    size_o = math.sqrt(on * on + oe * oe + od * od)

    if memory.engaged == 0.0:
        if not stuck:
            return 0.0, 0.0, 0.0
        memory.engaged = 1.0
        memory.engaged_at = goal_distance
        memory.side = 0.0
        memory.stuck = 0.0
        memory.quarter = 0.0
        memory.clear = 0.0
    memory.clear = memory.clear + 1.0 if size_o == 0.0 else 0.0
    nearer = goal_distance < memory.engaged_at - NEARER_M
    if nearer or goal_distance <= arrival or memory.clear >= CLEAR_STEPS:
        memory.engaged = 0.0
        return 0.0, 0.0, 0.0
    memory.stuck = memory.stuck + 1.0 if stuck else 0.0
    if memory.stuck > TURN_STEPS:
        memory.stuck = 0.0
        memory.quarter = (memory.quarter + 1.0) % 4.0
    if size_g == 0.0 or size_o == 0.0:
        return 0.0, 0.0, 0.0

    # s = F̂_g × up; up is (0, 0, -1), so the product is (-ge, gn, 0).
    level = math.sqrt(gn * gn + ge * ge)
    if level > 1e-9 * size_g:
        sn = -ge / level
        se = gn / level
    else:
        sn = 1.0
        se = 0.0
    if memory.side == 0.0:
        memory.side = 1.0 if on * sn + oe * se >= 0.0 else -1.0
    cn = ge * od - gd * oe
    ce = gd * on - gn * od
    cd = gn * oe - ge * on
    angle = elementary.atan2(math.sqrt(cn * cn + ce * ce + cd * cd), gn * on + ge * oe + gd * od)
    delta_f = (size_g - size_o) / (size_g + size_o)
    f = _strength(memory.side * angle, delta_f)

    quarter = memory.quarter
    if quarter % 2.0 == 0.0:
        size = GAIN * size_g * f * (1.0 - quarter)
        return size * sn, size * se, 0.0
    # The perpendicular to both, s × F̂_g: up for a level line.
    size = GAIN * math.fabs(f) * (2.0 - quarter)
    return size * se * gd, -size * sn * gd, size * (sn * ge - se * gn)


def _record(memory: Any, qn: float, qe: float, qd: float, full_step: float) -> bool:
    """Enter this step into the history; True when the ten before it got nowhere."""
    at = cython.cast(cython.int, memory.oldest)
    step = cython.address(memory.steps[at])
    stuck = False
    if memory.count >= WINDOW:
        dn = qn - step.north
        de = qe - step.east
        dd = qd - step.down
        could = 0.0
        for k in range(WINDOW):
            could += memory.steps[k].full
        stuck = math.sqrt(dn * dn + de * de + dd * dd) < STUCK_SHARE * could
    else:
        memory.count += 1.0
    step.north, step.east, step.down, step.full = qn, qe, qd, full_step
    memory.oldest = (at + 1) % WINDOW
    return stuck
