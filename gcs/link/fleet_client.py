"""All vehicles at an address, asked at once, before or after they fly: in dialogues, and for messages by name."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any, Protocol

from gcs.link.listener import Listener
from gcs.link.socket import Where
from gcs.mavlink import codec
from gcs.mavlink.autopilots import Profile, profile_of
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.command_protocol import CommandLong, CommandTarget
from gcs.mavlink.ids import AUTOPILOT, OUR_HEARTBEAT, STATION
from gcs.mavlink.sequence import sequence_numbers
from gcs.scenario.endpoint import Endpoint
from skytender import mavlink as mav

POLL_S = 0.02
HEARTBEAT_EVERY_S = 1.0
ASK_EVERY_S = 1.0
SETTLED_S = 1.5
"""So long after the last newcomer the fleet is taken for complete: a HEARTBEAT comes once a second."""


class VehicleClient(Protocol):
    """One side of a dialogue with one vehicle; times are of the monotonic clock, s."""

    sysid: int
    compid: int

    @property
    def done(self) -> bool:
        """Whether nothing is open."""

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""


class FleetClient:
    """The vehicles, and the connection to them. Raises AddressRefused, KeyRefused."""

    def __init__(self, at: Endpoint, key_file: Path | None = None, station: tuple[int, int] = STATION) -> None:
        """`station`: our system and component id."""
        self._station = station
        self.listener = Listener(at, key_file, older=True)
        self._numbers = sequence_numbers()
        self._heartbeat_s = -HEARTBEAT_EVERY_S
        self._where: dict[int, Where] = {}
        self._components: dict[tuple[int, int], Where] = {}
        """where a component that is no autopilot says HEARTBEAT from, by system and component id"""
        self._seconds: dict[int, Where] = {}
        """where another autopilot of a vehicle's system id says HEARTBEAT from"""
        self.doubled: dict[int, Where] = {}
        """the same, once the first one has been received after it: a vehicle that has moved to another port is not
        two"""
        self.profiles: dict[int, Profile] = {}
        """by system id, of vehicles that have been received"""
        self.armed: set[int] = set()
        """whose last HEARTBEAT said so"""

    def find(self, wanted: Collection[int], within_s: float) -> bool:
        """Listen until all of these vehicles have been received, or, where none is named, until no more come; whether
        that was within this time."""
        begun_s = newest_s = time.monotonic()
        while (now_s := time.monotonic()) - begun_s < within_s:
            before = len(self.profiles)
            self._receive()
            newest_s = newest_s if len(self.profiles) == before else now_s
            if set(wanted) <= self.profiles.keys() if wanted else self.profiles and now_s - newest_s >= SETTLED_S:
                break
        if wanted:
            self.profiles = {sysid: profile for sysid, profile in self.profiles.items() if sysid in wanted}
        return bool(self.profiles) and set(wanted) <= self.profiles.keys()

    @property
    def not_understood(self) -> dict[int, str]:
        """Reasons why those are not among the vehicles whose frames are refused for their signatures, by system id."""
        reasons = self.listener.gate.reasons.items()
        return {
            sysid: str(why) for sysid, why in reasons if sysid not in {*self.profiles, *STATION[:1], *self._station[:1]}
        }

    def converse(
        self,
        clients: Collection[VehicleClient],
        progress: Callable[[], object] = lambda: None,
        at_once: int | None = None,
    ) -> None:
        """Have all dialogues to their ends, side by side, or so many at once."""
        while under_way := [client for client in clients if not client.done][:at_once]:
            self.exchange(under_way)
            progress()

    def exchange(self, clients: Collection[VehicleClient]) -> None:
        """Take in what has come, for POLL_S at most, and send what is due."""
        by_address = {(client.sysid, client.compid): client for client in clients}
        for frame in self._receive():
            client = by_address.get((frame.sysid, frame.compid))
            if client is not None:
                try:
                    client.receive(codec.name(frame.msgid), codec.fields(frame), time.monotonic())
                except ValueError:  # a message that no dialect of ours holds
                    continue
        for client in clients:
            for message in client.poll(time.monotonic()):
                self.send_to(client.sysid, message, client.compid)

    def send_to(self, sysid: int, message: Message, compid: int = AUTOPILOT) -> None:
        """Send a message to a vehicle that has been received: to its component's address, else to its autopilot's."""
        to = self._address(sysid, compid)
        assert to is not None
        self._send(message, to)

    def request(
        self, names: Collection[str], within_s: float, sysids: Collection[int] | None = None
    ) -> dict[int, dict[str, Any]]:
        """Ask these vehicles, or all, for messages once a second, until all have come or the time is up; the latest
        fields of each that came, by system id and name."""
        numbers = {codec.msgid(name): name for name in names}
        told: dict[int, dict[str, Any]] = {sysid: {} for sysid in (self.profiles if sysids is None else sysids)}
        begun_s, asked_s = time.monotonic(), -math.inf
        while (now_s := time.monotonic()) - begun_s < within_s and any(len(t) < len(numbers) for t in told.values()):
            if now_s - asked_s >= ASK_EVERY_S:
                asked_s = now_s
                for sysid, so_far in told.items():
                    for number in [n for n, name in numbers.items() if name not in so_far]:
                        target = CommandTarget(sysid, AUTOPILOT)
                        ask = CommandLong(target, mav.MAV_CMD_REQUEST_MESSAGE, (float(number),))
                        self.send_to(sysid, ask.message(0))
            for frame in self._receive():
                if frame.msgid in numbers and frame.compid == AUTOPILOT and frame.sysid in told:
                    told[frame.sysid][numbers[frame.msgid]] = codec.fields(frame)
        return told

    def close(self) -> None:
        """Close the connection."""
        self.listener.close()

    def _receive(self) -> list[Frame]:
        now_s = time.monotonic()
        self.listener.connection.tend(now_s)
        if now_s - self._heartbeat_s >= HEARTBEAT_EVERY_S:
            self._heartbeat_s = now_s
            to = self.listener.connection.to
            for address in {to} if to is not None else {*self._where.values(), *self.listener.connection.senders}:
                self._send(OUR_HEARTBEAT, address)
        self.listener.wait(POLL_S)
        received: list[Frame] = []
        for frames, sender in self.listener.receive():
            for frame in frames:
                if frame.msgid == mav.MAVLINK_MSG_ID_HEARTBEAT and frame.compid != AUTOPILOT:
                    self._components.setdefault((frame.sysid, frame.compid), sender)
                elif frame.msgid == mav.MAVLINK_MSG_ID_HEARTBEAT:
                    content = codec.fields(frame)
                    if content.autopilot != mav.MAV_AUTOPILOT_INVALID and frame.sysid != self._station[0]:
                        self.profiles.setdefault(frame.sysid, profile_of(content.autopilot, content.type))
                        if self._where.setdefault(frame.sysid, sender) != sender:
                            self._seconds[frame.sysid] = sender
                        elif frame.sysid in self._seconds:
                            self.doubled[frame.sysid] = self._seconds[frame.sysid]
                        armed = content.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED
                        (self.armed.add if armed else self.armed.discard)(frame.sysid)
                if self._address(frame.sysid, frame.compid) == sender:
                    received.append(frame)
        return received

    def _address(self, sysid: int, compid: int) -> Where | None:
        """Address of a component, else of its vehicle's autopilot; None where that has not been received."""
        return self._components.get((sysid, compid), self._where.get(sysid)) if sysid in self._where else None

    def _send(self, message: Message, to: Where) -> None:
        self.listener.send(codec.frame(message, next(self._numbers), *self._station), to)
