"""`QGC WPL 110`: items as lines of text, the format of Mission Planner, MAVProxy and ArduPilot (.waypoints, .txt).

    index  current  frame  command  p1  p2  p3  p4  x/latitude  y/longitude  z/height  autocontinue

A file holds a mission, a fence or rally points. Item 0 of a mission is home; version 120, of old QGroundControls, has
none. Lines that begin with # are comments.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from gcs.missions.errors import MissionFileError
from gcs.missions.items import ItemError, MissionItem, MissionPlan, sorted_out
from skytender import mavlink as mav

BEGIN = "QGC WPL"
_HOME_FIRST = {"110": True, "120": False}
_FIELDS = ("index", "current", "frame", "command", "p1", "p2", "p3", "p4", "x", "y", "z", "autocontinue")
_WHOLE = {"index": 65535, "current": 2, "frame": 255, "command": 65535, "autocontinue": 1}
"""Fields that are whole numbers from 0, and their greatest values; 2 as current is the one that is flown to at once."""


def read(text: str, file: str) -> MissionPlan:
    """The plan in a file's text. Raises MissionFileError."""
    lines = text.splitlines()
    version = lines[0].split() if lines else []
    if version[:2] != BEGIN.split():
        raise MissionFileError(f"{file}: line 1: a way point file begins with QGC WPL 110.")
    if len(version) != 3 or version[2] not in _HOME_FIRST:
        raise MissionFileError(f"{file}: line 1: version {' '.join(version[2:])} is not read, only 110 and 120.")
    items: list[MissionItem] = []
    numbers: list[int] = []
    for number, line in enumerate(lines[1:], 2):
        if (words := line.split()) and not line.startswith("#"):
            numbers.append(number)
            items.append(_item(words, f"{file}: line {number}", first=not items))
    try:
        return sorted_out(items, has_home=_HOME_FIRST[version[2]])
    except ItemError as error:
        raise MissionFileError(f"{file}: line {numbers[error.index]}: {error}.") from None


def _item(words: list[str], where: str, *, first: bool) -> MissionItem:
    if len(words) != len(_FIELDS):
        raise MissionFileError(f"{where}: an item has {len(_FIELDS)} fields, this one {len(words)}.")
    numbers: dict[str, float] = {}
    for field, word in zip(_FIELDS, words, strict=True):
        most = _WHOLE.get(field)
        try:
            numbers[field] = float(word) if most is None else int(word)
        except ValueError:
            kind = "number" if most is None else "whole number"
            raise MissionFileError(f"{where}: {field} is {word[:40]!r}, no {kind}.") from None
        if math.isinf(numbers[field]) or (most is not None and not 0 <= numbers[field] <= most):
            limits = "finite" if most is None else f"from 0 to {most}"
            raise MissionFileError(f"{where}: {field} is {word[:40]}, not {limits}.")
    command = int(numbers["command"])
    if first and command == 0:  # as Mission Planner writes home
        command = mav.MAV_CMD_NAV_WAYPOINT
    p1, p2, p3, p4, x, y, z = (numbers[field] for field in _FIELDS[4:11])
    params = (p1, p2, p3, p4, x, y, z)
    return MissionItem(
        command,
        int(numbers["frame"]),
        params,
        autocontinue=bool(numbers["autocontinue"]),
        current=numbers["current"] == 1,
    )


def write(items: Iterable[MissionItem]) -> str:
    """Items as the text of a file, version 110, every number to its last digit."""
    lines = [f"{BEGIN} 110"]
    for index, item in enumerate(items):
        words = [index, int(item.current), item.frame, item.command]
        lines.append("\t".join(map(str, [*words, *(f"{value:.17g}" for value in item.params), int(item.autocontinue)])))
    return "\n".join(lines) + "\n"
