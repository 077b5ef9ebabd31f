"""The pages of the documentation: their headings, and their fenced blocks, which tests run.

```python title="NAME" and ```yaml title="NAME"    a file of that name
```sh                                              run by `bash -e` in the folder that has the page's files
```console                                         lines for a terminal, which wait for others or for Ctrl-C
```text and everything else                        only read
"""

from __future__ import annotations

import re
import subprocess
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
README = ROOT / "README.md"
CONTRIBUTING = ROOT / "CONTRIBUTING.md"
PAGES = sorted(DOCS.rglob("*.md"))
FENCE = re.compile(
    r'^(?P<indent> *)```(?P<kind>\w+)(?: title="(?P<title>[\w.-]+)")?\n(?P<body>.*?)^(?P=indent)```$', re.M | re.S
)


class Block(NamedTuple):
    """A fenced block: its language, the file that it becomes, and its text without indentation."""

    kind: str
    title: str | None
    body: str


def blocks(page: Path) -> Iterator[Block]:
    """The fenced blocks of a page, in order."""
    for match in FENCE.finditer(page.read_text(encoding="utf-8")):
        yield Block(match["kind"], match["title"], textwrap.dedent(match["body"]))


def block(page: Path, title: str) -> str:
    """The text of a page's block with that title."""
    return next(found.body for found in blocks(page) if found.title == title)


def files(page: Path) -> dict[str, str]:
    """Text by name of the files that a page prints."""
    return {found.title: found.body for found in blocks(page) if found.title is not None}


def run_lines(page: Path) -> list[str]:
    """What a page has run as `sh`, without comments."""
    lines = [line for found in blocks(page) if found.kind == "sh" for line in found.body.splitlines()]
    return [line.split("  #")[0].strip() for line in lines]


def terminal_lines(page: Path) -> list[str]:
    """What a page has a reader type in a terminal, without comments, and without what is run as `sh`."""
    lines = [line for found in blocks(page) if found.kind == "console" for line in found.body.splitlines()]
    return [line.split("  #")[0].strip() for line in lines]


def anchors(text: str) -> set[str]:
    """The anchors of a page's headings, as the site makes them."""
    text = re.sub(r"^ *```.*?^ *```", "", text, flags=re.M | re.S)
    headings = re.findall(r"^#+ (.+)$", text, flags=re.M)
    return {re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", heading).strip().lower()) for heading in headings}


def run(page: Path, folder: Path, within_s: float) -> None:
    """Write and run a page's blocks in `folder`. Raises CalledProcessError, TimeoutExpired."""
    for found in blocks(page):
        if found.title is not None:
            (folder / found.title).write_text(found.body, encoding="utf-8")
        elif found.kind == "sh":
            said = subprocess.run(
                ["bash", "-e", "-c", found.body],
                cwd=folder,
                capture_output=True,
                text=True,
                timeout=within_s,
                stdin=subprocess.DEVNULL,
                check=False,
            )
            assert said.returncode == 0, f"{found.body}\n{said.stdout[-2000:]}\n{said.stderr[-4000:]}"
