"""The error of a file that cannot be read as a plan."""

from __future__ import annotations


class MissionFileError(ValueError):
    """A file that is no plan, or a broken one: one sentence with the file and the line, or the place in its JSON."""
