"""`gcs mission show`: missions, geofences and rally points of a file or a recording, listed or converted."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from gcs.missions.items import GlobalPlace, MissionItem, MissionPlan

PARTS = ("mission", "fence", "rally")
PLAN_FILE = ".plan"
_ROW = "{:>4}  {:<28} {:>12} {:>13}  {:<24} {}"
_EMPTY = ""


@click.command(short_help="List a mission, geofence and rally points, of a file or a recording.")
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--json", "as_json", is_flag=True, help="One JSON object for each vehicle, or for the file, on stdout.")
@click.option("--sysid", type=click.IntRange(1, 255), help="Of a recording: of this vehicle only.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="OTHER",
    help="Write it to a new file instead: a .plan of QGroundControl, any other name is QGC WPL 110.",
)
@click.option("--part", type=click.Choice(PARTS), help="With --out: of several parts the one for a QGC WPL 110 file.")
def show(file: Path, as_json: bool, sysid: int | None, out: Path | None, part: str | None) -> int:
    """List the mission, the geofence and the rally points in FILE.

    FILE is a .plan of QGroundControl, a QGC WPL 110 file as of Mission Planner and MAVProxy, or a list of points as of
    older MAVProxys. Of a session's folder or a recording it lists what every vehicle had at its end: what a .tlog holds
    of uploads and downloads, and what a .BIN logs.

    Surveys and corridor scans come as the items that the .plan carries of them. What QGroundControl only makes when it
    opens the file, as structure scans and landing patterns, is named.

    \b
    Examples:
      gcs mission show survey.plan
      gcs mission show flight.tlog --json
      gcs mission show survey.plan --out fence.txt --part fence
      gcs mission show flight.BIN --out flown.plan

    \b
    Exit status:
      0    listed or written
      1    OTHER could not be written
      2    bad input, or there is none in FILE
    """
    from gcs.missions.errors import MissionFileError
    from gcs.recording.importing import ImportFailed

    try:
        found = dict(_plans(file, sysid))
    except (MissionFileError, ImportFailed) as error:
        raise click.UsageError(str(error)) from None
    except OSError as error:
        raise click.UsageError(f"{error.filename or file}: {error.strerror}.") from None
    if not found:
        whose = "" if sysid is None else f" of vehicle {sysid}"
        raise click.UsageError(f"{file} holds no mission, geofence or rally point{whose}.")
    if out is not None:
        return _write(found, out, part)
    for name, plan in found.items():
        click.echo(json.dumps(plain(name, plan)) if as_json else "\n".join(lines(name, plan)))
    return 0


def _plans(file: Path, sysid: int | None) -> Iterator[tuple[str, MissionPlan]]:
    """Names of a file, or of the vehicles in a recording, with what each has."""
    from gcs.missions import files
    from gcs.recording import tlog_reader
    from gcs.recording.importing import opened
    from gcs.recording.plans import PlansReader
    from gcs.recording.recorder import TLOG

    if file.is_file() and files.is_one(file):
        yield str(file), files.load(file)
        return
    reader = PlansReader()
    with opened(file / TLOG if file.is_dir() else file) as source:
        log = tlog_reader.read(source.path)
        for chunk in log.chunks():
            reader.add(chunk)
    for sysids, plan, _ in reader.plans(0.0).at(math.inf):
        for one in sysids:
            if sysid in (None, one):
                yield f"vehicle {one}", plan


def _write(found: dict[str, MissionPlan], out: Path, part: str | None) -> int:
    if len(found) > 1:
        raise click.UsageError(f"--out holds one plan, and there are {', '.join(found)}: choose one with --sysid.")
    (plan,) = found.values()
    return write(plan, out, part)


def write(plan: MissionPlan, out: Path, part: str | None = None) -> int:
    """Write a plan, or of several parts this one, to a new file; the exit status. Raises click.UsageError."""
    from gcs.missions import qgc_plan, waypoint_file
    from gcs.missions.items import fence_items, mission_items, rally_items
    from skytender.exit import NOT_DONE

    if out.suffix == PLAN_FILE:
        text = qgc_plan.write(plan)
    else:
        there = [name for name, one in zip(PARTS, (plan.mission, plan.fence, plan.rally), strict=True) if one]
        if part is None and len(there) > 1:
            raise click.UsageError(f"a QGC WPL 110 file holds one part, and there are {', '.join(there)}: give --part.")
        chosen = part or (there or ["mission"])[0]
        text = waypoint_file.write({"mission": mission_items, "fence": fence_items, "rally": rally_items}[chosen](plan))
    try:
        with out.open("x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:
        raise click.UsageError(f"{out} exists already and is left as it is.") from None
    except OSError as error:
        click.echo(f"gcs: {out}: {error.strerror}", err=True)
        return NOT_DONE
    for text in plan.left_out:
        click.echo(f"gcs: left out: {text}", err=True)
    return 0


def lines(name: str, plan: MissionPlan) -> Iterator[str]:
    """A plan in words, under its name; its items count from 1."""
    from gcs.missions.items import numbered

    plan = numbered(plan, 1)
    counts = [
        f"{count} {one}{'' if count == 1 else 's'}"
        for count, one in (
            (len(plan.mission), "mission item"),
            (len(plan.fence), "fence area"),
            (len(plan.rally), "rally point"),
        )
        if count
    ]
    yield f"{name}: {', '.join(counts) or ('nothing' if plan.empty else 'nothing that is known here')}"
    if plan.home is not None:
        yield f"home: {_place(plan.home)}"
    elif plan.mission or plan.rally:
        yield "home: not known"
    if plan.mission:
        yield _ROW.format("", "command", "latitude", "longitude", "height", "parameters").rstrip()
    for number, item in enumerate(plan.mission, plan.first):
        yield _row(number, item)
    for area in plan.fence:
        side = "inside" if area.inclusion else "outside"
        places = "; ".join(f"{lat:.7f} {lon:.7f}" for lat, lon in area.corners_deg)
        shape = f"polygon {places}" if area.radius_m is None else f"circle of {area.radius_m:g} m around {places}"
        yield f"fence: stay {side} the {shape}"
    if plan.fence_return is not None:
        yield "fence: return to {:.7f} {:.7f}".format(*plan.fence_return)
    for point in plan.rally:
        yield f"rally point: {_place(point)}"
    for text in plan.left_out:
        yield f"left out: {text}"


def _row(number: int, item: MissionItem) -> str:
    from gcs.missions.items import GlobalPlace

    place = item.place
    if place is None:
        cells = (_EMPTY, _EMPTY, _EMPTY)
    elif isinstance(place, GlobalPlace):
        cells = (f"{place.lat_deg:.7f}", f"{place.lon_deg:.7f}", _height(place))
    else:
        cells = ("N {:.1f} m".format(*place.p_ned), f"E {place.p_ned[1]:.1f} m", f"{-place.p_ned[2]:.1f} m local")
    return _ROW.format(number, item.name, *cells, item.about).rstrip()


def _place(place: GlobalPlace) -> str:
    return f"{place.lat_deg:.7f} {place.lon_deg:.7f}, {_height(place)}"


def _height(place: GlobalPlace) -> str:
    return "height not given" if math.isnan(place.height_m) else f"{place.height_m:g} m above {place.above}"


def plain(name: str, plan: MissionPlan) -> dict[str, Any]:
    """A plan as JSON, whose items count from 1; numbers that are not given are null."""
    from gcs.missions.items import numbered

    plan = numbered(plan, 1)

    def known(value: float) -> float | None:
        return value if math.isfinite(value) else None

    def place(at: GlobalPlace | None) -> dict[str, Any] | None:
        return None if at is None else {**at._asdict(), "height_m": known(at.height_m)}

    return {
        "source": name,
        "home": place(plan.home),
        "mission": [
            {
                "number": number,
                "command": item.command,
                "name": item.name,
                "frame": item.frame_name,
                "params": [known(value) for value in item.params],
                "autocontinue": item.autocontinue,
            }
            for number, item in enumerate(plan.mission, plan.first)
        ],
        "fence": [area._asdict() for area in plan.fence],
        "fence_return_deg": plan.fence_return,
        "rally": [place(point) for point in plan.rally],
        "left_out": plan.left_out,
    }
