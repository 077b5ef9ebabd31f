"""Loading of modules, which make lasting objects by the ten thousand."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def uncollected() -> Iterator[None]:
    """Look for no garbage within this context.

    Python looks through all objects again each time that their number has grown by a quarter: a twelfth of the time
    from the prompt to a session's end.
    """
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()
