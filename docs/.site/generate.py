"""Writes the generated pages of the documentation into a folder.

    scenario.md      every key of a scenario file, from its JSON Schema
    commands.md      every command and option, from click
    parameters.md    every MAVLink parameter of the vehicle, from its table
    packages.md      which package imports which, and what each module holds, from the code, with pictures

`python docs/.site/generate.py FOLDER` needs a Python that has Skytender installed; build.py calls it.
"""

from __future__ import annotations

import functools
import json
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import click
import package_pictures
from package_pictures import cell, escaped, prose

# All that is taken from the project; the rest of this file knows no module of it.
from gcs.cli.main import cli as gcs_command
from gcs.scenario.json_schema import editor_schema
from simvehicle.autopilot.parameters import TABLE as PARAMETERS
from simvehicle.cli import cli as simvehicle_command

ROOT = Path(__file__).resolve().parents[2]

UNITS = {
    "_m_s": "m/s", "_m": "m", "_s": "s", "_j": "J", "_w": "W", "_deg": "°", "_percent": "%", "_rad": "rad", "_hz": "Hz",
}  # fmt: skip
ROOT_TITLE = "Scenario file"
OPTIONAL = ("defaults", "grid")
"""Keys that a file may have and the loaded scenario has not; they have no default."""


def main() -> None:
    """Write every page."""
    if len(sys.argv) != 2:
        raise SystemExit("generate.py FOLDER")
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in pages().items():
        (folder / name).write_text(text, encoding="utf-8")


@functools.cache
def pages() -> Mapping[str, str]:
    """Text of every generated file, by name."""
    return {
        "scenario.md": scenario_page(editor_schema()),
        "commands.md": commands_page({"gcs": gcs_command, "simvehicle": simvehicle_command}),
        "parameters.md": parameters_page(),
        **package_pictures.pages(ROOT),
    }


# Scenario


def scenario_page(schema: Mapping[str, Any]) -> str:
    """A section for each block of keys, in the order in which the file's own keys lead to them."""
    parts = schema["$defs"]
    order = reachable(schema, parts)
    lines = [
        "# Scenario reference",
        "",
        "Every key of a scenario file, generated from its JSON Schema (`gcs schema`). Units stand at the end of",
        "names. Positions are three numbers in the axes that the file states: `ned` (north, east, down) or `paper`",
        "(x north, y west, z up). The [first hour](../first-hour.md#your-own-scenario) has an example.",
        "",
        *section(ROOT_TITLE, schema, parts),
    ]
    for name in order:
        lines += section(heading(name), parts[name], parts)
    return "\n".join(lines) + "\n"


def heading(name: str) -> str:
    """A part's heading: its name as a user knows it."""
    return name.removesuffix("Rules")


def reachable(schema: Mapping[str, Any], parts: Mapping[str, Any]) -> list[str]:
    """Names of the parts, each when it is first referred to."""
    found: list[str] = []
    waiting: list[Mapping[str, Any]] = [schema]
    while waiting:
        for name in references(waiting.pop(0).get("properties", {})):
            if name not in found:
                found.append(name)
                waiting.append(parts[name])
    return found


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


def section(title: str, part: Mapping[str, Any], parts: Mapping[str, Any]) -> list[str]:
    """A part's heading, description and table."""
    lines = [f"## {title}", ""]
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
        lines.append(f"| `{key}` | {cell(kind(value))} | {unit(key)} | {cell(default)} | {cell(meaning)} |")
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


def kind(value: Mapping[str, Any]) -> str:
    """A schema's type in words, with its limits."""
    if "$ref" in value:
        name = value["$ref"].rpartition("/")[2]
        return f"[{heading(name)}](#{heading(name).lower()})"
    if "enum" in value:
        return " or ".join(f"`{choice}`" for choice in value["enum"])
    if "const" in value:
        return f"`{value['const']}`"
    choices = value.get("anyOf") or value.get("oneOf")
    if choices:
        names = dict.fromkeys(kind(choice) for choice in choices if choice.get("type") != "null")
        return " or ".join(names)
    name = value.get("type", "any")
    if name == "array":
        items = value.get("prefixItems")
        if items:
            return f"{len(items)} × {kind(items[0])}" if all(item == items[0] for item in items) else "list"
        return f"list of {kind(value.get('items', {}))}"
    if name == "object":
        extra = value.get("additionalProperties")
        return f"block of {kind(extra)}" if isinstance(extra, dict) else "block"
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


# Commands


def commands_page(programs: Mapping[str, click.Command]) -> str:
    """A section for each command of each program."""
    lines = ["# Command reference", "", "Generated from the programs; the same as `COMMAND --help`.", ""]
    for name, command in programs.items():
        lines += [f"## {name}", "", *command_section(command, context_of(command, name))]
        if isinstance(command, click.Group):
            with context_of(command, name) as context:
                for sub in command.list_commands(context):
                    below = command.get_command(context, sub)
                    if below is None or below.hidden:
                        continue
                    inner = context_of(below, sub, context)
                    lines += [f"### {name} {sub}", "", *command_section(below, inner)]
                    for last in below.list_commands(inner) if isinstance(below, click.Group) else ():
                        if (command_of_group := below.get_command(inner, last)) is not None:
                            lines += [f"#### {name} {sub} {last}", ""]
                            lines += command_section(command_of_group, context_of(command_of_group, last, inner))
    return "\n".join(lines) + "\n"


def context_of(command: click.Command, name: str, parent: click.Context | None = None) -> click.Context:
    """The context in which a command's help is written."""
    return click.Context(command, info_name=name, parent=parent, **command.context_settings)


def command_section(command: click.Command, context: click.Context) -> list[str]:
    """Usage and text as the terminal shows them, then a table of options."""
    context.terminal_width = context.max_content_width = 110
    formatter = context.make_formatter()
    command.format_usage(context, formatter)
    command.format_help_text(context, formatter)
    lines = ["```text", formatter.getvalue().rstrip(), "```", ""]
    records = [record for param in command.get_params(context) if (record := param.get_help_record(context))]
    lines += ["| option | meaning |", "|---|---|"]
    lines += [f"| {code(option)} | {cell(escaped(meaning))} |" for option, meaning in records]
    return [*lines, ""]


def code(text: str) -> str:
    """An option in code type; a cell's bar must be escaped there too."""
    return f"`{cell(text)}`"


# Parameters


def parameters_page() -> str:
    """The vehicle's parameter table."""
    lines = [
        "# Vehicle parameters",
        "",
        "MAVLink parameters of `simvehicle`; a scenario sets them with `params:` of a vehicle. Names are PX4's",
        "where PX4 has the quantity, else `SIM_*`.",
        "",
        "| name | type | range | default | meaning |",
        "|---|---|---|---|---|",
    ]
    for row in PARAMETERS:
        integer = "INT32" if row.whole else "REAL32"
        span = f"{row.least:g} … {row.most:g}"
        lines.append(f"| `{row.name}` | {integer} | {span} | {row.default:g} | {cell(row.meaning)} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
