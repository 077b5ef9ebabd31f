"""The paper's claims and how they are judged: claims.yaml and later_claims.yaml, a measurement each, a verdict each.

The tables say what is accepted before anything is measured; this module only applies it. Why a claim differs is said by
reasons.yaml.
"""

from __future__ import annotations

import itertools
import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from types import MappingProxyType
from typing import Any, Literal, get_args

import yaml

from gcs.report.paper.study import Measurement, Value

Verdict = Literal["agrees", "differs", "cannot be compared"]
Why = Literal["the paper contradicts itself", "not determined by the text", "our criterion", "a real difference"]
SCHEMA = 1
FIRST, LATER, REASONS = "claims.yaml", "later_claims.yaml", "reasons.yaml"


@dataclass(frozen=True)
class Claim:
    """One row of claims.yaml; `accept` is its tolerance for the machine."""

    id: str
    figure: str
    part: str
    claim: str
    paper: str
    tolerance: str
    criterion: str
    accept: Mapping[str, Any] | None
    ours: str = ""
    """what of it is this project's and not the paper's"""
    later: bool = False
    """whether it is of the second table"""


@dataclass(frozen=True)
class Reason:
    """Why a claim differs."""

    reason: Why
    because: str


REAL = Reason("a real difference", "none of the other reasons explains it")


@dataclass(frozen=True)
class Judged:
    """A claim with its measurement and verdict; a reason where it differs."""

    claim: Claim
    value: Value
    verdict: Verdict
    why: str
    reason: Reason | None = None

    @property
    def line(self) -> str:
        """For a terminal: where the paper says what, and the first reason of the verdict."""
        where = f"Fig. {self.claim.figure}" if self.claim.figure[0].isdecimal() else self.claim.figure
        reason = f" ({self.reason.reason})" if self.reason else ""
        return f"{where}: {self.claim.claim} Here {self.why.partition('; ')[0]}{reason}."

    def row(self) -> dict[str, Any]:
        """The claim as it stands in claims.json."""
        value = self.value
        return {
            "figure": self.claim.figure,
            "claim": self.claim.claim,
            "paper": self.claim.paper,
            **({"ours": self.claim.ours} if self.claim.ours else {}),
            "tolerance": self.claim.tolerance,
            "criterion": self.claim.criterion,
            "measured": list(value) if isinstance(value, Sequence) else value,
            "verdict": self.verdict,
            "why": self.why,
            **({"reason": self.reason.reason, "because": self.reason.because} if self.reason else {}),
        }


def load() -> list[Claim]:
    """Both tables that ship with the package, the first one first. Raises ValueError where a row says nothing that can
    be judged."""
    claims = []
    for name in (FIRST, LATER):
        for row in _rows(name)["claims"]:
            accept = None if row["accept"] == "none" else row["accept"]
            words = {key: str(row[key]) for key in ("id", "figure", "part", "claim", "paper", "tolerance", "criterion")}
            claim = Claim(**words, accept=accept, ours=str(row.get("ours", "")), later=name == LATER)
            if accept is not None and (len(accept) != 1 or not accept.keys() <= _TESTS.keys()):
                raise ValueError(f"{name}: {claim.id} has no test that is known; use one of {', '.join(_TESTS)}")
            claims.append(claim)
    return claims


def reasons() -> dict[str, Reason]:
    """Reason of each claim that may differ, by id. Raises ValueError where one is none of the four."""
    found = {key: Reason(row["reason"], str(row["because"])) for key, row in _rows(REASONS)["reasons"].items()}
    for key, one in found.items():
        if one.reason not in get_args(Why):
            raise ValueError(f"{REASONS}: {key} differs for {one.reason!r}; use one of {', '.join(get_args(Why))}")
    return found


def _rows(name: str) -> dict[str, Any]:
    return yaml.safe_load(resources.files("gcs.report.paper").joinpath(name).read_text(encoding="utf-8"))


def judge(claim: Claim, measured: Measurement, known: Mapping[str, Reason] = MappingProxyType({})) -> Judged:
    """The verdict on one claim, and where it differs the reason, by `known` or else `REAL`.

    Without a tolerance, or without a value that can be held against it, it cannot be compared. A value that is not
    finite differs, and is left out.
    """
    note = f"; {measured.note}" if measured.note else ""
    if claim.accept is None:
        return Judged(claim, measured.value, "cannot be compared", f"the paper prints no value for it{note}")
    if measured.value is None:
        return Judged(claim, None, "cannot be compared", measured.note or "nothing was measured")
    numbers = measured.value if isinstance(measured.value, Sequence) else [measured.value]
    reason = known.get(claim.id, REAL)
    if not all(map(math.isfinite, numbers)):
        return Judged(claim, None, "differs", f"what was measured grows beyond all bounds{note}", reason)
    (kind, limit), *_ = claim.accept.items()
    holds, why = _TESTS[kind](measured.value, limit)
    if holds:
        return Judged(claim, measured.value, "agrees", f"{why}{note}")
    return Judged(claim, measured.value, "differs", f"{why}{note}", reason)


def shown(value: Value) -> str:
    """A measured value for people: three or four significant digits."""
    if value is None:
        return "–"
    if isinstance(value, Sequence):
        return ", ".join(shown(number) for number in value)
    if isinstance(value, int):
        return str(value)
    return f"{value:.4g}"


def write(judged: Sequence[Judged], folder: Path) -> None:
    """Write claims.json into `folder`. Raises OSError."""
    content = {
        "schema": SCHEMA,
        "claims": [one.row() for one in judged if not one.claim.later],
        "later_claims": [one.row() for one in judged if one.claim.later],
    }
    text = json.dumps(content, indent=2, ensure_ascii=False, allow_nan=False)
    (folder / "claims.json").write_text(text + "\n", encoding="utf-8")


def _at_most(value: Any, limit: float) -> tuple[bool, str]:
    holds = value <= limit
    return holds, f"{shown(value)} is {'at most' if holds else 'more than'} {limit:g}"


def _at_least(value: Any, limit: float) -> tuple[bool, str]:
    holds = value >= limit
    return holds, f"{shown(value)} is {'at least' if holds else 'less than'} {limit:g}"


def _equals(value: Any, wanted: Any) -> tuple[bool, str]:
    holds = (list(value) if isinstance(value, Sequence) else value) == wanted
    return holds, "exactly so" if holds else f"{shown(value)} instead of {shown(wanted)}"


def _bands(value: Any, bands: Sequence[Sequence[float | None]]) -> tuple[bool, str]:
    outside = []
    for number, (low, high) in zip(value, bands, strict=True):
        if (low is not None and number < low) or (high is not None and number > high):
            outside.append(f"{shown(number)} is outside {_edge(low, '-')} to {_edge(high, '')}")
    return not outside, "; ".join(outside) or "each lies within its band"


def _edge(edge: float | None, sign: str) -> str:
    return f"{sign}infinity" if edge is None else f"{edge:g}"


def _rising_by(value: Any, factor: float) -> tuple[bool, str]:
    factors = [later / earlier for earlier, later in itertools.pairwise(value)]
    holds = all(step >= factor for step in factors)
    return holds, f"from one to the next by {', '.join(f'{step:.3g}' for step in factors)}, wanted {factor:g} or more"


_TESTS: dict[str, Callable[[Any, Any], tuple[bool, str]]] = {
    "at_most": _at_most,
    "at_least": _at_least,
    "equals": _equals,
    "bands": _bands,
    "rising_by": _rising_by,
}
