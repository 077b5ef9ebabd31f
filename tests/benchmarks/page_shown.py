"""Figure 13: the live page of 254 vehicles at 10 Hz in headless Chromium without a graphics card, and its server.

python page_shown.py DESCRIPTOR is the server itself, fed with what tests/support/feed.py makes up.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import psutil
from measure import Figure

SUPPORT = Path(__file__).resolve().parents[1] / "support"
VEHICLES, EVERY_S = 254, 0.1
WARM_MS, MEASURED_MS = 5000, 8000
FRAMES_S, SERVER_SHARE = 20.0, 0.15
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


class Crowd:
    """A source with a snapshot of every vehicle ten times a second; the bytes are read as those of a socket."""

    connected = True

    def __init__(self) -> None:
        import feed  # noqa: PLC0415 - it is on the path of this process alone

        from gcs.session.client import Lines  # noqa: PLC0415

        snapshots = [feed.crowd(VEHICLES, i / 10) for i in range(50)]
        members = [
            feed.known(row["sysid"], row["role"], 24000, []) | {"colour": k}
            for k, row in enumerate(snapshots[0]["vehicles"])
        ]
        self._first: list[Mapping[str, Any]] = [feed.session(vehicles=members)]
        self._lines = [json.dumps(snapshot).encode() for snapshot in snapshots]
        self._reader, self._begun_s, self._ticks = Lines(), time.monotonic(), 0

    def receive(self) -> list[Mapping[str, Any]]:
        """The snapshots that are due since the last call."""
        messages, self._first = self._first, []
        while self._ticks * EVERY_S < time.monotonic() - self._begun_s:
            for line in self._reader.feed(self._lines[self._ticks % len(self._lines)] + b"\n"):
                messages.append({**line, "t_s": self._ticks * EVERY_S})
            self._ticks += 1
        return messages

    def send(self, command: Mapping[str, Any]) -> None:
        """Nobody commands."""

    def close(self) -> None:
        """Nothing to close."""


def figures() -> list[Figure]:
    """Animation frames of the page, in space and on the map, and the server's share of a core meanwhile."""
    sys.path.insert(0, str(SUPPORT))
    from web import CHROMIUM, MISSING, Watched, chromium  # noqa: PLC0415

    if CHROMIUM is None:
        print(f"Figure 13 is left out: {MISSING}.", file=sys.stderr)
        return []
    read, write = os.pipe()
    server = subprocess.Popen([sys.executable, __file__, str(write)], pass_fds=(write,))
    os.close(write)
    found = []
    try:
        with open(read, encoding="utf-8") as links, chromium() as browser:
            page = Watched(browser).flying(json.loads(links.readline())["command"])
            process = psutil.Process(server.pid)
            for view, words in (("space", "in space"), ("map", "on the map")):
                page.evaluate(f"skytender.show('{view}')")
                page.wait_for_timeout(WARM_MS)
                before, begun_s = process.cpu_times(), time.monotonic()
                measured = page.evaluate(FRAMES)
                after, lasted_s = process.cpu_times(), time.monotonic() - begun_s
                share = (after.user + after.system - before.user - before.system) / lasted_s
                what = f"page of {VEHICLES} vehicles at 10 Hz, {words}"
                found += [
                    Figure(13, f"{what}: animation frames", measured["frames"], "1/s", FRAMES_S),
                    Figure(13, "  snapshots drawn", measured["drawn"], "1/s"),
                    Figure(13, "  its server", share, "of a core", SERVER_SHARE, at_most=True),
                ]
    finally:
        server.terminate()
        server.wait()
    return found


def main() -> None:
    """Serve until SIGTERM."""
    sys.path.insert(0, str(SUPPORT))
    from gcs.web.serve import serve  # noqa: PLC0415

    with open(int(sys.argv[1]), "w", encoding="utf-8") as links:
        serve(Crowd(), lambda made: print(json.dumps(made), file=links, flush=True))


if __name__ == "__main__":
    main()
