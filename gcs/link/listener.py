"""Any address without a fleet that is known before: split into frames, with their senders; sends only when asked to.

Each is spoken to as it speaks. An autopilot may begin with MAVLink 1 and change when it receives MAVLink 2, or know no
other: what is for all, as our HEARTBEAT, goes out in MAVLink 2, and to an address with a MAVLink 1 sender also
in that; what is for one vehicle in the version of its last frame.
"""

from __future__ import annotations

import contextlib
import select
import time
from collections.abc import Iterator
from pathlib import Path

from gcs.link.addresses import open_connection
from gcs.link.diagnosis import Diagnosis
from gcs.link.keys import SignatureGate
from gcs.link.socket import Where
from gcs.mavlink import dialect
from gcs.mavlink.codec import Frame, target_of
from gcs.scenario.endpoint import Endpoint

MOST_OLDER = 1024
"""Senders of MAVLink 1 that are known at once."""


class Listener:
    """Frames received at an address, with their senders. A connection that breaks is made again."""

    def __init__(self, at: Endpoint, key_file: Path | None = None, *, older: bool = False) -> None:
        """older: read MAVLink 1 too. Raises AddressRefused, KeyRefused."""
        self._older = older
        self._speaks_older: set[tuple[Where, int]] = set()
        """addresses and system ids with a last frame in MAVLink 1"""
        self.gate = SignatureGate(key_file)
        self.connection = open_connection(at)
        self._diagnosis = Diagnosis(at)
        self.open = True

    def use_key(self, key_file: Path | None) -> None:
        """From now on sign, and take only what is signed, with another key, or none. Raises KeyRefused."""
        gate = SignatureGate(key_file)
        self.gate.close()
        self.gate = gate

    @property
    def silence(self) -> str:
        """Reason why no vehicle is received, where that can be seen."""
        return self._diagnosis.text(self.connection.problem)

    def wait(self, wait_s: float) -> None:
        """Wait until something has come, at most so long."""
        self.connection.tend(time.monotonic())
        select.select([self.connection], [], [], wait_s)

    def receive(self) -> Iterator[tuple[list[Frame], Where]]:
        """Frames received, with their senders, of a bounded number of datagrams; never waits."""
        if not self.open:
            return
        self.connection.tend(time.monotonic())
        for data, sender in self.connection.receive():
            split = self.connection.split(data, sender)
            self._speaks_older -= {(sender, frame.sysid) for frame in split.frames}
            if len(self._speaks_older) < MOST_OLDER:
                self._speaks_older |= {(sender, frame.sysid) for frame in split.older}
            if self._older:
                split = split._replace(frames=[*split.frames, *split.older], older=[])
            self._diagnosis.count(data, split)
            yield self.gate.accepted(split.frames), sender
        self.connection.pop_gone()

    def send(self, raw: bytes, peer: Where, *, unsigned: bool = False) -> None:
        """Send a MAVLink 2 frame to a known sender, or to the one address that it speaks to; signed, where there is a
        key. A peer that speaks MAVLink 1 is answered in it where possible."""
        to = self.connection.to or peer
        here = {sysid for address, sysid in self._speaks_older if address == peer}
        for_all = (target := target_of(raw)) == 0
        older = None
        if (for_all and here) or target in here:
            with contextlib.suppress(ValueError):  # it has no such message
                older = dialect.older_form(raw)
        if for_all or older is None:
            self.connection.send(raw if unsigned else self.gate.signed(raw), to)
        if older is not None:
            self.connection.send(older, to)

    @property
    def older_senders(self) -> set[Where]:
        """Addresses from which MAVLink 1 comes."""
        return {address for address, _ in self._speaks_older}

    def close(self) -> None:
        """Close the connection."""
        self.open = False
        self.connection.close()
        self.gate.close()
