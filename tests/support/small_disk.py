"""Commands on a small disk, which is mounted where no other process sees it."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

ALONE = ["unshare", "--user", "--map-root-user", "--mount"]


def run_on_small_disk(
    size: str, script: str, command: Sequence[str], folder: Path, env: Mapping[str, str] | None = None
) -> subprocess.CompletedProcess[str]:
    """Run a shell's script, in which "$@" is the command, in `folder`, where `disk` holds no more than `size`; where
    this machine lets a user mount nothing, the test is skipped."""
    if subprocess.run([*ALONE, "mount", "-t", "tmpfs", "t", "/mnt"], capture_output=True, check=False).returncode:
        pytest.skip("this machine lets a user mount no disk")
    (folder / "disk").mkdir()
    mounted = f"mount -t tmpfs -o size={size} t disk && {{ {script}; }}"
    words = [*ALONE, "sh", "-c", mounted, "sh", *command]
    return subprocess.run(words, cwd=folder, env=env, capture_output=True, text=True, check=False)
