"""Statistics of a campaign's table: rates with Wilson intervals, means and paired differences with bootstrap ones."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gcs.campaign import measures
from gcs.campaign.plan import Plan

if TYPE_CHECKING:
    import pyarrow as pa

CONFIDENCE = 0.95
RESAMPLES = 2000
SEED = 1
"""Of the resampling: the same table gives the same page."""

ERRORS_STAY = (
    "Sessions with an error count as failed, and gcs campaign resume leaves them so; gcs campaign resume --errors DIR "
    "flies them again."
)

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Interval:
    """An estimate and its 95 % interval."""

    value: float
    low: float
    high: float


def wilson(count: int, of: int, confidence: float = CONFIDENCE) -> Interval:
    """A rate and its Wilson score interval (E. B. Wilson, J. Am. Stat. Assoc. 22, 1927)."""
    if of == 0:
        return Interval(math.nan, 0.0, 1.0)
    z = NormalDist().inv_cdf(0.5 + confidence / 2.0)
    rate = count / of
    middle = (rate + z * z / (2.0 * of)) / (1.0 + z * z / of)
    half = z / (1.0 + z * z / of) * math.sqrt(rate * (1.0 - rate) / of + z * z / (4.0 * of * of))
    low, high = max(0.0, middle - half), min(1.0, middle + half)
    return Interval(rate, 0.0 if count == 0 else low, 1.0 if count == of else high)


def mean(values: Floats) -> Interval:
    """A mean and its bootstrap interval, by percentiles; of fewer than three values there is none."""
    from scipy.stats import bootstrap  # noqa: PLC0415 - of the extra, and only a page of results needs it

    values = values[np.isfinite(values)]
    if len(values) == 0:
        return Interval(math.nan, math.nan, math.nan)
    centre = float(values.mean())
    if len(values) < 3 or np.ptp(values) == 0.0:
        spread = (math.nan, math.nan) if len(values) < 3 else (centre, centre)
        return Interval(centre, *spread)
    rng = np.random.default_rng(SEED)
    found = bootstrap(
        (values,), np.mean, confidence_level=CONFIDENCE, n_resamples=RESAMPLES, method="percentile", rng=rng
    )
    return Interval(centre, float(found.confidence_interval.low), float(found.confidence_interval.high))


@dataclass(frozen=True)
class PairedDifference:
    """A measure's paired difference between two combinations: the second less the first."""

    pairs: int
    difference: Interval
    effect: float
    """mean difference over its standard deviation (Cohen's d of paired samples)"""
    sessions_needed: int | None
    """pairs by which an effect of this size would be distinguished from none, at 95 % confidence with 80 % power"""


def paired(rows: pa.Table, measure: str, first: int, second: int) -> PairedDifference:
    """The difference in the sessions that both combinations have flown."""
    session, combination = (np.array(rows[name].to_pylist(), dtype=np.int64) for name in ("session", "combination"))
    values = numbers(rows, measure)
    mine, theirs = (
        dict(zip(session[combination == c], values[combination == c], strict=True)) for c in (first, second)
    )
    changes = np.array([theirs[s] - mine[s] for s in sorted(mine.keys() & theirs.keys())], dtype=np.float64)
    changes = changes[np.isfinite(changes)]
    deviation = float(changes.std(ddof=1)) if len(changes) > 1 else math.nan
    effect = float(changes.mean()) / deviation if deviation > 0.0 else math.nan
    needed = None
    if math.isfinite(effect) and effect != 0.0:
        z = NormalDist().inv_cdf(0.5 + CONFIDENCE / 2.0) + NormalDist().inv_cdf(0.8)
        needed = math.ceil((z / effect) ** 2) + 1
    return PairedDifference(len(changes), mean(changes), effect, needed)


def numbers(rows: pa.Table, measure: str) -> Floats:
    """A measure's values; nan where there is none, and 1 for `met` of an outcome."""
    listed = rows[measure].to_pylist()
    if measures.is_word(measure):
        listed = [None if value is None else float(value == "met") for value in listed]
    return np.array([math.nan if value is None else value for value in listed], dtype=np.float64)


def name_of(plan: Plan, combination: int) -> str:
    """A combination's values in words, of mappings what differs between them, each by the last part of its key path and
    as much before it as tells it from the others; empty where nothing is varied."""
    row, vary = plan.row(combination), plan.campaign.vary
    names = _short([path for key, values in vary.items() for path in _paths(key, values)])
    words = []
    for key, values in vary.items():
        value = row.values[key]
        if isinstance(value, Mapping):
            words += [f"{names[f'{key}.{k}']} {value[k]}" for k in _differing(value, values)] or [names[key]]
        else:
            words.append(f"{names[key]} {value}")
    return ", ".join(words)


def _paths(key: str, values: Sequence[Any]) -> list[str]:
    """Key paths by which a key's values are named."""
    inner = [f"{key}.{k}" for value in values if isinstance(value, Mapping) for k in _differing(value, values)]
    return list(dict.fromkeys([key, *inner]))


def _differing(value: Mapping[str, Any], values: Sequence[Any]) -> list[str]:
    """Keys of a mapping that not all of the values have as it has them."""
    return [k for k in value if any(not isinstance(v, Mapping) or v.get(k) != value[k] for v in values)]


def _short(paths: Sequence[str]) -> dict[str, str]:
    """By key path its last parts: as few as no other one ends with, the first of them no number."""
    short = {}
    for path in paths:
        parts = path.split(".")
        ends = [".".join(parts[i:]) for i in reversed(range(len(parts))) if not parts[i].isdecimal()]
        others = [f".{other}" for other in paths if other != path]
        short[path] = next((end for end in ends if not any(one.endswith(f".{end}") for one in others)), path)
    return short


def summary(plan: Plan, rows: pa.Table) -> dict[str, Any]:
    """Each combination's success rate with its interval of 95 %, how many of its sessions ended with an error, which
    are no success, and the means of its numbers; None: no number came."""
    campaign = plan.campaign
    ok, errors = rows["ok"].to_pylist(), rows["error"].to_pylist()
    combination = np.array(rows["combination"].to_pylist(), dtype=np.int64)
    columns = {name: numbers(rows, name) for name in campaign.measured if not measures.is_word(name)}
    combinations = []
    for number in range(campaign.combinations):
        of = np.flatnonzero(combination == number)
        good = sum(bool(ok[i]) for i in of)
        failed = sum(errors[i] is not None for i in of)
        rate = wilson(good, len(of))
        means = {name: float(np.nanmean(v[of])) if np.isfinite(v[of]).any() else None for name, v in columns.items()}
        name = name_of(plan, number) or campaign.name
        counts = {"ok": good, "of": len(of), "errors": failed}
        combinations.append({"name": name, **counts, "low": rate.low, "high": rate.high, "means": means})
    return {
        "campaign": campaign.name, "sessions": rows.num_rows, "planned": plan.rows, "combinations": combinations
    }  # fmt: skip


def text(plan: Plan, rows: pa.Table) -> list[str]:
    """The summary as a table for terminals."""
    found = summary(plan, rows)["combinations"]
    lines = [("", "ok", "95 %", "errors", *found[0]["means"])]
    for one in found:
        cells = ["-" if mean is None else f"{mean:.4g}" for mean in one["means"].values()]
        interval = f"{100 * one['low']:.1f} to {100 * one['high']:.1f} %"
        lines.append((one["name"], f"{one['ok']} of {one['of']}", interval, one["errors"], *cells))
    return [*aligned(lines), *([ERRORS_STAY] if any(one["errors"] for one in found) else [])]


def aligned(lines: Sequence[Sequence[Any]]) -> list[str]:
    """Rows of words in columns."""
    widths = [max(len(str(line[i])) for line in lines) for i in range(len(lines[0]))]
    return [
        "  ".join(f"{word!s:<{width}}" for word, width in zip(line, widths, strict=True)).rstrip() for line in lines
    ]
