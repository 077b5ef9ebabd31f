"""The documentation: citations and links resolve, what is generated is complete, and the site builds."""

from __future__ import annotations

import functools
import importlib
import json
import os
import pkgutil
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
import yaml
from pages import CONTRIBUTING, DOCS, PAGES, README, ROOT, anchors, files

import gcs
from gcs.scenario.json_schema import editor_schema

SITE = DOCS / ".site"
CITATION = re.compile(r"docs/(?P<page>[a-z/-]+\.md)(?:#(?P<anchor>[a-z0-9-]+))?")
LINK = re.compile(r"\]\((?P<path>[^)#:\s]*)(?:#(?P<anchor>[a-z0-9-]+))?\)")
PICTURE = re.compile(r'<img src="(?P<path>[^"]+)"')
GENERATED = DOCS / "reference"
TOPS = (ROOT / "gcs", ROOT / "simvehicle")
TO_READ = [README, CONTRIBUTING, ROOT / "SECURITY.md", *PAGES]
MOST_WORDS = 2500
EXAMPLES = {"my_planner.py": "own-planner.md", "my_policy.py": "own-policy.md"}


def texts() -> Iterator[tuple[Path, str]]:
    """(file, text) of code, tests, scenarios, pages and the files at the top."""
    for folder in ("gcs", "simvehicle", "skytender", "tests", "configs", "docs"):
        for path in (ROOT / folder).rglob("*"):
            if path.suffix in {".py", ".pxd", ".js", ".yaml", ".json", ".md", ".ipynb"} and path != Path(__file__):
                yield path, path.read_text(encoding="utf-8")
    for name in ("CHANGELOG.md", "CONTRIBUTING.md", "README.md", "SECURITY.md", "CITATION.cff", "Makefile"):
        yield ROOT / name, (ROOT / name).read_text(encoding="utf-8")


def test_every_citation_names_a_heading() -> None:
    cited = 0
    broken = set()
    for path, text in texts():
        for match in CITATION.finditer(re.sub(r"\n\s*(?:# )?", " ", text)):
            page, anchor = DOCS / match["page"], match["anchor"]
            cited += 1
            if not there(page, anchor):
                broken.add(f"{path.relative_to(ROOT)}: {match[0]}")
    assert not broken
    assert cited > 100


def test_nothing_cites_what_no_user_has() -> None:
    internal = re.compile(r"(?<!docs/)(?<!-)\b(?:contract|model|mavlink|house|found)\.md")
    assert not [path for path, text in texts() if internal.search(text)]


@pytest.mark.parametrize("page", TO_READ, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_resolve(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    for match in LINK.finditer(text):
        target = (page.parent / match["path"]).resolve() if match["path"] else page
        assert there(target, match["anchor"]), match[0]
    assert all((page.parent / match["path"]).exists() for match in PICTURE.finditer(text))


def test_the_links_of_generated_pages_resolve() -> None:
    checked = 0
    for page, text in made().items():
        for match in LINK.finditer(text):
            target = (page.parent / match["path"]).resolve() if match["path"] else page
            assert there(target, match["anchor"]), f"{page}: {match[0]}"
            checked += 1
    assert checked > 100


def there(page: Path, anchor: str | None) -> bool:
    """Whether there is a page or file, generated ones too, with that heading."""
    text = made().get(page)
    if text is None:
        return page.exists() and (anchor is None or anchor in anchors(page.read_text(encoding="utf-8")))
    return anchor is None or anchor in anchors(text)


@functools.cache
def made() -> dict[Path, str]:
    """Text of every generated file, by where the site has it."""
    return {GENERATED / name: text for name, text in generated().pages().items()}


def test_each_page_can_be_read_at_one_sitting() -> None:
    texts = {page: page.read_text(encoding="utf-8") for page in TO_READ}
    texts |= {page: text for page, text in made().items() if page.suffix == ".md"}
    assert [page for page, text in texts.items() if len(text.split()) >= MOST_WORDS] == []


def linked(page: Path) -> set[Path]:
    """The pages that a page links."""
    text = made().get(page) or page.read_text(encoding="utf-8")
    return {(page.parent / match["path"]).resolve() for match in LINK.finditer(text) if match["path"]}


def test_every_page_is_of_one_of_four_kinds_in_the_navigation_and_is_found_from_the_index() -> None:
    index, *kinds = yaml.safe_load((SITE / "mkdocs.yml").read_text(encoding="utf-8"))["nav"]
    assert list(index.values()) == ["index.md"]
    assert [name for kind in kinds for name in kind] == ["Tutorials", "How-to guides", "Reference", "Explanation"]
    pages = {*PAGES, *(page for page in made() if page.suffix == ".md")} - {DOCS / "index.md"}
    assert sorted(named_in(kinds)) == sorted(pages)
    at_once = linked(DOCS / "index.md")
    for page in pages:
        overview = page.parent / "index.md"
        assert page in at_once or (overview in at_once and page in linked(overview)), page


def named_in(navigation: Any) -> Iterator[Path]:
    """The pages that a part of the navigation names; a folder stands for its generated pages."""
    if isinstance(navigation, str):
        inside = [page for page in made() if page.parent == DOCS / navigation and page.suffix == ".md"]
        yield from inside if navigation.endswith("/") else [DOCS / navigation]
    else:
        for part in navigation.values() if isinstance(navigation, dict) else navigation:
            yield from named_in(part)


def test_what_the_python_api_describes_can_be_imported() -> None:
    described = re.findall(r"^::: ([\w.]+)$", (DOCS / "python-api.md").read_text(encoding="utf-8"), re.M)
    assert {f"gcs.{name}" for name in gcs.__all__} <= set(described)
    for name in described:
        assert pkgutil.resolve_name(name).__doc__, name


def test_the_files_that_pages_name_exist() -> None:
    named = re.compile(r"`((?:gcs|simvehicle|skytender|tests|configs|docs)/[\w./-]+\.\w+)`")
    for page in (README, CONTRIBUTING, *PAGES):
        for path in named.findall(page.read_text(encoding="utf-8")):
            assert (ROOT / path).exists(), f"{page.name}: {path}"


def test_each_folder_of_tests_is_run_by_make_check_or_named_as_left_out() -> None:
    done = subprocess.run(["make", "-n", "check"], cwd=ROOT, capture_output=True, text=True, check=True)
    run = set(re.findall(r"(?<= )tests/[\w/]+", done.stdout))
    left_out = set(re.findall(r"`(tests/[\w/]+)`", CONTRIBUTING.read_text(encoding="utf-8").partition("leaves out")[2]))
    folders = {path.parent for part in TOPS for path in (ROOT / "tests" / part.name).glob("*/test_*.py")}
    assert {str(folder.relative_to(ROOT)) for folder in folders} <= run ^ left_out


def test_the_printed_planner_and_policy_are_the_tested_examples() -> None:
    for name, page in EXAMPLES.items():
        example = (ROOT / "tests" / "examples" / name).read_text(encoding="utf-8")
        assert example.split('"""\n\n', 1)[1] == files(DOCS / "how-to" / page)[name]


def generated() -> ModuleType:
    """The module that writes the generated pages."""
    if str(SITE) not in sys.path:
        sys.path.append(str(SITE))
    return importlib.import_module("generate")


def pages_of(folder: str) -> str:
    """All generated pages of a folder, one after the other."""
    return "".join(text for page, text in made().items() if page.parent.name == folder and page.suffix == ".md")


def test_the_scenario_reference_has_every_key_with_its_meaning() -> None:
    text = pages_of("scenario")
    rows = [line for line in text.splitlines() if line.startswith("| `")]
    assert [row for row in rows if row.endswith("|  |")] == []
    schema = editor_schema()
    parts = [schema, *schema["$defs"].values()]
    assert len(rows) == sum(len(part.get("properties", {})) for part in parts) + 3 * text.count("`grid`")
    for part in parts:
        for key in part.get("properties", {}):
            assert f"| `{key}` |" in text
    for name in schema["$defs"]:
        assert len(re.findall(rf"^##? {name.removesuffix('Rules')}$", text, re.M)) == 1


def schema(name: str) -> dict[str, Any]:
    content: dict[str, Any] = json.loads((ROOT / "gcs" / "schemas" / f"{name}.schema.json").read_text(encoding="utf-8"))
    return content


def named(page: str, begins: str) -> set[str]:
    """The words in code type of a protocol page's lines from the one that begins so to the next empty one, or of that
    row of a table alone."""
    text = (DOCS / "protocol" / page).read_text(encoding="utf-8")
    (found,) = re.findall(rf"^{re.escape(begins)}.*", text, re.M)
    if not begins.startswith("|"):
        found = text[text.index(found) :].partition("\n\n")[0]
    return set(re.findall(r"`([a-z0-9_ ]+)(?:\[\])?`", found))


@pytest.mark.parametrize(("begins", "line"), [
    ("| `session` |", "SessionLine"), ("| `snapshot` |", "SnapshotMessage"), ("| `reply` |", "Reply"),
    ("| `end` |", "End"), ("A vehicle in a snapshot has", "VehicleRow"), ("A vehicle in a snapshot has", "EventRow"),
])  # fmt: skip
def test_the_page_of_the_socket_has_every_key_of_its_lines(begins: str, line: str) -> None:
    keys = set(schema("messages")["$defs"][line]["properties"]) - {"type"}
    assert not keys - named("socket.md", begins)


def test_the_page_of_the_result_has_every_key_of_the_summary() -> None:
    summary = schema("summary")
    rows = re.findall(r"^\| (`.*?) \|", (DOCS / "protocol" / "result.md").read_text(encoding="utf-8"), re.M)
    first = {name for row in rows for name in re.findall(r"`([a-z0-9_]+)(?:\[\])?`", row)}
    assert not set(summary["properties"]) - first - {"schema"}
    parts = {
        "vehicles[]": ("VehicleSummary", "CheckedItem", "MissionSummary", "VehicleLinkSummary"),
        "vehicles[].energy": ("EnergySummary",), "refuelling[]": ("RefuellingSummary",), "faults[]": ("FaultSummary",),
        "bases[]": ("BaseSummary",), "link": ("LinkSummary",), "closest": ("ClosestSummary",),
    }  # fmt: skip
    for row, definitions in parts.items():
        keys = {key for one in definitions for key in summary["$defs"][one]["properties"]}
        assert not keys - named("result.md", f"| `{row}` |"), row


def test_the_page_of_the_folder_has_every_kind_of_decision() -> None:
    kinds = [one["properties"]["kind"] for one in schema("decisions")["oneOf"]]
    text = (DOCS / "protocol" / "folder.md").read_text(encoding="utf-8").partition("## Decisions")[2]
    rows = " ".join(re.findall(r"^\| (`.*?) \|", text.partition("\n## ")[0], re.M))
    assert not {kind for one in kinds for kind in one.get("enum", [one.get("const")])} - set(
        re.findall("`(.*?)`", rows)
    )
    (safety,) = (one for one in schema("decisions")["oneOf"] if one["properties"]["kind"].get("const") == "safety")
    assert not set(safety["properties"]) - named("folder.md", "| `safety` |") - {"t_s", "kind"}


def test_the_command_reference_has_every_command_and_option() -> None:
    text = pages_of("commands")
    assert {"# gcs run", "# gcs paper", "## gcs campaign fly", "# simvehicle"} <= set(text.splitlines())
    assert "--lockstep" in text
    assert "--state" in text


def test_the_pictures_of_the_packages_have_no_circle_and_no_arrow_between_the_programs() -> None:
    pages = generated().pages()
    programs = [pages[f"packages/packages-{program.name}.svg"] for program in TOPS]
    assert "#c0392b" not in "".join(programs)
    assert "gcs.supervisor imports gcs.recording" in programs[0]
    assert not re.search(r"gcs\S* imports simvehicle|simvehicle\S* imports gcs", "".join(pages.values()))


def test_the_pages_of_packages_have_every_module_with_its_content() -> None:
    rows = set(re.findall(r"^\| `([\w/]+\.py)` \| \S.* \|$", pages_of("packages"), re.M))
    sources = {path for package in ("gcs", "simvehicle", "skytender") for path in (ROOT / package).rglob("*.py")}
    packages = {path for path in sources if path.name == "__init__.py" and path.parent.parent in (ROOT, *TOPS)}
    assert rows == {str(path.relative_to(ROOT)) for path in sources - packages}


def builder() -> str:
    """A Python that has the site's builder."""
    places = [os.environ.get("SKYTENDER_DOCS_BUILDER"), str(ROOT / ".venv-docs" / "bin" / "python"), sys.executable]
    for python in filter(None, places):
        asked = [python, "-c", "import mkdocstrings_handlers.python, zensical"]
        if shutil.which(python) and subprocess.run(asked, capture_output=True, check=False).returncode == 0:
            return python
    pytest.skip("the site's builder is not installed: call make docs")


def test_the_site_builds_and_asks_for_nothing_from_the_network(tmp_path: Path) -> None:
    build = [sys.executable, str(SITE / "build.py"), "--builder", builder(), "--into", str(tmp_path / "stage")]
    done = subprocess.run(build, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    site = tmp_path / "stage" / "site"
    api = (site / "python-api.html").read_text(encoding="utf-8")
    assert 'id="gcs.session.python.Session"' in api or 'id="gcs.Session"' in api
    assert 'href="protocol/folder.html#session-folder"' in api
    assert "docs/protocol/" not in api
    for page in site.rglob("*.html"):
        loaded = re.findall(r'<(?:script|img|link)[^>]+(?:src|href)="(https?:)?//', page.read_text(encoding="utf-8"))
        assert not loaded, page


def test_a_missing_builder_is_told_with_what_to_do(tmp_path: Path) -> None:
    build = [sys.executable, str(SITE / "build.py"), "--builder", "/bin/false", "--into", str(tmp_path / "stage")]
    done = subprocess.run(build, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "not installed" in done.stderr
    assert "pip install -r docs/.site/requirements.txt" in done.stderr
