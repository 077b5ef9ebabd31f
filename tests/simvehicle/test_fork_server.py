"""The fork server as a real process: it forks, reports, and nothing outlives it."""

from __future__ import annotations

import contextlib
import json
import os
import select
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from patience import PATIENCE_S
from pymavlink.dialects.v20 import common as mav

PROGRAM = [sys.executable, "-c", "from simvehicle.cli import main; main()"]


class Child:
    """A process that the server made, by a descriptor that no other process can inherit the number of."""

    def __init__(self, pid: int) -> None:
        self.pid = pid
        try:
            self.fd = os.pidfd_open(pid)
        except ProcessLookupError:
            self.fd = -1

    def ended(self, within_s: float = 0.0) -> bool:
        return self.fd < 0 or bool(select.select([self.fd], [], [], within_s)[0])

    def kill(self, how: signal.Signals = signal.SIGKILL) -> None:
        signal.pidfd_send_signal(self.fd, how)

    def close(self) -> None:
        if self.fd >= 0:
            os.close(self.fd)


class Server:
    """A running `simvehicle fork-server`."""

    def __init__(self, folder: Path, **popen: Any) -> None:
        self.folder = folder
        self.process = subprocess.Popen(
            [*PROGRAM, "fork-server"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **popen
        )
        self._pending = b""
        self.children: list[Child] = []

    def line(self) -> dict[str, Any]:
        """The next report."""
        assert self.process.stdout is not None
        deadline_s = time.monotonic() + PATIENCE_S
        while b"\n" not in self._pending:
            left_s = deadline_s - time.monotonic()
            assert select.select([self.process.stdout], [], [], max(left_s, 0.0))[0], "no report"
            chunk = os.read(self.process.stdout.fileno(), 65536)
            assert chunk, "the server has ended"
            self._pending += chunk
        line, _, self._pending = self._pending.partition(b"\n")
        report: dict[str, Any] = json.loads(line)
        return report

    def write(self, raw: bytes) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(raw)
        self.process.stdin.flush()

    def close_stdin(self) -> None:
        assert self.process.stdin is not None
        self.process.stdin.close()

    def complaint(self) -> str:
        """All that it says on stderr, once it has ended."""
        assert self.process.stderr is not None
        return self.process.stderr.read().decode()

    def order(self, *argv: str, log: str = "vehicle.log") -> bytes:
        return json.dumps({"argv": argv, "log": str(self.folder / log)}).encode() + b"\n"

    def fork(self, *argv: str, log: str = "vehicle.log") -> dict[str, Any]:
        self.write(self.order(*argv, log=log))
        report = self.line()
        self.children.append(Child(report["pid"]))
        return report

    def fork_waiting(self, sysid: int) -> Child:
        """A vehicle that waits for a ground station."""
        self.fork("--sysid", str(sysid), "--connect", "udpin:127.0.0.1:0", log=f"{sysid}.log")
        return self.children[-1]


def all_gone(children: list[Child]) -> bool:
    """Whether every process has ended, or does within 10 s."""
    return all(child.ended(within_s=10.0) for child in children)


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    running = Server(tmp_path)
    try:
        assert running.line() == {"ready": True}
        yield running
    finally:
        running.process.kill()
        running.process.wait()
        for pipe in (running.process.stdin, running.process.stdout, running.process.stderr):
            assert pipe is not None
            with contextlib.suppress(BrokenPipeError):
                pipe.close()
        assert all_gone(running.children)
        for child in running.children:
            child.close()


def test_vehicle_is_forked_and_speaks(server: Server) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ground:
        ground.bind(("127.0.0.1", 0))
        ground.settimeout(PATIENCE_S)
        report = server.fork("--sysid", "42", "--connect", f"udpout:127.0.0.1:{ground.getsockname()[1]}")
        assert report == {"sysid": 42, "pid": report["pid"]}
        (heartbeat,) = mav.MAVLink(None).parse_buffer(ground.recv(2000))
        assert Path(f"/proc/{report['pid']}/cmdline").read_bytes().rstrip(b"\0") == b"simvehicle 42"
        assert Path(f"/proc/{report['pid']}/comm").read_text().strip() == "simvehicle 42"
    assert (heartbeat.get_type(), heartbeat.get_srcSystem()) == ("HEARTBEAT", 42)
    assert os.getsid(report["pid"]) == report["pid"]


def test_several_orders_in_one_write_and_one_order_in_two(server: Server) -> None:
    argv = ("--connect", "udpin:127.0.0.1:0")
    first, second, third = (server.order("--sysid", str(i), *argv, log=f"{i}.log") for i in (1, 2, 3))
    server.write(first + second + third[:20])
    server.write(third[20:])
    reports = [server.line() for _ in range(3)]
    server.children += [Child(report["pid"]) for report in reports]
    assert [report["sysid"] for report in reports] == [1, 2, 3]


def test_bad_argv_is_reported_with_status_2_and_its_sentence(server: Server) -> None:
    good = server.fork_waiting(1)
    forked = server.fork("--sysid", "7", "--connect", "nowhere", log="bad.log")
    ended = server.line()
    assert (ended["sysid"], ended["pid"], ended["exit"]) == (7, forked["pid"], 2)
    assert len(ended["last_lines"]) == 1
    assert "'nowhere' is no connection" in ended["last_lines"][0]
    assert not good.ended()


def test_vehicle_killed_by_a_signal_is_reported_negative_and_the_others_live(server: Server) -> None:
    victim, other = server.fork_waiting(1), server.fork_waiting(2)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ground:  # 3 is heard, so its log is written
        ground.bind(("127.0.0.1", 0))
        ground.settimeout(PATIENCE_S)
        server.fork("--sysid", "3", "--connect", f"udpout:127.0.0.1:{ground.getsockname()[1]}", log="3.log")
        ground.recv(2000)
    victim.kill(signal.SIGSEGV)
    ended = server.line()
    assert (ended["sysid"], ended["pid"], ended["exit"]) == (1, victim.pid, -11)
    assert ended["cpu_s"] >= 0.0
    server.children[-1].kill()
    ended = server.line()
    assert (ended["sysid"], ended["exit"]) == (3, -9)
    assert "udpout:127.0.0.1:" in ended["last_lines"][0]
    assert not other.ended()


@pytest.mark.parametrize(("how", "status"), [(None, 0), (signal.SIGKILL, -9)], ids=["end of stdin", "killed"])
def test_all_vehicles_end_with_the_server(server: Server, how: signal.Signals | None, status: int) -> None:
    for sysid in (1, 2):
        server.fork_waiting(sysid)
    if how is None:
        server.close_stdin()
    else:
        server.process.send_signal(how)
    assert server.process.wait(PATIENCE_S) == status
    assert all_gone(server.children)


def test_log_that_cannot_be_written_is_said_in_one_sentence(server: Server) -> None:
    server.fork("--sysid", "1", "--connect", "udpin:127.0.0.1:0", log="none/vehicle.log")
    ended = server.line()
    assert (ended["sysid"], ended["exit"], ended["last_lines"]) == (1, 74, [])
    server.close_stdin()
    said = server.complaint()
    assert said.count("\n") == 1
    assert "cannot write" in said
    assert "No such file or directory" in said


@pytest.mark.parametrize("line", [b"no json\n", b'{"argv": ["--sysid", "1"]}\n'])
def test_order_that_is_none_ends_the_server_with_a_sentence(server: Server, line: bytes) -> None:
    server.fork_waiting(1)
    server.write(line)
    assert server.process.wait(PATIENCE_S) == 2
    assert all_gone(server.children)
    said = server.complaint()
    assert said.startswith("fork server: no order: ")
    assert said.count("\n") == 1


def test_a_fork_server_of_one_session_ends_with_its_socket_and_takes_its_vehicles_along(tmp_path: Path) -> None:
    """It is forked from one that lasts, which reports the CPU time of it and its vehicles."""
    connection, theirs = socket.socketpair()
    with connection, theirs, subprocess.Popen([*PROGRAM, "fork-server"], stdin=theirs, stdout=theirs) as lasting:
        connection.settimeout(PATIENCE_S)
        reports = connection.makefile("rb")
        assert json.loads(reports.readline()) == {"ready": True}
        session, its = socket.socketpair()
        order = json.dumps({"argv": ["fork-server"], "log": str(tmp_path / "server.log")}).encode() + b"\n"
        with session:
            with its:
                socket.send_fds(connection, [order], [its.fileno()])
            session.settimeout(PATIENCE_S)
            answers = session.makefile("rb")
            server = json.loads(reports.readline())["pid"]
            assert json.loads(answers.readline()) == {"ready": True}
            argv = ["--sysid", "1", "--connect", "udpin:127.0.0.1:0"]
            session.sendall(json.dumps({"argv": argv, "log": str(tmp_path / "1.log")}).encode() + b"\n")
            vehicle = Child(json.loads(answers.readline())["pid"])
            answers.close()
        ended = json.loads(reports.readline())
        assert (ended["pid"], ended["exit"]) == (server, 0)
        assert ended["cpu_s"] > 0.0
        assert vehicle.ended()
        vehicle.close()
        reports.close()
        connection.shutdown(socket.SHUT_WR)
        assert lasting.wait(PATIENCE_S) == 0
