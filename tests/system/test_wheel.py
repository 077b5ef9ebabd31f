"""The wheel in an environment of its own: programs, scenarios, schemas and types come with it, from any folder."""

from __future__ import annotations

import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest
from sessions import ROOT

pytestmark = pytest.mark.timeout(900)
"""The wheel is compiled first."""


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The bin folder of an environment that has the wheel, and what it depends on from this one."""
    folder = tmp_path_factory.mktemp("wheel")
    pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    built = subprocess.run(
        [*pip, "wheel", "--no-deps", "-w", folder, ROOT], capture_output=True, text=True, check=False
    )
    if "Failed to establish a new connection" in built.stderr or "No matching distribution" in built.stderr:
        pytest.skip("the build needs setuptools and Cython from the package index")
    assert built.returncode == 0, built.stderr
    (wheel,) = folder.glob("skytender-*.whl")
    venv.create(folder / "env")
    python = folder / "env" / "bin" / "python"
    done = subprocess.run([*pip, "--python", python, "install", "--no-deps", "--no-index", wheel], check=False)
    assert done.returncode == 0
    packages = next((folder / "env" / "lib").glob("python*/site-packages"))
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return folder / "env" / "bin"


def run(program: Path, *words: str, cwd: Path) -> str:
    done = subprocess.run([program, *words], cwd=cwd, capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_programs_scenarios_schemas_and_types_are_in_it(installed: Path, tmp_path: Path) -> None:
    for name in ("demo", "paper/example1", "fleet"):
        assert run(installed / "gcs", "validate", name, "--quiet", cwd=tmp_path) == ""
    run(installed / "skytender", "init", "mine", cwd=tmp_path)
    program = (
        "import gcs, simvehicle\nfrom importlib.resources import files\n"
        "print(gcs.__file__, *[files(p).joinpath(f).is_file() for p, f in (('gcs', 'py.typed'), "
        "('simvehicle', 'py.typed'), ('gcs', 'schemas/summary.schema.json'), ('gcs', 'report/paper/claims.yaml'))])"
    )
    where, *present = run(installed / "python", "-c", program, cwd=tmp_path).split()
    assert where.startswith(str(installed.parent))
    assert present == ["True"] * 4
    assert "simvehicle" in run(installed / "gcs", "doctor", cwd=tmp_path)
