"""Base class of the console app: message source, session model and terminal capabilities, as pages use them."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable

from textual.app import App

from gcs.console.model import SessionModel
from gcs.console.styles import GROUNDS, Look, look_of
from gcs.console.text import Glyphs, own_glyphs
from gcs.session.client import MessageSource


class Shell(App[int]):
    """One source, the state of its messages, and the abilities of the terminal.

    `owner`: this console belongs to `gcs run`, whose session Ctrl-C is meant to stop. `clock`: s, by which silence and
    notices are timed.
    """

    def __init__(
        self, source: MessageSource, title: str, *, owner: bool, glyphs: Glyphs | None, clock: Callable[[], float]
    ) -> None:
        self._ground = look_of(os.environ)
        super().__init__()
        self.look: Look = "plain" if self.no_color else self._ground
        self.source = source
        self.title = title
        self.owner = owner
        self.glyphs = glyphs or own_glyphs(sys.__stderr__.encoding if sys.__stderr__ else "ascii")
        self.seen = SessionModel()
        self.clock = clock
        self.last_received_s = clock()

    def get_css_variables(self) -> dict[str, str]:
        """The grounds, for the panels' rules."""
        on = GROUNDS[self._ground]
        return super().get_css_variables() | {"ground": on.ground, "raised": on.raised, "frame": on.frame}

    def turn_look(self) -> None:
        """For a terminal of the other ground."""
        self._ground = "light" if self._ground == "dark" else "dark"
        self.look = "plain" if self.no_color else self._ground
        self.refresh_css()

    def lost(self) -> list[str]:
        """Limits of this terminal, in sentences."""
        lost = []
        if self.no_color:
            lost.append("No colour (NO_COLOR is set): signs, words, bold and reverse say the same.")
        if not self.glyphs.unicode:
            lost.append("No Unicode: the map and the curves are drawn four times as coarse.")
        return lost
