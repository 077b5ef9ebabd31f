"""The supervised link, and the ground station's only fleet socket: docs/protocol/link.md#clock-and-supervised-link.

One UDP socket holds every vehicle's link; a vehicle is known by its (system, component), by the secret in its first
hello, which only the processes of the session have, and from then on by the address that this came from. A datagram
from anywhere else is not read. A bundle goes out to each, and the tick is in when all have answered; a vehicle that is
missing gets the same bytes again. Vehicles of one process share an address: several bundles, each marked with its
vehicle, make a datagram, and so do several answers.
"""

from __future__ import annotations

import contextlib
import random
import secrets
import select
import socket
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain, count, groupby
from operator import itemgetter

import numpy as np

from gcs.frame_spans import FrameSpans
from gcs.link.bundles import NO_SOCKET, DatagramGatherer, Recipients
from gcs.link.inbox import FULL, NOTHING, UNKNOWN, Address, Ints
from gcs.link.intake import Intake, numbered
from gcs.link.link import Answers, Key, TickGrants, TickLink
from gcs.link.socket import kernel_drops, widen
from gcs.mavlink import codec
from gcs.mavlink.boot_clock import ComparedClocks
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.datagram import FrameRun, runs_of
from gcs.mavlink.frame_runs import NOWHERE, NUMBERS
from gcs.mavlink.ids import STATION
from gcs.mavlink.sequence import TickCollector, hello_of

DATAGRAM_BYTES = 1400
RECEIVE_BYTES = 16_384
"""A longer datagram is no answer, and is cut."""
HELLO_BYTES = 64
"""No hello is longer."""
YIELDS = 100
"""So often the processor is left to others before a tick's late answers are slept for. A vehicle that has a process to
itself answers in some ten microseconds, and the sleep would cost as much; several together take so long that looking
again and again would take time from them."""
MOST_AT_ONCE = 4096
"""Datagrams that are taken in before anything else has its turn."""
SECRET_BITS = 64
RESEND_FIRST_S, RESEND_LAST_S = 0.02, 0.2
REPEAT_S = 1.0
GRANT_BYTES = codec.HEADER_BYTES + 12 + codec.CRC_BYTES


@dataclass
class _LockstepPeer:
    """One vehicle's link."""

    key: Key
    address: Address
    marker: bytes
    """begins each bundle where the address is shared"""
    collector: TickCollector
    number_cell: memoryview = field(default_factory=lambda: np.zeros(1, np.int64).data)
    """the number of the next frame, where the recipients of the tick counts it on"""
    waiting: list[Message | bytes] = field(default_factory=list)
    bundle: bytes = b""
    """the last one that was made for it alone,"""
    bundle_ms: int = -1
    """and what that grants"""
    held: int = 0


@dataclass
class _Origin:
    """The peers at one address."""

    number: int
    """of the address, as `Intake` knows it"""
    address: Address
    shared: bool
    peers: dict[int, _LockstepPeer] = field(default_factory=dict)
    """by system id"""

    @property
    def first(self) -> _LockstepPeer:
        """The sole peer at this address, where it is not shared."""
        return next(iter(self.peers.values()))


class LockstepLink(TickLink):
    """All supervised links of a session: every vehicle is waited for, and has one link."""

    def __init__(self, *, host: str = "127.0.0.1", drop: float = 0.0, seed: int = 0, unpaced: bool = False) -> None:
        """Bind a port of the system's choice. `drop` loses that share of datagrams, both ways, below the protocol.
        `unpaced`: the next tick begins as soon as all have answered, so that a short sleep counts."""
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setblocking(False)
        widen(self._socket)
        self._socket.bind((host, 0))
        self.host = host
        self._poll = select.poll()
        self._poll.register(self._socket, select.POLLIN)
        self._drop = drop
        self._random = random.Random(seed)
        self.secret = secrets.randbits(SECRET_BITS - 1) + 1
        """the secret in this session's hellos; never 0, which stands for none"""
        self._peers: dict[Key, _LockstepPeer] = {}
        self._by_address: dict[Address, _Origin] = {}
        self._origins: dict[int, _Origin] = {}
        """by number"""
        self._intake = Intake(MOST_AT_ONCE, RECEIVE_BYTES, HELLO_BYTES)
        self._enrolled = False
        self._unpaced = unpaced
        self._yields = 0
        self._numbers = count()
        self._datagrams = DatagramGatherer(self._send_datagram)
        self._recipients: Recipients | None = None
        self._granted: list[_LockstepPeer] = []
        """the peers of the recipients"""
        self._bundles: tuple[bytes, Ints, Mapping[Key, int], int] = (b"", np.empty((0, 3), np.int64), {}, -1)
        """bundles that were made at once: the bytes, where each lies, by key, and what they grant"""
        """of the last tick"""
        self._expected: set[Key] = set()
        self._awaited: set[Key] = set()
        self._waiting: set[Key] = set()
        """vehicles with more waiting frames than fitted into their last bundle"""
        self._whole: deque[Key] = deque()
        self.refused: dict[Key, Address] = {}
        """ids that were claimed by other senders, with the first address of each"""
        self.rivals: dict[Key, Address] = {}
        """the same of senders with the session's secret: two of its own processes claim one vehicle's id"""
        self.malformed = 0
        self.resent = 0
        self._clocks = ComparedClocks()
        self._granted_ms = 0

    @property
    def port(self) -> int:
        """The port that vehicles speak to."""
        return int(self._socket.getsockname()[1])

    @property
    def signature_refusals(self) -> dict[int, int]:
        """As `Link.signature_refusals`: none; the link is private."""
        return {}

    @property
    def buffer_bytes(self) -> int:
        """The receive buffer that the kernel granted."""
        return self._socket.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) // 2

    @property
    def joined(self) -> set[Key]:
        """Vehicles that have said hello and are still held."""
        return set(self._peers)

    @property
    def awaited(self) -> list[Key]:
        """Vehicles that have not answered the last grant yet."""
        return sorted(self._awaited)

    def overflowed(self) -> int:
        """Datagrams that the kernel dropped because they were not read in time."""
        return kernel_drops(self._socket)

    def expect(self, keys: Iterable[Key]) -> None:
        """Let these vehicles join when they say hello."""
        self._expected |= set(keys)

    def listen(self, wait_s: float) -> set[Key]:
        """Receive hellos for at most `wait_s`; those still expected."""
        self._poll.poll(1e3 * wait_s)
        self._drain()
        return self._expected - self.joined

    def leave(self, key: Key) -> None:
        """Hold a vehicle no longer: an unfinished answer is dropped, the others go on."""
        peer = self._peers.pop(key, None)
        self._recipients = None
        self._enrolled = False
        self._intake.dismiss(key)
        if peer is not None:
            origin = self._by_address[peer.address]
            del origin.peers[key[0]]
            if not origin.peers:
                del self._by_address[peer.address], self._origins[origin.number]
                self._intake.inbox.forget(origin.number)
        self._expected.discard(key)
        self._awaited.discard(key)
        self._waiting.discard(key)

    def grant(
        self, key: Key, t_ms: int, unix_us: int, messages: Sequence[Message], relayed: Sequence[bytes], air: bytes = b""
    ) -> list[bytes]:
        """Send one vehicle its bundle up to T, at `flush` at the latest; the frames that it holds. What does not fit
        waits for the next one, but for `air`, which may take a bundle beyond DATAGRAM_BYTES."""
        peer = self._peers[key]
        if not peer.waiting and not relayed and len(messages) <= SURELY_FIT:
            frames = [self._frame(peer, message) for message in messages]
        else:
            frames = self._fitting(peer, messages, relayed)
        if air:
            frames.append(air)
        frames.append(self._frame(peer, codec.Message(_SYSTEM_TIME, (unix_us, t_ms))))
        peer.bundle, peer.bundle_ms = peer.marker + b"".join(frames), t_ms
        peer.collector.begin(t_ms)
        self._granted_ms = t_ms
        self._awaited.add(key)
        self._send(peer)
        return frames

    def grant_all(self, grants: TickGrants) -> Sequence[bytes]:
        """As `grant`, one after the other; bundles of nothing but HEARTBEAT and set point are made at once."""
        recipients, peers = self._recipients_of(grants.keys), self._granted
        general: list[int] = []
        if grants.more or self._waiting:
            general = [k for k, peer in enumerate(peers) if peer.waiting or peer.key in grants.more]
        at_once = not general and recipients.in_turn and not self._drop
        if general or not self._enrolled or not self._intake.begin(grants.keys, grants.t_ms):
            for k in set(range(len(peers))).difference(general):
                peers[k].collector.begin(grants.t_ms)
        raw, cuts, spans = recipients.bundled(general, grants, self._socket.fileno() if at_once else NO_SOCKET)
        self._bundles = (raw, cuts, recipients.rows_of, grants.t_ms)
        self._awaited.update(grants.keys)
        self._granted_ms = grants.t_ms
        frames = FrameSpans(raw, spans)
        if at_once:
            return frames
        sent: list[Sequence[bytes]] = []
        first = counted = 0
        places: list[tuple[int, int, int]] = cuts.tolist()
        for k in (*general, len(peers)):
            self._datagrams.put_all(recipients, raw, places, first, k)
            behind = places[k][2] if k < len(peers) else len(frames)
            sent.append(frames[counted:behind])
            if k < len(peers):
                key = peers[k].key
                sent.append(self.grant(key, grants.t_ms, grants.unix_us, *grants.content(key)))
            first, counted = k + 1, behind
        return FrameSpans.joined(sent)

    def _recipients_of(self, keys: Sequence[Key]) -> Recipients:
        if self._recipients is None or self._recipients.keys != keys:
            self._granted = peers = [self._peers[key] for key in keys]
            self._recipients = Recipients(keys, [peer.marker for peer in peers], [peer.address for peer in peers])
            for peer, cell in zip(peers, self._recipients.number_cells(), strict=True):
                cell[0] = peer.number_cell[0]
                peer.number_cell = cell
        return self._recipients

    def _fitting(self, peer: _LockstepPeer, messages: Sequence[Message], relayed: Sequence[bytes]) -> list[bytes]:
        """Frames of as much of what waits for a vehicle as fits into a bundle, our own before relayed ones."""
        peer.waiting += [*messages, *relayed]
        own: list[bytes] = []
        foreign: list[bytes] = []
        size = GRANT_BYTES
        taken = 0
        for item in peer.waiting:
            frame = item if isinstance(item, bytes) else self._frame(peer, item)
            size += len(frame)
            (foreign if isinstance(item, bytes) else own).append(frame)
            taken += 1
            if size > DATAGRAM_BYTES - _LARGEST_FRAME:
                break
        del peer.waiting[:taken]
        (self._waiting.add if peer.waiting else self._waiting.discard)(peer.key)
        return [*own, *foreign]

    def answers(self, idle: Callable[[], None]) -> Iterator[Answers]:
        """Every vehicle's answer to the last grant: answers that fill datagrams come all together at the end,
        the others each as soon as it is whole.

        Waits without spinning, but for some looks at the beginning; after 20 ms without progress, doubling to 200 ms,
        the same bytes go out again to those that are missing, and `idle` is called: it sees whether they still live and
        may call `leave`. Those that have answered get their last bundle every second, so that one that stalls does not
        make the others leave.
        """
        self._enrol()
        self._drain(self._yields)
        if self._awaited or self._whole:
            yield from self._late_answers(idle)
        for keys, runs in self._intake.answers():
            for k, key in enumerate(keys if self._clocks else ()):
                self._clocks.feed(key, runs[k], self._granted_ms / 1e3)
            yield keys, runs

    def _late_answers(self, idle: Callable[[], None]) -> Iterator[Answers]:
        """Wait until all have answered; the answers that were read frame by frame."""
        now_s = time.monotonic()
        wait_s, deadline_s, repeat_s = RESEND_FIRST_S, now_s + RESEND_FIRST_S, now_s + REPEAT_S
        while self._awaited or self._whole:
            while self._whole:
                key = self._whole.popleft()
                if key in self._peers:
                    self._peers[key].held = 0
                    frames = self._peers[key].collector.pop_frames()
                    self._clocks.feed(key, frames, self._granted_ms / 1e3)
                    yield [key], [frames]
            if not self._awaited:
                continue
            left_s = deadline_s - time.monotonic()
            if left_s > 0.0:
                self._poll.poll(1e3 * left_s)
                if self._drain():
                    wait_s = RESEND_FIRST_S
                    deadline_s = time.monotonic() + wait_s
                continue
            idle()
            for key in sorted(self._awaited):
                self.resent += 1
                self._send(self._peers[key])
            self.flush()
            wait_s = min(2.0 * wait_s, RESEND_LAST_S)
            deadline_s = time.monotonic() + wait_s
            if time.monotonic() >= repeat_s:
                self.repeat()
                repeat_s = time.monotonic() + REPEAT_S

    def _enrol(self) -> None:
        """Tell the intake which vehicles are there."""
        if not self._enrolled:
            vehicles = []
            for key, peer in sorted(self._peers.items()):
                origin = self._by_address[peer.address]
                received = origin.shared or origin.first is peer
                vehicles.append((key, peer.collector, origin.number if received else NOWHERE))
            self._intake.enrol(vehicles)
            shared = any(origin.shared for origin in self._origins.values())
            self._yields = YIELDS if self._unpaced and not shared else 0
            self._enrolled = True

    def begin(self) -> None:
        """As `Link.begin`: vehicles live on the session's clock."""

    def compare_clocks(self, keys: Iterable[Key]) -> None:
        """Compare the own clocks of these vehicles, whose autopilot is not ours, with the session's."""
        self._clocks = ComparedClocks(keys)

    def clock_offsets_s(self) -> dict[int, float]:
        """As `Link.clock_offsets_s`, of vehicles with compared clocks."""
        return self._clocks.offsets_s()

    def pop_rebooted(self) -> set[int]:
        """As `Link.pop_rebooted`, of vehicles with compared clocks."""
        return self._clocks.pop_rebooted()

    def repeat(self) -> None:
        """Send every last bundle again, so that vehicles know during a pause that they are not forgotten."""
        for peer in self._peers.values():
            if self._bundle(peer):
                self._send(peer)
        self.flush()
        self._drain()

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()

    def _frame(self, peer: _LockstepPeer, message: Message) -> bytes:
        number = peer.number_cell[0]
        peer.number_cell[0] = (number + 1) % NUMBERS
        return codec.frame(message, number, *STATION)

    def flush(self) -> None:
        """Send the bundles that are gathered for shared addresses."""
        self._datagrams.flush()

    def _send(self, peer: _LockstepPeer) -> None:
        self._datagrams.put(peer.address, self._bundle(peer), shared=bool(peer.marker))

    def _bundle(self, peer: _LockstepPeer) -> bytes:
        """The last one that went to a vehicle; nothing before the first."""
        raw, cuts, rows, t_ms = self._bundles
        if peer.bundle_ms < t_ms and (row := rows.get(peer.key)) is not None:
            begin, end, _ = cuts[row].tolist()
            return raw[begin:end]
        return peer.bundle

    def _send_datagram(self, address: Address, datagram: bytes) -> None:
        if self._drop and self._random.random() < self._drop:
            return
        with contextlib.suppress(OSError):
            self._socket.sendto(datagram, address)

    def _drain(self, yields: int = 0) -> bool:
        """Take in the datagrams that have come, MOST_AT_ONCE at most; whether any tick made progress. `yields`: as
        `Inbox.receive`."""
        progress, left = False, MOST_AT_ONCE
        intake, inbox, fd = self._intake, self._intake.inbox, self._socket.fileno()
        while left > 0 and (self._awaited or not progress):  # what else there is can wait
            lost = self._drop > 0.0 and self._random.random() < self._drop
            most = 1 if self._drop else len(self._awaited) or 1
            met = intake.receive(fd, most, left, yields=yields, lost=lost)
            left, yields = left - inbox.taken, 0
            stray = inbox.stray() if met in (UNKNOWN, FULL) else None
            progress |= self._take_in()
            if met == NOTHING:
                break
            if stray is None:
                continue
            datagram, address = stray
            if (origin := self._by_address.get(address)) is not None:
                progress |= self._receive(origin, datagram)
            elif len(datagram) <= HELLO_BYTES:
                self._admit(codec.split(datagram).frames, address)
        return progress

    def _take_in(self) -> bool:
        """See whose answers were found in datagrams, and read what else there is in them; whether any tick made
        progress."""
        progress = False
        inbox = self._intake.inbox
        while True:
            found = len(inbox.answered)
            if found == len(self._awaited):
                self._awaited.clear()
            elif found:
                self._awaited.difference_update(self._intake.answered())
            progress |= found > 0
            rest = inbox.stopped()
            if rest is None:
                return progress
            if (origin := self._origins.get(rest[0])) is not None:
                progress |= self._receive(origin, rest[1])
            self._intake.receive(-1, 0, 0)

    def _receive(self, origin: _Origin, datagram: bytes) -> bool:
        """Take in what one address has sent, frame by frame; whether any tick made progress."""
        runs: Sequence[Sequence[Frame]] | None = runs_of(datagram)
        if runs is None:
            frames, malformed, *_ = codec.split(datagram)
            self.malformed += malformed
            runs = [list(run) for _, run in groupby(frames, _SENDER)]
        if not origin.shared:
            return self._feed(origin.first, runs[0] if len(runs) == 1 else list(chain.from_iterable(runs)))
        progress = False
        for run in runs:
            peer = origin.peers.get(run.sender[0] if isinstance(run, FrameRun) else run[0].sysid)
            if peer is None:
                self._admit(run, origin.address)
            else:
                progress |= self._feed(peer, run)
        return progress

    def _feed(self, peer: _LockstepPeer, frames: Sequence[Frame]) -> bool:
        """Take in frames of a vehicle's answer; whether its tick made progress."""
        if peer.collector.feed(frames) and peer.key in self._awaited:
            self._awaited.discard(peer.key)
            self._whole.append(peer.key)
        progress = peer.collector.held > peer.held
        peer.held = peer.collector.held
        return progress

    def _admit(self, frames: Sequence[Frame], address: Address) -> None:
        """Admit a peer that says hello with the session's secret; remember one that does so without it."""
        hello = hello_of(frames)
        if hello is None:
            return
        key = (frames[0].sysid, frames[0].compid)
        if key not in self._expected:
            return
        if hello.secret != self.secret:
            self.refused.setdefault(key, address)
        elif key in self._peers:
            self.rivals.setdefault(key, address)
        else:
            marker = _marker(key) if hello.shared else b""
            peer = self._peers[key] = _LockstepPeer(key, address, marker, TickCollector(*key))
            self._enrolled = False
            if address not in self._by_address:
                number = numbered(next(self._numbers), shared=hello.shared)
                self._by_address[address] = self._origins[number] = _Origin(number, address, hello.shared)
                self._intake.inbox.know(address, number)
            self._by_address[address].peers[key[0]] = peer


def _marker(key: Key) -> bytes:
    """The frame that says whose the following bundle is: a PING to it, which is not numbered."""
    about = {"time_usec": 0, "seq": 0, "target_system": key[0], "target_component": key[1]}
    return codec.frame(codec.message("PING", **about), 0, *STATION)


_SENDER = itemgetter(0)
_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")
_LARGEST_FRAME = codec.HEADER_BYTES + 255 + codec.CRC_BYTES
SURELY_FIT = (DATAGRAM_BYTES - GRANT_BYTES) // _LARGEST_FRAME - 1
"""So many messages fit into a bundle whatever they are."""
