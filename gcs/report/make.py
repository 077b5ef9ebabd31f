"""A session's folder → report.html."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from gcs.recording.session_folder import read
from gcs.report import page
from gcs.report.findings import Findings

FILE = "report.html"
READ, MEASURED = 0.8, 0.9


def make(folder: Path, out: Path | None = None, progress: Callable[[str, float], object] = lambda *_: None) -> Path:
    """Make the report of the session in `folder`, in it or at `out`; where it lies. An older one is replaced, whole.

    `progress` is given what is done and how much of all, 0 to 1. Raises NoSession, OSError.
    """
    target = out or folder / FILE
    progress("reading", 0.0)
    recorded = read(folder, lambda share: progress("reading", READ * share))
    progress("measuring", READ)
    findings = Findings(recorded)
    progress("drawing", MEASURED)
    content = page.text(findings)
    beside = target.with_name(f".{target.name}.{os.getpid()}")
    try:
        beside.write_text(content, encoding="utf-8")
        beside.replace(target)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise
    progress("done", 1.0)
    return target
