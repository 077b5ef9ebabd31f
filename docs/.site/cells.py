"""Text of docstrings, schemas and programs as pages and their tables can hold it."""

from __future__ import annotations

import re

UP = "../../"
"""From a folder of generated pages, docs/reference/FOLDER, to docs/."""


def prose(text: str) -> str:
    """A docstring as Markdown: what it cites of docs/ becomes a link."""
    text = " ".join(text.split())

    def link(match: re.Match[str]) -> str:
        page, anchor = match["page"], match["anchor"] or ""
        return f"[{(anchor or page).lstrip('#').replace('-', ' ')}]({UP}{page}.md{anchor})"

    return re.sub(r"docs/(?P<page>[a-z/-]+)\.md(?P<anchor>#[a-z0-9-]+)?", link, text)


def cell(text: str) -> str:
    """Text that a table's cell can hold."""
    return text.replace("|", "\\|").replace("\n", " ")


def escaped(text: str) -> str:
    """Text without accidental Markdown."""
    return re.sub(r"([\[\]<>*_])", r"\\\1", text)


def code(text: str) -> str:
    """An option in code type; a cell's bar must be escaped there too."""
    return f"`{cell(text)}`"
