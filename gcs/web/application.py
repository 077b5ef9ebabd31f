"""The server of the page: static files for any client on this machine, and the session's lines for clients with a
token.

Bound to 127.0.0.1. A page of another origin gets nothing: Host must name this machine (against DNS rebinding), and the
stream's Origin must be the page's own. The token is in the link's fragment, which no browser sends or logs; the page
gives it as a WebSocket subprotocol. There are two: one shows, one commands too. The session's report has an address
that cannot be guessed either; only pages that have shown a token learn it.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import secrets
from collections.abc import Awaitable, Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from gcs.web import document
from gcs.web.hub import Hub, PageListener
from gcs.web.tiles import server

HERE = frozenset({"127.0.0.1", "localhost", "::1"})
PROTOCOL = "skytender"
NO_TOKEN, FAR_BEHIND = 4401, 4408
MOST_COMMAND = 4096
"""Characters of a command."""
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:{tiles}; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
REPORT_POLICY = "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
"""Beside the policy that the report itself carries."""
OF_REPORT = {"Content-Security-Policy": REPORT_POLICY}
REPORT = "/report/"
HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}
ELSEWHERE = "This page is for the machine that it runs on: open it as http://127.0.0.1 or http://localhost.\n"

Send = Callable[[Mapping[str, Any]], object]


class Tokens(NamedTuple):
    """Tokens that open the stream: with `command` it takes commands too. `report` opens the session's report alone."""

    command: str
    view: str
    report: str

    @classmethod
    def fresh(cls) -> Tokens:
        """Tokens that cannot be guessed."""
        return cls(*(secrets.token_urlsafe(18) for _ in cls._fields))

    def commands(self, given: str) -> bool | None:
        """Whether this one lets a page command; None: it opens nothing."""
        if hmac.compare_digest(given.encode(), self.command.encode()):
            return True
        return False if hmac.compare_digest(given.encode(), self.view.encode()) else None


def policy(tiles: str | None) -> str:
    """Content-Security-Policy of the page, whose map's tiles come from `tiles`."""
    return POLICY.format(tiles="" if tiles is None else f" {server(tiles)}")


def application(
    hub: Hub,
    tokens: Tokens,
    send: Send,
    tiles: str | None = None,
    admit: Callable[[tuple[str, int] | None], object] = lambda _: None,
    report: Path | None = None,
) -> Starlette:
    """The ASGI application; `send` takes the commands of pages that may command, `admit` the address of each client
    that has shown a token. `report` is the file of the session's report, once there is one."""

    async def give_report(request: Request) -> Response:
        given = str(request.path_params["token"])
        if report is None or not hmac.compare_digest(given.encode(), tokens.report.encode()):
            return PlainTextResponse("Not Found", 404)
        try:
            body = await asyncio.to_thread(report.read_bytes)
        except OSError:
            return PlainTextResponse("There is no report yet.\n", 404)
        return Response(body, media_type="text/html; charset=utf-8")

    async def stream(socket: WebSocket) -> None:
        if not _own(socket.headers.get("origin"), socket.headers.get("host")):
            await socket.close()  # before it is accepted: an answer of 403
            return
        offered = [part.strip() for part in socket.headers.get("sec-websocket-protocol", "").split(",")]
        given = next((part.removeprefix("token.") for part in offered if part.startswith("token.")), "")
        commands = tokens.commands(given)
        await socket.accept(subprotocol=PROTOCOL if PROTOCOL in offered else None)
        if commands is None:
            await socket.close(NO_TOKEN, "the token is missing, or of another session")
            return
        admit(None if socket.client is None else (socket.client.host, socket.client.port))
        await _serve(socket, hub, commands, send)

    routes = [
        Route("/", _text(document.served(tiles), "text/html")),
        Route("/page.js", _text(document.built(document.SCRIPT), "text/javascript")),
        Route("/page.css", _text(document.built(document.STYLE), "text/css")),
        Route(REPORT + "{token}", give_report),
        WebSocketRoute("/stream", stream),
    ]
    made = Starlette(routes=routes)
    made.add_middleware(_Guard, headers={"Content-Security-Policy": policy(tiles), **HEADERS})
    return made


def _text(content: str, kind: str) -> Callable[[Request], Awaitable[Response]]:
    body = content.encode()

    async def give(_: Request) -> Response:
        return Response(body, media_type=f"{kind}; charset=utf-8")

    return give


class _Guard:
    """Refuses requests to other host names, and gives every answer the headers."""

    def __init__(self, app: Any, headers: Mapping[str, str]) -> None:
        self._app, self._headers = app, dict(headers)

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        host = next((value.decode("latin-1") for name, value in scope["headers"] if name == b"host"), "")
        if _name(f"//{host}") not in HERE:
            if scope["type"] == "http":
                await PlainTextResponse(ELSEWHERE, 403, headers=self._headers)(scope, receive, send)
            else:
                await send({"type": "websocket.close", "code": 1008})
            return

        async def guarded(message: Any) -> None:
            if message["type"] == "http.response.start":
                headers = self._headers | (OF_REPORT if scope["path"].startswith(REPORT) else {})
                message["headers"] += [(name.encode(), value.encode()) for name, value in headers.items()]
            await send(message)

        await self._app(scope, receive, guarded)


def _name(address: str) -> str | None:
    try:
        return urlsplit(address).hostname
    except ValueError:
        return None


def _own(origin: str | None, host: str | None) -> bool:
    """Whether a request comes from a page of this very server."""
    return bool(origin and host) and origin == f"http://{host}" and _name(origin) in HERE


async def _serve(socket: WebSocket, hub: Hub, commands: bool, send: Send) -> None:
    """One page, until it goes: lines out, commands in."""
    arrived = asyncio.Event()
    listener = hub.join(commands, arrived.set)
    speaking = asyncio.create_task(_speak(socket, listener, arrived))
    try:
        while True:
            text = await socket.receive_text()
            command = hub.command(listener, text) if len(text) <= MOST_COMMAND else None
            if command is not None:
                send(command)
    except (WebSocketDisconnect, KeyError, RuntimeError):
        pass  # it has gone, or has sent what is no text
    finally:
        hub.leave(listener)
        speaking.cancel()
        with contextlib.suppress(asyncio.CancelledError, Exception):
            await speaking


async def _speak(socket: WebSocket, listener: PageListener, arrived: asyncio.Event) -> None:
    while True:
        await arrived.wait()
        arrived.clear()
        while (line := listener.take()) is not None:
            await socket.send_text(line.decode())
        if listener.slow:
            await socket.close(FAR_BEHIND, "too far behind")
            return
