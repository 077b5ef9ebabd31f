"""The documentation's MAVSDK program, run as it is printed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from pages import DOCS, block
from patience import PATIENCE_S


def test_the_printed_program_flies(peers: Path, tmp_path: Path) -> None:
    program = tmp_path / "fly_with_mavsdk.py"
    program.write_text(block(DOCS / "how-to" / "mavsdk.md", program.name), encoding="utf-8")
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    done = subprocess.run(
        [str(peers / "python"), str(program)],
        env={**os.environ, "PATH": path},
        capture_output=True,
        text=True,
        timeout=PATIENCE_S,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    said = done.stdout.splitlines()
    assert "landed" in said
    assert [line for line in said if line.startswith(("north 2.", "north 3."))]
