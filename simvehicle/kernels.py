"""Compiled functions kept on disk, and read from there without the compiler.

numba prepares its whole compiler before it reads one kept function: it loads scipy.linalg and 60 modules of its own,
and registers what they can compile, for a quarter of a second. Machine code needs none of that, so a kernel prepares
the compiler only where nothing is kept.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from numba import njit
from numba.core.caching import FunctionCache
from numba.core.runtime.nrt import rtsys

_Function = TypeVar("_Function", bound=Callable[..., Any])


class KernelCache(FunctionCache):
    """numba's own cache of a function, with its files, keys and checks."""

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """What is kept for a signature, ready to be called; None where nothing is, with the compiler prepared."""
        rtsys.initialize(target_context)  # kept code counts references to arrays
        found = self._load_overload(sig, target_context)
        if found is None:
            target_context.refresh()
        return found


def kernel(**options: Any) -> Callable[[_Function], _Function]:
    """A decorator: numba's `njit(cache=True)` with these options."""

    def decorate(function: _Function) -> _Function:
        compiled: Any = njit(**options)(function)
        compiled._cache = KernelCache(function)
        return compiled  # type: ignore[no-any-return]

    return decorate
