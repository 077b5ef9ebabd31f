"""The documentation: citations resolve, links resolve, examples run. (To be moved to tests/.)"""

from __future__ import annotations

import importlib.util
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
CITATION = re.compile(r"docs/(?P<page>[a-z/-]+\.md)(?:#(?P<anchor>[a-z0-9-]+))?")
LINK = re.compile(r"\]\((?P<page>[^)#:\s]*\.md)?(?:#(?P<anchor>[a-z0-9-]+))?\)")
GENERATED = "reference/"

_spec = importlib.util.spec_from_file_location("examples", DOCS / ".site" / "examples.py")
assert _spec is not None
assert _spec.loader is not None
examples = importlib.util.module_from_spec(_spec)
sys.modules["examples"] = examples
_spec.loader.exec_module(examples)
PAGES = examples.pages()


def anchors(page: Path) -> set[str]:
    """The anchors of a page's headings, as the site makes them."""
    text = re.sub(r"^ *```.*?^ *```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    headings = re.findall(r"^#+ (.+)$", text, flags=re.M)
    return {re.sub(r"[-\s]+", "-", re.sub(r"[^\w\s-]", "", heading).strip().lower()) for heading in headings}


def cited() -> list[tuple[Path, str, str | None]]:
    """(file, page, anchor) of every citation in code, tests and scenarios."""
    found = []
    for folder in ("gcs", "simvehicle", "tests", "configs"):
        for path in (ROOT / folder).rglob("*"):
            if path.suffix in {".py", ".yaml", ".json", ".md"} and path.name != Path(__file__).name:
                text = re.sub(r"\n\s*(?:# )?", " ", path.read_text(encoding="utf-8"))
                found += [(path, match["page"], match["anchor"]) for match in CITATION.finditer(text)]
    return found


def test_every_citation_names_a_heading() -> None:
    broken = {
        f"{path.relative_to(ROOT)}: docs/{page}#{anchor}"
        for path, page, anchor in cited()
        if not (DOCS / page).is_file() or (anchor and anchor not in anchors(DOCS / page))
    }
    assert not broken


def test_nothing_cites_what_no_user_has() -> None:
    internal = re.compile(r"(?<!docs/)\b(?:contract|model|mavlink|house)\.md")
    for folder in ("gcs", "simvehicle", "tests", "configs"):
        for path in (ROOT / folder).rglob("*"):
            if path.suffix in {".py", ".yaml", ".json", ".md"} and path.name != Path(__file__).name:
                assert not internal.search(path.read_text(encoding="utf-8")), path


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(DOCS)))
def test_links_between_pages_resolve(page: Path) -> None:
    for match in LINK.finditer(page.read_text(encoding="utf-8")):
        target = page if match["page"] is None else (page.parent / match["page"]).resolve()
        if GENERATED in str(target.relative_to(DOCS)):
            continue
        assert target.is_file(), match[0]
        assert match["anchor"] is None or match["anchor"] in anchors(target), match[0]


DEMO_PAGES = {"first-hour.md", "index.md", "how-to/ci.md"}
"""They fly the demo, whose pursuers come within 0.43 m of traffic where 0.6 m is wanted: the planner gives traffic no
radius. Strict, so that the safety filter that cures it takes this away."""


@pytest.mark.timeout(300)
@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(DOCS)))
def test_examples_run(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> None:
    if str(page.relative_to(DOCS)) in DEMO_PAGES:
        request.applymarker(pytest.mark.xfail(reason="the demo breaks its goal's traffic part", strict=True))
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=":")
    examples.run(page, tmp_path)
