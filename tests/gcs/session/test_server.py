"""The session's socket, with real clients."""

import errno
import json
import os
import socket
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from gcs.session.client import READ_BYTES, SOCKET
from gcs.session.messages import CONTEST_S
from gcs.session.server import MOST_CLIENTS, MOST_COMMANDS, MOST_IN_ALL, REMEMBERED, TOO_MANY, Publisher


@pytest.fixture
def publisher(tmp_path: Path) -> Iterator[Publisher]:
    made = Publisher(tmp_path)
    yield made
    made.close()


def connect(folder: Path) -> socket.socket:
    directory = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        client = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        client.settimeout(5.0)
        client.connect(f"/proc/self/fd/{directory}/{SOCKET}")
    finally:
        os.close(directory)
    return client


def lines(client: socket.socket, count: int) -> list[object]:
    data = b""
    while data.count(b"\n") < count:
        chunk = client.recv(65536)
        assert chunk
        data += chunk
    return [json.loads(line) for line in data.splitlines()]


def closed(client: socket.socket) -> bool:
    """Read what is left; whether the other end has hung up."""
    try:
        while client.recv(1 << 20):
            pass
    except ConnectionResetError:
        return True
    except TimeoutError:
        return False
    return True


def asked(publisher: Publisher) -> list[dict[str, Any]]:
    return [request.content for request in publisher.poll()]


def test_every_client_gets_every_line_from_when_it_came(publisher: Publisher, tmp_path: Path) -> None:
    with connect(tmp_path) as first:
        publisher.poll()
        publisher.publish({"t_s": 1})
        with connect(tmp_path) as second:
            publisher.poll()
            publisher.publish({"t_s": 2})
            assert lines(first, 2) == [{"t_s": 1}, {"t_s": 2}]
            assert lines(second, 1) == [{"t_s": 2}]


def test_commands_come_in_whole_however_they_are_cut(publisher: Publisher, tmp_path: Path) -> None:
    with connect(tmp_path) as first, connect(tmp_path) as second:
        assert publisher.poll() == []
        first.sendall(b'{"command": "pa')
        second.sendall(b'{"command": "stop"}\n{"command": "resume"}\n')
        assert asked(publisher) == [{"command": "stop"}, {"command": "resume"}]
        first.sendall(b'use"}\n')
        assert asked(publisher) == [{"command": "pause"}]


@pytest.mark.parametrize(
    "garbage",
    [b"\n", b"hello\n", b"\xff\xfe\x00\n", b"[1, 2]\n", b'{"command": 7}\n', b"{}\n", b"[" * 20_000 + b"\n", b"NaN\n"],
)
def test_who_sends_a_line_that_is_no_command_is_told_so(publisher: Publisher, tmp_path: Path, garbage: bytes) -> None:
    with connect(tmp_path) as client:
        publisher.poll()
        client.sendall(garbage + b'{"command": "pause"}\n{"foo": 1, "id": 7}\n')
        assert asked(publisher) == [{"command": "pause"}]
        *unnamed, named = lines(client, 1 + (garbage != b"\n"))
        assert [line["id"] for line in unnamed] == [None] * len(unnamed)  # type: ignore[index]
        assert named == {
            "type": "reply", "id": 7, "ok": False,
            "text": 'A command is a JSON object with a text under "command", such as {"command": "pause"}.',
        }  # fmt: skip


def test_a_line_without_end_costs_its_sender_the_connection(publisher: Publisher, tmp_path: Path) -> None:
    with connect(tmp_path) as client, connect(tmp_path) as other:
        publisher.poll()
        for _ in range(3):
            client.sendall(b"x" * READ_BYTES)
            assert publisher.poll() == []
        publisher.publish({"t_s": 1})
        assert closed(client)
        assert lines(other, 1) == [{"t_s": 1}]


def test_a_slow_reader_is_dropped_and_the_others_get_everything(publisher: Publisher, tmp_path: Path) -> None:
    with connect(tmp_path) as slow, connect(tmp_path) as quick:
        publisher.poll()
        padding = "x" * 100_000
        for k in range(60):
            publisher.publish({"t_s": k, "padding": padding})
            assert lines(quick, 1)[0]["t_s"] == k  # type: ignore[index]
        assert closed(slow)
        publisher.publish({"t_s": 99})
        assert lines(quick, 1) == [{"t_s": 99}]


def test_a_client_that_leaves_is_no_error(publisher: Publisher, tmp_path: Path) -> None:
    with connect(tmp_path):
        publisher.poll()
    publisher.publish({"t_s": 1})
    assert publisher.poll() == []
    publisher.publish({"t_s": 2})


def test_a_folder_with_a_long_name_is_no_hindrance(tmp_path: Path) -> None:
    folder = tmp_path / ("x" * 120) / ("y" * 120)
    folder.mkdir(parents=True)
    publisher = Publisher(folder)
    with connect(folder) as client:
        publisher.poll()
        publisher.publish({"t_s": 1})
        assert lines(client, 1) == [{"t_s": 1}]
    publisher.close()
    assert not (folder / SOCKET).exists()


def test_closing_lets_everyone_go(tmp_path: Path) -> None:
    publisher = Publisher(tmp_path)
    with connect(tmp_path) as client:
        publisher.poll()
        publisher.close()
        assert client.recv(1) == b""
    assert not (tmp_path / SOCKET).exists()


def test_a_client_reads_the_greeting_before_anything_else(tmp_path: Path) -> None:
    publisher = Publisher(tmp_path, {"type": "session", "name": "x"})
    with connect(tmp_path) as first:
        publisher.poll()
        publisher.publish({"t_s": 1})
        with connect(tmp_path) as second:
            publisher.poll()
            publisher.publish({"t_s": 2})
            greeting = {"type": "session", "name": "x", "events": [], "told": 0, "contest": []}
            assert lines(first, 3) == [greeting, {"t_s": 1}, {"t_s": 2}]
            assert lines(second, 2) == [greeting, {"t_s": 2}]
    publisher.close()


def test_who_comes_late_is_greeted_with_the_last_events_and_how_many_there_were(tmp_path: Path) -> None:
    publisher = Publisher(tmp_path, {"type": "session"})
    assert not publisher.watched
    publisher.remember({"t_s": 0, "events": [{"n": 0}, {"n": 1}]})
    with connect(tmp_path) as first:
        publisher.poll()
        assert publisher.watched
        assert lines(first, 1) == [{"type": "session", "events": [{"n": 0}, {"n": 1}], "told": 2, "contest": []}]
        for n in range(2, REMEMBERED + 5):
            publisher.publish({"t_s": 0.25 * n, "events": [{"n": n}], "competition": {"v": {"1": 0.5}}})
        with connect(tmp_path) as second:
            publisher.poll()
            (greeting,) = lines(second, 1)
            assert isinstance(greeting, dict)
            assert [event["n"] for event in greeting["events"]] == list(range(5, REMEMBERED + 5))
            assert greeting["told"] == REMEMBERED + 5
            times = [t_s for t_s, v in greeting["contest"] if v == {"1": 0.5}]
            last_s = 0.25 * (REMEMBERED + 4)
            assert times == [last_s + 0.5 * k for k in range(1 - round(2 * CONTEST_S), 1)], "twice a second"
    publisher.close()


def test_a_reply_goes_to_who_asked_and_carries_the_id(publisher: Publisher, tmp_path: Path) -> None:
    with connect(tmp_path) as first, connect(tmp_path) as second:
        publisher.poll()
        half = b'{"command": "stop", "id": "\\ud800"}\n'  # of a pair of surrogates, which is no text of UTF-8
        second.sendall(b'{"command": "hold", "id": "a7"}\n{"command": "land", "id": NaN}\n' + half)
        hold, land, stop = publisher.poll()
        publisher.reply(hold, True, "Yes.")
        publisher.reply(land, False, "No.")
        publisher.reply(stop, False, "No.")
        publisher.publish({"t_s": 1})
        assert lines(second, 4) == [
            {"type": "reply", "id": "a7", "ok": True, "text": "Yes."},
            {"type": "reply", "id": None, "ok": False, "text": "No."},
            {"type": "reply", "id": "\ud800", "ok": False, "text": "No."},
            {"t_s": 1},
        ]
        assert lines(first, 1) == [{"t_s": 1}]
        assert hold.client in publisher.clients
    publisher.poll()
    assert hold.client not in publisher.clients
    publisher.reply(hold, True, "Nobody hears it.")


def test_only_its_user_may_connect_whatever_the_umask(tmp_path: Path) -> None:
    before = os.umask(0)
    try:
        publisher = Publisher(tmp_path)
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / SOCKET).stat().st_mode) == 0o600
    publisher.close()


def test_more_clients_than_there_is_room_for_are_told_so_and_the_others_stay(
    publisher: Publisher, tmp_path: Path
) -> None:
    clients = []
    for _ in range(MOST_CLIENTS + 3):
        clients.append(connect(tmp_path))
        publisher.poll()
    assert len(publisher.clients) == MOST_CLIENTS
    for late in clients[MOST_CLIENTS:]:
        assert lines(late, 1) == [{"type": "reply", "id": None, "ok": False, "text": TOO_MANY}]
        assert closed(late)
    publisher.publish({"t_s": 1})
    assert lines(clients[0], 1) == [{"t_s": 1}]
    clients[0].close()
    publisher.poll()
    with connect(tmp_path) as another:
        publisher.poll()
        publisher.publish({"t_s": 2})
        assert lines(another, 1) == [{"t_s": 2}]
    for client in clients:
        client.close()


def test_a_session_without_free_descriptors_goes_on(publisher: Publisher) -> None:
    class Exhausted:
        def accept(self) -> None:
            raise OSError(errno.EMFILE, "Too many open files")

    real, publisher._server = publisher._server, Exhausted()  # type: ignore[assignment]
    assert publisher.poll() == []
    publisher._server = real


def test_a_flood_of_commands_waits_with_its_sender_and_nobody_elses_does(publisher: Publisher, tmp_path: Path) -> None:
    with connect(tmp_path) as flood, connect(tmp_path) as other:
        publisher.poll()
        flood.sendall(b'{"command": "skip"}\n' * 2000)
        other.sendall(b'{"command": "pause"}\n')
        first = publisher.poll()
        assert len(first) == MOST_COMMANDS + 1
        assert sum(request.content["command"] == "pause" for request in first) == 1
        flood.close()
        count = len(first)
        while more := publisher.poll():
            assert len(more) <= MOST_COMMANDS
            count += len(more)
        assert count == 2001  # none of a client that has gone is lost


def test_many_flooding_clients_have_their_turns(publisher: Publisher, tmp_path: Path) -> None:
    clients = []
    for _ in range(MOST_CLIENTS):
        clients.append(connect(tmp_path))
        publisher.poll()
    for client in clients:
        client.sendall(b'{"command": "skip"}\n' * 50)
    served: set[int] = set()
    for _ in range(5):
        commands = publisher.poll()
        assert len(commands) <= MOST_IN_ALL + MOST_COMMANDS
        served |= {request.client for request in commands}
    assert served == publisher.clients
    for client in clients:
        client.close()
