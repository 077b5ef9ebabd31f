"""From an address, as people write it, to its connection."""

from __future__ import annotations

from gcs.link.connection import Channel, UdpConnection
from gcs.link.tcp import TcpClient, TcpListener
from gcs.scenario.endpoint import Endpoint


def open_connection(at: Endpoint, *, alone: bool = False) -> Channel:
    """The connection of an address; what another try cannot mend is refused at once. Raises AddressRefused.

    alone: a udpout takes nothing but from where it sends to.
    """
    if at.way in ("udpin", "udpout"):
        return UdpConnection(at, alone=alone)
    if at.way == "serial":
        from gcs.link.serial_device import SerialConnection  # noqa: PLC0415 - only cables need its library

        return SerialConnection(at)
    return TcpClient(at) if at.way == "tcp" else TcpListener(at)
