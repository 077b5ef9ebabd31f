"""Starting without looking for garbage: what is loaded stays, and to look through it again and again is a tenth of a
start. And forking many processes from one that has all loaded."""

from __future__ import annotations

import ctypes
import gc
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

MADV_COLLAPSE = 25
HUGE_BYTES = 1 << 21


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
