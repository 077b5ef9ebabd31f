"""Answers that the heads of a chunk's frames give: which frames went to vehicles, and the last of each kind."""

from __future__ import annotations

import numpy as np
from cython.cimports.gcs.recording.frame_heads import head_at
from numpy.typing import NDArray

IntArray = NDArray[np.int64]
ByteArray = NDArray[np.uint8]
BoolArray = NDArray[np.bool_]

_SYSTEM_TIME = 2
_PRIME, _OFFSET = 1099511628211, 14695981039346656037
"""Of FNV-1a in 64 bits."""


def sent_frames(heads: IntArray, stations: BoolArray, answered_us: IntArray, relayed: IntArray) -> BoolArray:
    """Which frames (n,) were sent by a ground station.

    In a session of ours a vehicle's own frame that stands behind the SYSTEM_TIME with which its answer of that tick
    ended has been relayed to another vehicle.

    Args:
        heads: (n, 6) of a chunk.
        stations: (65536,) which senders, system id << 8 | component, are stations.
        answered_us: (65536,) when each sender's last answer ended, which is brought up to date; empty where no session
            of ours has been recorded.
        relayed: (2,) ids of the messages that are relayed.
    """
    sent = np.zeros(len(heads), dtype=np.bool_)
    _fill_sent(heads, stations.view(np.uint8), answered_us, relayed, sent.view(np.uint8))
    return sent


def frame_keys(data: ByteArray, heads: IntArray, subjects: IntArray) -> IntArray:
    """(n,) for each frame a number that is the same for the same sender, message and subject (FNV-1a, 64 bits).

    subjects: (m, 3) message id, where in its payload the subject begins, and how long it is.
    """
    keys = np.empty(len(heads), dtype=np.int64)
    _fill_keys(data, heads, subjects, keys)
    return keys


def last_of_each(keys: IntArray) -> IntArray:
    """Where each of some keys, which are hashes, stands last; the latest first."""
    size = 1
    while size < 2 * len(keys):
        size *= 2
    last = np.empty(len(keys), dtype=np.int64)
    return last[: _fill_last(keys, np.full(size, -1, dtype=np.int64), last)].copy()


def _fill_sent(heads: IntArray, stations: ByteArray, answered_us: IntArray, relayed: IntArray, sent: ByteArray) -> None:
    for i in range(len(heads)):
        head = head_at(heads, i)
        sender = head.sysid << 8 | head.compid
        sent[i] = stations[sender]
        if len(answered_us) > 0:
            if head.msgid == _SYSTEM_TIME:
                answered_us[sender] = head.t_us
            elif answered_us[sender] == head.t_us and (head.msgid == relayed[0] or head.msgid == relayed[1]):
                sent[i] = 1


def _hashed(h: int, byte: int) -> int:
    return (h ^ byte) * _PRIME


def _fill_keys(data: ByteArray, heads: IntArray, subjects: IntArray, keys: IntArray) -> None:
    for i in range(len(heads)):
        head = head_at(heads, i)
        h = _hashed(_hashed(_OFFSET, head.sysid), head.compid)
        h = _hashed(_hashed(_hashed(h, head.msgid & 0xFF), head.msgid >> 8 & 0xFF), head.msgid >> 16)
        for s in range(len(subjects)):
            if subjects[s, 0] == head.msgid:
                begin = head.at + (10 if data[head.at] == 0xFD else 6)
                for k in range(subjects[s, 1], subjects[s, 1] + subjects[s, 2]):
                    h = _hashed(h, data[begin + k] if k < data[head.at + 1] else 0)
        keys[i] = h


def _fill_last(keys: IntArray, slots: IntArray, last: IntArray) -> int:
    """Find the last of each key by a table of slots, a power of two, that hold -1; how many there are."""
    mask = len(slots) - 1
    count = 0
    for i in range(len(keys) - 1, -1, -1):
        slot = keys[i] & mask
        while slots[slot] >= 0 and keys[slots[slot]] != keys[i]:
            slot = (slot + 1) & mask
        if slots[slot] < 0:
            slots[slot] = last[count] = i
            count += 1
    return count
