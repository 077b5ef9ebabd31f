"""Table of docs/campaigns/safety.md: the scenario families flown by Skytender, by its field alone and by A* with ORCA.

    python safety_table.py --out ../../campaigns/safety-1 [--seed 1] [--sessions 77] [--beside 20]

The same command goes on where it was stopped. All three fly the same scenarios in the same simulator: launched
vehicles, sockets, lockstep. Distances are the vehicles' own truth.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from campaign_tables import Row, asked, told

import gcs
from gcs.campaign.families.makers import FAMILIES
from gcs.campaign.statistics import wilson

HERE = Path(__file__).resolve().parent
DISTANCES = ("separation", "clearance", "traffic", "ground")
TO_WAY_POINTS = ("circles", "head_on", "crossings", "walls", "gaps")


def main() -> None:
    parser = asked(__doc__, sessions=(77, "of each family by Skytender"), seed=1, out="folder of both campaigns")
    parser.add_argument("--beside", type=int, default=20, help="of each family by the others")
    options = parser.parse_args()
    sys.path.insert(0, str(HERE))
    options.out.mkdir(parents=True, exist_ok=True)
    ours = _flown("safety", options.sessions, options, "skytender")
    others = _flown(str(HERE / "safety_beside.yaml"), options.beside, options, "beside") if options.beside else []
    for text in table(ours, others):
        print(text)


def _flown(campaign: str, sessions: int, options: argparse.Namespace, name: str) -> list[Row]:
    flown = gcs.Campaign(
        campaign, sessions=sessions, seed=options.seed, out=options.out / name, workers=options.workers, trust=True
    )
    rows: list[Row] = flown.fly(told).to_pylist()
    return rows


def table(ours: Sequence[Row], others: Sequence[Row]) -> list[str]:
    """Lines of Markdown: a row for each family and planner, then all of them, then times to goal."""
    by = {"Skytender": ours}
    for name, words in (("field", "field alone"), ("orca", "A* + ORCA")):
        by[words] = [row for row in others if row["arguments.planner"] == name]
    lines = [
        "| family | planner | sessions | too near [95 %] | least separation, m | touched or too near an obstacle "
        "| stuck | lost | met |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for family in (*FAMILIES, "all"):
        for planner, rows in by.items():
            of = [row for row in rows if family in (row["arguments.name"], "all")]
            if of:
                lines.append(_line(family, planner, of))
    lines += ["", "| family | sessions | Skytender, s | A* + ORCA, s | ratio |", "|---|---|---|---|---|"]
    arrivals = {name: _arrivals(rows) for name, rows in by.items()}
    for family in (*TO_WAY_POINTS, "all"):
        keys = [key for key in arrivals["A* + ORCA"] if key in arrivals["Skytender"] and family in (key[0], "all")]
        if keys:
            mine, theirs = (
                float(np.median([arrivals[name][key] for key in keys])) for name in ("Skytender", "A* + ORCA")
            )
            lines.append(f"| {family} | {len(keys)} | {mine:.1f} | {theirs:.1f} | {mine / theirs:.2f} |")
    return lines


def _line(family: str, planner: str, rows: Sequence[Row]) -> str:
    near = wilson(sum(_broken(row, ("separation", "traffic")) for row in rows), len(rows))
    least_m = min((row["min_separation_m"] for row in rows if row["min_separation_m"] is not None), default=math.nan)
    hit, stuck, lost = (
        sum(_broken(row, ("clearance", "ground")) for row in rows),
        sum((row["stuck"] or 0) > 0 for row in rows),
        sum((row["lost"] or 0) > 0 for row in rows),
    )
    met = sum(row["outcome"] == "met" for row in rows)
    rate = f"{round(near.value * len(rows))} [{100 * near.low:.1f}, {100 * near.high:.1f}] %"
    return f"| {family} | {planner} | {len(rows)} | {rate} | {least_m:.2f} | {hit} | {stuck} | {lost} | {met} |"


def _broken(row: Row, parts: Sequence[str]) -> bool:
    return bool(row["error"]) or any(row[f"goal.{part}.met"] == 0.0 for part in parts)


def _arrivals(rows: Sequence[Row]) -> dict[tuple[str, int], float]:
    """Time to goal by family and session; inf where somebody did not arrive."""
    return {
        (row["arguments.name"], row["session"]): math.inf if row["stuck"] else row["time_to_goal_s"]
        for row in rows
        if row["arguments.name"] in TO_WAY_POINTS and not row["error"]
    }


if __name__ == "__main__":
    main()
