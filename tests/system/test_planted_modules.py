"""Modules of a stranger in the current folder, named like every module there is: no command runs one of them."""

from __future__ import annotations

import importlib.metadata
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from sessions import GCS, small

PROGRAM = str(Path(sys.executable).with_name("gcs"))
NAMES = (
    sys.stdlib_module_names | importlib.metadata.packages_distributions().keys() | {"sitecustomize", "usercustomize"}
)
PLANTED = "import os\nwith open({ran!r}, 'a') as ran:\n    ran.write({name!r} + chr(10))\n"
CAMPAIGN = {"schema": 1, "name": "planted", "scenario": "own.yaml", "sessions": 1, "keep": "none"}
BRIEF = small(goal={"duration_s": 0.5, "refuelled_at_least": 0})


@pytest.fixture(scope="module")
def planted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a session, a scenario, a campaign, and a module for each name that Python finds anywhere."""
    folder = tmp_path_factory.mktemp("planted")
    (folder / "own.yaml").write_text(yaml.safe_dump({**BRIEF, "clock": {"mode": "real"}}))
    (folder / "campaign.yaml").write_text(yaml.safe_dump(CAMPAIGN))
    subprocess.run(
        [*GCS, "run", "own.yaml", "--lockstep", "--quiet", "--no-report", "--out", "flown"], cwd=folder, check=False
    )
    assert (folder / "flown" / "summary.json").exists()
    for name in NAMES:
        (folder / f"{name}.py").write_text(PLANTED.format(ran=str(folder / "ran"), name=name))
    return folder


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "until"),
    [
        (("run", "own.yaml", "--plain", "--out", "run"), None),
        (("run", "own.yaml", "--web", "--out", "web"), None),
        (("campaign", "run", "campaign.yaml", "--workers", "1", "--out", "many", "--plain"), None),
        (("replay", "flown", "--web"), "page"),
        (("report", "flown"), None),
        (("validate", "own.yaml"), None),
        (("launch", "own.yaml"), "Ctrl-C"),
        (("monitor", "--connect", "udpin:127.0.0.1:0", "--plain"), "udpin"),
        (("export", "flown", "--format", "csv", "--out", "exported"), None),
        (("doctor",), None),
    ],
    ids=lambda words: " ".join(words[:2]) if isinstance(words, tuple) else "",
)
def test_no_command_runs_what_lies_in_the_current_folder(
    planted: Path, words: tuple[str, ...], until: str | None
) -> None:
    """`until`: a word of a command that goes on, after which it is ended."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    with subprocess.Popen(
        [PROGRAM, *words], cwd=planted, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as process:
        assert process.stdout is not None
        said = []
        for line in process.stdout:
            said.append(line)
            if until is not None and until in line:
                process.send_signal(signal.SIGINT)
                until = None
    ran = planted / "ran"
    assert not ran.exists(), f"{ran.read_text().split()} ran: {''.join(said)}"
    assert process.returncode in ((0, 1, 130) if words[0] != "validate" else (0,)), "".join(said)
    assert until is None, "".join(said)
