"""Loading of modules, which make lasting objects by the ten thousand."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def uncollected(*, for_good: bool = False) -> Iterator[None]:
    """Look for no garbage within this context; `for_good`: nor ever among what is there at its end, in a program of
    ours, whose objects are all its own.

    Python looks through all objects again each time that their number has grown by a quarter: a twelfth of the time
    from the prompt to a session's end.
    """
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if for_good:
            gc.freeze()
        if collects:
            gc.enable()
