"""The console of a real session in a real terminal: closing, killing, suspending or resizing it changes no flight."""

from __future__ import annotations

import json
import signal
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml
from screens import ALTERNATE, MAIN, Screen
from sessions import GCS, all_gone, fly, small

CONSOLE = "gcs.console"
DURATION_S, LONG_S = 90.0, 900.0
"""Of sessions that end by themselves, and of those that are stopped."""
SPEED = 3.0  # there has to be time to look, whatever else the machine does


def content(duration_s: float = DURATION_S, **changes: Any) -> dict[str, Any]:
    return small(goal={"duration_s": duration_s, "refuelled_at_least": 0}, **changes)


def run(folder: Path, *options: str, duration_s: float = DURATION_S) -> list[str]:
    """`gcs run` of the small session, paced so that there is time to look at it."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "scenario.yaml"
    paced = content(duration_s, clock={"mode": "real", "speed": SPEED})
    path.write_text(yaml.safe_dump(paced, sort_keys=False), encoding="utf-8")
    return [*GCS, "run", str(path), "--out", str(folder / "session"), *options]


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The digest of the same session without a console."""
    outcome = fly(content(), tmp_path_factory.mktemp("undisturbed"), "--plain")
    digest: str = outcome.summary["digest"]
    return digest


@pytest.mark.slow
def test_resized_suspended_watched_by_others_and_killed_it_changes_nothing_in_flight(
    tmp_path: Path, undisturbed: str
) -> None:
    folder = tmp_path / "session"
    with Screen(run(tmp_path), columns=100, rows=30) as screen:
        screen.until(ALTERNATE.decode(), "flying")
        assert not screen.cooked
        console = screen.named(CONSOLE)
        with Screen([*GCS, "monitor", str(folder)]) as other:
            other.until("flying", "pursuer")
            screen.resize(60, 18)
            screen.until("the console needs 80 x 24")
            screen.resize(120, 40)
            screen.until("competition", "arm")
            console.send_signal(signal.SIGTSTP)
            screen.until(MAIN.decode(), "suspended", " of 90 s | ")
            assert screen.cooked
            console.send_signal(signal.SIGCONT)
            screen.until(ALTERNATE.decode(), "flying")
            console.kill()
            screen.until(MAIN.decode(), "the console was killed by signal 9; the session goes on", " of 90 s | ")
            assert screen.cooked
            family = screen.family()
            assert screen.finish() == 0
            assert other.finish() == 0
            assert other.cooked
            assert "outcome: met" in other.seen.decode()
    assert all_gone(family) == []
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    assert summary["digest"] == undisturbed
    assert "outcome: met" in screen.seen.decode()


def test_orders_are_obeyed_q_leaves_lines_and_ctrl_c_stops_them(tmp_path: Path) -> None:
    with Screen(run(tmp_path, duration_s=LONG_S)) as screen:
        screen.until("flying", "Offboard")
        screen.press("h")
        screen.until("Let pursuer 1 hold its position?")
        screen.press("y")
        screen.until("hold pursuer 1:", "operator")
        screen.press("q")
        screen.until(MAIN.decode(), "the console was closed; the session goes on", " of 900 s | ")
        assert screen.cooked
        family = screen.family()
        assert not [p for p in family if CONSOLE in p.cmdline()]
        screen.press("\x03")
        assert screen.finish() == 130
    assert all_gone(family) == []
    lines = (tmp_path / "session" / "decisions.jsonl").read_text(encoding="utf-8").splitlines()
    first, last = (record for record in map(json.loads, lines) if record["kind"] == "operator")
    assert (first["command"], first["sysid"], first["taken"]) == ("hold", 1, True)
    assert last["command"] == "stop"


def test_ctrl_c_twice_stops_the_session_from_inside_the_console_in_ascii_where_the_locale_is_c(tmp_path: Path) -> None:
    with Screen(run(tmp_path, duration_s=LONG_S), LC_ALL="", LC_CTYPE="", LANG="C") as screen:
        screen.until("flying")
        screen.press("\x03")
        screen.until("Stop the session?")
        screen.press("\x03")
        assert screen.finish() == 130
        assert screen.cooked
    assert "outcome: interrupted" in screen.seen.decode()
    assert screen.seen.isascii()


def test_ctrl_c_while_the_vehicles_start_leaves_nothing_behind(tmp_path: Path) -> None:
    with Screen(run(tmp_path, duration_s=LONG_S)) as screen:
        screen.until(ALTERNATE.decode(), "starting")
        family = screen.family()
        screen.press("\x03")
        screen.press("\x03")
        assert screen.finish() == 130
        assert screen.cooked
    assert all_gone(family) == []


def test_everything_ends_when_gcs_run_is_killed(tmp_path: Path) -> None:
    with Screen(run(tmp_path, duration_s=LONG_S)) as screen:
        screen.until("flying")
        family = screen.family()
        assert [p for p in family if CONSOLE in p.cmdline()]
        screen.process.kill()
        screen.until(MAIN.decode())  # a terminal that is not read keeps the console from its last words
        assert all_gone(family) == []
        assert screen.cooked


def test_a_shell_takes_the_terminal_back_on_ctrl_z_while_the_session_flies_on(tmp_path: Path) -> None:
    recording = tmp_path / "session" / "session.tlog"
    with Screen(["bash", "--norc", "-i"], PS1="READY> ") as screen:
        screen.until("READY> ")
        screen.press(" ".join(run(tmp_path, duration_s=LONG_S)) + "\n")
        screen.until("flying")
        screen.press("\x1a")
        screen.until(MAIN.decode(), "`fg` shows it again", "Stopped", "READY> ")
        size = recording.stat().st_size
        screen.press(f"until [ $(stat -c %s {recording}) -gt {size} ]; do :; done; echo it grows | tr a-z A-Z\n")
        screen.until("IT GROWS")
        screen.press("fg\n")
        screen.until(ALTERNATE.decode(), "flying")
        screen.press("x")
        screen.until("Stop the session?")
        screen.press("y")
        screen.until(MAIN.decode(), "outcome: interrupted", "READY> ")
        screen.press("exit\n")
        screen.finish()


def test_a_dumb_terminal_gets_lines(tmp_path: Path) -> None:
    with Screen(run(tmp_path, "--lockstep", duration_s=12.0), TERM="dumb") as screen:
        assert screen.finish() == 0
    assert b"\x1b" not in screen.seen
    assert b" of 12 s | " in screen.seen


def test_monitor_names_a_folder_where_nothing_runs(tmp_path: Path) -> None:
    with Screen([*GCS, "monitor", str(tmp_path)], cwd=tmp_path) as screen:
        assert screen.finish() == 2
    assert "no session runs in" in screen.seen.decode()
    with Screen([*GCS, "monitor"], cwd=tmp_path) as screen:
        assert screen.finish() == 2
    assert "no session runs under sessions/" in screen.seen.decode()


def test_help_imports_no_textual() -> None:
    program = "import sys; sys.argv = ['gcs', '--help']\ntry:\n    import gcs.cli.main; gcs.cli.main.main()\nfinally:\n"
    program += "    assert 'textual' not in sys.modules"
    with Screen([sys.executable, "-c", program]) as screen:
        assert screen.finish() == 0
