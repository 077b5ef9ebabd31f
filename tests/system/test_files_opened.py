"""Files that commands open: their own package, what they are given, and nothing that lies in the current folder or in a
cache, of any owner; and they leave none."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from sessions import ROOT, small

PROGRAM = str(Path(sys.executable).with_name("gcs"))
CACHES = ("HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "NUMBA_CACHE_DIR")
"""Variables that name folders where programs look for what they, or others, have kept."""
DATA = {".pymavlink/custom_mode_map.json", "matplotlib/fontlist-*.json", "matplotlib/fontlist-*.json.matplotlib-lock"}
"""Files in them that libraries read or write: JSON, of names of modes and of fonts."""
WATCH = """
import inspect, os, sys

def watch(event, arguments):
    if event != "open":
        return
    path, _, flags = arguments
    caller = inspect.currentframe().f_back
    removed = caller is not None and caller.f_globals.get("__name__") == "shutil"
    if isinstance(path, str | bytes) and path != {log!r} and not flags & os.O_DIRECTORY and not removed:
        at = os.open({log!r}, os.O_WRONLY | os.O_APPEND)
        os.write(at, os.fsencode(os.path.abspath(path)) + b"\\n")
        os.close(at)

sys.addaudithook(watch)
"""
"""Writes each file that this interpreter opens, and what is forked off it, into a log; not the folders that shutil
removes, whose names are relative to others."""
SETTINGS = (".numba_config.yaml", ".env", "pyproject.toml", "setup.cfg", "config.yaml", "dask.yaml", "uvicorn.json")
"""Files by which a library might be set from the current folder."""
BRIEF = small(goal={"duration_s": 5.0, "refuelled_at_least": 0})
CAMPAIGN = {"schema": 1, "name": "kept", "scenario": "own.yaml", "sessions": 1, "keep": "none"}


class Place:
    """A current folder, and the folders that the variables name."""

    def __init__(self, folder: Path) -> None:
        self.here, self.log = folder / "here", folder / "opened"
        self.caches = {name: folder / name.lower() for name in CACHES}
        for made in (self.here, folder / "found", *self.caches.values()):
            made.mkdir()
        self.log.touch()
        (folder / "found" / "sitecustomize.py").write_text(WATCH.format(log=str(self.log)))
        (self.here / "own.yaml").write_text(yaml.safe_dump(BRIEF))
        (self.here / "campaign.yaml").write_text(yaml.safe_dump(CAMPAIGN))
        for name in SETTINGS:
            (self.here / name).write_text("")
        inherited = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "NUMBA"))}
        named = {name: str(path) for name, path in self.caches.items()}
        self.environment = {**inherited, **named, "PYTHONPATH": str(folder / "found")}

    def run(self, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [PROGRAM, *words], cwd=self.here, env=self.environment, capture_output=True, text=True, check=False
        )

    def opened(self) -> set[Path]:
        """All files that were opened."""
        return {Path(line) for line in self.log.read_text(errors="surrogateescape").splitlines()}


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Place:
    made = Place(tmp_path_factory.mktemp("place"))
    flown = made.run("run", "own.yaml", "--lockstep", "--quiet", "--no-report", "--out", "flown")
    assert (made.here / "flown" / "summary.json").exists(), flown.stderr
    return made


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "given"),
    [
        ("run own.yaml --lockstep --plain --out out", "own.yaml out"),
        ("validate own.yaml", "own.yaml"),
        ("campaign run campaign.yaml --workers 1 --plain --out many", "campaign.yaml own.yaml many"),
        ("replay flown --plain", "flown"),
        ("replay flown --decide", "flown"),
        ("report flown", "flown"),
        ("export flown --format csv --out tables", "flown .tables.unfinished"),
        ("doctor", ""),
    ],
)
def test_a_command_opens_what_it_is_given_and_nothing_that_lies_around(place: Place, words: str, given: str) -> None:
    place.log.write_bytes(b"")
    done = place.run(*words.split())
    assert done.returncode in (0, 1), done.stderr
    opened = place.opened()
    assert any(path.is_relative_to(ROOT / "gcs") for path in opened), "the log itself works"
    own = [place.here / name for name in given.split()]
    here = {path for path in opened if path.is_relative_to(place.here) and path != place.here}
    assert {path for path in here if not any(path.is_relative_to(one) for one in own)} == set()
    for name, cache in place.caches.items():
        found = {path for path in opened if path.is_relative_to(cache)} | {
            path for path in cache.rglob("*") if path.is_file()
        }
        assert [path for path in found if not any(path.relative_to(cache).match(one) for one in DATA)] == [], name
