"""Types of a scenario's values: numbers with limits, places that are turned into NED, and what every part shares.

With the validation context {"axes": "paper"} geometry is turned from paper axes as it is read.
"""

import math
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    ValidationError,
    ValidationInfo,
    WithJsonSchema,
)
from pydantic_core import CoreSchema, core_schema

from gcs.scenario.described import Described
from gcs.scenario.document import MAX_SHOWN, Document
from gcs.scenario.parts.reach import Shown

MOST_M = 1e5


class Exact:
    """Beside a number's type or `bool` in Annotated: of that type as it stands, within limits (ge, gt, le, lt).

    pydantic's Field says the same, in as many steps as it has words, of which each takes its time.
    """

    def __init__(self, **limits: float) -> None:
        self._limits = limits

    def __get_pydantic_core_schema__(self, source: Any, _: GetCoreSchemaHandler, /) -> CoreSchema:
        return _SCHEMAS[source](strict=True, **self._limits)


_SCHEMAS: dict[Any, Callable[..., CoreSchema]] = {
    bool: core_schema.bool_schema,
    float: core_schema.float_schema,
    int: core_schema.int_schema,
}


def _into_ned(value: Any, info: ValidationInfo) -> Any:
    """A height, or a vector of two or three (also roll, pitch, yaw): from paper axes it is half a turn about north."""
    if info.context != {"axes": "paper"}:
        return value
    return (value[0], *(0.0 - part for part in value[1:])) if isinstance(value, tuple) else 0.0 - value


def _limit(value: Any) -> Any:
    """A distance, `false`, or nothing: what is meant then is the key's own default."""
    if value is None or value is False:
        return value
    usable = isinstance(value, int | float) and value is not True
    if not usable or not math.isfinite(value) or not 0.0 <= value <= MOST_M:
        raise ValueError(f"must be a number from 0 to {MOST_M:.0f}, or false")
    return float(value)


if TYPE_CHECKING:
    Limit = float | Literal[False] | None
else:
    _LIMIT = {"anyOf": [{"type": "number", "minimum": 0, "maximum": MOST_M}, {"enum": [False, None]}]}
    Limit = Annotated[Any, AfterValidator(_limit), WithJsonSchema(_LIMIT)]
Flag = Annotated[bool, Exact()]
Count = Annotated[int, Exact(ge=0, lt=1 << 63)]
SysId = Annotated[int, Exact(ge=1, le=254)]
Label = Annotated[str, Shown(), Field(pattern=r"^[^\x00-\x1f\x7f-\x9f]{1,32}$")]
ParamName = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]{0,15}$")]
Number = Annotated[float, Exact()]
Positive = Annotated[float, Exact(gt=0)]
NotNegative = Annotated[float, Exact(ge=0)]
Fraction = Annotated[float, Exact(ge=0, le=1)]
Percent = Annotated[float, Exact(ge=0, le=100)]
Metres = Annotated[float, Exact(gt=0, le=1e5)]
Speed = Annotated[float, Exact(gt=0, le=100)]
Degrees = Annotated[float, Exact(ge=-180, le=180)]
Seconds = Annotated[float, Exact(ge=0, le=604_800)]
Joules = Annotated[float, Exact(gt=0, le=1 << 24)]  # whole joules travel as 32-bit integers
Coordinate = Annotated[float, Exact(ge=-1e5, le=1e5)]
Height = Annotated[Coordinate, AfterValidator(_into_ned)]
Plane = Annotated[tuple[Coordinate, Coordinate], AfterValidator(_into_ned)]
Vec3 = Annotated[tuple[Coordinate, Coordinate, Coordinate], AfterValidator(_into_ned)]
Angles = Annotated[tuple[Degrees, Degrees, Degrees], AfterValidator(_into_ned)]
Route = Annotated[tuple[Vec3, ...], Field(min_length=1)]


def plain_numbers(value: Any) -> Any:
    """The same with NumPy's numbers, texts and arrays as Python's, in lists and blocks of keys too. Raises ValueError
    for one that holds itself."""
    numpy = sys.modules.get("numpy")  # what is not imported has made nothing
    try:
        return value if numpy is None else _plain(value, (numpy.generic, numpy.ndarray))
    except RecursionError:
        raise ValueError("a list or a block of keys holds itself") from None


def _plain(value: Any, kinds: Any) -> Any:
    if isinstance(value, kinds):
        value = value.tolist()
    if isinstance(value, dict):
        return {_plain(key, kinds): _plain(one, kinds) for key, one in value.items()}
    return type(value)([_plain(one, kinds) for one in value]) if type(value) in (list, tuple) else value


def explained(error: ValidationError, part: type[BaseModel], data: dict[str, Any], what: str) -> str:
    """Mistakes in the keys of a part that is not read from a file, as one sentence; `what`: words for that part."""
    problems = Document(part.__name__, data, what).explain(error, part.model_json_schema())
    return "; ".join(problem.message for problem in problems[:MAX_SHOWN])


if TYPE_CHECKING:
    from pydantic._internal._model_construction import ModelMetaclass as _Made
else:

    class _Made(type(BaseModel)):
        """Says in a sentence what is wrong with the keys by which a program makes a part; what is validated as plain
        data, such as a file's, does not pass here."""

        def __call__(cls, *values: Any, **keys: Any) -> Any:
            if values:
                raise TypeError(f"{cls.__name__} takes its keys by name: {cls.__name__}(**keys) for a block of them")
            keys = plain_numbers(keys)
            try:
                return super().__call__(**keys)
            except ValidationError as error:
                what = explained(error, cls, keys, f"the {cls.__name__.lower()}")
                raise ValueError(f"{cls.__name__}: {what}") from None


class Part(Described, BaseModel, metaclass=_Made):
    """A block of keys: one that it does not know is refused, and what it says is not changed any more."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, defer_build=True)
