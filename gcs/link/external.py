"""The link to vehicles that another program has started: plain MAVLink over UDP, TCP or a serial device.

A vehicle is known by its system id and component 1, and by the address of its first HEARTBEAT; whoever says the same
from elsewhere is refused and reported. Two who say the same before the session begins are `rivals`: nobody can know
which is the vehicle. One that was silent for a while, or whose stream has ended, may go on from another address.
Several vehicles may speak to one port, each from its own address or all through one router or radio. What has come by
the tick is delivered at the tick. Where a connection breaks it is made again, and the session goes on meanwhile.
"""

from __future__ import annotations

import math
import select
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import common as mav

from gcs.link.addresses import open_connection
from gcs.link.connection import Channel
from gcs.link.diagnosis import Diagnosis
from gcs.link.keys import KeyRefused, SignatureGate
from gcs.link.link import Key
from gcs.link.socket import BUFFER_BYTES, AddressRefused, Where
from gcs.mavlink import codec
from gcs.mavlink.boot_clock import CLOCKS, BootClock
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ids import AUTOPILOT, OUR_HEARTBEAT, STATION
from gcs.mavlink.sequence import SequenceCounter
from gcs.mavlink.signing import SignatureVerdict
from gcs.scenario.endpoint import address
from gcs.scenario.external import External

ANNOUNCE_EVERY_S = 1.0
REPEAT_AFTER_S = 0.2
"""A session that stands still for longer goes on sending its last set points: autopilots leave offboard without."""
MOST_UNKNOWN_SENDERS = 32
UNKNOWN_READ = 256
"""Datagrams of those who are no vehicle of the session that are looked into before anything else has its turn."""
UNKNOWN_BYTES = 512
CLAIM_S = 1.5
"""So long after a vehicle's first HEARTBEAT somebody else may say that it is the one: it comes once a second."""
MOVED_AFTER_S = 10.0
"""A vehicle that has been silent for so long may be heard from another address."""
MOVED_SIGNED_S = 2.0
"""The same of one that signs: nobody else has its key."""
_HEARTBEAT = codec.msgid("HEARTBEAT")
_RADIO_STATUS = codec.msgid("RADIO_STATUS")
RADIO_FULL_PERCENT = 20
"""So little room in a telemetry radio's buffer: from there on it tells autopilots to send less, or loses frames."""
RADIO_WEAK = 15
"""So little between signal and noise at either end, in the radio's own steps (SiK: about half a dB each)."""
RADIO_AGAIN_S = 30.0
_SET_POINT = codec.msgid("SET_POSITION_TARGET_LOCAL_NED")


@dataclass
class _Door:
    """One `connect`: its connection, and who has spoken there."""

    connection: Channel
    gate: SignatureGate
    diagnosis: Diagnosis
    counters: dict[Where, SequenceCounter] = field(default_factory=dict)
    speakers: set[Where] = field(default_factory=set)
    """addresses of vehicles"""
    unknown_senders: set[Where] = field(default_factory=set)
    """senders of MAVLink 1: some autopilots change to MAVLink 2 when they receive it"""
    problem: str = ""
    """of the connection, as it was reported last"""
    radio: str = ""
    """problem of a telemetry radio on the way, by its last RADIO_STATUS, in words; empty where there is none"""
    radio_said_s: float = -math.inf

    @property
    def hearers(self) -> set[Where]:
        """Addresses to let know that a ground station is here."""
        to = self.connection.to
        return {to} if to is not None else self.speakers | self.unknown_senders | self.connection.senders

    def send(self, message: Message | bytes, address: Where) -> bytes:
        counter = self.counters.setdefault(address, SequenceCounter())
        raw = message if isinstance(message, bytes) else codec.frame(message, counter.next(), *STATION)
        raw = self.gate.signed(raw)
        self.connection.send(raw, address)
        return raw


@dataclass
class _ExternalPeer:
    """One vehicle."""

    key: Key
    door: _Door
    address: Where | None = None
    cut_off: bool = False
    """whether the stream from that address has ended"""
    found_s: float = 0.0
    received_s: float = 0.0
    clock: BootClock = field(default_factory=BootClock)
    frames: list[Frame] = field(default_factory=list)
    set_point: Message | None = None


class ExternalLink:
    """All vehicles of a session that were not launched."""

    def __init__(self, expected: Mapping[int, External], now_s: Callable[[], float]) -> None:
        """Open each address; `now_s` reads the session's clock. Raises AddressRefused, KeyRefused."""
        self._now_s = now_s
        self._doors: dict[str, _Door] = {}
        self._peers: dict[int, _ExternalPeer] = {}
        self._poll = select.poll()
        self._kept = False
        self._announced_s = self._sent_s = -ANNOUNCE_EVERY_S
        self.refused: dict[Key, tuple[str, int]] = {}
        """who spoke with an id that another address has already, and from where; the first of each"""
        self.rivals: dict[Key, tuple[Where, Where]] = {}
        """who was claimed from two addresses before the session began"""
        self._moved: dict[Key, Where] = {}
        self.malformed = 0
        self._rebooted: set[int] = set()
        for sysid, external in expected.items():
            if external.connect not in self._doors:
                try:
                    self._doors[external.connect] = _open(external)
                except (AddressRefused, KeyRefused):
                    self.close()
                    raise
            self._peers[sysid] = _ExternalPeer((sysid, AUTOPILOT), self._doors[external.connect])
        for door in self._doors.values():
            self._poll.register(door.connection.fileno(), select.POLLIN)

    @property
    def joined(self) -> set[Key]:
        """Vehicles that have been received and are still held."""
        return {peer.key for peer in self._peers.values() if peer.address is not None}

    @property
    def missing(self) -> set[Key]:
        """Vehicles that have not been received yet."""
        return {peer.key for peer in self._peers.values() if peer.address is None}

    @property
    def settled(self) -> bool:
        """Whether everyone is there, and has been for so long that a rival would have spoken."""
        now_s = time.monotonic()
        return not self.missing and all(
            peer.door.connection.to is not None or now_s - peer.found_s >= CLAIM_S for peer in self._peers.values()
        )

    @property
    def signature_refusals(self) -> dict[int, int]:
        """Frames refused for their signature, by system id."""
        return dict(sum((door.gate.refused for door in self._doors.values()), Counter()))

    @property
    def signature_reasons(self) -> dict[int, SignatureVerdict]:
        """Why the last of them was refused."""
        return {sysid: why for door in self._doors.values() for sysid, why in door.gate.reasons.items()}

    def pop_moved(self) -> dict[Key, Where]:
        """Vehicles received from another address, after a silence, since the last call."""
        taken, self._moved = self._moved, {}
        return taken

    def waits(self) -> dict[int, str]:
        """Reasons why vehicles have not been received yet, by system id, where that can be seen."""
        texts = {}
        for sysid, peer in self._peers.items():
            if peer.address is None and (text := peer.door.diagnosis.text(peer.door.connection.problem, sysid)):
                texts[sysid] = text
        return texts

    def pop_problems(self) -> list[tuple[str, str]]:
        """(address, its problem) of connections that have broken or have been mended since the last call; no problem:
        mended."""
        changed = []
        for connect, door in self._doors.items():
            problem = door.connection.problem
            if bool(problem) != bool(door.problem):
                changed.append((connect, problem))
            door.problem = problem
        return changed

    def pop_radios(self) -> list[tuple[str, str]]:
        """(address, words) of telemetry radios that are full or weak; again after RADIO_AGAIN_S while they are."""
        now_s, notices = time.monotonic(), []
        for connect, door in self._doors.items():
            if door.radio and now_s - door.radio_said_s >= RADIO_AGAIN_S:
                door.radio_said_s = now_s
                notices.append((connect, door.radio))
        return notices

    @property
    def buffer_bytes(self) -> int:
        """The least receive buffer that the kernel granted."""
        granted = (door.connection.buffer_bytes() for door in self._doors.values())
        return min((size for size in granted if size is not None), default=BUFFER_BYTES)

    def overflowed(self) -> int:
        """Datagrams that the kernel dropped because they were not read in time."""
        return sum(door.connection.overflowed() for door in self._doors.values())

    def offsets_s(self) -> dict[int, float]:
        """Offset from a vehicle's own time to the session's, s, by system id."""
        known = {sysid: peer.clock.offset_s for sysid, peer in self._peers.items()}
        return {sysid: offset_s for sysid, offset_s in known.items() if offset_s is not None}

    def pop_rebooted(self) -> set[int]:
        """System ids of vehicles whose clock has restarted since the last call."""
        taken, self._rebooted = self._rebooted, set()
        return taken

    def listen(self, wait_s: float) -> None:
        """Look for vehicles for at most `wait_s`, and let them know that a ground station is here."""
        now_s = time.monotonic()
        if now_s - self._announced_s >= ANNOUNCE_EVERY_S:
            self._announced_s = now_s
            for door in self._doors.values():
                for address in sorted(door.hearers, key=str):
                    door.send(OUR_HEARTBEAT, address)
        self.rest(wait_s)

    def begin(self) -> None:
        """The session's clock runs from now: what comes is kept for its ticks."""
        self._drain()
        self.pop_problems()
        self._kept = True
        for peer in self._peers.values():
            peer.clock = BootClock()

    def rest(self, wait_s: float) -> None:
        """Take in what comes in the next `wait_s`, when it comes."""
        deadline_s = time.monotonic() + wait_s
        while (left_s := deadline_s - time.monotonic()) > 0.0:
            if self._poll.poll(1e3 * left_s):
                self._drain()

    def grant(self, key: Key, messages: Sequence[Message], relayed: Sequence[bytes]) -> list[bytes]:
        """Send one vehicle what is for it now; the frames. The clock that it lives on needs no grant."""
        peer = self._peers[key[0]]
        assert peer.address is not None  # it has joined
        self._sent_s = time.monotonic()
        set_points = [message for message in messages if message.msgid == _SET_POINT]
        peer.set_point = set_points[-1] if set_points else None
        items: list[Message | bytes] = [*messages, *relayed]
        return [peer.door.send(item, peer.address) for item in items]

    def collect(self) -> dict[Key, list[Frame]]:
        """Frames received from each vehicle since the last call, in order of system id."""
        self._drain()
        taken = {peer.key: peer.frames for _, peer in sorted(self._peers.items()) if peer.address is not None}
        for peer in self._peers.values():
            peer.frames = []
        return taken

    def stand_in(self) -> None:
        """While the session stands still: receive, and send the last set points again."""
        self._drain()
        if time.monotonic() - self._sent_s >= REPEAT_AFTER_S:
            self._sent_s = time.monotonic()
            for peer in self._peers.values():
                if peer.set_point is not None and peer.address is not None:
                    peer.door.send(peer.set_point, peer.address)

    def close(self) -> None:
        """Close the connections."""
        for door in self._doors.values():
            door.connection.close()
            door.gate.close()

    def _drain(self) -> None:
        now_s = time.monotonic()
        for door in self._doors.values():
            connection = door.connection
            connection.tend(now_s)
            unknown = 0
            for data, sender in connection.receive():
                if sender in door.speakers:
                    split = connection.split(data, sender)
                    self.malformed += split.malformed
                    self._receive(door, split.frames, sender)
                elif unknown < UNKNOWN_READ:
                    unknown += 1
                    self._look_into(door, data, sender)
            for sender in connection.pop_gone():
                self._cut_off(door, sender)

    def _look_into(self, door: _Door, data: bytes, address: Where) -> None:
        """Bytes of somebody who is no vehicle yet: no more of a datagram is read than UNKNOWN_BYTES."""
        if not door.connection.stream:
            data = data[:UNKNOWN_BYTES]
        split = door.connection.split(data, address)
        if door.diagnosis.count(data, split) and len(door.unknown_senders) < MOST_UNKNOWN_SENDERS:
            door.unknown_senders.add(address)
        self._receive(door, split.frames, address)

    def _cut_off(self, door: _Door, address: Where) -> None:
        """A stream has ended: who spoke there may come back there or elsewhere, at once."""
        for peer in self._peers.values():
            peer.cut_off = peer.cut_off or (peer.door is door and peer.address == address)
        door.unknown_senders.discard(address)
        if door.connection.to is None:
            door.speakers.discard(address)
            door.counters.pop(address, None)

    def _receive(self, door: _Door, frames: Sequence[Frame], address: Where) -> None:
        now_s = time.monotonic()
        for frame in door.gate.accepted(frames):
            peer = self._peers.get(frame.sysid)
            if frame.msgid == _RADIO_STATUS and address in door.speakers:
                door.radio = _radio_in_words(codec.fields(frame))
            if peer is None:
                continue
            if peer.address != address and peer.door is door and _is_autopilot(frame):
                self._claim(peer, address, now_s)
            if peer.address != address or peer.door is not door:
                if peer.address is not None and frame.compid == AUTOPILOT:
                    self.refused.setdefault(peer.key, (str(address[0]), int(address[1])))
                continue
            peer.received_s, peer.cut_off = now_s, False
            if self._kept:
                peer.frames.append(frame)
                if frame.msgid in CLOCKS and frame.compid == AUTOPILOT:
                    boot_s = codec.fields(frame).time_boot_ms / 1e3
                    rebooted = peer.clock.feed(frame.msgid, boot_s, self._now_s())
                    self._rebooted |= {frame.sysid} if rebooted else set()

    def _claim(self, peer: _ExternalPeer, address: Where, now_s: float) -> None:
        """Somebody says that it is this vehicle, from an address from which nobody did."""
        silent_s = MOVED_SIGNED_S if peer.door.gate.has_key else MOVED_AFTER_S
        if peer.address is None:
            peer.found_s = now_s
        elif not self._kept and not peer.cut_off:
            self.rivals.setdefault(peer.key, (peer.address, address))
            return
        elif now_s - peer.received_s < silent_s and not peer.cut_off:
            return
        elif self._kept:
            self._moved[peer.key] = address
        peer.address, peer.received_s, peer.cut_off = address, now_s, False
        peer.door.speakers.add(address)


def _radio_in_words(status: Any) -> str:
    """Words about a RADIO_STATUS that a person should know of; empty where all is well."""
    if status.txbuf <= RADIO_FULL_PERCENT:
        return f"its radio has {status.txbuf} % of its buffer left: fewer vehicles behind it, or a faster air rate"
    ends = (("here", status.rssi, status.noise), ("at the other end", status.remrssi, status.remnoise))
    for where, signal, noise in ends:
        if 0 < signal < 255 and 0 < noise < 255 and signal - noise < RADIO_WEAK:
            return f"its radio's signal {where} is weak: {signal}, noise {noise}"
    return ""


def _is_autopilot(frame: Frame) -> bool:
    """Whether this is the HEARTBEAT of a vehicle, not of its camera, its companion or another ground station."""
    if frame.msgid != _HEARTBEAT or frame.compid != AUTOPILOT:
        return False
    return bool(codec.fields(frame).autopilot != mav.MAV_AUTOPILOT_INVALID)


def _open(external: External) -> _Door:
    at = address(external.connect)
    assert at is not None  # as the scenario has checked
    gate = SignatureGate(Path(external.signing.key_file) if external.signing else None)
    return _Door(open_connection(at, alone=True), gate, Diagnosis(at))
