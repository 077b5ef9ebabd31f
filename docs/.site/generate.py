"""Writes the generated pages of the documentation into a folder.

    scenario/        every key of a scenario file, from its JSON Schema
    commands/        every command and option, from click
    parameters.md    every MAVLink parameter of the vehicle, from its table
    packages/        which package imports which, and what each module holds, from the code, with pictures

Each folder has an index.md, and pages under 2,500 words.

`python docs/.site/generate.py FOLDER` needs a Python that has Skytender installed; build.py does the same for the
site.
"""

from __future__ import annotations

import functools
import sys
from collections.abc import Mapping
from pathlib import Path

import command_pages
import package_pictures
import scenario_pages
from cells import cell

# All that is taken from the project; the rest of this file knows no module of it.
from gcs.cli.main import cli as gcs_command
from gcs.scenario.json_schema import editor_schema
from simvehicle.cli import cli as simvehicle_command
from skytender.vehicle.parameters import TABLE as PARAMETERS

ROOT = Path(__file__).resolve().parents[2]


def main() -> None:
    """Write every page into the folder that is named."""
    if len(sys.argv) != 2:
        raise SystemExit("generate.py FOLDER")
    write(Path(sys.argv[1]))


def write(folder: Path) -> None:
    """Write every page into a folder."""
    for name, text in pages().items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")


@functools.cache
def pages() -> Mapping[str, str]:
    """Text of every generated file, by its path, in the order in which the site's navigation shows them."""
    folders = {
        "scenario": scenario_pages.pages(editor_schema()),
        "commands": command_pages.pages({"gcs": gcs_command, "simvehicle": simvehicle_command}),
        "packages": package_pictures.pages(ROOT),
    }
    return {
        **{f"{folder}/{name}": text for folder, texts in folders.items() for name, text in texts.items()},
        "parameters.md": parameters_page(),
    }


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
