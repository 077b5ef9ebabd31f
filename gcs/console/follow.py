"""A source without a terminal: what it tells as lines of text, or as JSON for other programs."""

from __future__ import annotations

import json
import math
import time
from collections.abc import Callable
from typing import Any

from gcs.console.plain import JsonView, PlainView, mute_stdout
from gcs.console.source import Source

LOOK_EVERY_S = 0.1
STEP_S = 0.5


class Steps:
    """A clock that goes on by one step when it is asked to: for what need not be waited for."""

    def __init__(self, step_s: float = STEP_S) -> None:
        self.now_s = 0.0
        self._step_s = step_s

    def __call__(self) -> float:
        """The time."""
        return self.now_s

    def go_on(self) -> None:
        """One step."""
        self.now_s += self._step_s


def follow(
    source: Source,
    write: Callable[[str], object],
    *,
    as_json: bool,
    clock: Callable[[], float] = time.monotonic,
    wait: Callable[[], object] = lambda: time.sleep(LOOK_EVERY_S),
    until_s: float = math.inf,
) -> None:
    """Show a source until it ends, has played to its end, or nobody reads any more; Ctrl-C raises KeyboardInterrupt.

    until_s: the time on `clock` at which to leave off.
    """
    view: PlainView | JsonView = JsonView(write) if as_json else PlainView(write)
    try:
        while not _shown(source, view, write, as_json=as_json) and source.connected and clock() < until_s:
            view.tick(clock())
            wait()
        view.close()
    except BrokenPipeError:
        mute_stdout()
    finally:
        source.close()


def _shown(source: Source, view: PlainView | JsonView, write: Callable[[str], object], *, as_json: bool) -> bool:
    """Show what has come; whether it was the end."""
    ended = False
    for message in source.receive():
        kind: Any = message.get("type")
        if kind == "snapshot":
            view.show(message)
            ended = ended or message.get("phase") == "ended"
        elif kind == "end":
            ended = True
        elif kind == "session" and as_json:
            write(json.dumps(message))
        elif kind == "reply" and not as_json:
            write(str(message.get("text")))
    return ended
