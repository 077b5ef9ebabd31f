"""The moving picture of the README: flies the demo, opens its report in Chromium, and goes through the flight.

python docs/.site/picture.py [--session FOLDER] [--out .readme/page.webp]
"""

from __future__ import annotations

import argparse
import io
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from PIL import Image
from playwright.sync_api import Page, sync_playwright

ROOT = Path(__file__).resolve().parents[2]
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
WIDTH, HEIGHT = 1240, 760
SHOWN_WIDTH = 880
FRAMES, FRAME_MS, LAST_MS = 60, 130, 1500
BEGIN_S, END_S = 3.0, 119.5
READY = """new Promise((done) => {
  const look = () => (document.documentElement.dataset.all ? done() : setTimeout(look, 20));
  look();
})"""
STYLE = """(() => {
  const flight = document.querySelector('.flight');
  document.body.replaceChildren(flight);
  document.body.style.padding = '8px';
  flight.querySelector('.picture').style.height = '540px';
})()"""
SEEK = """(t_s) => new Promise(async (done) => {
  const app = await skytender;
  app.player.seek(t_s);
  app.shown_at = 0;
  const shown = () => Math.abs(app.current.t_s - t_s) < 1e-6 && app.paneled === app.current;
  const look = () => (shown() ? done() : requestAnimationFrame(look));
  look();
})"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0] if __doc__ else None)
    parser.add_argument("--session", type=Path, help="a session's folder, instead of flying the demo")
    parser.add_argument("--out", type=Path, default=ROOT / ".readme" / "page.webp")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        times_s = [BEGIN_S + (END_S - BEGIN_S) * k / (FRAMES - 1) for k in range(FRAMES)]
        small = [shrunk(png, SHOWN_WIDTH) for png in pictures(report("demo", Path(name), options.session), times_s)]
    durations = [FRAME_MS] * (len(small) - 1) + [LAST_MS]
    small[0].save(options.out, save_all=True, append_images=small[1:], duration=durations, loop=0, quality=55, method=4)
    print(f"{options.out}: {len(small)} frames, {options.out.stat().st_size / 1e3:.0f} kB")


def report(scenario: str, folder: Path, flown: Path | None = None) -> Path:
    """The report of a scenario, which is flown into `folder` unless `flown` has it already."""
    gcs = [sys.executable, "-m", "gcs"]
    session = flown or folder / "session"
    if flown is None:
        options = ("--lockstep", "--quiet", "--no-report", "--out", session)
        subprocess.run([*gcs, "run", scenario, *options], check=True)
    page = folder / "page.html"
    subprocess.run([*gcs, "report", session, "--quiet", "--out", page], check=True)
    return page


def shrunk(png: bytes, width: int) -> Image.Image:
    """A picture of that width."""
    image = Image.open(io.BytesIO(png)).convert("RGB")
    return image.resize((width, round(image.height * width / image.width)), Image.Resampling.LANCZOS)


@contextmanager
def opened(page: Path, width: int = WIDTH, height: int = HEIGHT) -> Iterator[Page]:
    """A file in Chromium."""
    with sync_playwright() as playwright:
        arguments = ["--no-sandbox", "--enable-unsafe-swiftshader"]
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        tab = browser.new_page(viewport={"width": width, "height": height}, color_scheme="light")
        tab.goto(page.as_uri())
        yield tab
        browser.close()


def pictures(page: Path, times_s: Iterable[float]) -> list[bytes]:
    """A PNG of the fleet's part of a report at each time."""
    with opened(page) as tab:
        tab.evaluate(READY)
        tab.evaluate(STYLE)
        taken = []
        for t_s in times_s:
            tab.evaluate(SEEK, t_s)
            taken.append(tab.screenshot())
        return taken


if __name__ == "__main__":
    main()
