"""Sentences on what a session's folder does not hold, or not as it should: what, where, and what is lost by that."""

from __future__ import annotations

from pathlib import Path

from gcs.recording.changes import NEAR_M

SCENARIO = "scenario.yaml"
CHANGES_ONLY = (
    f"decisions.jsonl holds set points only where they change, to {100.0 * NEAR_M:.0f} cm (record: decisions: "
    "changes): the tracking error cannot be shown."
)
"""Errors are smaller than what such set points may be off."""
NO_REASON = "the reason is not recorded"
"""Why a refuelling ended whose end is in no line that is left."""


def unread(path: Path, error: Exception, lost: str) -> str:
    """Why a file of a session could not be read, and what is lost; `error` is an OSError or a ScenarioError."""
    if not path.exists():
        return f"{path.parent} has no {path.name}: {lost}"
    if isinstance(error, OSError):
        return f"{path} cannot be read ({error.strerror}): {lost}"
    return f"{path} is no scenario ({str(error).splitlines()[0].removeprefix(f'{path}:')}): {lost}"


def passed_over(name: str, count: int) -> str:
    """Sentence on lines of a file of decisions that are none."""
    are = "line is no decision and was" if count == 1 else "lines are no decision and were"
    return f"{name}: {count} {are} passed over."
