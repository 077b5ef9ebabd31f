"""MAVLink endpoints, as people write them: one grammar for scenarios and every command.

    udpin:HOST:PORT      listens for datagrams          udpout:HOST:PORT   sends to a listener
    tcpin:HOST:PORT      listens for connections        tcp:HOST:PORT      connects to a listener
    serial:DEVICE:BAUD   a cable or a telemetry radio, such as serial:/dev/ttyUSB0:57600

A host of IPv6 stands in brackets: udpin:[::1]:14550.
"""

import ipaddress
import re
from typing import NamedTuple

WAYS = ("udpin", "udpout", "tcp", "tcpin", "serial")
FORM = "udpin|udpout|tcp|tcpin:HOST:PORT or serial:DEVICE:BAUD"
EXAMPLE = "such as udpin:127.0.0.1:14550, tcp:127.0.0.1:5760 or serial:/dev/ttyUSB0:57600"
LISTENS = ("udpin", "tcpin")
_NETWORK = re.compile(r"(udpin|udpout|tcp|tcpin):(\[[0-9A-Fa-f:.]+\]|[^:\s\[\]]+):([0-9]{1,5})")
_SERIAL = re.compile(r"(serial):(/[^:\s]+):([0-9]{3,7})")
_BAUD = range(300, 4_000_001)

ONLY_ONCE = (
    "; a PX4 answers, at the port where it listens, only the first station since its start: connect by udpin "
    "where it speaks to, such as udpin:127.0.0.1:14540"
)
"""Hint where no vehicle answers at a `udpout`."""


class Endpoint(NamedTuple):
    """Address of one of the WAYS. The host of IPv6 stands here without its brackets; of `serial` it is the device, and
    the port its baud rate."""

    way: str
    host: str
    port: int

    @property
    def text(self) -> str:
        """The endpoint as it is written."""
        host = f"[{self.host}]" if ":" in self.host and self.way != "serial" else self.host
        return f"{self.way}:{host}:{self.port}"


def beyond_this_machine(text: str) -> bool:
    """Whether an address is a device, or one that others than this machine's users can reach or be reached at."""
    at = address(text)
    if at is None or at.way == "serial":
        return True
    try:
        return not ipaddress.ip_address(at.host).is_loopback
    except ValueError:
        return at.host != "localhost"


def address(text: str, *ways: str) -> Endpoint | None:
    """Endpoint that `text` names, if it is an address of one of these ways (without any: of all); a listener's port may
    be 0, any that is free."""
    match = _NETWORK.fullmatch(text) or _SERIAL.fullmatch(text)
    if match is None or match[1] not in (ways or WAYS):
        return None
    at = Endpoint(match[1], match[2].strip("[]"), int(match[3]))
    if at.way == "serial":
        return at if at.port in _BAUD else None
    return at if at.port < 65536 and (at.port or at.way in LISTENS) else None
