"""A rehearsal leaves nothing to be loaded in the first tick."""

import json
import subprocess
import sys

CODE = """
import json, sys
from gcs.scenario import geometry
from gcs.session import process
from gcs.telemetry import approach, metrics
from gcs.scenario.file import find
from gcs.planner import leader
from gcs.supervisor.warmup import rehearse
from gcs.scenario import load

scenario = load(find("paper/example1"))
kernels = [leader._advance_all, geometry._clearances, metrics.distance_to_path, approach.nearest_pair]
before = [len(kernel.signatures) for kernel in kernels]
rehearse(scenario)
loaded = set(sys.modules)
after = [len(kernel.signatures) for kernel in kernels]
rehearse(scenario)
again = [len(kernel.signatures) for kernel in kernels]
print(json.dumps([before, after, again, sorted(set(sys.modules) - loaded)]))
"""


def test_a_rehearsal_loads_every_kernel_of_a_tick_for_good() -> None:
    done = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=True)
    before, after, again, imported_later = json.loads(done.stdout)
    assert before == [0, 0, 0, 0]
    assert after == again == [1, 1, 1, 1]
    assert imported_later == []
