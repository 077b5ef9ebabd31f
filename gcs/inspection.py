"""Everything that chosen vehicles send: the latest of each message, counted and timed, decoded only when it is told.

Nothing is kept of vehicles that nobody asks for.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from typing import Any

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame

RATE_OVER = 20
"""A rate is that of so many last messages."""


@dataclass
class _Latest:
    """One message of one vehicle."""

    frame: Frame
    count: int = 0
    times_s: deque[float] = field(default_factory=lambda: deque(maxlen=RATE_OVER))

    def rate_hz(self) -> float | None:
        """How often it comes, by the times of the last ones; None before it has come at two times."""
        span_s = self.times_s[-1] - self.times_s[0]
        return (len(self.times_s) - 1) / span_s if span_s > 0.0 else None


class Inspection:
    """Keeps frames of the vehicles in `wanted`."""

    def __init__(self) -> None:
        self.wanted: frozenset[int] = frozenset()
        self._latest: dict[int, dict[int, _Latest]] = {}

    def want(self, sysids: Collection[int]) -> None:
        """Look at these system ids from now on, and at no other; one that is asked for anew begins from nothing."""
        self.wanted = frozenset(sysids)
        self._latest = {sysid: self._latest.get(sysid, {}) for sysid in sorted(self.wanted)}

    def take(self, frames: Iterable[Frame], now_s: float) -> None:
        """Keep what wanted vehicles sent, delivered at `now_s`."""
        for frame in frames:
            messages = self._latest.get(frame.sysid)
            if messages is None:
                continue
            latest = messages.get(frame.msgid)
            if latest is None:
                latest = messages[frame.msgid] = _Latest(frame)
            latest.frame = frame
            latest.count += 1
            latest.times_s.append(now_s)

    def told(self, now_s: float) -> dict[str, dict[str, Any]]:
        """By system id and message name: count, rate, age, and the latest's fields in MAVLink's own units."""
        return {
            str(sysid): {
                codec.name(msgid): {
                    "count": latest.count,
                    "rate_hz": latest.rate_hz(),
                    "age_s": max(now_s - latest.times_s[-1], 0.0),
                    "fields": _fields(latest.frame),
                }
                for msgid, latest in sorted(messages.items())
            }
            for sysid, messages in self._latest.items()
        }


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
    return None if isinstance(value, float) and not math.isfinite(value) else value
