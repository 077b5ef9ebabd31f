"""A vehicle's own clock seen from the session's: which moment was its `time_boot_ms`?

A message that was `delay` on its way arrives at arrival = boot + offset + delay. The least of arrival - boot over the
last two to four seconds is the offset with the shortest way. Older arrivals are forgotten: clocks drift, and that of a
simulated autopilot, which stands still whenever its machine is busy, by a second in two minutes or all at once.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame

CLOCKS = frozenset({codec.msgid("LOCAL_POSITION_NED"), codec.msgid("ATTITUDE")})
"""Messages that carry a vehicle's time; the second comes also while it has not found its place, as after a boot."""
WINDOW_S = 2.0
REBOOT_S = 1.0
"""A boot time that falls by more than this is another boot; by less, a message that was overtaken."""
OLDEST_S = 10.0
"""[choice] So much older than the silence before it another boot may be: what came while the station stood still counts
as having come at once. What is older was overtaken, as copies are that go another way."""


class BootClock:
    """The offset of one vehicle's clock; times are s."""

    def __init__(self) -> None:
        self._least_s = self._least_before_s = math.inf
        self._window_began_s = -math.inf
        self._newest_boot_s: dict[int, float] = {}
        self._newest_arrival_s = math.inf

    def begins_anew(self, msgid: int, boot_s: float, arrival_s: float) -> bool:
        """Whether a message `msgid` that says `boot_s` and arrives at `arrival_s` is of another boot than those before.

        Messages are compared with others of their kind: a vehicle may fill in the time of one and leave another's 0.
        """
        silent_s = max(arrival_s - self._newest_arrival_s, 0.0)
        return boot_s < min(self._newest_boot_s.get(msgid, -math.inf) - REBOOT_S, silent_s + OLDEST_S)

    def feed(self, msgid: int, boot_s: float, arrival_s: float) -> bool:
        """A message `msgid` said `boot_s` and arrived at `arrival_s`; whether the vehicle has booted anew."""
        newest_s = self._newest_boot_s.get(msgid, -math.inf)
        rebooted = self.begins_anew(msgid, boot_s, arrival_s)
        if rebooted:
            self._newest_boot_s.clear()
            self._least_s = self._least_before_s = math.inf
            self._window_began_s = arrival_s
        elif arrival_s - self._window_began_s >= WINDOW_S:
            self._least_before_s, self._least_s = self._least_s, math.inf
            self._window_began_s = arrival_s
        if rebooted or boot_s >= newest_s:
            self._newest_boot_s[msgid], self._newest_arrival_s = boot_s, arrival_s
        self._least_s = min(self._least_s, arrival_s - boot_s)
        return rebooted

    @property
    def offset_s(self) -> float | None:
        """Offset from boot time to the session's, s; None before the first message."""
        offset_s = min(self._least_s, self._least_before_s)
        return offset_s if math.isfinite(offset_s) else None


class ComparedClocks:
    """The clocks of some vehicles, by (system, component)."""

    def __init__(self, keys: Iterable[tuple[int, int]] = ()) -> None:
        self._clocks = {key: BootClock() for key in keys}
        self._rebooted: set[int] = set()

    def __bool__(self) -> bool:
        return bool(self._clocks)

    def feed(self, key: tuple[int, int], frames: Sequence[Frame], arrival_s: float) -> None:
        """Take frames of a vehicle that arrived then; vehicles without a compared clock are passed over."""
        clock = self._clocks.get(key)
        if clock is None:
            return
        for frame in frames:
            if frame.msgid in CLOCKS:
                boot_s = codec.fields(frame).time_boot_ms / 1e3
                if clock.feed(frame.msgid, boot_s, arrival_s):
                    self._rebooted.add(key[0])

    def offsets_s(self) -> dict[int, float]:
        """Offset from boot time to the session's by system id, of vehicles that have reported a time."""
        offsets = {key[0]: clock.offset_s for key, clock in self._clocks.items()}
        return {sysid: offset_s for sysid, offset_s in offsets.items() if offset_s is not None}

    def pop_rebooted(self) -> set[int]:
        """System ids of vehicles that have rebooted since the last call."""
        rebooted, self._rebooted = self._rebooted, set()
        return rebooted
