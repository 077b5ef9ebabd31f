"""Kernels of the safety filter: projection of all wanted accelerations together, and the check that makes the
guarantee.

Everything runs in the order of the rows that are given and a fixed number of times, so equal inputs give equal bits.
A constraint is a row (kind, vehicle, with what) and its required distance D; safety_filter.py has the equations.
"""

from __future__ import annotations

import math
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from gcs.kernels import inner, kernel
from gcs.planner import braking_clearance, near_constraints, safety_constraints
from gcs.planner.braking_clearance import TINY, FloatArray, IntArray, braking
from gcs.planner.near_constraints import constraints_within_reach
from gcs.planner.safety_constraints import (
    GOLDEN,
    PAIR,
    PLANE,
    BoolArray,
    clearance_of,
    into_ball,
    line_of,
    within_limits,
)
from gcs.scenario import geometry

TOLERANCE_M = 1e-9
"""Rounding that the check forgives, so that a formation at exactly D is left in peace."""
_ACTED_M_S2 = 1e-9
_BLENDS = np.array([1.0, 0.5, 0.2, 0.0])  # shares of the projected acceleration; the rest is braking
_ACTIVE_M = 0.25
_REPAIRS = 4
_FEWEST_ROUNDS = 2
_SOFT_M = 0.1  # above the distance aimed at: there the turn of a wanted velocity begins


@inner(error_model="numpy")
def _turned(wanted: FloatArray, ids: IntArray, share: FloatArray, turn: float, climb: float) -> FloatArray:
    """Wanted velocities turned to the right by turn share and raised by up to climb share, differently for each id."""
    out = wanted.copy()
    for i in range(len(wanted)):
        if share[i] > 0.0:
            cos, sin = math.cos(turn * share[i]), math.sin(turn * share[i])
            part = (ids[i] * GOLDEN) % 1.0
            # A wanted velocity straight up or down has no right side, so one is chosen by id.
            right_n = abs(wanted[i, 2]) * math.cos(2.0 * math.pi * part) - wanted[i, 1]
            right_e = abs(wanted[i, 2]) * math.sin(2.0 * math.pi * part) + wanted[i, 0]
            out[i, 0] = cos * wanted[i, 0] + sin * right_n
            out[i, 1] = cos * wanted[i, 1] + sin * right_e
            speed = math.sqrt(wanted[i, 0] ** 2 + wanted[i, 1] ** 2)
            out[i, 2] = wanted[i, 2] + (2.0 * part - 1.0) * math.tan(climb * share[i]) * speed
    return out


@inner(error_model="numpy")
def _project(
    u: FloatArray, rows: IntArray, active: IntArray, lines: FloatArray, weight: FloatArray, live: BoolArray,
    v: FloatArray, a_max: FloatArray, v_top: FloatArray, dt: float, sweeps: int,
) -> None:  # fmt: skip
    """Nearest u within all lines (Hildreth) and both balls (Dykstra), by sweeps; writes u and the lines' weights."""
    n = len(u)
    corrected = np.zeros((n, 6))
    before = np.empty(3)
    for _ in range(sweeps):
        for k in range(len(active)):
            c = active[k]
            i, j = rows[c, 1], rows[c, 2]
            line = lines[c]
            short = line[6] - line[0] * u[i, 0] - line[1] * u[i, 1] - line[2] * u[i, 2]
            if rows[c, 0] == PAIR:
                short -= line[3] * u[j, 0] + line[4] * u[j, 1] + line[5] * u[j, 2]
            more = max(short / line[7], -weight[c])
            if more != 0.0:
                weight[c] += more
                for x in range(3):
                    u[i, x] += more * line[x]
                if rows[c, 0] == PAIR:
                    for x in range(3):
                        u[j, x] += more * line[3 + x]
        for i in range(n):
            if live[i]:
                for ball in range(2):
                    for x in range(3):
                        u[i, x] += corrected[i, 3 * ball + x]
                        before[x] = u[i, x]
                    if ball == 0:
                        into_ball(u, i, -v[i, 0] / dt, -v[i, 1] / dt, -v[i, 2] / dt, v_top[i] / dt)
                    else:
                        into_ball(u, i, 0.0, 0.0, 0.0, a_max[i])
                    for x in range(3):
                        corrected[i, 3 * ball + x] = before[x] - u[i, x]


@inner(error_model="numpy")
def _live(rows: IntArray, near: BoolArray, short: BoolArray, n: int, everybody: bool) -> BoolArray:
    """Vehicles that a near constraint concerns; after the first rounds only those of groups where one is short."""
    group = np.arange(n)
    for c in range(len(rows)):
        if near[c] and rows[c, 0] == PAIR:
            a, b = rows[c, 1], rows[c, 2]
            while group[a] != a:
                a = group[a]
            while group[b] != b:
                b = group[b]
            group[max(a, b)] = min(a, b)
            group[rows[c, 1]], group[rows[c, 2]] = min(a, b), min(a, b)
    for i in range(n):
        group[i] = group[group[i]]  # roots are lower than their members, so theirs are found already
    concerned = np.zeros(n, dtype=np.bool_)
    for c in range(len(rows)):
        if near[c] and (everybody or short[c]):
            concerned[group[rows[c, 1]]] = True
    return concerned[group]


@inner(error_model="numpy")
def _check(
    u: FloatArray, u_b: FloatArray, least: FloatArray, cause: IntArray, rows: IntArray, p: FloatArray, v: FloatArray,
    brake: FloatArray, others: FloatArray, table: FloatArray, walls: FloatArray, dt: float, horizon: float,
) -> IntArray:  # fmt: skip
    """Take vehicles towards braking until every constraint keeps its least clearance; writes u (module docstring).

    All of a pass are judged by the same accelerations, so their order does not matter. Every pass but the last one
    lowers a vehicle's share, and shares end at 0, full braking, which needs no proof: so it ends.
    """
    n = len(u)
    wanted = u.copy()
    level = np.zeros(n, dtype=np.int64)
    moved = np.ones(n, dtype=np.bool_)
    last = len(_BLENDS) - 1
    while True:
        worse = np.zeros(n, dtype=np.bool_)
        found = False
        for c in range(len(rows)):
            i, j = rows[c, 1], rows[c, 2]
            pair = rows[c, 0] == PAIR
            if not (moved[i] or (pair and moved[j])) or (level[i] == last and not (pair and level[j] < last)):
                continue
            first, after, _, _, _, _ = clearance_of(
                rows, c, least[c], p, v, u, brake, others, table, walls, dt, horizon
            )
            if min(first, after) < least[c] - TOLERANCE_M:
                found = True
                worse[i], cause[i] = True, c
                if pair:
                    worse[j], cause[j] = True, c
        if not found:
            return level
        for i in range(n):
            moved[i] = worse[i] and level[i] < last
            if moved[i]:
                level[i] += 1
                for x in range(3):
                    u[i, x] = u_b[i, x] + _BLENDS[level[i]] * (wanted[i, x] - u_b[i, x])


@inner(error_model="numpy")
def _restore(
    u: FloatArray, wanted: FloatArray, u_b: FloatArray, level: IntArray, least: FloatArray, target: FloatArray,
    rows: IntArray, p: FloatArray, v: FloatArray, a_max: FloatArray, v_top: FloatArray, brake: FloatArray,
    ids: IntArray, others: FloatArray, table: FloatArray, walls: FloatArray, dt: float, horizon: float,
) -> None:  # fmt: skip
    """Give back what the check took too much of, one vehicle after the other; writes u and level.

    The check takes from both of a pair, and whoever stands would stand again in the next period for the same reason.
    Everybody else's acceleration is held meanwhile, so every constraint still holds after each of these steps. What
    still fails moves the vehicle's own acceleration away, a few times.
    """
    before, line, one = np.empty(3), np.empty(8), np.zeros(len(u), dtype=np.bool_)
    for i in range(len(u)):
        if level[i] == 0:
            continue
        before[:] = u[i]
        one[i] = True
        kept = False
        for lower in range(level[i]):
            u[i] = u_b[i] + _BLENDS[lower] * (wanted[i] - u_b[i])
            for _ in range(_REPAIRS):
                kept = True
                for c in range(len(rows)):
                    mine = rows[c, 1] == i
                    if not mine and not (rows[c, 0] == PAIR and rows[c, 2] == i):
                        continue
                    first, after, when, nn, ne, nd = clearance_of(
                        rows, c, target[c], p, v, u, brake, others, table, walls, dt, horizon
                    )
                    if min(first, after) < least[c] - TOLERANCE_M:
                        kept = False
                        if line_of(rows, c, target[c], after, when, nn, ne, nd, v, u, brake, dt, ids, line):
                            own = line[0:3] if mine else line[3:6]
                            square = own[0] ** 2 + own[1] ** 2 + own[2] ** 2
                            if square > TINY * TINY:
                                more = (target[c] - after) / square
                                for x in range(3):
                                    u[i, x] += more * own[x]
                        within_limits(u, one, v, u_b, a_max, v_top, dt)
                if kept:
                    break
            if kept:
                level[i] = lower
                break
        if not kept:
            u[i] = before
        one[i] = False


@inner(error_model="numpy")
def _solve(
    p: FloatArray, v: FloatArray, wanted: FloatArray, v_max: FloatArray, a_max: FloatArray, brake: FloatArray,
    ids: IntArray, rows: IntArray, required: FloatArray, others: FloatArray, table: FloatArray, walls: FloatArray,
    dt: float, horizon: float, buffer: float, recover: float, turn: float, climb: float, rounds: int, sweeps: int,
) -> tuple[FloatArray, FloatArray, IntArray, IntArray, IntArray]:  # fmt: skip
    """Accelerations (n, 3), their change from the wanted ones, what bound them, and how far the check had to go, (n,)
    each."""
    n, m = len(p), len(rows)
    u_b, v_top = np.empty((n, 3)), np.empty(n)
    for i in range(n):
        u_b[i, 0], u_b[i, 1], u_b[i, 2] = braking(v[i, 0], v[i, 1], v[i, 2], brake[i], dt)
        speed = math.sqrt(v[i, 0] ** 2 + v[i, 1] ** 2 + v[i, 2] ** 2)
        v_top[i] = max(v_max[i], speed - brake[i] * dt)
    plain, all_live = (wanted - v) / dt, np.ones(n, dtype=np.bool_)
    within_limits(plain, all_live, v, u_b, a_max, v_top, dt)
    u = plain.copy()
    target, least = np.empty(m), np.empty(m)
    share, still, cause = np.zeros(n), np.zeros((n, 3)), np.full(n, -1)
    full = wanted.copy()  # the wanted velocity, no faster than allowed
    for i in range(n):
        into_ball(full, i, 0.0, 0.0, 0.0, v_max[i])
    for c in range(m):
        d = required[c]
        first, after, _, _, _, _ = clearance_of(
            rows, c, d + buffer, p, v, u_b, brake, others, table, walls, dt, horizon
        )
        least[c] = min(d, first, after)
        target[c] = min(max(after, d), d + buffer) if after >= d else min(d, after + recover * dt)
        i, j = rows[c, 1], rows[c, 2]
        if rows[c, 0] == PLANE:
            continue
        enough = target[c] + _SOFT_M
        _, after, _, _, _, _ = clearance_of(rows, c, enough, p, v, u, brake, others, table, walls, dt, horizon)
        if after < enough:
            # How far the wanted velocity cannot be had is seen where it is flown already: who stands has turned as
            # much.
            gate = min((enough - after) / _SOFT_M, 1.0)
            _, after, _, _, _, _ = clearance_of(
                rows, c, target[c], p, full, still, brake, others, table, walls, dt, horizon
            )
            blocked = gate * min((target[c] - after) / max(d, 0.1), 1.0)
            if blocked > share[i]:
                share[i], cause[i] = blocked, c
            if rows[c, 0] == PAIR and blocked > share[j]:
                share[j], cause[j] = blocked, c
    aim = (_turned(full, ids, share, turn, climb) - v) / dt
    for i in range(n):
        into_ball(aim, i, 0.0, 0.0, 0.0, a_max[i])
    for i in range(n):
        if share[i] > 0.0:
            u[i] = aim[i]
    within_limits(u, all_live, v, u_b, a_max, v_top, dt)
    lines, weight = np.zeros((m, 8)), np.zeros(m)
    near, short, live = np.zeros(m, dtype=np.bool_), np.zeros(m, dtype=np.bool_), np.ones(n, dtype=np.bool_)
    for turn_no in range(rounds):
        for c in range(m):
            i, j = rows[c, 1], rows[c, 2]
            if not (live[i] or (rows[c, 0] == PAIR and live[j])):
                continue  # nothing has changed there
            # What is a little farther takes part too: it may come in the way of whom another constraint turns aside.
            enough = target[c] + _ACTIVE_M
            first, after, when, nn, ne, nd = clearance_of(
                rows, c, enough, p, v, u, brake, others, table, walls, dt, horizon
            )
            short[c] = min(first, after) < least[c] - TOLERANCE_M
            near[c] = after < enough and line_of(
                rows, c, target[c], after, when, nn, ne, nd, v, u, brake, dt, ids, lines[c]
            )
            if not near[c]:
                weight[c] = 0.0
        live = _live(rows, near, short, n, turn_no < _FEWEST_ROUNDS)
        active = np.array([c for c in range(m) if near[c] and live[rows[c, 1]]], dtype=np.int64)
        if len(active) == 0:
            break
        for i in range(n):
            if live[i]:
                u[i] = aim[i]
        for c in active:  # the weights of the round before are nearly right, so the sweeps begin with them
            for x in range(3):
                u[rows[c, 1], x] += weight[c] * lines[c, x]
                if rows[c, 0] == PAIR:
                    u[rows[c, 2], x] += weight[c] * lines[c, 3 + x]
        _project(u, rows, active, lines, weight, live, v, a_max, v_top, dt, sweeps)
        within_limits(u, live, v, u_b, a_max, v_top, dt)
    free = share == 0.0
    for c in range(m):
        if weight[c] > 0.0:
            free[rows[c, 1]] = False
            if rows[c, 0] == PAIR:
                free[rows[c, 2]] = False
    for i in range(n):
        if free[i]:
            u[i] = plain[i]
    changed, kind, binding, pull = np.zeros(n), np.zeros(n, dtype=np.int64), np.full(n, -1), np.zeros(n)
    projected = u.copy()
    level = _check(u, u_b, least, cause, rows, p, v, brake, others, table, walls, dt, horizon)
    _restore(
        u, projected, u_b, level, least, target, rows, p, v, a_max, v_top, brake, ids, others, table, walls, dt, horizon
    )
    for c in range(m):
        i, j = rows[c, 1], rows[c, 2]
        size = weight[c] * math.sqrt(lines[c, 0] ** 2 + lines[c, 1] ** 2 + lines[c, 2] ** 2)
        if size > pull[i]:
            pull[i], kind[i], binding[i] = size, rows[c, 0], j
        if rows[c, 0] == PAIR:
            size = weight[c] * math.sqrt(lines[c, 3] ** 2 + lines[c, 4] ** 2 + lines[c, 5] ** 2)
            if size > pull[j]:
                pull[j], kind[j], binding[j] = size, rows[c, 0], i
    for i in range(n):
        if kind[i] == 0 and cause[i] >= 0:  # turned or braked by what the projection did not need to heed
            c = cause[i]
            kind[i], binding[i] = rows[c, 0], rows[c, 1] if rows[c, 2] == i and rows[c, 0] == PAIR else rows[c, 2]
        changed[i] = math.sqrt(((u[i] - plain[i]) ** 2).sum())
        if changed[i] <= _ACTED_M_S2:
            u[i], changed[i], kind[i], binding[i] = plain[i], 0.0, 0, -1
    return u, changed, kind, binding, level


def _compiled(build: int) -> Callable[..., Any]:
    """The one kernel here that numba keeps on disk (as in simvehicle/law/step.py).

    numba notices a change of the file of a kernel that it kept, not of the files of kernels compiled into it. Closing
    over `build`, a checksum of those, makes them part of the key.
    """

    @kernel()
    def solve(
        p: FloatArray, v: FloatArray, wanted: FloatArray, v_max: FloatArray, a_max: FloatArray, margin: FloatArray,
        ids: IntArray, others: FloatArray, table: FloatArray, beyond: BoolArray, walls: FloatArray,
        pair_required: FloatArray, other_required: FloatArray, apart: bool, separation: float, clearance: float,
        brake_share: float, dt: float, horizon: float, buffer: float, recover: float, turn: float, climb: float,
        rounds: int, sweeps: int,
    ) -> tuple[FloatArray, FloatArray, IntArray, IntArray, IntArray]:  # fmt: skip
        _ = build
        brake = brake_share * a_max
        constraints, required = constraints_within_reach(
            p, v, a_max, brake, margin, others, table, beyond, walls, pair_required, other_required, apart, separation,
            clearance, dt, horizon, buffer,
        )  # fmt: skip
        return _solve(
            p, v, wanted, v_max, a_max, brake, ids, constraints, required, others, table, walls, dt, horizon, buffer,
            recover, turn, climb, rounds, sweeps,
        )  # fmt: skip

    return solve


def _checksum() -> int:
    files = (
        Path(str(braking_clearance.__file__)),
        Path(str(safety_constraints.__file__)),
        Path(str(near_constraints.__file__)),
        Path(str(geometry.__file__)),
    )
    return zlib.crc32(b"".join(file.read_bytes() for file in files))


solve = _compiled(_checksum())
