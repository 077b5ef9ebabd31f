"""Kernel: the columns of a snapshot, from what the fleet's vehicles have reported (gcs/telemetry/track.py)."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.kernel_files import checksum
from gcs.kernels import UNCOUNTED, kernel
from gcs.telemetry import columns, energy, plausibility, readings, state
from gcs.telemetry.columns import (
    AGE_S,
    CAPACITY_J,
    DRAWN_J,
    GROUND_DOWN_M,
    INITIAL_J,
    IS_ALIVE,
    IS_FLYING,
    IS_FRESH,
    IS_LANDED,
    IS_STEERABLE,
    P_NED,
    P_NOW_NED,
    REMAINING_J,
    V_NED,
)
from gcs.telemetry.plausibility import DOUBTED_S, LEAST_SHARE, MOST_SHARE
from gcs.telemetry.readings import (
    DOWN,
    EAST,
    LANDED,
    LANDED_REPORTED,
    NORTH,
    POSITION_S,
    RECEIVED_S,
    V_DOWN,
    V_EAST,
    V_NORTH,
)
from gcs.telemetry.state import STALE_S

LANDED_M = 0.3
"""A vehicle that does not report whether it has landed is in the air above this height."""

FACTS = 11
(
    ALIVE, ARMED, STEERABLE,  # 1 or 0
    OFFSET_N, OFFSET_E, OFFSET_D,  # m, of its own frame in the common one; NaN while unknown
    TURN, COSINE, SINE,  # rad, of that frame's axes
    GROUND_DOWN,  # m; NaN while unknown
    DOUBTED,  # s, when it last told what cannot be; -inf without
) = range(FACTS)  # fmt: skip
"""Of a vehicle, beside its readings: as they change, which is seldom."""


def _compiled(build: int) -> Callable[..., bool]:
    """The entry, kept by numba; `build`: checksum of the other files that it is made of."""

    @kernel(**UNCOUNTED)
    def fill(
        now_s: float,
        reports: NDArray[np.float64],
        facts: NDArray[np.float64],
        accounts: NDArray[Any],
        seen: NDArray[np.int64],
        stamps: NDArray[np.int64],
        flags: NDArray[np.bool_],
        places: NDArray[np.float64],
        figures: NDArray[np.float64],
    ) -> bool:
        _ = build
        changed = False
        for k in range(len(reports)):
            row, fact, one = reports[k], facts[k], accounts[k]
            north, east, down = row[NORTH], row[EAST], row[DOWN]
            v_north, v_east, v_down = row[V_NORTH], row[V_EAST], row[V_DOWN]
            if fact[TURN] != 0.0:
                cosine, sine = fact[COSINE], fact[SINE]
                north, east = cosine * north - sine * east, sine * north + cosine * east
                v_north, v_east = cosine * v_north - sine * v_east, sine * v_north + cosine * v_east
            north, east, down = north + fact[OFFSET_N], east + fact[OFFSET_E], down + fact[OFFSET_D]
            known = not math.isnan(north)
            age_s = max(now_s - row[POSITION_S], 0.0)
            ahead_s = min(age_s, STALE_S)
            places[P_NED, k, 0], places[P_NED, k, 1], places[P_NED, k, 2] = north, east, down
            places[V_NED, k, 0], places[V_NED, k, 1], places[V_NED, k, 2] = v_north, v_east, v_down
            places[P_NOW_NED, k, 0] = north + v_north * ahead_s
            places[P_NOW_NED, k, 1] = east + v_east * ahead_s
            places[P_NOW_NED, k, 2] = down + v_down * ahead_s
            ground = fact[GROUND_DOWN]
            landed = row[LANDED] == 1.0
            if row[LANDED_REPORTED] == 0.0 and known and not math.isnan(ground):
                landed = ground - down < LANDED_M
            left_j = one.initial_j + one.received_j - one.drawn_j - one.given_j
            share = left_j / one.capacity_j
            doubted = now_s - fact[DOUBTED] < DOUBTED_S
            overfull = one.capacity_j > 0.0 and (share < LEAST_SHARE or share > MOST_SHARE)
            alive, armed = fact[ALIVE] == 1.0, fact[ARMED] == 1.0
            flying = alive and armed and not landed and known
            fresh = alive and age_s <= STALE_S and not doubted and not overfull
            flags[IS_ALIVE, k], flags[IS_STEERABLE, k] = alive, fact[STEERABLE] == 1.0
            flags[IS_LANDED, k], flags[IS_FLYING, k], flags[IS_FRESH, k] = landed, flying, fresh
            figures[AGE_S, k], figures[GROUND_DOWN_M, k] = age_s, ground
            figures[REMAINING_J, k], figures[DRAWN_J, k] = left_j, one.drawn_j
            figures[INITIAL_J, k], figures[CAPACITY_J, k] = one.initial_j, one.capacity_j
            now_seen = (
                np.int64(known)
                | np.int64(landed) << 1
                | np.int64(flying) << 2
                | np.int64(fresh) << 3
                | np.int64(doubted) << 4
                | np.int64(overfull) << 5
                | np.int64(row[RECEIVED_S] >= 0.0) << 6
                | np.int64(not math.isnan(row[NORTH])) << 7
                | np.int64(left_j <= 0.0) << 8
            )
            if now_seen != seen[k]:
                seen[k] = now_seen
                stamps[k] += 1
                changed = True
        return changed

    return fill


fill = _compiled(checksum(columns, energy, plausibility, readings, state))
"""(session time, readings (n, READINGS), facts (n, FACTS), accounts (n,), seen (n,), stamps (n,), flags (FLAGS, n),
places (PLACES, n, 3), figures (FIGURES, n)): fills the last three, of n vehicles, from the first ones. If more than
figures of one is another than in the last call, which `seen` remembers, it gets the next number in `stamps`. Whether
any does."""
