"""Hostile input by seed: datagrams, lines of commands, and mutated files."""

from __future__ import annotations

import json
import math
import random
import struct
from collections.abc import Sequence

from pymavlink.dialects.v20 import common

from gcs.mavlink import codec

CLASSES = list(common.mavlink_map.values())
HOT = [
    codec.msgid(name)
    for name in (
        *("HEARTBEAT", "LOCAL_POSITION_NED", "ATTITUDE", "BATTERY_STATUS", "SYS_STATUS", "STATUSTEXT", "COMMAND_LONG"),
        *("COMMAND_INT", "COMMAND_ACK", "PARAM_SET", "PARAM_VALUE", "NAMED_VALUE_INT", "MISSION_ITEM_INT"),
        *("MISSION_COUNT", "SET_POSITION_TARGET_LOCAL_NED", "GPS_GLOBAL_ORIGIN", "HOME_POSITION", "SYSTEM_TIME"),
        *("FOLLOW_TARGET", "ADSB_VEHICLE", "EXTENDED_SYS_STATE", "SETUP_SIGNING", "GLOBAL_POSITION_INT"),
    )
]
SENDERS = [(7, 1), (1, 1), (101, 1), (255, 190), (7, 100), (0, 0), (254, 1)]
WHOLE = [0, 1, 2, 7, 101, 255, 255, 127, 128, 32767, 32768, 65535, 2**31 - 1, 2**31, 2**32 - 1, 2**63, 2**64 - 1]
REAL = [0.0, -0.0, 1.0, -1.0, 1e-45, 1e38, -3.4e38, math.inf, -math.inf, math.nan, 31010.0, 400.0, 176.0, 5.0]
TEXTS = (b"1e999", b"NaN", b"-1", b"null", b"99999999999999999999", b'"', b"{", b"[[[[", b"&a *a ")
NAMES = (b"XferIn", b"XferOut", b"SIM_BAT_CAP_J", b"MPC_XY_CRUISE", b"\xff" * 50, b"\x1b[2J", b"", b"x" * 50)
WORDS = (
    *("hold", "return", "land", "rejoin", "refuel", "skip", "retarget", "pause", "resume", "inspect", "speed", "seek"),
    *("", "\x1b[2J", "x" * 100),
)
SIZES = {"b": 1, "B": 1, "h": 2, "H": 2, "i": 4, "I": 4, "q": 8, "Q": 8, "f": 4, "d": 8}


class Hostile:
    """One stream of hostile input; the same seed gives the same."""

    def __init__(self, seed: int, corpus: Sequence[bytes] = ()) -> None:
        self.random = random.Random(seed)
        self._corpus = list(corpus) or [b"\xfd" * 12]

    def frame(self) -> bytes:
        """A frame with a right checksum and any content."""
        rng = self.random
        msgid = rng.choice(HOT) if rng.random() < 0.8 else rng.choice(CLASSES).id
        cls = common.mavlink_map[msgid]
        payload = b"".join(self._field(form) for form in codec.layout(msgid).formats)
        if rng.random() < 0.2:
            payload = payload[: rng.randrange(1, len(payload) + 1)]
        sysid, compid = rng.choice(SENDERS) if rng.random() < 0.9 else (rng.randrange(256), rng.randrange(256))
        signed = rng.random() < 0.05
        head = struct.pack("<BBBBBBHB", len(payload), signed, 0, rng.randrange(256), sysid, compid, msgid & 0xFFFF,
                           msgid >> 16)  # fmt: skip
        crc = codec.mcrf4xx(head + payload + bytes([cls.crc_extra]))
        return b"\xfd" + head + payload + struct.pack("<H", crc) + (rng.randbytes(13) if signed else b"")

    def datagram(self) -> bytes:
        """Mostly intact frames, for they go deepest; and broken, cut, joined, old and meaningless bytes."""
        rng = self.random
        kind = rng.random()
        if kind < 0.7:
            return self.frame()
        if kind < 0.8:
            return self.mutated(self.frame())
        if kind < 0.85:
            return b"".join(self.frame() for _ in range(rng.randrange(2, 6)))
        if kind < 0.95:
            return self.mutated(rng.choice(self._corpus))
        if kind < 0.999:
            return rng.randbytes(rng.randrange(0, 300))
        return rng.choice((b"\xfd", b"\xfe", b"\xfd\xff\0\0", b"\0")) * rng.randrange(1, 16000)

    def line(self) -> bytes:
        """A line for session.sock."""
        rng = self.random
        values = (1, 101, 201, 7, -1, 0, 2**70, 1.5, math.nan, None, True, "1", [], {}, "\ud800", "a" * 300)
        content = {"command": rng.choice(WORDS)}
        for key in ("sysid", "target", "id", "t_s", "speed"):
            if rng.random() < 0.5:
                content[key] = rng.choice(values)  # type: ignore[assignment]
        line = json.dumps(content).encode()
        if rng.random() < 0.2:
            line = self.mutated(line).replace(b"\n", b" ")
        if rng.random() < 0.01:
            line = rng.choice((b"[", b'{"a":', b'"')) * rng.randrange(1, 3000)
        return line + b"\n"

    def mutated(self, data: bytes) -> bytes:
        """The same with some of it flipped, cut, repeated, moved, or overwritten by numbers that hurt."""
        rng, out = self.random, bytearray(data)
        for _ in range(rng.choice((1, 1, 2, 4, 16))):
            if not out:
                return rng.randbytes(rng.randrange(64))
            at = rng.randrange(len(out))
            kind = rng.randrange(7)
            if kind == 0:
                out[at] ^= 1 << rng.randrange(8)
            elif kind == 1:
                out[at] = rng.choice((0, 0x7F, 0x80, 0xFF, 0x0A, 0x7B, 0x5B, 0x22, 0x2D, 0x39))
            elif kind == 2:
                del out[at : at + rng.choice((1, 2, 8, 64, len(out)))]
            elif kind == 3:
                out[at:at] = out[at : at + rng.choice((1, 8, 64, 512))] * rng.choice((1, 2, 8))
            elif kind == 4:
                out[at:at] = rng.randbytes(rng.choice((1, 4, 8, 64)))
            elif kind == 5:
                out[at : at + 8] = struct.pack("<d", rng.choice(REAL))
            else:
                text = rng.choice(TEXTS)
                out[at : at + len(text)] = text
        return bytes(out)

    def _field(self, form: str) -> bytes:
        rng = self.random
        code, count = form[-1], int(form[:-1] or 1) if len(form) > 1 else 1
        if code == "s":
            return rng.choice(NAMES)[:count].ljust(count, b"\0")
        if code in "fd":
            draw = [rng.choice(REAL) if rng.random() < 0.5 else rng.uniform(-200.0, 200.0) for _ in range(count)]
            return struct.pack(f"<{count}{code}", *draw)
        if rng.random() < 0.5:
            return b"".join(
                (rng.choice(WHOLE) % (1 << 8 * SIZES[code])).to_bytes(SIZES[code], "little") for _ in range(count)
            )
        return rng.randbytes(count * SIZES[code])
