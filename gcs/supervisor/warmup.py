"""One made-up tick of a session before its first: what a tick runs is then loaded, compiled and warm.

Loading the planner's and the metrics' kernels takes about 0.2 s, which in flight would be two periods' delay.
"""

from __future__ import annotations

import functools
import socket

import numpy as np

from gcs.frame_spans import FrameSpans
from gcs.link.bundles import Roster
from gcs.link.intake import Intake, numbered
from gcs.link.link import TickGrants
from gcs.mavlink import codec
from gcs.mavlink.gaps import GapCounter
from gcs.mavlink.ids import AUTOPILOT, OUR_HEARTBEAT
from gcs.mavlink.sequence import FIRST_ANSWER, TickCollector
from gcs.mavlink.setpoints import SetPoint, SetPointPlacer
from gcs.planner.custom import behind_filter
from gcs.planner.guide import RouteFollower
from gcs.planner.planner import Planner
from gcs.planner.request import PlanRequest
from gcs.planner.route import Router
from gcs.planner.tracking import Tracking
from gcs.recording.decision_lines import TickSetPoints, decision_lines
from gcs.recording.digest import Digest
from gcs.recording.tlog_frames import stamped
from gcs.scenario import geometry
from gcs.scenario.model import Scenario
from gcs.supervisor.factory import make_arming_sequences, make_fleet
from gcs.supervisor.fleet_arming import FleetArming
from gcs.supervisor.goal_watch import GoalWatch
from gcs.telemetry import approach
from gcs.telemetry.fleet import Fleet
from gcs.telemetry.metrics import PLAN_MEMORY, Metrics
from gcs.telemetry.state import ZERO, FleetSnapshot

WAY_TICKS = 12


def rehearse(scenario: Scenario) -> None:
    """Plan for, and measure, a fleet in the air at its starts; everything that does so is thrown away afterwards."""
    fence = scenario.fence
    if scenario.planner.guide and scenario.planner.safety and (scenario.obstacles or fence.inside or fence.outside):
        find_way()
    place = {vehicle.sysid: vehicle.start_m for vehicle in scenario.vehicles.all}
    fleet = make_fleet(scenario)
    _rehearse_answer(fleet, min(place))
    views = (
        view._replace(
            armed=True, landed=False, p_ned=place[view.sysid], age_s=0.0, origin_offset_ned=ZERO, ground_down_m=0.0
        )
        for view in fleet.snapshot(0.0).vehicles
    )
    snapshot = FleetSnapshot(0.0, tuple(views), ())
    planner = behind_filter(scenario, Planner(scenario))
    metrics = Metrics(scenario)
    watch = GoalWatch(scenario, planner.obstacles, FleetArming(make_arming_sequences(scenario)))
    set_points = planner.plan(PlanRequest(snapshot, frozenset(place), scenario.clock.period_s))
    if scenario.planner.safety:
        _rehearse_tracking()
    _rehearse_bundles()
    approach.nearest_to(*(np.zeros((1, 3)) for _ in range(4)))  # once traffic is reported
    watch.update(snapshot, ())
    for _ in range(PLAN_MEMORY):  # only then is a vehicle's way held against its plan
        metrics.update(snapshot, set_points)


def _rehearse_answer(fleet: Fleet, sysid: int) -> None:
    """A vehicle's answer as in most ticks, taken in, counted and read."""
    key = (sysid, AUTOPILOT)
    end = codec.message("SYSTEM_TIME", time_unix_usec=0, time_boot_ms=0)
    answer = codec.frame(OUR_HEARTBEAT, FIRST_ANSWER, *key) + codec.frame(end, FIRST_ANSWER + 1, *key)
    collector, intake, gaps = TickCollector(*key), Intake(1, len(answer), 0), GapCounter()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as loop:
        loop.bind(("127.0.0.1", 0))
        number = numbered(0, shared=False)
        intake.enrol([(key, collector, number)])
        intake.inbox.know(loop.getsockname(), number)
        intake.begin([key], 0)
        loop.sendto(answer, loop.getsockname())
        intake.receive(loop.fileno(), 1, 1)
    for _, runs in intake.answers():
        gaps.feed_runs(runs)
        fleet.ingest_runs(runs, 0.0)


def _rehearse_bundles() -> None:
    """A bundle as in most ticks, made and counted."""
    points = SetPointPlacer().place([SetPoint(1, ZERO, ZERO)], [ZERO], [0.0], 0)
    key = (1, AUTOPILOT)
    bundles = Roster([key], [b""], [("127.0.0.1", 0)]).bundled((), TickGrants(0, 0, [key], set(), points, {}))
    sent = FrameSpans(bundles.raw, bundles.spans)
    stamped(0, sent, sent)
    Digest().tick(0, sent, sent, decision_lines([TickSetPoints(0.0, [SetPoint(1, ZERO, ZERO)])]))


def _rehearse_tracking() -> None:
    """A vehicle behind its leader."""
    tracking, rows = Tracking(1, 0.3), np.zeros(1, np.int64)
    for k in range(3):
        tracking.lead(rows, 0.1 * k, np.array([[0.1 * k, 0.0, 0.0]]))
    tracking.measure(rows, np.zeros((1, 3)), 0.3, 0.1, 0.3)


@functools.cache
def find_way() -> None:
    """Search, shorten and follow a route around a wall: the first search of a session must not wait for its compiler.

    It took up to 20 s, after which vehicles that wait for a grant have left.
    """
    wall = geometry.table([geometry.box([2.0, -2.0, -3.0], [2.4, 2.0, 0.0]), geometry.sphere([4.0, 4.0, -2.0], 0.3)])
    follower = RouteFollower(Router(wall, 0.6, floor_m=0.3))
    start = np.array([[0.0, 0.0, -1.0]])
    for goal in ([5.0, 0.0, -1.0], [5.0, 0.5, -1.0], [2.2, 0.0, -1.0]):
        for tick in range(WAY_TICKS):  # a goal that moves away is searched for from on the route
            aims = follower.aims([1], start, np.array([[goal[0] + 0.2 * tick, goal[1], goal[2]]]))
            start = start + 0.3 * (aims.aim_ned - start)
