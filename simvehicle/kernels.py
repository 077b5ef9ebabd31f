"""Compiled functions kept on disk, and read from there without the compiler.

numba prepares its whole compiler before it reads one kept function: it loads scipy.linalg and 60 modules of its own,
and registers what they can compile, for a quarter of a second. Machine code needs none of that, so a kernel prepares
the compiler only where nothing is kept.
"""

from __future__ import annotations

import pickle
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from numba import njit
from numba.core.caching import FunctionCache, IndexDataCacheFile
from numba.core.environment import _rebuild_env
from numba.core.runtime.nrt import rtsys

_Function = TypeVar("_Function", bound=Callable[..., Any])

UNCOUNTED: dict[str, Any] = {"error_model": "numpy", "_nrt": False}
"""Options for a compiled function that makes no array, nor calls one that does.

numba counts references to an array at the beginning and the end of every compiled function that takes one, each time
by an atomic addition, which lets the processor begin nothing behind it. What only reads and writes arrays of its
caller's needs no counting. Views are no new arrays.
"""

INLINED: dict[str, Any] = {**UNCOUNTED, "inline": "always"}
"""The same for a function that becomes part of every function that calls it, before that is compiled.

LLVM keeps a long function apart, and what it takes and gives then passes through memory at every call. For what each
step calls, from few places: every call makes a copy of the code.
"""


class KernelCache(FunctionCache):
    """numba's own cache of a function, with its files, keys and checks."""

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)  # type: ignore[no-untyped-call]
        self._cache_file.__class__ = _KernelFile  # made by the base class

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Kept code of a signature, ready to be called; None where nothing is kept, with the compiler prepared."""
        rtsys.initialize(target_context)  # kept code counts references to arrays
        found = self._load_overload(sig, target_context)
        if found is None:
            target_context.refresh()
        return found


class _KernelFile(IndexDataCacheFile):
    def _load_data(self, name: str) -> Any:
        with Path(self._data_path(name)).open("rb") as file:
            return _Unpickler(file).load()


class _Unpickler(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        if (module, name) == (_rebuild_env.__module__, _rebuild_env.__name__):
            return _environment
        return super().find_class(module, name)


def _environment(module: str, constants: Any, name: str) -> Any:
    """An environment of compiled code; the compiler's own modules are not loaded for globals, which it never reads."""
    if module.startswith("numba.") and module not in sys.modules:
        module = "numba"
    return _rebuild_env(module, constants, name)


def kernel(**options: Any) -> Callable[[_Function], _Function]:
    """A decorator: numba's `njit(cache=True)` with these options."""

    def decorate(function: _Function) -> _Function:
        compiled: Any = njit(**options)(function)
        compiled._cache = KernelCache(function)
        return compiled  # type: ignore[no-any-return]

    return decorate
