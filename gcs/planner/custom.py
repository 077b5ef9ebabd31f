"""A user's planner for the pursuers, in another process; targets and tankers stay with the shipped one."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.planner.planner import Planner
from gcs.planner.request import PlanRequest, Situation, TickPlanner
from gcs.planner.safe_planner import SafePlanner
from gcs.scenario.model import Scenario
from gcs.scenario.plugins import PLANNER, PluginClient
from gcs.telemetry.state import ZERO, Vec3


class OwnPlanner(TickPlanner):
    """The shipped planner, but pursuers follow a user's planner; without a good answer, and once
    its process has ended, they are held where they were last to be."""

    def __init__(self, scenario: Scenario, plugins: PluginClient) -> None:
        """Raises ScenarioError where the user's planner cannot be made."""
        self._scenario = scenario
        self._shipped = Planner(scenario)
        self.obstacles = self._shipped.obstacles
        plugins.made(PLANNER)
        self._plugins = plugins
        self._pursuers = frozenset(pursuer.sysid for pursuer in scenario.vehicles.pursuers)
        self._follows = scenario.vehicles.followed
        self._held: dict[int, Vec3] = {}

    def anchor(self, sysids: Sequence[int], p_ned: NDArray[np.float64]) -> None:
        """As `Planner.anchor`; a user's planner keeps its points."""
        self._shipped.anchor(sysids, p_ned)

    def surround(self, scenario: Scenario) -> None:
        """As `TickPlanner.surround`; the user's planner sees the obstacles in its next situation."""
        self._shipped.surround(scenario)
        self._scenario, self.obstacles = scenario, self._shipped.obstacles

    def plan(self, request: PlanRequest) -> Sequence[SetPoint]:
        """As `Planner.plan`, which also leads the pursuers that have a station, while the user's planner plans."""
        snapshot, steered = request.snapshot, request.steered
        own_pursuers = self._pursuers - request.stations.keys()
        follows = self._follows if request.pursuing is None else request.pursuing
        led = steered & own_pursuers
        there = [view for view in snapshot.of_role("pursuer") if view.sysid in led and view.p_ned is not None]
        own = [view for view in there if view.sysid not in request.given]
        if own:
            situation = Situation(snapshot.time_s, request.period_s, snapshot, follows, self._scenario.obstacles)
            self._plugins.ask(PLANNER, ([view.sysid for view in own], situation))
        points = list(self._shipped.plan(request._replace(steered=steered - own_pursuers)))
        points += [SetPoint(view.sysid, *request.given[view.sysid]) for view in there if view.sysid in request.given]
        self._held = {view.sysid: self._held.get(view.sysid, view.p_now_ned()) for view in own}
        rows = self._plugins.answers(PLANNER) if own else ()
        planned: dict[int, tuple[Vec3, Vec3]] = {row[0]: (row[1:4], row[4:7]) for row in rows}
        for view in own:
            p_ned, v_ned = planned.get(view.sysid, (self._held[view.sysid], ZERO))
            self._held[view.sysid] = p_ned
            points.append(SetPoint(view.sysid, p_ned, v_ned))
        return SetPoints.of(sorted(points, key=lambda point: point.sysid))


def make_planner(scenario: Scenario, own: PluginClient | None) -> TickPlanner:
    """The shipped planner, or the user's `own`, behind the safety filter unless the scenario leaves that out.

    Raises ScenarioError.
    """
    return behind_filter(scenario, Planner(scenario) if own is None else OwnPlanner(scenario, own))


def behind_filter(scenario: Scenario, planner: TickPlanner) -> TickPlanner:
    """The planner behind the safety filter, unless the scenario leaves that out."""
    return SafePlanner(scenario, planner) if scenario.planner.safety else planner
