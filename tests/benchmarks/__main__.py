"""`make bench`: the figures of speed, each beside its peer or limit in the same run; a table, and bench.json.

python tests/benchmarks [--only 1,3] [--out bench.json]
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

import autopilots_in_lockstep
import campaign_sessions
import codecs_of_a_tick
import console_drawn
import environment_steps
import flight_beside
import laws
import page_shown
import planned_and_filtered
import prompt_to_prompt
import report_opened
import sessions_timed
import steps_from_python
from measure import REFERENCE_STEPS_S, Figure, calibrate
from rich.console import Console
from rich.table import Table


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0] if __doc__ else None)
    parser.add_argument("--only", help="numbers of figures, with commas between them")
    parser.add_argument("--out", type=Path, default=Path("bench.json"))
    options = parser.parse_args()
    begun_s, load = time.monotonic(), os.getloadavg()[0]
    scale = calibrate()
    figures: dict[int, Callable[[], list[Figure]]] = {
        1: codecs_of_a_tick.figures,
        2: lambda: laws.flying(scale),
        3: sessions_timed.lockstep,
        4: lambda: sessions_timed.starting(scale),
        5: lambda: sessions_timed.full_fleet(scale),
        6: lambda: laws.planning(scale) + planned_and_filtered.figures(scale),
        7: laws.competing,
        8: lambda: laws.recording(scale),
        9: console_drawn.figures,
        10: report_opened.figures,
        11: prompt_to_prompt.figures,
        12: campaign_sessions.figures,
        13: page_shown.figures,
        14: lambda: autopilots_in_lockstep.figures(scale),
        15: lambda: steps_from_python.figures(scale),
        16: environment_steps.figures,
        17: flight_beside.figures,
    }
    wanted = [int(number) for number in options.only.split(",")] if options.only else list(figures)
    console = Console(width=None if sys.stdout.isatty() else 170)
    found: list[Figure] = []
    for number in wanted:
        with console.status(f"figure {number}"):
            found += figures[number]()
    console.print(_table(found))
    console.print(
        f"This machine now: {scale.cpu:.2f} of the reference ({REFERENCE_STEPS_S:.1e} steps of the calibration loop "
        f"per CPU second), {scale.wall:.2f} on the wall; load {load:.1f} before, {os.getloadavg()[0]:.1f} after; "
        f"{time.monotonic() - begun_s:.0f} s. Goals of 2, 4, 5, 6, 8, 14 and 15 are scaled by it."
    )
    rows = [
        {"id": f.id, "name": f.name.strip(), "value": f.value, "unit": f.unit, "peer": f.peer or None,
         "peer_value": f.peer_value, "ratio": f.ratio, "goal": f.goal, "met": f.met, "goal_is_ratio": f.goal_is_ratio,
         "cpu_s": f.cpu_s}
        for f in found
    ]  # fmt: skip
    calibration = {"cpu": scale.cpu, "wall": scale.wall, "load": load}
    options.out.write_text(json.dumps({"figures": rows, "calibration": calibration}, indent=1), encoding="utf-8")


def _table(figures: list[Figure]) -> Table:
    table = Table(title="Speed")
    for name, justify in (
        ("", "right"), ("figure", "left"), ("value", "right"), ("unit", "left"), ("peer or limit", "left"),
        ("its value", "right"), ("ratio", "right"), ("goal", "right"), ("met", "left"), ("CPU s", "right"),
    ):  # fmt: skip
        table.add_column(name, justify=justify)  # type: ignore[arg-type]
    for f in figures:
        goal = "" if f.goal is None else f"{'≤' if f.at_most and not f.goal_is_ratio else '≥'} {_short(f.goal)}"
        table.add_row(
            str(f.id), f.name, _short(f.value), f.unit, f.peer, _short(f.peer_value), _short(f.ratio),
            goal + (" x" if f.goal_is_ratio else ""), {None: "", True: "yes", False: "NO"}[f.met], _short(f.cpu_s),
        )  # fmt: skip
    return table


def _short(number: float | None) -> str:
    if number is None:
        return ""
    return f"{number:,.0f}" if abs(number) >= 1000 else f"{number:.3g}"


if __name__ == "__main__":
    main()
