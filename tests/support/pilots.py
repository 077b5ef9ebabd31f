"""The console's app without a terminal: messages and keys in, lines of text and styles out."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Mapping
from typing import Any

from feed import Fed
from rich.segment import Segment
from textual.pilot import Pilot

from gcs.console.app import ConsoleApp
from gcs.console.text import UNICODE, Glyphs

Messages = list[Mapping[str, Any]]


class Shown:
    """A console under a pilot."""

    def __init__(self, app: ConsoleApp, source: Fed, pilot: Pilot[int]) -> None:
        self.app, self.source, self.pilot = app, source, pilot

    async def feed(self, *messages: Mapping[str, Any]) -> None:
        """Have these taken in and shown."""
        self.source.feed(*messages)
        self.app.beat()
        await self.pilot.pause()

    async def press(self, *keys: str) -> None:
        """Press keys, one after the other."""
        await self.pilot.press(*keys)
        await self.pilot.pause()

    def segments(self) -> list[list[Segment]]:
        """The screen as a screenshot of Textual's takes it."""
        return [list(strip) for strip in self.app.screen._compositor.render_strips()]

    def lines(self) -> list[str]:
        """The screen's text."""
        return ["".join(segment.text for segment in line).rstrip() for line in self.segments()]

    def text(self) -> str:
        """The same in one piece."""
        return "\n".join(self.lines())


def drive(
    steps: Callable[[Shown], Awaitable[None]],
    messages: Messages,
    *,
    size: tuple[int, int] = (80, 24),
    glyphs: Glyphs = UNICODE,
    owner: bool = False,
) -> ConsoleApp:
    """Run the app, take in `messages`, then do `steps`; the app as it ended. Its clock stands."""
    source = Fed(*messages)
    app = ConsoleApp(source, "demo", owner=owner, glyphs=glyphs, clock=lambda: 0.0)

    async def run() -> None:
        async with app.run_test(size=size) as pilot:
            await pilot.pause()
            shown = Shown(app, source, pilot)
            await shown.feed()
            await steps(shown)

    asyncio.run(run())
    return app


def screen(messages: Messages, *keys: str, **options: Any) -> list[str]:
    """The screen's text after `messages` and `keys`."""
    seen: list[str] = []

    async def steps(shown: Shown) -> None:
        await shown.press(*keys)
        seen.extend(shown.lines())

    drive(steps, messages, **options)
    return seen
