"""The link to vehicles that another program has started: plain MAVLink over UDP, TCP or a serial device.

A vehicle is known by its system id and component 1, and by the address of its first HEARTBEAT; the same ids from
another address are refused and reported. Two senders of the same ids before the session begins are `rivals`: it cannot
be known which is the vehicle. One that was silent for a while, or whose stream has ended, may go on from another
address. Several vehicles may speak to one port, each from its own address or all through one router or radio; one
vehicle may speak to several (gcs/link/external_peer.py). What has come by the tick is delivered at the tick. Where a
connection breaks it is made again, and the session goes on meanwhile.
"""

from __future__ import annotations

import math
import select
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence

from gcs.link.external_peer import ExternalPeer, PeerLink
from gcs.link.link import Key, LinkState
from gcs.link.open_address import OpenAddress, open_address, radio_in_words
from gcs.link.socket import BUFFER_BYTES, AddressRefused, Where
from gcs.mavlink import codec
from gcs.mavlink.boot_clock import CLOCKS, BootClock
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.command_protocol import CommandLong, CommandTarget
from gcs.mavlink.ids import AUTOPILOT, OUR_HEARTBEAT, STATION
from gcs.mavlink.services import vehicle_uid
from gcs.mavlink.services.lateness import TIMESYNC
from gcs.scenario.external import External
from skytender import mavlink as mav
from skytender.key_files import KeyRefused
from skytender.signing import SignatureVerdict

ANNOUNCE_EVERY_S = 1.0
REPEAT_AFTER_S = 0.2
"""A session that stands still for longer goes on sending its last set points: autopilots leave offboard without."""
MOST_UNKNOWN_SENDERS = 32
UNKNOWN_READ = 256
"""Most datagrams of unknown senders that are looked into before anything else has its turn."""
UNKNOWN_BYTES = 512
MOST_UIDS = 1024
UID_S = 1.0
"""Two with one id have so long to say their uids."""
CLAIM_S = 1.5
"""Time after a vehicle's first HEARTBEAT in which another sender may claim its id: a HEARTBEAT comes once a second."""
MOVED_AFTER_S = 10.0
"""A vehicle that has been silent for so long may be received from another address."""
MOVED_SIGNED_S = 2.0
"""The same of one that signs: no other sender has its key."""
_HEARTBEAT = codec.msgid("HEARTBEAT")
_RADIO_STATUS = codec.msgid("RADIO_STATUS")
RADIO_AGAIN_S = 30.0
_SET_POINT = codec.msgid("SET_POSITION_TARGET_LOCAL_NED")
_FOR_ALL_LINKS = frozenset({_HEARTBEAT, codec.msgid("REQUEST_DATA_STREAM")})
_COMMAND_LONG = codec.msgid("COMMAND_LONG")
_COMMAND_AT = codec.layout("COMMAND_LONG").record._fields.index("command")


class ExternalLink:
    """All vehicles of a session that were not launched."""

    def __init__(
        self, expected: Mapping[int, External], now_s: Callable[[], float], station: tuple[int, int] = STATION
    ) -> None:
        """Open each address; `now_s` reads the session's clock, `station` is our system and component id. Raises
        AddressRefused, KeyRefused."""
        self._now_s = now_s
        self.collected_s = -math.inf
        """when `collect` was called last, on the session's clock"""
        self._station = station
        self._addresses: dict[str, OpenAddress] = {}
        self._peers: dict[int, ExternalPeer] = {}
        self._poll = select.poll()
        self._kept = False
        self._announced_s = self._sent_s = -ANNOUNCE_EVERY_S
        self.refused: dict[Key, tuple[str, int]] = {}
        """vehicles with an id that another address has already, and from where; the first of each"""
        self.rivals: dict[Key, tuple[Where, Where]] = {}
        """vehicles claimed from two addresses before the session began"""
        self._moved: dict[Key, Where] = {}
        self.malformed = 0
        self._rebooted: set[int] = set()
        self._changes: list[tuple[int, str]] = []
        self._uids: dict[tuple[int, Where], str] = {}
        """of hardware, by system id and address"""
        self._twins: dict[Key, tuple[Where, Where, float]] = {}
        """vehicles with one id: the address that is kept, the other one, and since when both are asked for uids"""
        for sysid, external in expected.items():
            links = [PeerLink(self._opened(connect, external), connect) for connect in external.addresses]
            self._peers[sysid] = ExternalPeer((sysid, AUTOPILOT), links, links[0])
        for opened in self._addresses.values():
            self._poll.register(opened.connection.fileno(), select.POLLIN)

    @property
    def joined(self) -> set[Key]:
        """Vehicles that have been received and are still held."""
        return {peer.key for peer in self._peers.values() if peer.found}

    @property
    def missing(self) -> set[Key]:
        """Vehicles that have not been received yet."""
        return {peer.key for peer in self._peers.values() if not peer.found}

    @property
    def settled(self) -> bool:
        """Whether everyone is there, and has been for so long that a rival would have spoken."""
        now_s = time.monotonic()
        known = (link for peer in self._peers.values() for link in peer.links if link.address is not None)
        return not self.missing and all(
            link.opened.connection.to is not None or now_s - link.found_s >= CLAIM_S for link in known
        )

    @property
    def signature_refusals(self) -> dict[int, int]:
        """Frames refused for their signature, by system id."""
        return dict(sum((opened.gate.refused for opened in self._addresses.values()), Counter()))

    @property
    def signature_reasons(self) -> dict[int, SignatureVerdict]:
        """Why the last of them was refused."""
        return {sysid: why for opened in self._addresses.values() for sysid, why in opened.gate.reasons.items()}

    def twin_sentence(self, key: Key) -> str | None:
        """A sentence about a vehicle whose id another has, once both have said their uids or UID_S have passed."""
        kept, other, since_s = self._twins[key]
        uids = [self._uids.get((key[0], address)) for address in (other, kept)]
        if None in uids and time.monotonic() - since_s < UID_S:
            return None
        named = [f"{address[0]}:{address[1]}" for address in (other, kept)]
        return vehicle_uid.twins(key[0], *named, *[uid or "" for uid in uids])

    def pop_twins(self) -> list[tuple[int, str]]:
        """(system id, sentence) of vehicles whose id another has, each once."""
        said = [(key, text) for key in self._twins if (text := self.twin_sentence(key)) is not None and self._kept]
        for key, _ in said:
            del self._twins[key]
        return [(key[0], text) for key, text in said]

    def pop_moved(self) -> dict[Key, Where]:
        """Vehicles received from another address, after a silence, since the last call."""
        taken, self._moved = self._moved, {}
        return taken

    def waits(self) -> dict[int, str]:
        """Reasons why vehicles have not been received yet, by system id, where that can be seen."""
        texts = {}
        for sysid, peer in self._peers.items():
            reasons = [link.opened.diagnosis.text(link.opened.connection.problem, sysid) for link in peer.links]
            if not peer.found and any(reasons):
                texts[sysid] = "; ".join(filter(None, reasons))
        return texts

    def links(self) -> dict[int, list[LinkState]]:
        """Links of the vehicles that have several, in the scenario's order, by system id."""
        now_s = time.monotonic()
        return {sysid: peer.states(now_s) for sysid, peer in self._peers.items() if len(peer.links) > 1}

    def pop_relinked(self) -> set[int]:
        """As `Link.pop_relinked`."""
        taken = {sysid for sysid, peer in self._peers.items() if peer.relinked}
        for sysid in taken:
            self._peers[sysid].relinked = False
        return taken

    def pop_changes(self) -> list[tuple[int, str]]:
        """(system id, words) of vehicles that another link is used for since the last call."""
        taken, self._changes = self._changes, []
        return taken

    def pop_problems(self) -> list[tuple[str, str]]:
        """(address, its problem) of connections that have broken or have been mended since the last call; no problem:
        mended."""
        found = [(connect, opened.connection.pop_problem()) for connect, opened in self._addresses.items()]
        return [(connect, problem) for connect, problem in found if problem is not None]

    def pop_radios(self) -> list[tuple[str, str]]:
        """(address, words) of telemetry radios that are full or weak; again after RADIO_AGAIN_S while they are."""
        now_s, notices = time.monotonic(), []
        for connect, opened in self._addresses.items():
            if opened.radio and now_s - opened.radio_said_s >= RADIO_AGAIN_S:
                opened.radio_said_s = now_s
                notices.append((connect, opened.radio))
        return notices

    @property
    def buffer_bytes(self) -> int:
        """The least receive buffer that the kernel granted."""
        granted = (opened.connection.buffer_bytes() for opened in self._addresses.values())
        return min((size for size in granted if size is not None), default=BUFFER_BYTES)

    def overflowed(self) -> int:
        """Datagrams that the kernel dropped because they were not read in time."""
        return sum(opened.connection.overflowed() for opened in self._addresses.values())

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
            for opened in self._addresses.values():
                for address in sorted(opened.hearers, key=str):
                    opened.send(OUR_HEARTBEAT, address)
        self.rest(wait_s)
        self._choose()

    def begin(self) -> None:
        """The session's clock runs from now: what comes is kept for its ticks."""
        self._drain()
        self.pop_problems()
        self._kept = True
        for peer in self._peers.values():
            peer.clock = BootClock()
            peer.relinked = False

    def rest(self, wait_s: float) -> None:
        """Take in what comes in the next `wait_s`, when it comes."""
        deadline_s = time.monotonic() + wait_s
        while (left_s := deadline_s - time.monotonic()) > 0.0:
            if self._poll.poll(1e3 * left_s):
                self._drain()

    def grant(self, key: Key, messages: Sequence[Message], relayed: Sequence[bytes]) -> list[bytes]:
        """Send one vehicle what is for it now; the frames. The clock that it lives on needs no grant."""
        peer = self._peers[key[0]]
        self._sent_s = time.monotonic()
        set_points = [message for message in messages if message.msgid == _SET_POINT]
        peer.set_point = set_points[-1] if set_points else None
        items: list[Message | bytes] = [*messages, *relayed]
        sent = []
        for link in peer.links:
            to = link.address or link.opened.connection.to
            if to is not None:
                sent += [link.opened.send(item, to) for item in items if link is peer.used or _is_for_all_links(item)]
                if (question := link.trips.ask(self._sent_s)) is not None:
                    sent.append(link.opened.send(question, to))
        return sent

    def collect(self) -> dict[Key, list[Frame]]:
        """Frames received from each vehicle since the last call, in order of system id."""
        self._drain()
        self.collected_s = self._now_s()
        taken = {peer.key: peer.frames for _, peer in sorted(self._peers.items()) if peer.found}
        for peer in self._peers.values():
            peer.frames = []
        self._choose()  # now: frames of one collection are numbered alike
        return taken

    def stand_in(self) -> None:
        """While the session stands still: receive, and send the last set points again."""
        self._drain()
        if time.monotonic() - self._sent_s >= REPEAT_AFTER_S:
            self._sent_s = time.monotonic()
            for peer in self._peers.values():
                if peer.set_point is not None and peer.used.address is not None:
                    peer.used.opened.send(peer.set_point, peer.used.address)

    def close(self) -> None:
        """Close the connections."""
        for opened in self._addresses.values():
            opened.connection.close()
            opened.gate.close()

    def _choose(self) -> None:
        now_s = time.monotonic()
        for sysid, peer in self._peers.items():
            if len(peer.links) > 1 and (text := peer.choose(now_s)) and self._kept:
                self._changes.append((sysid, text))

    def _opened(self, connect: str, external: External) -> OpenAddress:
        if connect not in self._addresses:
            key_file = external.signing.key_file if external.signing else None
            try:
                self._addresses[connect] = open_address(connect, key_file, len(self._addresses), self._station)
            except (AddressRefused, KeyRefused):
                self.close()
                raise
        return self._addresses[connect]

    def _drain(self) -> None:
        now_s = time.monotonic()
        for opened in self._addresses.values():
            connection = opened.connection
            connection.tend(now_s)
            unknown = 0
            for data, sender in connection.receive():
                if sender in opened.speakers:
                    split = connection.split(data, sender)
                    self.malformed += split.malformed
                    self._receive(opened, split.frames, sender)
                elif unknown < UNKNOWN_READ:
                    unknown += 1
                    self._look_into(opened, data, sender)
            for sender in connection.pop_gone():
                self._cut_off(opened, sender)

    def _look_into(self, opened: OpenAddress, data: bytes, address: Where) -> None:
        """Bytes of a sender that is not yet a vehicle: no more of a datagram is read than UNKNOWN_BYTES."""
        if not opened.connection.stream:
            data = data[:UNKNOWN_BYTES]
        split = opened.connection.split(data, address)
        if opened.diagnosis.count(data, split) and len(opened.unknown_senders) < MOST_UNKNOWN_SENDERS:
            opened.unknown_senders.add(address)
        self._receive(opened, split.frames, address)

    def _cut_off(self, opened: OpenAddress, address: Where) -> None:
        """A stream has ended: its vehicles may come back there or elsewhere, at once."""
        for peer in self._peers.values():
            link = peer.link_of(opened)
            if link is not None:
                link.cut_off = link.cut_off or link.address == address
        opened.unknown_senders.discard(address)
        if opened.connection.to is None:
            opened.speakers.discard(address)
            opened.numbers.pop(address, None)

    def _receive(self, opened: OpenAddress, frames: Sequence[Frame], address: Where) -> None:
        now_s = time.monotonic()
        for frame in opened.gate.accepted(frames):
            if frame.msgid == _RADIO_STATUS and address in opened.speakers:
                opened.radio = radio_in_words(codec.fields(frame))
            peer = self._peers.get(frame.sysid)
            if peer is None:
                continue
            link = peer.link_of(opened)
            if frame.msgid == vehicle_uid.VERSION and frame.compid == AUTOPILOT and len(self._uids) < MOST_UIDS:
                self._uids[frame.sysid, address] = vehicle_uid.uid_of(codec.fields(frame))
            if link is not None and link.address != address and _is_autopilot(frame):
                self._claim(peer.key, link, address, now_s)
            if link is None or link.address != address:
                known = peer.found if link is None else link.address is not None
                if known and frame.compid == AUTOPILOT and peer.key not in self.refused:
                    self.refused[peer.key] = str(address[0]), int(address[1])
                    self._ask_uids(peer, opened, address)
                continue
            own = frame.compid == AUTOPILOT
            boot_s = codec.fields(frame).time_boot_ms / 1e3 if own and frame.msgid in CLOCKS else None
            text = peer.answered(link, frame, now_s) if own and frame.msgid == TIMESYNC else ""
            if self._kept and boot_s is not None:
                text = peer.judge(link, frame.msgid, boot_s, self._now_s(), now_s)
            if text:
                self._changes.append((frame.sysid, text))
            if link.late_s:
                continue
            taken = peer.takes(frame, link, now_s)
            link.received_s, link.cut_off = now_s, False
            rebooted = taken and own and frame.msgid == _HEARTBEAT and peer.begins_to_boot(frame)
            if self._kept and taken:
                peer.frames.append(frame)
                rebooted |= boot_s is not None and peer.clock.feed(frame.msgid, boot_s, self._now_s())
                self._rebooted |= {frame.sysid} if rebooted else set()

    def _ask_uids(self, peer: ExternalPeer, opened: OpenAddress, other: Where) -> None:
        """Ask a vehicle, and another that has its id, for the uids of their hardware."""
        known = next(link for link in peer.links if link.address is not None)
        assert known.address is not None
        self._twins[peer.key] = known.address, other, time.monotonic()
        for at, address in ((known.opened, known.address), (opened, other)):
            at.send(CommandLong(CommandTarget(*peer.key), *vehicle_uid.ASKED).message(0), address)

    def _claim(self, key: Key, link: PeerLink, address: Where, now_s: float) -> None:
        """A new address claims to be this vehicle."""
        silent_s = MOVED_SIGNED_S if link.opened.gate.has_key else MOVED_AFTER_S
        if link.address is None:
            link.found_s = now_s
        elif not self._kept and not link.cut_off:
            if key not in self.rivals:
                self.rivals[key] = link.address, address
                self._ask_uids(self._peers[key[0]], link.opened, address)
            return
        elif now_s - link.received_s < silent_s and not link.cut_off:
            return
        elif self._kept:
            self._moved[key] = address
        link.address, link.cut_off = address, False
        link.opened.speakers.add(address)


def _is_for_all_links(item: Message | bytes) -> bool:
    """Whether a message goes over all links of a vehicle: an autopilot sends streams on the port where it was asked."""
    if isinstance(item, bytes):
        return False
    if item.msgid in _FOR_ALL_LINKS:
        return True
    return item.msgid == _COMMAND_LONG and item.values[_COMMAND_AT] == mav.MAV_CMD_SET_MESSAGE_INTERVAL


def _is_autopilot(frame: Frame) -> bool:
    """Whether this is the HEARTBEAT of a vehicle, not of its camera, its companion or another ground station."""
    if frame.msgid != _HEARTBEAT or frame.compid != AUTOPILOT:
        return False
    return bool(codec.fields(frame).autopilot != mav.MAV_AUTOPILOT_INVALID)
