"""A source's messages for Foxglove as they come, by its WebSocket protocol on this machine; foxglove-sdk serves it.

It shows and takes no command. Any program on this machine may look: the protocol has no token.
"""

from __future__ import annotations

import socket
import time
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from gcs.report.foxglove import Topics

if TYPE_CHECKING:
    from gcs.session.client import MessageSource

PORT = 8765
"""Where Foxglove looks first."""
LOOK_EVERY_S = 0.05


class _Arrivals:
    """Notes that a new client must be shown the present state."""

    def __init__(self) -> None:
        self.new = False

    def on_subscribe(self, client: object, channel: Any) -> None:
        """Called by the server's own thread."""
        self.new |= channel.topic in ("/scene", "/session")

    def on_unsubscribe(self, client: object, channel: Any) -> None:
        """Nothing to do."""


def serve(
    source: MessageSource,
    ready: Callable[[str], object],
    *,
    clock_ns: Callable[[], int] = time.time_ns,
    sleep: Callable[[float], object] = time.sleep,
) -> None:
    """Serve until the source's end; `ready` gets the address. Closes the source. Raises OSError without a port."""
    import foxglove  # noqa: PLC0415 - an extra

    topics: Topics | None = None
    session: Mapping[str, Any] = {}
    arrivals = _Arrivals()
    server = None
    try:
        while True:
            for line in source.receive():
                kind = line.get("type")
                if kind == "session":
                    session, arrivals.new = line, True
                elif kind == "snapshot":
                    if topics is None:
                        topics = Topics(clock_ns() - round(1e9 * line["t_s"]))
                        server = foxglove.start_server(
                            name=f"Skytender: {session.get('name')}",
                            port=_free_port(),
                            context=topics.context,
                            server_listener=arrivals,  # type: ignore[arg-type]
                        )
                        ready(f"ws://127.0.0.1:{server.port}")
                    if arrivals.new:
                        arrivals.new = False
                        topics.session(session, line["t_s"])
                    topics.snapshot(line)
                elif kind == "end":
                    return
            sleep(LOOK_EVERY_S)
    finally:
        if server is not None:
            server.stop()
        source.close()


def _free_port() -> int:
    """Foxglove's own, or another one where that is taken."""
    for port in (PORT, 0):
        with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as tried:
            tried.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                tried.bind(("127.0.0.1", port))
            except OSError:
                continue
            return tried.getsockname()[1]
    raise OSError("no port is free on this machine")
