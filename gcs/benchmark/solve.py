"""All that is known of an instance's optimum: a proven bound, and a schedule that the verifier accepts.

One thread, and limits by its processor time, so that a busy machine changes no result.
"""

from __future__ import annotations

import math
import random
import time
from collections.abc import Callable, Iterator

from gcs.benchmark import beam, bounds
from gcs.benchmark.arrays import Arrays
from gcs.benchmark.beam import PORTFOLIO, Weights
from gcs.benchmark.format import SCHEDULE, Instance, Schedule, plain
from gcs.benchmark.gaps import Gap
from gcs.benchmark.verifier import verify

WIDTHS = (40, 150, 500, 1500)
BOUNDS_SHARE = 0.5
"""[choice] Of the time, for the bound at most; it is looked for after the narrowest searches."""


def solve(
    instance: Instance, seconds: float, least_lost: Callable[[Arrays, int, float], int] = bounds.least_lost
) -> tuple[Gap, Schedule]:
    """Search until the bound is met, or for so many seconds of processor time; where none is found that can be carried
    out, the gap has no upper bound and the schedule is empty. Raises MissingExtra where a schedule loses a receiver and
    OR-Tools is not installed: one that loses none proves itself."""
    began_s = time.process_time()
    arrays, lower = Arrays(instance), 0
    best = Schedule(SCHEDULE, instance.name, [])
    upper = lost_of(instance, best)
    if not arrays.m + arrays.k:  # without a giver it is the only one
        return Gap(instance.name, int(upper), int(upper), round(time.process_time() - began_s, 2)), best
    bounded = False
    for weights, width in _tries(instance.seed):
        if width > WIDTHS[0] and upper > 0 and not bounded:
            lower, bounded = least_lost(arrays, int(min(upper, arrays.n)), BOUNDS_SHARE * seconds), True
        if upper <= lower or time.process_time() - began_s > seconds:
            break
        found = beam.search(arrays, weights, width, began_s + seconds)
        if (lost := lost_of(instance, found)) < upper:
            best, upper = found, int(lost)
    fewest = int(upper) if math.isfinite(upper) else None
    return Gap(instance.name, lower, fewest, round(time.process_time() - began_s, 2)), best


def searched(arrays: Arrays, seconds: float) -> Schedule:
    """The best schedule that beam search finds in so many seconds of processor time, without a bound."""
    return solve(arrays.instance, seconds, lambda *_: 0)[1]


def lost_of(instance: Instance, schedule: Schedule) -> float:
    """How many a schedule loses by the verifier; infinitely many where it cannot be carried out."""
    verdict = verify(plain(instance), plain(schedule))
    return len(verdict["lost"]) if verdict["feasible"] else math.inf


def _tries(seed: int) -> Iterator[tuple[Weights, int]]:
    """Ways to search, ever wider ones, and other weights each time."""
    draw = random.Random(seed)
    for width in WIDTHS:
        for weights in (*PORTFOLIO, *([_drawn(draw) for _ in PORTFOLIO] if width > WIDTHS[0] else [])):
            yield weights, width
    while True:
        yield _drawn(draw), draw.choice(WIDTHS[1:])


def _drawn(draw: random.Random) -> Weights:
    return Weights(
        lost=draw.choice((1.0, 3.0, 5.0)), way_s=draw.choice((1.0, 2.0, 3.0)), late=draw.choice((0.0, 0.1, 0.3)),
        near=draw.choice((0.1, 0.2, 0.4, 0.8)), near_s=draw.choice((5.0, 10.0, 20.0)),
        work=draw.choice((0.05, 0.1, 0.2)), time=draw.choice((0.0, 0.01, 0.03)), share=draw.choice((0.0, 0.4, 0.55)),
        room=draw.choice((0.3, 0.5, 0.65)), window_s=draw.choice((2.0, 4.0)), wait_s=draw.choice((2.0, 3.0)),
    )  # fmt: skip
