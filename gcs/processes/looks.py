"""Times of a recording at which a fleet is looked at: what is found, and when, depends on the recording alone."""

from __future__ import annotations

import math
from collections.abc import Iterator

EVERY_S = 0.1
"""As a session's supervisor looks, once in each period."""
SETTLED_S = 60.0
"""Without a frame for so long nothing of a vehicle but its times changes any more."""


class Looks:
    """Multiples of `every_s` above `after_s`, each once, in their order; those in a silence longer than `settled_s` are
    left out, for a stamp may be years away."""

    def __init__(self, every_s: float = EVERY_S, *, after_s: float = 0.0, settled_s: float = math.inf) -> None:
        self._every_s, self._settled_s = every_s, settled_s
        self._go_to(math.floor(after_s / every_s) + 1)

    def _go_to(self, number: int) -> None:
        self._number = number
        self.due_s = round(number * self._every_s, 6)
        """the next one"""

    def before(self, t_s: float) -> Iterator[float]:
        """Times that are due before the next frame comes, at `t_s`."""
        settled_s = self.due_s + self._settled_s
        while self.due_s < t_s:
            yield self.due_s
            last = self.due_s > settled_s
            self._go_to(max(self._number + 1, math.ceil(t_s / self._every_s)) if last else self._number + 1)
