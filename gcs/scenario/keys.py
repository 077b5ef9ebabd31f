"""Key paths of a scenario: `vehicles.pursuers.*.battery.initial_percent` names one value or many, to be set.

Parts are keys, positions in a list (from 0, as `.0` or `[0]`) and `*`, each of a list. A path is set in the file's data
before that is checked, so that a value out of range is reported like one in the file. A null takes the key out.
"""

from __future__ import annotations

import copy
import functools
import json
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from gcs.scenario.document import Document, KeyPath, Problem, ScenarioError, did_you_mean, dotted, options, parse
from gcs.scenario.json_schema import editor_schema
from gcs.scenario.types import plain_numbers
from gcs.scenario.yaml_dialect import SHORT

EACH = "*"
_PART = re.compile(r"\[(\d+|\*)\]|([^.\[\]]+)")
DEEPEST = 8


def read_settings(texts: Iterable[str]) -> dict[str, Any]:
    """{key path: value} of `KEY=VALUE` texts, values as YAML has them. Raises ScenarioError."""
    settings: dict[str, Any] = {}
    for text in texts:
        key, equals, value = text.partition("=")
        if not equals or not key.strip():
            raise _error(text, "write KEY=VALUE, such as planner.cruise_m_s=2")
        try:
            settings[key.strip()] = parse(f"value: {value}", "").data.get("value")
        except ScenarioError:
            raise _error(text, f"{value!r} is no value; write it as in a scenario file") from None
    return settings


def apply(document: Document, settings: Mapping[str, Any]) -> None:
    """Set key paths in a document. Raises ScenarioError with a sentence for each path that names nothing."""
    problems = []
    for key, value in plain_numbers(dict(settings)).items():
        label = f"set {key}={_shown(value)}"
        try:
            check(key)
            for path in _places(document, parts_of(key)):
                _put(document, path, copy.deepcopy(value))
                document.given[path] = label
        except ValueError as error:
            problems.append(Problem(label, None, None, str(error)))
    if problems:
        raise ScenarioError(problems)


@functools.cache  # a campaign asks thousands of times
def check(key: str) -> None:
    """See that a scenario may have this key path. Raises ValueError, one sentence with the nearest known path."""
    parts = parts_of(key)
    schema = editor_schema()
    nodes = list(options(schema, schema))
    for i, part in enumerate(parts):
        inner = list(_inside(schema, nodes, part))
        if not inner:
            where = f"in {dotted(parts[:i])}" if i else "at the top level"
            if part == EACH or isinstance(part, int):
                raise ValueError(f"{dotted(parts[:i]) or 'a scenario'} is no list")
            raise ValueError(f"unknown key {part!r} {where}{_near(parts, i, nodes)}")
        nodes = inner


@functools.cache
def parts_of(key: str) -> KeyPath:
    """The parts of a key path. Raises ValueError where it is none."""
    parts: list[str | int] = []
    at = 0
    while at < len(key):
        match = _PART.match(key, at)
        if match is None or (at and (key[at - 1] == ".") == (match[1] is not None)):
            raise ValueError(f"{key!r} is no key path; write keys with dots between, such as planner.cruise_m_s")
        word = match[1] or match[2]
        parts.append(int(word) if word.isdecimal() else word)
        at = match.end()
        if at < len(key) and key[at] == ".":
            at += 1
            if at == len(key):
                raise ValueError(f"{key!r} ends in a dot")
        elif at < len(key) and key[at] != "[":
            raise ValueError(f"{key!r} is no key path")
    if not parts:
        raise ValueError("a key path is empty")
    return tuple(parts)


@functools.cache
def known_paths() -> tuple[str, ...]:
    """Every key path that a scenario may have, lists as `*`."""
    schema = editor_schema()

    def walk(nodes: list[dict[str, Any]], path: tuple[str, ...]) -> Iterator[str]:
        if path:
            yield ".".join(path)
        if len(path) >= DEEPEST:
            return
        for key in dict.fromkeys(key for node in nodes for key in node.get("properties", ())):
            yield from walk(list(_inside(schema, nodes, key)), (*path, key))
        if items := [option for node in nodes if "items" in node for option in options(schema, node["items"])]:
            yield from walk(items, (*path, EACH))

    return tuple(dict.fromkeys(walk(list(options(schema, schema)), ())))


def expanded(document: Document, key: str) -> list[str]:
    """A key path without `*`: every place that it means in a document. Raises ValueError where it means none."""
    return [".".join(map(str, path)) for path in _places(document, parts_of(key))]


def _inside(schema: dict[str, Any], nodes: list[dict[str, Any]], part: str | int) -> Iterator[dict[str, Any]]:
    """Schema nodes of what stands at `part` in any of these."""
    for node in nodes:
        if part == EACH or isinstance(part, int):
            if node.get("type") == "array" or "prefixItems" in node:
                prefix = node.get("prefixItems", [])
                inner = prefix[part] if isinstance(part, int) and part < len(prefix) else node.get("items", {})
                yield from options(schema, inner or {})
        elif part in node.get("properties", ()):
            yield from options(schema, node["properties"][part])
        elif node.get("patternProperties") or isinstance(node.get("additionalProperties"), dict):
            yield {}


def _near(parts: KeyPath, i: int, nodes: list[dict[str, Any]]) -> str:
    """ "; did you mean 'x'?": a key in the same place, or else a path that ends alike."""
    word = str(parts[i])
    here = did_you_mean(word, [key for node in nodes for key in node.get("properties", ())])
    if here:
        return here
    words = [EACH if isinstance(part, int) else part for part in parts]
    for start in range(i, len(words)):
        end = ".".join(words[start:])
        if alike := [path for path in known_paths() if f".{path}".endswith(f".{end}")]:
            return f"; did you mean {min(alike, key=lambda path: (path.count('.'), path))!r}?"
    return did_you_mean(dotted(parts), known_paths())


def _places(document: Document, parts: KeyPath) -> list[KeyPath]:
    """The concrete paths that a key path means in a document. Raises ValueError where it means none."""
    found: list[KeyPath] = [()]
    for i, part in enumerate(parts):
        following: list[KeyPath] = []
        for path in found:
            inside = document.value(path)
            if part == EACH:
                following += [(*path, k) for k in range(len(inside) if isinstance(inside, list) else 0)]
            elif isinstance(part, int):
                size = len(inside) if isinstance(inside, list) else 0
                if part >= size:
                    raise ValueError(f"there is no {dotted((*path, part))}: {dotted(path)} has {size}, counted from 0")
                following.append((*path, part))
            else:
                following.append((*path, part))
        if not following:
            raise ValueError(f"{dotted(parts[:i])} has nothing in it that could be set")
        found = following
    return found


def _put(document: Document, path: KeyPath, value: Any) -> None:
    """Set one place; blocks on the way that the file leaves out are made."""
    node: Any = document.data
    for i, part in enumerate(path[:-1]):
        inside = node.get(part) if isinstance(node, dict) else node[part]
        if isinstance(inside, str) and i == 0 and part in SHORT:
            inside = {SHORT[part]: inside}
        if inside is None:
            inside = {}
        if not isinstance(inside, dict | list):
            raise ValueError(f"{dotted(path[: i + 1])} is no block of keys here")
        node[part] = inside
        node = inside
    last = path[-1]
    if value is None and isinstance(node, dict):
        node.pop(last, None)
    else:
        node[last] = value


def _shown(value: Any) -> str:
    text = json.dumps(value, default=str)
    return text if len(text) <= 40 else f"{text[:37]}..."


def _error(label: str, message: str) -> ScenarioError:
    return ScenarioError([Problem(f"set {label}", None, None, message)])
