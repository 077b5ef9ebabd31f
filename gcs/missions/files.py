"""A plan from a file, whatever its format."""

from __future__ import annotations

from pathlib import Path

from gcs.missions import point_lists, qgc_plan, waypoint_file
from gcs.missions.errors import MissionFileError
from gcs.missions.items import MissionPlan

MOST_BYTES = 1 << 24
_LOOKED_AT = 4096


def load(path: Path) -> MissionPlan:
    """The plan in a file: QGroundControl's .plan, QGC WPL 110, or a point list. Raises MissionFileError, OSError."""
    if path.exists() and not path.is_file():
        raise MissionFileError(f"{path} is no file.")
    with path.open("rb") as file:
        content = file.read(MOST_BYTES + 1)
    if len(content) > MOST_BYTES:
        raise MissionFileError(f"{path} has more than {MOST_BYTES >> 20} MiB: is it a plan?")
    return read(content, str(path))


def is_one(path: Path) -> bool:
    """Whether a file begins as one that `load` reads. Raises OSError."""
    with path.open("rb") as file:
        text = file.read(_LOOKED_AT).decode("utf-8-sig", errors="replace")
    return (
        text.lstrip().startswith("{")
        or text.startswith((waypoint_file.BEGIN, point_lists.RALLY))
        or bool(point_lists.FENCE.match(text))
    )


def read(content: bytes, file: str) -> MissionPlan:
    """The plan in a file's content. Raises MissionFileError."""
    text = content.decode("utf-8-sig", errors="replace")
    if text.lstrip().startswith("{"):
        return qgc_plan.read(content, file)
    if text.startswith(waypoint_file.BEGIN):
        return waypoint_file.read(text, file)
    if text.startswith(point_lists.RALLY) or point_lists.FENCE.match(text):
        return point_lists.read(text, file)
    raise MissionFileError(
        f"{file} is neither a QGroundControl plan nor a way point file that begins with QGC WPL 110."
    )
