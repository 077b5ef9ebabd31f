"""MAVLink ground-station supervisor: plans, competes, refuels, records.

From Python: `Session`, and what it takes and gives. They load when they are first asked for.
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False  # as from typing, which would take longer to load than all else here

if TYPE_CHECKING:
    from typing import Any

    from gcs.campaign.python import Campaign
    from gcs.recording.summary import Summary
    from gcs.scenario.file import load
    from gcs.scenario.model import Scenario, ScenarioError
    from gcs.session.arrays import MissingExtra, Snapshot
    from gcs.session.python import Session, SessionError

__all__ = [
    "Campaign",
    "MissingExtra",
    "Scenario",
    "ScenarioError",
    "Session",
    "SessionError",
    "Snapshot",
    "Summary",
    "load",
]

_HOME = {
    "Campaign": "campaign.python",
    "MissingExtra": "session.arrays",
    "Scenario": "scenario.model",
    "ScenarioError": "scenario.document",
    "Session": "session.python",
    "SessionError": "session.python",
    "Snapshot": "session.arrays",
    "Summary": "recording.summary",
    "load": "scenario.file",
}


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'gcs' has no attribute {name!r}")
    return getattr(import_module(f"gcs.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
