"""Decorators of compiled functions, and the callable that they make while numba is not needed."""

from __future__ import annotations

import functools
import inspect
import sys
import threading
from collections.abc import Callable
from types import FunctionType
from typing import Any, TypeVar

from simvehicle.kernels import argument_types, kept_code, machine_code
from simvehicle.kernels import extensions as numbas
from simvehicle.kernels.kept_code import Signature

_Function = TypeVar("_Function", bound=Callable[..., Any])

_EXTENSIONS: Any = numbas.load()
"""None where numba is needed from the beginning."""
_BASE: Any = object
if _EXTENSIONS is not None:
    _BASE = _EXTENSIONS.dispatcher.Dispatcher
    _TYPES = argument_types.of_process(_EXTENSIONS.dispatcher)
    _MANAGER = _EXTENSIONS.typeconv.new_type_manager()
    """Of conversions, which nobody asks for."""

_waiting: list[Callable[[], object]] = []
"""All that is done once numba is needed, in order; nothing waits after that."""
_begun = _EXTENSIONS is None
"""Whether numba has been needed."""
if _begun:
    numbas.import_numba()
_at_once = threading.RLock()


class Prepared(_BASE):  # type: ignore[misc]
    """A compiled function that is called by its kept code, and becomes numba's dispatcher once that does not do.

    Its base compares types of arguments with those that code was added for, and calls that, or asks `typeof_pyval` and
    `_compile_for_args`, as of any dispatcher of numba's. Whatever else is asked of it needs numba.
    """

    def __init__(self, function: FunctionType, options: dict[str, Any], stamp: bytes | None) -> None:
        """stamp: `kept_code.stamp_of` the function; None keeps nothing."""
        code = function.__code__
        count = code.co_argcount
        pointer = _EXTENSIONS.typeconv.get_pointer(_MANAGER)
        defaults = tuple(_TYPES.omitted(value) for value in function.__defaults__ or ())
        super().__init__(pointer, count, True, code.co_varnames[:count], defaults, False, False, True)
        functools.update_wrapper(self, function)
        self.py_func = function
        self.__code__ = code  # read by profilers
        self._options, self._stamp = options, stamp
        self._kept: dict[Signature, machine_code.Image] | None = None
        self._called: dict[Signature, Any] = {}

    @property
    def signatures(self) -> list[Signature]:
        """Types of arguments that it was called with."""
        return list(self._called)

    def typeof_pyval(self, value: Any) -> Any:
        """Type of an argument that is not a plain number, for the base, which remembers it."""
        if "numba" not in sys.modules:
            return _TYPES[_TYPES.key_of(value)]
        begin()  # numba compares types by numbers of its own
        return self.typeof_pyval(value)

    def _compile_for_args(self, *args: Any) -> Any:
        """Code for arguments that the base has none for."""
        with _at_once:
            if "numba" not in sys.modules and self._stamp is not None:
                loaded = self._load(tuple(_TYPES.key_of(value) for value in args), self._stamp)
                if loaded is not None:
                    return loaded
        begin()
        return self._compile_for_args(*args)

    def _load(self, signature: Signature, stamp: bytes) -> Any:
        """Kept code for arguments of these types, ready to be called from now on; None where there is none."""
        try:
            if self._kept is None:
                self._kept = kept_code.read(self.py_func, stamp, _EXTENSIONS.version)
            image = self._kept.get(signature)
            loaded = None if image is None else machine_code.load(image, self.py_func, _EXTENSIONS)
        except (OSError, AttributeError, KeyError, ValueError, TypeError, EOFError):
            return None  # numba has code of its own, or makes it
        if loaded is not None and signature not in self._called:
            self._insert([_TYPES[key]._code for key in signature], loaded)
            self._called[signature] = loaded
        return loaded

    def become(self) -> None:
        """Become numba's dispatcher of the function."""
        from simvehicle.kernels import compiling  # noqa: PLC0415 - it loads numba

        compiling.turn(self, self.py_func, self._options, self._stamp, _at_once)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        begin()
        return getattr(self, name)

    def __reduce__(self) -> Any:
        begin()
        return self.__reduce__()


def begin() -> None:
    """Load numba, which takes over from now on."""
    global _begun  # noqa: PLW0603 - it happens once
    with _at_once:
        numbas.import_numba()
        _begun = True
        while _waiting:
            _waiting.pop(0)()


def kernel(**options: Any) -> Callable[[_Function], _Function]:
    """A decorator: numba's `njit(cache=True)` with these options."""
    return lambda function: _decorated(function, options, kept_code.stamp_of(function))


def inner(**options: Any) -> Callable[[_Function], _Function]:
    """A decorator: numba's `njit` with these options, of a function that becomes part of kernels."""
    return lambda function: _decorated(function, options, None)


def _decorated(function: Any, options: dict[str, Any], stamp: bytes | None) -> Any:
    if _begun or not _is_plain(function):
        from simvehicle.kernels import compiling  # noqa: PLC0415 - it loads numba

        return compiling.compiled(function, options, stamp)
    prepared = Prepared(function, options, stamp)
    _waiting.append(prepared.become)
    return prepared


def _is_plain(function: FunctionType) -> bool:
    """Whether it takes a fixed number of arguments, by their place or their name."""
    code = function.__code__
    return not code.co_kwonlyargcount and not code.co_flags & (inspect.CO_VARARGS | inspect.CO_VARKEYWORDS)


def overload(function: Callable[..., Any], **options: Any) -> Callable[[_Function], _Function]:
    """A decorator: numba's, of what chooses compiled code for `function` by the types of its arguments."""

    def decorate(choose: _Function) -> _Function:
        def register() -> None:
            from numba.extending import overload as numbas_overload  # noqa: PLC0415

            numbas_overload(function, **options)(choose)

        if _begun:
            register()
        else:
            _waiting.append(register)
        return choose

    return decorate


class External:
    """A function of the system's, for compiled code alone."""

    def __init__(self, name: str, result: str, arguments: tuple[str, ...]) -> None:
        self._name, self._result, self._arguments = name, result, arguments

    @property
    def _numba_type_(self) -> Any:
        from numba import types  # noqa: PLC0415

        signature = getattr(types, self._result)(*(getattr(types, name) for name in self._arguments))
        return types.ExternalFunction(self._name, signature)


def external(name: str, result: str, *arguments: str) -> Any:
    """A function of the system's by its name and numba's names of its types."""
    return External(name, result, arguments)
