"""What the console costs while 254 vehicles are told ten times a second: CPU time, in a terminal of 160 x 50.

python console_drawn.py PAGE DESCRIPTOR is the console itself, fed with what tests/support/feed.py makes up.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Mapping
from typing import Any

from measure import SUPPORT, Figure, used_cpu_s

ROUND_S, EVERY_S, VEHICLES = 10.0, 0.1, 254
PAGES = {"1": "fleet, map, competition, events", "2": "map", "3": "competition"}


class Timed:
    """A source that tells what is due, and ends after a while; the bytes are read as those of a socket."""

    def __init__(self, report: int) -> None:
        import feed  # noqa: PLC0415 - it is on the path of this process alone

        from gcs.session.client import Lines  # noqa: PLC0415

        self._first: list[Mapping[str, Any]] = [feed.session()]
        self._told = [(json.dumps(feed.crowd(VEHICLES, i / 10)) + "\n").encode() for i in range(50)]
        self._reader, self._report = Lines(), report
        self._begun_s, self._cpu_s, self._ticks = time.monotonic(), used_cpu_s(), 0
        self.connected = True

    def receive(self) -> list[Mapping[str, Any]]:
        """What is due since the last call."""
        messages, self._first = self._first, []
        lasted_s = time.monotonic() - self._begun_s
        while self._ticks * EVERY_S < lasted_s:
            messages += self._reader.feed(self._told[self._ticks % len(self._told)])
            self._ticks += 1
        if lasted_s >= ROUND_S:
            told = {"cpu_s": used_cpu_s() - self._cpu_s, "wall_s": lasted_s}
            os.write(self._report, json.dumps(told).encode())
            messages.append({"type": "end"})
        return messages

    def send(self, command: Mapping[str, Any]) -> None:
        """Nobody listens."""

    def close(self) -> None:
        """Nothing to close."""


def figures() -> list[Figure]:
    """The share of a core for each of the pages that draw most."""
    found = []
    for page, name in PAGES.items():
        sys.path.insert(0, str(SUPPORT))
        from screens import Screen  # noqa: PLC0415

        read, write = os.pipe()
        command = [sys.executable, __file__, page, str(write)]
        with Screen(command, columns=160, rows=50, pass_fds=(write,)) as screen:
            os.close(write)
            screen.finish()
        told = json.loads(os.read(read, 4096))
        os.close(read)
        share = told["cpu_s"] / told["wall_s"]
        what = f"console, {VEHICLES} vehicles at 10 Hz, page {name}"
        found.append(Figure(9, what, 100.0 * share, "% of a core", goal=30.0, at_most=True, cpu_s=told["cpu_s"]))
    return found


def main(page: str, report: int) -> None:
    """Be the console, on that page."""
    sys.path[:0] = [str(SUPPORT)]
    from gcs.console.app import ConsoleApp  # noqa: PLC0415
    from gcs.console.pages.heading import PAGES as NAMES  # noqa: PLC0415

    app = ConsoleApp(Timed(report), "crowd")
    app.main.page = NAMES[int(page) - 1]
    app.run()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
