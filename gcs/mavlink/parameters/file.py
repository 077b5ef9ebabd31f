"""Files of parameters, as ArduPilot, MAVProxy, Mission Planner and QGroundControl write and read them.

    NAME VALUE             between them spaces, tabs, commas or =; a third word @READONLY changes nothing here
    SYSID COMPID NAME VALUE TYPE
    @include FILE          beside the file that says so
    # remark               also behind the rest of a line

A value is decimal, hexadecimal after 0x, nan or inf. A byte-order mark is passed over. Of two lines that give one
parameter, the latter counts.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.parameters.value import ParameterValue, parsed, typed

ANY_VEHICLE = 0
MOST_INCLUDES = 16
HEAD = "# Vehicle-Id Component-Id Name Value Type"
_NAME = re.compile(r"\w{1,16}", re.ASCII)
_BETWEEN = re.compile(r"[\s,=]+")
_FORMS = "write NAME VALUE, or system id, component id, name, value and type"

Address = tuple[int, int]
"""System id, ANY_VEHICLE in a line without one, and component id."""
Numbers = dict[str, int | float]


class FileRefused(ValueError):
    """A file that cannot be read, or holds what is no parameter; the text names file and line."""


def read(file: Path) -> dict[Address, Numbers]:
    """Numbers by name, of each component that the file has lines for. Raises FileRefused."""
    saved: dict[Address, Numbers] = {}
    for address, name, number in _lines(file, ()):
        saved.setdefault(address, {})[name] = number
    if not saved:
        raise FileRefused(f"{file} holds no parameter")
    return saved


def line(address: Address, name: str, value: ParameterValue) -> str:
    """The line of a file that holds a value."""
    return "\t".join((*map(str, address), name, value.text, str(value.kind)))


def of_vehicle(saved: dict[Address, Numbers], sysid: int) -> dict[int, Numbers]:
    """Numbers by component that a vehicle gets of a file: from lines without a system id, and its own; of a file of
    one vehicle all."""
    vehicles = {of for of, _ in saved} - {ANY_VEHICLE}
    found: dict[int, Numbers] = {}
    for (of, compid), numbers in saved.items():
        if of in (ANY_VEHICLE, sysid) or len(vehicles) == 1:
            found.setdefault(compid, {}).update(numbers)
    return found


def _lines(file: Path, within: tuple[Path, ...]) -> Iterator[tuple[Address, str, int | float]]:
    """Lines of a file, and of those that it includes. `within`: the files that include it."""
    try:
        text = file.read_text(encoding="utf-8-sig", errors="replace")
    except OSError as error:
        raise FileRefused(f"{file} cannot be read: {error.strerror}") from None
    within = (*within, file.resolve())
    for number, whole in enumerate(text.splitlines(), 1):
        content = whole.partition("#")[0].strip()
        if not content:
            continue
        try:
            if content.startswith("@include"):
                yield from _included(file, content, within)
            else:
                yield _parameter(content)
        except FileRefused:
            raise
        except ValueError as error:
            raise FileRefused(f"{file}:{number}: {whole.strip()[:60]!r}: {error}") from None


def _included(file: Path, content: str, within: tuple[Path, ...]) -> Iterator[tuple[Address, str, int | float]]:
    words = content.split(maxsplit=1)
    if len(words) != 2 or words[0] != "@include":
        raise ValueError("write @include FILE")
    other = file.parent / words[1]
    if other.resolve() in within or len(within) >= MOST_INCLUDES:
        raise ValueError("it includes itself" if other.resolve() in within else "too many files include each other")
    if not other.is_file():
        raise ValueError(f"there is no file {other}")
    yield from _lines(other, within)


def _parameter(content: str) -> tuple[Address, str, int | float]:
    """Address, name and number of a line. Raises ValueError, in words."""
    words = [word for word in _BETWEEN.split(content) if word]
    if len(words) == 3 and words[2] == "@READONLY":
        words.pop()
    if len(words) == 2:
        address, (name, text) = (ANY_VEHICLE, AUTOPILOT), words
    elif len(words) == 5:
        address, (name, text) = (_id(words[0]), _id(words[1])), words[2:4]
    elif len(words) == 3 and "," in content and words[2].isdecimal():
        raise ValueError("write a decimal number with a point, not with a comma")
    else:
        raise ValueError(f"no parameter: {_FORMS}")
    if not _NAME.fullmatch(name):
        raise ValueError(f"{name!r} is no name of a parameter, which has up to 16 letters, digits and _")
    try:
        number = parsed(text)
    except ValueError:
        raise ValueError(f"{text!r} is no number: {_FORMS}") from None
    if len(words) == 5:
        number = typed(number, _type(words[4])).number
    return address, name, number


def _id(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 255:
        raise ValueError(f"{text!r} is no id: system and component ids are 1 to 255")
    return int(text)


def _type(text: str) -> int:
    if not text.isdecimal():
        raise ValueError(f"{text!r} is no type: write the number of a MAV_PARAM_TYPE")
    return int(text)
