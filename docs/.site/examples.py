"""Runs the examples of the documentation, page by page, each page in an empty folder.

    python docs/.site/examples.py [PAGE.md …]        # `gcs`, `simvehicle` and `python` are those of the PATH

Fenced blocks of a page, in order:

    ```python title="NAME" and ```yaml title="NAME"    written to the file NAME
    ```sh                                              run by `bash -e`; its exit status must be 0
    ```console, ```text and everything else            not run
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

DOCS = Path(__file__).resolve().parent.parent
FENCE = re.compile(
    r'^(?P<indent> *)```(?P<kind>\w+)(?: title="(?P<title>[\w.-]+)")?\n(?P<body>.*?)^(?P=indent)```$', re.M | re.S
)


class Block(NamedTuple):
    """A fenced block: its language, the file that it becomes, and its text without indentation."""

    kind: str
    title: str | None
    body: str


def pages() -> list[Path]:
    """Pages written by hand."""
    return sorted(page for page in DOCS.rglob("*.md") if "reference" not in page.relative_to(DOCS).parts)


def blocks(page: Path) -> Iterator[Block]:
    """The fenced blocks of a page, in order."""
    for match in FENCE.finditer(page.read_text(encoding="utf-8")):
        yield Block(match["kind"], match["title"], textwrap.dedent(match["body"]))


def run(page: Path, folder: Path, within_s: float = 300.0) -> None:
    """Write and run a page's blocks in `folder`. Raises CalledProcessError, TimeoutExpired."""
    for block in blocks(page):
        if block.title is not None:
            (folder / block.title).write_text(block.body, encoding="utf-8")
        elif block.kind == "sh":
            subprocess.run(
                ["bash", "-e", "-c", block.body], cwd=folder, check=True, timeout=within_s, stdin=subprocess.DEVNULL
            )


def main() -> int:
    chosen = [Path(name).resolve() for name in sys.argv[1:]] or pages()
    failed = 0
    for page in chosen:
        with tempfile.TemporaryDirectory() as folder:
            try:
                run(page, Path(folder))
                print(f"ok      {os.path.relpath(page)}", flush=True)
            except subprocess.CalledProcessError as error:
                failed += 1
                print(f"FAILED  {os.path.relpath(page)}: exit status {error.returncode}:\n{error.cmd[-1]}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
