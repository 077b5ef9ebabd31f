"""The radio among vehicles that compete on board: every frame that one broadcasts, on its way to each other one
(docs/protocol/onboard.md#radio-among-vehicles).

It is a part of the simulated world and not of the ground station: nothing here is decided, and the ground station's own
radio may be dead meanwhile. It loses and delays as that one does, with a random stream for each sender and receiver. A
vehicle's blackout silences it towards its peers too.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from gcs.link.impairment import Burst, Impairment
from gcs.mavlink import codec
from gcs.mavlink.codec import LARGEST_FRAME, Frame
from gcs.scenario.parts.radio import RadioSplit

_COUNTERS = frozenset({"XferOut", "XferIn"})
_NAMED_VALUE_INT = codec.msgid("NAMED_VALUE_INT")
_BROADCAST = frozenset({codec.msgid("DEBUG_FLOAT_ARRAY"), codec.msgid("FOLLOW_TARGET")})
_ADDRESSED = frozenset({codec.msgid("COMMAND_LONG"), codec.msgid("COMMAND_ACK")})
MOST_BYTES = 11_000
"""Of other vehicles' frames in a bundle: with what a shared datagram holds besides it stays within 16,384 bytes."""


class PeerRadio:
    """The radio between any two of some vehicles."""

    def __init__(
        self,
        sysids: Sequence[int],
        radio: Impairment,
        *,
        blackouts: Iterable[Burst] = (),
        splits: Iterable[RadioSplit] = (),
    ) -> None:
        """`radio`: what befalls the frames of each pair; `blackouts` silence a vehicle whether it sends or receives."""
        self._sysids, self._radio = sorted(sysids), radio
        self._blackouts = tuple(blackouts)
        self._splits = tuple(splits)
        self._sent: dict[int, list[tuple[int, bytes]]] = {}

    def black_out(self, blackouts: Iterable[Burst]) -> None:
        """Silence vehicles by these too."""
        self._blackouts += tuple(blackouts)

    def send(self, sysid: int, frames: Iterable[Frame]) -> None:
        """Take what a vehicle has broadcast since the last tick, out of all its frames, for `receive`."""
        addressed = ((_reader(frame), frame.raw) for frame in frames)
        self._sent[sysid] = [(reader, raw) for reader, raw in addressed if reader is not None]

    def receive(self, sysid: int, t_s: float) -> bytes:
        """Frames that reach a vehicle at a session time, in the order of their senders, as one piece; once per tick and
        vehicle."""
        received: list[bytes] = []
        for sender in self._sysids:
            if sender == sysid:
                continue
            frames = [raw for reader, raw in self._sent.get(sender, ()) if reader in (0, sysid)]
            dark = apart(sender, sysid, t_s, self._blackouts, self._splits)
            received += self._radio.apply(sysid, sender, t_s, frames, dark=dark)
        return fitting(received, t_s, MOST_BYTES // 2)  # the places of peers need room too


def apart(a: int, b: int, t_s: float, blackouts: Iterable[Burst], splits: Iterable[RadioSplit]) -> bool:
    """Whether nothing passes between two vehicles: a blackout silences a vehicle whether it sends or receives."""
    if any(blackout.sysid in (a, b) and blackout.from_s <= t_s < blackout.to_s for blackout in blackouts):
        return True
    return any(s.from_s <= t_s < s.to_s and (a in s.sysids) != (b in s.sysids) for s in splits)


def fitting(frames: Sequence[bytes], t_s: float, most_bytes: int) -> bytes:
    """As many frames as fit, in one piece: of too many another part in each tick."""
    size = sum(map(len, frames))
    if size <= most_bytes:
        return b"".join(frames)
    parts = math.ceil(size / (most_bytes - LARGEST_FRAME))
    return b"".join(frames[round(10.0 * t_s) % parts :: parts])


def _reader(frame: Frame) -> int | None:
    """Reader of a frame: a system id, 0 for everyone; None for the ground station's alone."""
    if frame.msgid in _BROADCAST:
        return 0
    if frame.msgid == _NAMED_VALUE_INT:
        return 0 if codec.fields(frame).name in _COUNTERS else None
    if frame.msgid in _ADDRESSED:
        return int(codec.fields(frame).target_system)
    return None
