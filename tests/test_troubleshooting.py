"""The sentences that the pages of troubleshooting quote are those that the programs print."""

from __future__ import annotations

import ast
import functools
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from pages import DOCS, ROOT

PAGES = [DOCS / "troubleshooting.md", *sorted((DOCS / "troubleshooting").glob("*.md"))]
ROW = re.compile(r"^\| (?P<tick>`+) ?(?P<quoted>[^|]+?) ?(?P=tick) \| (?P<cause>[^|]+) \| (?P<advice>[^|]+) \|$", re.M)
HEAD = "| what is printed | cause | what to do |\n|---|---|---|\n"
VARIES = "…"
LEAST_LETTERS = 10
"""Of constant text, so that a quotation is found in one place by more than chance."""


def quotations() -> Iterator[tuple[Path, str]]:
    """(page, sentence) of each row of the tables."""
    for page in PAGES:
        for match in ROW.finditer(page.read_text(encoding="utf-8")):
            yield page, match["quoted"]


def text_of(node: ast.AST) -> str | None:
    """The text that an expression makes, with `VARIES` for what is only known when it runs; None for another one."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else None
    if isinstance(node, ast.JoinedStr):
        return "".join(text_of(part) or VARIES for part in node.values)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        left, right = text_of(node.left), text_of(node.right)
        return None if left is right is None else (left or VARIES) + (right or VARIES)
    return None


@functools.cache
def printed() -> str:
    """Every text of the programs, and what says so before they are installed, one a line."""
    lines = []
    for package in ("gcs", "simvehicle", "skytender"):
        for path in sorted((ROOT / package).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if (text := text_of(node)) is not None:
                    lines.append(re.sub(f"{VARIES}+", VARIES, text.replace("\n", " ")))
    others = [*sorted((ROOT / "gcs" / "web" / "page").glob("*.js")), ROOT / ".ci" / "compiler"]
    lines += [path.read_text(encoding="utf-8") for path in others]
    lines.append(re.sub(r"\$\([A-Z]+\)", VARIES, (ROOT / "Makefile").read_text(encoding="utf-8")))
    return "\n".join(lines)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_each_table_has_a_sentence_its_cause_and_what_to_do(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    rows = [line for line in text.splitlines() if line.startswith("|")]
    assert len(rows) == 2 * text.count(HEAD) + len(ROW.findall(text))
    assert len(rows) > 2 * text.count(HEAD) > 0


def test_a_quoted_sentence_is_printed_by_the_program() -> None:
    for page, quoted in quotations():
        constant = quoted.strip(f"{VARIES} ")
        assert len(re.findall(r"\w", constant)) >= LEAST_LETTERS, f"{page.name}: {quoted}"
        assert constant in printed(), f"{page.name}: no program prints this: {quoted}"


def test_no_sentence_is_quoted_twice() -> None:
    said = [quoted for _, quoted in quotations()]
    assert len(said) == len(set(said))


def test_a_sentence_that_no_program_prints_is_found() -> None:
    assert "exists already and is left as it is; give another folder" in printed()
    assert "exists already and is replaced; give another folder" not in printed()
