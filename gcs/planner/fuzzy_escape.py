"""Fuzzy escape from local minima of the potential field (docs/model.md#fuzzy-escape; form and rules [choice], domains
and terms [seed]).

Inputs: ΔΦ in [-π, π], the angle from attraction to repulsion, signed by the side s to which the repulsion leans;
ΔF = (|F_g| - |F_o|)/(|F_g| + |F_o|) in [-1, 1]. Output: f in [-1, 1]; the escape force has the size 1.3 |F_g| |f| and
is perpendicular to the line to the target. Mamdani inference (min, max), centroid.

The memory of one leader is a flat row of MEMORY_SIZE floats: where it was in its last ten steps and how long these
could have been, whether the escape is on, and how the present one goes.
"""

import math

import numpy as np

from gcs.kernels import kernel
from gcs.scenario.geometry import FloatArray

GAIN = 1.3  # size of the force, in |F_g|, at f = 1
WINDOW = 10  # steps over which progress is judged
STUCK_SHARE = 0.3  # stuck: the window moved less than this share of its steps' full length (3 κ of 10 κ)
NEARER_M = 0.3  # off when nearer to the target than at engagement by this
CLEAR_STEPS = 20  # off after so many steps without repulsion
TURN_STEPS = 25  # stuck for so long on one side: try the next, a quarter turn on

HEAD, COUNT, ENGAGED, SIDE, STUCK, QUARTER, ENGAGED_AT, CLEAR = range(4 * WINDOW, 4 * WINDOW + 8)
MEMORY_SIZE = 4 * WINDOW + 8

# Terms NB NM S PM PB are 0..4. Row: term of ΔΦ; column: term of ΔF [choice]: Table I's entries are not in the text.
RULES = np.array(
    [
        [0, 0, 0, 1, 2],
        [1, 1, 1, 2, 2],
        [2, 2, 2, 2, 2],
        [3, 3, 3, 2, 2],
        [4, 4, 4, 3, 2],
    ]
)
TERMS = 5
_HALF_WIDTH = 0.5  # of the triangles of ΔF and f, whose peaks are at -1, -½, 0, ½, 1; those of f at the ends reach ±1.5


def new_memory(n: int) -> FloatArray:
    """Memory (n, MEMORY_SIZE) of `n` leaders that have not moved yet."""
    return np.zeros((n, MEMORY_SIZE))


def escape_strength(delta_phi: float, delta_f: float) -> float:
    """Fuzzy output f in [-1, 1] for ΔΦ in rad and ΔF (docs/model.md#fuzzy-escape, Table I); inputs beyond the domains
    are clamped."""
    return float(_strength(float(delta_phi), float(delta_f)))


@kernel()
def _membership(x: float, term: int, half_width: float) -> float:
    return max(0.0, 1.0 - abs(x - (term - 2) * half_width) / half_width)


@kernel()
def _strength(delta_phi: float, delta_f: float) -> float:
    """Kernel: clip each output term at the strongest of its rules; centroid of the union, exact."""
    phi = min(max(delta_phi, -math.pi), math.pi)
    df = min(max(delta_f, -1.0), 1.0)
    height = np.zeros(TERMS + 2)  # of each output term, with an empty one beyond either end
    for i in range(TERMS):
        of_phi = _membership(phi, i, math.pi / 2)
        for j in range(TERMS):
            term = RULES[i, j] + 1
            height[term] = max(height[term], min(of_phi, _membership(df, j, _HALF_WIDTH)))
    area = 0.0
    moment = 0.0
    knots = np.empty(7)
    for left in range(TERMS + 1):
        # Between two neighbouring peaks only their own triangles count: t runs from the left one's to the right one's.
        h_left = height[left]
        h_right = height[left + 1]
        knots[:] = (0.0, h_left, 1.0 - h_left, 0.5, h_right, 1.0 - h_right, 1.0)
        knots.sort()
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


@kernel()
def escape_force(
    memory: FloatArray,
    qn: float,
    qe: float,
    qd: float,
    gn: float,
    ge: float,
    gd: float,
    on: float,
    oe: float,
    od: float,
    goal_distance: float,
    full_step: float,
    arrival: float,
) -> tuple[float, float, float]:
    """Kernel: the escape force (north, east, down), in the units of the attraction; changes `memory` (MEMORY_SIZE,) in
    place (docs/model.md#fuzzy-escape; paper eqs. 8, 9 and Table I) [choice], domains and terms [seed].

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

    if memory[ENGAGED] == 0.0:
        if not stuck:
            return 0.0, 0.0, 0.0
        memory[ENGAGED] = 1.0
        memory[ENGAGED_AT] = goal_distance
        memory[SIDE] = 0.0
        memory[STUCK] = 0.0
        memory[QUARTER] = 0.0
        memory[CLEAR] = 0.0
    memory[CLEAR] = memory[CLEAR] + 1.0 if size_o == 0.0 else 0.0
    nearer = goal_distance < memory[ENGAGED_AT] - NEARER_M
    if nearer or goal_distance <= arrival or memory[CLEAR] >= CLEAR_STEPS:
        memory[ENGAGED] = 0.0
        return 0.0, 0.0, 0.0
    memory[STUCK] = memory[STUCK] + 1.0 if stuck else 0.0
    if memory[STUCK] > TURN_STEPS:
        memory[STUCK] = 0.0
        memory[QUARTER] = (memory[QUARTER] + 1.0) % 4.0
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
    if memory[SIDE] == 0.0:
        memory[SIDE] = 1.0 if on * sn + oe * se >= 0.0 else -1.0
    cn = ge * od - gd * oe
    ce = gd * on - gn * od
    cd = gn * oe - ge * on
    angle = math.atan2(math.sqrt(cn * cn + ce * ce + cd * cd), gn * on + ge * oe + gd * od)
    delta_f = (size_g - size_o) / (size_g + size_o)
    f = _strength(memory[SIDE] * angle, delta_f)

    quarter = memory[QUARTER]
    if quarter % 2.0 == 0.0:
        size = GAIN * size_g * f * (1.0 - quarter)
        return size * sn, size * se, 0.0
    # The perpendicular to both, s × F̂_g: up for a level line.
    size = GAIN * abs(f) * (2.0 - quarter)
    return size * se * gd, -size * sn * gd, size * (sn * ge - se * gn)


@kernel()
def _record(memory: FloatArray, qn: float, qe: float, qd: float, full_step: float) -> bool:
    """Kernel: enter this step into the history; True when the ten before it got nowhere."""
    at = int(memory[HEAD])
    stuck = False
    if memory[COUNT] >= WINDOW:
        dn = qn - memory[at]
        de = qe - memory[at + 1]
        dd = qd - memory[at + 2]
        could = 0.0
        for k in range(WINDOW):
            could += memory[4 * k + 3]
        stuck = math.sqrt(dn * dn + de * de + dd * dd) < STUCK_SHARE * could
    else:
        memory[COUNT] += 1.0
    memory[at] = qn
    memory[at + 1] = qe
    memory[at + 2] = qd
    memory[at + 3] = full_step
    memory[HEAD] = (at + 4) % (4 * WINDOW)
    return stuck
