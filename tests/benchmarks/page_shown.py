"""Figure 13: the page of `gcs run fleet --web`, 254 vehicles, in headless Chromium without a graphics card.

The session flies in real time on the same cores.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

import psutil
from measure import SUPPORT, Figure

WARM_MS, MEASURED_MS = 5000, 8000
FRAMES_S, FIRST_S, SERVER_SHARE = 30.0, 2.0, 0.15
FRAMES = f"""new Promise((done) => {{
  const drawn = skytender.frames;
  const begun = performance.now();
  let count = 0;
  const tick = () => {{
    const lasted = performance.now() - begun;
    count += 1;
    if (lasted < {MEASURED_MS}) requestAnimationFrame(tick);
    else done({{frames: 1e3 * count / lasted, drawn: 1e3 * (skytender.frames - drawn) / lasted}});
  }};
  requestAnimationFrame(tick);
}})"""
ALL_ARMED = "window.skytender?.current?.vehicles.filter((one) => one.armed).length === 254"


@contextmanager
def _session() -> Iterator[tuple[str, psutil.Process]]:
    """A session of the full fleet: the link of its page, and the page's server."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "gcs", "run", "fleet", "--web", "--plain", "--no-report"]
        command += ["--out", f"{folder}/session"]
        session = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        assert session.stdout is not None
        try:
            link = next(found[0] for line in session.stdout if (found := re.search(r"http://\S+", line)))
            threading.Thread(target=session.stdout.read, daemon=True).start()
            children = psutil.Process(session.pid).children(recursive=True)
            yield link, next(one for one in children if "gcs.web" in one.cmdline())
        finally:
            session.terminate()
            session.wait()


def figures() -> list[Figure]:
    """Animation frames of the page, in space and on the map, its first picture, and the server's share of a core."""
    sys.path.insert(0, str(SUPPORT))
    from web import CHROMIUM, MISSING, Watched, chromium, until  # noqa: PLC0415

    if CHROMIUM is None:
        print(f"Figure 13 is left out: {MISSING}.", file=sys.stderr)
        return []
    found = []
    with chromium() as browser, _session() as (link, server):
        page = Watched(browser).flying(link)
        until(page, ALL_ARMED)
        page.close()
        opened = Watched(browser)
        begun_s = time.monotonic()
        page = opened.flying(link)
        page.evaluate("skytender.first")
        first_s = time.monotonic() - begun_s
        found.append(Figure(13, "live page of 254 vehicles: first picture", first_s, "s", FIRST_S, at_most=True))
        for view, words in (("space", "in space"), ("map", "on the map")):
            page.evaluate(f"skytender.show('{view}')")
            page.wait_for_timeout(WARM_MS)
            before, begun_s = server.cpu_times(), time.monotonic()
            measured = page.evaluate(FRAMES)
            after, lasted_s = server.cpu_times(), time.monotonic() - begun_s
            share = (after.user + after.system - before.user - before.system) / lasted_s
            found += [
                Figure(13, f"  animation frames, {words}", measured["frames"], "1/s", FRAMES_S),
                Figure(13, "  snapshots drawn", measured["drawn"], "1/s"),
                Figure(13, "  its server", share, "of a core", SERVER_SHARE, at_most=True),
            ]
    return found
