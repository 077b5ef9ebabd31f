"""The notebooks of the docs: every cell runs, and a browser shows what came of it."""

from __future__ import annotations

from ast import literal_eval
from collections.abc import Iterator
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient
from patience import PATIENCE_S
from playwright.sync_api import Browser, expect
from web import CHROMIUM, MISSING, Watched, chromium

NOTEBOOKS = Path(__file__).resolve().parents[2] / "docs" / "notebooks"
pytestmark = pytest.mark.filterwarnings("default")  # Jupyter's own


def run(name: str, folder: Path) -> dict[str, dict[str, str]]:
    """What each cell of a notebook shows, by the last line of its source: content by MIME type."""
    notebook = nbformat.read(NOTEBOOKS / name, as_version=4)
    assert all(not cell.get("outputs") for cell in notebook.cells), "kept without outputs"
    NotebookClient(notebook, timeout=PATIENCE_S, resources={"metadata": {"path": str(folder)}}).execute()
    return {
        cell.source.splitlines()[-1]: dict(output["data"])
        for cell in notebook.cells
        for output in cell.get("outputs", [])
        if "data" in output
    }


@pytest.fixture(scope="module")
def outputs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, str]]:
    return run("flight.ipynb", tmp_path_factory.mktemp("notebook"))


@pytest.mark.slow
def test_a_planner_of_a_cell_flies_and_repeats(tmp_path: Path) -> None:
    shown = run("act.ipynb", tmp_path)
    said = shown["home.outcome, snapshot.trouble[2], round(min(clear_m), 2)"]["text/plain"]
    outcome, trouble, clear_m = literal_eval(said)
    assert (outcome, len(trouble) > 0) == ("accepted", True)
    assert 0.1 <= clear_m < 2.0, "they keep clear of the pillar that is put in their way"
    assert shown["session.summary.digest == again.summary.digest"]["text/plain"] == "True"
    assert shown["snapshot"]["text/html"].count("<tr>") == 1 + 5


@pytest.mark.slow
def test_snapshot_summary_and_tables_are_shown(outputs: dict[str, dict[str, str]]) -> None:
    assert outputs["snapshot"]["text/html"].count("<tr>") == 1 + 7
    assert "<th>outcome</th><td>" in outputs["session.summary"]["text/html"]
    assert "'LOCAL_POSITION_NED'" in outputs["sorted(flight)"]["text/plain"]
    assert "image/png" in outputs['flight.plot("battery");']


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


@pytest.mark.slow
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
