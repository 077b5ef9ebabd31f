"""CP-SAT in a rolling horizon: the most services in time, and of these plans the one that begins them soonest."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

from ortools.sat.python import cp_model

from gcs.benchmark.peers.rolling import UNIT_S, Jobs, Rolling

LOST = 10_000
"""Units of time that a receiver which is not served in time costs."""

LOOKS_S = 0.002


class CpSat(Rolling):
    """Optional intervals, each on one tanker, with ways between them."""

    def plan(self, jobs: Jobs, seconds: float) -> dict[int, int] | None:
        """The first job of each tanker that has one; None where no plan was found in time."""
        model, n, m = cp_model.CpModel(), len(jobs.receivers), len(jobs.tankers)
        starts, on = [], []
        costs = []
        for j in range(n):
            low, high = math.ceil(jobs.from_s[j] / UNIT_S), math.floor(jobs.until_s[j] / UNIT_S)
            served = [model.NewBoolVar("") for _ in range(m)]
            start = model.NewIntVar(min(low, max(high, 0)), max(high, low, 0), "")
            if high < low:
                model.Add(sum(served) == 0)
            model.AddAtMostOne(served)
            for k in range(m):
                soonest = math.ceil((jobs.free_s[k] + jobs.first_s[k, j]) / UNIT_S)
                model.Add(start >= soonest).OnlyEnforceIf(served[k])
            starts.append(start)
            on.append(served)
            costs.append(start + LOST * (1 - sum(served)))
        for j in range(n):
            for i in range(j + 1, n):
                before = model.NewBoolVar("")
                for k in range(m):
                    both = [on[j][k], on[i][k]]
                    there = math.ceil((jobs.takes_s[j] + jobs.between_s[k, j, i]) / UNIT_S)
                    back = math.ceil((jobs.takes_s[i] + jobs.between_s[k, i, j]) / UNIT_S)
                    model.Add(starts[i] >= starts[j] + there).OnlyEnforceIf([*both, before])
                    model.Add(starts[j] >= starts[i] + back).OnlyEnforceIf([*both, before.Not()])
        model.Minimize(sum(costs))
        for one in (one for served in on for one in served):
            model.AddHint(one, 0)
        solver = cp_model.CpSolver()
        solver.parameters.num_workers = 1
        solver.parameters.random_seed = 1
        with _stopped_after(solver, seconds):
            solver.Solve(model)
        if solver.StatusName() not in ("OPTIMAL", "FEASIBLE"):
            return None
        order = sorted(range(n), key=lambda j: -solver.Value(starts[j]))
        return {k: j for j in order for k in range(m) if solver.Value(on[j][k])}


@contextmanager
def _stopped_after(solver: cp_model.CpSolver, seconds: float) -> Iterator[None]:
    """The solver's own limit is wall time; this one is processor time, which is the same on a machine that is busy."""
    until_s, ended = time.process_time() + seconds, threading.Event()

    def watch() -> None:
        while not ended.wait(LOOKS_S):
            if time.process_time() > until_s:
                solver.StopSearch()

    thread = threading.Thread(target=watch)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()
