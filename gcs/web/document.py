"""The page's HTML: for the server with links to its script and style, for report.html with both inside."""

from __future__ import annotations

import base64
import hashlib
import json
from dataclasses import asdict
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any, Literal

from gcs.scenario.colours import ALARM_DARK, ALARM_LIGHT, DARK, LIGHT, SOURCES_DARK, SOURCES_LIGHT
from gcs.session.order_table import ORDERS
from gcs.telemetry.health import CONDITIONS, Condition

SCRIPT, STYLE = "page.js", "page.css"
REPORT_FILE = "report.html"
"""The report's name in a session's folder."""
_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark"><title>{title}</title><link rel="icon" href="data:,">
<link rel="stylesheet" href="page.css"></head><body class="served">
<main id="app"></main>
<noscript><p class="verdict bad">The page needs JavaScript.</p></noscript>
<script type="application/json" id="config">{config}</script>
<script src="page.js"></script>
</body></html>
"""


@cache
def built(name: str) -> str:
    """A file of the page as it was built (gcs/web/page/build.sh)."""
    return files("gcs.web").joinpath("built", name).read_text(encoding="utf-8")


def config(source: Literal["server", "report"], tiles: str | None = None) -> dict[str, Any]:
    """Settings of the script: palette, operator's orders, conditions of vehicles, where flight and tiles come from."""
    palette = {
        "light": LIGHT,
        "dark": DARK,
        "sources": {"light": SOURCES_LIGHT, "dark": SOURCES_DARK},
        "alarm": {"light": ALARM_LIGHT, "dark": ALARM_DARK},
    }
    return {
        "palette": palette,
        "orders": [asdict(order) for order in ORDERS],
        "conditions": [_condition(one) for one in CONDITIONS],
        "source": source,
        "tiles": tiles,
    }


def _condition(condition: Condition) -> dict[str, str]:
    """A condition's name and title, and what the first figure beside it says more: `Low battery: 5 (48 s left)`."""
    low = condition is Condition.LOW
    return {"name": condition, "title": "Low battery" if low else condition.capitalize(), "unit": "left" if low else ""}


def as_json(content: Any) -> str:
    """Data for a script element: what could end the element is escaped."""
    return json.dumps(content, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")


def served(tiles: str | None = None) -> str:
    """The page that a server gives; `tiles` is the address of its map's tiles."""
    return _PAGE.format(title=escape("Skytender"), config=as_json(config("server", tiles)))


def source_hash(text: str) -> str:
    """A script or style as Content-Security-Policy names it."""
    digest = hashlib.sha256(text.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode()}'"
