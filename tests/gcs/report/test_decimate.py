"""Decimation: what is left out must not be seen, whatever the series."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from gcs.recording.series import Series
from gcs.report.decimate import band, min_max
from gcs.report.pack import Pack

values = arrays.arrays(
    np.float64, st.integers(1, 400), elements=st.floats(-1e6, 1e6) | st.just(float("nan")), fill=st.nothing()
)


@settings(max_examples=40)
@given(values, st.integers(1, 60))
def test_every_pixel_keeps_its_extremes_and_its_gap(y: np.ndarray, buckets: int) -> None:
    t = np.linspace(0.0, 60.0, len(y), endpoint=False)
    kept = min_max(Series(t, y), buckets, 0.0, 60.0)
    assert len(kept.t_s) <= max(3 * buckets, len(y) if len(y) <= 2 * buckets else 0)
    assert (np.diff(kept.t_s) > 0.0).all()
    original = dict(zip(t.tolist(), y.tolist(), strict=True))
    assert np.array_equal([original[s] for s in kept.t_s.tolist()], kept.values, equal_nan=True)
    edges = np.floor(t * (buckets / 60.0)).clip(0, buckets - 1)
    kept_edges = np.floor(kept.t_s * (buckets / 60.0)).clip(0, buckets - 1)
    for bucket in np.unique(edges):
        before, after = y[edges == bucket], kept.values[kept_edges == bucket]
        assert np.isnan(before).any() == np.isnan(after).any()
        if not np.isnan(before).all():
            assert (np.nanmin(before), np.nanmax(before)) == (np.nanmin(after), np.nanmax(after))


def test_one_spike_among_a_million_values_survives() -> None:
    t = np.arange(1_000_000) * 1e-3
    y = np.sin(t)
    y[654_321] = 40.0
    kept = min_max(Series(t, y), 1000, 0.0, 1000.0)
    assert len(kept.t_s) <= 2000
    assert kept.t_s[kept.values.argmax()] == t[654_321]


def test_a_short_series_stays_as_it_is() -> None:
    series = Series(np.array([0.0, 5.0, 6.0]), np.array([1.0, np.nan, 2.0]))
    assert min_max(series, 2, 0.0, 10.0) is series


@pytest.mark.parametrize(("buckets", "begin_s", "end_s"), [(0, 0.0, 1.0), (5, 1.0, 1.0), (5, 2.0, 1.0)])
def test_no_pixels_and_no_time_are_refused(buckets: int, begin_s: float, end_s: float) -> None:
    with pytest.raises(ValueError, match="hold nothing"):
        min_max(Series(np.zeros(3), np.zeros(3)), buckets, begin_s, end_s)


def test_a_band_holds_the_extremes_of_all_and_the_median_of_each() -> None:
    """Constant lines at 0 … 10: in every bucket least 0, greatest 10, median 5, but for one spike and one silence."""
    t = np.arange(0.0, 10.0, 0.1)
    lines = [Series(t, np.full(100, float(k))) for k in range(11)]
    lines[3].values[55] = 99.0
    t_s, least, median, greatest = band([Series(s.t_s[s.t_s < 8.0], s.values[s.t_s < 8.0]) for s in lines], 10, 0, 10)
    assert t_s == pytest.approx(np.arange(10) + 0.5)
    assert np.array_equal(least, [0.0] * 8 + [np.nan] * 2, equal_nan=True)
    assert np.array_equal(greatest, [10.0] * 5 + [99.0] + [10.0] * 2 + [np.nan] * 2, equal_nan=True)
    assert median[:5] == pytest.approx(5.0)


@settings(max_examples=40)
@given(values)
def test_packed_values_are_right_to_the_scale_and_exact_at_its_ends(y: np.ndarray) -> None:
    """Read back as the page's script does it."""
    pack = Pack(0.0, 10.0)
    place = pack.line(Series(np.linspace(0.0, 10.0, len(y)), y))
    raw = np.frombuffer(bytes(pack._bytes), dtype="<u2")
    t, told = raw[: place["n"]], raw[place["n"] :]
    assert t[0] == 0
    assert len(t) == 1 or t[-1] == 65534
    assert np.array_equal(told == 65535, np.isnan(y))
    if not np.isnan(y).all():
        back = place["low"] + told * ((place["high"] - place["low"]) / 65534)
        span = np.nanmax(y) - np.nanmin(y)
        assert (place["low"], place["high"]) == (np.nanmin(y), np.nanmax(y))
        assert np.nanmax(np.abs(np.where(np.isnan(y), np.nan, back - y))) <= 0.5001 * span / 65534 + 1e-9
