"""Everything that chosen vehicles send: the latest of each message, counted and timed, decoded only when it is sent on.

Nothing is kept of vehicles that are not asked for.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from typing import Any

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame

Subject = tuple[int, str]
_NAMED = frozenset(map(codec.msgid, ("NAMED_VALUE_FLOAT", "NAMED_VALUE_INT", "DEBUG_VECT")))
MOST_SUBJECTS = 256
"""Messages of one vehicle that are distinguished, each named value for itself; further ones are passed over."""
RATE_OVER = 20
"""A rate is that of so many last messages."""


@dataclass
class _Latest:
    """One message of one vehicle."""

    frame: Frame
    count: int = 0
    times_s: deque[float] = field(default_factory=lambda: deque(maxlen=RATE_OVER))

    def rate_hz(self) -> float | None:
        """Rate of the message, by the times of the last ones; None before it has come at two times."""
        span_s = self.times_s[-1] - self.times_s[0]
        return (len(self.times_s) - 1) / span_s if span_s > 0.0 else None


class MessageInspector:
    """Keeps frames of the vehicles in `wanted`."""

    def __init__(self) -> None:
        self.wanted: frozenset[int] = frozenset()
        self._latest: dict[int, dict[Subject, _Latest]] = {}

    def want(self, sysids: Collection[int]) -> None:
        """Look at these system ids from now on, and at no other; one that is asked for anew begins from nothing."""
        self.wanted = frozenset(sysids)
        self._latest = {sysid: self._latest.get(sysid, {}) for sysid in sorted(self.wanted)}

    def add(self, frames: Iterable[Frame], now_s: float) -> None:
        """Keep what wanted vehicles sent, delivered at `now_s`."""
        for frame in frames:
            messages = self._latest.get(frame.sysid)
            if messages is None:
                continue
            subject = frame.msgid, _own_name(frame)
            latest = messages.get(subject)
            if latest is None:
                if len(messages) >= MOST_SUBJECTS:
                    continue
                latest = messages[subject] = _Latest(frame)
            latest.frame = frame
            latest.count += 1
            latest.times_s.append(now_s)

    def latest(self, now_s: float) -> dict[str, dict[str, Any]]:
        """By system id and message name: count, rate, age, and the latest's fields in MAVLink's own units.

        What a named value is called follows the message's name: `NAMED_VALUE_INT XferIn`.
        """
        return {
            str(sysid): {
                f"{codec.name(msgid)} {name}".rstrip(): {
                    "count": latest.count,
                    "rate_hz": latest.rate_hz(),
                    "age_s": max(now_s - latest.times_s[-1], 0.0),
                    "fields": _fields(latest.frame),
                }
                for (msgid, name), latest in sorted(messages.items())
            }
            for sysid, messages in self._latest.items()
        }


def _own_name(frame: Frame) -> str:
    """Name of the value in a message that carries one of several; nothing of any other message."""
    return str(_fields(frame).get("name", "")).strip() if frame.msgid in _NAMED else ""


def _fields(frame: Frame) -> dict[str, Any]:
    """Fields by name; a number that JSON lacks (NaN, infinity) is None. A message that the dialect lacks has none."""
    try:
        content = codec.fields(frame)
    except ValueError:
        return {}
    return {name: _plain(value) for name, value in content._asdict().items()}


def _plain(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_plain(part) for part in value]
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else None
    return value
