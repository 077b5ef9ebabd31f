"""Other ground stations beside this one: all that vehicles say goes out to them, and what they say comes in.

Addresses are as in `gcs/link/connection.py`. A `udpin` sends to the stations that sent MAVLink there lately. Nothing
waits: what a station does not take is lost to it, and one that is not there costs nothing.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import NamedTuple

from gcs.link.addresses import open_connection
from gcs.link.connection import Channel
from gcs.link.keys import SignatureGate
from gcs.link.socket import AddressRefused, Where
from gcs.mavlink.codec import Frame
from gcs.scenario.endpoint import address

MOST_STATIONS = 8
"""A udpin sends to so many."""
SILENT_S = 10.0
"""A station at a udpin that has been silent for so long is sent nothing more."""
YIELDS_S = 3.0
"""One that has been silent for so long makes room for another, where all places are taken."""
READ_AT_ONCE = 256
"""Pieces of one address that are looked into at a tick; the rest of what has come waits."""


class FromStation(NamedTuple):
    """A frame that another ground station has sent, and its name."""

    frame: Frame
    by: str


class Forwarder:
    """All addresses that a session forwards to."""

    def __init__(self, addresses: Sequence[str]) -> None:
        """Open them. Raises AddressRefused."""
        self._channels: list[Channel] = []
        self._stations: dict[tuple[int, Where], float] = {}
        """when each station was last received at a udpin, by the place of its address"""
        self._gate = SignatureGate(None)
        for text in addresses:
            at = address(text)
            assert at is not None  # as the scenario has checked
            try:
                self._channels.append(open_connection(at, alone=True))
            except AddressRefused:
                self.close()
                raise

    def send(self, frames: Sequence[bytes]) -> None:
        """Send frames as they are to everyone."""
        now_s = time.monotonic()
        self._stations = {key: heard_s for key, heard_s in self._stations.items() if now_s - heard_s < SILENT_S}
        for place, channel in enumerate(self._channels):
            channel.tend(now_s)
            if channel.to is not None:
                hearers = [channel.to]
            elif channel.stream:
                hearers = list(channel.senders)
            else:
                hearers = [sender for at, sender in self._stations if at == place]
            for hearer in hearers:
                for raw in frames:
                    channel.send(raw, hearer)

    def receive(self) -> list[FromStation]:
        """Frames that stations have sent, signed ones apart: their key is not ours."""
        received: list[FromStation] = []
        now_s = time.monotonic()
        for place, channel in enumerate(self._channels):
            for pieces, (data, sender) in enumerate(channel.receive(), 1):
                split = channel.split(data, sender)
                frames = self._gate.accepted(split.frames)
                if not channel.stream and (frames or split.older):  # many begin with MAVLink 1, until they hear 2
                    self._note(place, sender, now_s)
                received += [
                    FromStation(frame, f"{frame.sysid}/{frame.compid} at {channel.at.text}") for frame in frames
                ]
                if pieces >= READ_AT_ONCE:
                    break
            channel.pop_gone()
        return received

    def pop_problems(self) -> list[tuple[str, str]]:
        """(address, its problem) of addresses that have been lost or found since the last call; no problem: found."""
        found = [(channel.at.text, channel.pop_problem()) for channel in self._channels]
        return [(at, problem) for at, problem in found if problem is not None]

    @property
    def addresses(self) -> list[str]:
        """The addresses, with the ports that the system chose."""
        return [channel.at._replace(port=channel.port or channel.at.port).text for channel in self._channels]

    def filenos(self) -> list[int]:
        """For select: readable when something has come."""
        return [channel.fileno() for channel in self._channels]

    def close(self) -> None:
        """Close them."""
        for channel in self._channels:
            channel.close()
        self._gate.close()

    def _note(self, place: int, sender: Where, now_s: float) -> None:
        if (place, sender) not in self._stations and len(self._stations) >= MOST_STATIONS:
            idle = min(self._stations, key=self._stations.__getitem__)
            if now_s - self._stations[idle] < YIELDS_S:
                return
            del self._stations[idle]
        self._stations[place, sender] = now_s
