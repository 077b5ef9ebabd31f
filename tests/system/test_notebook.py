"""The notebook of the docs: every cell runs, and a browser shows what came of it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient
from patience import PATIENCE_S
from playwright.sync_api import Browser, expect
from web import CHROMIUM, MISSING, Watched, chromium

NOTEBOOK = Path(__file__).resolve().parents[2] / "docs" / "notebooks" / "flight.ipynb"
pytestmark = pytest.mark.filterwarnings("default")  # Jupyter's own


@pytest.fixture(scope="module")
def outputs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, str]]:
    """What each cell shows, by the last line of its source: content by MIME type."""
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    assert all(not cell.get("outputs") for cell in notebook.cells), "kept without outputs"
    folder = str(tmp_path_factory.mktemp("notebook"))
    NotebookClient(notebook, timeout=PATIENCE_S, resources={"metadata": {"path": folder}}).execute()
    return {
        cell.source.splitlines()[-1]: dict(output["data"])
        for cell in notebook.cells
        for output in cell.get("outputs", [])
        if "data" in output
    }


def test_snapshot_summary_and_tables_are_shown(outputs: dict[str, dict[str, str]]) -> None:
    assert outputs["snapshot"]["text/html"].count("<tr>") == 1 + 7
    assert "<th>outcome</th><td>" in outputs["session.summary"]["text/html"]
    assert "'LOCAL_POSITION_NED'" in outputs["sorted(flight)"]["text/plain"]
    assert "image/png" in outputs['flight.plot("battery");']


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


@pytest.mark.skipif(CHROMIUM is None, reason=MISSING)
def test_a_recording_is_shown_as_its_page(outputs: dict[str, dict[str, str]], browser: Browser, tmp_path: Path) -> None:
    page = tmp_path / "shown.html"
    page.write_text(f"<!doctype html><body>{outputs['flight']['text/html']}</body>", encoding="utf-8")
    watched = Watched(browser)
    watched.open(page.as_uri())
    shown = watched.page.frame_locator("iframe")
    expect(shown.locator("h1")).to_contain_text("demo")
    expect(shown.locator("canvas").first).to_be_visible()
    expect(shown.get_by_role("slider", name="time")).to_be_visible()
    assert watched.wrong == []
    watched.page.screenshot(path=str(tmp_path / "shown.png"))
    watched.page.close()
