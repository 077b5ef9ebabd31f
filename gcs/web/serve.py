"""Serves a source (`gcs.session.client.MessageSource`) to browsers until it is asked to end."""

from __future__ import annotations

import asyncio
import socket
from collections import deque
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import uvicorn

from gcs.session.client import NO_LAST_WORD, MessageSource
from gcs.web.application import REPORT, Tokens, application
from gcs.web.connection_limit import ConnectionLimit, protocol
from gcs.web.hub import Hub

LOOK_EVERY_S = 0.05
GRACE_S = 1
"""time for the pages to learn that the server ends"""


def links(at: socket.socket, tokens: Tokens) -> dict[str, str]:
    """The links to print: `command` may command, `view` may look."""
    host, port = at.getsockname()
    opening = {"command": tokens.command, "view": tokens.view}
    return {name: f"http://{host}:{port}/#token={token}" for name, token in opening.items()}


def serve(
    source: MessageSource,
    ready: Callable[[Mapping[str, str]], object],
    tiles: str | None = None,
    report: Path | None = None,
    over: int | None = None,
    stays: Callable[[], object] = lambda: None,
) -> None:
    """Serve until the source's end, SIGINT or SIGTERM; `ready` gets the links when they work. Closes the source.

    tiles: address of the map's tiles, as `gcs.web.tiles.checked` takes it. report: where the report of the source's
    session will be; a server that has one goes on after the source's end, with the report, if a page was ever opened,
    and calls `stays` then. over: a descriptor whose end is the source's too, which may never have begun.
    """
    tokens, hub, places = Tokens.fresh(), Hub(), ConnectionLimit()
    orders: deque[Mapping[str, Any]] = deque()
    config = uvicorn.Config(
        application(hub, tokens, orders.append, tiles, places.admit, report),
        http=protocol(places),
        log_level="critical",
        access_log=False,
        lifespan="off",
        ws="websockets-sansio",
        ws_max_size=1 << 16,
        ws_per_message_deflate=False,  # the page is on this machine
        server_header=False,
        timeout_graceful_shutdown=GRACE_S,
    )
    server = uvicorn.Server(config)

    async def feed() -> None:
        ended = asyncio.Event()
        if over is not None:
            asyncio.get_running_loop().add_reader(over, ended.set)
        feeding = asyncio.create_task(_feed(source, hub, orders))
        gone = asyncio.create_task(ended.wait())
        await asyncio.wait((feeding, gone), return_when=asyncio.FIRST_COMPLETED)
        if over is not None:
            asyncio.get_running_loop().remove_reader(over)
        await asyncio.wait((feeding,), timeout=GRACE_S)  # what the session said last may still come
        feeding.cancel()
        gone.cancel()
        if not hub.ended:
            hub.take([NO_LAST_WORD])
        await asyncio.sleep(GRACE_S)
        if report is not None and hub.visited:
            stays()
        while report is not None and hub.visited:
            if not hub.reported and await asyncio.to_thread(report.is_file):
                hub.report(REPORT + tokens.report)
            await asyncio.sleep(LOOK_EVERY_S)
        server.should_exit = True

    async def run(at: socket.socket) -> None:
        feeding = asyncio.create_task(feed())
        ready(links(at, tokens))
        try:
            await server.serve(sockets=[at])
        finally:
            feeding.cancel()
            await asyncio.gather(feeding, return_exceptions=True)
            source.close()

    with socket.create_server(("127.0.0.1", 0), backlog=64) as at:  # of this machine alone
        asyncio.run(run(at))


async def _feed(source: MessageSource, hub: Hub, orders: deque[Mapping[str, Any]]) -> None:
    """Ask the source every so often, until it has ended; a recording that is sought through, or a slow parse, holds up
    no page."""

    def exchange() -> list[Mapping[str, Any]]:
        while orders:
            source.send(orders.popleft())
        return source.receive()

    while not hub.ended:
        hub.take(await asyncio.to_thread(exchange))
        await asyncio.sleep(LOOK_EVERY_S)
