"""A user's planner beside set points that a program gives."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scenarios import SMALL, loaded
from views import snapshot, view

from gcs.planner.custom import OwnPlanner
from gcs.planner.request import GuardedPlanner, PlanRequest, Situation
from gcs.scenario.guard import Guard, PluginFault
from gcs.scenario.plugins import PluginClient

GIVEN = ((7.0, 8.0, -9.0), (0.5, 0.25, 0.0))
PLANNED = (1.0, 2.0, -3.0, 0.0, 0.0, 0.125)


COMPLEX = np.array([1.0, 2.0, -3.0 + 1j])


@pytest.mark.parametrize("p_ned", [COMPLEX, COMPLEX.astype(object), [1.0, 2.0, -3.0 + 1j], COMPLEX.real + 0j])
def test_complex_numbers_are_no_answer(p_ned: Any) -> None:
    guard = Guard("planner a:B")
    answering = SimpleNamespace(plan=lambda *_: (p_ned, (0.0, 0.0, 0.0)))
    situation = Situation(1.0, 0.1, snapshot(view(1)), {}, ())
    assert GuardedPlanner(answering, guard).plan(view(1), situation) is None
    (fault,) = guard.pop_faults()
    assert fault.problem == "returned complex numbers, which are no place or speed"
    answering.plan = lambda *_: (np.array([1.0, 2.0, -3.0], dtype=object), np.zeros(3, np.float32))
    assert GuardedPlanner(answering, guard).plan(view(1), situation) == ((1.0, 2.0, -3.0), (0.0, 0.0, 0.0))


class Answering(PluginClient):
    """A planner's process that wants every vehicle at one place."""

    ended = False

    def __init__(self) -> None:
        self.asked: list[list[int]] = []

    def made(self, key: str) -> bool:
        return False

    def ask(self, key: str, question: Any) -> None:
        self.asked.append(question[0])

    def answers(self, key: str) -> list[Any]:
        return [(sysid, *PLANNED) for sysid in self.asked[-1]]

    def pop_faults(self) -> list[PluginFault]:
        return []


def test_a_given_set_point_stands_for_a_users_planner_which_is_not_asked_for_it(tmp_path: Path) -> None:
    plugins = Answering()
    planner = OwnPlanner(loaded(tmp_path / "small.yaml", SMALL), plugins)
    seen = snapshot(view(1), view(2, p_ned=(9.0, 0.0, -4.0)), view(3, "target", p_ned=(1.0, 9.0, -4.0)))
    request = PlanRequest(seen, frozenset((1, 2, 3)), 0.1)
    both = {point.sysid: point[1:] for point in planner.plan(request._replace(given={2: GIVEN, 3: GIVEN}))}
    assert plugins.asked == [[1]]
    assert (both[1], both[2], both[3]) == ((PLANNED[:3], PLANNED[3:]), GIVEN, GIVEN)
    alone = {point.sysid: point[1:] for point in planner.plan(request)}
    assert plugins.asked == [[1], [1, 2]]
    assert alone[2] == (PLANNED[:3], PLANNED[3:])
    on_the_ground = request._replace(steered=frozenset((1, 3)), given={2: GIVEN})
    assert [point.sysid for point in planner.plan(on_the_ground)] == [1, 3]
