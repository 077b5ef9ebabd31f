"""The columns of a snapshot, from what the fleet's vehicles have reported (gcs/telemetry/track.py)."""

from __future__ import annotations

from typing import Any

import cython
import numpy as np
from cython.cimports.gcs.telemetry.fleet_columns import (
    _AGE_S,
    _CAPACITY_J,
    _DRAWN_J,
    _GROUND_DOWN_M,
    _INITIAL_J,
    _IS_ALIVE,
    _IS_EMPTY,
    _IS_FLYING,
    _IS_FRESH,
    _IS_LANDED,
    _IS_STEERABLE,
    _P_NED,
    _P_NOW_NED,
    _REMAINING_J,
    _V_NED,
    _WAY_M,
    facts_at,
)
from cython.cimports.gcs.telemetry.readings import readings_at
from cython.cimports.libc.math import isnan
from numpy.typing import NDArray

from gcs.telemetry.plausibility import DOUBTED_S, LEAST_SHARE, MOST_SHARE
from gcs.telemetry.state import MODE_STALE_S, STALE_S

_LANDED_M = 0.3  # a vehicle that does not report whether it has landed is in the air above this height
_STALE_S, _MODE_STALE_S = STALE_S, MODE_STALE_S
_DOUBTED_S, _LEAST_SHARE, _MOST_SHARE = DOUBTED_S, LEAST_SHARE, MOST_SHARE


FACTS = 11
(
    ALIVE, ARMED, STEERABLE,  # 1 or 0
    OFFSET_N, OFFSET_E, OFFSET_D,  # m, of its own frame in the common one; NaN while unknown
    TURN, COSINE, SINE,  # rad, of that frame's axes
    GROUND_DOWN,  # m; NaN while unknown
    DOUBTED,  # s, when it last reported what cannot be; -inf without
) = range(FACTS)  # fmt: skip
"""Of a vehicle, beside its readings: as they change, which is seldom. In the order of the struct Facts."""


class ColumnFiller:
    """Fills the columns of n vehicles from the tables of what they have reported.

    reports (n, READINGS), facts (n, FACTS) and accounts (n,) are read. `seen` (n,) remembers the last call; where more
    than figures of a vehicle has changed since, `changed` (n,) gets the number of this one.
    """

    def __init__(
        self,
        reports: NDArray[np.float64],
        facts: NDArray[np.float64],
        accounts: NDArray[Any],
        seen: NDArray[np.int64],
        changed: NDArray[np.int64],
    ) -> None:
        self._reports, self._facts, self._accounts = reports, facts, accounts
        self._seen, self._changed = seen, changed

    def fill(
        self,
        now_s: float,
        number: int,
        flags: NDArray[np.uint8],
        places: NDArray[np.float64],
        figures: NDArray[np.float64],
    ) -> bool:
        """Fill flags (FLAGS, n), places (PLACES, n, 3) and figures (FIGURES, n) at a session time; whether any vehicle
        has changed as of this number."""
        return self._fill(now_s, number, flags, places, figures)

    def _fill(self, now_s: float, number: int, flags: Any, places: Any, figures: Any) -> Any:
        some = False
        for k in range(self._reports.shape[0]):
            row, fact, one = readings_at(self._reports, k), facts_at(self._facts, k), cython.address(self._accounts[k])
            north, east, down = row.north, row.east, row.down
            v_north, v_east, v_down = row.v_north, row.v_east, row.v_down
            if fact.turn != 0.0:
                cosine, sine = fact.cosine, fact.sine
                north, east = cosine * north - sine * east, sine * north + cosine * east
                v_north, v_east = cosine * v_north - sine * v_east, sine * v_north + cosine * v_east
            north, east, down = north + fact.offset_n, east + fact.offset_e, down + fact.offset_d
            known = not isnan(north)
            age_s = max(now_s - row.position_s, 0.0)
            ahead_s = min(age_s, _STALE_S)
            places[_P_NED, k, 0], places[_P_NED, k, 1], places[_P_NED, k, 2] = north, east, down
            places[_V_NED, k, 0], places[_V_NED, k, 1], places[_V_NED, k, 2] = v_north, v_east, v_down
            places[_P_NOW_NED, k, 0] = north + v_north * ahead_s
            places[_P_NOW_NED, k, 1] = east + v_east * ahead_s
            places[_P_NOW_NED, k, 2] = down + v_down * ahead_s
            ground = fact.ground_down
            landed = row.landed == 1.0
            if row.landed_reported == 0.0 and known and not isnan(ground):
                landed = ground - down < _LANDED_M
            left_j = one.initial_j + one.received_j - one.drawn_j - one.given_j
            share = left_j / one.capacity_j
            doubted = now_s - fact.doubted < _DOUBTED_S
            empty = left_j <= 0.0 or one.share == 0.0
            overfull = one.capacity_j > 0.0 and (share < _LEAST_SHARE or share > _MOST_SHARE)
            alive, armed = fact.alive == 1.0, fact.armed == 1.0
            flying = alive and armed and not landed and known
            reported = row.received_s >= 0.0
            moded = not reported or now_s - row.received_s <= _MODE_STALE_S
            fresh = alive and age_s <= _STALE_S and moded and not doubted and not overfull
            flags[_IS_ALIVE, k], flags[_IS_STEERABLE, k] = alive, fact.steerable == 1.0 and moded
            flags[_IS_LANDED, k], flags[_IS_FLYING, k], flags[_IS_FRESH, k] = landed, flying, fresh
            flags[_IS_EMPTY, k] = empty
            figures[_AGE_S, k], figures[_GROUND_DOWN_M, k] = age_s, ground
            figures[_REMAINING_J, k], figures[_DRAWN_J, k] = left_j, one.drawn_j
            figures[_INITIAL_J, k], figures[_CAPACITY_J, k] = one.initial_j, one.capacity_j
            figures[_WAY_M, k] = row.way
            now_seen = (
                known
                | landed << 1
                | flying << 2
                | fresh << 3
                | doubted << 4
                | overfull << 5
                | reported << 6
                | (not isnan(row.north)) << 7
                | (left_j <= 0.0) << 8
                | moded << 9
                | empty << 10
            )
            if now_seen != self._seen[k]:
                self._seen[k] = now_seen
                self._changed[k] = number
            some = some or self._changed[k] == number
        return some
