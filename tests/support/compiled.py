"""Functions that only compiled modules call (`cdef` in their .pxd), called from a test."""

import ctypes
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

_name = ctypes.pythonapi.PyCapsule_GetName
_name.restype, _name.argtypes = ctypes.c_char_p, [ctypes.py_object]
_pointer = ctypes.pythonapi.PyCapsule_GetPointer
_pointer.restype, _pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]


def function(module: ModuleType, name: str, returns: int, *arguments: str) -> Callable[..., Any]:
    """A module's function of so many float64: its arguments are each "number", or "row" for a pointer to a struct of
    float64, given as an array; it returns a number or a tuple of `returns` numbers."""
    capsule = module.__pyx_capi__[name]
    numbers = type("numbers", (ctypes.Structure,), {"_fields_": [("of", ctypes.c_double * returns)]})
    kinds = {"number": ctypes.c_double, "row": ctypes.c_void_p}
    prototype = ctypes.CFUNCTYPE(ctypes.c_double if returns == 1 else numbers, *(kinds[one] for one in arguments))
    call = prototype(_pointer(capsule, _name(capsule)))

    def called(*given: Any) -> Any:
        made = call(*(one.ctypes.data if isinstance(one, np.ndarray) else one for one in given))
        return made if returns == 1 else tuple(made.of)

    return called
