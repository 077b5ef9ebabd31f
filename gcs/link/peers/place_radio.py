"""The radio on which vehicles receive each other's places (docs/protocol/onboard.md#separation-on-board).

Vehicles broadcast LOCAL_POSITION_NED and POSITION_TARGET_LOCAL_NED to all vehicles, other aircraft ADSB_VEHICLE. As
the radio among those that compete, this is a part of the simulated world, not of the ground station: it loses and
delays as that one does, and goes on while the station's own radio is dead.
"""

from __future__ import annotations

from collections.abc import Collection, Container, Iterable, Mapping, Sequence

from gcs.link.impairment import Burst, Impairment
from gcs.link.peers.peer_radio import MOST_BYTES, apart, fitting
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.ids import STATION, TRAFFIC
from gcs.scenario.parts.radio import RadioSplit

_PLACE, _LEADER = codec.msgid("LOCAL_POSITION_NED"), codec.msgid("POSITION_TARGET_LOCAL_NED")
_AIRCRAFT = codec.msgid("ADSB_VEHICLE")
SELDOM = 3
"""[choice] Ticks: a vehicle foresees its peers for longer."""
_SYSID_AT, _COMPID_AT, _ID_AT = 5, 6, slice(7, 10)  # in a frame
_MASK_AT, _NO_ACCELERATION = codec.HEADER_BYTES + 48, 0b1100_0000  # the low byte of its type_mask has x's and y's


class PlaceRadio:
    """The radio between any two of some vehicles."""

    def __init__(
        self,
        sysids: Iterable[int],
        radio: Impairment,
        *,
        blackouts: Iterable[Burst] = (),
        splits: Iterable[RadioSplit] = (),
        traffic: bool = False,
    ) -> None:
        """Arguments as `PeerRadio` has them; `traffic`: other aircraft report themselves too, to all."""
        self._radio = radio
        self._members = frozenset(sysids)
        self._senders = [*sorted(self._members), *((TRAFFIC[0],) if traffic else ())]
        self._blackouts, self._splits = tuple(blackouts), tuple(splits)
        self._sent: Mapping[int, Sequence[Frame]] = {}
        self._places: dict[int, list[bytes]] = {}
        self._all: list[bytes] | None = None
        self._all_fitting: dict[int, bytes] = {}
        """by room"""
        self._flying: Collection[int] = ()
        self._steered: Container[int] = ()
        self._ticks = 0
        self.listening: frozenset[int] = frozenset()
        """vehicles that may fly, and are not known to follow set points"""
        self.delivered = False
        """whether a place has been delivered in this tick"""

    def black_out(self, blackouts: Iterable[Burst]) -> None:
        """Silence vehicles by these too."""
        self._blackouts += tuple(blackouts)

    def send(self, frames: Mapping[int, Sequence[Frame]]) -> None:
        """Take what vehicles have sent since the last tick, by system id."""
        self._sent, self._all = frames, None
        self._places.clear()
        self._all_fitting.clear()

    def begin(self, flying: Collection[int], steered: Container[int], *, seldom: bool = False) -> None:
        """Begin a tick's deliveries. `flying`: vehicles that may be in the air; `steered`: those to which a set point
        goes and which follow it, as far as is known. `seldom`: all hear the station, and places are carried in every
        third tick alone, to save time."""
        self._ticks += 1
        rests = seldom and not self._splits and self._ticks % SELDOM != 0
        self._flying, self.delivered = () if rests else flying, False
        self._steered = () if self._splits else steered
        self.listening = frozenset(
            sysid for sysid in self._members if sysid in self._flying and sysid not in self._steered
        )

    def deliver(self, sysid: int, t_s: float, *, led: bool, beside_bytes: int = 0) -> bytes:
        """Places that reach a vehicle at a session time, as one piece of data, once per tick; `led`: a set point has
        reached it. One that follows it, or is on the ground, has no use for them, and they are kept from it to save
        time; but what a split may soon keep from it. `beside_bytes` of other frames go with them."""
        needs = sysid in self._flying and sysid in self._members and not (led and sysid in self._steered)
        if not needs and (self._radio.prompt or sysid not in self._members):
            return b""
        received = self._received(sysid, t_s, MOST_BYTES - beside_bytes)
        if not needs or not received:
            return b""
        self.delivered = True
        return received

    def _received(self, sysid: int, t_s: float, most_bytes: int) -> bytes:
        """Frames in the order of their senders; where nothing is lost, the vehicle's own are among them."""
        if self._radio.clear and not self._blackouts and not self._splits:
            if self._all is None:
                self._all = [raw for sender in self._senders for raw in self._of(sender)]
            if most_bytes not in self._all_fitting:
                self._all_fitting[most_bytes] = _fitting(self._all, t_s, most_bytes)
            return self._all_fitting[most_bytes]
        received: list[bytes] = []
        for sender in self._senders:
            if sender != sysid:
                splits = () if sender == TRAFFIC[0] else self._splits
                dark = apart(sender, sysid, t_s, self._blackouts, splits)
                received += self._radio.apply(sysid, sender, t_s, self._of(sender), dark=dark)
        return _fitting(received, t_s, most_bytes)

    def _of(self, sender: int) -> list[bytes]:
        places = self._places.get(sender)
        if places is None:
            frames = self._sent.get(sender, ())
            places = self._places[sender] = [
                frame.raw
                for frame in frames
                if frame.msgid in (_PLACE, _AIRCRAFT) or (frame.msgid == _LEADER and _leads(frame.raw))
            ]
        return places


def is_place(raw: bytes) -> bool:
    """Whether a frame that goes to a vehicle, or several in one piece, is what another one, or an aircraft, has
    broadcast of itself."""
    if (raw[_SYSID_AT], raw[_COMPID_AT]) == TRAFFIC:
        return True
    return raw[_SYSID_AT] != STATION[0] and int.from_bytes(raw[_ID_AT], "little") in (_PLACE, _LEADER)


def _leads(raw: bytes) -> bool:
    """Whether a POSITION_TARGET_LOCAL_NED is of a leader: it has an acceleration."""
    return not raw[_MASK_AT] & _NO_ACCELERATION


def _fitting(frames: list[bytes], t_s: float, most_bytes: int) -> bytes:
    """As many frames as fit, in one piece; where not all do, of a vehicle with a leader that alone."""
    if sum(map(len, frames)) > most_bytes:
        leaders = [raw for raw in frames if raw[_ID_AT.start] == _LEADER]
        led = {raw[_SYSID_AT] for raw in leaders}
        frames = leaders + [raw for raw in frames if raw[_ID_AT.start] != _LEADER and raw[_SYSID_AT] not in led]
    return fitting(frames, t_s, most_bytes)
