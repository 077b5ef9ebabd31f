"""The page's server as strangers meet it: without a token, from other origins, under other names, too much at once."""

from __future__ import annotations

import asyncio
import contextlib
import http.client
import json
import socket
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from urllib.parse import quote, urlsplit

import pytest
from web import Script, served
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin, Subprotocol

from gcs.web.application import MOST_COMMAND, NO_TOKEN, policy
from gcs.web.connection_limit import MOST_WITHOUT_TOKEN, ConnectionLimit
from gcs.web.document import as_json
from gcs.web.process import page_server
from gcs.web.tiles import checked

SESSION = {"type": "session", "name": "one", "control": True}


@pytest.fixture(scope="module")
def source() -> Script:
    return Script(SESSION)


@pytest.fixture(scope="module")
def links(source: Script) -> Iterator[dict[str, str]]:
    with served(source) as links:
        yield links


def stream(link: str, *, token: str | None = None, origin: str | None = "own") -> Any:
    """A WebSocket to the stream of a link's server."""
    parts = urlsplit(link)
    given = parts.fragment.removeprefix("token=") if token is None else token
    return connect(
        f"ws://{parts.netloc}/stream",
        origin=None if origin is None else Origin(f"http://{parts.netloc}" if origin == "own" else origin),
        subprotocols=[Subprotocol("skytender"), Subprotocol(f"token.{given}")] if given else None,
        proxy=None,
    )


def get(link: str, path: str = "/", host: str | None = None, **headers: str) -> tuple[int, dict[str, str], str]:
    parts = urlsplit(link)
    connection = http.client.HTTPConnection(parts.hostname or "", parts.port or 0, timeout=20)
    connection.request("GET", path, headers=headers | ({} if host is None else {"Host": host}))
    answer = connection.getresponse()
    body = answer.read().decode()
    connection.close()
    return answer.status, {name.lower(): value for name, value in answer.getheaders()}, body


def said(socket: ClientConnection) -> Any:
    return json.loads(socket.recv(timeout=20))


def test_a_server_that_nobody_opened_ends_with_a_session_that_never_began(tmp_path: Path) -> None:
    stayed: list[bool] = []
    with page_server(tmp_path) as shown:
        assert set(shown.links) == {"command", "view"}
        shown.stay(lambda: stayed.append(True))
    assert stayed == []


def test_a_page_learns_of_the_end_of_a_session_that_has_said_nothing(tmp_path: Path) -> None:
    with contextlib.ExitStack() as stack:
        with page_server(tmp_path) as shown:
            page = stack.enter_context(stream(shown.links["view"]))
        end = said(page)
    assert (end["type"], end["outcome"], end["exit"]) == ("end", None, None)
    assert "without a last word" in end["text"]


def test_the_server_is_this_machines_alone_and_the_tokens_differ(links: dict[str, str]) -> None:
    command, view = urlsplit(links["command"]), urlsplit(links["view"])
    assert command.hostname == view.hostname == "127.0.0.1"
    assert command.fragment != view.fragment
    assert len(command.fragment) > 24
    assert not command.query, "what is in the fragment is sent to nobody"


def test_every_answer_has_a_policy_and_carries_no_secret(links: dict[str, str]) -> None:
    for path, status in (("/", 200), ("/page.js", 200), ("/page.css", 200), ("/nothing", 404), ("/../secrets", 404)):
        found, headers, body = get(links["command"], path)
        assert found == status, path
        assert headers["content-security-policy"] == policy(None)
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["referrer-policy"] == "no-referrer"
        assert "server" not in headers
        assert urlsplit(links["command"]).fragment.removeprefix("token=") not in body
    assert "unsafe" not in policy(None)


def test_a_report_has_an_address_that_cannot_be_guessed_and_a_server_that_no_page_came_to_ends(tmp_path: Path) -> None:
    """`served` waits for the server's end."""
    report = tmp_path / "report.html"
    report.write_text("<p>secret</p>", encoding="utf-8")
    with served(Script(SESSION), report=report) as links:
        for token in ("", "guessed", "é", urlsplit(links["command"]).fragment.removeprefix("token=")):
            status, headers, body = get(links["command"], f"/report/{quote(token)}")
            assert status == 404
            assert "secret" not in body
            assert headers["cache-control"] == "no-store"


def test_the_policy_lets_pictures_come_from_the_tiles_server_alone() -> None:
    given = policy(checked("https://user:secret@tiles.example:8443/{z}/{x}/{y}.png?key=abc"))
    assert "img-src 'self' data: blob: https://tiles.example:8443;" in given
    assert "secret" not in given
    assert given.replace(" https://tiles.example:8443", "") == policy(None)


@pytest.mark.parametrize(
    "address",
    ["tiles.example/{z}/{x}/{y}", "file:///{z}/{x}/{y}", "http:///{z}/{x}/{y}", "http://a; script-src *//{z}/{x}/{y}"],
)
def test_what_is_no_address_of_tiles_is_refused(address: str) -> None:
    with pytest.raises(ValueError, match="is no address of map tiles"):
        checked(address)


def test_an_address_of_tiles_names_all_three_numbers() -> None:
    with pytest.raises(ValueError, match=r"lacks \{x\} and \{y\}"):
        checked("http://tiles.example/{z}.png")


def test_another_name_for_this_machine_gets_nothing(links: dict[str, str]) -> None:
    """DNS rebinding: a stranger's name that has come to mean 127.0.0.1."""
    for host in ("evil.example", "evil.example:80", "127.0.0.1.evil.example", "[::"):
        status, _, body = get(links["command"], host=host)
        assert status in (400, 403), host
        assert "skytender" not in body.lower()
    port = urlsplit(links["command"]).port
    assert get(links["command"], host=f"localhost:{port}")[0] == 200


@pytest.mark.parametrize("origin", ["http://evil.example", "https://127.0.0.1", "null", "http://127.0.0.1:1", None])
def test_a_page_of_another_origin_is_refused_even_with_the_token(links: dict[str, str], origin: str | None) -> None:
    with pytest.raises(InvalidStatus) as refused:
        stream(links["command"], origin=origin)
    assert refused.value.response.status_code == 403


def test_the_stream_is_refused_under_another_name(links: dict[str, str]) -> None:
    upgrade = {"Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13"}
    upgrade |= {"Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==", "Origin": "http://evil.example"}
    assert get(links["command"], "/stream", host="evil.example", **upgrade)[0] == 403


@pytest.mark.parametrize("token", ["", "none", "é", "x" * 200])
def test_without_the_token_nothing_is_told(links: dict[str, str], token: str) -> None:
    with stream(links["command"], token=token.encode("ascii", "ignore").decode()) as socket:
        with pytest.raises(ConnectionClosed):
            socket.recv(timeout=20)
        assert socket.close_code == NO_TOKEN


def test_a_command_is_passed_on_and_answered_and_who_may_look_is_refused(links: dict[str, str], source: Script) -> None:
    with stream(links["command"]) as socket, stream(links["view"]) as looking:
        assert said(socket)["control"] is True
        assert said(looking)["control"] is False
        looking.send('{"command": "stop", "id": 1}')
        refused = said(looking)
        assert (refused["ok"], "commands are disabled" in refused["text"]) == (False, True)
        socket.send('{"command": "hold", "sysid": 3, "id": 7}')
        assert said(socket) == {"type": "reply", "id": "7", "ok": True, "text": "hold is taken."}
        assert [(one["command"], one["sysid"]) for one in source.sent] == [("hold", 3)], "only who may command"


def test_what_a_client_sends_too_much_of_harms_nobody(links: dict[str, str], source: Script) -> None:
    before = len(source.sent)
    with stream(links["command"]) as socket:
        said(socket)
        socket.send(json.dumps({"command": "hold", "id": "x" * MOST_COMMAND}))
        socket.send("[" * 4000)
        socket.send(b"\xff\xfe")  # bytes are no command: this one goes
        with pytest.raises(ConnectionClosed):
            socket.recv(timeout=20)
    with stream(links["command"]) as socket:
        said(socket)
        socket.send("x" * (1 << 20))
        with pytest.raises(ConnectionClosed):
            socket.recv(timeout=20)
    assert len(source.sent) == before
    assert get(links["command"])[0] == 200


def test_data_in_a_page_cannot_end_its_element() -> None:
    told = as_json({"name": "</script><script>alert(1)</script><!--"})
    assert "<" not in told
    assert json.loads(told)["name"] == "</script><script>alert(1)</script><!--"


def test_idle_connections_without_a_token_shut_no_page_out(links: dict[str, str]) -> None:
    """Half have sent nothing, half a part of their headers; the operator's page comes last."""
    at = urlsplit(links["command"])
    with contextlib.ExitStack() as stack:
        idle = []
        for k in range(300):
            idle.append(stack.enter_context(socket.create_connection((at.hostname or "", at.port or 0), timeout=20)))
            if k % 2:
                idle[-1].sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n")
        assert get(links["command"])[0] == 200
        with stream(links["command"]) as page:
            assert said(page)["control"] is True
            for one in idle[: 300 - MOST_WITHOUT_TOKEN]:  # the oldest made room
                with contextlib.suppress(ConnectionResetError):
                    assert one.recv(1) == b""
            page.send('{"command": "hold", "sysid": 3, "id": 8}')
            assert said(page)["ok"] is True


def test_a_connection_has_a_while_for_its_headers_and_a_page_with_a_token_as_long_as_it_likes() -> None:
    loop = asyncio.new_event_loop()
    ended: list[str] = []

    def transport(name: str) -> Any:
        return SimpleNamespace(abort=lambda: ended.append(name))

    async def come() -> None:
        places = ConnectionLimit(within_s=0.05, most=2)
        for k, name in enumerate(("first", "page", "idle", "late")):
            places.come(("127.0.0.1", k), transport(name))
            if name == "page":
                places.admit(("127.0.0.1", k))
        assert ended == ["first"], "of too many without a token the oldest"
        done = asyncio.Event()
        asyncio.get_running_loop().call_later(0.2, done.set)
        await done.wait()

    loop.run_until_complete(come())
    loop.close()
    assert ended == ["first", "idle", "late"]
