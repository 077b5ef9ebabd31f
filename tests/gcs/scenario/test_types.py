"""Numbers with limits, held against pydantic's own words for the same."""

from typing import Annotated, Any

import pytest
from pydantic import Field, TypeAdapter, ValidationError

from gcs.scenario.types import Exact

LIMITS = [{}, {"ge": 0}, {"gt": 0, "le": 1}, {"ge": -89, "lt": 89}]
VALUES = [0, 1, -1, 0.5, 1.0, 88.9, 89, -89.5, True, "1", None, float("nan"), float("inf"), [1]]


def judged(kind: Any, value: Any) -> Any:
    try:
        return TypeAdapter(kind).validate_python(value)
    except ValidationError as error:
        return error.errors(include_url=False)


@pytest.mark.parametrize("limits", LIMITS)
@pytest.mark.parametrize("kind", [int, float])
def test_exact_numbers_are_those_of_a_strict_field(kind: type, limits: dict[str, float]) -> None:
    ours, theirs = Annotated[kind, Exact(**limits)], Annotated[kind, Field(strict=True, **limits)]  # type: ignore[arg-type]
    assert TypeAdapter(ours).json_schema() == TypeAdapter(theirs).json_schema()
    for value in VALUES:
        assert repr(judged(ours, value)) == repr(judged(theirs, value))


def test_exact_truth_values_are_those_of_a_strict_field() -> None:
    for value in VALUES:
        ours, theirs = judged(Annotated[bool, Exact()], value), judged(Annotated[bool, Field(strict=True)], value)
        assert repr(ours) == repr(theirs)
