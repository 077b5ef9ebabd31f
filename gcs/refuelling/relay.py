"""Frames relayed between partners of a transfer: their own frames, header unchanged
(docs/protocol/energy.md#transfer-command)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame

_FOLLOW_TARGET = codec.msgid("FOLLOW_TARGET")
_NAMED_VALUE_INT = codec.msgid("NAMED_VALUE_INT")


class Relay(NamedTuple):
    """A frame of one vehicle on its way to another."""

    raw: bytes


def relayed(pairs: Iterable[tuple[int, int]], delivered: Mapping[int, Sequence[Frame]]) -> dict[int, list[Relay]]:
    """Frames relayed to each reader of those delivered by sender; `pairs` are (giver, receiver).

    The giver's FOLLOW_TARGET and counter go to the receiver, the receiver's counter to the giver.
    """
    relays: dict[int, list[Relay]] = {}
    for giver, receiver in pairs:
        for source, reader, counter in ((giver, receiver, "XferOut"), (receiver, giver, "XferIn")):
            frames = [frame for frame in delivered.get(source, ()) if _is_relayed(frame, counter)]
            relays.setdefault(reader, []).extend(Relay(frame.raw) for frame in frames)
    return relays


def _is_relayed(frame: Frame, counter: str) -> bool:
    if frame.msgid == _NAMED_VALUE_INT:
        return bool(codec.fields(frame).name == counter)
    return frame.msgid == _FOLLOW_TARGET and counter == "XferOut"
