"""The paper's claims and how they are judged: claims.yaml, a measurement each, a verdict each.

The table says what is accepted before anything is measured; this module only applies it.
"""

from __future__ import annotations

import itertools
import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any, Literal

import yaml

Verdict = Literal["agrees", "differs", "cannot be compared"]
Value = float | int | Sequence[float] | Sequence[int] | None
SCHEMA = 1


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


@dataclass(frozen=True)
class Measurement:
    """Measurement for a claim; `note` is said with the verdict. A value of None: nothing could be measured."""

    value: Value
    note: str = ""


@dataclass(frozen=True)
class Judged:
    """A claim with its measurement and verdict."""

    claim: Claim
    value: Value
    verdict: Verdict
    why: str

    @property
    def line(self) -> str:
        """For a terminal: where the paper says what, and the first reason of the verdict."""
        where = f"Fig. {self.claim.figure}" if self.claim.figure[0].isdecimal() else self.claim.figure
        return f"{where}: {self.claim.claim} Here {self.why.partition('; ')[0]}."

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
        }


def load() -> list[Claim]:
    """The table that ships with the package. Raises ValueError where a row says nothing that can be judged."""
    text = resources.files("gcs.report.paper").joinpath("claims.yaml").read_text(encoding="utf-8")
    claims = []
    for row in yaml.safe_load(text)["claims"]:
        accept = None if row["accept"] == "none" else row["accept"]
        words = {key: str(row[key]) for key in ("id", "figure", "part", "claim", "paper", "tolerance", "criterion")}
        claim = Claim(**words, accept=accept, ours=str(row.get("ours", "")))
        if accept is not None and (len(accept) != 1 or not accept.keys() <= _TESTS.keys()):
            raise ValueError(f"claims.yaml: {claim.id} has no test that is known; use one of {', '.join(_TESTS)}")
        claims.append(claim)
    return claims


def judge(claim: Claim, measured: Measurement) -> Judged:
    """The verdict on one claim.

    Without a tolerance, or without a value that can be held against it, it cannot be compared. A value that is not
    finite differs, and is left out.
    """
    note = f"; {measured.note}" if measured.note else ""
    if claim.accept is None:
        return Judged(claim, measured.value, "cannot be compared", f"the paper prints no value for it{note}")
    if measured.value is None:
        return Judged(claim, None, "cannot be compared", measured.note or "nothing was measured")
    numbers = measured.value if isinstance(measured.value, Sequence) else [measured.value]
    if not all(map(math.isfinite, numbers)):
        return Judged(claim, None, "differs", f"what was measured grows beyond all bounds{note}")
    (kind, limit), *_ = claim.accept.items()
    holds, why = _TESTS[kind](measured.value, limit)
    return Judged(claim, measured.value, "agrees" if holds else "differs", f"{why}{note}")


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
    content = {"schema": SCHEMA, "claims": [one.row() for one in judged]}
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
