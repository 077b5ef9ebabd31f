"""The wheel in an environment of its own: programs, scenarios, schemas and types come with it, and fly from any folder
without a compiler."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import venv
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import pytest
import yaml
from pages import DOCS, block
from sessions import DIGESTS, ROOT, small

from gcs.scenario.file import shipped_names
from skytender.compiled import PACKAGES, compiled_sources

PIP = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of what the package is made of, and of what is compiled here already."""
    copy = tmp_path_factory.mktemp("checkout")
    for name in (*PACKAGES, "configs", "build"):
        shutil.copytree(ROOT / name, copy / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("setup.py", "pyproject.toml", "MANIFEST.in", "README.md", "LICENSE"):
        shutil.copy2(ROOT / name, copy)
    return copy


@pytest.fixture(scope="module")
def wheel(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of the checkout."""
    copy, folder = checkout, tmp_path_factory.mktemp("wheel")
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


@pytest.mark.slow
def test_the_source_archive_has_all_that_is_kept(checkout: Path, tmp_path: Path) -> None:
    """The release's wheels are made of it alone."""
    command = [sys.executable, "setup.py", "--quiet", "sdist", "--dist-dir", tmp_path]
    subprocess.run(command, cwd=checkout, check=True, capture_output=True)
    (archive,) = tmp_path.glob("skytender-*.tar.gz")
    with tarfile.open(archive) as file:
        held = {name.partition("/")[2] for name in file.getnames()}
    listed = subprocess.run(
        ["git", "ls-files", *PACKAGES, "configs"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert {*listed.stdout.splitlines(), "setup.py", "pyproject.toml", "README.md", "LICENSE"} <= held
    assert not [name for name in held if name.endswith((".so", ".pyc", ".o"))]


@pytest.mark.slow
def test_what_is_compiled_is_in_it_and_nothing_that_only_a_build_reads(wheel: Path) -> None:
    names = ZipFile(wheel).namelist()
    compiled = {name.partition(".")[0] for name in names if name.endswith(".so")}
    sources = {source.with_suffix("").as_posix() for source in compiled_sources(ROOT)}
    assert compiled == sources | {"skytender/memoryviews"}
    assert not [name for name in names if name.endswith((".c", ".pxd", ".pyc", ".o"))]
    assert {name.partition("/")[0] for name in names if ".dist-info" not in name} == set(PACKAGES)


@pytest.mark.slow
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


# in other people's repositories


@pytest.fixture
def runner(tmp_path: Path) -> dict[str, str]:
    """The environment of a CI machine in an empty repository: a Python of its own, whose packages' dependencies and
    whose pip are those of this one."""
    environment = tmp_path / "python"
    venv.create(environment)
    packages = next((environment / "lib").glob("python*/site-packages"))
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")
    pip = environment / "bin" / "pip"
    pip.write_text(f'#!/bin/sh\nexec {environment}/bin/python -m pip "$@"\n')
    pip.chmod(0o755)
    repository = tmp_path / "repository"
    subprocess.run(["git", "init", "--quiet", repository], check=True)
    (repository / "README.md").write_text("# Somebody else's\n")
    path = f"{environment / 'bin'}:/usr/bin:/bin"
    return {"PATH": path, "HOME": str(tmp_path), "PIP_NO_DEPS": "1", "PIP_NO_INDEX": "1", "PWD": str(repository)}


def steps(listed: list[dict[str, Any]], environment: dict[str, str]) -> list[str]:
    """Run the steps that are commands, as a runner does; what each has printed."""
    said = []
    for step in listed:
        if "run" in step:
            words = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
            done = subprocess.run(
                words, cwd=environment["PWD"], env=environment, capture_output=True, text=True, timeout=200, check=False
            )
            assert done.returncode == 0, (step["run"], done.stdout, done.stderr)
            said.append(done.stdout)
    return said


@pytest.mark.slow
def test_the_workflow_of_the_docs_flies_the_demo_in_another_repository_as_in_the_checkout(
    wheel: Path, runner: dict[str, str]
) -> None:
    workflow = yaml.safe_load(block(DOCS / "how-to" / "ci.md", "workflow.yml"))
    assert workflow["env"].keys() == {"SKYTENDER"}
    steps(workflow["jobs"]["fly"]["steps"], runner | {"SKYTENDER": str(wheel)})
    repository = Path(runner["PWD"])
    (upload,) = (step["with"] for step in workflow["jobs"]["fly"]["steps"] if "upload" in step.get("uses", ""))
    for kept in upload["path"].split():
        assert (repository / kept).exists()
    cases = ET.parse(repository / "outcome.xml").getroot().iter("testcase")
    assert {case.find("failure") for case in cases} == {None}
    digest = json.loads((repository / "session" / "summary.json").read_text())["digest"]
    assert digest.startswith(f"sha256:{DIGESTS['demo']}")


@pytest.mark.slow
def test_the_actions_steps_fly_every_seed_each_time_that_it_is_used(
    wheel: Path, runner: dict[str, str], tmp_path: Path
) -> None:
    """What a runner puts for the expressions in `env` is put here."""
    action = yaml.safe_load((ROOT / "action.yml").read_text(encoding="utf-8"))
    assert action["inputs"]["scenario"]["default"] in shipped_names()
    brief = small(goal={"duration_s": 2.0, "refuelled_at_least": 0})
    (Path(runner["PWD"]) / "field.yaml").write_text(yaml.safe_dump(brief))
    given = {"PACKAGE": str(wheel), "SCENARIO": "field.yaml", "SEEDS": "3 4"}
    own = {"GITHUB_OUTPUT": str(tmp_path / "output"), "RUNNER_TEMP": str(tmp_path / "temp")}
    Path(own["RUNNER_TEMP"]).mkdir()
    listed = action["runs"]["steps"]
    assert {name for step in listed for name in step.get("env", ())} == given.keys()
    for use in (given, given | {"SEEDS": ""}):
        steps(listed, runner | own | use)
    said = Path(own["GITHUB_OUTPUT"]).read_text().splitlines()
    first, second = (Path(line.removeprefix("folder=")) for line in said)
    flown = {seed: yaml.safe_load((first / seed / "scenario.yaml").read_text())["seed"] for seed in ("3", "4")}
    assert flown == {"3": 3, "4": 4}
    assert {path.name for path in first.glob("*.xml")} == {"3.xml", "4.xml"}
    assert sorted(path.name for path in second.iterdir()) == ["own", "own.xml"]
    (upload,) = (step["with"] for step in listed if "upload" in step.get("uses", ""))
    assert upload["path"] == action["outputs"]["folder"]["value"] == "${{ steps.fly.outputs.folder }}"
