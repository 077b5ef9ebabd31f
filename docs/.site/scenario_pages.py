"""The pages of a scenario file's keys, from its JSON Schema: one for each part of the file, with the parts that only it
leads to where they are short."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from cells import UP, cell, prose

UNITS = {
    "_m_s": "m/s", "_m": "m", "_s": "s", "_j": "J", "_w": "W", "_deg": "°", "_percent": "%", "_rad": "rad", "_hz": "Hz",
}  # fmt: skip
ROOT_TITLE = "Scenario file"
OPTIONAL = ("defaults", "grid")
"""Keys that a file may have and the loaded scenario has not; they have no default."""
MOST_WORDS = 2000
"""Of a page: a part that leads to more than that is a page by itself, and what it leads to are others."""

Pages = dict[str, list[str]]
"""The parts of each page, by the part that gives it its name."""


def pages(schema: Mapping[str, Any]) -> dict[str, str]:
    """Text of each page by the file's name, in the order in which the file's own keys lead to the parts."""
    parts = schema["$defs"]
    grouped = groups(schema, parts)
    place = {name: page_of(first) for first, names in grouped.items() for name in names}
    lines = [
        "# Scenario reference",
        "",
        "Every key of a scenario file, generated from its JSON Schema (`gcs schema`). Units stand at the end of",
        "names. Positions are three numbers in the axes that the file states: `ned` (north, east, down) or `paper`",
        f"(x north, y west, z up). The [first hour]({UP}first-hour.md#your-own-scenario) has an example.",
        "",
        *section(f"## {ROOT_TITLE}", schema, parts, place),
        "## Parts",
        "",
        "| part | is |",
        "|---|---|",
    ]
    lines += [f"| {link(name, place)} | {cell(prose(parts[name].get('description', '')))} |" for name in place]
    texts = {"index.md": lines}
    for first, names in grouped.items():
        texts[page_of(first)] = section(f"# {heading(first)}", parts[first], parts, place)
        for name in names[1:]:
            texts[page_of(first)] += section(f"## {heading(name)}", parts[name], parts, place)
    return {name: "\n".join(text).rstrip() + "\n" for name, text in texts.items()}


def groups(schema: Mapping[str, Any], parts: Mapping[str, Any]) -> Pages:
    """The parts of each page: a part and what it leads to first, or it alone where that is too long for a page."""
    below = children(schema, parts)
    found: Pages = {}

    def put(name: str) -> None:
        names = [name, *reached(name, below)]
        text = [line for part in names for line in section("#", parts[part], parts, dict.fromkeys(parts, ""))]
        if sum(len(line.split()) for line in text) <= MOST_WORDS:
            found[name] = names
            return
        found[name] = [name]
        for other in below[name]:
            put(other)

    for name in below[""]:
        put(name)
    return found


def children(schema: Mapping[str, Any], parts: Mapping[str, Any]) -> dict[str, list[str]]:
    """Parts by the part that names them first; those that the file itself names are under an empty name."""
    below: dict[str, list[str]] = {"": []} | {name: [] for name in parts}
    seen: set[str] = set()
    waiting: list[tuple[str, Mapping[str, Any]]] = [("", schema)]
    while waiting:
        above, part = waiting.pop(0)
        for name in references(part.get("properties", {})):
            if name not in seen:
                seen.add(name)
                below[above].append(name)
                waiting.append((name, parts[name]))
    return below


def reached(name: str, below: Mapping[str, list[str]]) -> Iterator[str]:
    """All parts to which a part leads, by way of others too."""
    for other in below[name]:
        yield other
        yield from reached(other, below)


def page_of(part: str) -> str:
    """Name of the page that a part gives its name to."""
    return f"{heading(part).lower()}.md"


def link(part: str, place: Mapping[str, str]) -> str:
    """A part's heading, linked."""
    return f"[{heading(part)}]({place[part]}#{heading(part).lower()})"


def heading(name: str) -> str:
    """A part's heading: its name as a user knows it."""
    return name.removesuffix("Rules")


def references(content: Any) -> Iterator[str]:
    """Names of the parts that a piece of schema refers to."""
    if isinstance(content, dict):
        if "$ref" in content:
            yield content["$ref"].rpartition("/")[2]
        for value in content.values():
            yield from references(value)
    elif isinstance(content, list):
        for value in content:
            yield from references(value)


def section(title: str, part: Mapping[str, Any], parts: Mapping[str, Any], place: Mapping[str, str]) -> list[str]:
    """A part's heading, description and table; `place` has the page of each part."""
    lines = [title, ""]
    if part.get("description"):
        lines += [prose(part["description"]), ""]
    lines += ["| key | type | unit | default | meaning |", "|---|---|---|---|---|"]
    required = set(part.get("required", ()))
    for key, value in with_inner_keys(part.get("properties", {})):
        given = "required" if key in required or key == "sysid" else "required, here or by `defaults`"
        optional = key in OPTIONAL or key.startswith("grid.")
        default = f"`{shown(value['default'])}`" if "default" in value else "" if optional else given
        if "default" in value and any(True for _ in references(value)):
            default = "its defaults" if value["default"] else default
        meaning = prose(value.get("description", "")) or prose(parts_description(value, parts))
        lines.append(f"| `{key}` | {cell(kind(value, place))} | {unit(key)} | {cell(default)} | {cell(meaning)} |")
    return [*lines, ""]


def with_inner_keys(properties: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """(key, schema) of each key; a grid's own keys, which are no part of their own, follow it as `grid.KEY`."""
    for key, value in properties.items():
        yield key, value
        if key == "grid":
            yield from ((f"{key}.{inner}", inside) for inner, inside in value["properties"].items())


def parts_description(value: Mapping[str, Any], parts: Mapping[str, Any]) -> str:
    """The description of what a key refers to."""
    return next((parts[name].get("description", "") for name in references(value)), "")


def kind(value: Mapping[str, Any], place: Mapping[str, str]) -> str:
    """A schema's type in words, with its limits."""
    if "$ref" in value:
        return link(value["$ref"].rpartition("/")[2], place)
    if "enum" in value:
        return " or ".join(f"`{choice}`" for choice in value["enum"])
    if "const" in value:
        return f"`{value['const']}`"
    choices = value.get("anyOf") or value.get("oneOf")
    if choices:
        names = dict.fromkeys(kind(choice, place) for choice in choices if choice.get("type") != "null")
        return " or ".join(names)
    name = value.get("type", "any")
    if name == "array":
        items = value.get("prefixItems")
        if items:
            return f"{len(items)} × {kind(items[0], place)}" if all(item == items[0] for item in items) else "list"
        return f"list of {kind(value.get('items', {}), place)}"
    if name == "object":
        extra = value.get("additionalProperties")
        return f"block of {kind(extra, place)}" if isinstance(extra, dict) else "block"
    if name == "string":
        return f"text `{value['pattern']}`" if "pattern" in value and len(value["pattern"]) < 40 else "text"
    return name + limits(value)


def limits(value: Mapping[str, Any]) -> str:
    """Least and greatest value, as conditions."""
    words = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}
    conditions = [f"{sign} {value[word]:g}" for word, sign in words.items() if word in value and abs(value[word]) < 1e5]
    return f" {', '.join(conditions)}" if conditions else ""


def unit(key: str) -> str:
    """The unit in which a key's name ends."""
    return next((word for suffix, word in UNITS.items() if key.endswith(suffix)), "")


def shown(value: Any) -> str:
    """A default as a scenario file would have it."""
    return json.dumps(value) if not isinstance(value, str) else value or '""'
