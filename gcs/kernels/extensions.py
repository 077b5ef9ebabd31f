"""numba's C extensions, loaded without the package numba."""

from __future__ import annotations

import os
import re
import sys
import warnings
from importlib import import_module, machinery, util
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple, cast

OLDEST, NEWEST = (0, 61), (0, 68)
"""Versions of numba whose extensions are known; with any other one all is left to numba."""
NAMES = (
    "_devicearray",
    "_dispatcher",
    "_dynfunc",
    "_helperlib",
    "core.typeconv._typeconv",
    "core.runtime._nrt_python",
)
CACHE_FOLDER = "NUMBA_CACHE_DIR"
HARMLESS = {CACHE_FOLDER, "NUMBA_NUM_THREADS"}
"""Settings of numba's that change nothing of the code."""


class Extensions(NamedTuple):
    """All that a kernel is called through."""

    version: str
    dispatcher: Any
    dynfunc: Any
    helpers: Any
    typeconv: Any
    runtime: Any


def usual() -> bool:
    """Whether numba compiles for this machine as it does by itself, without a setting of the user's."""
    return not any(name.startswith("NUMBA_") and name not in HARMLESS for name in os.environ)


def import_numba() -> ModuleType:
    """numba, without the settings of a file in the working folder, which may name a folder of code.

    numba reads `.numba_config.yaml` while it is imported, if there is a package that reads YAML, and whenever it
    compiles. Whoever made the working folder is not trusted.
    """
    if "numba" not in sys.modules:
        loaded = sys.modules.pop("yaml", None)
        cast(Any, sys.modules)["yaml"] = None  # as if there were none
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # that the file is not read
                import_module("numba")
        finally:
            del sys.modules["yaml"]
            if loaded is not None:
                sys.modules["yaml"] = loaded
    cast(Any, import_module("numba.core.config"))._config_fname = os.devnull
    return sys.modules["numba"]


def load() -> Extensions | None:
    """The extensions; None where numba is loaded already, or is to be: no known one, or with settings."""
    if "numba" in sys.modules or not usual():
        return None
    spec = util.find_spec("numba")
    if spec is None or not spec.submodule_search_locations:
        return None
    folder = Path(spec.submodule_search_locations[0])
    version = _version(folder)
    if not OLDEST <= tuple(int(number) for number in version.split(".")[:2]) <= NEWEST:
        return None
    before = set(sys.modules)
    package = ModuleType("numba")  # `_dispatcher` asks it for `_devicearray`
    sys.modules["numba"] = package
    try:
        loaded = []
        for name in NAMES:
            module = _extension(folder, name)
            loaded.append(module)
            if "." not in name:
                setattr(package, name, module)
        _, dispatcher, dynfunc, helpers, typeconv, runtime = loaded
        runtime.memsys_use_cpython_allocator()  # as numba does
    except (ImportError, AttributeError, SystemError):  # numba says why
        for name in sys.modules.keys() - before:
            del sys.modules[name]
        return None
    finally:
        sys.modules.pop("numba", None)
    return Extensions(version, dispatcher, dynfunc, helpers, typeconv, runtime)


def _version(folder: Path) -> str:
    """numba's version; 0.0 where it is not found."""
    try:
        text = (folder / "_version.py").read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return "0.0"
    found = re.search(r'"version": "(\d+\.\d+[^"]*)"', text)
    return found[1] if found else "0.0"


def _extension(folder: Path, name: str) -> ModuleType:
    """One of the extensions, which numba finds loaded once it is imported."""
    full_name = f"numba.{name}"
    if full_name in sys.modules:  # by another program's `load`
        return sys.modules[full_name]
    path = str(folder / f"{name.replace('.', '/')}{machinery.EXTENSION_SUFFIXES[0]}")
    loader = machinery.ExtensionFileLoader(full_name, path)
    module = util.module_from_spec(machinery.ModuleSpec(full_name, loader, origin=path))
    sys.modules[full_name] = module
    loader.exec_module(module)
    return module
