"""pymavlink's dialect of newer.xml, which other dialects lack: its classes write and read like theirs."""

from __future__ import annotations

import contextlib
import importlib.util
import io
import tempfile
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import ardupilotmega, common
from pymavlink.generator import mavgen_python, mavparse

DEFINITIONS = Path(__file__).with_name("newer.xml")


def _dialect() -> Any:
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
        made = Path(folder) / "dialect.py"
        mavgen_python.generate(str(made), [mavparse.MAVXML(str(DEFINITIONS), "2.0")])
        spec = importlib.util.spec_from_file_location("newer_dialect", made)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    return module


dialect = _dialect()
ENUMS = {name: entries for name, entries in dialect.enums.items() if entries}
MESSAGES = dialect.mavlink_map


def understood() -> None:
    """Let parsers of pymavlink's common messages and ArduPilot's read these too."""
    for known in (common, ardupilotmega):
        known.mavlink_map.update({msgid: cls for msgid, cls in MESSAGES.items() if msgid not in known.mavlink_map})
