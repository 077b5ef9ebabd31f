"""Compiled functions kept on disk, and called from there without the compiler.

numba's package takes a quarter of a second to be imported, and some milliseconds for each kernel that it reads, where
the machine code itself is there in a moment. So a kernel is called through numba's C extensions alone (extensions.py)
as long as its code is kept (kept_code.py, machine_code.py) for arguments of these types (argument_types.py), and
becomes numba's own dispatcher, with all others, once one is not (dispatchers.py, compiling.py).
"""

from __future__ import annotations

from typing import Any

from gcs.kernels.dispatchers import external, inner, kernel, overload

__all__ = ["INLINED", "UNCOUNTED", "external", "inner", "kernel", "overload"]

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
