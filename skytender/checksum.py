"""MAVLink's checksum, CRC-16/MCRF4XX: polynomial 0x1021 reflected, the register 0xFFFF at first.

Eight bytes are summed in one step (Kounavis and Berry 2005). For compiled code, checksum.pxd declares `crc_of`, of
data[begin:end], and `ended`, of the same with one byte more: a frame's checksum ends with its message's seed.
"""

from __future__ import annotations

from typing import Any

from cython.cimports.skytender.checksum import _AT_ONCE, _TERMS

_REFLECTED = 0x8408


def _fill() -> None:
    """Let _TERMS[k][byte] be the checksum, from a register of 0, of a byte with k zeros behind it."""
    for byte in range(256):
        term: Any = byte
        for _ in range(8):
            term = term >> 1 ^ (_REFLECTED if term & 1 else 0)
        _TERMS[0][byte] = term
    for k in range(1, _AT_ONCE):
        for byte in range(256):
            before = _TERMS[k - 1][byte]
            _TERMS[k][byte] = before >> 8 ^ _TERMS[0][before & 0xFF]


_fill()


def summed(register: int, data: Any, begin: int, end: int) -> int:
    """The register after data[begin:end]."""
    while begin + _AT_ONCE <= end:
        register = (
            _TERMS[7][data[begin] ^ register & 0xFF]
            ^ _TERMS[6][data[begin + 1] ^ register >> 8]
            ^ _TERMS[5][data[begin + 2]]
            ^ _TERMS[4][data[begin + 3]]
            ^ _TERMS[3][data[begin + 4]]
            ^ _TERMS[2][data[begin + 5]]
            ^ _TERMS[1][data[begin + 6]]
            ^ _TERMS[0][data[begin + 7]]
        )
        begin += _AT_ONCE
    while begin < end:
        register = register >> 8 ^ _TERMS[0][data[begin] ^ register & 0xFF]
        begin += 1
    return register


def mcrf4xx(data: bytes, register: int = 0xFFFF) -> int:
    """Checksum of these bytes; `register`: where it begins."""
    return summed(register, data, 0, len(data))
