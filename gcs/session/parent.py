"""The supervisor and the process that started it: a pipe that closes, and lines of JSON with the last word."""

from __future__ import annotations

import contextlib
import json
import os
import sys
import traceback
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from gcs.link.socket import AddressRefused
from gcs.processes.fork_server import LaunchError
from gcs.recording.recorder import RecorderError
from gcs.scenario.model import ScenarioError
from gcs.session.arrival import BadVehicleError, SessionFailed
from skytender.exit import BAD_INPUT, INTERNAL_ERROR, NOT_DONE, RAISE_LIMIT, TOO_FEW_FILES
from skytender.key_files import KeyRefused

ELSEWHERE = "Free space there, or give --out another place."


def has_gone() -> bool:
    """Whether the parent has gone: its end of our standard input, which does not block, is closed."""
    try:
        return os.read(0, 1) == b""
    except BlockingIOError:
        return False


def say(content: Mapping[str, Any]) -> None:
    """Say a line of JSON to the parent."""
    with contextlib.suppress(BrokenPipeError):
        print(json.dumps(content), file=sys.__stdout__, flush=True)


def explained(problem: Exception, folder: Path, *, begun: bool) -> tuple[int, str]:
    """Exit status and sentence of an error that has ended the session in `folder`. `begun`: whether anything has flown.

    Called where it is handled: the traceback of a fault of the program's own goes into the folder.
    """
    if isinstance(problem, ScenarioError | BadVehicleError | AddressRefused | KeyRefused):
        return BAD_INPUT, str(problem)
    if isinstance(problem, RecorderError | OSError) and not folder.is_dir():
        why = f"{folder} is gone, and with it what was recorded there; the session has ended"
        return NOT_DONE if begun else BAD_INPUT, why
    if isinstance(problem, RecorderError):
        return NOT_DONE, f"{problem} What was flown until then is kept. {ELSEWHERE}"
    if isinstance(problem, SessionFailed | LaunchError):
        return NOT_DONE, str(problem)
    if isinstance(problem, OSError) and problem.errno in TOO_FEW_FILES:
        return NOT_DONE if begun else BAD_INPUT, RAISE_LIMIT
    if isinstance(problem, OSError):
        why = f"{problem.filename or folder} cannot be written: {problem.strerror}; give --out another place"
        return NOT_DONE if begun else BAD_INPUT, why
    log = folder / "supervisor.log"
    with contextlib.suppress(OSError):
        log.write_text(traceback.format_exc(), encoding="utf-8")
    return INTERNAL_ERROR, f"this is a bug of the supervisor: please report it with {log}"
