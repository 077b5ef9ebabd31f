"""A recording's times, judged as a whole: the stamps of the frames, held against the clocks of the vehicles in them.

Frames stand in a recording in the order of their arrival, so that true times do not fall. Stamps do, or leap, where the
recorder's clock was set, where it has none, or where bytes are wrong. Stamps are cut into runs, at each fall and each
silence, and then

1. a few frames that fit neither those before nor those behind have wrong stamps: the time of the frame before holds;
2. from one run to the next as much time passes as the stamps say, unless a vehicle's clock (time_boot_ms) on both sides
   says otherwise: that is a step of the recorder's clock. Without a vehicle's clock a fall is a step, and so is a leap
   that undoes one or is undone later, or that begins or ends at no time of MAVLink's;
3. in a recording without stamps, or whose stamps all stand still, a vehicle's clock counts; so it does where stamps
   pass at another rate than the vehicles' clocks (vehicle_clock.py).

The run with the most frames keeps its stamps; the others follow from it. Times are µs; rows are frames. All [choice].
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gcs.recording.times import vehicle_clock
from gcs.recording.times.vehicle_clock import DISAGREE_US, FEW, LEAP_US, SECOND_US, IntArray, VehicleClock, followed

FALL_US = 100_000
"""Stamps may fall by so much: recorders of several links write them out of order."""
SILENCE_US = 2 * SECOND_US
WORTH_SAYING_US = 10 * SECOND_US
NAMED = 3
NO_STAMP = -1
EARLIEST_US, NEVER_US = 1_230_768_000 * SECOND_US, 4_102_444_800 * SECOND_US
"""MAVLink is of 2009; no recording is of 2100."""
LATEST_US = 1 << 61
"""No stamp is later; sums of two are whole numbers of 64 bits then."""


class JudgedTimes(NamedTuple):
    """Times that hold, (n,) µs, and what was found: sentences without the recording's name."""

    times_us: IntArray
    notes: list[str]


class _Run(NamedTuple):
    """Frames whose stamps follow each other: rows [begin, end)."""

    begin: int
    end: int


def suspicious(stamps_us: IntArray) -> bool:
    """Whether these stamps, (n,), fall, stand still, are missing, or leave silences, so that `judged` has to look."""
    if len(stamps_us) < 2:
        return bool((stamps_us == NO_STAMP).any())
    passed = np.diff(stamps_us)
    still = stamps_us[-1] == stamps_us[0] and len(stamps_us) > FEW
    return bool(still or (stamps_us == NO_STAMP).any() or passed.min() < -FALL_US or passed.max() > SILENCE_US)


def judged(stamps_us: IntArray, clocks: Sequence[VehicleClock], *, session: bool = False) -> JudgedTimes:
    """The times of frames by their stamps, (n,) µs, NO_STAMP where a frame has none, and the clocks in them.

    session: the stamps are a session's own time, at whatever rate its vehicles' clocks pass.
    """
    n = len(stamps_us)
    if 2 * int((stamps_us != NO_STAMP).sum()) < n or (n > FEW and (stamps_us == stamps_us[0]).all()):
        return _by_clocks(n, clocks)
    possible = (stamps_us >= 0) & (stamps_us < LATEST_US)
    wrong = ~possible & (stamps_us != NO_STAMP)
    stamps_us = _filled(stamps_us, possible)
    wrong_rate = None if session else vehicle_clock.wrong_rate(stamps_us, clocks)
    if wrong_rate is not None:
        stamps_us = stamps_us[0] + np.rint((stamps_us - stamps_us[0]) / wrong_rate.rate).astype(np.int64)
    misfits = _misfits(stamps_us, _runs(stamps_us))
    stamps_us = _filled(stamps_us, ~misfits)
    runs = _runs(stamps_us, () if session else vehicle_clock.leaps(stamps_us, clocks))
    count = int((wrong | misfits).sum())
    notes = [] if wrong_rate is None else [_of_rate(wrong_rate.rate)]
    notes += [_of_wrong(count)] if count else []
    times = _joined(stamps_us, runs, clocks, notes)
    return times if wrong_rate is None else times._replace(times_us=followed(times.times_us, wrong_rate.clock))


def _by_clocks(n: int, clocks: Sequence[VehicleClock]) -> JudgedTimes:
    """Times by the vehicle that said the most of its clock; from 0 on where none did."""
    clock = max(clocks, key=lambda one: len(one.rows), default=None)
    if clock is None or not len(clock.rows):
        return JudgedTimes(np.zeros(n, dtype=np.int64), ["its frames have no times, and no vehicle in it says its own"])
    times_us = _by_clock(clock, 0, n)
    return JudgedTimes(times_us - times_us[0], ["its frames have no times: they have those of the vehicle's own clock"])


def _by_clock(clock: VehicleClock, begin: int, end: int) -> IntArray:
    """Times of rows [begin, end) straight on between what a clock said; a clock that begins anew goes on."""
    passed = np.diff(clock.boot_us, prepend=clock.boot_us[:1])
    going_us = np.cumsum(np.maximum(passed, 0))
    between_us = np.interp(np.arange(begin, end), clock.rows, going_us)
    return np.asarray(np.rint(between_us), dtype=np.int64)


def _filled(stamps_us: IntArray, good: NDArray[np.bool_]) -> IntArray:
    """Stamps, those that are not good replaced by the last good one before, or the first of all."""
    if good.all() or not good.any():
        return stamps_us
    row = np.where(good, np.arange(len(good)), -1)
    last = np.maximum.accumulate(row)
    return np.asarray(stamps_us[np.where(last < 0, int(np.argmax(good)), last)], dtype=np.int64)


def _runs(stamps_us: IntArray, leaps: Sequence[int] = ()) -> list[_Run]:
    """Runs, cut also at the rows of `leaps`."""
    passed = np.diff(stamps_us)
    cuts = (np.flatnonzero((passed < -FALL_US) | (passed > SILENCE_US)) + 1).tolist()
    cuts = sorted({*cuts, *leaps} - {0})
    return [_Run(begin, end) for begin, end in pairwise([0, *cuts, len(stamps_us)])]


def _misfits(stamps_us: IntArray, runs: Sequence[_Run]) -> NDArray[np.bool_]:
    """(n,) whether a frame's stamp fits neither those before nor those behind, few in a row."""
    misfits = np.zeros(len(stamps_us), dtype=np.bool_)
    kept = set(_longest_chain(stamps_us, runs))
    at = 0
    while at < len(runs):
        if at in kept:
            at += 1
            continue
        episode = at
        while at < len(runs) and at not in kept:
            at += 1
        begin, end = runs[episode].begin, runs[at - 1].end
        if end - begin <= FEW:
            misfits[begin:end] = True
    for leap, rest in _lonely(stamps_us, [runs[k] for k in sorted(kept)]):
        misfits[leap:rest] = True
    return misfits


def _lonely(stamps_us: IntArray, chain: Sequence[_Run]) -> Iterator[tuple[int, int]]:
    """Rows of few frames at either end of a chain that a leap parts from the rest."""
    while len(chain) > 1:
        first, last = chain[0], chain[-1]
        if last.end - last.begin <= FEW and stamps_us[last.begin] - stamps_us[chain[-2].end - 1] > LEAP_US:
            yield last
            chain = chain[:-1]
        elif first.end - first.begin <= FEW and stamps_us[chain[1].begin] - stamps_us[first.end - 1] > LEAP_US:
            yield first
            chain = chain[1:]
        else:
            return


def _longest_chain(stamps_us: IntArray, runs: Sequence[_Run]) -> list[int]:
    """Of the runs those that can all be in order: their stamps do not fall from one to the next, and their frames are
    the most, with the shorter silence where two are equal. By the heaviest increasing subsequence, with a Fenwick tree
    over the last stamps."""
    ends_us = np.array([stamps_us[run.end - 1] for run in runs])
    begins_us = np.array([stamps_us[run.begin] for run in runs])
    order_us = np.unique(ends_us)
    tree: list[tuple[int, int, int]] = [(0, 0, -1)] * (len(order_us) + 1)
    before, weights = [-1] * len(runs), [0] * len(runs)
    below = np.searchsorted(order_us, begins_us + FALL_US, side="right").tolist()
    places, last_us = (np.searchsorted(order_us, ends_us) + 1).tolist(), ends_us.tolist()
    for k, run in enumerate(runs):
        heaviest, at = (0, 0, -1), below[k]
        while at > 0:
            heaviest = max(heaviest, tree[at])
            at -= at & -at
        before[k], weights[k] = heaviest[2], heaviest[0] + run.end - run.begin
        at = places[k]
        while at <= len(order_us):
            tree[at] = max(tree[at], (weights[k], last_us[k], k))
            at += at & -at
    chain, k = [], max(range(len(runs)), key=weights.__getitem__, default=-1)
    while k >= 0:
        chain.append(k)
        k = before[k]
    return chain[::-1]


def _joined(stamps_us: IntArray, runs: Sequence[_Run], clocks: Sequence[VehicleClock], notes: list[str]) -> JudgedTimes:
    """Times of runs, one behind the other."""
    times_us = np.empty(len(stamps_us), dtype=np.int64)
    steps: list[tuple[int, int]] = []
    silences: list[tuple[int, int]] = []
    fallen_us = 0
    for k, run in enumerate(runs):
        own_us = stamps_us[run.begin : run.end]
        if k == 0:
            begin_us = int(own_us[0])
        else:
            said_us = int(stamps_us[run.begin] - stamps_us[run.begin - 1])
            passed_us = _by_clocks_of(stamps_us, runs[k - 1], run, said_us, clocks)
            if passed_us is None:
                passed_us = _by_stamps(stamps_us, runs, k, said_us, fallen_us)
                fallen_us += passed_us - said_us if said_us < 0 or passed_us == 0 else 0
            begin_us = int(times_us[run.begin - 1]) + passed_us
            if abs(said_us - passed_us) > FALL_US:
                steps.append((run.begin, said_us - passed_us))
            if passed_us >= WORTH_SAYING_US:
                silences.append((run.begin, passed_us))
        times_us[run.begin : run.end] = own_us - own_us[0] + begin_us
    longest = max(runs, key=lambda run: run.end - run.begin)
    times_us += stamps_us[longest.begin] - times_us[longest.begin]
    since_us = times_us - times_us[0]
    if steps:
        told = [
            f"{'ahead' if by > 0 else 'back'} by {_span(abs(by))} at {since_us[row] / 1e6:.1f} s" for row, by in steps
        ]
        notes.append(f"its recorder's clock was set {_few(told)}; times go on as the vehicles' clocks do")
    if silences:
        told = [f"for {_span(length)} until {since_us[row] / 1e6:.1f} s" for row, length in silences]
        notes.append(f"nothing was recorded {_few(told)}")
    return JudgedTimes(times_us, notes)


def _by_clocks_of(
    stamps_us: IntArray, before: _Run, run: _Run, said_us: int, clocks: Sequence[VehicleClock]
) -> int | None:
    """Time from the last frame of the run before to the first of this one, which is `said_us` by their stamps, by the
    vehicles' clocks; None where none was heard in both."""
    by_clocks = [by for clock in clocks if (by := _by_vehicle(stamps_us, before, run, clock)) is not None]
    if not by_clocks:
        return None
    nearest_us = min(by_clocks, key=lambda passed_us: abs(passed_us - said_us))
    agrees = said_us >= -FALL_US and abs(nearest_us - said_us) <= DISAGREE_US
    return max(said_us if agrees else nearest_us, 0)


def _by_stamps(stamps_us: IntArray, runs: Sequence[_Run], k: int, said_us: int, fallen_us: int) -> int:
    """The same by the stamps alone; `fallen_us`: by how much they have been found to have fallen before."""
    before_us, begin_us = int(stamps_us[runs[k].begin - 1]), int(stamps_us[runs[k].begin])
    if said_us <= LEAP_US // 2:
        return max(said_us, 0)
    undoes = abs(said_us - fallen_us) <= SILENCE_US
    impossible = not all(EARLIEST_US <= at_us < NEVER_US for at_us in (before_us, begin_us))
    undone = any(-FALL_US <= stamps_us[later.begin] - before_us <= LEAP_US for later in runs[k + 1 :])
    return 0 if undoes or impossible or undone else said_us


def _by_vehicle(stamps_us: IntArray, before: _Run, run: _Run, clock: VehicleClock) -> int | None:
    """The same by a clock that was heard in both runs and did not begin anew; None where there is none."""
    at = int(np.searchsorted(clock.rows, run.begin))
    if not 0 < at < len(clock.rows):
        return None
    row, next_row = int(clock.rows[at - 1]), int(clock.rows[at])
    vehicle_us = int(clock.boot_us[at] - clock.boot_us[at - 1])
    if row < before.begin or next_row >= run.end or vehicle_us < 0:
        return None
    around_us = (stamps_us[run.begin - 1] - stamps_us[row]) + (stamps_us[next_row] - stamps_us[run.begin])
    return max(vehicle_us - int(around_us), 0)


def _of_rate(rate: float) -> str:
    times = f"{rate:.3g} times as fast as" if rate > 1.0 else f"{1.0 / rate:.3g} times as slowly as"
    return f"its stamps pass {times} the vehicles' own clocks; it has the times of these"


def _of_wrong(count: int) -> str:
    if count == 1:
        return "one frame has a time that cannot be: it has the time of the frame before"
    return f"{count} frames have times that cannot be: each has the time of the frame before"


def _few(told: Sequence[str]) -> str:
    more = f" and {len(told) - NAMED} times more" if len(told) > NAMED else ""
    return ", ".join(told[:NAMED]) + more


def _span(us: int) -> str:
    seconds = us / 1e6
    for unit, length_s in (("years", 31_557_600.0), ("days", 86_400.0), ("h", 3600.0)):
        if seconds >= 1.5 * length_s or (unit == "h" and seconds >= length_s):
            return f"{seconds / length_s:.1f} {unit}"
    return f"{seconds:.1f} s"
