"""Looks of each style name of a panel: calm colours on a dark ground, yellow for look, red only for act.

Without colour the same names differ by weight and reversal alone, and every mark has its own character or word.
"""

from __future__ import annotations

from functools import lru_cache

from rich.style import Style

from gcs.scenario.colours import DARK

GROUND = "#10151b"
RAISED = "#1a222b"
CHOSEN = "#27384a"
TEXT = "#c8d1da"
RED, YELLOW = "#ff6b62", "#e6b84f"

COLOURS: dict[str, str] = {
    "dim": "#77838f",
    "faint": "#3b4651",
    "grid": "#2c353e",
    "title": "bold #9fb3c8",
    "name": "bold #e8eef4",
    "heading": f"#8795a3 on {RAISED}",
    "who": "#a9bccf",
    "well": "#86b894",
    "well-line": "#7f9c88",
    "info": "#8fb6d9",
    "look": YELLOW,
    "act": f"bold {RED}",
    "badge": "reverse",
    "lead": "bold #9ad0c2",
    "meet": "#6fc3c9",
    "held": "#b9a8d8",
    "charge": "#6f93b3",
    "half": "#8d9fb0",
    "progress": "#6f93b3",
    "tab": "#8795a3",
    "key": f"bold #9fc3e6 on {RAISED}",
    "keys": f"#8795a3 on {RAISED}",
    "notice": f"#c8d1da on {RAISED}",
    "craft": TEXT,
    "target": "#e8eef4",
    "trail": "dim",
    "path": "dim",
    "aim": "#46566a",
    "obstacle": "#9a7f66",
    "base": "#b5b58c",
    "traffic": "#d8a37c",
    "scale": "#8795a3",
    "mark": "#5f8f86",
    **{f"vehicle{place}": colour for place, colour in enumerate(DARK)},
    "raised": f"on {RAISED}",
    "chosen": f"on {CHOSEN}",
}
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
def style(names: str, colour: bool = True) -> Style:
    """The style that a name, or several, stand for; later ones win."""
    combined = Style.parse(f"{TEXT} on {GROUND}") if colour else Style()
    table = COLOURS if colour else PLAIN
    for name in names.split():
        if name in table:
            combined += Style.parse(table[name])
    return combined
