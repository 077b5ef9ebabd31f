"""`gcs logs` over two vehicles of ours and one that pymavlink speaks for, against the files that they have written."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import random
import re
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from scenarios import loaded
from sessions import fly
from strangers import SIMVEHICLE, strangers

from gcs.session.fetched_logs import fetch_logs

DATAFLASH = b"\xa3\x95" + random.Random(1).randbytes(50_000)


class ArduPilotLogs:
    """A vehicle 3 with two logs; what it sends of them is lost at random, and it is slow where asked to be. It may be
    dead from a byte of theirs on."""

    def __init__(self, port: int, dies_at: int | None = None) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", port))
        self.socket.settimeout(0.02)
        self.ended = threading.Event()
        self.slow = False
        self.stop = False
        self._dies_at = dies_at
        self.logs = {7: b"\xa3\x95older", 8: DATAFLASH}
        self._random = random.Random(2)
        self._thread = threading.Thread(target=self._live)
        self._thread.start()

    def close(self) -> None:
        self.stop = True
        self._thread.join()
        self.socket.close()

    def _heard(self, reader: Any) -> list[Any]:
        """What came in one datagram; that nobody is there any more to hear a heartbeat hides none that came before."""
        for _ in range(2):
            try:
                return reader.parse_buffer(self.socket.recv(2048)) or []
            except ConnectionRefusedError:
                continue
            except OSError:  # nothing came
                break
        return []

    def _live(self) -> None:
        writer, reader = mav.MAVLink(None, 3, 1), mav.MAVLink(None)
        sending: tuple[int, int, int] | None = None
        while not self.stop:
            for message in self._heard(reader):
                match message.get_type():
                    case "LOG_REQUEST_LIST":
                        for number, content in self.logs.items():
                            self._send(mav.MAVLink_log_entry_message(number, 2, 8, 0, len(content)), writer)
                    case "LOG_REQUEST_DATA":
                        sending = message.id, message.ofs, message.ofs + message.count
                    case "LOG_REQUEST_END":
                        sending = None
                        self.ended.set()
            self._send(mav.MAVLink_heartbeat_message(2, 3, 0, 0, 3, 3), writer)
            for _ in range(1 if self.slow else 20):
                if sending is None:
                    break
                number, at, stop = sending
                data = self.logs[number][at : min(at + 90, stop)]
                if self._dies_at is not None and at >= self._dies_at:
                    return
                if self._random.random() > 0.1:
                    padded = [*data, *[0] * (90 - len(data))]
                    self._send(mav.MAVLink_log_data_message(number, at, len(data), padded), writer)
                sending = (number, at + 90, stop) if at + 90 < stop else None

    def _send(self, message: Any, writer: Any) -> None:
        with contextlib.suppress(OSError):  # nobody is there
            self.socket.send(message.pack(writer))


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[int, Path, ArduPilotLogs]]:
    port, folder = free_port(), tmp_path_factory.mktemp("logged")
    to = ["--connect", f"udpout:127.0.0.1:{port}"]
    commands = [
        [*SIMVEHICLE, "--sysid", "1", *to, "--truth", str(folder / "1.truth")],
        [*SIMVEHICLE, "--sysid", "2", *to],
    ]
    with strangers(folder / "said", *commands):
        other = ArduPilotLogs(port)
        try:
            yield port, folder, other
        finally:
            other.close()


def at(port: int, *sysids: int) -> list[str]:
    only = [word for sysid in sysids for word in ("--sysid", str(sysid))]
    return ["--connect", f"udpin:127.0.0.1:{port}", "--wait", "40", *only]


def test_logs_of_three_are_listed_and_come_whole(fleet: tuple[int, Path, ArduPilotLogs], tmp_path: Path) -> None:
    port, folder, _ = fleet
    listed = gcs("logs", "list", *at(port, 1, 2, 3), "--json")
    assert listed.returncode == 0, listed.stderr
    vehicles = json.loads(listed.stdout)["vehicles"]
    assert [(log["number"], log["size_bytes"], log["begun"]) for log in vehicles["3"]] == [
        (7, 7, None),
        (8, 50002, None),
    ]
    assert vehicles["2"] == []
    assert vehicles["1"][0]["size_bytes"] > 0

    out = tmp_path / "out"
    done = gcs("logs", "get", "--out", str(out), *at(port, 1, 2, 3), "--json")
    assert done.returncode == 0, done.stderr
    rows = {row["sysid"]: row for row in json.loads(done.stdout)["files"]}
    assert sorted(rows) == [1, 3]
    mine, other = Path(rows[1]["file"]), Path(rows[3]["file"])
    assert (mine.suffix, other.name) == (".truth", "vehicle-3-log-8.bin")
    assert other.read_bytes() == DATAFLASH
    assert rows[3]["sha256"] == hashlib.sha256(DATAFLASH).hexdigest()
    truth = (folder / "1.truth").read_bytes()
    assert 0 < rows[1]["size_bytes"] == mine.stat().st_size <= len(truth)
    assert truth.startswith(mine.read_bytes())
    assert sorted(path.name for path in out.iterdir()) == sorted([mine.name, other.name])

    again = gcs("logs", "get", "7", "8", "--out", str(out), *at(port, 3))
    assert again.returncode == 0
    assert "vehicle-3-log-8.bin, is there already, sha256" in again.stdout
    assert (out / "vehicle-3-log-7.bin").read_bytes() == b"\xa3\x95older"


def test_what_cannot_be_had_is_a_sentence(fleet: tuple[int, Path, ArduPilotLogs], tmp_path: Path) -> None:
    port, _, _ = fleet
    unknown = gcs("logs", "get", "5", "--out", str(tmp_path), *at(port, 3))
    assert unknown.returncode == 1
    assert unknown.stderr.splitlines()[1:] == ["gcs: vehicle 3: log 5: it has no such log"]  # the first: it waits
    (tmp_path / "vehicle-3-log-7.bin").write_bytes(b"mine")
    foreign = gcs("logs", "get", "7", "--out", str(tmp_path), *at(port, 3))
    assert foreign.returncode == 1
    assert "vehicle-3-log-7.bin holds another log and is left as it is" in foreign.stderr
    assert (tmp_path / "vehicle-3-log-7.bin").read_bytes() == b"mine"


PART = "vehicle-3-log-8-partial.bin"
GAP = re.compile(
    r"(\d+) of 50002 bytes came.*; bytes (\d+) to (\d+) are the first that are missing; what came is in (.*)"
)


def check_part(said: str, folder: Path) -> int:
    """Whether the only part in a folder is the log with zeros for what is missing, as is said; bytes that came."""
    match = GAP.search(said)
    assert match is not None, said
    came, first, last = (int(number) for number in match.groups()[:3])
    (path,) = folder.glob("vehicle-*")
    part = path.read_bytes()
    assert (Path(match[4]), path.name) == (path, PART if part[:1] == DATAFLASH[:1] else PART.replace(".bin", ".log"))
    pieces = [(part[at : at + 90], DATAFLASH[at : at + 90]) for at in range(0, len(part), 90)]
    assert all(held in (sent, bytes(len(held))) for held, sent in pieces)
    there = [held == sent for held, sent in pieces]
    assert came == sum(len(held) for (held, _), is_there in zip(pieces, there, strict=True) if is_there)
    missing = [*(not is_there for is_there in there), True]
    assert first == min(90 * missing.index(True), len(part))
    after = next((90 * n for n in range(first // 90, len(there)) if there[n]), len(DATAFLASH))
    assert last == after - 1
    return came


@pytest.mark.parametrize("dies_at", [0, 49_500])
def test_of_a_vehicle_that_dies_the_part_that_came_stays_until_the_whole_log_comes(
    dies_at: int, tmp_path: Path
) -> None:
    """At its first byte, of which nothing stays, or at 99 %."""
    port = free_port()
    arguments = ["logs", "get", "8", "--out", str(tmp_path), *at(port, 3)]
    dying = ArduPilotLogs(port, dies_at)
    try:
        died = gcs(*arguments, "--json")
    finally:
        dying.close()
    assert died.returncode == 1
    (said,) = died.stderr.splitlines()[-1:]
    assert said.startswith("gcs: vehicle 3: log 8: ")
    rows = json.loads(died.stdout)
    assert rows["files"] == []
    if dies_at:
        assert 40_000 < check_part(said, tmp_path) <= dies_at
        assert [row["file"] for row in rows["parts"]] == [str(path) for path in tmp_path.iterdir()]
    else:
        assert said.endswith("0 of 50002 bytes came, then nothing, though it was asked 8 times")
        assert (rows["parts"], list(tmp_path.iterdir())) == ([], [])

    living = ArduPilotLogs(port)
    try:
        done = gcs(*arguments)
    finally:
        living.close()
    assert done.returncode == 0, done.stderr
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"vehicle-3-log-8.bin": DATAFLASH}


def external(port: int, *sysids: int) -> dict[str, Any]:
    """A scenario of vehicles at a port."""
    rules = {"connect": f"udpin:127.0.0.1:{port}", "capacity_j": 250_000, "found_within_s": 40, "arm_within_s": 3}
    ends = {1: "land", 2: "hold", 3: "land"}
    return {
        "schema": 1, "name": "logged", "axes": "ned", "goal": {"duration_s": 10.0, "lost_at_most": 3}, "logs": True,
        "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0}, "planner": {"vehicles_repel": False},
        "vehicles": {"pursuers": [
            {"external": {**rules, "sysid": sysid, "at_end": ends[sysid]}, "waypoints_m": [[0, 4 * sysid, -2.5]]}
            for sysid in sysids
        ]},
    }  # fmt: skip


@pytest.mark.parametrize("slow", [False, True])
def test_after_a_session_the_part_of_a_vehicle_that_dies_or_is_too_slow_stays(slow: bool, tmp_path: Path) -> None:
    port = free_port()
    scenario = loaded(tmp_path / "logged.yaml", json.dumps(external(port, 3)))
    vehicle = ArduPilotLogs(port, None if slow else 49_500)
    vehicle.slow = slow
    try:
        (missed,) = fetch_logs(scenario, tmp_path, [].append, fetch_within_s=3.0 if slow else 60.0)
    finally:
        vehicle.close()
    came = check_part(missed, tmp_path / "logs")
    assert ("bytes came in 3 s (`gcs logs get` has no limit); " in missed) == slow
    content = json.loads((tmp_path / "logs" / "logs.json").read_text(encoding="utf-8"))
    assert (content["files"], content["problems"]) == ([], [missed])
    (row,) = content["parts"]
    assert (row["came_bytes"], row["claimed_bytes"]) == (came, len(DATAFLASH))
    assert (tmp_path / "logs" / row["file"]).exists()


def test_ctrl_c_ends_the_download_on_the_vehicle_too_and_keeps_what_came(
    fleet: tuple[int, Path, ArduPilotLogs], tmp_path: Path
) -> None:
    port, _, other = fleet
    other.slow = True
    other.ended.clear()
    argv = [sys.executable, "-m", "gcs", "logs", "get", "8", "--out", str(tmp_path), *at(port, 3)]
    with subprocess.Popen(argv, stderr=subprocess.PIPE, env={**os.environ}) as process:
        assert process.stderr is not None
        assert b"waiting for a HEARTBEAT at " in process.stderr.readline()
        assert b" of 0.05 MB, " in process.stderr.readline()  # progress, once it has taken two seconds
        process.send_signal(signal.SIGINT)
        rest = process.stderr.read()
    assert process.returncode == 130
    assert b"Traceback" not in rest
    assert other.ended.wait(10.0)
    check_part(rest.decode(), tmp_path)
    assert len(list(tmp_path.iterdir())) == 1


def test_after_a_session_the_newest_log_of_each_lies_in_its_folder(
    fleet: tuple[int, Path, ArduPilotLogs], tmp_path: Path
) -> None:
    """One lands and is waited for, one is told to hold and stays armed, one has never been armed; a fourth is lost."""
    port, folder, other = fleet
    other.slow = False
    flown = fly(external(port, 1, 2, 3), tmp_path)
    logs = flown.folder / "logs"
    content = json.loads((logs / "logs.json").read_text(encoding="utf-8"))
    rows = {row["sysid"]: row for row in content["files"]}
    assert sorted(rows) == [1, 3]
    for row in rows.values():
        assert hashlib.sha256((logs / row["file"]).read_bytes()).hexdigest() == row["sha256"]
    assert (logs / rows[3]["file"]).read_bytes() == DATAFLASH
    mine = (logs / rows[1]["file"]).read_bytes()
    assert (folder / "1.truth").read_bytes().startswith(mine)
    assert len(mine) > 10_000  # it has flown
    (armed,) = content["problems"]
    assert armed.startswith("vehicle 2: still armed, so its log is not whole: `gcs logs get --connect udpin:")
    said = (flown.folder / "session.log").read_text(encoding="utf-8")
    assert f"log 8 of vehicle 3: {logs / rows[3]['file']}, {len(DATAFLASH)} bytes" in said
    assert "waiting until vehicle 1 is down and disarmed, for its log ..." in said
    assert armed in said


def test_logs_of_nobody_are_refused(tmp_path: Path) -> None:
    done = gcs("run", "demo", "--logs", "--out", str(tmp_path / "out"))
    assert done.returncode == 2
    assert "logs are fetched from external vehicles, and there is none" in done.stderr
