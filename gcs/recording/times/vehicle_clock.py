"""Clocks of the vehicles in a recording, held against the stamps of its frames: at which rate the stamps pass, and
where a clock leaps though they do not. Times are µs; rows are frames. All [choice]."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

IntArray = NDArray[np.int64]

SECOND_US = 1_000_000
FEW = 5
"""So many frames in a row may have wrong times; more are a step of a clock."""
LEAP_US = 3600 * SECOND_US
DISAGREE_US = 10 * SECOND_US
"""Stamps may pass a vehicle's clock by so much over a silence: frames come late, and simulations pause."""
MOST_OFF = 1.25
"""Rates that differ by more are no drift: crystals keep to 0.01 %, oscillators without one to 5 %."""
SHORTEST_US = 5 * SECOND_US
"""Rates are taken over windows of so much of a vehicle's time, and of twice as much again and again."""
WINDOWS = 3
"""So many windows are needed, of which one may hold a step of the recorder's clock."""
OTHER_UNITS = (1e-6, 1e-3, 1e3, 1e6)
"""Rates of clocks that do not count in the unit of their field."""


class VehicleClock(NamedTuple):
    """One sender's times since its start: at which frames, (k,) ascending, and the times, (k,) µs."""

    rows: IntArray
    boot_us: IntArray


class WrongRate(NamedTuple):
    """Rate at which stamps pass, in a unit of the time of a vehicle, whose clock this is."""

    rate: float
    clock: VehicleClock


def wrong_rate(stamps_us: IntArray, clocks: Sequence[VehicleClock]) -> WrongRate | None:
    """The rate of stamps, (n,), by the first clock, where it is far from 1 by every clock that says enough, and much
    the same by all; else None."""
    found = [(one, clock) for clock in clocks for one in _rates(stamps_us, clock)]
    rates = [one for one, _ in found]
    if not found or not (min(rates) > MOST_OFF or max(rates) < 1.0 / MOST_OFF):
        return None
    return WrongRate(*found[0]) if max(rates) <= MOST_OFF * min(rates) else None


def _rates(stamps_us: IntArray, clock: VehicleClock) -> Iterator[float]:
    """The median rate over windows of each length, the longest first: frames that come in bursts pass at a wrong rate
    in short ones, and a step of the recorder's clock is in few."""
    boot_us, own_us = clock.boot_us, stamps_us[clock.rows]
    found: list[float] = []
    window_us = SHORTEST_US
    while len(boot_us):
        number = boot_us // window_us
        begins = np.flatnonzero(np.diff(number, prepend=number[0] - 1))
        boot_us, own_us = boot_us[begins], own_us[begins]
        passed_us, stamped_us = np.diff(boot_us), np.diff(own_us)
        whole = (2 * passed_us >= window_us) & (stamped_us > 0)
        if whole.sum() < WINDOWS:
            break
        found.append(float(np.median(stamped_us[whole] / passed_us[whole])))
        window_us *= 2
    units = any(1.0 / MOST_OFF <= one / unit <= MOST_OFF for one in found for unit in OTHER_UNITS)
    yield from () if units else reversed(found)


def followed(times_us: IntArray, clock: VehicleClock) -> IntArray:
    """Times, (n,), that pass as a clock does where it was heard, and as `times_us` before, after, and where the clock
    begins anew; the first one is kept."""
    since_us = np.cumsum(np.maximum(np.diff(times_us, prepend=times_us[:1]), 0))
    received_us = since_us[clock.rows]
    passed_us = np.diff(clock.boot_us)
    passed_us = np.where((passed_us >= 0) & (passed_us <= LEAP_US), passed_us, np.diff(received_us))
    going_us = received_us[0] + np.cumsum(passed_us, dtype=np.int64)
    going_us = np.concatenate((received_us[:1], going_us))
    within_us = np.rint(np.interp(since_us, received_us, going_us)).astype(np.int64)
    after_us = np.maximum(since_us - received_us[-1], 0)
    before = since_us < received_us[0]
    return np.asarray(times_us[0] + np.where(before, since_us, within_us + after_us), dtype=np.int64)


def disagree(stamps_us: IntArray, clocks: Sequence[VehicleClock]) -> bool:
    """Whether the stamps, (n,), pass at another rate than the clocks, or one leaps where they do not."""
    leap = any((_ahead_us(stamps_us, clock) > DISAGREE_US).any() for clock in clocks)
    return leap or wrong_rate(stamps_us, clocks) is not None


def leaps(stamps_us: IntArray, clocks: Sequence[VehicleClock]) -> list[int]:
    """Rows at which a clock is ahead of the stamps, (n,), by more than before, for good: the recorder's clock was set
    back so that nothing is seen of it, or what came first was late."""
    rows: set[int] = set()
    for clock in clocks:
        if len(clock.rows) < 2 * FEW:
            continue
        ahead_us = np.lib.stride_tricks.sliding_window_view(clock.boot_us - stamps_us[clock.rows], FEW)
        least_us, most_us = ahead_us.min(axis=1), ahead_us.max(axis=1)
        step_us, steady = least_us[FEW:] - most_us[:-FEW], most_us - least_us < DISAGREE_US
        found = (step_us > DISAGREE_US) & (step_us <= LEAP_US) & steady[FEW:] & steady[:-FEW]
        rows.update(clock.rows[FEW:][: len(found)][found].tolist())
    return sorted(rows)


def _ahead_us(stamps_us: IntArray, clock: VehicleClock) -> IntArray:
    """By how much more than the stamps a clock passes from each of its times to the next; (k - 1,)."""
    passed_us = np.diff(clock.boot_us)
    return np.where(passed_us > 0, passed_us - np.diff(stamps_us[clock.rows]), 0)
