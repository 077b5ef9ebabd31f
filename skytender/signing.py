"""MAVLink 2 signing: frames out signed, frames in judged (https://mavlink.io/en/guide/message_signing.html).

A signature is the first 48 bits of SHA-256 over key, frame (header, payload, checksum), link id and time stamp. Time
stamps count 10 µs since 2015-01-01 and rise strictly in each stream (system, component, link id); the first of a new
stream may be at most a minute behind the latest time known here. Time is an argument.
"""

from __future__ import annotations

import hashlib
import hmac
import struct
from collections.abc import Mapping
from enum import StrEnum

from skytender.checksum import mcrf4xx

KEY_BYTES = 32
TICKS_PER_S = 100_000
EPOCH_S = 1_420_070_400
"""2015-01-01 in Unix time."""
STALE_TICKS = 60 * TICKS_PER_S
SIGNED = 0x01
"""Incompatibility flag of a signed frame."""
CHECKSUM_BYTES, SIGNATURE_BYTES = 2, 13
_STAMP_BYTES, _HASH_BYTES = 6, 6
_SIGNED_BYTE = bytes((SIGNED,))
LAST_STAMP = (1 << 48) - 1
"""A time stamp has 48 bits; after the last one it is repeated, and no receiver accepts it twice."""
_TAIL = struct.Struct("<HBIH").pack
"""Checksum, link id, time stamp (low 32 bits, high 16)."""
UNSIGNED = frozenset({109, 246})
"""RADIO_STATUS and ADSB_VEHICLE are accepted without a signature: radios and transponders have no key."""
SETUP_SIGNING = 256
"""It carries a key: it is never accepted from a vehicle, recorded or forwarded."""
Stream = tuple[int, int, int]
"""System, component and link id."""


class SignatureVerdict(StrEnum):
    """Result of judging a frame; all but `GOOD` are refused."""

    GOOD = "good"
    UNSIGNED = "not signed"
    WRONG = "signed with another key"
    STALE = "repeated or out of date"
    NO_KEY = "signed, and there is no key to check it with"


def without_key(raw: bytes) -> SignatureVerdict:
    """Judge a frame where no key is set: a signature that cannot be checked proves nothing."""
    return SignatureVerdict.NO_KEY if raw[2] & SIGNED else SignatureVerdict.GOOD


def ticks(unix_s: float) -> int:
    """The time stamp of a Unix time."""
    return max(int((unix_s - EPOCH_S) * TICKS_PER_S), 0)


class Signing:
    """One key at one end of a link: its own time stamps, and the stamps of every stream that it has accepted."""

    def __init__(
        self, key: bytes, *, latest: int = 0, streams: Mapping[Stream, int] | None = None, most_streams: int = 1024
    ) -> None:
        """`latest`: the greatest time stamp of an earlier run, by which no later one may be less; `streams`: its
        streams. Raises ValueError for a key of another length."""
        if len(key) != KEY_BYTES:
            raise ValueError(f"a signing key has {KEY_BYTES} bytes, not {len(key)}")
        self._hash = hashlib.sha256(key)
        self._most_streams = most_streams
        self.latest = latest
        self.streams: dict[Stream, int] = dict(streams or {})

    def sign(self, raw: bytes, seed: bytes, link_id: int, now_ticks: int) -> bytes:
        """An unsigned frame, signed; `seed`: the byte by which its message's checksum begins."""
        latest = now_ticks if now_ticks > self.latest else self.latest + 1
        self.latest = latest = latest if latest < LAST_STAMP else LAST_STAMP
        body = raw[:2] + _SIGNED_BYTE + raw[3:-CHECKSUM_BYTES]
        crc = mcrf4xx(body[1:] + seed)
        stamped = body + _TAIL(crc, link_id, latest & 0xFFFF_FFFF, latest >> 32)
        return stamped + self._signature(stamped)

    def judge(self, raw: bytes, msgid: int, now_ticks: int) -> SignatureVerdict:
        """Whether a received frame counts; its time stamp is kept where it does."""
        if not raw[2] & SIGNED:
            return SignatureVerdict.GOOD if msgid in UNSIGNED else SignatureVerdict.UNSIGNED
        if not hmac.compare_digest(self._signature(raw[:-_HASH_BYTES]), raw[-_HASH_BYTES:]):
            return SignatureVerdict.WRONG
        stamp = int.from_bytes(raw[-_STAMP_BYTES - _HASH_BYTES : -_HASH_BYTES], "little")
        stream = raw[5], raw[6], raw[-SIGNATURE_BYTES]
        before = self.streams.get(stream)
        if before is None:
            if stamp + STALE_TICKS < max(self.latest, now_ticks) or len(self.streams) >= self._most_streams:
                return SignatureVerdict.STALE
        elif stamp <= before:
            return SignatureVerdict.STALE
        self.streams[stream] = stamp
        self.latest = max(self.latest, min(stamp, LAST_STAMP - 1))
        return SignatureVerdict.GOOD

    def _signature(self, stamped: bytes) -> bytes:
        digest = self._hash.copy()
        digest.update(stamped)
        return digest.digest()[:_HASH_BYTES]
