"""Tables of docs/campaigns/policies.md: which refuelling policies lose somebody, and where nobody need be lost.

    python policies_table.py --out ../../campaigns/policies-11 --sessions 200 --seed 11 \
        --policies winner_take_all,optimal

The same command goes on where it was stopped. Every policy flies the same random scenarios (the campaign `policies`):
vehicles, sockets, lockstep. Rates have Wilson intervals, paired differences bootstrap intervals, all of 95 %.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

import numpy as np
import yaml
from campaign_tables import Row, asked, told

import gcs
from gcs.campaign import file
from gcs.campaign.statistics import Interval, mean, wilson

POLICY = "competition.policy"
ALLOWED_MORE = 0.05


def main() -> None:
    parser = asked(__doc__, sessions=(200, "random scenarios, each flown by every policy"), seed=4, out="its folder")
    parser.add_argument("--policies", default=None, help="some of them; all by default")
    options = parser.parse_args()
    content = yaml.safe_load(file.find("policies").read_text(encoding="utf-8"))
    if options.policies is not None:
        content["vary"][POLICY] = options.policies.split(",")
    campaign = gcs.Campaign(
        content, sessions=options.sessions, seed=options.seed, out=options.out, workers=options.workers
    )
    rows: list[Row] = campaign.fly(told).to_pylist()
    print(file=sys.stderr)
    print(f"seed {options.seed}, {options.sessions} scenarios\n")
    for text in table(rows):
        print(text)


def table(rows: Sequence[Row]) -> list[str]:
    """Lines of Markdown: a row for each policy, then the differences of each to `optimal` and what they say."""
    flown = [row for row in rows if not row["error"]]
    by = {
        name: {r["session"]: r for r in flown if r[POLICY] == name} for name in dict.fromkeys(r[POLICY] for r in rows)
    }
    lines = [
        "| policy | scenarios | lost somebody | vehicles lost | at least | kept everyone where an order does "
        "| tanker idle while somebody waits, s a session | sessions with any |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for name, of in by.items():
        lost = [row["lost_somebody"] > 0 for row in of.values()]
        can = [not row["lost_somebody"] for row in of.values() if row["keepable"] == 1.0]
        idle = np.array([row["tanker_idle_s"] for row in of.values()], dtype=np.float64)
        lines.append(
            f"| `{name}` | {len(of)} | {_rate(wilson(sum(lost), len(lost)))} "
            f"| {sum(row['lost'] for row in of.values()):g} | {sum(row['least_lost'] for row in of.values()):g} "
            f"| {sum(can)} of {len(can)}, {_rate(wilson(sum(can), len(can)))} "
            f"| {idle.mean():.3f}, most {idle.max():.2f} | {int((idle > 0.0).sum())} |"
        )
    failed = len(rows) - len(flown)
    unknown = sum(row["keepable"] is None for row in by[next(iter(by))].values())
    lines += ["", f"{failed} sessions could not be flown; of {unknown} scenarios the search does not know.", ""]
    if "optimal" in by:
        for name, those in by.items():
            if name != "optimal":
                lines.append(_difference(name, those, by["optimal"]))
    return lines


def _difference(name: str, those: dict[int, Row], best: dict[int, Row]) -> str:
    both = sorted(those.keys() & best.keys())
    more = mean(np.array([those[s]["lost_somebody"] - best[s]["lost_somebody"] for s in both], dtype=np.float64))
    says = "within" if more.high <= ALLOWED_MORE else "not shown to be within" if more.low <= ALLOWED_MORE else "beyond"
    return (
        f"`{name}` loses somebody in {_rate(more)} of the scenarios more than `optimal` ({len(both)} pairs): {says} "
        f"{100 * ALLOWED_MORE:g} in a hundred."
    )


def _rate(interval: Interval) -> str:
    return f"{100 * interval.value:.1f} % [{100 * interval.low:.1f}, {100 * interval.high:.1f}]"


if __name__ == "__main__":
    main()
