"""MAVLink 2 signing: frames out signed, frames in judged (https://mavlink.io/en/guide/message_signing.html).

A signature is the first 48 bits of SHA-256 over key, frame (header, payload, checksum), link id and time stamp. Time
stamps count 10 µs since 2015-01-01 and rise strictly in each stream (system, component, link id); the first of a new
stream may be at most a minute behind the latest time known here. Time is an argument.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from enum import StrEnum
from hmac import compare_digest
from typing import Any

import cython
from cython.cimports.cpython.bytes import PyBytes_AS_STRING, PyBytes_FromStringAndSize
from cython.cimports.libc.string import memcpy
from cython.cimports.skytender.checksum import crc_of, ended
from cython.cimports.skytender.frames import CHECKSUM_BYTES, HEADER_BYTES, SIGNATURE_BYTES, SIGNED

KEY_BYTES = 32
TICKS_PER_S = 100_000
EPOCH_S = 1_420_070_400
"""2015-01-01 in Unix time."""
STALE_TICKS = 60 * TICKS_PER_S
_STAMP_BYTES, _HASH_BYTES = 6, 6
LAST_STAMP = (1 << 48) - 1
"""A time stamp has 48 bits; after the last one it is repeated, and no receiver accepts it twice."""
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

    latest: int
    """the greatest time stamp given or accepted"""
    streams: dict[Stream, int]
    """the last time stamp of each stream"""
    _hash: Any
    _most_streams: int

    def __init__(
        self, key: bytes, *, latest: Any = 0, streams: Mapping[Stream, int] | None = None, most_streams: int = 1024
    ) -> None:
        """`latest`: the greatest time stamp of an earlier run, by which no later one may be less; `streams`: its
        streams. Raises ValueError for a key of another length."""
        if len(key) != KEY_BYTES:
            raise ValueError(f"a signing key has {KEY_BYTES} bytes, not {len(key)}")
        self._hash = hashlib.sha256(key)
        self._most_streams = most_streams
        self.latest = min(latest, LAST_STAMP)
        self.streams = dict(streams or {})

    def sign(self, raw: bytes, seed: bytes, link_id: int, now_ticks: int) -> bytes:
        """An unsigned frame, signed; `seed`: the byte by which its message's checksum begins. Raises ValueError for
        what is too short to be a frame."""
        body_end = len(raw) - CHECKSUM_BYTES
        if body_end < HEADER_BYTES:
            raise ValueError(f"a frame has at least {HEADER_BYTES + CHECKSUM_BYTES} bytes, not {len(raw)}")
        self.latest = stamp = min(max(now_ticks, self.latest + 1), LAST_STAMP)
        stamped: bytes = PyBytes_FromStringAndSize(
            cython.NULL, body_end + CHECKSUM_BYTES + SIGNATURE_BYTES - _HASH_BYTES
        )
        to: Any = cython.cast(cython.p_uchar, PyBytes_AS_STRING(stamped))
        memcpy(to, PyBytes_AS_STRING(raw), body_end)
        to[2] = SIGNED
        crc = ended(crc_of(to, 1, body_end), seed[0])
        to[body_end], to[body_end + 1], to[body_end + 2] = crc & 0xFF, crc >> 8, link_id
        for k in range(_STAMP_BYTES):
            to[body_end + 3 + k] = stamp >> 8 * k & 0xFF
        return stamped + self._signature(stamped)

    def judge(self, raw: bytes, msgid: int, now_ticks: int) -> SignatureVerdict:
        """Whether a received frame counts; its time stamp is kept where it does."""
        size = len(raw)
        if size < HEADER_BYTES or not raw[2] & SIGNED:
            return SignatureVerdict.GOOD if msgid in UNSIGNED else SignatureVerdict.UNSIGNED
        hash_at = size - _HASH_BYTES
        if not compare_digest(self._signature(raw[:hash_at]), raw[hash_at:]):
            return SignatureVerdict.WRONG
        stamp = 0
        for k in range(_STAMP_BYTES):
            stamp = stamp << 8 | raw[hash_at - 1 - k]
        stream = raw[5], raw[6], raw[size - SIGNATURE_BYTES]
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
