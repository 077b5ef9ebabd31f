"""Old names of public modules: each goes on to work, with a DeprecationWarning that names the new one.

`gcs/renamed.py` is the same for the ground station.
"""

from __future__ import annotations

import sys
import warnings
from importlib import import_module
from importlib.machinery import ModuleSpec

TYPE_CHECKING = False  # every start of the program pays for what is imported here

if TYPE_CHECKING:
    from importlib.abc import Loader
    from types import ModuleType
else:
    Loader = object

MODULES = {
    "simvehicle.differentiator": "simvehicle.law.differentiator",
    "simvehicle.dynamics": "simvehicle.law.dynamics",
}
"""New name of a module by its old one."""


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
        module.__dict__["__getattr__"] = lambda name: getattr(home, name)


def install() -> None:
    """Let old modules be found."""
    if not any(isinstance(finder, _Finder) for finder in sys.meta_path):
        sys.meta_path.append(_Finder())
