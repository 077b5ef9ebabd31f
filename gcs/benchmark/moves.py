"""Moves: all that a giver may do next in many unfinished schedules at once, and what comes of it.

A service gives what the receiver lacks until the horizon, what it has room for, or what is left to give, whichever is
least; a share of that; or it waits until one service brings the receiver to the horizon. A tanker may load at a base.
A receiver may come to a base, for a transfer or to stay until the horizon.

Of the arrays, the first axis is the unfinished schedules: b of them, n receivers, g givers, tankers before bases.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gcs.benchmark.arrays import MEETS_LATER_S, Arrays, Floats, Ints, net_w

LEAST_J = 200.0
"""A giver with less to give is done."""
MARGIN_J = 1.0
LATER_S = 0.02
LONGEST_WAIT_S = 25.0
LOADS_LEAST = 0.1
"""[choice] Of what a tanker holds: it goes to a base for no less."""
LOADS_MOST_S = 40.0
NONE, LOAD = -1, -2
"""In place of a receiver: the giver waits, or loads at a base."""


@dataclass(frozen=True)
class Weights:
    """How beginnings are compared and what is tried [choice]: found by trying weights at random on 10 instances."""

    lost: float = 5.0
    way_s: float = 2.0
    """that a service is taken to fly"""
    late: float = 0.3
    """of work before deadlines, beyond what givers can do, in services"""
    near: float = 0.8
    near_s: float = 5.0
    """a receiver that lands in so many seconds counts `near` / e"""
    work: float = 0.1
    """of a service's work that is left"""
    time: float = 0.0
    """of a service's time that givers have used"""
    share: float = 0.55
    """of the greatest transfer, tried beside it; 0: none"""
    room: float = 0.65
    """of what a receiver holds: services that give less must bring it to the horizon"""
    window_s: float = 2.0
    wait_s: float = 2.0


class Beginnings(NamedTuple):
    """Beginnings of schedules: b of them, n receivers, g givers."""

    lands_s: Floats
    """(b, n)"""
    busy_s: Floats
    """(b, n) until then a receiver is with a giver, or off its path"""
    free_s: Floats
    """(b, g)"""
    place_ned: Floats
    """(b, g, 3)"""
    spare_j: Floats
    """(b, g) of a tanker, what it can give until the horizon; of a base, its stock"""
    last: Ints
    """(b,) the latest of its services, as an index of all that were tried"""

    def of(self, rows: Ints | np.ndarray) -> Beginnings:
        """Some of them."""
        return Beginnings._make(column[rows] for column in self)

    def with_others(self, other: Beginnings) -> Beginnings:
        """Both."""
        return Beginnings._make(np.concatenate(pair) for pair in zip(self, other, strict=True))


class Moves(NamedTuple):
    """Services, loads and waits that are tried: one each, with its row of the state."""

    row: Ints
    giver: Ints
    receiver: Ints
    """or NONE, or LOAD"""
    base: Ints
    """at which a tanker loads"""
    leave_s: Floats
    start_s: Floats
    end_s: Floats
    back_s: Floats
    energy_j: Floats

    def of(self, rows: Ints | np.ndarray) -> Moves:
        """Some of them."""
        return Moves._make(column[rows] for column in self)


def lands(arrays: Arrays, state: Beginnings) -> np.ndarray:
    """(b, n) whether it lands before the horizon if it gets no more."""
    return np.asarray(state.lands_s < arrays.horizon_s - 1e-6)


def moves_of(arrays: Arrays, state: Beginnings, weights: Weights) -> Moves:
    """All that the first free giver of each beginning may do."""
    giver = state.free_s.argmin(axis=1)
    rows = np.arange(len(giver))
    free_s = state.free_s[rows, giver]
    flies = np.flatnonzero(giver < arrays.m)
    stands = np.flatnonzero(giver >= arrays.m)
    found = [_waits(rows, giver, free_s)]
    if len(flies):
        found += _tanker_moves(arrays, state, weights, flies, giver[flies], free_s[flies])
        found += [_load(arrays, state, flies, giver[flies], free_s[flies], base) for base in range(arrays.k)]
    if len(stands):
        found += _base_moves(arrays, state, weights, stands, giver[stands], free_s[stands])
    return Moves._make(np.concatenate(columns) for columns in zip(*found, strict=True))


def _waits(rows: Ints, giver: Ints, free_s: Floats) -> Moves:
    nothing = np.full(len(rows), NONE)
    return Moves(rows, giver, nothing, nothing, free_s, free_s, free_s, free_s, np.zeros(len(rows)))


def _tanker_moves(
    arrays: Arrays, state: Beginnings, weights: Weights, rows: Ints, giver: Ints, free_s: Floats
) -> list[Moves]:
    """Services in flight."""
    horizon_s, setup_s, rate_w, power_w = arrays.horizon_s, arrays.setup_s, arrays.rate_w, arrays.power_w
    lands_s, each = state.lands_s[rows], np.arange(arrays.n)
    met_s = arrays.meets_s(
        each, np.repeat(free_s[:, None], arrays.n, axis=1), state.place_ned[rows, giver][:, None],
        arrays.speed_m_s[giver][:, None],
    )  # fmt: skip
    soon_s = np.maximum(met_s, state.busy_s[rows])
    lacks_j = power_w * (horizon_s - lands_s)
    last_s = horizon_s - arrays.holds_j / power_w - setup_s - lacks_j / rate_w + LATER_S
    found = []
    for waits, share in ((False, 1.0), (True, 1.0), *([(False, weights.share)] if weights.share else [])):
        start_s = np.maximum(soon_s, last_s) if waits else soon_s
        flows_from_s = start_s + setup_s
        room_j = (arrays.holds_j - power_w * (lands_s - flows_from_s)) * rate_w
        room_j /= net_w(rate_w, power_w)
        most_j = np.minimum(state.spare_j[rows, giver][:, None] - MARGIN_J, (horizon_s - flows_from_s) * rate_w)
        energy_j = np.minimum(np.minimum(room_j - MARGIN_J, lacks_j + MARGIN_J), most_j)
        may = (lands_s < horizon_s - 1e-6) & (lands_s >= flows_from_s + LATER_S) & (energy_j > 0.0)
        lasts = energy_j >= lacks_j
        if waits:
            may &= lasts & (start_s > soon_s + 0.05) & (start_s < soon_s + LONGEST_WAIT_S)
        elif share < 1.0:
            energy_j = energy_j * share
            may &= energy_j > 0.15 * arrays.holds_j
        else:
            may &= lasts | (energy_j > weights.room * arrays.holds_j) | (energy_j >= most_j)
        row, receiver = np.nonzero(may)
        start, energy = start_s[row, receiver], energy_j[row, receiver]
        end = start + setup_s + energy / rate_w
        found.append(
            Moves(rows[row], giver[row], receiver, np.full(len(row), NONE), start, start, end, end, energy)
        )  # fmt: skip
    return found


def _load(arrays: Arrays, state: Beginnings, rows: Ints, giver: Ints, free_s: Floats, base: int) -> Moves:
    """A tanker loads all it can hold."""
    of, rate_w = arrays.m + base, arrays.base_rate_w[base]
    way = state.place_ned[rows, giver] - arrays.base_ned[base]
    way_s = np.sqrt(np.square(way).sum(axis=1)) / arrays.speed_m_s[giver] + 1e-3
    start_s = np.maximum(free_s + way_s, state.free_s[rows, of])
    held_j = state.spare_j[rows, giver] + arrays.tanker_power_w[giver] * (arrays.horizon_s - start_s)
    room_j = arrays.tanker_holds_j[giver] - held_j
    energy_j = np.minimum(np.minimum(room_j, state.spare_j[rows, of]) - MARGIN_J, LOADS_MOST_S * rate_w)
    end_s = start_s + arrays.setup_s + energy_j / rate_w
    may = np.flatnonzero((energy_j > LOADS_LEAST * arrays.tanker_holds_j[giver]) & (end_s < arrays.horizon_s - 10.0))
    at = np.full(len(may), base)
    start_s, end_s = start_s[may], end_s[may]
    return Moves(
        rows[may], giver[may], np.full(len(may), LOAD), at, start_s, start_s, end_s, end_s, energy_j[may]
    )  # fmt: skip


def _base_moves(
    arrays: Arrays, state: Beginnings, weights: Weights, rows: Ints, giver: Ints, free_s: Floats
) -> list[Moves]:
    """A receiver comes to a base: for a transfer, or to stay until the horizon."""
    n, horizon_s, power_w = arrays.n, arrays.horizon_s, arrays.power_w
    base = giver - arrays.m
    lands_s, each = state.lands_s[rows], np.arange(n)
    rate_w = arrays.base_rate_w[base][:, None]
    place = arrays.base_ned[base][:, None]
    leave_s = np.maximum(state.busy_s[rows], free_s[:, None])
    for _ in range(3):  # sooner, so that it comes when the base is free; its way changes with that
        way_s = np.sqrt(np.square(arrays.at(each, leave_s) - place).sum(axis=2)) / arrays.off_path_m_s + 1e-3
        leave_s = np.maximum(state.busy_s[rows], free_s[:, None] - way_s)
    way_s = np.sqrt(np.square(arrays.at(each, leave_s) - place).sum(axis=2)) / arrays.off_path_m_s + MEETS_LATER_S
    start_s = np.maximum(leave_s + way_s, free_s[:, None])
    lacks_j = power_w * (horizon_s - lands_s)
    stands_w = rate_w + power_w
    room_j = arrays.holds_j - power_w * (lands_s - start_s)
    full_j = np.minimum(room_j, state.spare_j[rows, giver][:, None]) - MARGIN_J
    lasts_j = (lacks_j - power_w * arrays.setup_s) * rate_w / stands_w + MARGIN_J
    energy_j = np.minimum(full_j, lasts_j)
    end_s = start_s + arrays.setup_s + energy_j / rate_w
    comes = (lands_s < horizon_s - 1e-6) & (lands_s >= start_s + LATER_S) & (start_s < horizon_s)
    may = comes & (energy_j > 0.0) & (end_s < horizon_s)
    may &= (energy_j >= lasts_j) | (energy_j > weights.room * arrays.holds_j)
    found = []
    for allowed, until_s, given_j in ((may, end_s, energy_j), (comes, np.full_like(end_s, horizon_s), 0.0 * energy_j)):
        row, receiver = np.nonzero(allowed)
        end = until_s[row, receiver]
        back_s = arrays.meets_s(receiver, end, place[row, 0], arrays.off_path_m_s[receiver])
        found.append(
            Moves(
                rows[row], giver[row], receiver, base[row], leave_s[row, receiver], start_s[row, receiver], end,
                back_s, given_j[row, receiver],
            )
        )  # fmt: skip
    return found


def grown_by(arrays: Arrays, state: Beginnings, moves: Moves, weights: Weights) -> Beginnings:
    """Each beginning with what was added to it."""
    grown = state.of(moves.row)
    each, giver = np.arange(len(moves.giver)), moves.giver
    serves, waits, loads = moves.receiver >= 0, moves.receiver == NONE, moves.receiver == LOAD
    row, receiver = each[serves], moves.receiver[serves]
    stood_s = np.where(giver >= arrays.m, moves.end_s - moves.start_s, 0.0)
    grown.lands_s[row, receiver] += moves.energy_j[serves] / arrays.power_w[receiver] + stood_s[serves]
    grown.busy_s[row, receiver] = moves.back_s[serves]
    grown.spare_j[row, giver[serves]] -= moves.energy_j[serves]
    grown.free_s[each, giver] = np.where(waits, moves.end_s + weights.wait_s, moves.end_s)
    flew = serves & (giver < arrays.m)
    grown.place_ned[each[flew], giver[flew]] = arrays.at(moves.receiver[flew], moves.end_s[flew])
    row, of, base = each[loads], giver[loads], moves.base[loads]
    stood_j = arrays.tanker_power_w[of] * (moves.end_s - moves.start_s)[loads]
    grown.spare_j[row, of] += moves.energy_j[loads] + stood_j
    grown.place_ned[row, of] = arrays.base_ned[base]
    grown.spare_j[row, arrays.m + base] -= moves.energy_j[loads]
    grown.free_s[row, arrays.m + base] = moves.end_s[loads]
    empty = grown.spare_j < LEAST_J
    empty[:, : arrays.m] &= np.all(grown.spare_j[:, arrays.m :] < LEAST_J, axis=1, keepdims=True)
    empty[:, arrays.m :] = False  # receivers can stand at it all the same
    grown.free_s[empty] = arrays.horizon_s
    return grown
