"""Figure 14: real autopilots in lockstep, where one is named: SKYTENDER_ARDUCOPTER=/path/to/bin/arducopter,
SKYTENDER_PX4=/path/to/build/px4_sitl_default.

python tests/benchmarks --only 14
"""

from __future__ import annotations

import json
import os
import statistics
import sys
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

import yaml
from measure import ROOT, Figure, Scale, children_cpu_s
from prompt_to_prompt import took

ROUNDS = 3
DURATION_S = 90.0


class Kind(NamedTuple):
    """One kind of autopilot, how many of it fly, and how fast they should."""

    name: str
    key: str
    variable: str
    vehicles: int
    goal: float
    repeats: bool


KINDS = (
    Kind("ArduCopters", "ardupilot", "SKYTENDER_ARDUCOPTER", 5, 8.0, repeats=True),
    Kind("PX4s", "px4", "SKYTENDER_PX4", 3, 3.0, repeats=False),
)


def fleet(kind: Kind) -> dict[str, Any]:
    """The demo with a real autopilot for each of its pursuers, over open ground."""
    content: dict[str, Any] = yaml.safe_load((ROOT / "configs/demo.yaml").read_text(encoding="utf-8"))
    for key in ("obstacles", "traffic"):
        del content[key]
    content["goal"] = {"duration_s": DURATION_S, "refuelled_at_least": 2}
    content["planner"]["separation_m"] = 1.5
    content["vehicles"]["defaults"]["battery"]["capacity_j"] = 48_000.0  # so that everyone flies to the end
    content["formation"]["ring_m"] = 4.0
    pursuers = content["vehicles"]["pursuers"] = content["vehicles"]["pursuers"][: kind.vehicles]
    assert len(pursuers) == kind.vehicles
    for pursuer in pursuers:
        pursuer["autopilot"] = {kind.key: os.environ[kind.variable]}
        north, east, _ = pursuer["start_m"]
        pursuer["start_m"] = [2.0 * north, 2.0 * (east + 3.0) - 3.0, 0.0]
    return content


def figures(scale: Scale) -> list[Figure]:
    """Nothing of a kind of which no program is named. Raises RuntimeError where a session that repeats does not."""
    return [figure for kind in KINDS if os.environ.get(kind.variable) for figure in _of(kind, scale)]


def _of(kind: Kind, scale: Scale) -> list[Figure]:
    with tempfile.TemporaryDirectory() as folder:
        rounds = [_fly(kind, Path(folder), number) for number in range(ROUNDS)]
    if kind.repeats and len({digest for *_, digest in rounds}) != 1:
        raise RuntimeError(f"the same session of {kind.name} had more than one digest")
    speed, began_s, cpu_s = (statistics.median(column) for column in list(zip(*rounds, strict=True))[:3])
    name = f"{kind.vehicles} {kind.name} in lockstep for {DURATION_S:.0f} s"
    return [
        Figure(14, name, speed, "x real time", kind.goal * scale.wall, cpu_s=cpu_s),
        Figure(14, "  from prompt to the first tick, and away", began_s, "s", 5.0 / scale.wall, True),
    ]


def _fly(kind: Kind, folder: Path, number: int) -> tuple[float, float, float, str | None]:
    """Times real time, wall time of all but the flight, CPU seconds of all processes, and the digest."""
    path, out = folder / "scenario.yaml", folder / str(number)
    path.write_text(yaml.safe_dump(fleet(kind)), encoding="utf-8")
    command = [sys.executable, "-m", "gcs", "run", str(path), "--lockstep", "--trust", "--quiet", "--no-report"]
    before_s = children_cpu_s()
    took_s = took([*command, "--out", str(out)])
    cpu_s = children_cpu_s() - before_s
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    return summary["speed_achieved"], took_s - summary["wall_time_s"], cpu_s, summary["digest"]
