"""Winners and orders of Examples 2, 3 and 4 under what the paper does not print: every combination of the time of a
step, the readings of eqs. 4 and 17, the yaw that is kept, the energy, and how long it is counted.

The plans are the planner's, the flights the vehicle's own (`simvehicle paper --plans`); nothing is tuned.
"""

from __future__ import annotations

import itertools
import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.planner import fuzzy_escape
from gcs.planner.potential_field import FieldConstants
from gcs.recording.series import Floats
from gcs.report.paper.session import NED_TO_PAPER
from gcs.report.paper.study import Measurement, Study, Table
from gcs.report.paper.theory import step_alone
from skytender import geometry

STARTS = ((0.0, 5.0, 0.0), (0.0, 0.0, 0.0), (0.0, -5.0, 0.0))
SPEEDS = ((0.0, 0.0, 0.0), (1.0, 3.0, 2.0), (2.0, 2.0, 2.0), (1.0, 3.0, 6.0), (1.0, 2.0, 4.0))
EXAMPLE_2_SPEED = (1.0, 1.0, 1.0)
COURSE = ((5.0, 5.0, 1.5), (10.0, 10.0, 3.0))
OBSTACLES = (  # Example 1's
    *((1, 2, 1.5), (2, 2, 1), (2, 2, 2), (4, 2.2, 2.1), (4.1, 3, 2.1), (3, 5, 2.1), (4, 5, 2.1), (5, 5, 2.3)),
    *((5.8, 5, 2.4), (8, 5, 2.6), (8.3, 6, 2.7), (8, 8, 2.6), (8.5, 8, 2.7)),
)
"""Paper axes, m and m/s [seed]; vehicles 1-15 are Example 3's, 6-10 also Example 4's, and three more Example 2's."""
STEPS = {"shrinking": False, "whole": True}
STEP_M, MOST_STEPS = 0.1, 400
PAPERS_WINNER, PAPERS_ORDER_2, PAPERS_ORDER_4 = 8, (1, 2, 3), (5, 1, 4, 2, 3)
SECONDS = (2.0, 5.0, 10.0)
FIFTHS = 5


@dataclass(frozen=True)
class Combination:
    """One choice of everything that is not printed, as text by what was chosen; and what comes of it."""

    choice: Mapping[str, str]
    winner_3: int
    order_2: tuple[int, ...]
    orders_4: Sequence[tuple[int, ...]]
    """counted within each fifth, and since the start; none where the time is not cut into fifths"""


def planned(start: Sequence[float], *, full_steps: bool) -> Floats:
    """Velocities (k, 3) m/s, paper axes, of a planned point's steps of 0.1 m and 0.1 s along the course."""
    field = FieldConstants(full_steps=full_steps)
    obstacles = geometry.points(np.array(OBSTACLES) * NED_TO_PAPER)
    q, memory = np.array([start]) * NED_TO_PAPER, fuzzy_escape.new_memory(1)
    left = [np.array(point) * NED_TO_PAPER for point in COURSE]
    velocities: list[Floats] = []
    while left and len(velocities) < MOST_STEPS:
        q, memory, v_ned = step_alone(q, memory, left[0], obstacles=obstacles, field=field, escape=True)
        velocities.append(v_ned[0] * NED_TO_PAPER)
        if np.linalg.norm(q[0] - left[0]) <= STEP_M:
            left.pop(0)
    return np.array(velocities)


def write_plans(path: Path) -> dict[str, list[int]]:
    """Write the plans of all vehicles for `simvehicle paper --plans`; the length of each start's plan, by steps."""
    plans = {name: [planned(start, full_steps=full) for start in STARTS] for name, full in STEPS.items()}
    longest = max(len(plan) for each in plans.values() for plan in each)
    rows = [*itertools.chain.from_iterable([i] * len(SPEEDS) for i in range(len(STARTS))), *range(len(STARTS))]

    def padded(plan: Floats) -> list[Any]:
        return np.concatenate([plan, np.zeros((longest - len(plan), 3))]).tolist()

    content = {
        "start_velocity_nwu": [*(list(SPEEDS) * len(STARTS)), *[EXAMPLE_2_SPEED] * len(STARTS)],
        "plans": [{"name": name, "velocity_nwu": [padded(each[i]) for i in rows]} for name, each in plans.items()],
    }
    path.write_text(json.dumps(content), encoding="utf-8")
    return {name: [len(plan) for plan in each] for name, each in plans.items()}


def combinations(energies: Mapping[str, NDArray[Any]], lengths: Mapping[str, Sequence[int]]) -> Iterator[Combination]:
    """Every combination in turn, of what `simvehicle paper --plans` wrote; `lengths` is `write_plans`' result."""
    energy = energies["energy"]
    for i, (step_s, plan, gains, yaw) in enumerate(
        zip(energies["step_s"], energies["plan"], energies["gain_set"], energies["yaw_rad"], strict=True)
    ):
        own = np.array(lengths[str(plan)])
        start_of = np.concatenate([np.repeat(np.arange(3), 5), np.arange(3)])
        latest, last = int(own.max()) - 1, energy.shape[3] - 1
        ends: dict[str, NDArray[Any]] = {
            "up to its own arrival": own[start_of] - 1,
            "up to half of its way": own[start_of] // 2 - 1,
            "up to the last arrival": np.full(18, latest),
            "up to the last arrival and some time at rest": np.full(18, last),
        }
        ends |= {f"first {s:g} s": np.full(18, min(round(s / float(step_s)) - 1, last)) for s in SECONDS}
        for (m, measure), (until, end) in itertools.product(enumerate(energies["measures"]), ends.items()):
            used = energy[i, np.arange(18), m, end]
            fifths = until.startswith("up to the last")
            yield Combination(
                {
                    "a step takes": f"{float(step_s):g} s",
                    "steps (eq. 4)": str(plan),
                    "eq. 17": "signed thrust, no floor" if str(gains).endswith("literal") else "floor of 0.3 g",
                    "yaw kept": f"{float(yaw):g} rad",
                    "energy": str(measure),
                    "counted": until,
                },
                int(used[:15].argmin()) + 1,
                tuple(int(k) + 1 for k in np.argsort(used[15:], kind="stable")),
                [_served(energy[i, 5:10, m], int(end[5]), within) for within in (True, False)] if fifths else (),
            )


def _served(energy: Floats, end: int, within: bool) -> tuple[int, ...]:
    """Order of five (5, k): at the end of each fifth which of those left has used most, within it or since the
    start."""
    bounds = [round(end * k / FIFTHS) for k in range(FIFTHS + 1)]
    left, order = list(range(len(energy))), []
    for before, now in itertools.pairwise(bounds):
        used = energy[:, now] - (energy[:, before] if within and before else 0.0)
        order.append(max(left, key=lambda k: used[k]))
        left.remove(order[-1])
    return tuple(k + 1 for k in order)


def study(energies: Mapping[str, NDArray[Any]], lengths: Mapping[str, Sequence[int]]) -> Study:
    """Shares of all combinations that give the paper's winner and orders, and the tables of sensitivity."""
    found = list(combinations(energies, lengths))
    winners = Counter(one.winner_3 for one in found)
    orders_2 = Counter(one.order_2 for one in found)
    orders_4 = Counter(order for one in found for order in one.orders_4)
    chance = f"of {len(found)} combinations; by chance 1 in 15"
    n4 = sum(orders_4.values())
    first, count = winners.most_common(1)[0]
    measured = {
        "sens-ex3-papers": Measurement(winners[PAPERS_WINNER] / len(found), chance),
        "sens-ex3-one": Measurement(
            count / len(found), f"vehicle {first}; {len(winners)} of 15 vehicles win somewhere"
        ),
        "sens-ex2-papers": Measurement(orders_2[PAPERS_ORDER_2] / len(found), f"of {len(found)}; by chance 1 in 6"),
        "sens-ex4-papers": Measurement(orders_4[PAPERS_ORDER_4] / n4, f"of {n4}; by chance 1 in 120"),
    }
    rows = [
        [str(k), _triple(STARTS[(k - 1) // 5]), _triple(SPEEDS[(k - 1) % 5]), _percent(winners[k] / len(found))]
        for k in range(1, 16)
    ]
    tables = [
        Table(
            f"Example 3: the winner, in {len(found)} combinations", ["vehicle", "start, m", "speed, m/s", "wins"], rows
        ),
        _orders(f"Example 2: order of the energies, in {len(found)} combinations", orders_2, PAPERS_ORDER_2),
        _orders(f"Example 4: order of refuelling by fifths, in {n4} combinations", orders_4, PAPERS_ORDER_4),
        _by_choice(found),
    ]
    return Study(measured, (), tables)


def _orders(caption: str, orders: Counter[tuple[int, ...]], papers: tuple[int, ...]) -> Table:
    total, shown = sum(orders.values()), [order for order, _ in orders.most_common(6)]
    if papers not in shown:
        shown.append(papers)
    rows = [
        [", ".join(map(str, order)) + (" (the paper's)" if order == papers else ""), _percent(orders[order] / total)]
        for order in shown
    ]
    return Table(f"{caption}; {len(orders)} orders occur", ["order", "share"], rows)


def _by_choice(found: Sequence[Combination]) -> Table:
    """Effect of each single choice does, over all combinations that have it."""
    rows = []
    for name in found[0].choice:
        for level in dict.fromkeys(one.choice[name] for one in found):
            those = [one for one in found if one.choice[name] == level]
            winner, count = Counter(one.winner_3 for one in those).most_common(1)[0]
            fourth = [order for one in those for order in one.orders_4]
            rows.append(
                [
                    f"{name}: {level}",
                    f"{winner} ({_percent(count / len(those))})",
                    _percent(sum(one.winner_3 == PAPERS_WINNER for one in those) / len(those)),
                    _percent(sum(one.order_2 == PAPERS_ORDER_2 for one in those) / len(those)),
                    _percent(fourth.count(PAPERS_ORDER_4) / len(fourth)) if fourth else "–",
                ]
            )
    columns = ["chosen", "Example 3: most frequent winner", "vehicle 8 wins", "Example 2: 1, 2, 3"]
    return Table("What each choice does", [*columns, "Example 4: 5, 1, 4, 2, 3"], rows)


def _percent(share: float) -> str:
    return f"{100.0 * share:.1f} %"


def _triple(vector: Sequence[float]) -> str:
    return ", ".join(f"{x:g}" for x in vector)
