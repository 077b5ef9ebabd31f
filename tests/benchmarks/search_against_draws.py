"""A campaign's search against random draws: is the worst of 200 trials at least as bad as the worst of 1,000 draws?

    python search_against_draws.py --out ../../campaigns/search

Three vehicles meet under the plain field; where they come from, how high, when, and how fast is drawn, and how near any
two come is searched for. Heights are drawn too because two that cross in one plane miss each other by one number, which
a thousand draws bring to a millimetre by luck.
"""

from __future__ import annotations

import argparse
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import yaml

HERE = Path(__file__).resolve().parent
OUT_M, HEIGHT_M = 5.0, 5.0
DRAWN: dict[str, Any] = {
    **{f"arguments.bearing_{k}_deg": {"uniform": [120.0 * k - 55.0, 120.0 * k + 55.0]} for k in range(3)},
    **{f"arguments.ahead_{k}_m": {"uniform": [0.0, 3.0]} for k in range(3)},
    **{f"arguments.aside_{k}_m": {"uniform": [-2.0, 2.0]} for k in range(3)},
    **{f"arguments.above_{k}_m": {"uniform": [-2.0, 2.0]} for k in range(3)},
    "planner.cruise_m_s": {"uniform": [1.5, 4.0]},
}


def encounter(seed: int, **drawn: float) -> dict[str, Any]:
    """Three vehicles that fly through the middle, each from a bearing, a lead, an offset and a height of its own."""
    pursuers = []
    for k in range(3):
        bearing = math.radians(drawn[f"bearing_{k}_deg"])
        out_m, aside_m = OUT_M + drawn[f"ahead_{k}_m"], drawn[f"aside_{k}_m"]
        n, e = math.cos(bearing), math.sin(bearing)
        down = -HEIGHT_M - drawn[f"above_{k}_m"]
        start = [out_m * n - aside_m * e, out_m * e + aside_m * n, down]
        end = [-OUT_M * n - aside_m * e, -OUT_M * e + aside_m * n, down]
        pursuers.append({"sysid": k + 1, "start_m": start, "airborne": True, "waypoints_m": [end]})
    return {
        "schema": 1, "name": "encounter", "axes": "ned", "seed": seed, "truth": True,
        "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0}, "clock": {"mode": "lockstep"},
        "goal": {"duration_s": 6.0, "waypoints": "none"},
        "vehicles": {"defaults": {"battery": {"capacity_j": 100_000}}, "pursuers": pursuers},
        "planner": {"safety": False}, "refuelling": {"enabled": False},
    }  # fmt: skip


def campaign(seed: int, draws: int, trials: int) -> dict[str, Any]:
    return {
        "schema": 1, "name": "encounter", "generate": "search_against_draws:encounter", "draw": DRAWN,
        "sessions": draws, "seed": seed, "measure": ["min_separation_m"], "keep": "none",
        "search": {"minimise": "min_separation_m", "trials": trials},
    }  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--seeds", default="1,2,3")
    parser.add_argument("--trials", type=int, default=200)
    parser.add_argument("--draws", type=int, default=1000)
    parser.add_argument("--out", type=Path, required=True, help="new folder")
    options = parser.parse_args()
    options.out.mkdir(parents=True)
    print("| seed | worst of the draws, m | worst of the trials, m |\n|---|---|---|")
    for seed in map(int, options.seeds.split(",")):
        path = HERE / f"encounter-{seed}.yaml"  # beside the module that it names
        path.write_text(yaml.safe_dump(campaign(seed, options.draws, options.trials)), encoding="utf-8")
        try:
            worst = [worst_m(verb, path, options.out / f"{verb}-{seed}") for verb in ("run", "search")]
        finally:
            path.unlink()
        print(f"| {seed} | {worst[0]:.4f} | {worst[1]:.4f} |", flush=True)


def worst_m(verb: str, path: Path, out: Path) -> float:
    """Least separation of a campaign's rows, flown by the command."""
    subprocess.run([sys.executable, "-m", "gcs", "campaign", verb, str(path), "--out", str(out)], check=False)
    rows = pq.read_table(out / "rows", columns=["min_separation_m"])
    return float(min(value for value in rows.column(0).to_pylist() if value is not None))


if __name__ == "__main__":
    main()
