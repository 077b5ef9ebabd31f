"""A vehicle on the supervised link, driven by hand by the rules of docs/protocol/link.md#vehicle-side-of-the-link."""

import random
import socket
from collections.abc import Callable
from typing import Any

from gcs.link.link import Key
from gcs.link.lockstep import LockstepLink
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ids import STATION

SYSTEM_TIME, HEARTBEAT, PING = map(codec.msgid, ("SYSTEM_TIME", "HEARTBEAT", "PING"))
BEAT = {"type": 2, "autopilot": 12, "base_mode": 0, "custom_mode": 0, "system_status": 3}


def collect(link: LockstepLink, idle: Callable[[], None]) -> dict[Key, list[Frame]]:
    """Every vehicle's answer to the last grant, in order of (system, component)."""
    answers = (one for keys, frames in link.answers(idle) for one in zip(keys, frames, strict=True))
    return dict(sorted(answers))


def heartbeat() -> Message:
    return codec.message("HEARTBEAT", **BEAT)


def text(k: int) -> Message:
    return codec.message("STATUSTEXT", severity=6, text=f"{k:04d}".ljust(50, "x"))


class Vehicle:
    """Answers a grant once every number since the last one is there, and repeats the same bytes when asked again."""

    def __init__(self, link: LockstepLink, sysid: int = 1, extra: int = 2, drop: float = 0.0) -> None:
        self.sysid = sysid
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setblocking(False)
        self.socket.connect(("127.0.0.1", link.port))
        self.secret = link.secret
        self.t_ms = -1
        self.seq, self.expected, self.extra = 2, 0, extra
        self.bundles: list[bytes] = []
        self.heard: list[Frame] = []
        self.last = b""
        self._random, self._drop = random.Random(sysid), drop

    def frame(self, name: str, seq: int, **values: Any) -> bytes:
        return codec.encode(name, seq, self.sysid, 1, **values)

    def hello(self) -> None:
        stamp = {"time_unix_usec": self.secret, "time_boot_ms": 0}
        self.socket.send(self.frame("HEARTBEAT", 0, **BEAT) + self.frame("SYSTEM_TIME", 1, **stamp))

    def pump(self) -> None:
        """Take every datagram that has come, and answer."""
        while True:
            try:
                bundle = self.socket.recv(65535)
            except BlockingIOError:
                return
            self.bundles.append(bundle)
            self.take(codec.split(bundle).frames)

    def take(self, frames: list[Frame]) -> None:
        granted_ms = codec.fields(frames[-1]).time_boot_ms
        if granted_ms == self.t_ms:
            self.send()
            return
        own = [frame for frame in frames if (frame.sysid, frame.compid) == STATION]
        assert [frame.seq for frame in own] == [(self.expected + k) % 256 for k in range(len(own))]
        self.expected = (self.expected + len(own)) % 256
        self.heard += frames
        self.t_ms = granted_ms
        told = [self.frame("HEARTBEAT", 0, **BEAT) for _ in range(self.extra)]
        told.append(self.frame("SYSTEM_TIME", 0, time_unix_usec=0, time_boot_ms=granted_ms))
        numbered = []
        for raw in told:
            message = codec.split(raw).frames[0]
            numbered.append(codec.frame(Message(message.msgid, tuple(codec.fields(message))), self.seq, self.sysid, 1))
            self.seq = (self.seq + 1) % 256
        self.last = b"".join(numbered)
        self.send()

    def send(self) -> None:
        if self._random.random() >= self._drop:
            self.socket.send(self.last)
