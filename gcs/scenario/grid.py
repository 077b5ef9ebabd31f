"""The short form of a scenario file for many things alike: `grid` in a vehicle or an obstacle.

    - {sysid: 1, start_m: [0, 0, 0], grid: {count: 6, columns: 3, spacing_m: [2, 5]}}

stands for six, row by row: the next in a row lies spacing_m[1] further along the second axis, the next row spacing_m[0]
further along the first. System ids count up. Everything else is the same for all.
"""

import copy
from typing import Any

from gcs.scenario.document import Document, KeyPath, ScenarioError

PLACES = ("start_m", "home_m", "point_m", "sphere_m", "box_m", "cylinder_m", "path_m", "waypoints_m")
MOST = 10_000
_FORM = "grid must be {count: N, columns: N, spacing_m: [along the first axis, along the second]}"


def expand(document: Document, group: KeyPath) -> None:
    """Write out every grid in the list at `group`; problems found later are still shown where the file has them.

    Raises ScenarioError for a grid that is none.
    """
    items = document.value(group)
    if not isinstance(items, list) or not any(isinstance(item, dict) and "grid" in item for item in items):
        return
    written: list[Any] = []
    for i, item in enumerate(items):
        copies = [item]
        if isinstance(item, dict) and "grid" in item:
            fields = {key: value for key, value in item.items() if key != "grid"}
            grid = _grid(item["grid"])
            if grid is None:
                raise ScenarioError([document.problem((*group, i, "grid"), _FORM)])
            count, columns, (first_m, second_m) = grid
            copies = [_copied(fields, k, k // columns * first_m, k % columns * second_m) for k in range(count)]
        for made in copies:
            document.origins[(*group, len(written))] = (*group, i)
            written.append(made)
    items[:] = written


def _grid(grid: Any) -> tuple[int, int, tuple[float, float]] | None:
    """count, columns and spacing; None where it is no grid."""
    if not isinstance(grid, dict) or grid.keys() != {"count", "columns", "spacing_m"}:
        return None
    count, columns, spacing = grid["count"], grid["columns"], grid["spacing_m"]
    if not all(type(number) is int and 0 < number <= MOST for number in (count, columns)):
        return None
    if not isinstance(spacing, list) or [type(x) in (int, float) for x in spacing] != [True, True]:
        return None
    return count, columns, (float(spacing[0]), float(spacing[1]))


def _copied(fields: dict[str, Any], k: int, first_m: float, second_m: float) -> dict[str, Any]:
    """The k-th of a grid."""
    own = copy.deepcopy(fields)  # so that one of many can be changed alone
    made = {key: _moved(value, first_m, second_m) if key in PLACES else value for key, value in own.items()}
    if isinstance(made.get("sysid"), int):
        made["sysid"] += k
    return made


def _moved(place: Any, first_m: float, second_m: float) -> Any:
    """A place, or a list of places, moved; what is neither stays for the scenario's own checks."""
    if isinstance(place, list) and place and all(isinstance(part, list) for part in place):
        return [_moved(part, first_m, second_m) for part in place]
    if isinstance(place, list) and len(place) >= 2 and all(type(x) in (int, float) for x in place):
        return [place[0] + first_m, place[1] + second_m, *place[2:]]
    return place
