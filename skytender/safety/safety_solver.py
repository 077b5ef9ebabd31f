"""Projection of all wanted accelerations of the safety filter together, and the check that makes the guarantee.

Everything runs in the order of the constraints and a fixed number of times, so equal inputs give equal bits.
safety_filter.py has the equations; constraints.pxd the rows that are written.
"""

from __future__ import annotations

from typing import Any

import cython
import cython.cimports.skytender.elementary as elementary
import numpy as np
from cython.cimports.libc import math
from cython.cimports.libc.stdlib import calloc, free
from cython.cimports.skytender.geometry import shape_at
from cython.cimports.skytender.safety.braking_clearance import TINY, braking
from cython.cimports.skytender.safety.constraints import (
    Box,
    Constraint,
    Constraints,
    Leader,
    Moves,
    Near,
    Other,
    Problem,
    Surroundings,
)
from cython.cimports.skytender.safety.leaving import choose_directions
from cython.cimports.skytender.safety.near_constraints import find_constraints
from cython.cimports.skytender.safety.safety_constraints import (
    GOLDEN,
    PAIR,
    PLANE,
    REACH,
    clearance_of,
    descent_of,
    into_ball,
    into_limits,
    part_of_turn,
    write_line,
)

from skytender.safety.braking_clearance import FloatArray, IntArray

TOLERANCE_M = 1e-9  # rounding that the check forgives, so that a formation at exactly D is left in peace
_ACTED_M_S2 = 1e-9
_BLENDS = [1.0, 0.5, 0.2, 0.0]  # shares of the projected acceleration; the rest is braking
_LAST_BLEND = 3
_ACTIVE_M = 0.25
_REPAIRS = 4
_FEWEST_ROUNDS = 2
LEAVES_M = 0.3  # so far below its distance from what may turn a vehicle leaves with all that it has
_SOFT_M = 0.1  # above the distance aimed at: there the turn of a wanted velocity begins


def _copy(row: Any, to: Any) -> None:
    to[0], to[1], to[2] = row[0], row[1], row[2]


def _moves(s: Any, u: Any) -> Any:
    return Moves(p=s.p, v=s.v, u=u, brake=s.brake, v_max=s.v_max)


def _blend(s: Any, i: int, level: int, wanted: Any, u: Any) -> None:
    for x in range(3 * i, 3 * i + 3):
        u[x] = s.u_b[x] + _BLENDS[level] * (wanted[x] - s.u_b[x])


def _into_limits(s: Any, i: int, u: Any) -> None:
    x = 3 * i
    into_limits(u + x, s.v + x, s.u_b + x, s.a_max[i], s.leaders[i].v_top, s.rules.dt)


def _turned(wanted: Any, sysid: int, share: float, turn: float, climb: float, out: Any) -> None:
    """A wanted velocity turned to the right by turn share and raised by up to climb share, differently for each id."""
    _copy(wanted, out)
    if share > 0.0:
        sin, cos = elementary.sin_cos(turn * share)
        part = part_of_turn(sysid * GOLDEN)
        # A wanted velocity straight up or down has no right side, so one is chosen by id.
        side_sin, side_cos = elementary.sin_cos(2.0 * math.M_PI * part)
        right_n = math.fabs(wanted[2]) * side_cos - wanted[1]
        right_e = math.fabs(wanted[2]) * side_sin + wanted[0]
        out[0] = cos * wanted[0] + sin * right_n
        out[1] = cos * wanted[1] + sin * right_e
        speed = math.sqrt(wanted[0] ** 2 + wanted[1] ** 2)
        out[2] = wanted[2] + descent_of(sysid) * elementary.tan(climb * share) * speed


def _project(s: Any, active: Any, count: int, u: Any) -> None:
    """Nearest u within all lines (Hildreth) and both balls (Dykstra), by sweeps; writes u and the lines' weights."""
    dt = s.rules.dt
    before = [0.0, 0.0, 0.0]
    for i in range(s.n):
        for x in range(6):
            s.leaders[i].corrected[x] = 0.0
    for _ in range(s.rules.sweeps):
        for k in range(count):
            c = cython.address(s.constraints[active[k]])
            ui, uj = u + 3 * c.i, u + 3 * c.j
            short = c.r - c.a[0] * ui[0] - c.a[1] * ui[1] - c.a[2] * ui[2]
            if c.kind == PAIR:
                short -= c.b[0] * uj[0] + c.b[1] * uj[1] + c.b[2] * uj[2]
            more = max(short / c.square, -c.weight)
            if more != 0.0:
                c.weight += more
                for x in range(3):
                    ui[x] += more * c.a[x]
                if c.kind == PAIR:
                    for x in range(3):
                        uj[x] += more * c.b[x]
        for i in range(s.n):
            leader = cython.address(s.leaders[i])
            if leader.live:
                v, ui = s.v + 3 * i, u + 3 * i
                for ball in range(2):
                    for x in range(3):
                        ui[x] += leader.corrected[3 * ball + x]
                        before[x] = ui[x]
                    if ball == 0:
                        into_ball(ui, -v[0] / dt, -v[1] / dt, -v[2] / dt, leader.v_top / dt)
                    else:
                        into_ball(ui, 0.0, 0.0, 0.0, s.a_max[i])
                    for x in range(3):
                        leader.corrected[3 * ball + x] = before[x] - ui[x]


def _find_live(s: Any, everybody: bool) -> None:
    """Vehicles that a near constraint concerns; after the first rounds only those of groups where one is short."""
    leaders = s.leaders
    for i in range(s.n):
        leaders[i].group, leaders[i].concerned = i, False
    for k in range(s.count):
        c = cython.address(s.constraints[k])
        if c.near and c.kind == PAIR:
            a, b = c.i, c.j
            while leaders[a].group != a:
                a = leaders[a].group
            while leaders[b].group != b:
                b = leaders[b].group
            low = min(a, b)
            leaders[max(a, b)].group = low
            leaders[c.i].group = leaders[c.j].group = low
    for i in range(s.n):
        leaders[i].group = leaders[leaders[i].group].group  # roots are lower, so theirs are found already
    for k in range(s.count):
        c = cython.address(s.constraints[k])
        if c.near and (everybody or c.short):
            leaders[leaders[c.i].group].concerned = True
    for i in range(s.n):
        leaders[i].live = leaders[leaders[i].group].concerned


def _check(s: Any, wanted: Any, u: Any, level: Any) -> None:
    """Take vehicles towards braking until every constraint keeps its least clearance; writes u, level and causes
    (docstring of safety_filter.py).

    All of a pass are judged by the same accelerations, so their order does not matter. Every pass but the last one
    lowers a vehicle's share, and shares end at 0, full braking, which needs no proof: so it ends.
    """
    moves, leaders = _moves(s, u), s.leaders
    for i in range(s.n):
        level[i], leaders[i].moved = 0, True
    while True:
        found = False
        for i in range(s.n):
            leaders[i].worse = False
        for k in range(s.count):
            c = cython.address(s.constraints[k])
            pair = c.kind == PAIR
            if not (leaders[c.i].moved or (pair and leaders[c.j].moved)):
                continue
            if level[c.i] == _LAST_BLEND and not (pair and level[c.j] < _LAST_BLEND):
                continue
            first, after, _, _, _, _ = clearance_of(c, c.least, cython.address(moves), cython.address(s.around))
            if min(first, after) < c.least - TOLERANCE_M:
                found = True
                leaders[c.i].worse, leaders[c.i].cause = True, k
                if pair:
                    leaders[c.j].worse, leaders[c.j].cause = True, k
        if not found:
            return
        for i in range(s.n):
            leaders[i].moved = leaders[i].worse and level[i] < _LAST_BLEND
            if leaders[i].moved:
                level[i] += 1
                _blend(s, i, level[i], wanted, u)


def _restore(s: Any, wanted: Any, u: Any, level: Any) -> None:
    """Give back what the check took too much of, one vehicle after the other; writes u and level.

    The check takes from both of a pair, and a vehicle that stands would stand again in the next period for the same
    reason. All others' accelerations are held meanwhile, so every constraint still holds after each of these steps.
    What still fails moves the vehicle's own acceleration away, a few times.
    """
    before = [0.0, 0.0, 0.0]
    for i in range(s.n):
        if level[i] == 0:
            continue
        _copy(u + 3 * i, before)
        kept = False
        for lower in range(level[i]):
            _blend(s, i, lower, wanted, u)
            for _ in range(_REPAIRS):
                kept = _repair(s, i, u)
                if kept:
                    break
            if kept:
                level[i] = lower
                break
        if not kept:
            _copy(before, u + 3 * i)


def _repair(s: Any, i: int, u: Any) -> bool:
    """Move a vehicle's acceleration away from what fails, one constraint after the other; whether none did."""
    moves, ui = _moves(s, u), u + 3 * i
    line = cython.declare(Constraint)
    kept = True
    for k in range(s.count):
        c = cython.address(s.constraints[k])
        mine = c.i == i
        if not mine and not (c.kind == PAIR and c.j == i):
            continue
        first, after, when, nn, ne, nd = clearance_of(c, c.target, cython.address(moves), cython.address(s.around))
        if min(first, after) < c.least - TOLERANCE_M:
            kept = False
            line = c[0]
            if write_line(cython.address(line), after, when, nn, ne, nd, cython.address(moves), s.rules.dt, s.ids):
                own = cython.address(line.a[0]) if mine else cython.address(line.b[0])
                square = own[0] ** 2 + own[1] ** 2 + own[2] ** 2
                if square > TINY * TINY:
                    more = (c.target - after) / square
                    for x in range(3):
                        ui[x] += more * own[x]
            _into_limits(s, i, u)
    return kept


def _set_aims(s: Any, u: Any, full: Any, still: Any, aim: Any) -> None:
    """Write each constraint's least and target, and the accelerations aimed at.

    u: (n, 3) the wanted accelerations within limits; full: (n, 3), written; still: (n, 3) zeros; aim: (n, 3), written.
    """
    rules, around = s.rules, cython.address(s.around)
    braked, chosen = _moves(s, s.u_b), _moves(s, u)
    flown = Moves(p=s.p, v=full, u=still, brake=s.brake, v_max=s.v_max)
    turn = cython.declare(cython.double[3])
    for i in range(s.n):  # the wanted velocity, no faster than allowed
        _copy(s.wanted + 3 * i, full + 3 * i)
        into_ball(full + 3 * i, 0.0, 0.0, 0.0, s.v_max[i])
    choose_directions(s)
    for k in range(s.count):
        c = cython.address(s.constraints[k])
        d = c.required
        first, after, _, _, _, _ = clearance_of(c, d + rules.buffer, cython.address(braked), around)
        # Braking keeps no distance to what turns: it gives way to all that braking keeps.
        c.least = min(d, first, after) if c.kind != REACH else -math.INFINITY
        recover = rules.recover + (around.others[c.j].agile if c.kind == REACH else 0.0)
        c.target = min(max(after, d), d + rules.buffer) if after >= d else min(d, after + recover * rules.dt)
        if c.kind == REACH and d - after > LEAVES_M * s.leaders[c.i].leaves:
            s.leaders[c.i].leaves, s.leaders[c.i].cause = min((d - after) / LEAVES_M, 1.0), k
            _copy(c.leave, s.leaders[c.i].leave)
        if c.kind == PLANE:
            continue
        enough = c.target + _SOFT_M
        _, after, _, _, _, _ = clearance_of(c, enough, cython.address(chosen), around)
        if after < enough:
            # How far the wanted velocity cannot be had is seen where it is flown already: one that stands has turned
            # as much.
            gate = min((enough - after) / _SOFT_M, 1.0)
            _, after, _, _, _, _ = clearance_of(c, c.target, cython.address(flown), around)
            blocked = gate * min((c.target - after) / max(d, 0.1), 1.0)
            if blocked > s.leaders[c.i].share:
                s.leaders[c.i].share, s.leaders[c.i].cause = blocked, k
            if c.kind == PAIR and blocked > s.leaders[c.j].share:
                s.leaders[c.j].share, s.leaders[c.j].cause = blocked, k
    for i in range(s.n):
        _turned(full + 3 * i, s.ids[i], s.leaders[i].share, rules.turn, rules.climb, aim + 3 * i)
        for x in range(3 * i, 3 * i + 3):
            aim[x] = (aim[x] - s.v[x]) / rules.dt
        into_ball(aim + 3 * i, 0.0, 0.0, 0.0, s.a_max[i])
        leader = cython.address(s.leaders[i])
        if leader.leaves > 0.0:
            for x in range(3):
                turn[x] = (s.v_max[i] * leader.leave[x] - s.v[3 * i + x]) / rules.dt
            into_ball(turn, 0.0, 0.0, 0.0, s.a_max[i])
            for x in range(3):
                aim[3 * i + x] += leader.leaves * (turn[x] - aim[3 * i + x])


def _project_in_rounds(s: Any, aim: Any, active: Any, u: Any) -> None:
    """Nearest accelerations to `aim` that satisfy all constraints, made linear at the last result in each round."""
    moves, leaders = _moves(s, u), s.leaders
    for i in range(s.n):
        leaders[i].live = True
    for number in range(s.rules.rounds):
        for k in range(s.count):
            c = cython.address(s.constraints[k])
            if not (leaders[c.i].live or (c.kind == PAIR and leaders[c.j].live)):
                continue  # nothing has changed there
            # What is a little farther takes part too: it may come in the way of one that another constraint turns.
            enough = c.target + _ACTIVE_M
            first, after, when, nn, ne, nd = clearance_of(c, enough, cython.address(moves), cython.address(s.around))
            c.short = min(first, after) < c.least - TOLERANCE_M
            c.near = after < enough and write_line(c, after, when, nn, ne, nd, cython.address(moves), s.rules.dt, s.ids)
            if not c.near:
                c.weight = 0.0
        _find_live(s, number < _FEWEST_ROUNDS)
        count = 0
        for k in range(s.count):
            if s.constraints[k].near and leaders[s.constraints[k].i].live:
                active[count] = k
                count += 1
        if count == 0:
            break
        for i in range(s.n):
            if leaders[i].live:
                _copy(aim + 3 * i, u + 3 * i)
        for k in range(count):  # the weights of the round before are nearly right, so the sweeps begin with them
            c = cython.address(s.constraints[active[k]])
            for x in range(3):
                u[3 * c.i + x] += c.weight * c.a[x]
                if c.kind == PAIR:
                    u[3 * c.j + x] += c.weight * c.b[x]
        _project(s, active, count, u)
        for i in range(s.n):
            if leaders[i].live:
                _into_limits(s, i, u)


def _bind(s: Any, plain: Any, u: Any, changed: Any, kind: Any, binding: Any) -> None:
    """Write how far each acceleration is from the plain one, and what bound it; hardly any change is taken back."""
    for i in range(s.n):
        kind[i], binding[i] = 0, -1
    for k in range(s.count):
        c = cython.address(s.constraints[k])
        leader = cython.address(s.leaders[c.i])
        size = c.weight * math.sqrt(c.a[0] ** 2 + c.a[1] ** 2 + c.a[2] ** 2)
        if size > leader.pull:
            leader.pull, kind[c.i], binding[c.i] = size, c.kind, c.j
        if c.kind == PAIR:
            leader = cython.address(s.leaders[c.j])
            size = c.weight * math.sqrt(c.b[0] ** 2 + c.b[1] ** 2 + c.b[2] ** 2)
            if size > leader.pull:
                leader.pull, kind[c.j], binding[c.j] = size, c.kind, c.i
    for i in range(s.n):
        if kind[i] == 0 and s.leaders[i].cause >= 0:  # turned or braked by what the projection did not need to heed
            c = cython.address(s.constraints[s.leaders[i].cause])
            kind[i], binding[i] = c.kind, c.i if c.j == i and c.kind == PAIR else c.j
        square = 0.0
        for x in range(3 * i, 3 * i + 3):
            square += (u[x] - plain[x]) ** 2
        changed[i] = math.sqrt(square)
        if changed[i] <= _ACTED_M_S2:
            _copy(plain + 3 * i, u + 3 * i)
            changed[i], kind[i], binding[i] = 0.0, 0, -1


def _solve(s: Any, rows: Any, active: Any, u: Any, changed: Any, kind: Any, binding: Any, level: Any) -> None:
    """rows: (6 n, 3) zeros and active: (count,), written."""
    n, dt = s.n, s.rules.dt
    u_b, plain, aim, full = rows, rows + 3 * n, rows + 6 * n, rows + 9 * n
    still, projected = rows + 12 * n, rows + 15 * n
    s.u_b = u_b
    for i in range(n):
        v, at = s.v + 3 * i, u_b + 3 * i
        at[0], at[1], at[2] = braking(v[0], v[1], v[2], s.brake[i], dt)
        speed = math.sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2)
        s.leaders[i].v_top, s.leaders[i].cause = max(s.v_max[i], speed - s.brake[i] * dt), -1
        for x in range(3 * i, 3 * i + 3):
            plain[x] = (s.wanted[x] - s.v[x]) / dt
        _into_limits(s, i, plain)
        _copy(plain + 3 * i, u + 3 * i)
    _set_aims(s, u, full, still, aim)
    for i in range(n):
        if s.leaders[i].share > 0.0 or s.leaders[i].leaves > 0.0:
            _copy(aim + 3 * i, u + 3 * i)
        _into_limits(s, i, u)
    _project_in_rounds(s, aim, active, u)
    for i in range(n):
        s.leaders[i].worse = s.leaders[i].share > 0.0 or s.leaders[i].leaves > 0.0  # a change that something asked for
    for k in range(s.count):
        c = cython.address(s.constraints[k])
        if c.weight > 0.0:
            s.leaders[c.i].worse = True
            if c.kind == PAIR:
                s.leaders[c.j].worse = True
    for i in range(n):
        if not s.leaders[i].worse:
            _copy(plain + 3 * i, u + 3 * i)
        _copy(u + 3 * i, projected + 3 * i)
    _check(s, projected, u, level)
    _restore(s, projected, u, level)
    _bind(s, plain, u, changed, kind, binding)


def solve(
    p: FloatArray, v: FloatArray, wanted: FloatArray, v_max: FloatArray, a_max: FloatArray, margin: FloatArray,
    spread: FloatArray, ids: IntArray, others: FloatArray, table: FloatArray, beyond: Any, walls: FloatArray,
    pair_required: FloatArray, other_required: FloatArray, rules: Any,
) -> tuple[FloatArray, FloatArray, IntArray, IntArray, IntArray]:  # fmt: skip
    """Accelerations (n, 3), their change from the wanted ones, what bound them, and how far the check had to go, (n,)
    each.

    Vehicles are in order of id; arguments as in `filter_step`. others: (m, 9) place, velocity, radius, growth, agility.
    beyond: (n,) uint8. walls: (n, 6). pair_required, other_required: rows (i, j, m), i < j of a pair.
    """
    n = len(p)
    u, changed = np.empty((n, 3)), np.empty(n)
    kind, binding, level = np.empty(n, np.int64), np.empty(n, np.int64), np.empty(n, np.int64)
    u_view, changed_view, kind_view, binding_view, level_view = u, changed, kind, binding, level
    found = Constraints(rows=cython.NULL, count=0, room=0)
    boxes = cython.cast(cython.pointer(Box), calloc(max(n, len(table)) + 1, cython.sizeof(Box)))
    rows = cython.cast(cython.p_double, calloc(20 * n + 1, cython.sizeof(cython.double)))
    leaders = cython.cast(cython.pointer(Leader), calloc(n + 1, cython.sizeof(Leader)))
    active = cython.cast(cython.p_Py_ssize_t, cython.NULL)
    try:
        if not boxes or not rows or not leaders:
            raise MemoryError
        brake, reach = rows + 18 * n, rows + 19 * n
        for i in range(n):
            brake[i] = rules.brake_share * a_max[i]
        near = Near(
            n=n, p=cython.address(p[0, 0]), v=cython.address(v[0, 0]), v_max=cython.address(v_max[0]),
            a_max=cython.address(a_max[0]), brake=brake,
            margin=cython.address(margin[0]), spread=cython.address(spread[0]),
            beyond=cython.address(beyond[0]), walls=cython.address(walls[0, 0]),
            others=cython.cast(cython.pointer(Other), cython.address(others[0, 0])), others_count=len(others),
            shapes=shape_at(table, 0), shapes_count=len(table),
            pairs=cython.address(pair_required[0, 0]), pairs_count=len(pair_required),
            singles=cython.address(other_required[0, 0]), singles_count=len(other_required),
            apart=rules.apart, separation=rules.separation, clearance=rules.clearance, buffer=rules.buffer,
            dt=rules.dt, horizon=rules.horizon,
        )  # fmt: skip
        find_constraints(cython.address(near), reach, boxes, cython.address(found))
        active = cython.cast(cython.p_Py_ssize_t, calloc(found.count + 1, cython.sizeof(cython.Py_ssize_t)))
        if not active:
            raise MemoryError
        around = Surroundings(
            others=near.others, shapes=near.shapes, walls=near.walls, dt=rules.dt, horizon=rules.horizon
        )
        problem = Problem(
            n=n, p=near.p, v=near.v, wanted=cython.address(wanted[0, 0]), v_max=cython.address(v_max[0]),
            a_max=near.a_max, brake=brake, ids=cython.address(ids[0]), u_b=rows, leaders=leaders,
            constraints=found.rows, count=found.count, around=around, rules=rules,
        )  # fmt: skip
        _solve(
            cython.address(problem), rows, active, cython.address(u_view[0, 0]), cython.address(changed_view[0]),
            cython.address(kind_view[0]), cython.address(binding_view[0]), cython.address(level_view[0]),
        )  # fmt: skip
    finally:
        free(boxes)
        free(rows)
        free(leaders)
        free(active)
        free(found.rows)
    return u, changed, kind, binding, level
