"""A source without a terminal: its messages as lines of text, or as JSON for other programs."""

from __future__ import annotations

import json
import time
from collections.abc import Callable

from gcs.session.client import Message, MessageSource
from gcs.session.plain_text import JsonView, PlainView, View, mute, outcome_line, progress

LOOK_EVERY_S = 0.1
STEP_S = 0.5


class Steps:
    """A clock that goes on by one step when it is asked to: for what need not be waited for."""

    def __init__(self) -> None:
        self.now_s = 0.0

    def __call__(self) -> float:
        """The time."""
        return self.now_s

    def go_on(self) -> None:
        """One step."""
        self.now_s += STEP_S


class ReplayPace:
    """Waits for times of a recording, at a speed. A time that is past is not waited for."""

    def __init__(self, from_s: float, speed: float) -> None:
        self._speed, self._zero_s = speed, time.monotonic() - from_s / speed

    def __call__(self, t_s: float) -> None:
        """Wait until `t_s` is due."""
        time.sleep(max(self._zero_s + t_s / self._speed - time.monotonic(), 0.0))


class ChangesView(PlainView):
    """The plain view without lines of progress that say nothing new: a monitor may run for days beside idle fleets."""

    _before = ""

    def _print_progress(self, now_s: float) -> None:
        assert self._last is not None
        now = progress({**self._last, "t_s": 0.0})
        if now != self._before:
            self._before = now
            super()._print_progress(now_s)


def follow(
    source: MessageSource,
    write: Callable[[str], object],
    *,
    as_json: bool,
    changes_only: bool = False,
    clock: Callable[[], float] = time.monotonic,
    wait: Callable[[], object] = lambda: time.sleep(LOOK_EVERY_S),
    over: Callable[[], bool] = lambda: False,
) -> None:
    """Show a source until it ends, is `over`, or its reader is gone; Ctrl-C raises KeyboardInterrupt.

    changes_only: as text, no line of progress that says only that time has passed.
    clock, wait: by which what is shown now and then is due, and how the next look is waited for.
    """
    view = JsonView(write) if as_json else (ChangesView if changes_only else PlainView)(write)
    try:
        end: Message | None = None
        while end is None and not over():
            end = _show(source, view, write, as_json=as_json)
            view.tick(clock())
            if end is None and not over():
                wait()
        view.close()
        if end is not None:
            write(json.dumps(end) if as_json else outcome_line(end.get("outcome") or "unknown", end.get("text")))
    except BrokenPipeError:
        mute(1)
    finally:
        source.close()


def _show(source: MessageSource, view: View, write: Callable[[str], object], *, as_json: bool) -> Message | None:
    """Show what has come; the message that ends it, if that was among it."""
    for message in source.receive():
        kind = message.get("type")
        if kind == "snapshot":
            view.show(message)
        elif kind == "end":
            return message
        elif kind == "session" and as_json:
            write(json.dumps(message))
    return None
