"""The console: a Textual app that shows a source's messages and sends its operator's commands."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable

from textual import events

from gcs.console.dialogs import Confirm
from gcs.console.job import can_suspend
from gcs.console.main_screen import MainScreen
from gcs.console.shell import Shell
from gcs.console.text import Glyphs
from gcs.session.client import MessageSource
from gcs.session.plain_text import outcome_line

BEAT_S = 0.2
"""The screen is looked at, and drawn where it has changed, this often: 5 Hz."""


class ConsoleApp(Shell):
    """The app's shell around one source; `owner` means that its Ctrl-C asks to stop the session."""

    ENABLE_COMMAND_PALETTE = False
    AUTO_FOCUS = None

    def __init__(
        self,
        source: MessageSource,
        title: str = "",
        *,
        owner: bool = False,
        glyphs: Glyphs | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        super().__init__(source, title, owner=owner, glyphs=glyphs, clock=clock)
        self.main = MainScreen()

    def on_mount(self) -> None:
        """Begin to look."""
        self.push_screen(self.main)
        self.set_interval(BEAT_S, self.beat)
        self.call_after_refresh(self.beat)

    def beat(self) -> None:
        """Take in what has come and show it."""
        changed = self.seen.update(self.source.receive())
        if changed:
            self.last_received_s = self.clock()
        if self.seen.end is not None:
            self.exit(0)
            return
        self.main.beat(changed)
        if changed and isinstance(self.screen, Confirm):
            self.screen.redraw()

    def action_suspend_process(self) -> None:
        """Give the terminal back to the shell, if there is one that can continue us."""
        if can_suspend():
            super().action_suspend_process()
        else:
            self.main.notice("there is no shell here that could continue the console: Ctrl-Z does nothing")

    def on_resize(self, event: events.Resize) -> None:
        """A question in a terminal that has become too small is taken as not answered."""
        if self.main.is_mounted and self.main.too_small(event.size) and len(self.screen_stack) > 2:
            while self.screen is not self.main:
                self.pop_screen()


def show(source: MessageSource, title: str = "", *, owner: bool = False) -> int:
    """Show `source` in this terminal until it ends or the person closes it; the exit status."""
    for size in ("COLUMNS", "LINES"):  # where they were exported, they would outlive every resize
        os.environ.pop(size, None)
    app = ConsoleApp(source, title, owner=owner)

    def leave(*_: object) -> None:
        app.call_later(app.exit, 0)

    handlers = {number: signal.signal(number, leave) for number in (signal.SIGTERM, signal.SIGHUP)}
    try:
        app.run()
        if app.seen.end is not None and not owner:
            print(outcome_line(app.seen.end.get("outcome") or "unknown", app.seen.end.get("text")))
        return app.return_code or 0
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
        source.close()
