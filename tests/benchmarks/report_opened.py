"""Figure 10: the reports of the demo and of the full fleet's ten minutes, made, and opened in headless Chromium."""

from __future__ import annotations

import statistics
import sys
import tempfile
import time
from pathlib import Path

import yaml
from measure import ROOT, SUPPORT, Figure, children_cpu_s
from sessions_timed import fleet, fly, run_gcs

FLEET_S = 600.0
OPENED = 5
STAGES = {"first": "the fleet drawn", "flat": "every figure drawn", "all": "all on the screen"}
DEMO_BYTES, DEMO_S, FULL_S = 900_000, 1.0, 2.0


def figures() -> list[Figure]:
    """The page itself tells when each stage was reached; each opening has a new profile, as a new reader has."""
    sys.path.insert(0, str(SUPPORT))
    from browser import CHROMIUM, MISSING, Browser  # noqa: PLC0415

    if CHROMIUM is None:
        print(f"Figure 10 is left out: {MISSING}.", file=sys.stderr)
        return []
    found = []
    sessions = (
        (
            "report of the demo",
            yaml.safe_load((ROOT / "configs/demo.yaml").read_text(encoding="utf-8")),
            DEMO_BYTES,
            DEMO_S,
        ),
        (f"report of 254 vehicles for {FLEET_S:.0f} s", fleet(FLEET_S), None, FULL_S),
    )
    for what, scenario, most_bytes, within_s in sessions:
        with tempfile.TemporaryDirectory() as name:
            session = Path(name) / "session"
            fly(scenario, Path(name))
            begun_s, before_s = time.perf_counter(), children_cpu_s()
            run_gcs("report", str(session))
            took_s, cpu_s = time.perf_counter() - begun_s, children_cpu_s() - before_s
            page = session / "report.html"
            found.append(Figure(10, f"{what}: made", took_s, "s", cpu_s=cpu_s))
            found.append(Figure(10, "  its size", float(page.stat().st_size), "bytes", most_bytes, at_most=True))
            opened = []
            for _ in range(OPENED):
                with Browser() as browser:
                    browser.open(page)
                    opened.append(browser.drawn())
        for stage, words in STAGES.items():
            goal_s = within_s if stage == "all" else None
            drawn_s = statistics.median(stages[stage] for stages in opened) / 1e3
            found.append(Figure(10, f"  opened: {words}", drawn_s, "s", goal_s, at_most=True))
    return found
