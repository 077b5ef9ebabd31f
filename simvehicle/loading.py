"""Starting without looking for garbage: what is loaded stays, and to look through it again and again is a tenth of a
start."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


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
