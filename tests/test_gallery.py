"""The gallery shows every scenario that ships, by a picture that a flight of it made."""

from __future__ import annotations

import re

from pages import DOCS

from gcs.campaign.file import shipped_names as shipped_campaigns
from gcs.scenario.file import load, shipped_folder, shipped_names

GALLERY = (DOCS / "gallery.md").read_text(encoding="utf-8")
SHOWN = re.compile(
    r"^!\[(?P<name>[\w/-]+) at (?P<t_s>\d+) s\]\((?P<path>gallery/[\w-]+\.webp)\)\n\n"
    r"`gcs run (?P<flown>[\w/-]+)`: .+\.$",
    re.M,
)
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
    pages = "".join(page.read_text(encoding="utf-8") for page in DOCS.glob("*.md"))
    for path in pictures:
        assert f"(gallery/{path.name})" in pages, path
        assert path.stat().st_size < LARGEST_BYTES, path
        assert (content := path.read_bytes())[:4] == b"RIFF"
        assert content[8:12] == b"WEBP"
