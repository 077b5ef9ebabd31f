"""Table of docs/campaigns/dense.md: families of up to 100 vehicles flown by Skytender, by A* with ORCA in 3-D, and by
A* with navground.

    python dense_table.py --out ../../campaigns/dense-1 [--seed 1] [--sessions 20]

The same command goes on where it was stopped. All three fly the same scenarios in the same simulator: launched
vehicles, sockets, lockstep. Distances are the vehicles' own truth. CPU time is that of planning alone (routes, planner,
filter) in the first 80 ticks of one scenario of each family, of vehicles that are where their set points are.
"""

from __future__ import annotations

import importlib
import os
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import yaml
from campaign_tables import Row, asked, told
from flown_families import scenario

import gcs
from gcs.campaign.statistics import wilson
from gcs.mavlink.setpoints import SetPoint
from gcs.planner.planner import Planner
from gcs.planner.request import PlanRequest, Situation
from gcs.planner.safe_planner import SafePlanner
from gcs.scenario.file import load
from gcs.scenario.model import Scenario
from gcs.telemetry.state import FleetSnapshot

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from views import view

HERE = Path(__file__).resolve().parent
FAMILIES = ("cube", "forest", "streets", "big_circle")
PLANNERS = {"skytender": "Skytender", "orca3d": "A* + ORCA 3-D", "navground": "A* + navground"}
TICKS = 80
HEAD = (
    "| family | planner | sessions | too near [95 %] | least spare, m | touched or too near an obstacle | all arrived "
    "| time, s | way beside Skytender's | CPU ms a vehicle and tick |",
    "|---|---|---|---|---|---|---|---|---|---|",
)


def main() -> None:
    options = asked(
        __doc__, sessions=(20, "of each family and planner"), seed=1, out="the campaign's folder"
    ).parse_args()
    os.environ["PYTHONPATH"] = os.pathsep.join([str(HERE), os.environ.get("PYTHONPATH", "")])
    flown = gcs.Campaign(
        HERE / "dense_beside.yaml", sessions=options.sessions, seed=options.seed, out=options.out,
        workers=options.workers, trust=True,
    )  # fmt: skip
    rows: list[Row] = flown.fly(told).to_pylist()
    print(*HEAD, sep="\n")
    for family in FAMILIES:
        by = {key: {row["session"]: row for row in rows if _is(row, family, key)} for key in PLANNERS}
        for key, name in PLANNERS.items():
            print(_line(family, name, by[key], by["skytender"], cpu_ms(family, key, options.seed)), flush=True)


def _is(row: Row, family: str, planner: str) -> bool:
    return (row["arguments.name"], row["arguments.planner"]) == (family, planner) and not row["error"]


def _line(family: str, planner: str, rows: dict[int, Row], ours: dict[int, Row], spent_ms: float) -> str:
    """Times and ways count the sessions in which all vehicles arrived, by this planner and by Skytender."""
    near = wilson(sum(row["goal.separation.met"] == 0.0 for row in rows.values()), len(rows))
    hit = sum(row["goal.clearance.met"] == 0.0 for row in rows.values())
    there = [session for session, row in rows.items() if not row["stuck"]]
    both = [session for session in there if session in ours and not ours[session]["stuck"]]
    time_s, way = "-", "-"
    if both:
        time_s = f"{statistics.median(rows[k]['time_to_goal_s'] for k in both):.1f}"
        way = f"{statistics.median(rows[k]['path_length_m'] / ours[k]['path_length_m'] for k in both):.2f}"
    rate = f"{round(near.value * len(rows))} [{100 * near.low:.1f}, {100 * near.high:.1f}] %"
    spare_m = min(row["spare_m"] for row in rows.values())
    return (
        f"| {family} | {planner} | {len(rows)} | {rate} | {spare_m:.2f} | {hit} | {len(there)} | {time_s} | {way} "
        f"| {spent_ms:.3f} |"
    )


def cpu_ms(family: str, planner: str, seed: int) -> float:
    """Median CPU time of planning, ms a vehicle and tick, of vehicles that are where their set points are."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "scenario.yaml")
        file.write_text(yaml.safe_dump(scenario(family, planner, seed)), encoding="utf-8")
        content = load(file)
    pursuers, period_s = content.vehicles.pursuers, content.clock.period_s
    places = {one.sysid: (one.start_m, (0.0, 0.0, 0.0)) for one in pursuers}
    plan = _plan_of(content, planner)
    spent_ms = []
    for tick in range(TICKS):
        vehicles = tuple(view(k, p_ned=p, v_ned=v, ground_down_m=0.0) for k, (p, v) in sorted(places.items()))
        snapshot = FleetSnapshot(100.0 + tick * period_s, vehicles, ())
        begun_s = time.process_time()
        points = plan(snapshot)
        spent_ms.append(1e3 * (time.process_time() - begun_s) / len(pursuers))
        places = {point.sysid: (point.p_ned, point.v_ned) for point in points}
    return statistics.median(spent_ms)


def _plan_of(content: Scenario, planner: str) -> Callable[[FleetSnapshot], Sequence[SetPoint]]:
    """Set points of all pursuers by the shipped planner with its filter, or by one of the others."""
    period_s, steered = content.clock.period_s, frozenset(one.sysid for one in content.vehicles.pursuers)
    if planner == "skytender":
        own = SafePlanner(content, Planner(content))
        return lambda snapshot: list(own.plan(PlanRequest(snapshot, steered, period_s)))
    module, _, name = (content.planner.method).partition(":")
    other = getattr(importlib.import_module(module), name)(content)

    def plan(snapshot: FleetSnapshot) -> Sequence[SetPoint]:
        situation = Situation(snapshot.time_s, period_s, snapshot, {}, content.obstacles)
        answers = [(one.sysid, *other.plan(one, situation)) for one in snapshot.vehicles]
        return [SetPoint(k, *(tuple(np.asarray(x, float).tolist()) for x in (p, v))) for k, p, v in answers]

    return plan


if __name__ == "__main__":
    main()
