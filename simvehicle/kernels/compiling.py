"""numba's part of a kernel: where nothing is kept for its arguments, or numba is loaded anyway.

numba prepares its whole compiler before it reads one kept function: it loads scipy.linalg and 60 modules of its own,
and registers what they can compile, for a quarter of a second. Machine code needs none of that, so a kernel prepares
the compiler only where numba has kept nothing either.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FunctionType
from typing import Any

import numba
from numba import njit, typeof, types
from numba.core.caching import FunctionCache, IndexDataCacheFile
from numba.core.environment import _rebuild_env
from numba.core.registry import CPUDispatcher
from numba.core.runtime.nrt import rtsys
from numba.np import numpy_support

from simvehicle.kernels import argument_types, extensions, kept_code, machine_code
from simvehicle.kernels.argument_types import Key


def compiled(function: Any, options: dict[str, Any], stamp: bytes | None) -> Any:
    """A dispatcher of numba's, kept on disk where there is a stamp (`kept_code.stamp_of`)."""
    made: Any = njit(**options)(function)
    _keep(made, function, stamp)
    return made


def _keep(made: Any, function: Callable[..., Any], stamp: bytes | None) -> None:
    """Have a dispatcher keep its code, where there is a folder for it."""
    if stamp is not None:
        with contextlib.suppress(RuntimeError):  # numba's, of no folder that can be written to
            made._cache = KernelCache(function, stamp)


def turn(prepared: Any, function: FunctionType, options: dict[str, Any], stamp: bytes | None, taken: Any) -> None:
    """Make a `Prepared` numba's dispatcher of its function; `taken` is the lock that is held meanwhile."""
    made = njit(**options)(function)
    _Turning.taken = taken
    prepared.__class__ = _Turning
    prepared._clear()
    vars(prepared).clear()
    CPUDispatcher.__init__(prepared, function, made.locals, made.targetoptions)
    _keep(prepared, function, stamp)
    prepared.__class__ = CPUDispatcher


class _Turning(CPUDispatcher):
    """A dispatcher in the making: another thread that calls it waits."""

    taken: Any

    def typeof_pyval(self, value: Any) -> Any:
        with self.taken:
            return super().typeof_pyval(value)

    def _compile_for_args(self, *args: Any, **kwargs: Any) -> Any:
        with self.taken:
            return super()._compile_for_args(*args, **kwargs)  # type: ignore[misc]


class KernelCache(FunctionCache):
    """numba's own cache of a function, with its files and keys."""

    def __init__(self, function: Callable[..., Any], stamp: bytes) -> None:
        super().__init__(function)  # type: ignore[no-untyped-call]
        self._cache_file.__class__ = _KernelFile  # made by the base class
        vars(self._cache_file).update(function=function, stamp=stamp, _source_stamp=stamp)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Kept code of a signature, ready to be called; None where nothing is kept, with the compiler prepared."""
        rtsys.initialize(target_context)  # kept code counts references to arrays
        found = self._load_overload(sig, target_context)
        if found is None:
            target_context.refresh()
        return found


class _KernelFile(IndexDataCacheFile):
    """numba's file of a function; what passes through it is also kept for when numba is not loaded."""

    function: FunctionType
    stamp: bytes

    def load(self, key: Any) -> Any:
        data = super().load(key)  # type: ignore[no-untyped-call]
        if data is not None:
            self._keep(key[0], data, anew=False)
        return data

    def save(self, key: Any, data: Any) -> None:
        """Keep what was compiled, unless the source has changed since it was read, or nothing can be written."""
        if kept_code.is_current(self.function, self.stamp):
            with contextlib.suppress(OSError):  # a full disk; doctor says it
                super().save(key, data)  # type: ignore[no-untyped-call]
            self._keep(key[0], data, anew=True)

    def _load_index(self) -> Any:
        try:
            with kept_code.opened(self._index_path) as file:
                if pickle.load(file) != self._version:
                    return {}
                stamp, overloads = pickle.load(file)
        except (OSError, EOFError, pickle.UnpicklingError):
            return {}
        return overloads if stamp == self._source_stamp else {}

    def _load_data(self, name: str) -> Any:
        with kept_code.opened(self._data_path(name)) as file:
            return _Unpickler(file).load()

    @contextlib.contextmanager
    def _open_for_write(self, filepath: str) -> Iterator[Any]:
        with super()._open_for_write(filepath) as file:
            os.fchmod(file.fileno(), kept_code.OWN_MODE)
            yield file

    def _keep(self, arguments: Any, data: Any, *, anew: bool) -> None:
        """Keep machine code of these types of arguments, if it is of a kind that can be; `anew` also where it is."""
        (_, kind, (elf, *_)), described, environment, _, objectmode, lifted, _, reload, others = data
        if kind != "object" or objectmode or lifted or reload or not extensions.usual():
            return
        file = kept_code.File(Path(self._cache_path), self.function, self.stamp, numba.__version__)
        environments = {each.env_name: each.consts for each in (environment, *others)}
        with contextlib.suppress(machine_code.Unfit, NotImplementedError):
            signature = tuple(_key_of(argument) for argument in arguments)
            if None not in signature and (anew or signature not in file.read()):
                file.add(signature, machine_code.link(elf, described.llvm_cpython_wrapper_name, environments.items()))


def _key_of(argument: Any) -> Key | None:
    """Of a type of numba's, as argument_types.py has it of a value; None where kept code takes no such thing."""
    if isinstance(argument, types.Literal):
        return None
    if isinstance(argument, types.Number | types.Boolean | types.Record):
        return argument_types.key_of_dtype(numpy_support.as_dtype(argument))
    if type(argument) is types.Array and argument.aligned:
        dtype = argument_types.key_of_dtype(numpy_support.as_dtype(argument.dtype))
        return dtype and ("array", dtype, argument.ndim, argument.layout, argument.mutable)
    if isinstance(argument, types.BaseTuple):
        kind = getattr(argument, "instance_class", tuple)
        return argument_types.key_of_tuple(kind, [_key_of(item) for item in argument.types])  # type: ignore[attr-defined]
    if isinstance(argument, types.Omitted):
        return argument_types.key_of_omitted(argument.value)
    return argument_types.BYTES if argument == typeof(b"") else None


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
