"""Measures of a flown session: numbers and words, from what its folder holds."""

from __future__ import annotations

import functools
import itertools
import json
import math
from collections.abc import Callable
from pathlib import Path
from types import NoneType
from typing import Any, get_args, get_origin

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel

from gcs.campaign.service_orders import some_order_keeps_all, tankers_alone_serve
from gcs.recording import truth
from gcs.recording.summary import FILE, GoalPartSummary, Summary
from gcs.refuelling.loss_bound import least_lost
from gcs.scenario import goal
from gcs.scenario.document import did_you_mean
from gcs.scenario.model import Scenario
from skytender import geometry
from skytender.safety.patrol import patrol

REACHED_M = 0.5
"""Distance from its last way point within which a vehicle has arrived."""

OFF_THE_GROUND_M, PARTING_S = 0.05, 3.5
"""A vehicle that is higher flies, as does one that started airborne, which has no ground; partners of a transfer have
so long to part when it ends."""

Value = float | str | None


class Flown:
    """A session's folder as measures see it; each file is read once, and only if it is asked for."""

    def __init__(self, folder: Path, scenario: Scenario) -> None:
        self.folder, self.scenario = folder, scenario

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json; raises OSError, ValueError."""
        content = json.loads((self.folder / FILE).read_text(encoding="utf-8"))
        if not isinstance(content, dict):
            raise ValueError(f"{FILE} holds no block of keys")
        return content

    def truth(self, sysid: int) -> NDArray[np.float64]:
        """Rows of (time, north, east, down) as the vehicle itself knew them; none where it recorded nothing."""
        rows = truth.read(self.folder, sysid, truth.PLACE)
        return np.empty((0, len(truth.PLACE))) if rows is None else rows

    @functools.cached_property
    def arrivals_s(self) -> list[float]:
        """When each pursuer with way points first came to its last one, after which it stayed; inf where it did not,
        NaN where it recorded nothing."""
        found = []
        for pursuer in self.scenario.vehicles.pursuers:
            if not pursuer.waypoints_m:
                continue
            rows = self.truth(pursuer.sysid)
            if not len(rows):
                found.append(math.nan)
                continue
            away_m = np.linalg.norm(rows[:, 1:] - np.array(pursuer.waypoints_m[-1]), axis=1)
            outside = np.flatnonzero(away_m > REACHED_M)
            last = int(outside[-1]) + 1 if len(outside) else 0
            found.append(float(rows[last, 0]) if last < len(rows) else math.inf)
        return found


def _lost(flown: Flown) -> float:
    """Vehicles lost as the goal counts them: dead, run dry, landed by a failsafe without an order, never in the air."""
    judged = next(part for part in flown.summary["goal"] if part["part"] == "lost")
    return float(judged["value"] or 0.0)


def _lowest_battery(flown: Flown) -> Value:
    capacity_j = {v.sysid: v.battery.capacity_j for v in flown.scenario.vehicles.pursuers}
    left = [
        100.0 * vehicle["energy"]["remaining_j"] / capacity_j[vehicle["sysid"]]
        for vehicle in flown.summary["vehicles"]
        if vehicle["sysid"] in capacity_j
    ]
    return min(left, default=None)


def _waited(flown: Flown) -> Value:
    """Mean time from the decision to the first joule."""
    fed = [service for service in flown.summary["refuelling"] if service["energy_j"] > 0.0]
    waits = [s["start_s"] - s["decided_at_s"] for s in fed if s["start_s"] is not None]
    return float(np.mean(waits)) if waits else None


def _tankers_way_m(flown: Flown) -> Value:
    ways = [v["path_length_m"] for v in flown.summary["vehicles"] if v["role"] == "tanker"]
    return float(sum(ways)) if ways else None


def _least_lost(flown: Flown) -> Value:
    """By the scenario alone."""
    scenario = flown.scenario
    pursuers, tankers, rules = scenario.vehicles.pursuers, scenario.vehicles.tankers, scenario.refuelling
    if not tankers_alone_serve(scenario):
        return None
    charge_j = [v.battery.capacity_j * (0.01 * v.battery.initial_percent - rules.lands_at) for v in pursuers]
    spare_j = [v.battery.capacity_j * 0.01 * v.battery.initial_percent - v.reserve_j for v in tankers]
    draw_w = [v.battery.hover_w + v.battery.avionics_w for v in pursuers]
    end_s = scenario.goal.duration_s
    return float(least_lost(charge_j, draw_w, end_s=end_s, rate_w=rules.rate_w, spare_j=spare_j, first_s=rules.hold_s))


def _keepable(flown: Flown) -> Value:
    """By the scenario alone."""
    found = some_order_keeps_all(flown.scenario)
    return None if found is None else float(found)


def _arrival(flown: Flown) -> Value:
    """When the last one that arrives at all has arrived."""
    there = [t for t in flown.arrivals_s if math.isfinite(t)]
    return max(there, default=None)


def _stuck(flown: Flown) -> Value:
    """None where one of them recorded nothing."""
    arrivals_s = flown.arrivals_s
    return None if any(map(math.isnan, arrivals_s)) else float(sum(map(math.isinf, arrivals_s)))


def _in_flight(flown: Flown) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
    """Times (k,), places (n, k, 3) of launched vehicles by their own truth, NaN where one recorded nothing, as after
    its death; whether each is off the ground (n, k). None of all where one never recorded anything."""
    launched = flown.scenario.vehicles.launched
    rows = [flown.truth(vehicle.sysid) for vehicle in launched]
    known = rows if all(map(len, rows)) else []
    times_s = np.unique(np.concatenate([np.empty(0), *(one[:, 0] for one in known)]))
    places = np.full((len(rows), len(times_s), 3), np.nan)
    for own, one in zip(places, known, strict=False):
        own[np.searchsorted(times_s, one[:, 0])] = one[:, 1:]
    highest_down_m = np.array([math.inf if vehicle.airborne else -OFF_THE_GROUND_M for vehicle in launched])
    return times_s, places, places[:, :, 2] < highest_down_m[:, np.newaxis]


def _spare(flown: Flown) -> Value:
    """Between two records vehicles are taken to fly straight. Partners of a transfer may be nearer until it has ended,
    or the station has fallen silent, and they have had their time to part."""
    times_s, places, flies = _in_flight(flown)
    sysids = [vehicle.sysid for vehicle in flown.scenario.vehicles.launched]
    silences = flown.scenario.radio.ground_blackouts
    partners = []
    for service in flown.summary["refuelling"]:
        begins_s, ends_s = service["decided_at_s"], math.inf if service["end_s"] is None else service["end_s"]
        ends_s = min([ends_s, *(silence.from_s for silence in silences if silence.from_s >= begins_s)]) + PARTING_S
        partners.append(({service["tanker"], service["receiver"]}, begins_s, ends_s))
    least_m = math.inf
    for i, j in itertools.combinations(range(len(sysids)), 2):
        both = np.isfinite(places[i, :, 0] + places[j, :, 0])
        counts = (flies[i] | flies[j])[1:] & both[1:] & both[:-1]
        for pair, begins_s, ends_s in partners:
            if pair == {sysids[i], sysids[j]}:
                counts = counts & ~((times_s[1:] >= begins_s) & (times_s[1:] <= ends_s))
        away = places[i] - places[j]
        before, way = away[:-1], np.diff(away, axis=0)
        share = -(before * way).sum(axis=1) / np.maximum((way * way).sum(axis=1), 1e-12)
        gap_m = np.linalg.norm(before + np.clip(share, 0.0, 1.0)[:, None] * way, axis=1)
        least_m = min(least_m, float(gap_m[counts].min(initial=math.inf)))
    return least_m - flown.scenario.planner.separation_m if math.isfinite(least_m) else None


def _solid(flown: Flown) -> Value:
    table = geometry.of_scenario(flown.scenario.obstacles)
    _, places, flies = _in_flight(flown)
    return float(geometry.clearance(table, places[flies]).min()) if len(table) and flies.any() else None


def _aircraft(flown: Flown) -> Value:
    """At the times of the records, by where the paths of aircraft lead."""
    times_s, places, flies = _in_flight(flown)
    least_m = math.inf
    for mover in flown.scenario.traffic:
        if not mover.attracts and flies.any():
            path = functools.partial(patrol, mover.path_m, mover.speed_m_s, closed=mover.closed, start_s=mover.start_s)
            there = np.array([path(time_s)[0] for time_s in times_s.tolist()])
            away_m = np.linalg.norm(places - there, axis=2)
            least_m = min(least_m, float(away_m[flies].min()))
    return least_m - flown.scenario.planner.separation_m if math.isfinite(least_m) else None


def _aloft(flown: Flown) -> Value:
    """None of a session at whose end the station is received. The dead do not count: they are lost."""
    times_s, places, flies = _in_flight(flown)
    end_s = flown.summary["sim_time_s"]
    left = any(one.from_s < end_s <= one.to_s for one in flown.scenario.radio.ground_blackouts)
    if not left or not len(times_s):
        return None if left and len(flies) else 0.0
    dead = {vehicle["sysid"] for vehicle in flown.summary["vehicles"] if vehicle["final_mode"] == "dead"}
    alive = [vehicle.sysid not in dead for vehicle in flown.scenario.vehicles.launched]
    recorded = np.isfinite(places[:, :, 2])
    last = len(times_s) - 1 - np.argmax(recorded[:, ::-1], axis=1)
    return float(flies[np.arange(len(last)), last][alive].sum())


def _density(flown: Flown) -> Value:
    """By the scenario alone: the volume is the box around starts and way points, widened by half a separation."""
    vehicles, separation_m = flown.scenario.vehicles.all, flown.scenario.planner.separation_m
    places = [v.start_m for v in vehicles] + [p for v in flown.scenario.vehicles.pursuers for p in v.waypoints_m]
    if not separation_m:
        return None
    sides = (np.ptp(np.array(places), axis=0) + separation_m) / separation_m
    return len(vehicles) / float(sides[0] * sides[1] * sides[2])


def _of_vehicles(key: str, of: Callable[[list[float]], float]) -> Callable[[Flown], Value]:
    def measure(flown: Flown) -> Value:
        values = [v[key] for v in flown.summary["vehicles"] if v[key] is not None]
        return float(of(values)) if values else None

    return measure


def _from_summary(key: str) -> Callable[[Flown], Value]:
    return lambda flown: _plain(flown.summary[key])


SHIPPED: dict[str, tuple[Callable[[Flown], Value], str]] = {
    "outcome": (_from_summary("outcome"), "`met`, or the first part of the goal that was not"),
    "min_separation_m": (_from_summary("min_separation_m"), "least distance of two vehicles, m"),
    "min_clearance_m": (_from_summary("min_clearance_m"), "least distance to an obstacle, m"),
    "spare_m": (_spare, "least distance of two launched vehicles less the separation, in any mode, m"),
    "solid_m": (_solid, "least distance to an obstacle of a launched vehicle in flight, in any mode, m"),
    "aircraft_m": (_aircraft, "least distance to traffic of a launched vehicle less the separation, in any mode, m"),
    "aloft": (_aloft, "launched vehicles that a station that stays silent leaves in the air"),
    "density": (_density, "separation cubed times vehicles by the volume in which they start and go to way points"),
    "lost": (_lost, "vehicles lost: dead, run dry, landed by a failsafe, never in the air"),
    "lowest_battery": (_lowest_battery, "least charge of a pursuer at the end, % of its capacity"),
    "delivered_j": (lambda f: float(sum(s["energy_j"] for s in f.summary["refuelling"])), "energy delivered, J"),
    "refuelled": (lambda f: float(len(f.summary["refuel_order"])), "services that ended, and delivered energy"),
    "lost_somebody": (lambda f: float(bool(_lost(f))), "1 where a vehicle was lost, else 0"),
    "least_lost": (_least_lost, "vehicles that no schedule could have kept, at least; not known with bases or join_s"),
    "keepable": (_keepable, "1 where some order of services keeps everyone, 0 where none does, by a search; the same"),
    "tankers_way_m": (_tankers_way_m, "sum of the tankers' ways, m"),
    "tanker_idle_s": (_from_summary("tanker_idle_s"), "tankers' time free while a vehicle waited, s"),
    "wait_s": (_waited, "mean time from a decision to its transfer, s"),
    "time_to_goal_s": (_arrival, "when the last arriving pursuer came to its last way point and stayed, s"),
    "stuck": (_stuck, "pursuers that did not come to theirs, or not to stay"),
    "path_length_m": (_of_vehicles("path_length_m", sum), "sum of all vehicles' ways, m"),
    "control_effort": (_of_vehicles("control_effort", sum), "sum of all vehicles' control efforts"),
    "max_tracking_error_m": (_of_vehicles("max_tracking_error_m", max), "greatest distance from a planned path, m"),
    "sim_time_s": (_from_summary("sim_time_s"), "session time flown, s"),
}
"""By name: how it is taken, and what it means."""
DEFAULT = ("outcome", "min_separation_m", "min_clearance_m", "lost")
NAMES = tuple(SHIPPED)
WORDS = ("outcome",)
"""Measures that are words; all others are numbers."""


def fault(name: str, *, number: bool = False) -> str | None:
    """Why there is no measure of this name, or none that is a number, as a sentence; None where there is one.

    It is a shipped one, or a key path into a summary, as deep as its models go.
    """
    if is_word(name):
        return f"{name} is no number" if number else None
    if name in SHIPPED:
        return None
    kind: Any = Summary
    parts = name.split(".")
    for i, part in enumerate(parts):
        known, others = _inside(kind)
        kind = known.get(part, others(part))
        if kind is None:
            beside = (".".join([*parts[:i], one, *parts[i + 1 :]]) for one in known)
            return f"there is no measure {name!r}{did_you_mean(name, [*NAMES, *beside])}"
    return None if kind in (bool, int, float) else f"{name} is no number"


def _inside(kind: Any) -> tuple[dict[str, Any], Callable[[str], Any]]:
    """Names of what a value of a type in the summary holds, with their types, and the type by any other name."""
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        fields = {field.alias or name: field.annotation for name, field in kind.model_fields.items()}
        return {name: _present(annotation) for name, annotation in fields.items()}, lambda _: None
    *keys, of = get_args(kind) or (None,)
    if get_origin(kind) is list:
        parts = goal.BY_NAME if of is GoalPartSummary else ()  # by part, as in goal.separation.met
        return dict.fromkeys(parts, of), lambda part: of if part.isdecimal() else None
    if get_origin(kind) is dict:
        return dict.fromkeys(get_args(keys[0]), of), lambda _: of if keys[0] is str else None
    return {}, lambda _: None


def _present(annotation: Any) -> Any:
    """A type without the None that its value may be instead."""
    kinds = [kind for kind in get_args(annotation) if kind is not NoneType]
    return kinds[0] if NoneType in get_args(annotation) else annotation


def is_word(name: str) -> bool:
    """Whether its values are text."""
    if name in SHIPPED:
        return name in WORDS
    field = Summary.model_fields.get(name)
    return field is not None and field.annotation in (str, str | None)


def measure(name: str, flown: Flown) -> Value:
    """A measure's value; None where the session has none. Of a list in the summary: by position, or by `part`."""
    if name in SHIPPED:
        return SHIPPED[name][0](flown)
    node: Any = flown.summary
    for part in name.split("."):
        if isinstance(node, list):
            node = node[int(part)] if part.isdecimal() and int(part) < len(node) else _goal_part(node, part)
        else:
            node = node.get(part) if isinstance(node, dict) else None
    value = _plain(node)
    return value if is_word(name) == isinstance(value, str) or value is None else None


def _goal_part(listed: list[Any], name: str) -> Any:
    """The part of a goal that has this name; None where the session's goal has none."""
    return next((one for one in listed if isinstance(one, dict) and one.get("part") == name), None)


def _plain(value: Any) -> Value:
    if isinstance(value, bool | int | float):
        return float(value) if math.isfinite(value) else None
    return value if isinstance(value, str) else None
