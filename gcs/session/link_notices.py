"""Notices about the links of a session, for people: peers that are refused, moved or lost, each once."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from gcs.link.keys import RefusalNotices
from gcs.link.link import Key, Link
from gcs.telemetry.events import Level

if TYPE_CHECKING:  # most sessions have neither
    from gcs.link.external import ExternalLink
    from gcs.link.forwarder import Forwarder

Notice = tuple[int, Level, str]
"""System id that it concerns, or 0; how much it matters; a sentence."""


class LinkNotices:
    """Notices of one session."""

    def __init__(self, link: Link, external: ExternalLink | None, forwarder: Forwarder | None) -> None:
        self._link, self._external, self._forwarder = link, external, forwarder
        self._reported: set[Key] = set()
        self._refusals = RefusalNotices()

    def poll(self, now_s: float, *, begun: bool) -> Iterator[Notice]:
        """Notices since the last call, at `now_s` of the monotonic clock; `begun`: the session's clock runs."""
        external = self._external.refused.keys() if self._external is not None else ()
        for key in self._link.refused.keys() - self._reported - set(external):
            self._reported.add(key)
            host, port = self._link.refused[key]
            yield key[0], "warning", f"Another vehicle says that it is {key[0]}, from {host}:{port}: ignored"
        if self._external is not None:
            yield from self._of_externals(self._external, now_s, begun=begun)
        for to, problem in self._forwarder.pop_problems() if self._forwarder is not None else ():
            text = f"Nothing is forwarded to {to}: {problem}" if problem else f"All is forwarded to {to} again"
            yield 0, "warning" if problem else "info", text

    def _of_externals(self, link: ExternalLink, now_s: float, *, begun: bool) -> Iterator[Notice]:
        for (sysid, _), address in link.pop_moved().items():
            yield sysid, "warning", f"Heard from {address[0]}:{address[1]} now, after a silence"
        for sysid, text in [*link.pop_twins(), *link.pop_changes()]:
            yield sysid, "warning", text
        for connect, problem in link.pop_problems() if begun else ():
            text = f"{connect} is lost: {problem}" if problem else f"{connect} is there again"
            yield 0, "critical" if problem else "info", text
        for connect, text in link.pop_radios():
            yield 0, "warning", f"{connect}: {text}"
        for sysid, text in self._refusals.poll(link.signature_refusals, link.signature_reasons, now_s):
            yield sysid, "critical", text
