"""The secret by which a supervisor knows the vehicles that it has started:
docs/protocol/link.md#vehicle-side-of-the-link.

The fork server reads it from its socket and leaves it to the process that it forks. It stands in no command line and no
file, which other users could read.
"""

from __future__ import annotations

_held: list[int] = []
"""the one, or none"""


def hand_over(secret: object) -> None:
    """Keep an order's secret for this process, which the fork server has just forked; one that is none is no secret."""
    _held[:] = [secret] if isinstance(secret, int) and not isinstance(secret, bool) and 0 < secret < 1 << 64 else []


def own_secret() -> int | None:
    """This process's secret; None where it was not forked by a fork server that had one."""
    return _held[0] if _held else None
