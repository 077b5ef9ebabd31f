"""The gate of meSch (K. B. Naveed, A. Dang, R. Kumar, D. Panagou, IROS 2025, arXiv 2406.04560): robots go to charge one
at a time, and no sooner than the gaps between their remaining times ask for it.

As the authors' program has it (github.com/kalebbennaveed/meSch, recompute_committed_timed_quads!) [lineage]: of robots
on their mission, in order of remaining time TF_1 <= TF_2 <= …, TC_1 is when the first is back at the station if it
stays for one interval more. It goes to charge now if any flag is false of

    TF_k - TC_1 > (k - 1) (T_charge + T_delta),    k = 2, 3, …

and otherwise each goes on whose own way back leaves energy.

Here stations fly to robots, and there are several [choice]. TC_1 is when energy would flow if the nearest free tanker
set off one interval later. T_charge is the mean service, T_delta DELTA mean ways. The right side becomes when the k-th
would have its turn if each took the tanker that is free first, which is the same for one that is free; for k = 1 it is
the test of its own energy. Receivers that do not wait yet are counted, but the first that waits is sent for.
"""

from __future__ import annotations

import heapq

from gcs.benchmark.peers.flight import TICK_S, DispatchedFlight

DELTA = 4.0
"""[choice] With wider gaps the gate is open more often, until it is earliest deadline."""


class GapGate:
    """The gate is asked again after each receiver that passed, while a tanker is free."""

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker."""
        receivers, setup_s = flight.flying(), flight.arrays.setup_s
        left_s = dict(zip(receivers, (flight.lands_s[receivers] - flight.now_s).tolist(), strict=True))
        ways_s = flight.ways_s(flight.waiting)
        flows_s = flight.takes_s(receivers, flight.lands_s[receivers])
        service_s = setup_s + float(flows_s.mean()) + DELTA * float(ways_s.mean())
        busy_s = [float(s) - flight.now_s for s in flight.free_s if s > flight.now_s]
        order, free = sorted(receivers, key=lambda i: left_s[i]), list(range(len(flight.free)))
        found: dict[int, int] = {}
        while free and (waiting := [i for i in order if i in flight.waiting]):
            column = flight.waiting.index(waiting[0])
            nearest = min(free, key=lambda k: float(ways_s[k, column]))
            flows_in_s = TICK_S + float(ways_s[nearest, column]) + setup_s
            turns_s = _turns_s(len(order), [0.0] * len(free) + busy_s, service_s)
            if all(left_s[i] - flows_in_s > turn_s for i, turn_s in zip(order, turns_s, strict=True)):
                break
            found[flight.free[nearest]] = waiting[0]
            order.remove(waiting[0])
            free.remove(nearest)
            busy_s.append(service_s)
        return found


def _turns_s(count: int, free_in_s: list[float], service_s: float) -> list[float]:
    """When each of so many has its turn, if each takes the tanker that is free first."""
    queue, turns_s = sorted(free_in_s), []
    for _ in range(count):
        turns_s.append(queue[0])
        heapq.heapreplace(queue, queue[0] + service_s)
    return turns_s
