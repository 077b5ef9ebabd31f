"""The pictures of docs/gallery: each scenario that docs/gallery.md shows is flown, and its report opened in Chromium.

    python docs/.site/gallery.py [NAME …]     all of them without a name; a how-to page by its name, such as act

A picture shows the fleet in space at the time that stands in its text, `![demo at 62 s](gallery/demo.webp)`, with the
ways that were flown until then. Beside them are the whole page of the demo and its console, for the first hour.

A how-to page is run as its tests run it, and its picture's title says what of that is shown: a session's folder at a
time, a page or a figure, `![A battery](../gallery/read.webp "battery.png")`.
"""

from __future__ import annotations

import argparse
import io
import os
import re
import sys
import tempfile
from pathlib import Path

from picture import HEIGHT, READY, ROOT, SEEK, STYLE, opened, report, shrunk
from picture import WIDTH as PAGE_WIDTH
from PIL import Image

sys.path.append(str(ROOT / "tests" / "support"))
import pages  # it is with the tests that run what pages say

DOCS = ROOT / "docs"
SHOWN = re.compile(r"!\[(?P<name>[\w/-]+) at (?P<t_s>\d+) s\]\((?P<path>gallery/[\w-]+\.webp)\)")
OF_PAGE = re.compile(r'!\[[^\]]+\]\(\.\./(?P<path>gallery/[\w-]+\.webp) "(?P<what>[^"]+)"\)')
FLOWN = re.compile(r"(?P<folder>[\w-]+) at (?P<t_s>\d+) s")
RUN_WITHIN_S = 400.0
WIDTH, WIDE = 720, 880
QUALITY = 60
AWAY, FROM_AFAR = 3, (1600, 1000)
PALE, MARGIN = 190, 24
NORTH, SCALE = (1500, 0, 1600, 70), (1380, 940, 1600, 1000)
"""Corners of a picture from afar in which the arrow to the north and the width of the squares stand."""
PAGE_AT_S = 62.0
SPACE = """(() => {
  const picture = document.querySelector('.picture');
  document.body.replaceChildren(picture);
  document.body.style.padding = picture.style.margin = '0';
  picture.style.height = '100vh';
})()"""
CONSOLE = ROOT / ".readme" / "demo.svg"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0] if __doc__ else None)
    parser.add_argument("names", nargs="*", metavar="NAME")
    names = parser.parse_args().names
    (DOCS / "gallery").mkdir(exist_ok=True)
    for match in SHOWN.finditer((DOCS / "gallery.md").read_text(encoding="utf-8")):
        if not names or match["name"] in names:
            with tempfile.TemporaryDirectory() as folder:
                page = report(match["name"], Path(folder))
                save(cropped(taken(page, float(match["t_s"]), SPACE, from_afar=True)), DOCS / match["path"], WIDTH)
                if match["name"] == "demo":
                    save(taken(page, PAGE_AT_S, STYLE), DOCS / "gallery" / "page.webp", WIDE)
    for path in sorted((DOCS / "how-to").glob("*.md")):
        found = list(OF_PAGE.finditer(path.read_text(encoding="utf-8")))
        if found and (not names or path.stem in names):
            of_page(path, found)
    if not names:
        with opened(CONSOLE) as tab:
            save(tab.locator("svg").first.screenshot(), DOCS / "gallery" / "console.webp", WIDE)


def of_page(path: Path, found: list[re.Match[str]]) -> None:
    """Run a how-to page, and take its pictures."""
    os.environ["PATH"] = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        pages.run(path, folder, RUN_WITHIN_S)
        for match in found:
            if flown := FLOWN.fullmatch(match["what"]):
                page = report(path.stem, folder, folder / flown["folder"])
                png, width = cropped(taken(page, float(flown["t_s"]), SPACE, from_afar=True)), WIDTH
            elif match["what"].endswith(".html"):
                with opened(folder / match["what"]) as tab:
                    png, width = tab.screenshot(), WIDE
            else:
                png, width = (folder / match["what"]).read_bytes(), WIDTH
            save(png, DOCS / match["path"], width)


def taken(page: Path, t_s: float, style: str, *, from_afar: bool = False) -> bytes:
    """A PNG of a report at that time; `from_afar`: with the camera farther away, since it frames what lies low."""
    width, height = FROM_AFAR if from_afar else (PAGE_WIDTH, HEIGHT)
    with opened(page, width, height) as tab:
        tab.evaluate(READY)
        tab.evaluate(style)
        for _ in range(AWAY if from_afar else 0):
            tab.locator("canvas.space").press("-")
        tab.evaluate(SEEK, t_s)
        return tab.screenshot()


def cropped(png: bytes) -> bytes:
    """The part of a picture that shows something: the grid on the ground is paler than `PALE`."""
    image = Image.open(io.BytesIO(png)).convert("RGB")
    for corner in (NORTH, SCALE):
        image.paste("white", corner)
    box = image.convert("L").point(lambda grey: 255 * (grey < PALE)).getbbox() or (0, 0, *image.size)
    left, top, right, bottom = box
    high = max(bottom - top, (right - left) // 3)
    around = (left - MARGIN, top - MARGIN, right + MARGIN, top + high + MARGIN)
    out = io.BytesIO()
    image.crop((max(around[0], 0), max(around[1], 0), min(around[2], image.width), min(around[3], image.height))).save(
        out, "PNG"
    )
    return out.getvalue()


def save(png: bytes, out: Path, width: int) -> None:
    """Save a picture of that width."""
    shrunk(png, width).save(out, quality=QUALITY, method=6)
    print(f"{out.relative_to(ROOT)}: {out.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
