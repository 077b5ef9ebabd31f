"""Which telemetry is due on one connection, and when: at the table's rates until the other side asks for others."""

from __future__ import annotations

from collections.abc import Iterable

from simvehicle.mavlink.telemetry import TELEMETRY, Stream
from skytender import mavlink as mav

FASTEST_MS = 4
SLOWEST_MS = 2_000_000
"""MESSAGE_INTERVAL holds intervals in 32 bits of µs."""


class StreamSchedule:
    """The schedule of one connection; times are ms since boot."""

    def __init__(self) -> None:
        self._default_ms = {s.key: _interval_ms(s.rate_hz) for s in TELEMETRY}
        self._interval_ms = dict(self._default_ms)
        self._due_ms = dict.fromkeys(self._interval_ms, 0)
        self._sent: list[tuple[str, Stream]] | None = None

    def due(self, now_ms: int) -> list[Stream]:
        """Streams that are due at `now_ms`, each once, in the table's order; they count as sent."""
        due_ms, due = self._due_ms, []
        for key, stream in self._active():
            due_then_ms = due_ms[key]
            if now_ms >= due_then_ms:
                interval_ms, late = self._interval_ms[key], now_ms - due_then_ms
                due_ms[key] = now_ms + interval_ms - (late if late < interval_ms else 0)
                due.append(stream)
        return due

    def timetable(self) -> list[tuple[int, int]]:
        """Interval and time due of every stream, ms, in the table's order; an interval of 0: it is not sent."""
        return [(interval_ms, self._due_ms[key]) for key, interval_ms in self._interval_ms.items()]

    def set_due(self, due_ms: Iterable[int]) -> None:
        """Times at which streams are due, in the table's order."""
        self._due_ms = dict(zip(self._due_ms, due_ms, strict=True))

    def _active(self) -> list[tuple[str, Stream]]:
        """Streams that have an interval."""
        if self._sent is None:
            self._sent = [(stream.key, stream) for stream in TELEMETRY if self._interval_ms[stream.key]]
        return self._sent

    def hasten(self, key: str, now_ms: int) -> None:
        """Let a stream be due now, besides its rhythm."""
        self._due_ms[key] = now_ms

    def set_interval(self, msgid: int, interval_us: float, now_ms: int) -> bool:
        """MAV_CMD_SET_MESSAGE_INTERVAL: -1 stops, 0 restores the default; False where there is no such stream."""
        known, self._sent = False, None
        for stream in TELEMETRY:
            if stream.msgid == msgid:
                known = True
                if interval_us < 0:
                    interval_ms = 0
                elif interval_us == 0:
                    interval_ms = self._default_ms[stream.key]
                else:
                    interval_ms = round(min(max(interval_us / 1e3, FASTEST_MS), SLOWEST_MS))
                if msgid != mav.MAVLINK_MSG_ID_HEARTBEAT or interval_ms:
                    self._interval_ms[stream.key] = interval_ms
                    self._due_ms[stream.key] = now_ms
        return known

    def set_rate(self, key: str, rate_hz: float, now_ms: int) -> None:
        """Send one stream at a rate; 0 stops it."""
        self._interval_ms[key], self._sent = _interval_ms(rate_hz), None
        self._due_ms[key] = now_ms

    def set_default(self, key: str, rate_hz: float) -> None:
        """Send one stream at a rate from the beginning, and whenever the default is asked for."""
        self._default_ms[key] = self._interval_ms[key] = _interval_ms(rate_hz)
        self._sent = None

    def interval_us(self, msgid: int) -> int | None:
        """MESSAGE_INTERVAL of a message: -1 when it is not sent; None where the vehicle has no such stream."""
        for stream in TELEMETRY:
            if stream.msgid == msgid:
                return 1000 * self._interval_ms[stream.key] or -1
        return None


def _interval_ms(rate_hz: float) -> int:
    return round(1e3 / rate_hz) if rate_hz else 0
