"""The wheel in an environment of its own: programs, scenarios, schemas and types come with it, and fly from any folder
without a compiler."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path
from zipfile import ZipFile

import pytest
from sessions import DIGESTS, ROOT

from skytender.compiled import PACKAGES, compiled_sources

PIP = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, made of a copy of what is compiled here already."""
    copy, folder = tmp_path_factory.mktemp("checkout"), tmp_path_factory.mktemp("wheel")
    for name in (*PACKAGES, "configs", "build"):
        shutil.copytree(ROOT / name, copy / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("setup.py", "pyproject.toml", "MANIFEST.in", "README.md", "LICENSE"):
        shutil.copy2(ROOT / name, copy)
    command = [*PIP, "wheel", "--no-deps", "--no-build-isolation", "-w", folder, copy]
    subprocess.run(command, check=True, capture_output=True)
    (made,) = folder.glob("skytender-*.whl")
    return made


@pytest.fixture(scope="module")
def installed(wheel: Path) -> Path:
    """The bin folder of an environment that has the wheel, and what it depends on from this one."""
    environment = wheel.parent / "env"
    venv.create(environment)
    python = environment / "bin" / "python"
    subprocess.run([*PIP, "--python", python, "install", "--no-deps", "--no-index", wheel], check=True)
    packages = next((environment / "lib").glob("python*/site-packages"))
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    return environment / "bin"


def run(program: Path, *words: str, cwd: Path) -> str:
    """What a program prints where no other program is in reach."""
    path = {"PATH": str(program.parent), "HOME": str(cwd)}
    done = subprocess.run(
        [program, *words], cwd=cwd, env=path, capture_output=True, text=True, timeout=100, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_what_is_compiled_is_in_it_and_nothing_that_only_a_build_reads(wheel: Path) -> None:
    names = ZipFile(wheel).namelist()
    compiled = {name.partition(".")[0] for name in names if name.endswith(".so")}
    sources = {source.with_suffix("").as_posix() for source in compiled_sources(ROOT)}
    assert compiled == sources | {"skytender/memoryviews"}
    assert not [name for name in names if name.endswith((".c", ".pxd", ".pyc", ".o"))]
    assert {name.partition("/")[0] for name in names if ".dist-info" not in name} == set(PACKAGES)


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


def test_the_demo_flies_in_it_as_in_the_checkout(installed: Path, tmp_path: Path) -> None:
    """With all of the processor's instructions; tests/system/test_digests.py flies it with fewer."""
    run(installed / "gcs", "run", "demo", "--lockstep", "--quiet", "--no-report", "--out", "wheel", cwd=tmp_path)
    digest = json.loads((tmp_path / "wheel" / "summary.json").read_text())["digest"]
    assert digest.removeprefix("sha256:").startswith(DIGESTS["demo"])
