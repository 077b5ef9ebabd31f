"""`gcs mission`: missions, geofences and rally points over a whole fleet: read, written, cleared, compared.

`show` lists the plan in a file (show.py).
"""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from gcs.cli.fleet_options import fleet_at, of_the_fleet
from gcs.cli.mission.show import PARTS, PLAN_FILE, lines, plain, show, write
from gcs.cli.options import Refused
from skytender.exit import NOT_DONE

if TYPE_CHECKING:
    from gcs.cli.mission.writing import PlanWriting
    from gcs.link.fleet_client import FleetClient
    from gcs.mavlink.plans.client import ItemDifference, PlanClient
    from gcs.mavlink.plans.items import PlanItem
    from gcs.missions.items import MissionPlan

AT_ONCE = 32
"""Vehicles whose plans are under way at the same time: each has one question open, so that a radio is not flooded."""
NAMED = 5
"""Differences of one plan that are named; the others are counted."""
HOME_WITHIN_S = 3.0
"""[choice] So long vehicles are asked for their homes: one that has none yet does not say it."""
READ = frozenset({"read", "unsupported"})
"""Ends of a reading by which it is known what a vehicle has."""
Found = Mapping[int, Mapping[str, "PlanWriting"]]
"""Dialogues that have ended, by system id and part."""


class _Group(click.Group):
    """Its commands; a file in the place of one is answered by the command that lists it."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args[0] not in self.commands and ("." in args[0] or Path(args[0]).exists()):
            raise click.UsageError(f"{args[0]} is no command: `gcs mission show {args[0]}` lists the plan in a file.")
        return super().resolve_command(ctx, args)


def _of_parts(command: Callable[..., Any]) -> Callable[..., Any]:
    """The option that chooses parts of a plan."""
    help = "Only this part; may be given again.  [default: all that there are]"
    return click.option("--part", "parts", type=click.Choice(PARTS), multiple=True, help=help)(command)


@click.group(cls=_Group, short_help="Missions, geofences and rally points: of a fleet, a file or a recording.")
def mission() -> None:
    """Missions, geofences and rally points of every vehicle at an address at once, whatever its autopilot.

    What is written is read back, and counts only when it reads as it was written. Files are a .plan of QGroundControl
    or QGC WPL 110, as of Mission Planner and MAVProxy.

    \b
    Examples:
      gcs mission show survey.plan
      gcs mission get --connect udpin:127.0.0.1:14550
      gcs mission set survey.plan --sysid 3 --sysid 4
      gcs mission diff survey.plan
      gcs mission clear --part fence

    \b
    Exit status:
      0    done; diff: all vehicles have what is in the file
      1    a vehicle refused something, keeps it otherwise, or did not answer; diff: they differ
      2    bad input, or no vehicle was received
      130  stopped by Ctrl-C; what each vehicle was given is said
    """


mission.add_command(show)


@mission.command(short_help="Show what vehicles have, or write it to files.")
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    metavar="OTHER",
    help="Write it to a new file instead: a .plan of QGroundControl, any other ending is QGC WPL 110. "
    "Of several vehicles, or without an ending: a folder, with vehicle-SYSID.plan for each.",
)
@_of_parts
@of_the_fleet
def get(out: Path | None, parts: tuple[str, ...], as_json: bool, **options: Any) -> int:
    """Show the mission, the geofence and the rally points of every vehicle.

    \b
    Examples:
      gcs mission get --part mission --json
      gcs mission get --sysid 3 --out three.plan
      gcs mission get --out plans
    """
    with fleet_at(**options) as fleet:
        paths = {} if out is None else _paths(out, sorted(fleet.profiles), parts)
        found = _converse(fleet, {s: dict.fromkeys(parts or PARTS) for s in fleet.profiles}, options["station"])
        plans = _with_homes(fleet, {sysid: _plan(fleet, sysid, clients) for sysid, clients in found.items()}, paths)
    status = _complain(found, READ)
    paths = {s: path for s, path in paths.items() if all(one.outcome in READ for one in found[s].values())}
    for sysid, path in paths.items():
        status = max(status, write(plans[sysid], path, parts[0] if len(parts) == 1 else None))
    if as_json:
        shown = {sysid: plain(f"vehicle {sysid}", plan) for sysid, plan in plans.items()}
        click.echo(json.dumps({"vehicles": shown, "files": {sysid: str(path) for sysid, path in paths.items()}}))
    else:
        for sysid, plan in plans.items():
            text = "\n".join(lines(f"vehicle {sysid}", plan))
            click.echo(f"{text.splitlines()[0]}, in {paths[sysid]}" if sysid in paths else text)
    return status


@mission.command("set", short_help="Write a file's plan to vehicles, and read it back.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@_of_parts
@of_the_fleet
def set_(file: Path, parts: tuple[str, ...], as_json: bool, **options: Any) -> int:
    """Give every vehicle the mission, the geofence and the rally points in FILE, and verify them by reading them back.

    Parts that FILE does not hold stay as they are. What a vehicle has already is not written. A parameter for which its
    autopilot has no use, such as the acceptance radius in ArduCopter, reads 0, and is named.

    \b
    Examples:
      gcs mission set survey.plan
      gcs mission set site.plan --part fence --part rally --sysid 3
    """
    plan, chosen = _load(file, parts)
    with fleet_at(**options) as fleet:
        _say_armed(fleet)
        found = _converse(fleet, _items(fleet, plan, chosen, file), options["station"], plan.first)
    return _report(found, {"kept", "uploaded"}, as_json=as_json)


@mission.command(short_help="Clear what vehicles have, and read that back.")
@_of_parts
@of_the_fleet
def clear(parts: tuple[str, ...], as_json: bool, **options: Any) -> int:
    """Clear the mission, the geofence and the rally points of every vehicle.

    \b
    Examples:
      gcs mission clear --part mission
      gcs mission clear --sysid 3
    """
    with fleet_at(**options) as fleet:
        _say_armed(fleet)
        found = _converse(fleet, {s: dict.fromkeys(parts or PARTS, ()) for s in fleet.profiles}, options["station"])
    return _report(found, {"kept", "uploaded", "unsupported"}, as_json=as_json)


@mission.command(short_help="Compare vehicles with a file.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@_of_parts
@of_the_fleet
def diff(file: Path, parts: tuple[str, ...], as_json: bool, **options: Any) -> int:
    """Show where vehicles differ from the mission, the geofence and the rally points in FILE, item by item.

    Only parts that FILE holds are compared. A parameter that FILE does not give, and one for which a vehicle's
    autopilot has no use, is no difference.
    """
    plan, chosen = _load(file, parts)
    with fleet_at(**options) as fleet:
        wanted = _items(fleet, plan, chosen, file)
        found = _converse(fleet, {s: dict.fromkeys(chosen) for s in wanted}, options["station"], plan.first)
    status = _complain(found, {"read"})
    differ = {
        sysid: {part: _between(one, wanted[sysid][part]) for part, one in clients.items() if one.found is not None}
        for sysid, clients in found.items()
    }
    if as_json:
        click.echo(json.dumps({"differences": differ}))
    else:
        for sysid, rows in differ.items():
            said = [f"{part}: {_some(texts)}" for part, texts in rows.items() if texts]
            if said or len(rows) == len(chosen):
                click.echo(f"vehicle {sysid}: {'; '.join(said) or 'no difference'}")
    return max(status, NOT_DONE if any(any(rows.values()) for rows in differ.values()) else 0)


def _load(file: Path, parts: Collection[str]) -> tuple[MissionPlan, list[str]]:
    """The plan in a file, and the parts of it that are asked for. Raises click.ClickException."""
    from gcs.missions import files
    from gcs.missions.errors import MissionFileError

    try:
        plan = files.load(file)
    except MissionFileError as error:
        raise Refused(str(error).removesuffix(".")) from None
    except OSError as error:
        raise Refused(f"{error.filename or file}: {error.strerror}") from None
    if plan.left_out:
        raise Refused(f"{file} is not understood whole, and no vehicle gets a part of it: {'; '.join(plan.left_out)}")
    held = {"mission": plan.mission, "fence": plan.fence or plan.fence_return, "rally": plan.rally}
    chosen = [part for part in PARTS if part in (parts or PARTS) and (held[part] or parts)]
    missing = [part for part in chosen if not held[part]]
    if missing or not chosen:
        raise Refused(f"{file} holds no {' and no '.join(missing) or 'mission, geofence or rally point'}")
    return plan, chosen


def _items(
    fleet: FleetClient, plan: MissionPlan, parts: Sequence[str], file: Path
) -> dict[int, dict[str, Sequence[PlanItem] | None]]:
    """Items of these parts as each vehicle is given them. Raises click.ClickException."""
    from gcs.mavlink.plans.items import KINDS, wire_items
    from gcs.missions.items import ItemError

    try:
        return {
            sysid: {part: wire_items(plan, KINDS[part], profile.plans, profile.not_given) for part in parts}
            for sysid, profile in fleet.profiles.items()
        }
    except ItemError as error:
        raise Refused(f"{file}: item {error.index}: {error}") from None


def _converse(
    fleet: FleetClient,
    wanted: Mapping[int, Mapping[str, Sequence[PlanItem] | None]],
    station: tuple[int, int],
    first: int = 1,
) -> Found:
    """Have the dialogues about what each vehicle is to have; None is only read. `first`: number of a mission's first
    item."""
    from gcs.cli.mission.writing import PlanWriting, read_after_refusals, say_interrupted
    from gcs.cli.progress_bar import progress_bar
    from gcs.mavlink.ids import AUTOPILOT
    from gcs.mavlink.plans.client import PlanClients
    from gcs.mavlink.plans.items import KINDS

    found = {
        sysid: {
            part: PlanWriting(
                sysid,
                AUTOPILOT,
                KINDS[part],
                items,
                fleet.profiles[sysid].plans,
                station=station,
                first=first if part == "mission" else 1,
            )
            for part, items in parts.items()
        }
        for sysid, parts in sorted(wanted.items())
    }
    vehicles = [PlanClients(list(clients.values())) for clients in found.values()]
    try:
        with progress_bar("plans") as shown:
            fleet.converse(vehicles, lambda: shown(sum(one.done for one in vehicles) / len(vehicles)), AT_ONCE)
        read_after_refusals(fleet, found, station, AT_ONCE)
    except KeyboardInterrupt:
        say_interrupted(found)
        raise
    return found


def _plan(fleet: FleetClient, sysid: int, clients: Mapping[str, PlanClient]) -> MissionPlan:
    """All parts that were read of a vehicle."""
    from gcs.mavlink.plans.items import plan_of

    return plan_of({client.kind: client.found or () for client in clients.values()}, fleet.profiles[sysid].plans)


def _with_homes(
    fleet: FleetClient, plans: Mapping[int, MissionPlan], written: Collection[int]
) -> dict[int, MissionPlan]:
    """Plans with the homes that vehicles give of themselves, where home is not among their items. Only those that have
    something, or whose plans are `written`, are asked."""
    from gcs.missions.items import GlobalPlace
    from gcs.telemetry.place_claims import is_place

    asked = [s for s, plan in plans.items() if plan.home is None and (plan.mission or plan.rally or s in written)]
    found = dict(plans)
    for sysid, messages in fleet.request(["HOME_POSITION"], HOME_WITHIN_S, asked).items():
        home = messages.get("HOME_POSITION")
        if home is not None and is_place(home.latitude, home.longitude):
            place = GlobalPlace(home.latitude / 1e7, home.longitude / 1e7, home.altitude / 1e3, "sea")
            found[sysid] = found[sysid]._replace(home=place)
    return found


def _paths(out: Path, sysids: Sequence[int], parts: Sequence[str]) -> dict[int, Path]:
    """New file of each vehicle. Raises click.ClickException."""
    if len(sysids) == 1 and out.suffix:
        paths = {sysids[0]: out}
    elif out.suffix:
        raise Refused(f"--out {out} is one file, and there are vehicles {', '.join(map(str, sysids))}: name a folder")
    else:
        paths = {sysid: out / f"vehicle-{sysid}{PLAN_FILE}" for sysid in sysids}
        try:
            out.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise Refused(f"--out {out}: {error.strerror}") from None
    if out.suffix not in ("", PLAN_FILE) and len(parts) != 1:
        raise Refused(f"--out {out} would be a QGC WPL 110 file, which holds one part: give one --part, or a .plan")
    for path in paths.values():
        if path.exists():
            raise Refused(f"{path} exists already and is left as it is; give another name")
    return paths


def _say_armed(fleet: FleetClient) -> None:
    for sysid in sorted(fleet.armed & fleet.profiles.keys()):
        click.echo(f"gcs: vehicle {sysid} is armed: if it flies by its plan, that changes under way.", err=True)


def _report(found: Found, well: Collection[str], *, as_json: bool) -> int:
    """Say how each writing has ended; the exit status."""
    rows = [(sysid, part, client) for sysid, clients in found.items() for part, client in clients.items()]
    if as_json:
        results = [
            {
                **{"sysid": sysid, "part": part, "outcome": client.outcome, "items": client.count, "why": _why(client)},
                "not_kept": [one.text for one in client.not_kept],
            }
            for sysid, part, client in rows
        ]
        click.echo(json.dumps({"results": results}))
    else:
        for sysid, part, client in rows:
            click.echo(f"{sysid:>3}  {part:<7}  {_words(client)}")
    return 0 if all(client.outcome in well for *_, client in rows) else NOT_DONE


def _words(client: PlanWriting) -> str:
    items = f"{client.count} item{'' if client.count == 1 else 's'}"
    not_kept = f"; not kept as given: {_some([one.text for one in client.not_kept])}" if client.not_kept else ""
    match client.outcome:
        case "kept":
            words = f"{items}, there already" if client.items else "there was none"
        case "uploaded":
            words = f"{items} uploaded, read back equal" if client.items else "cleared, read back"
        case _:
            return f"{client.outcome}: {_why(client)}" + not_kept * client.all_there
    return words + not_kept


def _why(client: PlanWriting) -> str:
    """Why a plan is not as it was given, and what the vehicle has then."""
    if client.all_there:
        return "the item is on the vehicle" if client.count == 1 else f"all {client.count} items are on the vehicle"
    return client.why + (f"; {client.after}" if client.after else "")


def _complain(found: Found, well: Collection[str]) -> int:
    """Name what could not be read; the exit status of that."""
    status = 0
    for sysid, clients in found.items():
        for part, client in clients.items():
            if client.outcome != "read":
                click.echo(f"gcs: vehicle {sysid}: {part}: {client.why}", err=True)
                status = status if client.outcome in well else NOT_DONE
    return status


def _between(client: PlanClient, items: Sequence[PlanItem] | None) -> list[str]:
    """Differences of what a vehicle has from these items, in words."""
    items = items or ()
    counts = [] if client.has_count(items) else [f"it has {client.count} items, the file {client.expected(items)}"]
    return [*counts, *_texts(client.compare(items))]


def _texts(differences: Sequence[ItemDifference]) -> Iterator[str]:
    return (one.text for one in differences if not one.difference.lost)


def _some(texts: Sequence[str]) -> str:
    """The first ones of several, the others counted."""
    more = len(texts) - NAMED
    return "; ".join(texts[:NAMED]) + (f"; and {more} more" if more > 0 else "")
