"""MAVLink 2 signing of a vehicle's plain links (https://mavlink.io/en/guide/message_signing.html).

A signature is the first 48 bits of SHA-256 over key, frame, link id and time stamp. Rules:
1. Without a key nothing is signed, and a signed frame is dropped: it cannot be checked.
2. With one everything is signed, and a frame counts when its signature is right and its time stamp, in 10 µs since
   2015, is later than the last of its stream (system, component, link id); the first one may be a minute behind.
3. With one an unsigned frame is dropped, but for RADIO_STATUS and ADSB_VEHICLE, whose senders have no key.
4. SETUP_SIGNING sets the key while there is none; later only a signed one does, and 32 zero bytes take the key away.
   It is acted on here and goes no further.
"""

from __future__ import annotations

import hashlib
import hmac
import struct
from collections.abc import Callable, Mapping

from fastcrc.crc16 import mcrf4xx
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.codec import CHECKSUM_BYTES, SIGNATURE_BYTES, SIGNED, ReceivedFrame, decode, schema

KEY_BYTES = 32
TICKS_PER_S = 100_000
EPOCH_S = 1_420_070_400
"""2015-01-01 in Unix time."""
STALE_TICKS = 60 * TICKS_PER_S
MOST_STREAMS = 256
LAST_STAMP = (1 << 48) - 1
"""A time stamp has 48 bits; who has used them up repeats the last one, which nobody takes twice."""
_TAIL = struct.Struct("<HBIH").pack
"""Checksum, link id, time stamp (low 32 bits, high 16)."""
_HASH_BYTES = _STAMP_BYTES = 6
_UNSIGNED = frozenset({mav.MAVLINK_MSG_ID_RADIO_STATUS, mav.MAVLINK_MSG_ID_ADSB_VEHICLE})
GOOD, NO_KEY = "", "signed, and no key is set"
NOT_SIGNED, OTHER_KEY, REPEATED = "not signed", "signed with another key", "repeated or out of date"


def ticks(unix_s: float) -> int:
    """The time stamp of a Unix time."""
    return max(int((unix_s - EPOCH_S) * TICKS_PER_S), 0)


class VehicleSigning:
    """One vehicle's key, for all its plain links, and the time stamps used and seen with it."""

    def __init__(
        self,
        sysid: int,
        key: bytes | None = None,
        *,
        latest: int = 0,
        streams: Mapping[tuple[int, int, int], int] | None = None,
        on_key: Callable[[bytes | None], object] = lambda _: None,
    ) -> None:
        """`latest` and `streams`: the time stamps of an earlier run; `on_key` is called with a key that was set."""
        self._sysid = sysid
        self._on_key = on_key
        self._use(key)
        self.latest = latest
        self.streams = dict(streams or {})

    @property
    def has_key(self) -> bool:
        """Whether frames are signed."""
        return self._hash is not None

    def sign(self, raw: bytes, link_id: int, now_ticks: int) -> bytes:
        """A frame as it is sent."""
        if self._hash is None:
            return raw
        self.latest = min(max(self.latest + 1, now_ticks), LAST_STAMP)
        row = schema(int.from_bytes(raw[7:10], "little"))
        assert row is not None
        latest = self.latest
        body = raw[:2] + bytes((SIGNED,)) + raw[3:-CHECKSUM_BYTES]
        crc = mcrf4xx(body[1:] + row.seed)
        stamped = body + _TAIL(crc, link_id, latest & 0xFFFF_FFFF, latest >> 32)
        return stamped + self._signature(stamped)

    def judge(self, frame: ReceivedFrame, now_ticks: int) -> str:
        """Why a received frame is refused; GOOD, the empty text, where it counts."""
        raw = frame.raw
        if not raw[2] & SIGNED:
            return GOOD if self._hash is None or frame.msgid in _UNSIGNED else NOT_SIGNED
        if self._hash is None:
            return NO_KEY
        if not hmac.compare_digest(self._signature(raw[:-_HASH_BYTES]), raw[-_HASH_BYTES:]):
            return OTHER_KEY
        stamp = int.from_bytes(raw[-_STAMP_BYTES - _HASH_BYTES : -_HASH_BYTES], "little")
        stream = frame.sysid, frame.compid, raw[-SIGNATURE_BYTES]
        before = self.streams.get(stream)
        if before is None:
            if stamp + STALE_TICKS < max(self.latest, now_ticks) or len(self.streams) >= MOST_STREAMS:
                return REPEATED
        elif stamp <= before:
            return REPEATED
        self.streams[stream] = stamp
        self.latest = max(self.latest, min(stamp, LAST_STAMP - 1))
        return GOOD

    def take_setup(self, frame: ReceivedFrame) -> bool:
        """Act on a SETUP_SIGNING that was judged good; whether the frame was one, for this vehicle or another."""
        if frame.msgid != mav.MAVLINK_MSG_ID_SETUP_SIGNING:
            return False
        content = decode(frame)
        assert content is not None
        if content.target_system in (0, self._sysid):
            key = bytes(content.secret_key)
            self._use(key if any(key) else None)
            self.streams.clear()
            self.latest = max(self.latest, min(content.initial_timestamp, LAST_STAMP - 1))
            self._on_key(key if any(key) else None)
        return True

    def _use(self, key: bytes | None) -> None:
        if key is not None and len(key) != KEY_BYTES:
            raise ValueError(f"a signing key has {KEY_BYTES} bytes, not {len(key)}")
        self._hash = None if key is None else hashlib.sha256(key)

    def _signature(self, stamped: bytes) -> bytes:
        assert self._hash is not None
        digest = self._hash.copy()
        digest.update(stamped)
        return digest.digest()[:_HASH_BYTES]
