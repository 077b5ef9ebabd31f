"""ConnectionLimit of the page's server: a client with a token keeps one, all others share a few for a short while.

A connection that sends no request, or asks for nothing but files, ends by itself; of too many the oldest ends. So
clients without a token, any program on this machine, use up no descriptors and keep no client with a token out.
"""

from __future__ import annotations

import asyncio

from uvicorn.protocols.http.h11_impl import H11Protocol

WITHOUT_TOKEN_S = 10.0
"""A connection without a token has so long, for its headers and for all that it reads."""
MOST_WITHOUT_TOKEN = 64

Client = tuple[str, int]


class ConnectionLimit:
    """Connections without a token, by the client's address, in the order in which they came."""

    def __init__(self, within_s: float = WITHOUT_TOKEN_S, most: int = MOST_WITHOUT_TOKEN) -> None:
        self._within_s, self._most = within_s, most
        self._waiting: dict[Client, tuple[asyncio.Transport, asyncio.TimerHandle]] = {}

    def come(self, client: Client, transport: asyncio.Transport) -> None:
        """Give a connection a place for a while."""
        if len(self._waiting) >= self._most:
            self._end(next(iter(self._waiting)))
        timer = asyncio.get_running_loop().call_later(self._within_s, self._end, client)
        self._waiting[client] = transport, timer

    def admit(self, client: Client | None) -> None:
        """Let a connection stay, which has shown a token or has ended."""
        if client is not None and (found := self._waiting.pop(client, None)) is not None:
            found[1].cancel()

    def _end(self, client: Client) -> None:
        transport, timer = self._waiting.pop(client)
        timer.cancel()
        transport.abort()


def protocol(places: ConnectionLimit) -> type[asyncio.Protocol]:
    """uvicorn's HTTP, each of whose connections begins with one of these places."""

    class PlacedHttp(H11Protocol):
        """HTTP over a connection that has a place."""

        def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
            """It has come."""
            super().connection_made(transport)
            if self.client is not None:
                places.come(self.client, transport)

        def connection_lost(self, exc: Exception | None) -> None:
            """It has gone, as HTTP: what goes over to a WebSocket does so without this."""
            places.admit(self.client)
            super().connection_lost(exc)

    return PlacedHttp
