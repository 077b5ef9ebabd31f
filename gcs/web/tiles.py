"""Address of map tiles (Web Mercator, {z}/{x}/{y}) that the page's map lies on where a user names one."""

from __future__ import annotations

from urllib.parse import urlsplit

PLACEHOLDERS = ("{z}", "{x}", "{y}")
EXAMPLE = "https://tile.openstreetmap.org/{z}/{x}/{y}.png"


def checked(template: str) -> str:
    """The address itself. Raises ValueError unless it is a page's address with all three placeholders in its path."""
    parts = urlsplit(template)
    if parts.scheme not in ("http", "https") or not parts.hostname or set(" ;,'\"") & set(template):
        raise ValueError(f"{template!r} is no address of map tiles: give one such as {EXAMPLE}")
    if missing := [one for one in PLACEHOLDERS if one not in parts.path + parts.query]:
        raise ValueError(f"{template!r} lacks {' and '.join(missing)}: give an address such as {EXAMPLE}")
    return template


def server(template: str) -> str:
    """Scheme, host and port, as Content-Security-Policy names them."""
    parts = urlsplit(template)
    return f"{parts.scheme}://{parts.netloc.rpartition('@')[2]}"
