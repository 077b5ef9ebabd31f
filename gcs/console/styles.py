"""Looks of each style name of a panel: calm colours on a dark or a light ground, yellow for look, red only for act.

Without colour the same names differ by weight and reversal alone, and every mark has its own character or word.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Literal, NamedTuple

from rich.style import Style

from gcs.scenario.colours import DARK, LIGHT

Look = Literal["dark", "light", "plain"]
"""`plain`: without colour"""


class Ground(NamedTuple):
    """Colours of the areas that text stands on, and of the text."""

    ground: str
    raised: str
    chosen: str
    frame: str
    text: str


GROUNDS = {
    "dark": Ground("#10151b", "#1a222b", "#27384a", "#5c7894", "#c8d1da"),
    "light": Ground("#ffffff", "#eef1f4", "#cfe0f2", "#6d8399", "#1f2933"),
}
_INK = {
    # name: (on a dark ground, on a light one)
    "dim": ("#77838f", "#5f6b77"),
    "faint": ("#3b4651", "#c3ccd4"),
    "grid": ("#2c353e", "#dde3e8"),
    "title": ("bold #9fb3c8", "bold #34526f"),
    "name": ("bold #e8eef4", "bold #10151b"),
    "who": ("#a9bccf", "#34526f"),
    "well": ("#86b894", "#1e6b3a"),
    "well-line": ("#7f9c88", "#2f6b46"),
    "info": ("#8fb6d9", "#1c5d99"),
    "look": ("#e6b84f", "#8a5a00"),
    "act": ("bold #ff6b62", "bold #b3261e"),
    "lead": ("bold #9ad0c2", "bold #0b6b58"),
    "meet": ("#6fc3c9", "#0b6a73"),
    "held": ("#b9a8d8", "#5b3f96"),
    "charge": ("#6f93b3", "#3d6a94"),
    "half": ("#8d9fb0", "#5a6c7d"),
    "progress": ("#6f93b3", "#3d6a94"),
    "tab": ("#8795a3", "#52606d"),
    "craft": ("#c8d1da", "#1f2933"),
    "target": ("#e8eef4", "#10151b"),
    "aim": ("#46566a", "#9fb0c2"),
    "obstacle": ("#9a7f66", "#7a5c40"),
    "base": ("#b5b58c", "#6b6b2f"),
    "traffic": ("#d8a37c", "#9a5320"),
    "scale": ("#8795a3", "#52606d"),
    "mark": ("#5f8f86", "#3f7a6e"),
}


def _colours(look: Literal["dark", "light"]) -> dict[str, str]:
    dark, on = look == "dark", GROUNDS[look]
    soft, key = ("#8795a3", "#9fc3e6") if dark else ("#52606d", "#1c5d99")
    return {
        **{name: inks[0 if dark else 1] for name, inks in _INK.items()},
        **{f"vehicle{place}": colour for place, colour in enumerate(DARK if dark else LIGHT)},
        "heading": f"{soft} on {on.raised}",
        "badge": "reverse",
        "key": f"bold {key} on {on.raised}",
        "keys": f"{soft} on {on.raised}",
        "notice": f"{on.text} on {on.raised}",
        "trail": "dim",
        "path": "dim",
        "raised": f"on {on.raised}",
        "chosen": f"on {on.chosen}",
    }


COLOURS: dict[str, dict[str, str]] = {"dark": _colours("dark"), "light": _colours("light")}
PLAIN: dict[str, str] = {
    "title": "bold",
    "name": "bold",
    "heading": "underline",
    "look": "bold",
    "act": "bold",
    "badge": "reverse",
    "lead": "bold",
    "key": "bold reverse",
    "keys": "reverse",
    "notice": "reverse",
    "chosen": "reverse",
}


@lru_cache(maxsize=512)
def style(names: str, look: Look = "dark") -> Style:
    """The style that a name, or several, stand for; later ones win."""
    table = PLAIN if look == "plain" else COLOURS[look]
    combined = Style() if look == "plain" else Style.parse(f"{GROUNDS[look].text} on {GROUNDS[look].ground}")
    for name in names.split():
        if name in table:
            combined += Style.parse(table[name])
    return combined


def look_of(environment: Mapping[str, str]) -> Literal["dark", "light"]:
    """The look for a terminal's ground: COLORFGBG, where a terminal sets it, ends with its colour's number."""
    ground = environment.get("COLORFGBG", "").rpartition(";")[2]
    return "light" if ground in ("7", "15") else "dark"
