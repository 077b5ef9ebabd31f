"""Methods on the same instances, in equal time, as one table."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from msgspec import Struct

from gcs.benchmark import gaps
from gcs.benchmark.arrays import Arrays
from gcs.benchmark.format import Instance, Schedule, plain
from gcs.benchmark.generator import KINDS, OF_A_KIND, instance
from gcs.benchmark.peers.dispatching import ApparentTardiness, FirstToLand, LeastWays, NearestPair
from gcs.benchmark.peers.due_windows import ModifiedTardiness, PiecewiseTardiness
from gcs.benchmark.peers.flight import DispatchedFlight
from gcs.benchmark.peers.gap_gate import GapGate
from gcs.benchmark.peers.own import PlannedAhead, WinnerTakeAll
from gcs.benchmark.solve import searched
from gcs.benchmark.verifier import verify
from gcs.campaign.statistics import Interval, aligned, mean, wilson
from gcs.extras import require

Method = Callable[[Arrays, float], Schedule]
EACH = 5


def _cp_sat(arrays: Arrays, seconds: float) -> Schedule:
    from gcs.benchmark.peers.cp_sat import CpSat  # noqa: PLC0415 - an extra

    return DispatchedFlight(arrays).flown(CpSat(arrays, seconds))


def _py_vrp(arrays: Arrays, seconds: float) -> Schedule:
    from gcs.benchmark.peers.py_vrp import PyVrp  # noqa: PLC0415 - an extra

    return DispatchedFlight(arrays).flown(PyVrp(arrays, seconds))


def _rrrp(arrays: Arrays, seconds: float) -> Schedule:
    from gcs.benchmark.peers.rendezvous import Rendezvous  # noqa: PLC0415 - an extra

    return DispatchedFlight(arrays).flown(Rendezvous(arrays, seconds))


METHODS: dict[str, Method] = {
    "beam_search": searched,
    "optimal": lambda arrays, _: DispatchedFlight(arrays).flown(PlannedAhead(arrays)),
    "winner_take_all": lambda arrays, _: DispatchedFlight(arrays).flown(WinnerTakeAll(arrays)),
    "cp_sat": _cp_sat,
    "pyvrp": _py_vrp,
    "rrrp": _rrrp,
    "mesch": lambda arrays, _: DispatchedFlight(arrays).flown(GapGate()),
    "aptcr": lambda arrays, _: DispatchedFlight(arrays).flown(PiecewiseTardiness()),
    "modified_atc": lambda arrays, _: DispatchedFlight(arrays).flown(ModifiedTardiness()),
    "atcs": lambda arrays, _: DispatchedFlight(arrays).flown(ApparentTardiness()),
    "earliest_deadline": lambda arrays, _: DispatchedFlight(arrays).flown(FirstToLand()),
    "hungarian": lambda arrays, _: DispatchedFlight(arrays).flown(LeastWays()),
    "greedy_nearest": lambda arrays, _: DispatchedFlight(arrays).flown(NearestPair()),
}
NEEDS = {
    "cp_sat": {"ortools": "OR-Tools"}, "pyvrp": {"pyvrp": "PyVRP"}, "hungarian": {"scipy": "SciPy"},
    "rrrp": {"scipy": "SciPy"},
}  # fmt: skip


class Result(Struct, frozen=True):
    """One method on one instance, by the verifier."""

    method: str
    instance: str
    seconds: float
    """the limit that was set"""
    lost: int | None
    """None: the schedule cannot be carried out"""
    delivered_j: float
    way_m: float
    cpu_s: float
    """that was used"""


def sample() -> list[Instance]:
    """Every EACH-th of the 300."""
    return [instance(kind, number) for kind in KINDS for number in range(0, OF_A_KIND, EACH)]


def run(method: str, one: Instance, seconds: float) -> Result:
    """The result of one instance. The limit is processor time of one thread, so that a busy machine is no disadvantage;
    what stops by it, as `cp_sat` does, makes other schedules from run to run all the same. Raises MissingExtra."""
    require(f"the method {method}", NEEDS.get(method, {}), "benchmark")
    began_s = time.process_time()
    schedule = METHODS[method](Arrays(one), seconds)
    cpu_s = time.process_time() - began_s
    verdict = verify(plain(one), plain(schedule))
    lost = len(verdict["lost"]) if verdict["feasible"] else None
    return Result(method, one.name, seconds, lost, verdict["delivered_j"], verdict["way_m"], round(cpu_s, 2))


def text(results: Mapping[str, Sequence[Result]]) -> list[str]:
    """The table's lines: rates with Wilson intervals, means with bootstrap intervals, 95 %; of schedules that can be
    carried out, and below it where a method made none."""
    known = gaps.shipped()
    lines = [("method", "loses some", "95 %", "lost", "95 %", "gap", "95 %", "kJ", "way m", "CPU s")]
    left_out = []
    for method, made in results.items():
        each = [(one, one.lost) for one in made if one.lost is not None]
        if len(each) < len(made):
            names = [one.instance for one in made if one.lost is None]
            left_out.append(f"{method} made no schedule that can be carried out of {', '.join(names)}")
        if not each:
            continue
        some = wilson(sum(lost > 0 for _, lost in each), len(each))
        lost = mean(np.array([float(lost) for _, lost in each]))
        proven = [(one, lost) for one, lost in each if one.instance in known and known[one.instance].proven]
        gap = mean(np.array([float(lost - known[one.instance].lower) for one, lost in proven]))
        lines.append(
            (
                method, f"{100 * some.value:.0f} %", f"{100 * some.low:.0f} to {100 * some.high:.0f} %",
                f"{lost.value:.2f}", _span(lost), f"{gap.value:.2f}" if proven else "-", _span(gap),
                f"{np.mean([one.delivered_j for one, _ in each]) / 1e3:.0f}",
                f"{np.mean([one.way_m for one, _ in each]):.0f}", f"{np.mean([one.cpu_s for one, _ in each]):.2f}",
            )
        )  # fmt: skip
    return [*aligned(lines), *left_out]


def _span(one: Interval) -> str:
    return "-" if math.isnan(one.low) else f"{one.low:.2f} to {one.high:.2f}"
