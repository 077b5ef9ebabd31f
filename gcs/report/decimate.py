"""Fewer points that draw the same curve: per bucket of time the smallest and the largest value, where they were.

A line drawn through them covers the same pixels as one through all, if a bucket is no wider than a pixel, and no
extreme is lost however few they are. Paths in space lose the points that lie next to the line through the others.
"""

from __future__ import annotations

import numpy as np
from cython.cimports.libc.math import isnan
from numpy.typing import NDArray

from gcs.recording.series import Floats, Series


def min_max(series: Series, buckets: int, begin_s: float, end_s: float) -> Series:
    """At most 2 points, or 3 with a gap, of each of `buckets` equal parts of [begin_s, end_s], in order of time.

    Of the values in a part the smallest and the largest are kept, each the first of its kind, and one NaN if there is
    any. A series of at most 2 points per bucket stays as it is. ValueError unless buckets > 0 and begin_s < end_s.
    """
    if buckets <= 0 or not begin_s < end_s:
        raise ValueError(f"{buckets} buckets from {begin_s} s to {end_s} s hold nothing")
    t_s, values = series
    if len(t_s) <= 2 * buckets:
        return series
    bucket = _bucket(t_s, buckets, begin_s, end_s)
    places = np.empty(len(values), np.int64)
    chosen = places[: _extremes(bucket, np.ascontiguousarray(values), places)]
    return Series(t_s[chosen], values[chosen])


def _bucket(t_s: Floats, buckets: int, begin_s: float, end_s: float) -> NDArray[np.int64]:
    """(k,) in which of the equal parts of [begin_s, end_s] each time lies; what is outside belongs to the nearest."""
    part = ((t_s - begin_s) * (buckets / (end_s - begin_s))).astype(np.int64)
    return np.minimum(np.maximum(part, 0), buckets - 1)


def _extremes(bucket: NDArray[np.int64], values: Floats, places: NDArray[np.int64]) -> int:
    """Write the places of the smallest value, the largest and the first NaN of each run of one bucket, ascending; how
    many there are."""
    size = values.shape[0]
    count = begin = 0
    while begin < size:
        least = greatest = gap = -1
        end = begin
        while end < size and bucket[end] == bucket[begin]:
            if isnan(values[end]):
                gap = end if gap < 0 else gap
            elif least < 0:
                least = greatest = end
            elif values[end] < values[least]:
                least = end
            elif values[end] > values[greatest]:
                greatest = end
            end += 1
        for k in range(begin, end):
            if k in (least, greatest, gap):
                places[count] = k
                count += 1
        begin = end
    return count


def band(many: list[Series], buckets: int, begin_s: float, end_s: float) -> tuple[Floats, Floats, Floats, Floats]:
    """(times, least, median, greatest), each (buckets,): over all series, in equal parts of [begin_s, end_s].

    Least and greatest are those of any value in a part; the median is that of the series' own means in it. NaN where
    a part is empty.
    """
    least, greatest = np.full(buckets, np.inf), np.full(buckets, -np.inf)
    means, sums = np.full((len(many), buckets), np.nan), np.empty((2, buckets))
    for row, (t_s, values) in enumerate(many):
        _spread(_bucket(t_s, buckets, begin_s, end_s), np.ascontiguousarray(values), least, greatest, sums, means[row])
    empty = least > greatest
    median = np.full(buckets, np.nan)
    if len(many):
        median[~empty] = np.nanmedian(means[:, ~empty], axis=0)
    least[empty] = greatest[empty] = np.nan
    middles_s: Floats = begin_s + (np.arange(buckets).astype(np.float64) + 0.5) * ((end_s - begin_s) / buckets)
    return middles_s, least, median, greatest


def _spread(
    bucket: NDArray[np.int64], values: Floats, least: Floats, greatest: Floats, sums: Floats, means: Floats
) -> None:
    """Widen least and greatest (buckets,) by a series' values, and set its means (buckets,) where it has any. What is
    NaN counts for nothing. sums (2, buckets): written."""
    buckets = means.shape[0]
    for b in range(buckets):
        sums[0, b] = sums[1, b] = 0.0
    for k in range(values.shape[0]):
        if not isnan(values[k]):
            b = bucket[k]
            least[b] = min(least[b], values[k])
            greatest[b] = max(greatest[b], values[k])
            sums[0, b] += 1.0
            sums[1, b] += values[k]
    for b in range(buckets):
        if sums[0, b] > 0.0:
            means[b] = sums[1, b] / sums[0, b]
