"""`gcs logs` over two vehicles of ours and one that pymavlink speaks for, against the files that they have written."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import random
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
from pymavlink.dialects.v20 import common as mav
from sessions import fly
from strangers import SIMVEHICLE, free_port, strangers

pytestmark = pytest.mark.timeout(100)
DATAFLASH = b"\xa3\x95" + random.Random(1).randbytes(50_000)


class ArduPilotLogs:
    """A vehicle 3 with two logs; what it sends of them is lost at random, and it is slow where asked to be."""

    def __init__(self, port: int) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", port))
        self.socket.settimeout(0.02)
        self.ended = threading.Event()
        self.slow = False
        self.stop = False
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
    return ["--connect", f"udpin:127.0.0.1:{port}", "--within", "40", *only]


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
    assert (unknown.returncode, unknown.stderr) == (1, "gcs: vehicle 3: log 5: it has no such log\n")
    (tmp_path / "vehicle-3-log-7.bin").write_bytes(b"mine")
    foreign = gcs("logs", "get", "7", "--out", str(tmp_path), *at(port, 3))
    assert foreign.returncode == 1
    assert "vehicle-3-log-7.bin holds another log and is left as it is" in foreign.stderr
    assert (tmp_path / "vehicle-3-log-7.bin").read_bytes() == b"mine"


def test_ctrl_c_ends_the_download_on_the_vehicle_too_and_leaves_no_part(
    fleet: tuple[int, Path, ArduPilotLogs], tmp_path: Path
) -> None:
    port, _, other = fleet
    other.slow = True
    other.ended.clear()
    argv = [sys.executable, "-m", "gcs", "logs", "get", "8", "--out", str(tmp_path), *at(port, 3)]
    with subprocess.Popen(argv, stderr=subprocess.PIPE, env={**os.environ}) as process:
        assert process.stderr is not None
        assert b" of 0.05 MB, " in process.stderr.readline()  # progress, once it has taken two seconds
        process.send_signal(signal.SIGINT)
        rest = process.stderr.read()
    assert process.returncode == 130
    assert b"Traceback" not in rest
    assert other.ended.wait(10.0)
    assert not list(tmp_path.iterdir())


def test_after_a_session_the_newest_log_of_each_lies_in_its_folder(
    fleet: tuple[int, Path, ArduPilotLogs], tmp_path: Path
) -> None:
    """One lands and is waited for, one is told to hold and stays armed, one has never been armed; a fourth is lost."""
    port, folder, other = fleet
    other.slow = False
    rules = {"connect": f"udpin:127.0.0.1:{port}", "capacity_j": 250_000, "found_within_s": 40, "arm_within_s": 3}
    ends = {1: "land", 2: "hold", 3: "land"}
    made = {
        "schema": 1, "name": "logged", "axes": "ned", "goal": {"duration_s": 10.0, "lost_at_most": 3}, "logs": True,
        "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0}, "planner": {"vehicles_repel": False},
        "vehicles": {"pursuers": [
            {"external": {**rules, "sysid": sysid, "at_end": end}, "waypoints_m": [[0, 4 * sysid, -2.5]]}
            for sysid, end in ends.items()
        ]},
    }  # fmt: skip
    flown = fly(made, tmp_path)
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
