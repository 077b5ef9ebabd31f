"""What leaves the repository, as its linters want it: action, workflows, container, conda recipe; and what a release's
last job does, run here."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest
import yaml
from pages import DOCS, block
from rattler_build import PlatformConfig, RattlerBuildError, RenderConfig, Stage0Recipe, VariantConfig
from sessions import ROOT

PROGRAMS = Path(sys.executable).parent
JACTIONLINT = [PROGRAMS / "jactionlint", "--strict-exit", "--shellcheck", PROGRAMS / "shellcheck"]
SCHEMA = [PROGRAMS / "check-jsonschema", "--builtin-schema"]
ACTION, WORKFLOWS, RECIPE = "action.yml", ".github/workflows", ROOT / "conda" / "recipe.yaml"


def said(*words: str | Path, cwd: Path) -> str:
    """What a linter finds: nothing where it is content. It ends with another status than 0 where it finds something."""
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, check=False)
    found = done.stdout + done.stderr
    assert found or done.returncode == 0
    return found if done.returncode else ""


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A copy of the files that are linted."""
    shutil.copytree(ROOT / WORKFLOWS, tmp_path / WORKFLOWS)
    for name in (ACTION, "Dockerfile"):
        shutil.copy(ROOT / name, tmp_path)
    return tmp_path


def test_action_workflows_and_container_are_as_their_linters_want(copy: Path) -> None:
    recipe = copy / "workflow.yml"
    recipe.write_text(block(DOCS / "how-to" / "ci.md", "workflow.yml"))
    workflows = sorted((copy / WORKFLOWS).glob("*.yml"))
    assert len(workflows) == len(list((ROOT / WORKFLOWS).iterdir()))
    assert said(*JACTIONLINT, ACTION, *workflows, cwd=copy) == ""
    assert said(*JACTIONLINT, "--profile", "correctness", recipe, cwd=copy) == ""
    assert said(*SCHEMA, "vendor.github-actions", ACTION, cwd=copy) == ""
    assert said(*SCHEMA, "vendor.github-workflows", recipe, *workflows, cwd=copy) == ""
    assert said(PROGRAMS / "hadolint", "Dockerfile", cwd=copy) == ""


def test_forms_for_issues_and_the_citation_are_as_their_schemas_want() -> None:
    forms = sorted((ROOT / ".github" / "ISSUE_TEMPLATE").glob("*.yml"))
    config = [path for path in forms if path.stem == "config"]
    assert said(*SCHEMA, "vendor.github-issue-forms", *(path for path in forms if path not in config), cwd=ROOT) == ""
    assert said(*SCHEMA, "vendor.github-issue-config", *config, cwd=ROOT) == ""
    assert said(*SCHEMA, "vendor.citation-file-format", "CITATION.cff", cwd=ROOT) == ""


@pytest.mark.parametrize(
    ("name", "right", "wrong", "rule"),
    [
        (f"{WORKFLOWS}/release.yml", "matrix.python }}\n", "matrix.version }}\n", "undefined-property"),
        (f"{WORKFLOWS}/release.yml", "needs: source", "needs: sources", "job-needs"),
        (f"{WORKFLOWS}/demo.yml", "--plain --out session", "--out ${{ github.head_ref }}", "template-injection"),
        (f"{WORKFLOWS}/demo.yml", "@a26af69be951a213d495a4c3e4e4022e16d87065 # v5.6.0", "@v5", "unpinned-uses"),
        (ACTION, "steps.fly.outputs", "steps.flown.outputs", "undefined-property"),
        (ACTION, "own}; do", "own};", "shellcheck"),
        ("Dockerfile", "--no-install-recommends ", "", "DL3015"),
        ("Dockerfile", "python:3.12-slim AS build", "python AS build", "DL3006"),
    ],
)
def test_a_fault_is_found(copy: Path, name: str, right: str, wrong: str, rule: str) -> None:
    text = (copy / name).read_text()
    assert right in text
    (copy / name).write_text(text.replace(right, wrong, 1))
    linter = [PROGRAMS / "hadolint"] if name == "Dockerfile" else JACTIONLINT
    assert rule in said(*linter, name, cwd=copy)


def workflow() -> dict[str, Any]:
    """The release's workflow."""
    content: dict[str, Any] = yaml.safe_load((ROOT / WORKFLOWS / "release.yml").read_text(encoding="utf-8"))
    return content


def project() -> dict[str, Any]:
    """What pyproject.toml says."""
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def test_a_release_has_wheels_of_each_python_for_both_processors() -> None:
    matrix = workflow()["jobs"]["wheels"]["strategy"]["matrix"]
    assert [f"cp{python}-manylinux_*" for python in matrix["python"]] == project()["tool"]["cibuildwheel"]["build"]
    assert len(matrix["runner"]) == 2


@pytest.fixture
def published(tmp_path: Path) -> Path:
    """A folder as the release's last job has it, with what other jobs have made; gh notes what it is called with."""
    made = {
        "skytender-0.1.0.tar.gz", "skytender-0.1.0-cp312-cp312-manylinux_2_28_x86_64.whl",
        "skytender-0.1.0-cp312-cp312-manylinux_2_28_aarch64.whl", "skytender-docs.tar.gz",
    }  # fmt: skip
    (tmp_path / "dist").mkdir()
    for name in made:
        (tmp_path / "dist" / name).write_text(name)
    (tmp_path / "CHANGELOG.md").write_text("# Changes\n\n## 0.2.0\n\n- New.\n\n## 0.1.0 (2026-12-01)\n\n- First.\n")
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "gh").write_text('#!/bin/sh\nprintf "%s\\n" "$@" > called\n')
    (tmp_path / "bin" / "gh").chmod(0o755)
    return tmp_path


def release(folder: Path, tag: str) -> int:
    """Run the last job's commands; the status of the first that failed, or 0."""
    path = f"{folder / 'bin'}:/usr/bin:/bin"
    environment = {"PATH": path, "GITHUB_REF_NAME": tag, "GITHUB_REPOSITORY": "owner/skytender"}
    for step in workflow()["jobs"]["release"]["steps"]:
        if "run" in step:
            words = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
            if status := subprocess.run(words, cwd=folder, env=environment, check=False).returncode:
                return status
    return 0


def test_a_release_has_all_files_with_their_checksums_and_the_changelogs_part(published: Path) -> None:
    made = {f"dist/{path.name}" for path in (published / "dist").iterdir()}
    assert release(published, "v0.1.0") == 0
    assert made | {"dist/SHA256SUMS", "v0.1.0"} <= set((published / "called").read_text().splitlines())
    assert (published / "notes.md").read_text().strip() == "- First."
    checked = subprocess.run(
        ["sha256sum", "--check", "SHA256SUMS"], cwd=published / "dist", capture_output=True, check=True
    )
    assert checked.stdout.count(b": OK") == len(made)
    (provenance,) = (
        s for s in workflow()["jobs"]["release"]["steps"] if "attest-build-provenance" in s.get("uses", "")
    )
    assert provenance["with"]["subject-path"] == "dist/*"


def test_nothing_is_released_without_its_part_of_the_changelog(published: Path) -> None:
    assert release(published, "v0.3.0") != 0
    assert not (published / "called").exists()


# conda


@pytest.mark.parametrize("platform", ["linux-64", "linux-aarch64"])
def test_the_conda_recipe_renders_for_each_python_with_the_packages_needs(platform: str) -> None:
    config = RenderConfig(platform=PlatformConfig(target_platform=platform))
    variants = Stage0Recipe.from_file(RECIPE).render(VariantConfig.from_file(RECIPE.with_name("variants.yaml")), config)
    rendered = [variant.recipe.to_dict() for variant in variants]
    pyproject = project()
    pythons = [f"py{build[2:5]}" for build in pyproject["tool"]["cibuildwheel"]["build"]]
    assert [recipe["build"]["string"].partition("h")[0] for recipe in rendered] == pythons
    for recipe in rendered:
        assert recipe["package"] == {"name": "skytender", "version": version("skytender")}
        assert recipe["requirements"]["host"] == ["python", "pip", *map(conda, pyproject["build-system"]["requires"])]
        needed = [
            f"python {pyproject['project']['requires-python']}",
            *map(conda, pyproject["project"]["dependencies"]),
        ]
        assert recipe["requirements"]["run"] == needed
        assert recipe["about"]["summary"] == pyproject["project"]["description"]
        assert [test["script"] for test in recipe["tests"] if "script" in test] == [
            pyproject["tool"]["cibuildwheel"]["test-command"]
        ]


def conda(requirement: str) -> str:
    """A requirement as conda writes it: a blank before the versions."""
    return re.sub(r"(?<=\w)(?=[<>=])", " ", requirement, count=1)


def test_a_key_that_conda_does_not_know_is_refused(tmp_path: Path) -> None:
    wrong = tmp_path / "recipe.yaml"
    wrong.write_text(RECIPE.read_text().replace("requirements:", "requirement:", 1))
    with pytest.raises(RattlerBuildError, match="requirement"):
        Stage0Recipe.from_file(wrong)


def test_the_citation_has_the_packages_version() -> None:
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert version("skytender") == cited["version"]
