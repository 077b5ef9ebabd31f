"""Figure 12: what a further session of a campaign costs, over the CPU time of its flight alone.

Sessions of 30 s of the paper's Example 1 are flown one after the other from one spawner, as a campaign's worker
does, from the row's number to the row; among them long ones of the same flight, to and fro for 150 s. What 30 s more
of flight cost in a long one is the flight alone. A session costs what its processes and the worker spend, and its share
of what the two fork servers spend, from which its processes are forked.
"""

from __future__ import annotations

import statistics
from pathlib import Path
from typing import Any

from measure import Figure, cpu_s_of

from gcs.campaign import worker
from gcs.campaign.file import from_data
from gcs.campaign.plan import Plan, make

SESSION_S, LONG_S = 30.0, 150.0
SESSIONS, SHORT_PER_LONG = 50, 5
TO_AND_FRO = [[10.0, 10.0, 3.0], [5.0, 5.0, 1.5], [0.0, 0.0, 0.0], [5.0, 5.0, 1.5]] * 8
GOAL = 1.3
PAGE_KIB = 4.0


def plan(duration_s: float) -> Plan:
    settings = {"goal.duration_s": duration_s, "vehicles.pursuers.*.waypoints_m": TO_AND_FRO}
    content: dict[str, Any] = {"schema": 1, "name": "bench", "scenario": "paper/example1", "sessions": SESSIONS}
    return make(from_data({**content, "set": settings, "keep": "none"}), [])


def figures() -> list[Figure]:
    short, long = plan(SESSION_S), plan(LONG_S)
    cost_s: list[float] = []
    long_s: list[float] = []
    wall_s: list[float] = []
    worker._sessions().wait_ready()
    serving_s = _serving_cpu_s()
    memory_kib: list[float] = []
    try:
        for number in range(SESSIONS):
            row = worker.fly_row(short, short.row(number))
            cost_s.append(row["cpu_s"])
            wall_s.append(row["wall_s"])
            if number % SHORT_PER_LONG == 0:
                long_s.append(worker.fly_row(long, long.row(number))["cpu_s"])
            memory_kib.append(_resident_kib())
        serving_s = (_serving_cpu_s() - serving_s) / (len(cost_s) + len(long_s))
    finally:
        worker.close()
    flight_s = (statistics.median(long_s) - statistics.median(cost_s)) / (LONG_S - SESSION_S) * SESSION_S
    session_s = statistics.median(cost_s) + serving_s
    growth = memory_kib[-1] / memory_kib[len(memory_kib) // 5]
    name = f"a further session of {SESSION_S:.0f} s, spawned"
    return [
        Figure(12, f"{name}: CPU over its flight alone", session_s / flight_s, "x", GOAL, True, cpu_s=session_s),
        Figure(12, "  wall time", statistics.median(wall_s), "s"),
        Figure(
            12, f"  memory of the worker after {SESSIONS}, over that after {SESSIONS // 5}", growth, "x", 1.05, True
        ),
    ]


def _resident_kib() -> float:
    """Of this process and the two that its sessions are forked from."""
    pids = ["self", *(str(pid) for sessions in worker._all for pid in sessions.pids)]
    return sum(PAGE_KIB * int(Path(f"/proc/{pid}/statm").read_text(encoding="ascii").split()[1]) for pid in pids)


def _serving_cpu_s() -> float:
    """CPU time of the two fork servers, without that of what they forked."""
    return sum(cpu_s_of(pid) for sessions in worker._all for pid in sessions.pids)
