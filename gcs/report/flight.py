"""The recorded flight for the page, which plays it: places and attitudes at even times, modes, events and refuellings.

It speaks the types of the session's socket (`gcs.session.message_types`), so that the page shows it as it shows a live
one. Numbers over time that the report draws anyway (battery, speed, distance to target) are not carried twice: the page
takes them from the figures.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.autopilots import profile_of
from gcs.recording.pursuit_held import pursued
from gcs.recording.series import GAP_S, Floats, Series, Track, by_vehicle, held
from gcs.recording.tick_record import event_of, is_event
from gcs.report.findings import Findings
from gcs.report.pack import Pack
from gcs.scenario.model import Obstacle
from gcs.scenario.parts.world import bodies
from gcs.session import messages
from gcs.session.message_types import BrokenRow, MemberRow, ServedRow, SessionLine, plain
from gcs.telemetry.events import Event, level_of
from gcs.telemetry.health import Health
from skytender.processes import printable

MANY = 16
MOST_SAMPLES, MOST_SAMPLES_OF_MANY = 1500, 600
"""Of a vehicle's places; between them the page goes straight on."""
EVERY_S = 0.1
MOST_EVENTS = 4000
MOST_WORLDS = 600
"""Of changes of obstacles and paths: of more, those at even times are shown."""


def flight(found: Findings, pack: Pack) -> dict[str, Any] | None:
    """The recording that the page plays; its numbers go to `pack`. None where no place is known."""
    if not found.tracks:
        return None
    many = len(found.tracks) > MANY
    end_s = max(found.end_s, 1e-3)
    count = min(MOST_SAMPLES_OF_MANY if many else MOST_SAMPLES, math.ceil(end_s / EVERY_S) + 1)
    t_s: Floats = np.linspace(0.0, end_s, max(count, 2))
    vehicles = []
    for sysid, track in sorted(found.tracks.items()):
        turns = found.attitudes.get(sysid)
        # With many vehicles attitudes are too small to see, and the page would be twice as large.
        shown = () if turns is None else ((2, "heading"),) if many else ((2, "heading"), (0, "roll"), (1, "pitch"))
        angles = {} if turns is None else {name: pack.column(_angle(turns[i], t_s)) for i, name in shown}
        places, age_s = _known(track, t_s)
        packed = {"p": [pack.column(column) for column in places.T], "age": pack.column(age_s)}
        vehicles.append({"sysid": sysid, **packed, **angles})
    traffic = [
        {"callsign": name, "p": [pack.column(column) for column in _places(track, t_s).T]}
        for name, track in found.traffic.items()
    ]
    rules = found.judged
    return {
        "count": len(t_s),
        "end_s": end_s,
        "session": _session(found),
        "vehicles": vehicles,
        "traffic": traffic,
        "targets": _targets(found),
        "words": _words(found),
        "health": _health(found),
        "events": [msgspec.to_builtins(messages.event_row(event)) for event in _events(found)][-MOST_EVENTS:],
        "history": [{key: getattr(service, key) for key in ServedRow.__struct_fields__} for service in found.services],
        "threshold": rules.competition.share if rules is not None else 0.9,
        "goal": msgspec.to_builtins(messages.goal_state(rules, None, _broken(found))),
        **_worlds(found),
    }


def _silences(reported_s: Floats, t_s: Floats) -> tuple[NDArray[np.bool_], NDArray[np.int64]]:
    """(k,) whether each time lies in a silence between two reports, and (k,) the place of the last report by then."""
    latest = np.maximum(np.searchsorted(reported_s, t_s, side="right") - 1, 0)
    next_one = np.minimum(latest + 1, len(reported_s) - 1)
    return reported_s[next_one] - reported_s[latest] > GAP_S, latest


def _places(track: Track, t_s: Floats) -> Floats:
    """(k, 3) where an aircraft was, straight on between its reports; NaN in silences."""
    places, _ = _known(track, t_s)
    if len(track.t_s):
        silent, _ = _silences(track.t_s, t_s)
        places[silent | (t_s > track.t_s[-1] + GAP_S)] = np.nan
    return places


def _known(track: Track, t_s: Floats) -> tuple[Floats, Floats]:
    """(k, 3) where a vehicle was as far as is known, straight on between its reports and in silences where it was last,
    and (k,) how old its last report is, in s to one decimal; NaN before the first."""
    if not len(track.t_s):
        return np.full((len(t_s), 3), np.nan), np.full(len(t_s), np.nan)
    silent, latest = _silences(track.t_s, t_s)
    places = np.column_stack([np.interp(t_s, track.t_s, axis) for axis in track.p_ned.T])
    places[silent] = track.p_ned[latest[silent]]
    age_s: Floats = np.maximum(t_s - track.t_s[latest], 0.0).round(1)
    before = t_s < track.t_s[0] - GAP_S
    places[before], age_s[before] = np.nan, np.nan
    return places, age_s


def _angle(series: Series, t_s: Floats) -> Floats:
    """(k,) an angle in rad, between -π and π, in silences the last that is known."""
    known = np.isfinite(series.values)
    if not known.any():
        return np.full(len(t_s), np.nan)
    reported_s, values = series.t_s[known], series.values[known]
    silent, latest = _silences(reported_s, t_s)
    turned = np.interp(t_s, reported_s, np.unwrap(values))
    turned[silent] = values[latest[silent]]
    return np.arctan2(np.sin(turned), np.cos(turned))


def _targets(found: Findings) -> dict[str, list[list[float]]]:
    """By system id of a pursuer: [time, system id of its target or 0] where that changes."""
    t_s = found.nearness.separation.t_s
    return {
        str(sysid): [[float(t_s[k]), int(targets[k])] for k in np.flatnonzero(np.r_[True, np.diff(targets) != 0])]
        for sysid, targets in pursued(found.recorded, t_s).items()
        if len(targets)
    }


def _session(found: Findings) -> dict[str, Any]:
    """The message of type "session"; without a scenario, the vehicles that flew."""
    if found.scenario is not None:
        return messages.session_message(found.scenario, None, source="replay", clock="replay", control=False)
    members = [MemberRow(v.sysid, v.role, v.label, None, [], v.sysid - 1) for v in found.vehicles]
    name = printable(found.recorded.folder.resolve().name)
    goal = messages.goal_of(None)
    return plain(
        SessionLine(name, None, "replay", found.end_s, "replay", None, False, None, None, members, [], [], goal)
    )


def _worlds(found: Findings) -> dict[str, Any]:
    """Obstacles and targets' paths where they changed in flight: `solids`, each once, and `worlds`, which of them are
    there from a time on, with the paths by system id. Nothing where nothing changed."""
    worlds = found.recorded.worlds
    if worlds is None or len(worlds) < 2:
        return {}
    entries = list(worlds)
    entries = entries[:: math.ceil(len(entries) / MOST_WORLDS)]
    if entries[-1][1] is not worlds.now:
        entries.append(list(worlds)[-1])
    solids: dict[Obstacle, int] = {}
    listed = []
    for since_s, world in entries:
        there = [solids.setdefault(one, len(solids)) for one in bodies(world, "obstacle")]
        paths = {str(target.sysid): messages.vehicle_of(target, 0).path_ned for target in world.vehicles.targets}
        listed.append((max(since_s, 0.0), there, paths))
    return {"solids": [msgspec.to_builtins(messages.obstacle_of(one, "")) for one in solids], "worlds": listed}


def _words(found: Findings) -> dict[str, list[list[Any]]]:
    """By system id: [time, mode, armed, in the air] where any of these changes."""
    words: dict[str, list[list[Any]]] = {}
    for sysid, beats in by_vehicle(found.recorded, "HEARTBEAT").items():
        if sysid not in found.tracks:
            continue
        told = np.column_stack([beats[name].astype(np.int64) for name in ("custom_mode", "autopilot", "type")])
        changed = np.flatnonzero(np.r_[True, (np.diff(told, axis=0) != 0).any(axis=1)])
        track = found.tracks[sysid]
        modes = [(int(k), *map(int, told[k])) for k in changed]
        times = {float(beats["t_s"][k]): profile_of(pilot, kind).mode_name(mode) for k, mode, pilot, kind in modes}
        moments = sorted({*times, *_changes(track.armed), *_changes(track.in_air)})
        armed, in_air = (held(state, np.array(moments)) > 0.0 for state in (track.armed, track.in_air))
        mode, listed = "", []
        for t_s, is_armed, flies in zip(moments, armed.tolist(), in_air.tolist(), strict=True):
            mode = times.get(t_s, mode)
            listed.append([round(t_s, 2), mode, is_armed, flies])
        words[str(sysid)] = listed
    return words


def _health(found: Findings) -> dict[str, Any]:
    """Health of the vehicles: each state of it once in `rows`, as fields of VehicleRow, and in `of` by system id from
    when on each holds."""
    rows: dict[Health, int] = {}
    of = {
        str(sysid): [[round(t_s, 2), rows.setdefault(wrong, len(rows))] for t_s, wrong in seen]
        for sysid, seen in found.watched.health.items()
    }
    listed = [
        {"trouble": list(wrong.texts), **{name: getattr(wrong, name) for name in Health._fields[1:]}} for wrong in rows
    ]
    return {"rows": listed, "of": of}


def _changes(series: Series) -> list[float]:
    """The times at which a state changes."""
    if not len(series.t_s):
        return []
    return series.t_s[np.flatnonzero(np.r_[True, np.diff(series.values) != 0])].tolist()


def _events(found: Findings) -> list[Event]:
    """Decisions, orders, deaths, failsafes, changes of links, and vehicles' own texts from warnings up, by time."""
    told = [Event(t_s, sysid, level_of(severity), text, "text") for t_s, sysid, severity, text in found.texts]
    return sorted([*_decided(found), *told, *found.watched.events], key=lambda event: event.t_s)


def _decided(found: Findings) -> Iterator[Event]:
    for record in found.recorded.decisions:
        if is_event(record):
            try:
                yield event_of(record)
            except (KeyError, TypeError, ValueError):
                continue  # of another version: what the report cannot tell of it, its top has said already


def _broken(found: Findings) -> list[BrokenRow]:
    violations = (record for record in found.recorded.decisions if record["kind"] == "violation")
    return messages.first_broken(sorted(violations, key=lambda record: float(record["at_s"])))
