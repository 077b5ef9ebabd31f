"""A scenario's `plan`: fence and rally points from a file of QGroundControl, Mission Planner or MAVProxy.

They become the scenario's `fence` and `rally_m` as it is read, so that nothing else needs to know of the file.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gcs.scenario.document import Document, KeyPath, ScenarioError
from gcs.scenario.types import MOST_M
from skytender import elementary

if TYPE_CHECKING:
    from gcs.missions.items import MissionPlan

_FILLED = ("fence", "rally_m")


def fill(document: Document) -> None:
    """Replace `plan` by what its file holds. Raises ScenarioError; what else is wrong is left to the model."""
    value, origin = document.data.get("plan"), _origin(document.data.get("origin"))
    if not isinstance(value, str) or origin is None:
        return
    problems = [
        document.problem((key,), f"{key} stands in the file that plan names; leave out one of them", at_key=True)
        for key in _FILLED
        if key in document.data
    ]
    if problems:
        raise ScenarioError(problems)
    plan = read_plan(document, value, ("plan",))
    if not plan.fence and not plan.rally:
        raise ScenarioError([document.problem(("plan",), f"{value} holds neither a geofence nor rally points")])
    mirror = -1.0 if document.data.get("axes") == "paper" else 1.0
    areas, rally = _ned(plan, origin, mirror)
    if any(elementary.norm(place) > MOST_M for place in _places(areas, rally)):
        message = f"{value} lies more than {MOST_M / 1e3:.0f} km from the scenario's origin"
        raise ScenarioError([document.problem(("plan",), message)])
    for key, found in (("fence", areas), ("rally_m", rally)):
        if found:
            document.data[key] = found
            document.origins[key,] = ("plan",)
    del document.data["plan"]


def read_plan(document: Document, value: str, path: KeyPath) -> MissionPlan:
    """The plan in a file beside the scenario that the key at `path` names. Raises ScenarioError."""
    from gcs.missions.errors import MissionFileError  # noqa: PLC0415 - most scenarios have no such file
    from gcs.missions.files import load  # noqa: PLC0415

    def refused(message: str) -> ScenarioError:
        return ScenarioError([document.problem(path, message)])

    try:
        plan = load(Path(document.file).parent / value)
    except MissionFileError as error:
        raise refused(str(error)) from None
    except (OSError, ValueError) as error:  # a name with a zero byte is a ValueError
        raise refused(f"{value} cannot be read: {getattr(error, 'strerror', None) or error}") from None
    about_mission = path[-1] == "mission"
    unknown = [text for text in plan.left_out if text.startswith("mission.") is about_mission]
    if unknown:
        raise refused(f"{value}: {'; '.join(unknown)}")
    return plan


def _places(fence: dict[str, Any], rally: list[Any]) -> Iterator[list[float]]:
    yield from rally
    for area in (area for areas in fence.values() for area in areas):
        yield from area.get("polygon_m") or [area["circle_m"]]


def _origin(given: Any) -> tuple[float, float, float] | None:
    """The scenario's origin, deg, deg, m; None where it is none, as the model will say."""
    values: list[Any] = [given.get(key) for key in ("lat_deg", "lon_deg", "alt_m")] if isinstance(given, dict) else []
    if not values or not all(type(value) in (int, float) and math.isfinite(value) for value in values):
        return None
    lat_deg, lon_deg, alt_m = values
    return float(lat_deg), float(lon_deg), float(alt_m)


def _ned(plan: MissionPlan, origin: tuple[float, float, float], mirror: float) -> tuple[dict[str, Any], list[Any]]:
    """`fence` and `rally_m` as the file would have them; mirror: -1 where its axes are the paper's."""
    from gcs.missions.placed import plane_ne  # noqa: PLC0415 - only where a plan is read

    def place(at_deg: tuple[float, float]) -> list[float]:
        north_m, east_m = plane_ne(at_deg, origin)
        return [north_m, mirror * east_m]

    fence: dict[str, Any] = {}
    for area in plan.fence:
        corners = [place(at) for at in area.corners_deg]
        shape = {"polygon_m": corners} if area.radius_m is None else {"circle_m": corners[0], "radius_m": area.radius_m}
        fence.setdefault("inside" if area.inclusion else "outside", []).append(shape)
    return fence, [place((point.lat_deg, point.lon_deg)) for point in plan.rally]
