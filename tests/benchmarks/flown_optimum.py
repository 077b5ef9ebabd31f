"""Vehicles lost in flight, compared with the losses of a schedule that knows all consumption in advance.

    python flown_optimum.py --out ../../campaigns/optimum --sessions 30

flies the campaign `refuelling` and keeps its sessions. For each scenario an instance is made in which each vehicle
draws what it drew in flight, on average, and `gcs benchmark solve` looks for a schedule and for a bound. Such a
schedule knows all consumption before, may begin a service at any need, and gives only what lasts to the end.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import msgspec
import yaml
from campaign_tables import asked, told

import gcs
from gcs.benchmark.sessions import instance_of
from gcs.benchmark.solve import solve
from gcs.campaign import file
from gcs.scenario import Scenario

POLICIES = ("winner_take_all", "optimal")


def main() -> None:
    parser = asked(__doc__, sessions=(30, "random scenarios"), seed=20261213, out="its folder")
    parser.add_argument("--seconds", type=float, default=2.0, help="processor time of each search")
    options = parser.parse_args()
    content = yaml.safe_load(file.find("refuelling").read_text(encoding="utf-8")) | {"keep": "all"}
    campaign = gcs.Campaign(
        content, sessions=options.sessions, seed=options.seed, out=options.out, workers=options.workers
    )
    campaign.fly(told)
    print(file=sys.stderr)
    print("| scenario | proven to be lost | lost by a schedule | by `winner_take_all` | by `optimal` |")
    print("|---|---|---|---|---|")
    some = [0, 0, 0, 0]
    for session in range(options.sessions):
        folders = [Path(options.out, "sessions", str(2 * session + k)) for k in range(len(POLICIES))]
        scenario = Scenario.model_validate(yaml.safe_load((folders[0] / "scenario.yaml").read_text(encoding="utf-8")))
        drawn, lost = zip(*(flown(folder, scenario) for folder in folders), strict=True)
        mean_w = {sysid: sum(one[sysid] for one in drawn) / len(drawn) for sysid in drawn[0]}
        one = instance_of(scenario)
        found, _ = solve(
            msgspec.structs.replace(
                one,
                receivers=[msgspec.structs.replace(r, power_w=mean_w[r.id]) for r in one.receivers],
                tankers=[msgspec.structs.replace(t, power_w=mean_w[t.id]) for t in one.tankers],
            ),
            options.seconds,
        )
        numbers = (found.lower, found.upper, *lost)
        some = [count + (number > 0) for count, number in zip(some, numbers, strict=True)]
        print(f"| {session} | " + " | ".join(map(str, numbers)) + " |", flush=True)
    print(f"| lose some, of {options.sessions} | " + " | ".join(map(str, some)) + " |")


def flown(folder: Path, scenario: Scenario) -> tuple[dict[int, float], int]:
    """Mean draw of each vehicle until it was lost or to the end, W; and how many were lost."""
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    lost_s: dict[int, float] = {}
    with (folder / "decisions.jsonl").open(encoding="utf-8") as lines:
        for record in (json.loads(line) for line in lines if '"violation"' in line):
            if record["part"] == "lost":
                lost_s |= dict.fromkeys(record["sysids"], record["at_s"])
    floors_j = {one.sysid: scenario.refuelling.lands_at * one.battery.capacity_j for one in scenario.vehicles.pursuers}
    mean_w = {}
    for vehicle in summary["vehicles"]:
        sysid, energy = vehicle["sysid"], vehicle["energy"]
        if sysid in lost_s:  # what it draws while it lands is no part of it
            mean_w[sysid] = (energy["initial_j"] + energy["received_j"] - floors_j[sysid]) / lost_s[sysid]
        else:
            mean_w[sysid] = energy["drawn_j"] / summary["sim_time_s"]
    return mean_w, len(lost_s)


if __name__ == "__main__":
    main()
