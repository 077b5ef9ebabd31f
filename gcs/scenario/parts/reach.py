"""Things that a scenario may reach beyond its session: code, programs, key files, devices, addresses, orders.

A key's type says so itself (`Asks`), so that one list of all that a scenario names can be made from its models.
"""

from __future__ import annotations

import functools
import typing
from collections.abc import Callable, Iterator
from typing import Any, Literal, NamedTuple

from pydantic import BaseModel

Reach = Literal["code", "program", "key file", "address", "control"]


class Asks:
    """Beside a type in Annotated: a value that reaches beyond the session, which is asked for before it is used.

    `when` says whether a value does.
    """

    def __init__(self, reach: Reach, when: Callable[[Any], bool] = bool) -> None:
        self.reach: Reach = reach
        self.when = when


class Shown:
    """Beside a type in Annotated: free text that is shown, or a file that is read as data; neither is run nor spoken
    to."""


class Reached(NamedTuple):
    """One thing beyond the session that a model names, and by which key."""

    reach: Reach
    value: str
    key: str

    @property
    def text(self) -> str:
        """For a person."""
        if self.reach == "control":
            return f"other ground stations may command the vehicles ({self.key})"
        return f"{self.reach} {self.value} ({self.key})"


def is_foreign_code(name: str) -> bool:
    """Whether MODULE:NAME, or the name of what is shipped, is code that is not shipped."""
    return ":" in name and not name.startswith("gcs.")


def reached(model: BaseModel, at: str = "") -> list[Reached]:
    """All that a model and what is in it reach, in order of its keys; each thing once."""
    found = {(one.reach, one.value): one for one in reversed(list(_reached(model, at)))}
    return list(found.values())[::-1]


def _reached(value: Any, at: str) -> Iterator[Reached]:
    if isinstance(value, BaseModel):
        for name, asks in _keys(type(value)):
            key = f"{at}.{name}" if at else name
            inner = getattr(value, name)
            if asks is None:
                yield from _reached(inner, key)
                continue
            for one in inner if isinstance(inner, tuple) else (inner,):
                if one is not None and asks.when(one):
                    yield Reached(asks.reach, str(one), key)
    elif isinstance(value, tuple):
        for i, one in enumerate(value):
            yield from _reached(one, f"{at}.{i}")
    elif isinstance(value, dict):
        for name, one in value.items():
            yield from _reached(one, f"{at}.{name}")


@functools.cache
def _keys(model: type[BaseModel]) -> list[tuple[str, Asks | None]]:
    """Keys of a model that reach beyond the session, with how, or that hold others that may."""
    keys: list[tuple[str, Asks | None]] = []
    for name, field in model.model_fields.items():
        marks = [one for one in (*field.metadata, *_marks(field.annotation)) if isinstance(one, Asks)]
        if marks:
            keys.append((name, marks[0]))
        elif any(_keys(inner) for inner in _marks(field.annotation) if isinstance(inner, type)):
            keys.append((name, None))
    return keys


def _marks(annotation: Any) -> Iterator[Any]:
    """Everything that stands beside the types in an annotation, and the models in it."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    yield from getattr(annotation, "__metadata__", ())
    for inner in typing.get_args(annotation):
        yield from _marks(inner)
