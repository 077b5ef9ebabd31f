"""`gcs list`: scenarios that ship with the program, and sessions that were flown."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once; the command is called list

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import click

from gcs.cli.options import Refused

SESSIONS = Path("sessions")
RUNNING = "no summary: it still flies, or was killed"


@click.command(short_help="List the shipped scenarios, and sessions that were flown.")
@click.argument("folder", required=False, type=click.Path(file_okay=False, path_type=Path))
@click.option("--json", "as_json", is_flag=True, help="One JSON object on stdout.")
def list(folder: Path | None, as_json: bool) -> int:
    """List the scenarios that ship with the program, and the sessions in FOLDER, ./sessions if left out: newest last.

    \b
    Examples:
      gcs list
      gcs list sessions --json | jq -r '.sessions[] | select(.outcome != "met").folder'

    \b
    Exit status:
      0    listed, also where nothing was flown
      2    there is no such FOLDER
    """
    if folder is not None and not folder.is_dir():
        raise Refused(f"there is no folder {folder}")
    scenarios, sessions = [*_scenarios()], [*_sessions(folder or SESSIONS)]
    if as_json:
        click.echo(json.dumps({"scenarios": scenarios, "sessions": sessions}))
        return 0
    click.echo("Scenarios, for gcs run NAME:")
    _columns(scenarios, ("name", "description"))
    click.echo(f"\nSessions in {folder or SESSIONS}:" if sessions else f"\nNo sessions in {folder or SESSIONS}.")
    _columns(sessions, ("folder", "outcome", "flown"))
    return 0


def _scenarios() -> Iterator[dict[str, Any]]:
    import yaml

    from gcs.scenario.file import find, shipped_names

    for name in shipped_names():
        content = yaml.safe_load(find(name).read_text(encoding="utf-8"))
        yield {"name": name, "description": content.get("description", "")}


def _sessions(folder: Path) -> Iterator[dict[str, Any]]:
    """Sessions directly below a folder, by the time of their recording."""
    found = [path for path in folder.glob("*/session.tlog") if path.is_file()]
    for recording in sorted(found, key=lambda path: path.stat().st_mtime):
        summary = _summary(recording.parent)
        flown_s = summary.get("sim_time_s")
        yield {
            "folder": str(recording.parent),
            "scenario": summary.get("scenario"),
            "outcome": summary.get("outcome", RUNNING),
            "sim_time_s": flown_s,
            "flown": "" if flown_s is None else f"{flown_s:.1f} s",
            "digest": summary.get("digest"),
        }


def _summary(folder: Path) -> Mapping[str, Any]:
    try:
        found = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def _columns(rows: Sequence[Mapping[str, Any]], keys: tuple[str, ...]) -> None:
    widths = [max((len(str(row[key])) for row in rows), default=0) for key in keys]
    for row in rows:
        click.echo("  " + "  ".join(f"{row[key]!s:<{width}}" for key, width in zip(keys, widths, strict=True)).rstrip())
