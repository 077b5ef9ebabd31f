"""Which telemetry is due on one connection, and when: at the table's rates until the other side asks for others."""

from __future__ import annotations

from typing import Any

import cython
from cython.cimports.simvehicle.mavlink.streams import FASTEST_MS, SLOWEST_MS
from cython.cimports.simvehicle.mavlink.telemetry import STREAMS

from simvehicle.mavlink.telemetry import TELEMETRY

_PLACE = {stream.key: k for k, stream in enumerate(TELEMETRY)}


class StreamSchedule:
    """The schedule of one connection; times are ms since boot."""

    tick_ms: int
    """time from one look at it to the next, where that is fixed: no stream comes faster"""
    _default_ms: Any
    _interval_ms: Any
    _due_ms: Any

    def __init__(self) -> None:
        self.tick_ms = 0
        for k in range(STREAMS):
            self._default_ms[k] = self._interval_ms[k] = _interval_ms(TELEMETRY[k].rate_hz)
            self._due_ms[k] = 0

    def take(self, stream: int, now_ms: int) -> bool:
        """Whether a stream is due at `now_ms`; it counts as sent then."""
        interval_ms, late_ms = self._interval_ms[stream], now_ms - self._due_ms[stream]
        if interval_ms == 0 or late_ms < 0:
            return False
        self._due_ms[stream] = now_ms + interval_ms - (late_ms if late_ms < interval_ms else 0)
        return True

    def hasten(self, key: str, now_ms: int) -> None:
        """Let a stream be due now, besides its rhythm."""
        k = cython.cast(cython.int, _PLACE[key])
        self._due_ms[k] = now_ms

    def set_interval(self, msgid: int, interval_us: float, now_ms: int) -> bool:
        """MAV_CMD_SET_MESSAGE_INTERVAL: -1 stops, 0 restores the default; False where there is no such stream."""
        known = False
        for k in range(STREAMS):
            if TELEMETRY[k].msgid != msgid:
                continue
            known = True
            if interval_us < 0:
                interval_ms = 0
            elif interval_us == 0:
                interval_ms = self._default_ms[k]
            else:
                interval_ms = round(min(max(interval_us / 1e3, FASTEST_MS), SLOWEST_MS))
            self._interval_ms[k], self._due_ms[k] = interval_ms, now_ms
        return known

    def set_rate(self, key: str, rate_hz: float, now_ms: int) -> None:
        """Send one stream at a rate; 0 stops it."""
        k = cython.cast(cython.int, _PLACE[key])
        self._interval_ms[k], self._due_ms[k] = _interval_ms(rate_hz), now_ms

    def set_default(self, key: str, rate_hz: float) -> None:
        """Send one stream at a rate from the beginning, and whenever the default is asked for."""
        k = cython.cast(cython.int, _PLACE[key])
        self._default_ms[k] = self._interval_ms[k] = _interval_ms(rate_hz)

    def interval_us(self, msgid: int) -> int | None:
        """MESSAGE_INTERVAL of a message, as it is sent: -1 when it is not; None where the vehicle has no such
        stream."""
        for k in range(STREAMS):
            if TELEMETRY[k].msgid == msgid:
                interval_ms = cython.cast(cython.longlong, self._interval_ms[k])
                return 1000 * max(interval_ms, self.tick_ms) if interval_ms else -1
        return None


def _interval_ms(rate_hz: float) -> int:
    return round(1e3 / rate_hz) if rate_hz else 0
