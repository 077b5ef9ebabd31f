"""MAVLink endpoints, as people write them: udpin:HOST:PORT listens, udpout: and tcp:HOST:PORT go to a listener."""

import re
from typing import NamedTuple

_FORM = re.compile(r"(udpin|udpout|tcp):(\[[0-9A-Fa-f:.]+\]|[^:\s\[\]]+):([0-9]{1,5})")


ONLY_ONCE = (
    "; a PX4 answers nobody at the port where it listens but who spoke there first since its start: hear it by udpin "
    "where it speaks to, such as udpin:127.0.0.1:14540"
)
"""Hint where no vehicle answers at a `udpout`."""


class Endpoint(NamedTuple):
    """Address to listen at (`udpin`), or to send to. The host of IPv6 stands here without its brackets."""

    way: str
    host: str
    port: int

    @property
    def text(self) -> str:
        """The endpoint as it is written."""
        return f"{self.way}:{f'[{self.host}]' if ':' in self.host else self.host}:{self.port}"


def address(text: str, *ways: str) -> Endpoint | None:
    """Endpoint that `text` names, if it is an address of one of these ways; a listener's port may be 0, any that is
    free."""
    match = _FORM.fullmatch(text)
    if match is None or match[1] not in ways:
        return None
    at = Endpoint(match[1], match[2].strip("[]"), int(match[3]))
    return at if at.port < 65536 and (at.port or at.way == "udpin") else None
