"""Figure 10: the report of the full fleet's ten minutes, made, and opened in headless Chromium."""

from __future__ import annotations

import statistics
import sys
import tempfile
import time
from pathlib import Path

from measure import Figure
from sessions_timed import children_cpu_s, fleet, fly, run_gcs

SUPPORT = Path(__file__).resolve().parents[1] / "support"
FLEET_S = 600.0
OPENED = 5
STAGES = {"first": "first figure drawn", "flat": "all drawn but the view in space", "all": "all drawn"}


def figures() -> list[Figure]:
    """The page itself tells when each stage was reached; each opening has a new profile, as a new reader has."""
    sys.path.insert(0, str(SUPPORT))
    from browser import CHROMIUM, MISSING, Browser  # noqa: PLC0415

    if CHROMIUM is None:
        print(f"Figure 10 is left out: {MISSING}.", file=sys.stderr)
        return []
    what = f"report of 254 vehicles for {FLEET_S:.0f} s"
    with tempfile.TemporaryDirectory() as name:
        session = Path(name) / "session"
        fly(fleet(FLEET_S), Path(name))
        begun_s, before_s = time.perf_counter(), children_cpu_s()
        run_gcs("report", str(session))
        found = [Figure(10, f"{what}: made", time.perf_counter() - begun_s, "s", cpu_s=children_cpu_s() - before_s)]
        opened = []
        for _ in range(OPENED):
            with Browser(watched=False) as browser:
                browser.open(session / "report.html")
                opened.append(browser.drawn())
    for stage, told in STAGES.items():
        goal_s = 3.0 if stage == "all" else None
        took_s = statistics.median(stages[stage] for stages in opened) / 1e3
        found.append(Figure(10, f"  opened: {told}", took_s, "s", goal_s, at_most=True))
    return found
