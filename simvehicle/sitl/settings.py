"""Parameters that an autopilot of others starts with, and which of its versions have each of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple


class Setting(NamedTuple):
    """A parameter that is given to an autopilot at its start."""

    name: str
    value: float
    since: str = ""
    """first release that has it; empty: all have, as far back as they fly"""
    until: str = ""
    """last release that does something with it; empty: today's does"""

    def applies(self, release: str) -> bool:
        """Whether it does something in a release, such as 4.7.0 or 1.18.0-rc1."""
        return _order(self.since) <= _order(release)[:2] and (
            not self.until or _order(release)[:2] <= _order(self.until)
        )


def given(settings: Iterable[Setting]) -> dict[str, float]:
    """All values by name: which release it is shows only once it runs, and each passes over names that it lacks."""
    return {setting.name: setting.value for setting in settings}


def _order(release: str) -> tuple[int, ...]:
    return tuple(int(part) for part in release.split("-", maxsplit=1)[0].split(".") if part)
