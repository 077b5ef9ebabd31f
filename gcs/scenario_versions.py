"""The versions of the scenario format: what an older file must change, said where its `schema` stands."""

from __future__ import annotations

from typing import Any

CURRENT = 1
CHANGED: dict[int, str] = {0: "this is the number of drafts; the first published format is 1, which `gcs init` writes"}
"""By version, what came after it: what to do to a file of that version to make it one of the next."""


def refusal(version: Any) -> str | None:
    """Why a file of this version cannot be read, as a sentence; None where it can, or where it is no version at all."""
    if isinstance(version, bool) or not isinstance(version, int) or version == CURRENT:
        return None
    if version > CURRENT:
        return f"schema {version} is newer than this program, which reads {CURRENT}: pip install -U skytender"
    steps = [f"{old} to {old + 1}: {CHANGED[old]}" for old in range(version, CURRENT) if old in CHANGED]
    if not steps:
        return None
    return f"schema {version} is an older format; change the file, then write 'schema: {CURRENT}'. {'; '.join(steps)}"
