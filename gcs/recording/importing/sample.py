"""One message that a vehicle would have sent."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple


class ImportFailed(Exception):
    """A file that cannot be read as a recording; one sentence."""


class Sample(NamedTuple):
    """A MAVLink message by its name and fields, in MAVLink's own units, as of a time."""

    t_us: int
    """µs since the Unix epoch where the log knows it, else since the vehicle's start"""
    sysid: int
    message: str
    fields: Mapping[str, Any]
