"""Lists of points, in which MAVProxy and ArduPilot kept fences and rally points before they were mission items.

A fence: latitude and longitude a line; the first point is where a vehicle goes that has left it, the others are the
polygon's corners, the last of which repeats the first. Rally points: RALLY, latitude, longitude, height above home, and
three numbers of a landing.
"""

from __future__ import annotations

import math
import re

from gcs.missions.errors import MissionFileError
from gcs.missions.items import FenceArea, GlobalPlace, ItemError, MissionPlan, check_place

RALLY = "RALLY"
FENCE = re.compile(r"\s*(#.*\s+)*[-+.\d]+[ \t]+[-+.\d]+\s*[\r\n]")
"""Beginning of a fence's file."""
_CORNERS = 3


def read(text: str, file: str) -> MissionPlan:
    """The plan in a file's text. Raises MissionFileError."""
    lines = [(number, line.split()) for number, line in enumerate(text.splitlines(), 1) if not line.startswith("#")]
    lines = [(number, words) for number, words in lines if words]
    if lines and lines[0][1][0].upper() == RALLY:
        points = [_numbers(file, number, words[1:], 6) for number, words in lines]
        return MissionPlan(rally=tuple(GlobalPlace(lat, lon, height_m, "home") for lat, lon, height_m, *_ in points))
    (back, *corners) = [(lat, lon) for lat, lon in (_numbers(file, number, words, 2) for number, words in lines)]
    if len(corners) > 1 and corners[0] == corners[-1]:
        corners = corners[:-1]
    if len(corners) < _CORNERS:
        raise MissionFileError(f"{file}: a fence is a return point, {_CORNERS} corners or more, and the first again.")
    return MissionPlan(fence=(FenceArea(inclusion=True, corners_deg=tuple(corners)),), fence_return=back)


def _numbers(file: str, number: int, words: list[str], count: int) -> list[float]:
    where = f"{file}: line {number}"
    try:
        found = [float(word) for word in words]
    except ValueError:
        raise MissionFileError(f"{where}: {' '.join(words)[:60]!r} are no numbers.") from None
    if len(found) != count or not all(map(math.isfinite, found)):
        raise MissionFileError(f"{where}: a line has {count} numbers, this one is {' '.join(words)[:60]!r}.")
    try:
        check_place(0, found[0], found[1])
    except ItemError as error:
        raise MissionFileError(f"{where}: {error}.") from None
    return found
