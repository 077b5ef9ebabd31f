"""Progress of a campaign in the terminal: a line that is drawn again, or plain lines; failures as they come."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import shutil
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from gcs.campaign.engine import Progress

LISTED_FAILURES = 20
PLAIN_EVERY_S = 5.0


class ProgressLine:
    """Progress as a line that is drawn again, or as lines; failures as they come."""

    def __init__(self, folder: Path, *, quiet: bool, plain: bool) -> None:
        self._folder, self._quiet, self._plain = folder, quiet, plain
        self._next_s = 0.0
        self._width = 0
        self._failures = 0
        self._linked = False

    def update(self, progress: Progress, row: dict[str, Any] | None) -> None:
        """Take in a row, or just the time."""
        if self._quiet:
            return
        if not self._linked and progress.dashboard:
            self._linked = True
            self._line(f"Dask's dashboard: {progress.dashboard}")
        if row is not None and not row["ok"]:
            self._failures += 1
            if self._failures <= LISTED_FAILURES:
                self._line(f"row {row['row']}: {row['error'] or row['fault']}")
            elif self._failures == LISTED_FAILURES + 1:
                self._line(f"more failures: gcs campaign status {self._folder}")
        now_s = time.monotonic()
        if now_s < self._next_s:
            return
        self._next_s = now_s + (PLAIN_EVERY_S if self._plain else 0.25)
        text = words(progress)
        if self._plain:
            click.echo(text)
            return
        text = text[: shutil.get_terminal_size().columns - 1]
        click.echo(f"\r{text:<{self._width}}", nl=False)
        self._width = len(text)

    def end(self) -> None:
        """Leave the line."""
        if self._width:
            click.echo()

    def _line(self, text: str) -> None:
        if self._width:
            click.echo(f"\r{'':<{self._width}}\r", nl=False)
        click.echo(text)
        self._next_s = 0.0 if not self._plain else self._next_s


def words(progress: Progress) -> str:
    """One line: how far, how fast, how long still."""
    from gcs.session.plain_text import minutes

    parts = [f"{progress.done} of {progress.total} sessions"]
    if progress.flown:
        parts.append(f"{60.0 * progress.rate:.1f} per minute, {minutes(progress.left_s)} left")
    else:
        parts.append("workers are starting ...")
    parts += [f"{progress.workers} worker{'s' * (progress.workers != 1)}"] if progress.workers else []
    parts += [f"{progress.failed} failed"] if progress.failed else []
    parts += [f"{progress.errors} with errors"] if progress.errors else []
    return ", ".join(parts)
