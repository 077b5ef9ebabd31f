"""A failing scenario made small: vehicles, obstacles and digits are taken away while it still fails.

Delta debugging (A. Zeller, R. Hildebrandt, IEEE Trans. Softw. Eng. 28, 2002) over each list in turn, until nothing
more can go.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from pydantic import ValidationError

from gcs.campaign import measures
from gcs.campaign.flight import fly
from gcs.campaign.model import Expectation
from gcs.scenario.model import Scenario
from gcs.session.spawning.spawner import SessionSpawner

LISTS = (
    ("vehicles", "pursuers"),
    ("obstacles",),
    ("traffic",),
    ("attractors",),
    ("vehicles", "tankers"),
    ("vehicles", "targets"),
    ("bases",),
)
DIGITS = (1, 2, 3)

Fails = Callable[[dict[str, Any]], bool]


def failing(
    sessions: SessionSpawner, expect: Mapping[str, Expectation], notify: Callable[[str], object] = lambda _: None
) -> Fails:
    """Whether a scenario, as plain data, can be flown and fails; flights are reported and not repeated."""
    known: dict[str, bool] = {}

    def fails(data: dict[str, Any]) -> bool:
        try:
            scenario = Scenario.model_validate(data)
        except ValidationError:
            return False
        key = scenario.model_dump_json()
        if key not in known:
            flight = fly(sessions, scenario, f"shrink-{len(known)}")
            try:
                known[key] = bool(not flight.error and fault(measures.Flown(flight.folder, scenario), expect))
            finally:
                flight.discard()
            listed = ", ".join(f"{len(_listed(data, path))} {path[-1]}" for path in LISTS if _listed(data, path))
            notify(f"{'still fails' if known[key] else 'passes'}: {listed}")
        return known[key]

    return fails


def fault(flown: measures.Flown, expect: Mapping[str, Expectation]) -> str | None:
    """Why a flown session is not as expected; without expectations, that its goal was not met."""
    wanted = expect or {"outcome": Expectation(equals="met")}
    return next((why for name, one in wanted.items() if (why := one.fault(name, measures.measure(name, flown)))), None)


def shrink(scenario: Scenario, fails: Fails) -> Scenario:
    """The smallest scenario found that still fails. Raises ValueError where the given one does not."""
    data = scenario.model_dump(by_alias=True)
    if not fails(data):
        raise ValueError("it does not fail: its session is as expected")
    before: dict[str, Any] | None = None
    while data != before:
        before = data
        for path in LISTS:
            data = _fewer(data, path, fails)
    for digits in DIGITS:
        rounded = _rounded(data, digits)
        if fails(rounded):
            data = rounded
            break
    return Scenario.model_validate(data)


def _fewer(data: dict[str, Any], path: tuple[str, ...], fails: Fails) -> dict[str, Any]:
    """The same with as few in one list as still fail (ddmin)."""
    items, parts = list(_listed(data, path)), 2
    if items and fails(_with(data, path, [])):
        return _with(data, path, [])
    while len(items) >= 2:
        size = -(-len(items) // parts)
        chunks = [items[i : i + size] for i in range(0, len(items), size)]
        candidates = [(chunk, 2) for chunk in chunks] if parts > 2 or len(chunks) == 2 else []
        candidates += [
            ([item for other in chunks if other is not chunk for item in other], max(parts - 1, 2)) for chunk in chunks
        ]
        for candidate, following in candidates:
            if 0 < len(candidate) < len(items) and fails(_with(data, path, candidate)):
                items, parts = candidate, following
                break
        else:
            if parts >= len(items):
                break
            parts = min(2 * parts, len(items))
    return _with(data, path, items)


def _listed(data: dict[str, Any], path: tuple[str, ...]) -> Any:
    node: Any = data
    for part in path:
        node = node[part]
    return node


def _with(data: dict[str, Any], path: tuple[str, ...], items: list[Any]) -> dict[str, Any]:
    """The same data with another list; what names a vehicle that is gone goes too."""
    first, *rest = path
    changed = {**data, first: tuple(items) if not rest else {**data[first], rest[0]: tuple(items)}}
    if first == "vehicles":
        groups = changed["vehicles"]
        there = {v["sysid"] for group in ("pursuers", "targets", "tankers") for v in groups[group]}
        radio = changed["radio"]
        kept = tuple(blackout for blackout in radio["blackouts"] if blackout["sysid"] in there)
        changed["radio"] = {**radio, "blackouts": kept}
    return changed


def _rounded(node: Any, digits: int) -> Any:
    """Plain data with its places and numbers to so many decimals; what is a setting of the origin stays."""
    if isinstance(node, dict):
        return {key: value if key in ("origin", "clock") else _rounded(value, digits) for key, value in node.items()}
    if isinstance(node, list | tuple):
        return tuple(_rounded(one, digits) for one in node)
    return round(node, digits) if isinstance(node, float) else node
