"""Scenarios from elsewhere may name code, and lie beside files named like modules: neither runs unasked."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from commands import gcs
from sessions import ROOT, fly, small

CODE = """
from pathlib import Path
Path(__file__).with_name("ran").touch()

class Mine:
    def __init__(self, scenario):
        pass

    def plan(self, vehicle, situation):
        return vehicle.p_ned, (0.0, 0.0, 0.0)
"""
SHADOWED = ("json", "token", "selectors", "click", "numpy", "gcs", "yaml", "platform")


@pytest.fixture
def named(tmp_path: Path) -> Path:
    """A scenario that names code beside it; the code leaves a file `ran`."""
    module = re.sub(r"\W", "_", tmp_path.name)  # imported into this process, which remembers names
    (tmp_path / f"{module}.py").write_text(CODE)
    path = tmp_path / f"{module}.yaml"
    path.write_text(yaml.safe_dump(small(planner=f"{module}:Mine", goal={"duration_s": 1.0, "refuelled_at_least": 0})))
    return path


def test_validate_names_code_and_runs_it_with_trust_alone(named: Path) -> None:
    told = gcs("validate", str(named), "--quiet")
    assert told.returncode == 0
    assert f"names code, which is not looked at without --trust: {named.stem}:Mine (planner.method)" in told.stderr
    assert not named.with_name("ran").exists()
    trusted = gcs("validate", str(named), "--quiet", "--trust")
    assert (trusted.returncode, "names code" in trusted.stderr) == (0, False)
    assert named.with_name("ran").exists()


@pytest.mark.parametrize(("method", "why"), [
    ("my_planer:Ring", "there is no module 'my_planer'; put it beside the scenario or install its package"),
    ("{module}.sub:Ring", "there is no module '{module}.sub'; put it beside the scenario or install its package"),
    ("{module}:Mien", "has no 'Mien'; did you mean 'Mine'?"),
])  # fmt: skip
def test_validate_finds_by_its_source_code_that_is_not_there(named: Path, method: str, why: str) -> None:
    content = yaml.safe_load(named.read_text())
    content["planner"] = method.format(module=named.stem)
    named.write_text(yaml.safe_dump(content))
    told = gcs("validate", str(named), "--quiet")
    assert told.returncode == 2
    assert why.format(module=named.stem) in told.stderr
    assert f"{named}:" in told.stderr
    assert not named.with_name("ran").exists()


def test_run_says_that_it_runs_code_and_decide_runs_it_with_trust_alone(
    named: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    flown = fly(yaml.safe_load(named.read_text()), tmp_path, "--lockstep", "--plain")
    assert f"the scenario names code, which the session runs as you: {named.stem}:Mine (planner.method)" in flown.stderr
    named.with_name("ran").unlink()
    refused = gcs("replay", str(flown.folder), "--decide")
    assert refused.returncode == 2
    assert f"names code: {named.stem}:Mine (planner.method); --trust runs it" in refused.stderr
    assert not named.with_name("ran").exists()
    assert "names code" not in gcs("replay", str(flown.folder), "--decide", "--trust").stderr
    assert named.with_name("ran").exists()


def test_files_named_like_modules_beside_a_scenario_never_run(tmp_path: Path) -> None:
    """Also not in the processes that a session starts, which once looked into the current folder first."""
    for name in SHADOWED:
        (tmp_path / f"{name}.py").write_text(
            f"open({str(tmp_path / 'ran')!r}, 'a').write({name!r})\nraise SystemExit(9)\n"
        )
    (tmp_path / "own.yaml").write_text(
        yaml.safe_dump(small(planner="theirs:Mine", goal={"duration_s": 0.5, "refuelled_at_least": 0}))
    )
    (tmp_path / "theirs.py").write_text(CODE.replace('"ran"', '"used"'))
    program = [sys.executable, "-P", "-m", "gcs"]
    command = [*program, "run", "own.yaml", "--lockstep", "--plain", "--out", "flown"]
    path = {"PATH": "/usr/bin:/bin", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, cwd=tmp_path, env=path, capture_output=True, text=True, check=False)
    assert not (tmp_path / "ran").exists(), (tmp_path / "ran").read_text()
    assert (tmp_path / "used").exists()
    assert done.returncode in (0, 1), done.stderr
