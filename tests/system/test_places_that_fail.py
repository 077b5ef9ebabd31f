"""Sessions whose place fails them: its name, its disk, its end while they fly, and too few files that may be open."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml
from commands import gcs
from sessions import GCS, Running, fly, small
from small_disk import run_on_small_disk

import gcs as gcs_package


def test_a_folder_whose_name_is_no_utf8_is_flown_into_and_shown_as_text(tmp_path: Path) -> None:
    outcome = fly(small(goal={"duration_s": 2.0, "refuelled_at_least": 0}), tmp_path / "x\udcff", "--json")
    assert outcome.status == 0, outcome.stderr
    assert outcome.summary["outcome"] == "met"
    end = json.loads(outcome.stdout.splitlines()[-1])
    assert end["session"].endswith("/x\ufffd/session")
    json.dumps([json.loads(line) for line in outcome.stdout.splitlines()], ensure_ascii=False).encode()
    reported = gcs("report", str(outcome.folder))
    assert reported.returncode == 0, reported.stderr
    (outcome.folder / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("record", [{}, {"rotate_mb": 1}])
def test_a_folder_that_is_removed_in_flight_ends_the_session_and_is_named(
    tmp_path: Path, record: dict[str, Any]
) -> None:
    clock = {"mode": "real", "speed": 5.0}
    session = Running(small(clock=clock, goal={"duration_s": 3000.0}, record=record), tmp_path, "--json", report=True)
    try:
        session.wait_for(lambda s: s["t_s"] > 2.0)
        shutil.rmtree(session.folder)
        outcome = session.finish()
    finally:
        session.stop()
    assert outcome.status == 1
    said = f"{session.folder} is gone, and with it what was recorded there; the session has ended"
    assert f"gcs: {said}" in outcome.stderr.splitlines()
    assert json.loads(outcome.stdout.splitlines()[-1])["error"] == said
    assert "kept" not in outcome.stderr
    assert ".summary" not in outcome.stderr
    assert not session.folder.exists()


def test_the_same_command_flies_once_there_is_room_on_a_disk_that_was_full(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 2.0, "refuelled_at_least": 0})
    (tmp_path / "scenario.yaml").write_text(yaml.safe_dump(content), encoding="utf-8")
    script = 'head -c 4M /dev/zero >disk/filler; "$@"; echo $?; ls disk; rm disk/filler; "$@"; echo $?'
    flown = [*GCS, "run", "scenario.yaml", "--quiet", "--no-report", "--out", "disk/session"]
    done = run_on_small_disk("4m", script, flown, tmp_path)
    assert done.stdout.split() == ["2", "filler", "0"], done.stderr
    assert "No space left on device; give --out another place" in done.stderr


QUIET = ("--quiet", "--no-report")


def from_a_folder_that_is_gone(tmp_path: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """`gcs …`, started where there is no folder any more."""
    (tmp_path / "here").mkdir()
    script = 'cd here && rmdir ../here && exec "$@"'
    command = ["sh", "-c", script, "sh", sys.executable, "-P", "-m", "gcs", *words]
    environment = {**os.environ, "PYTHONPATH": str(Path(gcs_package.__file__).parents[1])}
    return subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)


def test_a_session_needs_no_current_folder_where_its_files_are_named_in_full(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 2.0, "refuelled_at_least": 0})
    (tmp_path / "scenario.yaml").write_text(yaml.safe_dump(content), encoding="utf-8")
    done = from_a_folder_that_is_gone(
        tmp_path, "run", str(tmp_path / "scenario.yaml"), *QUIET, "--out", str(tmp_path / "session")
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads((tmp_path / "session" / "summary.json").read_text(encoding="utf-8"))["outcome"] == "met"


def test_a_session_without_a_place_says_that_the_current_folder_is_gone(tmp_path: Path) -> None:
    done = from_a_folder_that_is_gone(tmp_path, "run", "demo", "--lockstep", *QUIET)
    assert done.returncode == 2
    assert re.fullmatch(
        "gcs: cannot make the folder sessions/demo-[-0-9]+: the current folder is gone; give a place to write\n",
        done.stderr,
    )


@pytest.mark.parametrize("most", [6, 8, 10])
def test_where_too_few_files_may_be_open_a_sentence_says_so(tmp_path: Path, most: int) -> None:
    flown = limited(tmp_path, most)
    assert flown.returncode == 1
    assert flown.stderr == "gcs: too few files may be open at once here: raise the limit (ulimit -n)\n"
    assert not (tmp_path / "session").exists()


@pytest.mark.parametrize("most", [11, 12, 13])
def test_a_supervisor_finds_what_it_inherits_where_hardly_any_file_may_be_opened(tmp_path: Path, most: int) -> None:
    flown = limited(tmp_path, most)
    assert "Traceback" not in flown.stderr
    assert flown.returncode == 0 or "ulimit -n" in flown.stderr


def limited(tmp_path: Path, most: int) -> subprocess.CompletedProcess[str]:
    """A session whose every process may have so many files open."""
    content = small(goal={"duration_s": 2.0, "refuelled_at_least": 0})
    (tmp_path / "scenario.yaml").write_text(yaml.safe_dump(content), encoding="utf-8")
    words = [*GCS, "run", "scenario.yaml", "--quiet", "--no-report", "--out", "session"]
    command = ["prlimit", f"--nofile={most}", *words]
    return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("replay {}/session --decide", r"all \d+ decisions up to \S+ s agree"),
        ("doctor", "problem  this folder: it is gone"),
        (
            "campaign run policies --sessions 1 --out {}/campaign",
            "gcs: the current folder is gone, without which Python starts no worker; change to another one",
        ),
    ],
)
def test_other_commands_do_without_a_current_folder_or_say_that_it_is_gone(
    words: str, said: str, tmp_path: Path
) -> None:
    fly(small(goal={"duration_s": 10.0, "refuelled_at_least": 0}), tmp_path)
    done = from_a_folder_that_is_gone(tmp_path, *words.format(tmp_path).split())
    assert re.search(said, done.stdout + done.stderr), done
    assert "internal error" not in done.stderr
