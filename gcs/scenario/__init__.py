"""A session's world as typed, frozen objects: read from YAML, checked, drawn, written.

`Scenario`, `ScenarioError`, `load` and `dump` load when they are first asked for.
"""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False

if TYPE_CHECKING:
    from typing import Any

    from gcs.scenario.document import ScenarioError
    from gcs.scenario.file import dump, load
    from gcs.scenario.model import Scenario

__all__ = ["Scenario", "ScenarioError", "dump", "load"]

_HOME = {"Scenario": "model", "ScenarioError": "document", "dump": "file", "load": "file"}
_PARTS = (
    *("Attractor", "Base", "Battery", "Blackout", "Clock", "Goal", "Mover", "Obstacle", "Origin", "Problem", "Pursue"),
    *("Pursuer", "Radio", "Tanker", "Target", "VehicleBase", "Vehicles"),
)
"""Classes of `gcs.scenario.model` that may be asked for here."""


def __getattr__(name: str) -> Any:
    home = _HOME.get(name) or ("model" if name in _PARTS else None)
    if home is None:
        raise AttributeError(f"module 'gcs.scenario' has no attribute {name!r}")
    return getattr(import_module(f"gcs.scenario.{home}"), name)
