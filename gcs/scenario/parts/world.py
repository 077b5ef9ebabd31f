"""Obstacles, attractors and targets' paths that change in flight (docs/protocol/socket.md#programs-that-act).

A change is plain data, as its decision holds it: what an obstacle or attractor is from now on, by its place in the
list, or the path that a target flies. The changed world is a scenario that differs in that alone. NED, m.
"""

from __future__ import annotations

import bisect
import math
import operator
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal

import numpy as np
from pydantic import ValidationError

from gcs.scenario.document import did_you_mean
from gcs.scenario.model import START_CLEARANCE_M, Scenario, route_conflicts
from gcs.scenario.parts.bases import base_conflicts
from gcs.scenario.parts.surroundings import Attractor, Obstacle
from gcs.scenario.types import Part, Vec3, explained, plain_numbers

WORLD = "world"
"""Kind of decision of a change."""
ADDED, MOVED, REMOVED, PATH = "added", "moved", "removed", "path"
MOST = 1000
"""Obstacles, and attractors, that a world may come to have."""
Kind = Literal["obstacle", "attractor"]
Body = Obstacle | Attractor
Change = Mapping[str, Any]
_PARTS: dict[str, type[Obstacle] | type[Attractor]] = {"obstacle": Obstacle, "attractor": Attractor}
_ROUTE = ("path_m", "speed_m_s", "closed", "laps")


def bodies(scenario: Scenario, kind: Kind) -> tuple[Any, ...]:
    """Obstacles or attractors, each with the name that it is shown by."""
    there: Sequence[Body] = scenario.obstacles if kind == "obstacle" else scenario.attractors
    return tuple(
        one
        if one.name is not None
        else one.model_copy(update={"name": f"{one.kind if isinstance(one, Obstacle) else kind} {place + 1}"})
        for place, one in enumerate(there)
    )


def found(scenario: Scenario, kind: Kind, which: Any) -> int:
    """Place of an obstacle or attractor in its list, by that or by its name. Raises ValueError."""
    there = bodies(scenario, kind)
    names = [one.name for one in there]
    has = f"it has {', '.join(map(str, names[:20]))}{' ...' if len(names) > 20 else ''}" if names else "it has none"
    if isinstance(which, str):
        places = [place for place, name in enumerate(names) if name == which]
        if len(places) > 1:
            raise ValueError(f"{len(places)} {kind}s are named {which!r}: give one's index, such as {places[0]}")
        if not places:
            near = did_you_mean(which, (name for name in names if name))
            raise ValueError(f"there is no {kind} {which[:48]!r} in this session: {has}{near}")
        return places[0]
    try:
        place = operator.index(which)
    except TypeError:
        raise ValueError(f"{which!r:.48} is no {kind}: give its name or its index") from None
    if not -len(there) <= place < len(there):
        raise ValueError(f"there is no {kind} {place} in this session: {has}")
    return place % len(there)


def addition(scenario: Scenario, kind: Kind, content: Any) -> Change:
    """The change that adds an obstacle or attractor, given as the block of keys that a scenario has. Raises
    ValueError."""
    there = bodies(scenario, kind)
    if len(there) >= MOST:
        raise ValueError(f"a session has at most {MOST} {kind}s: remove one first")
    made = _made(kind, content)
    names = {one.name for one in there}
    name = made.name or _fresh_name(made.kind if isinstance(made, Obstacle) else kind, len(there), names)
    if name in names:
        raise ValueError(f"there is an {kind} named {name!r} already: give another name")
    return _change(ADDED, kind, len(there), made.model_copy(update={"name": name}))


def move(scenario: Scenario, kind: Kind, which: Any, at_m: Any) -> Change:
    """The change that takes an obstacle's middle, or an attractor, to (n, e, d), or to (n, e) at its height. Raises
    ValueError."""
    place = found(scenario, kind, which)
    one = bodies(scenario, kind)[place]
    try:
        wanted = [float(number) for number in np.asarray(at_m, np.float64).ravel()]
    except (TypeError, ValueError, OverflowError):
        wanted = []
    if len(wanted) not in (2, 3) or not all(map(math.isfinite, wanted)):
        raise ValueError(f"{at_m!r:.60} is no place: give (n, e, d) in m, or (n, e) to keep the height")
    at = middle(one)
    by = [to - here for to, here in zip(wanted, at, strict=False)] + [0.0] * (3 - len(wanted))
    return _change(MOVED, kind, place, _made(kind, _shifted(one, (by[0], by[1], by[2]))))


def removal(scenario: Scenario, kind: Kind, which: Any) -> Change:
    """The change that takes an obstacle or attractor away. Raises ValueError."""
    place = found(scenario, kind, which)
    return _change(REMOVED, kind, place, None, bodies(scenario, kind)[place].name)


def new_path(
    scenario: Scenario, sysid: int, path_m: Any, *, closed: bool, laps: int, speed_m_s: float | None
) -> Change:
    """The change by which a target flies another path from now on. Raises ValueError."""
    target = next((one for one in scenario.vehicles.targets if one.sysid == sysid), None)
    if target is None:
        raise ValueError(f"vehicle {sysid} is no target: only targets fly paths")
    try:
        points = np.asarray(path_m, np.float64)
    except (TypeError, ValueError, OverflowError):
        points = np.empty(0)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError("path_m is a list of places (n, e, d) in m, such as [(0, 0, -5), (10, 0, -5)]")
    speed_m_s = target.speed_m_s if speed_m_s is None else speed_m_s
    route = plain_numbers({"path_m": points, "speed_m_s": speed_m_s, "closed": closed, "laps": laps})
    change = {"change": PATH, "sysid": sysid, **route}
    changed(scenario, change)
    return change


def sentence(change: Change) -> str:
    """A change for a person."""
    if change["change"] == PATH:
        count = len(change["path_m"])
        return f"Vehicle {change['sysid']} flies another path from now on, of {count} corner{'s' * (count != 1)}."
    name, kind = str(change["name"]), change["part"]
    what = f"The {name}" if name.startswith(kind) else f"The {kind} {name}"
    if change["change"] == REMOVED:
        return f"{what} is removed."
    n, e, d = middle(_made(change["part"], change["now"]))
    return f"{what} is {'added at' if change['change'] == ADDED else 'moved to'} ({n:g}, {e:g}, {d:g}) m NED."


def middle(one: Body) -> Vec3:
    """Where a point or centre is, or the middle of a box or cylinder."""
    if isinstance(one, Attractor):
        return one.point_m
    (n0, e0, d0), (n1, e1, d1) = one.low_m, one.high_m
    return (n0 + n1) / 2.0, (e0 + e1) / 2.0, (d0 + d1) / 2.0


def changed(scenario: Scenario, change: Change) -> Scenario:
    """The world after a change. Raises ValueError, one sentence, where it makes none."""
    what = change.get("change")
    if what == PATH:
        return _with_path(scenario, change)
    kind, place = change.get("part"), change.get("index")
    if what not in (ADDED, MOVED, REMOVED) or kind not in _PARTS or not isinstance(place, int):
        raise ValueError(f"{what!r:.40} is no change of the world")
    there = list(bodies(scenario, "obstacle" if kind == "obstacle" else "attractor"))
    if not 0 <= place < len(there) + (what == ADDED) or (what == ADDED and place != len(there)):
        raise ValueError(f"there is no {kind} {place} in this session: it has {len(there)}")
    there[place : place + 1] = [] if what == REMOVED else [_made(kind, change.get("now"))]
    new = scenario.model_copy(update={f"{kind}s": tuple(there)})
    if kind == "obstacle":
        conflicts = base_conflicts(new.bases, (), new.obstacles, capture_m=math.inf)
        if (conflict := next(conflicts, None)) is not None:
            raise ValueError(conflict.message)
    return new


def meets(scenario: Scenario, change: Change, places: Mapping[str, Vec3]) -> str:
    """Why a change of obstacles makes no sense for vehicles at these places, by their labels; empty where it does."""
    if change.get("part") != "obstacle" or change["change"] == REMOVED:
        return ""
    one = changed(scenario, change).obstacles[change["index"]]
    for label, p_ned in places.items():
        if one.clearance_m(p_ned) < START_CLEARANCE_M:
            return f"the obstacle {one.name} would be inside or within {START_CLEARANCE_M} m of {label}"
    return ""


class Worlds:
    """The worlds of one session, each from its time on; `scenario` is the first."""

    def __init__(self, scenario: Scenario) -> None:
        self._since_s, self._worlds = [-math.inf], [scenario]

    @classmethod
    def recorded(cls, scenario: Scenario, decisions: Iterable[Mapping[str, Any]]) -> Worlds:
        """Those of a recording; a line of another version, which makes no world, is passed over."""
        worlds = cls(scenario)
        for record in decisions:
            if record["kind"] == WORLD:
                try:
                    worlds.change(float(record["t_s"]), record)
                except (ValueError, TypeError, KeyError):
                    continue
        return worlds

    def change(self, t_s: float, change: Change) -> Scenario:
        """The world from a time on, which is not before that of the last one. Raises ValueError."""
        new = changed(self.now, change)
        if t_s > self._since_s[-1]:
            self._since_s.append(t_s)
            self._worlds.append(new)
        else:
            self._worlds[-1] = new
        return new

    def at(self, t_s: float) -> Scenario:
        """The world at a time."""
        return self._worlds[max(bisect.bisect_right(self._since_s, t_s) - 1, 0)]

    def since(self, t_s: float) -> float:
        """When the world of a time began."""
        return self._since_s[max(bisect.bisect_right(self._since_s, t_s) - 1, 0)]

    def __iter__(self) -> Iterator[tuple[float, Scenario]]:
        return iter(zip(self._since_s, self._worlds, strict=True))

    def __len__(self) -> int:
        return len(self._worlds)

    @property
    def now(self) -> Scenario:
        """The last one."""
        return self._worlds[-1]

    @property
    def judged(self) -> Scenario:
        """The scenario by which the goal is judged: the first in which there is an obstacle to keep clear of."""
        return next((one for one in self._worlds if one.obstacles), self._worlds[0])


def _change(what: str, kind: Kind, place: int, now: Body | None, name: str | None = None) -> Change:
    content = None if now is None else now.model_dump(mode="json", exclude_none=True, exclude_defaults=True)
    return {
        "change": what,
        "part": kind,
        "index": place,
        "name": name if now is None else now.name,
        **({} if content is None else {"now": content}),
    }


def _made(kind: str, content: Any) -> Any:
    """The obstacle or attractor of a block of keys. Raises ValueError."""
    if isinstance(content, _PARTS[kind]):
        content = content.model_dump(exclude_defaults=True)
    if not isinstance(content, Mapping):
        example = "{'sphere_m': (4, 0, -5), 'radius_m': 0.5}" if kind == "obstacle" else "{'point_m': (4, 0, -5)}"
        raise ValueError(f"an {kind} is a block of keys, such as {example}, not {content!r:.60}")
    one = _validated(kind, _PARTS[kind], content)
    if isinstance(one, Obstacle) and (fault := one.fault()):
        raise ValueError(fault)
    return one


def _validated(name: str, part: type[Part], content: Mapping[str, Any]) -> Any:
    data = plain_numbers({key: value for key, value in content.items() if value is not None})
    try:
        return part.model_validate(data)
    except ValidationError as error:
        raise ValueError(explained(error, part, data, f"the {name}")) from None


def _shifted(one: Body, by: Vec3) -> dict[str, Any]:
    """Keys of an obstacle or attractor that is elsewhere."""
    content = one.model_dump(exclude_none=True, exclude_defaults=True)
    for key in ("point_m", "sphere_m", "cylinder_m"):
        if key in content:
            content[key] = tuple(x + dx for x, dx in zip(content[key], by, strict=False))
    if "box_m" in content:
        content["box_m"] = tuple(tuple(x + dx for x, dx in zip(c, by, strict=True)) for c in content["box_m"])
    if by[2]:
        content.update({key: content[key] + by[2] for key in ("bottom_m", "top_m") if key in content})
    return content


def _with_path(scenario: Scenario, change: Change) -> Scenario:
    sysid, targets = change.get("sysid"), list(scenario.vehicles.targets)
    place = next((i for i, target in enumerate(targets) if target.sysid == sysid), None)
    if place is None:
        raise ValueError(f"vehicle {sysid} is no target: only targets fly paths")
    own = targets[place].model_dump(mode="json", exclude_defaults=True, exclude=set(_ROUTE))
    target = _validated("target", type(targets[place]), {**own, **{key: change.get(key) for key in _ROUTE}})
    if (conflict := next(route_conflicts(("path_m",), target), None)) is not None:
        raise ValueError(conflict.message)
    targets[place] = targets[place].model_copy(update={key: getattr(target, key) for key in _ROUTE})
    vehicles = scenario.vehicles.model_copy(update={"targets": tuple(targets)})
    return scenario.model_copy(update={"vehicles": vehicles})


def _fresh_name(kind: str, count: int, names: Collection[str | None]) -> str:
    """`sphere 3`, as scenarios name what has no name of its own, or the next number that is free."""
    number = count + 1
    while f"{kind} {number}" in names:
        number += 1
    return f"{kind} {number}"
