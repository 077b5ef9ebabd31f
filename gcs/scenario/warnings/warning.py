"""One warning of a scenario."""

from __future__ import annotations

from typing import NamedTuple


class ScenarioWarning(NamedTuple):
    """One thing that is likely to go wrong: what it is about, in a word, and a sentence."""

    about: str
    text: str
