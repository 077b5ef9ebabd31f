"""Plain data of what a program made: numbers, texts, lists and blocks of keys, as a file has them."""

from __future__ import annotations

from typing import Any

from gcs.scenario.document import KeyPath, Problem, ScenarioError, dotted, shown
from gcs.scenario.types import plain_numbers


def plain(data: dict[Any, Any], name: str) -> dict[str, Any]:
    """The same, with numpy's scalars and arrays as numbers and lists. Raises ScenarioError for anything else."""
    try:
        made: dict[str, Any] = _plain(plain_numbers(data), (), name)
    except (RecursionError, ValueError):
        raise ScenarioError([Problem(name, None, None, "a list or a block of keys holds itself")]) from None
    return made


def _plain(value: Any, path: KeyPath, name: str) -> Any:
    if isinstance(value, dict):
        return {_plain(key, path, name): _plain(one, (*path, str(key)), name) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(one, (*path, k), name) for k, one in enumerate(value)]
    if value is None or type(value) in (bool, int, float, str):
        return value
    message = f"{dotted(path)} is {shown(value)}; it has to be a number, a text, a list or a block of keys"
    raise ScenarioError([Problem(name, None, None, message)])
