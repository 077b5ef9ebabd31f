"""The container's recipe: each COPY and RUN of both stages, in a folder that stands for the container's root."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
from sessions import ROOT

from skytender.compiled import PACKAGES

COMPILED = ("*.so", "*.c", "compiled.txt")


def instructions() -> list[tuple[str, str]]:
    """(instruction, its words) of the Dockerfile, in order."""
    text = re.sub(r"^#.*\n", "", (ROOT / "Dockerfile").read_text(), flags=re.M).replace("\\\n", " ")
    return [(name, words) for name, _, words in (line.partition(" ") for line in text.splitlines() if line)]


def let_in() -> tuple[set[str], list[str]]:
    """What .dockerignore lets through, and the patterns of names that it leaves out of that."""
    first, *lines = (ROOT / ".dockerignore").read_text().splitlines()
    assert first == "*"
    left_out = [line.removeprefix("**/") for line in lines if line.startswith("**/")]
    return {line.removeprefix("!") for line in lines if line.startswith("!")}, left_out


class Container:
    """A folder in which a Dockerfile's instructions are done. What they ask of Debian is noted in `asked`; packages
    come from this environment, and a compiled module is compiled anew only where it is not yet here."""

    def __init__(self, folder: Path) -> None:
        self.root = folder / "root"
        self.root.mkdir()
        self.cwd = self.root
        self.asked: list[str] = []
        self.stages: list[str] = []
        self.final: dict[str, str] = {}
        self._note = folder / "asked"
        self._note.touch()
        self._bin = folder / "bin"
        self._bin.mkdir()
        for name in ("apt-get", "useradd"):
            (self._bin / name).write_text(f'#!/bin/sh\necho {name} "$@" >> {self._note}\n')
            (self._bin / name).chmod(0o755)
        (self._bin / "python").write_text(f'#!/bin/sh\nexec {sys.executable} "$@"\n')
        (self._bin / "python").chmod(0o755)
        self.environment = {
            "PATH": f"{self._bin}:/usr/bin:/bin", "HOME": str(folder), "PYTHONPATH": sysconfig.get_path("purelib"),
            "PIP_NO_DEPS": "1", "PIP_NO_INDEX": "1", "PIP_NO_BUILD_ISOLATION": "0",
        }  # fmt: skip

    def do(self, instruction: str, words: str) -> None:
        """Do an instruction; its absolute paths are below `root`."""
        here = re.sub(r"(?<![\w.$/])/(?=\w)", f"{self.root}/", words)
        match instruction:
            case "FROM":
                self.stages.append(words.partition(" AS ")[2])
                self.cwd = self.root
            case "WORKDIR":
                self.cwd = Path(here)
                self.cwd.mkdir(parents=True, exist_ok=True)
            case "COPY" if words.startswith("--from="):
                stage, source, target = words.split()
                assert stage.removeprefix("--from=") in self.stages
                assert Path(here.split()[1]).is_dir()
                assert source == target, "an environment holds its own path"
            case "COPY":
                self.copy(*words.split())
            case "RUN":
                self.run("sh", "-ec", here)
                self.asked = self._note.read_text().splitlines()
            case "ENV":
                name, _, value = here.partition("=")
                self.environment[name] = value.replace("$PATH", self.environment["PATH"])
            case _:
                self.final[instruction] = words

    def copy(self, *words: str) -> None:
        """Copy files into a folder, or a folder's content, of what .dockerignore lets through."""
        sent, left_out = let_in()
        *sources, target = words
        for source in sources:
            assert source in sent
            if (ROOT / source).is_dir():
                shutil.copytree(ROOT / source, self.cwd / target, ignore=shutil.ignore_patterns(*left_out))
            else:
                shutil.copy2(ROOT / source, self.cwd / target)

    def run(self, *words: str) -> str:
        """What a command prints that ends well."""
        done = subprocess.run(
            words, cwd=self.cwd, env=self.environment, capture_output=True, text=True, timeout=200, check=False
        )
        assert done.returncode == 0, (words, done.stdout, done.stderr)
        return done.stdout


@pytest.fixture
def container(tmp_path: Path) -> Container:
    return Container(tmp_path)


def kept() -> set[str]:
    """The files that git keeps of what a package is made of."""
    made_of = [*PACKAGES, "configs", "setup.py", "pyproject.toml", "MANIFEST.in", "README.md", "LICENSE"]
    listed = subprocess.run(["git", "ls-files", *made_of], cwd=ROOT, capture_output=True, text=True, check=True)
    return set(listed.stdout.splitlines())


def compiled_here(source: Path) -> None:
    """Put beside the sources what has been compiled of them here, so that it is not compiled again."""
    shutil.copytree(ROOT / "build", source / "build")
    for pattern in COMPILED:
        for package in PACKAGES:
            for path in (ROOT / package).rglob(pattern):
                shutil.copy2(path, source / path.relative_to(ROOT))


@pytest.mark.slow
def test_the_containers_steps_make_one_that_runs_its_programs_and_not_as_root(container: Container) -> None:
    for instruction, words in instructions():
        if instruction == "RUN" and "pip install" in words:
            copied = {str(path.relative_to(container.cwd)) for path in container.cwd.rglob("*") if path.is_file()}
            assert kept() <= copied
            assert not [name for name in copied if name.endswith((".so", ".c", ".pyc"))]
            compiled_here(container.cwd)
        container.do(instruction, words)
    assert "apt-get install -y --no-install-recommends gcc libc6-dev" in container.asked
    user = container.final["USER"].partition(":")[0]
    assert [line for line in container.asked if line.startswith("useradd") and f"--uid {user} " in line]
    assert int(user) > 0
    program, command = (json.loads(container.final[name]) for name in ("ENTRYPOINT", "CMD"))
    assert "Usage: gcs" in container.run(*program, *command)
    assert container.run(*program, "validate", "demo", "--quiet") == ""
    where = container.run("python", "-c", "import gcs; print(gcs.__file__)")
    assert where.startswith(f"{container.root}/opt/")
