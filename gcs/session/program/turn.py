"""One call at a time talks to a session; and what a session refuses with."""

from __future__ import annotations

import threading


class SessionError(RuntimeError):
    """A session that could not be flown, has not ended yet, or refuses what is asked of it; the text says why and what
    to do."""


class Turn:
    """A context manager that one call holds at a time, of any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()

    def __enter__(self) -> None:
        """Raises SessionError while another call holds it: an answer would be taken for that call's."""
        if not self._lock.acquire(blocking=False):
            raise SessionError(
                "another call of this session is under way: call it from one thread, and not from its own planner or "
                "policy"
            )

    def __exit__(self, *_: object) -> None:
        self._lock.release()
