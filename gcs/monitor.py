"""Any fleet on the air as a console's source: one socket, an observer, the wall clock; nothing to configure.

A monitor is passive: not a byte leaves its socket. With `control` it is a ground station: a HEARTBEAT each second to
whoever was heard, and hold, return and land for one vehicle, in its own autopilot's way.
"""

from __future__ import annotations

import contextlib
import math
import socket
import time
from collections.abc import Callable, Iterator, Mapping
from typing import Any, cast

from gcs.addresses import Address, address
from gcs.events import Event
from gcs.mavlink import codec, older
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.commands import CommandLong, CommandQueue, CommandResult, Step, Target
from gcs.mavlink.identities import STATION
from gcs.mavlink.sequence import SequenceCounter
from gcs.mavlink.station import OUR_HEARTBEAT
from gcs.observe import Observer
from gcs.profiles import End

SNAPSHOT_EVERY_S = 0.1
HEARTBEAT_EVERY_S = 1.0
COMMAND_TIMEOUT_S = 1.0
GONE_S = 5.0
"""A vehicle may come from another address once the one that it had has been silent for so long."""
CONNECT_WITHIN_S = 5.0
BUFFER_BYTES = 1 << 22
RECEIVE_BYTES = 65535
ORDERS: Mapping[str, End] = {"hold": "hold", "return": "return", "land": "land"}
FORM = "write udpin:HOST:PORT to listen, udpout:HOST:PORT or tcp:HOST:PORT to go to somebody who does"
_COMMAND_ACK = codec.msgid("COMMAND_ACK")

Peer = tuple[Any, ...]


class MonitorError(Exception):
    """Nothing can be heard there; one sentence."""


def place(text: str) -> Address:
    """Read an address. Raises MonitorError."""
    at = address(text, "udpin", "udpout", "tcp")
    if at is None:
        raise MonitorError(f"{text!r} is no address: {FORM}, such as udpin:127.0.0.1:14550.")
    return at


class Air:
    """The socket. Raises MonitorError where it cannot be had."""

    def __init__(self, at: Address) -> None:
        self._stream = at.way == "tcp"
        self._pending = b""
        self.open = True
        try:
            found = socket.getaddrinfo(at.host, at.port, type=socket.SOCK_STREAM if self._stream else socket.SOCK_DGRAM)
            family, kind, protocol, _, where = found[0]
            self._socket = socket.socket(family, kind, protocol)
        except OSError as error:
            raise MonitorError(f"{at.text}: {error.strerror}; {FORM}.") from None
        self._to: Peer | None = None if at.way == "udpin" else tuple(where)
        try:
            if at.way == "udpin":
                self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER_BYTES)
                self._socket.bind(where)
            elif self._stream:
                self._socket.settimeout(CONNECT_WITHIN_S)
                self._socket.connect(where)
            else:
                self._socket.bind(("::" if family == socket.AF_INET6 else "", 0))
            self._socket.setblocking(False)
        except OSError as error:
            self._socket.close()
            hint = "; another program listens there: end it, or let it forward to another port" if _taken(error) else ""
            raise MonitorError(f"{at.text}: {error.strerror or 'no answer'}{hint}.") from None

    @property
    def port(self) -> int:
        """The port that it is at."""
        return int(self._socket.getsockname()[1])

    def fileno(self) -> int:
        """The socket's."""
        return self._socket.fileno()

    def receive(self) -> Iterator[tuple[list[Frame], Peer]]:
        """What has come, with who sent it; never waits."""
        while self.open:
            try:
                data, peer = self._socket.recvfrom(RECEIVE_BYTES)
            except OSError as error:
                self.open = isinstance(error, BlockingIOError | ConnectionRefusedError) or not self._stream
                return
            if self._stream:
                if not data:
                    self.open = False
                    return
                yield self._cut(data), self._to or ()
                continue
            yield codec.split(data).frames or older.split(data), tuple(peer)

    def send(self, raw: bytes, peer: Peer) -> None:
        """Send a frame to somebody who was heard, or to the one that was gone to."""
        with contextlib.suppress(OSError):
            if self._stream:
                self._socket.sendall(raw)
            else:
                self._socket.sendto(raw, self._to or peer)

    @property
    def to(self) -> Peer | None:
        """Whom it goes to; None where it listens."""
        return self._to

    def close(self) -> None:
        """Close the socket."""
        self.open = False
        self._socket.close()

    def _cut(self, data: bytes) -> list[Frame]:
        """The frames that a stream's next bytes complete."""
        self._pending += data
        frames = codec.split(self._pending).frames
        if frames:
            last = frames[-1].raw
            self._pending = self._pending[self._pending.rindex(last) + len(last) :]
        self._pending = self._pending[-RECEIVE_BYTES:]
        return frames


def _taken(error: OSError) -> bool:
    return error.errno == 98  # EADDRINUSE


class MonitorSource:
    """A console's source that listens at an address. Raises MonitorError where it cannot."""

    def __init__(self, at: Address, *, control: bool = False, clock: Callable[[], float] = time.monotonic) -> None:
        self._air = Air(at)
        self._clock = clock
        self._begun_s = clock()
        self._observer = Observer("monitor", at.text)
        self._observer.control = control
        self._control = control
        self._peers: dict[int, tuple[Peer, float]] = {}
        self._refused: set[tuple[int, Peer]] = set()
        self._queues: dict[int, CommandQueue] = {}
        self._counter = SequenceCounter()
        self._replies: list[Mapping[str, Any]] = []
        self._shown_s = self._beat_s = -math.inf
        self._ended = False
        if at.way == "udpout" and not control:
            text = f"Nothing is sent to {at.text}: somebody who only answers will not be heard; --control speaks"
            self._observer.tell(Event(0.0, 0, "warning", text, "link"))

    @property
    def port(self) -> int:
        """The port that it is at."""
        return self._air.port

    def fileno(self) -> int:
        """For select: readable when something has come."""
        return self._air.fileno()

    @property
    def connected(self) -> bool:
        """Whether it listens."""
        return self._air.open

    def receive(self) -> list[Mapping[str, Any]]:
        """Listen; the messages since the last call."""
        t_s = self._clock() - self._begun_s
        for frames, peer in self._air.receive():
            for frame in frames:
                self._hear(frame, peer, t_s)
        if self._control:
            self._speak(t_s)
        messages, self._replies = self._replies, []
        if self._observer.changed:
            messages.append(self._observer.session())
        if t_s - self._shown_s >= SNAPSHOT_EVERY_S or not self._air.open:
            self._shown_s = t_s
            messages.append(self._observer.snapshot(t_s, speed=1.0, phase="flying"))
        if not self._air.open and not self._ended:
            self._ended = True
            messages.append({"type": "end", "outcome": "the other end has closed the connection", "exit": 0})
        return messages

    def send(self, command: Mapping[str, Any]) -> None:
        """Take `inspect`, and with control `hold`, `return` and `land`."""
        ok, text = self._obey(command)
        self._replies.append({"type": "reply", "id": command.get("id"), "ok": ok, "text": text})

    def close(self) -> None:
        """Listen no longer."""
        self._air.close()

    # in

    def _hear(self, frame: Frame, peer: Peer, t_s: float) -> None:
        observer = self._observer
        known = self._peers.get(frame.sysid)
        if known is not None and known[0] != peer and t_s - known[1] < GONE_S:
            if (frame.sysid, peer) not in self._refused:
                self._refused.add((frame.sysid, peer))
                text = f"Another vehicle says that it is {frame.sysid}, from {_where(peer)}: ignored"
                observer.tell(Event(t_s, frame.sysid, "warning", text, "link"))
            return
        observer.hear(frame, t_s)
        if frame.sysid not in observer.sysids:
            observer.overhear(frame)
            return
        self._peers[frame.sysid] = (peer, t_s)
        if frame.msgid == _COMMAND_ACK and (queue := self._queues.get(frame.sysid)) is not None:
            self._follow_up(frame.sysid, queue.on_ack(frame.sysid, frame.compid, codec.fields(frame), t_s), t_s)

    # out, with control only

    def _obey(self, command: Mapping[str, Any]) -> tuple[bool, str]:
        word, sysid = command.get("command"), command.get("sysid")
        known = isinstance(sysid, int) and not isinstance(sysid, bool) and sysid in self._observer.sysids
        if word == "inspect":
            if sysid is not None and not known:
                return False, f"No vehicle {sysid} has been heard."
            self._observer.inspection.want(() if sysid is None else (cast(int, sysid),))
            return True, "" if sysid is None else f"Snapshots tell everything that vehicle {sysid} sends."
        if not isinstance(word, str) or word not in ORDERS:
            return False, f"A monitor knows hold, return, land and inspect, not {word}."
        if not self._control:
            return False, "This monitor only watches; start it with --control to give orders."
        if not known:
            return False, f"No vehicle {sysid} has been heard."
        return self._order(cast(int, sysid), ORDERS[word])

    def _order(self, sysid: int, end: End) -> tuple[bool, str]:
        t_s = self._clock() - self._begun_s
        view = self._observer.view(t_s).vehicle(sysid)
        if not view.armed:
            return False, f"{view.label} is not armed: there is nothing to {end}."
        number, params = view.profile.ending(end)
        queue = self._queues.setdefault(sysid, CommandQueue(*STATION))
        order = CommandLong(Target(sysid, self._observer.component(sysid)), number, params)
        self._transmit(sysid, queue.send(order, t_s, COMMAND_TIMEOUT_S, token=end))
        self._observer.tell(Event(t_s, sysid, "info", f"Operator: {end}", "operator"))
        return True, f"{view.label} is told to {end}; what it answers is shown."

    def _speak(self, t_s: float) -> None:
        if t_s - self._beat_s >= HEARTBEAT_EVERY_S:
            self._beat_s = t_s
            raw = codec.frame(OUR_HEARTBEAT, self._counter.take(), *STATION)
            peers = {self._air.to} if self._air.to is not None else {peer for peer, _ in self._peers.values()}
            for peer in sorted(peers, key=str):
                self._air.send(raw, peer)
        for sysid, queue in self._queues.items():
            self._follow_up(sysid, queue.poll(t_s), t_s)

    def _follow_up(self, sysid: int, step: Step, t_s: float) -> None:
        self._transmit(sysid, step.messages)
        for result in step.results:
            if result.outcome == "timeout":
                self._observer.tell(Event(t_s, sysid, "warning", _unanswered(result), "ack"))

    def _transmit(self, sysid: int, messages: list[Message]) -> None:
        peer = self._peers[sysid][0]
        for message in messages:
            self._air.send(codec.frame(message, self._counter.take(), *STATION), peer)


def _unanswered(result: CommandResult) -> str:
    return f"{str(result.token).capitalize()} was not acknowledged, though it was sent {result.attempts} times"


def _where(peer: Peer) -> str:
    return f"{peer[0]}:{peer[1]}"
