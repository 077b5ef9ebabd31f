"""The gallery shows every scenario that ships, and how-to pages what they fly, by pictures that `make gallery` made."""

from __future__ import annotations

import re

from pages import DOCS, PAGES, files, run_lines

from gcs.campaign.file import shipped_names as shipped_campaigns
from gcs.scenario.file import load, shipped_folder, shipped_names

GALLERY = (DOCS / "gallery.md").read_text(encoding="utf-8")
SHOWN = re.compile(
    r"^!\[(?P<name>[\w/-]+) at (?P<t_s>\d+) s\]\((?P<path>gallery/[\w-]+\.webp)\)\n\n"
    r"`gcs run (?P<flown>[\w/-]+)`: .+\.$",
    re.M,
)
OF_PAGE = re.compile(r'\]\(\.\./gallery/([\w-]+)\.webp "([^"]+)"\)')
LARGEST_BYTES = 60_000


def test_each_shipped_scenario_has_a_picture_a_command_and_a_sentence() -> None:
    shown = list(SHOWN.finditer(GALLERY))
    assert sorted(match["name"] for match in shown) == sorted(shipped_names())
    for match in shown:
        assert match["flown"] == match["name"]
        assert 0 < float(match["t_s"]) < load(shipped_folder() / f"{match['name']}.yaml").goal.duration_s


def test_each_shipped_campaign_is_named() -> None:
    named = re.findall(r"^\| `([\w-]+)` \|", GALLERY, re.M)
    assert sorted(named) == sorted(shipped_campaigns())


def test_pictures_are_small_and_all_are_shown() -> None:
    pictures = sorted((DOCS / "gallery").iterdir())
    shown = {
        (page.parent / path).resolve()
        for page in PAGES
        for path in re.findall(r"!\[[^\]]+\]\(([\w./-]+\.webp)", page.read_text(encoding="utf-8"))
    }
    assert [path for path in shown if not path.exists()] == []
    for path in pictures:
        assert path in shown, path
        assert path.stat().st_size < LARGEST_BYTES, path
        assert (content := path.read_bytes())[:4] == b"RIFF"
        assert content[8:12] == b"WEBP"


def test_pictures_of_how_to_pages_show_what_the_page_makes() -> None:
    shown = 0
    for page in (DOCS / "how-to").glob("*.md"):
        for name, what in OF_PAGE.findall(page.read_text(encoding="utf-8")):
            shown += 1
            assert name == page.stem
            made = [*run_lines(page), *files(page).values()]
            folder = re.split(r" at \d+ s$|/", what)[0]
            assert [line for line in made if re.search(rf"\b{re.escape(folder)}\b", line)], (page, what)
    assert shown >= 4
