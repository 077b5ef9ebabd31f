"""Old names of public modules and classes: each goes on to work, with a DeprecationWarning that names the new one.

`simvehicle/renamed.py` is the same for the vehicle.
"""

from __future__ import annotations

import sys
import warnings
from importlib import import_module
from importlib.machinery import ModuleSpec

TYPE_CHECKING = False  # every start of the program pays for what is imported here

if TYPE_CHECKING:
    from collections.abc import Callable
    from importlib.abc import Loader
    from types import ModuleType
    from typing import Any
else:
    Loader = object

MODULES = {
    "gcs.arrays": "gcs.session.arrays",
    "gcs.competition": "gcs.refuelling.winner_take_all",
    "gcs.junit": "gcs.report.junit",
    "gcs.planner.own": "gcs.planner.custom",
    "gcs.policies": "gcs.refuelling.policies",
    "gcs.summary": "gcs.recording.summary",
    "gcs.views": "gcs.telemetry.state",
}
"""New name of a module by its old one."""

CLASSES: dict[str, dict[str, str]] = {
    "gcs": {"FleetState": "FleetSnapshot"},
    "gcs.policies": {"Request": "RefuellingRequest"},
    "gcs.scenario": {
        "Competition": "CompetitionRules",
        "Formation": "FormationRules",
        "Planner": "PlannerRules",
        "Pursuit": "PursuitRules",
        "Refuelling": "RefuellingRules",
    },
    "gcs.summary": {
        "Base": "BaseSummary",
        "Energy": "EnergySummary",
        "Link": "LinkSummary",
        "Refuelling": "RefuellingSummary",
        "Vehicle": "VehicleSummary",
    },
    "gcs.views": {"Snapshot": "FleetSnapshot"},
}
"""New name of a class by its old one, by the module that had it."""


class RenamedWarning(DeprecationWarning):
    """A name that has moved is still in use."""


class _Finder:
    """Finds old modules; the last to be asked, so it costs nothing where a module exists."""

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        return ModuleSpec(name, _Loader()) if name in MODULES else None


class _Loader(Loader):
    """Makes a module that looks everything up in the one that has replaced it."""

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        return None

    def exec_module(self, module: ModuleType) -> None:
        old, new = module.__name__, MODULES[module.__name__]
        warnings.warn(f"{old} is now {new}", RenamedWarning, stacklevel=2)
        home = import_module(new)
        renamed = old_classes(old, lambda name: getattr(home, name), module.__dict__)
        module.__dict__["__getattr__"] = lambda name: renamed(name) or getattr(home, name)


def old_classes(module: str, find: Callable[[str], Any], known: dict[str, Any]) -> Callable[[str], Any]:
    """A function from the old name of a class of `module` to the class, which it warns of once; None for other names.

    `find` gets the class by its new name; `known` is the module's dictionary.
    """
    names = CLASSES.get(module, {})

    def renamed(name: str) -> Any:
        if name not in names:
            return None
        warnings.warn(f"{module}.{name} is now {names[name]}", RenamedWarning, stacklevel=3)
        return known.setdefault(name, find(names[name]))

    return renamed


def warn_of_field(owner: str, old: str, new: str) -> None:
    """Warn a caller's caller that reads a field by its old name."""
    warnings.warn(f"{owner}.{old} is now {owner}.{new}", RenamedWarning, stacklevel=3)


def install() -> None:
    """Let old modules be found."""
    if not any(isinstance(finder, _Finder) for finder in sys.meta_path):
        sys.meta_path.append(_Finder())
