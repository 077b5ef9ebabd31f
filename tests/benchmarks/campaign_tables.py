"""What the programs that make tables of campaigns are asked, and what they say while they fly."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from gcs.campaign.engine import Progress

Row = dict[str, Any]


def asked(about: str | None, *, sessions: tuple[int, str], seed: int, out: str) -> argparse.ArgumentParser:
    """Options that all of them have; `sessions`: how many, and of what."""
    parser = argparse.ArgumentParser(description=(about or "").partition("\n")[0])
    parser.add_argument("--sessions", type=int, default=sessions[0], help=sessions[1])
    parser.add_argument("--seed", type=int, default=seed)
    parser.add_argument("--workers", type=int, default=None)
    parser.add_argument("--out", type=Path, required=True, help=out)
    return parser


def told(progress: Progress, _row: Row | None) -> None:
    """A line that says how far it is."""
    print(f"\r{progress.done} of {progress.total}, {progress.failed} failed ", end="", file=sys.stderr, flush=True)
