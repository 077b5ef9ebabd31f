"""Names of a process from its command line, before anything of it is parsed."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

LAST_SYSID = 254


def sysid_of(argv: Sequence[str]) -> int:
    """The system id that an argv stands for; 255 for traffic, 0 where it names none."""
    if argv and argv[0] == "traffic":
        return 255
    for word, following in pairwise(argv):
        if word == "--sysid" and following.isdecimal():
            return int(following)
    return 0


def title_of(argv: Sequence[str]) -> str:
    """Process title of this argv: `simvehicle 3`, a block `simvehicle 3-27`, or `simvehicle traffic`."""
    first = sysid_of(argv)
    if not 0 < first <= LAST_SYSID:
        return "simvehicle traffic" if first else "simvehicle"
    counts = [int(following) for word, following in pairwise(argv) if word == "--count" and following.isdecimal()]
    last = first + (counts[-1] if counts else 1) - 1
    return f"simvehicle {first}" if last == first else f"simvehicle {first}-{last}"
