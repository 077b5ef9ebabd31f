"""Compiled modules: a changed source is never passed over, and what flies is what its source says."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from skytender import compiled

ROOT = Path(__file__).resolve().parents[1]
SOURCES = compiled.compiled_sources(ROOT)


@pytest.fixture(scope="module")
def copied(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The packages with their compiled modules, to be changed."""
    root = tmp_path_factory.mktemp("copy")
    ignored = shutil.ignore_patterns("__pycache__", "page", "built")
    for package in compiled.PACKAGES:
        shutil.copytree(ROOT / package, root / package, ignore=ignored)
    for name in ("setup.py", "pyproject.toml", "MANIFEST.in", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, root)
    for folder in ("configs", "build"):
        shutil.copytree(ROOT / folder, root / folder)
    return root


def said(root: Path, program: str) -> subprocess.CompletedProcess[str]:
    """A program run on the packages of a folder alone."""
    path = {**os.environ, "PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-c", program]
    return subprocess.run(command, cwd=root, env=path, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("source", SOURCES, ids=str)
@pytest.mark.parametrize("suffix", [".py", ".pxd"])
def test_a_changed_source_of_any_compiled_module_is_named(copied: Path, source: Path, suffix: str) -> None:
    changed = copied / source.with_suffix(suffix)
    before = changed.read_text()
    try:
        changed.write_text(before + "\n")
        package = source.parts[0]
        with pytest.raises(ImportError, match=re.escape(f"{changed} was changed after it was compiled")):
            compiled.check(package, str(copied))
    finally:
        changed.write_text(before)
    compiled.check(package, str(copied))


@pytest.mark.parametrize(
    ("program", "source"),
    [
        ("simvehicle", "simvehicle/law/controller.py"),
        ("gcs", "gcs/planner/tracking.py"),
        ("gcs", "skytender/checksum.py"),
    ],
)
def test_no_program_starts_with_old_code(copied: Path, program: str, source: str) -> None:
    changed = copied / source
    before = changed.read_text()
    changed.write_text(before + "\n")
    try:
        done = said(copied, f"import {program}")
        assert done.returncode == 1
        assert f"{source} was changed after it was compiled: run `make build`" in done.stderr.splitlines()[-1]
    finally:
        changed.write_text(before)


FLOWN = """
from simvehicle.law import controller
print(controller.outer(0., 0., 0., 0., 0., 0., -50., 0., 0., 0., 3., 0., 10., 0.7, 20.)[2])
"""


@pytest.mark.timeout(600)
def test_what_is_rebuilt_flies(copied: Path) -> None:
    """A fall that is asked for is held at the least lift, a share of gravity that the law's source names."""
    law = copied / "simvehicle" / "law" / "controller.py"
    assert said(copied, FLOWN).stdout == "3.0\n"
    law.write_text(law.read_text().replace("_LEAST_LIFT = 0.3", "_LEAST_LIFT = 0.4"))
    command = [sys.executable, "setup.py", "--quiet", "build_ext", "--inplace"]
    subprocess.run(command, cwd=copied, check=True, capture_output=True)
    assert said(copied, FLOWN).stdout == "4.0\n"


def test_every_compiled_module_is_compiled() -> None:
    made = {path.relative_to(ROOT).parent / path.name.partition(".")[0] for package in compiled.PACKAGES
            for path in (ROOT / package).rglob("*.so")}  # fmt: skip
    assert made == {source.with_suffix("") for source in SOURCES} | {Path("skytender/memoryviews")}
