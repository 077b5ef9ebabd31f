"""How soon vehicles that compete on board agree, beside the central competition in the same flights.

    python tests/benchmarks/onboard_agreement.py [--fleets N] [--first SEED]     one process, real vehicles and radios
    python tests/benchmarks/onboard_agreement.py --flown N                       pairs of whole sessions
    python tests/benchmarks/onboard_agreement.py --silent                        the demo without a ground station

A fleet's vehicles are scattered at random with 25 to 49 % of charge and tankers that take part from 5 s on, so that all
of them have something to decide at once. `later` is from the central decision, made from the same telemetry over the
same radio, to the moment from which every vehicle and tanker has received who is served by whom.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))

from fleets import Agreement, agreement, random_fleet
from rich.console import Console
from rich.table import Table
from sessions import demo, fly, merged

RADIOS: dict[str, dict[str, Any]] = {
    "clear": {},
    "20 % loss, 0.2 s": {"loss": 0.2, "delay_s": 0.2},
    "40 % loss, 0.2 s": {"loss": 0.4, "delay_s": 0.2},
}
TANKERS = (1, 2, 4)
PURSUERS = 10
SILENT_FROM_S = (10, 20, 30, 40)
SILENT_FOR_S = 60


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--fleets", type=int, default=40, help="fleets of each kind")
    parser.add_argument("--first", type=int, default=0, help="seed of the first")
    parser.add_argument("--flown", type=int, metavar="N", help="fly N pairs of sessions instead")
    parser.add_argument("--silent", action="store_true", help="fly the demo without a ground station instead")
    options = parser.parse_args()
    seeds = range(options.first, options.first + (options.flown or options.fleets))
    table = in_silence() if options.silent else in_sessions(seeds) if options.flown else in_process(seeds)
    Console(width=None if sys.stdout.isatty() else 150).print(table)


def scattered(seed: int, tankers: int, radio: dict[str, Any]) -> dict[str, Any]:
    """A random fleet of ten that all want energy."""
    return random_fleet(seed, pursuers=PURSUERS, tankers=tankers, half_m=12.0, percent=(25.0, 49.0), radio=radio)


def in_process(seeds: range) -> Table:
    """Every radio and number of tankers."""
    table = Table(title=f"{PURSUERS} vehicles, {len(seeds)} fleets each, from seed {seeds[0]}")
    for name in ("radio", "tankers", "later: median", "90 %", "most", "same winners", "calls in vain", "undecided"):
        table.add_column(name, justify="left" if name == "radio" else "right")
    for radio, keys in RADIOS.items():
        for tankers in TANKERS:
            found = [agreement(scattered(seed, tankers, keys)) for seed in seeds]
            table.add_row(radio, str(tankers), *_row(found))
    return table


def _row(found: list[Agreement]) -> list[str]:
    agreed = [one for one in found if one.agreed_s < float("inf") and one.central_s < float("inf")]
    later_s = sorted(one.agreed_s - one.central_s for one in agreed)
    same = sum(set(one.on_board.values()) == set(one.central.values()) for one in agreed)
    return [
        f"{statistics.median(later_s):.1f} s",
        f"{later_s[int(0.9 * (len(later_s) - 1))]:.1f} s",
        f"{later_s[-1]:.1f} s",
        f"{same} of {len(agreed)}",
        str(sum(one.refused_calls for one in found)),
        str(len(found) - len(agreed)),
    ]


def in_sessions(seeds: range) -> Table:
    """Pairs of whole sessions over the lossy radio: the central one and the one on board."""
    table = Table(title=f"{PURSUERS} vehicles and a tanker in whole sessions, 20 % loss, 0.2 s")
    for name in ("seed", "central: decided", "winner", "on board: taken", "winner", "later"):
        table.add_column(name, justify="right")
    later_s = []
    for seed in seeds:
        content = scattered(seed, 1, RADIOS["20 % loss, 0.2 s"])
        content["vehicles"]["tankers"][0]["join_s"] = 5.0
        content["goal"] = {"duration_s": 20.0, "refuelled_at_least": 0}
        central, on_board = (_first(merged(content, {"competition": {"where": w}})) for w in ("supervisor", "vehicles"))
        later_s.append(on_board[0] - central[0])
        decided = (f"{central[0]:.1f} s", str(central[1]), f"{on_board[0]:.1f} s", str(on_board[1]))
        table.add_row(str(seed), *decided, f"{later_s[-1]:.1f} s")
    table.caption = f"median {statistics.median(later_s):.1f} s"
    return table


def _first(content: dict[str, Any]) -> tuple[float, int]:
    """When the first receiver was decided, on board: when its tanker had taken it, by the tanker's own log; and who."""
    with tempfile.TemporaryDirectory() as folder:
        outcome = fly(content, Path(folder), "--quiet")
        if content["competition"]["where"] == "supervisor":
            service = outcome.summary["refuelling"][0]
            return service["decided_at_s"], service["receiver"]
        log = (outcome.folder / "vehicles" / "201.log").read_text(encoding="utf-8")
    taken = next(line for line in log.splitlines() if "Serves " in line)
    _, time, _, said = taken.split(": ")
    return float(time.removesuffix(" s")), int(said.removeprefix("Serves "))


def in_silence() -> Table:
    """The demo with a dead radio of the ground station, from different times on, with and without loss."""
    table = Table(title=f"The demo, the ground station's radio dead for {SILENT_FOR_S} s")
    for name in (
        "from",
        "radio",
        "outcome",
        "served in the dark",
        "lowest battery",
        "separation",
        "clearance",
        "traffic",
    ):
        table.add_column(name)
    for from_s in SILENT_FROM_S:
        for radio in ("clear", "20 % loss, 0.2 s"):
            table.add_row(f"{from_s} s", radio, *silent_demo(from_s, RADIOS[radio]))
    return table


def silent_demo(from_s: float, radio: dict[str, Any]) -> list[str]:
    """One session, by what the vehicles themselves recorded."""
    window = [{"from_s": from_s, "to_s": from_s + SILENT_FOR_S}]
    changes = {"competition": {"where": "vehicles"}, "radio": {**radio, "ground_blackouts": window}}
    with tempfile.TemporaryDirectory() as folder:
        outcome = fly(merged(demo(), changes), Path(folder), "--quiet")
        summary = outcome.summary
        served, lowest = 0, 1.0
        for vehicle in summary["vehicles"]:
            truth = outcome.truth(vehicle["sysid"])
            _, received, _, remaining = truth.energy.T
            dark = (truth.time_s >= from_s) & (truth.time_s < from_s + SILENT_FOR_S)
            served += bool(received[dark][-1] > received[dark][0])
            lowest = min(lowest, float(remaining.min() / truth.head["capacity_j"]))
    return [
        summary["outcome_text"],
        f"{served} vehicles",
        f"{100.0 * lowest:.0f} %",
        *(f"{summary[f'min_{key}_m']:.2f} m" for key in ("separation", "clearance", "traffic")),
    ]


if __name__ == "__main__":
    main()
