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


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'gcs.scenario' has no attribute {name!r}")
    return getattr(import_module(f"gcs.scenario.{_HOME[name]}"), name)
