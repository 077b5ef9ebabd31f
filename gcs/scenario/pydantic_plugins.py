"""Models built without what other packages plug into pydantic: only where no code runs but ours."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

VARIABLE = "PYDANTIC_DISABLE_PLUGINS"


@contextmanager
def without_plugins() -> Iterator[None]:
    """Build models without plugins in this context, unless the user has said what is wanted of them.

    The search for them reads what every installed package says of itself.
    """
    if VARIABLE in os.environ:
        yield
        return
    os.environ[VARIABLE] = "__all__"
    try:
        yield
    finally:
        del os.environ[VARIABLE]
