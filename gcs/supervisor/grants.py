"""A tick's grants on their way out: recipients, set points in the vehicles' own frames, and what else waits for each
vehicle, through the radio to the link."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gcs.link.link import Key, TickGrants, TickLink
from gcs.link.peers.place_radio import is_place
from gcs.link.quality import LinkQuality
from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.common_frame import turned
from gcs.mavlink.ids import OUR_HEARTBEAT, STATION, TRAFFIC
from gcs.mavlink.setpoints import PlacedSetPoints, SetPoint, SetPoints
from gcs.refuelling.relay import Relay
from gcs.supervisor.faults import FaultInjector
from gcs.supervisor.fleet_command_queue import FleetCommandQueue
from gcs.supervisor.forwarding import ForwardedControl
from gcs.supervisor.radios import Radios
from gcs.telemetry.columns import FleetColumns

HEARTBEAT_EVERY_MS = 1000
_SYSID_AT = 5  # in a frame
_SET_POINT = codec.msgid("SET_POSITION_TARGET_LOCAL_NED")


class Addressees:
    """Vehicles to which grants go, and our HEARTBEAT."""

    def __init__(self, join_ms: Mapping[int, int]) -> None:
        """join_ms: session time from which each vehicle takes part, by system id."""
        self._join_ms = join_ms
        self._due_ms = dict.fromkeys(join_ms, 0)
        self._next_ms = 0
        self._joined: set[Key] = set()
        self._keys: list[Key] = []

    def granted(self, joined: set[Key], grant_ms: int) -> Sequence[Key]:
        """The joined vehicles that may fly until then, in order."""
        if joined != self._joined or len(self._keys) < len(joined):
            self._joined, self._next_ms = set(joined), 0
            self._keys = [key for key in sorted(joined) if key == TRAFFIC or grant_ms >= self._join_ms[key[0]]]
        return self._keys

    def heartbeat_due(self, keys: Iterable[Key], now_ms: int) -> set[int]:
        """System ids of vehicles whose HEARTBEAT from us is due now; they count as sent."""
        if now_ms < self._next_ms:
            return set()
        due_ms = self._due_ms
        heartbeat_due = {key[0] for key in keys if key != TRAFFIC and now_ms >= due_ms[key[0]]}
        due_ms |= dict.fromkeys(heartbeat_due, now_ms + HEARTBEAT_EVERY_MS)
        self._next_ms = min((due_ms[key[0]] for key in keys if key != TRAFFIC), default=0)
        return heartbeat_due


class OwnFrames:
    """Brings set points into their vehicles' own frames."""

    def __init__(self) -> None:
        self._sysids: tuple[int, ...] = ()
        self._number = -1
        self._origins = np.empty((0, 6))
        """(k, 6) nothing is taken off a velocity, so that one subtraction does for both"""
        self._turns_rad: dict[int, float] = {}
        """by row, where it is none"""

    def placed(self, points: SetPoints, columns: FleetColumns, time_ms: int) -> PlacedSetPoints:
        """These set points as they are sent. Each of their vehicles must have reported where its frame lies."""
        if points.sysids != self._sysids or columns.changed_since(self._number):
            frames = columns.frames[[columns.row[sysid] for sysid in points.sysids]]
            assert not np.isnan(frames).any()
            self._origins = np.hstack((frames[:, :3], np.zeros((len(frames), 3))))
            self._turns_rad = {row: turn for row, turn in enumerate(frames[:, 3].tolist()) if turn}
            self._sysids, self._number = points.sysids, columns.number
        values = points.values - self._origins
        for row, turn_rad in self._turns_rad.items():
            n, e, d, v_n, v_e, v_d = values[row].tolist()
            values[row] = *turned((n, e, d), -turn_rad), *turned((v_n, v_e, v_d), -turn_rad)
        return PlacedSetPoints(time_ms, points.sysids, values)


class WaitingMessages(NamedTuple):
    """Everything that may wait to be sent to vehicles beside HEARTBEAT and set points."""

    commands: FleetCommandQueue
    forwarded: ForwardedControl
    faults: FaultInjector
    quality: LinkQuality


class GrantSender:
    """Sends every vehicle its grant, and with it what waits for the vehicle."""

    def __init__(self, link: TickLink, radios: Radios, waiting: WaitingMessages, join_ms: Mapping[int, int]) -> None:
        """join_ms: as of `Addressees`."""
        self._link = link
        self._radio, self._peer_radio, self._place_radio = radios
        self._commands, self._forwarded, self._faults, self._quality = waiting
        self._addressees, self._own_frames = Addressees(join_ms), OwnFrames()

    def send(
        self,
        set_points: Sequence[SetPoint],
        columns: FleetColumns,
        relays: Mapping[int, list[Relay]],
        now_ms: int,
        grant_ms: int,
        unix_us: int,
    ) -> Sequence[bytes]:
        """Grant all vehicles the time up to `grant_ms`, which is `unix_us` since 1970; the frames that were sent.

        relays: frames of vehicles to be passed to others, by the receiver's system id.
        """
        keys = self._addressees.granted(self._link.joined, grant_ms)
        points = self._own_frames.placed(SetPoints.of(set_points), columns, now_ms)
        heartbeat_due = self._addressees.heartbeat_due(keys, now_ms)
        more = {}
        if self._place_radio is not None:
            up = columns.flying if self._radio.clear else columns.alive  # more is not known of silent ones
            flying = {sysid for sysid, flies in zip(columns.sysids, up.tolist(), strict=True) if flies}
            following = {
                sysid for sysid, follows in zip(columns.sysids, columns.steerable.tolist(), strict=True) if follows
            }
            self._place_radio.begin(flying, following.intersection(points.sysids), seldom=self._radio.clear)
        for key in self._with_more(keys, relays):
            own = [points.message(key[0])] if key[0] in points.sysids else []
            more[key] = self._content(key[0], own, relays, now_ms / 1e3, heartbeat_due=key[0] in heartbeat_due)
        sent = self._link.grant_all(TickGrants(grant_ms, unix_us, keys, heartbeat_due, points, more))
        if self._peer_radio is not None:
            sent = [raw for raw in sent if raw[_SYSID_AT] == STATION[0] and not is_place(raw)]
        elif self._place_radio is not None and self._place_radio.delivered:
            sent = [raw for raw in sent if not is_place(raw)]
        self._link.flush()
        return sent

    def _with_more(self, keys: Iterable[Key], relays: Mapping[int, list[Relay]]) -> list[Key]:
        """Keys with more to send than HEARTBEAT and set point, or with a radio that may hold it back."""
        if not self._radio.clear or self._peer_radio is not None:
            return [key for key in keys if key != TRAFFIC]
        copied = self._quality.copied
        alone = self._place_radio.listening if self._place_radio is not None else ()
        there = (self._commands.waiting, relays, self._forwarded.waiting, self._faults.ordered, copied, alone)
        if not any(there):
            return []
        some = set().union(*there)
        return [key for key in keys if key[0] in some and key != TRAFFIC]

    def _content(
        self,
        sysid: int,
        set_point: list[Message],
        relays: Mapping[int, list[Relay]],
        now_s: float,
        *,
        heartbeat_due: bool,
    ) -> tuple[list[Message], list[bytes], bytes]:
        """All that goes to a vehicle now, after the radio: messages, frames as they are, what others have broadcast."""
        copies = self._quality.copies(sysid)
        messages: list[Message | Relay] = [OUR_HEARTBEAT] * copies if heartbeat_due else []
        messages += self._commands.pop(sysid)
        messages += set_point * copies
        messages += relays.get(sysid, ())
        messages += self._forwarded.pop(sysid)
        messages = [*self._faults.pop_orders(sysid), *self._radio.apply(sysid, "out", now_s, messages)]
        own = [m for m in messages if isinstance(m, Message)]
        air = b""
        if self._peer_radio is not None:
            air = self._peer_radio.receive(sysid, now_s)
        if self._place_radio is not None:
            led = any(one.msgid == _SET_POINT for one in own)
            air += self._place_radio.deliver(sysid, now_s, led=led, beside_bytes=len(air))
        return own, [m.raw for m in messages if isinstance(m, Relay)], air
