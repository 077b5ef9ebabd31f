"""A campaign file as typed, frozen objects: what is flown how often, what changes, what is measured and expected."""

from __future__ import annotations

import math
import re
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, ConfigDict, Field, model_validator

from gcs.campaign import measures
from gcs.scenario import keys
from gcs.scenario.document import Conflict, conflict_error
from gcs.scenario.parts.reach import Asks, Shown, is_foreign_code
from gcs.scenario.rules import OWN
from gcs.scenario.types import Count, Flag, NotNegative, Number, Part, Positive

ARGUMENTS = "arguments."
"""Key paths that begin so are arguments of the function that `generate` names."""
MOST_SESSIONS = 10_000_000

Pair = tuple[Number, Number]
Words = Annotated[tuple[Any, ...], Field(min_length=1)]


def _in_order(pair: Pair) -> Pair:
    if not pair[0] < pair[1]:
        raise ValueError("must be [least, most], the first below the second")
    return pair


def _above_zero(pair: Pair) -> Pair:
    if pair[0] <= 0.0:
        raise ValueError("must be above 0")
    return pair


Range = Annotated[Pair, AfterValidator(_in_order)]
Corner = tuple[Number, Number, Number]


class RandomObstacles(Part):
    """Obstacles of random kind, size and place beside the scenario's own."""

    count: tuple[Count, Count]
    """least and most"""
    kinds: Annotated[tuple[Literal["point", "sphere", "box", "cylinder"], ...], Field(min_length=1)] = (
        "sphere",
        "box",
        "cylinder",
    )
    """kinds to choose from; boxes and cylinders stand on the ground"""
    within_m: tuple[Corner, Corner]
    """two corners of the room for their centres, m, in the file's axes"""
    apart_m: NotNegative = 1.2
    """least distance from starts, the way up, way points, targets' paths and homes, m"""


class Draw(Part):
    """Source of a value: exactly one of the first six, and how it is drawn."""

    uniform: Range | None = None
    """evenly between two numbers"""
    log_uniform: Annotated[Range, AfterValidator(_above_zero)] | None = None
    """evenly in the logarithm between two numbers above 0"""
    normal: Pair | None = None
    """mean and standard deviation"""
    integers: tuple[int, int] | None = None
    """whole numbers from the first to the last, both included"""
    choice: Words | None = None
    """one of these, each as likely"""
    random: RandomObstacles | None = None
    """obstacles, for the key `obstacles` alone"""
    clip: Range | None = None
    """limits of a normal value"""
    together: Flag = False
    """one value for all that `*` means, instead of one for each"""

    @model_validator(mode="after")
    def _is_one(self) -> Self:
        given = [kind for kind in KINDS if getattr(self, kind) is not None]
        if len(given) != 1:
            raise conflict_error([Conflict((), f"a draw needs exactly one of {', '.join(KINDS)}")])
        if self.clip is not None and self.normal is None:
            raise conflict_error([Conflict(("clip",), "clip goes with normal")])
        if self.normal is not None and self.normal[1] < 0.0:
            raise conflict_error([Conflict(("normal",), "the standard deviation must not be below 0")])
        if self.integers is not None and self.integers[0] > self.integers[1]:
            raise conflict_error([Conflict(("integers",), "integers must be [least, most]")])
        return self


KINDS = ("uniform", "log_uniform", "normal", "integers", "choice", "random")


class Expectation(Part):
    """Limits of a measure; a session outside them has failed."""

    at_least: Number | None = None
    at_most: Number | None = None
    equals: str | float | bool | None = None

    def fault(self, name: str, value: Any) -> str | None:
        """Why a value is not as expected, in words; None where it is. A value that is missing meets every limit."""
        if self.equals is not None and value != self.equals:
            return f"{name} is {_shown(value)}, not {_shown(self.equals)}"
        if value is None or isinstance(value, str):
            return None
        if self.at_least is not None and not value >= self.at_least:
            return f"{name} is {_shown(value)}, below {_shown(self.at_least)}"
        if self.at_most is not None and not value <= self.at_most:
            return f"{name} is {_shown(value)}, above {_shown(self.at_most)}"
        return None


class CampaignLimits(Part):
    """Limits of a session's cost; one that takes more is a row with an error."""

    wall_s: Positive = 600.0
    """wall time, s"""
    session_s: Positive = 86_400.0
    """session time, s"""


class SearchRules(Part):
    """The worst case instead of the average: `draw` is searched for it."""

    model_config = ConfigDict(populate_by_name=True)

    minimise: str | None = None
    maximise: str | None = None
    trials: Annotated[int, Field(strict=True, ge=1, le=1_000_000)] = 200
    sampler: Literal["sobol_cmaes", "tpe", "cmaes", "sobol"] = "sobol_cmaes"
    """sobol_cmaes: a Sobol sequence over three tenths of the trials, then CMA-ES about the worst of them"""
    batch: Annotated[int, Field(strict=True, ge=1, le=1000)] = 10
    """trials that are flown at once; the result does not depend on the number of workers"""

    @model_validator(mode="after")
    def _has_an_aim(self) -> Self:
        if (self.minimise is None) == (self.maximise is None):
            raise conflict_error([Conflict((), "a search needs exactly one of minimise, maximise")])
        return self


class CampaignRules(Part):
    """One campaign."""

    model_config = ConfigDict(populate_by_name=True)

    schema_version: Annotated[int, Field(strict=True, ge=1, le=1, alias="schema")]
    """version of the file format; 1"""
    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]{0,63}$")]
    """also the folder's"""
    description: Annotated[str, Shown()] = ""
    """free text, shown in the report"""
    scenario: str | None = None
    """a shipped scenario's name, or a file, as seen from the campaign's folder"""
    generate: Annotated[str, Asks("code", is_foreign_code)] | None = None
    """MODULE:FUNCTION, which returns a scenario as plain data for `seed` and `arguments`; instead of `scenario`"""
    arguments: dict[str, Any] = {}  # noqa: RUF012 - pydantic copies it
    """further arguments of that function; `vary` and `draw` change them as `arguments.NAME`"""
    set: dict[str, Any] = {}  # noqa: RUF012 - pydantic copies it
    """values by key path, the same in every session"""
    sessions: Annotated[int, Field(strict=True, ge=1, le=MOST_SESSIONS)]
    """draws of each combination"""
    seed: Count = 1
    """of every draw and every session"""
    vary: dict[str, Words] = {}  # noqa: RUF012 - pydantic copies it
    """values by key path, flown in every combination"""
    draw: dict[str, Draw] = {}  # noqa: RUF012 - pydantic copies it
    """drawn once per session, the same for every combination"""
    measure: Annotated[tuple[str, ...], Field(min_length=1)] = measures.DEFAULT
    """columns of the table: shipped measures, or key paths into summary.json"""
    expect: dict[str, Expectation] = {}  # noqa: RUF012 - pydantic copies it
    """what makes a session a success; without it that its goal was met"""
    keep: Literal["all", "failed", "none"] = "failed"
    """which sessions' folders are kept"""
    limits: CampaignLimits = CampaignLimits()
    """wall and session time of one session"""
    search: SearchRules | None = None
    """for `gcs campaign search`"""

    @property
    def measured(self) -> tuple[str, ...]:
        """Every measure, those that are only expected or searched for included."""
        wanted = [*self.measure, *self.expect]
        wanted += [] if self.search is None else [str(self.search.minimise or self.search.maximise)]
        return tuple(dict.fromkeys(wanted))

    @property
    def combinations(self) -> int:
        """Number of combinations that `vary` makes."""
        return math.prod(len(values) for values in self.vary.values())

    @model_validator(mode="after")
    def _agrees(self) -> Self:
        found = []
        if (self.scenario is None) == (self.generate is None):
            found.append(Conflict((), "a campaign needs exactly one of scenario, generate"))
        if self.generate is not None and not OWN.fullmatch(self.generate):
            found.append(Conflict(("generate",), "generate must be MODULE:FUNCTION"))
        if self.arguments and self.generate is None:
            found.append(Conflict(("arguments",), "arguments go with generate"))
        if self.combinations * self.sessions > MOST_SESSIONS:
            found.append(Conflict(("sessions",), f"more than {MOST_SESSIONS} sessions in all"))
        for where in ("set", "vary", "draw"):
            found += [Conflict((where, key), fault) for key in getattr(self, where) if (fault := self._fault(key))]
            earlier = {"set": {}, "vary": self.set, "draw": {**self.set, **self.vary}}[where]
            again = [key for key in getattr(self, where) if key in earlier and (where, key) != ("draw", "obstacles")]
            found += [Conflict((where, key), f"{key} is set twice") for key in again]
        for key, values in self.vary.items():
            if len({repr(value) for value in values}) < len(values):
                found.append(Conflict(("vary", key), "a value is given twice"))
        for key, draw in self.draw.items():
            if (draw.random is not None) != (key == "obstacles"):
                found.append(Conflict(("draw", key), "random goes with the key obstacles, and that with random"))
        limited = {name for name, one in self.expect.items() if (one.at_least, one.at_most) != (None, None)}
        for place in ("measure", "expect"):
            for i, name in enumerate(getattr(self, place)):
                if why := measures.fault(name, number=place == "expect" and name in limited):
                    found.append(Conflict((place, i if place == "measure" else name), why))
        if self.search is not None:
            if why := measures.fault(str(self.search.minimise or self.search.maximise), number=True):
                found.append(Conflict(("search",), why))
            if not self.draw:
                found.append(Conflict(("search",), "a search needs something to draw"))
        if found:
            raise conflict_error(found)
        return self

    def _fault(self, key: str) -> str | None:
        """Fault of a key path, as a sentence; None without one."""
        if key.startswith(ARGUMENTS):
            name = key.removeprefix(ARGUMENTS)
            if self.generate is None:
                return f"{key} needs generate"
            return None if re.fullmatch(r"[A-Za-z_]\w*", name) else f"{key} names no argument"
        if key == "seed":
            return "each session has a seed of its own; set the campaign's"
        try:
            keys.check(key)
        except ValueError as error:
            return str(error)
        return None


def _shown(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.4g}"
    return "nothing" if value is None else str(value)
