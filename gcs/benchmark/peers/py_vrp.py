"""PyVRP re-solved (N. A. Wouda, L. Lan, W. Kool, INFORMS Journal on Computing 36, 2024): a route for each tanker, with
time windows, and a prize for each receiver that is served in its own."""

from __future__ import annotations

import math
import time

from pyvrp import Model

from gcs.benchmark.peers.rolling import UNIT_S, Jobs, Rolling

PRIZE = 100_000


class PyVrp(Rolling):
    """Routes need not end anywhere: ways to their ends take no time."""

    def plan(self, jobs: Jobs, seconds: float) -> dict[int, int] | None:
        """The first job of each tanker that has one; None where no plan was found in time."""
        model, n, m = Model(), len(jobs.receivers), len(jobs.tankers)
        served = [
            j for j in range(n)
            if math.ceil(jobs.from_s[j] / UNIT_S) <= math.floor(jobs.until_s[j] / UNIT_S) and jobs.until_s[j] >= 0.0
        ]  # fmt: skip
        if not served:
            return {}
        starts = [model.add_location(k, 0) for k in range(m)]
        places = [model.add_location(j, 1) for j in served]
        for place, j in zip(places, served, strict=True):
            takes, low = math.ceil(jobs.takes_s[j] / UNIT_S), math.ceil(jobs.from_s[j] / UNIT_S)
            high = math.floor(jobs.until_s[j] / UNIT_S)
            model.add_client(
                place, service_duration=takes, tw_early=low, tw_late=high, prize=PRIZE, required=False
            )  # fmt: skip
        for k, start in enumerate(starts):
            depot = model.add_depot(start)
            profile = model.add_profile()
            free = math.ceil(jobs.free_s[k] / UNIT_S)
            model.add_vehicle_type(1, start_depot=depot, end_depot=depot, tw_early=free, profile=profile)
            for a, i in zip(places, served, strict=True):
                way = math.ceil(jobs.first_s[k, i] / UNIT_S)
                model.add_edge(start, a, distance=way, duration=way, profile=profile)
                model.add_edge(a, start, distance=0, duration=0, profile=profile)
                for b, j in zip(places, served, strict=True):
                    if i != j:
                        way = math.ceil(jobs.between_s[k, i, j] / UNIT_S)
                        model.add_edge(a, b, distance=way, duration=way, profile=profile)
        until_s = time.process_time() + seconds
        best = model.solve(lambda _: time.process_time() > until_s, seed=1, collect_stats=False, display=False).best
        if not best.is_feasible():
            return None
        found: dict[int, int] = {}
        for route in best.routes():
            first = next(visit for visit in route if visit.is_client())
            found[route.vehicle_type()] = served[first.idx]
        return found
