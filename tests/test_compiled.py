"""Compiled modules: a changed source is never passed over, and what flies is what its source says."""

from __future__ import annotations

import ast
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import message_structs
import pytest
from Cython.Build.Dependencies import create_dependency_tree

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
        shutil.copy2(ROOT / name, root)  # with its time, by which it is known that all is compiled
    setup, times = root / "setup.py", (root / "setup.py").stat()
    setup.write_text(setup.read_text().replace('"-O3"', '"-O0"'))  # a third of the time, and the same bytes
    os.utime(setup, ns=(times.st_atime_ns, times.st_mtime_ns))
    for folder in ("configs", "build"):
        shutil.copytree(ROOT / folder, root / folder)
    return root


@contextmanager
def changed(source: Path) -> Iterator[None]:
    """A source with an empty line more, and then as it was, its time included."""
    before, times = source.read_text(), source.stat()
    source.write_text(before + "\n")
    try:
        yield
    finally:
        source.write_text(before)
        os.utime(source, ns=(times.st_atime_ns, times.st_mtime_ns))


def said(root: Path, program: str) -> subprocess.CompletedProcess[str]:
    """A program run on the packages of a folder alone."""
    path = {**os.environ, "PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-c", program]
    return subprocess.run(command, cwd=root, env=path, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("suffix", [".py", ".pxd"])
def test_a_changed_source_of_any_compiled_module_is_named(copied: Path, suffix: str) -> None:
    for source in SOURCES:
        one, package = copied / source.with_suffix(suffix), source.parts[0]
        with changed(one), pytest.raises(ImportError, match=re.escape(f"{one} was changed after it was compiled")):
            compiled.check(package, str(copied))
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
    with changed(copied / source):
        done = said(copied, f"import {program}")
    assert done.returncode == 1
    assert f"{source} was changed after it was compiled: run `make build`" in done.stderr.splitlines()[-1]


FLOWN = """
from simvehicle.law import controller
print(controller.outer(0., 0., 0., 0., 0., 0., -50., 0., 0., 0., 3., 0., 10., 0.7, 20.)[2])
"""


def rebuilt(root: Path) -> set[Path]:
    """The modules that are compiled anew."""
    begun = {path: path.stat().st_mtime_ns for path in root.rglob("*.so")}
    command = [sys.executable, "setup.py", "--quiet", "build_ext", "--inplace"]
    subprocess.run(command, cwd=root, check=True, capture_output=True)
    return {
        path.relative_to(root).parent / path.name.partition(".")[0]
        for package in compiled.PACKAGES
        for path in (root / package).rglob("*.so")
        if path.stat().st_mtime_ns != begun.get(path)
    }


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_what_is_rebuilt_flies(copied: Path) -> None:
    """A fall that is asked for is held at the least lift, a share of gravity that the law's source names. The changed
    source is older than what was compiled, as one that is put back from a copy."""
    law = copied / "simvehicle" / "law" / "controller.py"
    assert said(copied, FLOWN).stdout == "3.0\n"
    law.write_text(law.read_text().replace("_LEAST_LIFT = 0.3", "_LEAST_LIFT = 0.4"))
    os.utime(law, (0, 0))
    no_longer_compiled = copied / "gcs" / "ids.cpython-3-x86_64-linux-gnu.so"
    no_longer_compiled.touch()
    assert rebuilt(copied) == {Path("simvehicle/law/controller")}
    assert said(copied, FLOWN).stdout == "4.0\n"
    assert not no_longer_compiled.exists()


@pytest.mark.timeout(600)
def test_a_changed_function_of_a_declaration_flies_in_all_that_use_it(copied: Path) -> None:
    """What holds accelerations within their limits stands in a .pxd alone: here it adds a climb beyond all thrust."""
    declared = copied / "simvehicle" / "law" / "arithmetic.pxd"
    declared.write_text(declared.read_text().replace("min(max(x, -limit)", "1000.0 + min(max(x, -limit)"))
    law = Path("simvehicle/law")
    assert rebuilt(copied) == {law / "controller", law / "step", law / "rotor_flight"}
    assert said(copied, FLOWN).stdout == "20.0\n"


def declarations_of(source: Path) -> set[Path]:
    """The .pxd of ours that a compiled source, or a .pxd, names."""
    text = source.read_text()
    if source.suffix == ".pxd":
        found = re.finditer(r"^ *(?:from +([\w.]+) +)?cimport +(.+)$", text, re.MULTILINE)
        named = [(one[1], [name.split()[0] for name in one[2].split(",")]) for one in found]
    else:
        nodes = list(ast.walk(ast.parse(text)))
        named = [(one.module, [name.name for name in one.names]) for one in nodes if isinstance(one, ast.ImportFrom)]
        named += [(None, [name.name for name in one.names]) for one in nodes if isinstance(one, ast.Import)]
    modules = {module for module, _ in named if module}
    modules |= {f"{module}.{name}" if module else name for module, names in named for name in names}
    cython = {module.removeprefix("cython.cimports.") for module in modules
              if source.suffix == ".pxd" or module.startswith("cython.cimports.")}  # fmt: skip
    paths = {Path(*module.split(".")).with_suffix(".pxd") for module in cython}
    return {path for path in paths if (ROOT / path).exists()}


def test_cython_sees_each_declaration_that_a_module_uses(monkeypatch: pytest.MonkeyPatch) -> None:
    """It reads imports line by line, and not all forms of them: what it does not see would not be compiled anew."""
    monkeypatch.chdir(ROOT)
    seen = create_dependency_tree(quiet=True)
    for source in SOURCES:
        named, left = set(), [source, source.with_suffix(".pxd")]
        while left:
            named |= (more := declarations_of(left.pop()) - named)
            left += more
        assert named <= {Path(path) for path in seen.all_dependencies(str(source))}, source


def test_every_compiled_module_is_compiled() -> None:
    made = {path.relative_to(ROOT).parent / path.name.partition(".")[0] for package in compiled.PACKAGES
            for path in (ROOT / package).rglob("*.so")}  # fmt: skip
    assert made == {source.with_suffix("") for source in SOURCES} | {Path("skytender/memoryviews")}


def test_structs_of_messages_are_pymavlinks_definitions() -> None:
    assert message_structs.DECLARED.read_text() == message_structs.declarations()
