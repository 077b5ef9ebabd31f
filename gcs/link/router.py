"""All launched vehicles behind one address of any kind: TCP, a serial device, a UDP port where others speak first."""

from __future__ import annotations

import contextlib
import socket

from gcs.link.forwarder import Forwarder
from gcs.link.socket import MOST_AT_ONCE, RECEIVE_BYTES, Where, widen
from gcs.scenario.endpoint import Endpoint

MOST_VEHICLES = 254


class VehicleRouter:
    """Passes on what vehicles send at a port of this machine to an address, and what comes from there to all of them:
    each takes what names it."""

    def __init__(self, at: Endpoint) -> None:
        """Raises AddressRefused."""
        self.far = Forwarder([at.text])
        self._near = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._near.setblocking(False)
        widen(self._near)
        self._near.bind(("127.0.0.1", 0))
        self._vehicles: set[Where] = set()

    @property
    def near(self) -> str:
        """Address that vehicles speak to."""
        return f"udpout:127.0.0.1:{self._near.getsockname()[1]}"

    def filenos(self) -> tuple[int, int]:
        """For select: readable when something has come."""
        return self._near.fileno(), self.far.filenos()[0]

    def pump(self) -> None:
        """Pass on what has come, a bounded piece of it, and connect again where that is due."""
        frames: list[bytes] = []
        for _ in range(MOST_AT_ONCE):
            try:
                datagram, vehicle = self._near.recvfrom(RECEIVE_BYTES)
            except OSError:
                break
            if len(self._vehicles) < MOST_VEHICLES:
                self._vehicles.add(vehicle)
            if vehicle in self._vehicles:
                frames.append(datagram)
        self.far.send(frames)
        for received in self.far.receive():
            for vehicle in self._vehicles:
                with contextlib.suppress(OSError):
                    self._near.sendto(received.frame.raw, vehicle)

    def close(self) -> None:
        """Close both sides."""
        self._near.close()
        self.far.close()
