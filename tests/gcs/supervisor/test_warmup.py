"""A rehearsal leaves nothing to be loaded in the first tick."""

import json
import subprocess
import sys

import pytest
from extremes import extremes, number_keys

from gcs.scenario.file import load, shipped_folder
from gcs.scenario.model import ScenarioError
from gcs.supervisor.warmup import rehearse

CODE = """
import json, sys
from gcs.scenario import geometry
from gcs.recording import digest, set_point_lines, tlog_frames
from gcs.session import process
from gcs.link import bundles, inbox, intake
from gcs.mavlink import gaps
from gcs.telemetry import approach, metrics, readings
from gcs.scenario.file import find
from gcs.planner import leader
from gcs.supervisor.warmup import rehearse
from gcs.scenario import load

scenario = load(find("paper/example1"))
kernels = [leader._lead, leader.aim, geometry.fill_clearances,
           metrics._measure, approach.look, approach.pass_points, bundles._bundle,
           digest._count, tlog_frames._stamp, set_point_lines._lay_out,
           inbox._receive, inbox._cut, intake._begin, gaps._go_on, readings.read]
before = [len(kernel.signatures) for kernel in kernels]
rehearse(scenario)
loaded = set(sys.modules)
after = [len(kernel.signatures) for kernel in kernels]
rehearse(scenario)
again = [len(kernel.signatures) for kernel in kernels]
later = sorted(set(sys.modules) - loaded)
compiled = [kernel.__name__ for kernel in kernels if kernel.stats.cache_misses]
print(json.dumps([before, after, again, later, compiled]))
"""


def test_a_rehearsal_loads_every_kernel_of_a_tick_for_good() -> None:
    for _ in range(2):  # the first time they may have to be compiled
        done = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=True)
    before, after, again, imported_later, compiled = json.loads(done.stdout)
    assert before == [0] * 15
    assert after == again == [1] * 15
    assert imported_later == []
    assert compiled == []


ROUTES = """
import numpy as np
from gcs.planner import guide, line_of_sight, route_grid, route_shortening
from gcs.planner.guide import RouteFollower
from gcs.planner.route import Router
from gcs.scenario import geometry
from gcs.supervisor.warmup import find_way

def signatures():
    modules = (guide, line_of_sight, route_grid, route_shortening, geometry)
    kernels = {(m.__name__, n): k for m in modules for n, k in vars(m).items() if hasattr(k, "signatures")}
    return {name: len(kernel.signatures) for name, kernel in kernels.items()}

find_way()
before = signatures()
rng = np.random.default_rng(1)
for _ in range(20):
    rows = [geometry.box(p - [0.5, 3.0, 3.0], p + [0.5, 3.0, 3.0]) for p in rng.uniform(-8.0, 8.0, (4, 3))]
    follower = RouteFollower(Router(geometry.table(rows), 0.6, floor_m=None))
    for _ in range(5):
        follower.aims([1, 2], rng.uniform(-12.0, 12.0, (2, 3)), rng.uniform(-12.0, 12.0, (2, 3)))
after = signatures()
print({name: (before[name], count) for name, count in after.items() if count != before[name]})
"""


def test_a_rehearsed_way_loads_every_kernel_of_the_guide() -> None:
    done = subprocess.run([sys.executable, "-c", ROUTES], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "{}"


@pytest.mark.parametrize("key", number_keys("planner"))
def test_whatever_a_scenario_may_say_of_the_planner_is_flown(key: str) -> None:
    """Each number at its least and its greatest: refused in a sentence, or planned with."""
    flown = 0
    for value in (*extremes(key), 1.0 if key != "planner.b" else 0.5):
        try:
            scenario = load(shipped_folder() / "demo.yaml", set={key: value})
        except ScenarioError:
            continue
        rehearse(scenario)
        flown += 1
    assert flown
