"""MAVLink ground-station supervisor: plans, competes, refuels, records.

From Python: `Session`, and what it takes and gives; what planners and refuelling policies of one's own get. They load
when they are first asked for.
"""

from __future__ import annotations

from importlib import import_module

from skytender.compiled import check

TYPE_CHECKING = False  # as from typing, which would take longer to load than all else here

if TYPE_CHECKING:
    from typing import Any

    from gcs.campaign.python import Campaign
    from gcs.extras import MissingExtra
    from gcs.learning import parallel_env
    from gcs.planner.request import PursuerPlanner, Situation
    from gcs.recording.summary import Summary
    from gcs.refuelling.policies import RefuellingPolicy, RefuellingRequest
    from gcs.report.opened import Recording, RecordingError, open
    from gcs.scenario.faults import Fault
    from gcs.scenario.file import load
    from gcs.scenario.model import Scenario, ScenarioError
    from gcs.scenario.parts.surroundings import Attractor, Obstacle
    from gcs.scenario.parts.trust import TrustError
    from gcs.session.arrays import Snapshot
    from gcs.session.program.turn import SessionError
    from gcs.session.python import Session
    from gcs.session.spawning.spawner import SessionSpawner
    from gcs.telemetry.state import FleetSnapshot, TrafficView, VehicleView

__all__ = [
    "Attractor",
    "Campaign",
    "Fault",
    "FleetSnapshot",
    "MissingExtra",
    "Obstacle",
    "PursuerPlanner",
    "Recording",
    "RecordingError",
    "RefuellingPolicy",
    "RefuellingRequest",
    "Scenario",
    "ScenarioError",
    "Session",
    "SessionError",
    "SessionSpawner",
    "Situation",
    "Snapshot",
    "Summary",
    "TrafficView",
    "TrustError",
    "VehicleView",
    "load",
    "open",
    "parallel_env",
]

check("skytender")
check("gcs")

_HOME = {
    "Attractor": "scenario.parts.surroundings",
    "Campaign": "campaign.python",
    "Fault": "scenario.faults",
    "FleetSnapshot": "telemetry.state",
    "MissingExtra": "extras",
    "Obstacle": "scenario.parts.surroundings",
    "PursuerPlanner": "planner.request",
    "Recording": "report.opened",
    "RecordingError": "report.opened",
    "RefuellingPolicy": "refuelling.policies",
    "RefuellingRequest": "refuelling.policies",
    "Scenario": "scenario.model",
    "ScenarioError": "scenario.document",
    "Session": "session.python",
    "SessionError": "session.program.turn",
    "SessionSpawner": "session.spawning.spawner",
    "Situation": "planner.request",
    "Snapshot": "session.arrays",
    "Summary": "recording.summary",
    "TrafficView": "telemetry.state",
    "TrustError": "scenario.parts.trust",
    "VehicleView": "telemetry.state",
    "load": "scenario.file",
    "open": "report.opened",
    "parallel_env": "learning",
}


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'gcs' has no attribute {name!r}")
    return getattr(import_module(f"gcs.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
