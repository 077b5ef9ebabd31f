"""The console: what a person reads of a session, in the room there is; and the client of a session's socket."""

import json
import os
import select
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from gcs.session.client import Client, Lines
from gcs.session.plain_text import EventLines, JsonView, PlainView, VerboseView, farewell, progress
from gcs.session.supervised import PATIENCE_S, SAVES_WITHIN_S, Supervised


def vehicle(sysid: int, role: str = "pursuer", **other: Any) -> dict[str, Any]:
    return {
        "sysid": sysid,
        "role": role,
        "label": f"{role} {sysid}",
        "alive": True,
        "stage": "fly",
        "mode": "offboard",
        "mode_name": "Offboard",
        "armed": True,
        "p_ned": [3.25, -1.5, -2.125],
        "speed_m_s": 0.75,
        "height_m": 2.125,
        "target_m": 2.5,
        "battery": 0.71,
        "remaining_j": 17000,
        "endurance_s": 81.0,
        "v": None,
        "tau": None,
        "note": "",
    } | other


def snapshot(*vehicles: dict[str, Any], **other: Any) -> dict[str, Any]:
    return {
        "type": "snapshot",
        "t_s": 52.3,
        "duration_s": 150.0,
        "speed": 4.98,
        "phase": "flying",
        "vehicles": list(vehicles),
        "traffic": [],
        "services": [],
        "refuelled": 2,
        "goal": {"pursue_within_m": 3.5, "pursue_for_s": 20, "pursue_held_s": 12.0, "refuelled_at_least": 3},
        "events": [],
    } | other


def event(t_s: float, sysid: int, text: str, level: str = "info") -> dict[str, Any]:
    return {"t_s": t_s, "sysid": sysid, "level": level, "text": text}


SERVICE = {"receiver": 5, "tanker": 201, "phase": "transfer", "energy_j": 3120, "by": "competition"}
EVENTS = [event(40.0 + i, 5, f"happening {i}") for i in range(5)]


def demo(**other: Any) -> dict[str, Any]:
    return snapshot(
        vehicle(1, v=0.93),
        vehicle(2, battery=0.42, p_ned=[-12.34, 103.45, -3.0], v=0.02),
        vehicle(3, battery=0.15, endurance_s=20.0, v=0.05),
        vehicle(4, mode="hold", mode_name="Hold"),
        vehicle(5, mode="refuel", mode_name="Refuel", note="served by 201: transfer"),
        vehicle(101, "target", target_m=None),
        vehicle(201, "tanker", target_m=None, note="serves 5: transfer"),
        **({"services": [SERVICE], "events": EVENTS} | other),
    )


def news(content: dict[str, Any]) -> list[str]:
    return EventLines().lines(content)


def test_text_from_the_air_cannot_steer_the_terminal() -> None:
    content = demo(events=[event(1.0, 5, "\x1b[2Jgone [red]\nnext\x07")])
    (line,) = news(content)
    assert "\x1b" not in line
    assert "[2Jgone [red] next" in line


def test_a_progress_line_says_time_modes_lowest_battery_and_goal() -> None:
    assert progress(demo()) == (
        "   52.3 s of 150 s | x4.98 | flying | 5 Offboard, 1 Hold, 1 Refuel | lowest battery 15 % (pursuer 3) | "
        "pursuit 12 of 20 s | refuelled 2 of 3"
    )


def test_a_progress_line_counts_the_silent_whose_modes_and_batteries_are_old() -> None:
    silent = [vehicle(sysid, condition="silent") for sysid in (1, 2)]
    line = progress(snapshot(*silent, vehicle(3, condition="low"), goal={}))
    assert "| 3 Offboard | 2 silent | lowest battery" in line
    assert "silent" not in progress(demo())


def test_a_progress_line_without_a_pace_or_a_vehicle_says_no_more_than_it_knows() -> None:
    line = progress(snapshot(speed=None, duration_s=None, goal={}))
    assert line == "   52.3 s | flying | no vehicle yet"


def test_each_event_becomes_one_line_with_its_level_and_vehicle() -> None:
    lines = news(demo(events=[event(12.1, 5, "Refuel"), event(12.2, 3, "Battery empty", "critical")]))
    assert lines == ["   12.1 s pursuer 5: Refuel", "   12.2 s CRITICAL: pursuer 3: Battery empty"]
    death = "pursuer 3 (process 9) was killed by signal 9"
    assert news(demo(events=[event(1.0, 3, death, "critical")])) == [f"    1.0 s CRITICAL: {death}"]


def test_a_change_of_mode_is_told_unless_its_vehicle_has_just_said_so() -> None:
    changed = event(52.4, 5, "Offboard -> Hold") | {"kind": "mode"}
    assert news(demo(events=[changed])) == ["   52.4 s pursuer 5: Offboard -> Hold"]
    announced = event(51.5, 5, "Set points lost: hold") | {"kind": "text"}
    assert news(demo(events=[announced, changed])) == ["   51.5 s pursuer 5: Set points lost: hold"]
    assert len(news(demo(events=[announced | {"sysid": 4}, changed]))) == 2
    assert len(news(demo(events=[announced | {"t_s": 50.0}, changed]))) == 2


def test_what_is_granted_is_not_told_and_what_is_refused_is() -> None:
    granted = event(1.0, 5, "Hold accepted") | {"kind": "ack"}
    refused = event(1.0, 5, "Hold refused: denied", "warning") | {"kind": "ack"}
    assert news(demo(events=[granted, refused])) == ["    1.0 s WARNING: pursuer 5: Hold refused: denied"]


@pytest.mark.parametrize("at_once", [1, 2, 3, 7])
def test_the_lines_do_not_depend_on_how_often_snapshots_come(at_once: int) -> None:
    happened = [
        event(40.0, 5, "Refuelling of 5 by 201 decided by competition") | {"kind": "decision"},
        event(44.0, 5, "Refuel") | {"kind": "text"},
        event(44.0, 5, "Offboard -> Refuel") | {"kind": "mode"},
        event(44.1, 5, "Transfer from 201 to 5 begun") | {"kind": "decision"},
        event(47.0, 4, "Offboard -> Hold", "warning") | {"kind": "failsafe"},
        event(50.0, 5, "Refuelling of 5 by 201 ended: full, 9000 J") | {"kind": "decision"},
        event(52.5, 5, "Refuel -> Offboard") | {"kind": "mode"},
    ]
    phases = ("join", "start receiver", "transfer", "catch up")
    lines: list[str] = []
    view = PlainView(lines.append)
    for begin in range(0, len(happened), at_once):
        services = [SERVICE | {"phase": phases[begin % 4]}]
        view.show(demo(services=services, events=happened[begin : begin + at_once]))
    assert [line.split(" s ", 1)[1] for line in lines] == [
        "pursuer 5: Refuelling of 5 by 201 decided by competition",
        "pursuer 5: Refuel",
        "pursuer 5: Transfer from 201 to 5 begun",
        "WARNING: pursuer 4: Offboard -> Hold",
        "pursuer 5: Refuelling of 5 by 201 ended: full, 9000 J",
        "pursuer 5: Refuel -> Offboard",
    ]


def test_the_sessions_own_words_are_the_sessions() -> None:
    assert news(demo(events=[event(1.0, 0, "The session goes on.")])) == ["    1.0 s session: The session goes on."]


def test_plain_progress_comes_every_two_seconds_and_news_at_once() -> None:
    lines: list[str] = []
    view = PlainView(lines.append)
    for tenth in range(50):
        view.show(demo(events=[event(1.0, 5, "Refuel")] if tenth == 25 else []))
        view.tick(tenth / 10)
    assert [line.partition(" s ")[2][:9] for line in lines] == ["of 150 s ", "of 150 s ", "pursuer 5", "of 150 s "]


def test_a_vehicle_that_has_not_reported_has_dashes_in_its_line() -> None:
    lines: list[str] = []
    view = VerboseView(lines.append)
    view.show(snapshot(vehicle(1, mode_name="other", p_ned=None, speed_m_s=None, battery=None)))
    view.tick(0.0)
    assert " ".join(lines[1].split()) == "pursuer 1 other N - E - - m high - m/s - %"


def test_a_start_that_takes_long_is_said_once() -> None:
    lines: list[str] = []
    view = PlainView(lines.append)
    for tenth in range(1000, 1100):
        if tenth == 1090:
            view.show(demo(events=[]))
        view.tick(tenth / 10)
        assert len(lines) == (tenth >= 1020) + (tenth >= 1090)
    assert lines[0] == "still starting ..."


def test_json_comes_every_second_and_leaves_no_event_out() -> None:
    lines: list[str] = []
    view = JsonView(lines.append)
    for tenth in range(25):
        view.show(demo(t_s=tenth / 10, events=[event(tenth / 10, 5, str(tenth))]))
        view.tick(tenth / 10)
    view.close()
    shown = [json.loads(line) for line in lines]
    assert [s["t_s"] for s in shown] == [0.0, 1.0, 2.0, 2.4]
    assert [e["text"] for s in shown for e in s["events"]] == [str(i) for i in range(25)]


SUMMARY: dict[str, Any] = {
    "refuelling": [{"receiver": 5, "tanker": 201, "end_s": 60.0, "energy_j": 9000, "by": "competition"}],
    "min_separation_m": 0.71,
    "min_clearance_m": None,
    "sim_time_s": 150.0,
    "wall_time_s": 30.5,
    "speed_achieved": 4.918,
    "lag_s": 0.5,
    "digest": "sha256:ab",
    "outcome": "met",
    "vehicles": [
        {"sysid": 3, "role": "pursuer", "final_mode": "offboard"},
        {"sysid": 201, "role": "tanker", "final_mode": "offboard"},
    ],
}


def test_the_farewell_says_what_the_session_amounts_to() -> None:
    assert farewell(SUMMARY, "met", Path("sessions/x")) == [
        "outcome: met",
        "refuelled: 5 by 201 (9000 J, competition)",
        "minimum separation: 0.71 m",
        "minimum clearance: -",
        "speed: 4.92 (150.0 s flown in 30.5 s, 0.5 s behind its pace)",
        "digest: sha256:ab",
        "session: sessions/x",
    ]
    (service,) = SUMMARY["refuelling"]
    unended = {**SUMMARY, "refuelling": [{**service, "end_s": None}]}
    assert "refuelled: 5 by 201 (9000 J, competition, not ended)" in farewell(unended, "met", Path("x"))
    assert farewell(None, None, Path("x")) == ["outcome: none", "session: x"]


def test_a_long_farewell_needs_no_line_of_more_than_80_columns_and_leaves_nobody_out() -> None:
    done = [
        {"receiver": i, "tanker": 201, "end_s": 9.0, "energy_j": 12000 + i, "by": "competition"} for i in range(1, 10)
    ]
    lines = farewell({**SUMMARY, "refuelling": done}, "met", Path("x"))
    assert max(map(len, lines)) <= 80
    told = " ".join(line.strip() for line in lines).partition("refuelled: ")[2].partition(" minimum")[0]
    assert told == ", ".join(f"{i} by 201 ({12000 + i} J, competition)" for i in range(1, 10))


def test_the_farewell_names_who_was_lost_also_where_the_supervisor_could_not_say_the_outcome() -> None:
    vehicles = [dict(vehicle, final_mode="dead") for vehicle in SUMMARY["vehicles"]]
    lines = farewell(
        {**SUMMARY, "outcome": "lost", "outcome_text": "not met: lost 2", "vehicles": vehicles}, "", Path("sessions/x")
    )
    assert lines[:2] == ["not met: lost 2", "lost: pursuer 3, tanker 201"]


@pytest.mark.parametrize(
    ("met", "lines"), [(True, ["outcome: met", "lost: 1 (3 at 4.0 s: dead)"]), (False, ["outcome: met"])]
)
def test_the_farewell_names_losses_that_the_outcome_does_not(met: bool, lines: list[str]) -> None:
    part = {"part": "lost", "met": met, "value": 1.0, "reached": "1 (3 at 4.0 s: dead)", "limit": 1.0}
    said = farewell({**SUMMARY, "goal": [part]}, "met", Path("x"))
    assert said[: len(lines)] == lines
    assert sum(line.startswith("lost") for line in said) == len(lines) - 1


def test_lines_arrive_whole_however_they_are_cut() -> None:
    content = b'{"a": 1}\nnot json\n[1]\n{"b": "\xc3\xa9"}\n{"unfinished'
    for size in range(1, len(content) + 1):
        lines = Lines()
        got = [m for i in range(0, len(content), size) for m in lines.feed(content[i : i + size])]
        assert got == [{"a": 1}, {"b": "é"}]


# A supervisor that speaks the protocol and does what its first word says; what it was told ends up in `told`.
FAKE = """
import json, os, signal, socket, sys, time
folder, behaviour = sys.argv[1:3]
signal.signal(signal.SIGINT, signal.SIG_IGN)
say = lambda content: print(json.dumps(content), flush=True)
snapshots = json.load(open(os.path.join(folder, "snapshots.json")))
if behaviour == "dies":
    print("something broke", file=sys.stderr)
    os._exit(9)
os.chdir(folder)
server = socket.socket(socket.AF_UNIX)
server.bind("session.sock")
server.listen()
say({"listening": True})
client, _ = server.accept()
if behaviour == "drops":
    client.sendall(b'{"type": "snaps')
    client.close()
    client, _ = server.accept()
for snapshot in snapshots:
    client.sendall(json.dumps(snapshot).encode() + b"\\n")
outcome, status = "met", 0
if behaviour == "deaf":  # obeys neither the command nor the closed pipe
    while True:
        time.sleep(60)
if behaviour == "waits":
    open("told", "wb").write(client.makefile("rb").readline())
    outcome, status = "interrupted", 130
if behaviour == "ignores":  # ends only when its pipe closes
    sys.stdin.read()
    outcome, status = "interrupted", 130
if behaviour == "misses":
    outcome, status = "pursue", 1
json.dump(json.load(open("canned.json")), open("summary.json", "w"))
client.sendall(json.dumps({"type": "end", "outcome": outcome, "exit": status}).encode() + b"\\n")
say({"exit": status, "outcome": outcome, "error": None})
sys.exit(status)
"""

RUN = """
import signal
import sys
from pathlib import Path
from gcs.session.plain_text import PlainView
from gcs.session.supervised import run
write = lambda line: print(line, flush=True)
folder, hangs_up, *arguments = sys.argv[1:]
signal.signal(signal.SIGHUP, int(hangs_up))
sys.exit(run(Path(folder), PlainView(write), write, supervisor="fake", arguments=arguments))
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A session folder whose path is longer than a Unix socket's may be."""
    deep = tmp_path / ("long" * 30)
    deep.mkdir()
    (deep / "fake.py").write_text(FAKE)
    (deep / "snapshots.json").write_text(json.dumps([demo(), demo(t_s=53.0, events=[event(52.9, 5, "Refuelled")])]))
    (deep / "canned.json").write_text(json.dumps(SUMMARY))
    return deep


@contextmanager
def started(
    folder: Path, behaviour: str, hangs_up: signal.Handlers = signal.SIG_DFL
) -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-c", RUN, str(folder), str(int(hangs_up)), behaviour]
    path = {**os.environ, "PYTHONPATH": str(folder)}
    process = subprocess.Popen(command, env=path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        with process:
            yield process
    finally:
        process.kill()


def until(process: subprocess.Popen[str], words: str) -> None:
    """Read the program's lines up to one with `words` in it."""
    assert process.stdout is not None
    for line in process.stdout:
        if words in line:
            return
    raise AssertionError(f"ended without a word of {words}")


@pytest.mark.parametrize(("behaviour", "status"), [("ends", 0), ("misses", 1), ("drops", 0)])
def test_a_session_is_shown_summed_up_and_its_status_passed_on(folder: Path, behaviour: str, status: int) -> None:
    with started(folder, behaviour) as process:
        out, err = process.communicate(timeout=60)
    assert process.returncode == status
    assert "pursuer 5: Refuelled" in out
    assert "refuelled: 5 by 201 (9000 J, competition)" in out
    assert out.rstrip().endswith(f"session: {folder}")
    assert err == ""


@pytest.mark.parametrize(("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)])
def test_a_signal_stops_the_session_once_and_saves_it(folder: Path, number: signal.Signals, status: int) -> None:
    with started(folder, "waits") as process:
        until(process, "Refuelled")
        process.send_signal(number)
        out, _ = process.communicate(timeout=60)
    assert process.returncode == status
    assert json.loads((folder / "told").read_text()) == {"command": "stop"}
    assert "outcome: interrupted" in out


def test_a_hang_up_that_the_caller_ignores_stops_nothing(folder: Path) -> None:
    with started(folder, "waits", hangs_up=signal.SIG_IGN) as process:  # as nohup starts it
        until(process, "Refuelled")
        process.send_signal(signal.SIGHUP)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
    assert process.returncode == 143


def test_the_second_signal_closes_the_pipe(folder: Path) -> None:
    with started(folder, "ignores") as process:
        until(process, "Refuelled")
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)  # two of the same kind could arrive as one
        out, _ = process.communicate(timeout=60)
    assert process.returncode in (130, 143)
    assert "outcome: interrupted" in out


def test_however_often_it_is_asked_a_supervisor_has_its_time_to_save_the_session(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "waiting.py").write_text("import signal\nsignal.pause()\n")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    with Supervised(tmp_path, [], supervisor="waiting") as process:
        for now_s in (100.0, 100.1, 100.2, 100.0 + SAVES_WITHIN_S - 0.01):
            process.interrupt(now_s)
        assert not process.ended
        process.interrupt(100.0 + SAVES_WITHIN_S)
        assert select.select([process.death], [], [], 60.0)[0]
        assert process.status == -signal.SIGKILL


def test_who_waits_for_a_supervisor_that_does_not_stop_is_told_and_can_end_it(folder: Path) -> None:
    with started(folder, "deaf") as process:
        until(process, "Refuelled")
        process.send_signal(signal.SIGINT)
        assert process.stderr is not None
        assert "Ctrl-C twice more" in process.stderr.readline()
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=PATIENCE_S[1])
    assert process.returncode == 130


def test_a_supervisor_that_dies_is_reported_in_one_sentence(folder: Path) -> None:
    with started(folder, "dies") as process:
        out, err = process.communicate(timeout=60)
    assert process.returncode == 70
    said, sentence = err.splitlines()
    assert said == "something broke"
    assert sentence.startswith(f"gcs: the supervisor of {folder} ended with status 9")
    assert out == ""


def test_a_supervisor_that_is_killed_is_reported_with_its_signal(folder: Path) -> None:
    with started(folder, "deaf") as process:
        until(process, "Refuelled")
        (supervisor,) = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        os.kill(int(supervisor), signal.SIGKILL)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 70
    assert "was killed by signal 9" in err
    assert not (folder / "session.sock").exists(), "programs would knock where nobody answers"


def test_a_reader_that_goes_away_stops_the_session(folder: Path) -> None:
    with started(folder, "waits") as process:
        until(process, "happening 0")
        assert process.stdout is not None
        process.stdout.close()
        process.wait(timeout=60)
    assert json.loads((folder / "told").read_text()) == {"command": "stop"}


def test_a_client_without_a_session_gets_an_os_error(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        Client(tmp_path)
    shutil.rmtree(tmp_path)
    with pytest.raises(FileNotFoundError):
        Client(tmp_path)
