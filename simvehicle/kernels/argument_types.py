"""Types of arguments, as far as kept code is told apart by them, and the numbers that numba's C dispatcher compares.

A type is a key: of a number its dtype, of an array and a tuple what they are of. Keys are made of text, whole numbers
and tuples alone, so that they are kept as they are; any other type has none.
"""

from __future__ import annotations

from typing import Any

import numpy as np

Key = str | tuple[Any, ...]

_FIRST_CODE = 1 << 24
"""Far from numba's own, which begin at 0: once numba is loaded, no code of ours is taken for one of its types."""
_SHARED = "_types_of_kept_code"
_NUMBERS = "biufc"
BYTES = "bytes"
_OF_PYTHON = {bool: "|b1", int: "<i8", float: "<f8", complex: "<c16", bytes: BYTES}


class ArgumentType:
    """A type's number, as the C dispatcher asks for it."""

    def __init__(self, code: int) -> None:
        self._code = code


class Omitted:
    """An argument that was left out, and what stands for it."""

    def __init__(self, value: Any) -> None:
        self.value = value


class ArgumentTypes:
    """The numbers of types in this process, by key; None stands for all that have none."""

    def __init__(self) -> None:
        self._types: dict[Key | None, ArgumentType] = {}

    def __getitem__(self, key: Key | None) -> ArgumentType:
        found = self._types.get(key)
        if found is None:
            found = self._types[key] = ArgumentType(_FIRST_CODE + len(self._types))
        return found

    def omitted(self, value: Any) -> Omitted:
        """As the C dispatcher takes an argument that was left out."""
        return Omitted(value)

    def key_of(self, value: Any) -> Key | None:
        """Of an argument; None where kept code takes no such thing."""
        kind = type(value)
        if kind in _OF_PYTHON:
            return _OF_PYTHON[kind]
        if kind is np.ndarray:
            dtype = key_of_dtype(value.dtype)
            flags = value.flags
            layout = "C" if flags.c_contiguous else "F" if flags.f_contiguous else "A"
            return dtype and ("array", dtype, value.ndim, layout, flags.writeable)
        if kind is tuple or (isinstance(value, tuple) and hasattr(value, "_fields")):
            return key_of_tuple(kind, [self.key_of(item) for item in value])
        if kind is Omitted:
            return key_of_omitted(value.value)
        return key_of_dtype(value.dtype) if isinstance(value, np.generic) else None


def of_process(dispatcher: Any) -> ArgumentTypes:
    """The one for all who use this extension, which compares their numbers."""
    if not hasattr(dispatcher, _SHARED):
        types = ArgumentTypes()
        sizes = {"int": (1, 2, 4, 8), "uint": (1, 2, 4, 8), "float": (4, 8), "complex": (8, 16)}
        names = [f"{kind}{8 * size}" for kind, some in sizes.items() for size in some]
        dispatcher.typeof_init(Omitted, {name: types[np.dtype(name).str]._code for name in names})
        setattr(dispatcher, _SHARED, types)
    shared: ArgumentTypes = getattr(dispatcher, _SHARED)
    return shared


def key_of_omitted(value: Any) -> Key:
    """Of an argument that was left out, for which this stands."""
    return ("omitted", repr(value))


def key_of_tuple(kind: type, items: list[Key | None]) -> Key | None:
    """Of a tuple, or a named one, of things with these keys."""
    return None if None in items else ("tuple", kind.__module__, kind.__qualname__, *items)


def key_of_dtype(dtype: np.dtype[Any]) -> Key | None:
    """Of an array's elements."""
    if dtype.subdtype is not None:
        base, shape = dtype.subdtype
        of_base = key_of_dtype(base)
        return None if of_base is None else ("sub", of_base, *shape)
    if dtype.fields is None:
        return dtype.str if dtype.kind in _NUMBERS and dtype.isnative else None
    fields = [(name, key_of_dtype(dtype.fields[name][0]), dtype.fields[name][1]) for name in dtype.names or ()]
    if any(key is None for _, key, _ in fields) or any(len(field) > 2 for field in dtype.fields.values()):
        return None
    return ("record", dtype.type.__name__, dtype.itemsize, dtype.isalignedstruct, *fields)
