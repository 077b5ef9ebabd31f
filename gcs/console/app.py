"""The console: a Textual app that shows what a source tells, and hands over what its operator asks for."""

from __future__ import annotations

from textual.app import App

from gcs.console.source import Source


class ConsoleApp(App[int]):
    """The app's shell around one source."""

    def __init__(self, source: Source, title: str = "") -> None:
        super().__init__()
        self._source = source
        self.title = title


def show(source: Source, title: str = "") -> int:
    """Show `source` in this terminal until it ends or the person closes it; the exit status."""
    try:
        return ConsoleApp(source, title).run() or 0
    finally:
        source.close()
