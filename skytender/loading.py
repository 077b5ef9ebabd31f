"""Starting without looking for garbage: what is loaded stays, and to look through it again and again is a tenth of a
start. With room on the interpreter's stack, and without threads that nobody needs. And forking many processes from one
that has all loaded."""

from __future__ import annotations

import ctypes
import gc
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

_Result = TypeVar("_Result")

MADV_COLLAPSE = 25
HUGE_BYTES = 1 << 21
SLOTS = 33_000
"""Of 8 bytes, a little more than 256 KiB: the interpreter takes the next power of two, and leaves the rest free."""


def with_room(run: Callable[[], _Result]) -> _Result:
    """Call a function with a quarter of a MiB of the interpreter's stack in one piece.

    Python 3.11 keeps its frames in pieces of 16 KiB, and maps or unmaps one at each call and return across an end. A
    module's loop that stood there took 40 ms longer. Behind a large frame the rest of its piece is free.
    """
    return run()


with_room.__code__ = with_room.__code__.replace(co_stacksize=SLOTS)


def on_one_core() -> None:
    """Have numpy's linear algebra, loaded after this, calculate where it is called, unless the user has said otherwise.

    Beginning its threads is a third of loading numpy; a session has none of the large matrices that need them.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


@contextmanager
def uncollected() -> Iterator[None]:
    """No collection until `loaded`, or the end of this context, which leaves it as it was."""
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def loaded() -> None:
    """Collect from now on, among what is new."""
    gc.freeze()
    gc.enable()


def gathered() -> None:
    """Gather this process's memory in huge pages, where the kernel does so (Linux 6.1 on).

    For each process that is forked from this one the kernel has fewer pages to enter, and at its end to release. It
    takes some 10 ms, which only pays for many forks.
    """
    libc = ctypes.CDLL(None)
    for line in Path("/proc/self/maps").read_text(encoding="utf-8", errors="replace").splitlines():
        addresses, rights, _, _, _, *name = line.split(maxsplit=5)
        if rights != "rw-p" or name not in ([], ["[heap]"]):
            continue
        first, end = (int(text, 16) for text in addresses.split("-"))
        for at in range(-(-first // HUGE_BYTES) * HUGE_BYTES, end - HUGE_BYTES + 1, HUGE_BYTES):
            libc.madvise(ctypes.c_void_p(at), ctypes.c_size_t(HUGE_BYTES), MADV_COLLAPSE)  # it may refuse: never mind
