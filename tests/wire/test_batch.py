"""Many frames at once: pymavlink is the oracle for every hot message, random payloads and every cut."""

import random

import pytest
from oracle import CLASSES, peer_frame, same
from pymavlink.dialects.v20 import common

from gcs.mavlink import batch, codec

HOT = ("HEARTBEAT", "LOCAL_POSITION_NED", "ATTITUDE", "GLOBAL_POSITION_INT", "BATTERY_STATUS", "NAMED_VALUE_FLOAT")


def assert_reads_like_pymavlink(data: bytes) -> None:
    theirs = common.MAVLink(None).parse_buffer(data)
    ours = batch.decode(data)
    assert ours.malformed == 0
    assert len(ours.messages) == len(theirs) == len(ours.headers)
    for header, message, other in zip(ours.headers.tolist(), ours.messages, theirs, strict=True):
        sender = (other.get_srcSystem(), other.get_srcComponent(), other.get_seq(), other.get_msgId())
        assert tuple(header) == sender
        assert type(message).__name__ == other.get_type()
        for field in message._fields:
            assert same(getattr(message, field), getattr(other, field)), field


@pytest.mark.parametrize("seed", range(5))
def test_hot_messages_with_random_payloads_mixed_in_one_run(seed: int) -> None:
    rng = random.Random(seed)
    names = [rng.choice(HOT) for _ in range(300)]
    frames = [peer_frame(n, rng.randbytes(CLASSES[n].unpacker.size), i % 256, 1 + i % 7) for i, n in enumerate(names)]
    assert_reads_like_pymavlink(b"".join(frames))


@pytest.mark.parametrize("name", HOT)
def test_hot_message_cut_at_every_byte(name: str) -> None:
    size = CLASSES[name].unpacker.size
    payload = bytes(i % 255 + 1 for i in range(size))
    assert_reads_like_pymavlink(b"".join(peer_frame(name, payload[:length]) for length in range(1, size + 1)))


def test_every_message_of_the_dialect_and_payloads_longer_than_known() -> None:
    frames = [peer_frame(n, bytes(i % 90 + 32 for i in range(min(CLASSES[n].unpacker.size + 3, 255)))) for n in CLASSES]
    assert_reads_like_pymavlink(b"".join(frames))


@pytest.mark.parametrize("where", [0, 40, -1])
@pytest.mark.parametrize("flip", [1, 0x80])
def test_what_is_not_plain_is_read_as_the_codec_reads_it(where: int, flip: int) -> None:
    good = b"".join(peer_frame(name, bytes(range(1, CLASSES[name].unpacker.size + 1)), i) for i, name in enumerate(HOT))
    signed = bytearray(peer_frame("HEARTBEAT", bytes(range(1, 10))))
    signed[2] = 1
    signed[-2:] = common.x25crc(bytes(signed[1:-2]) + bytes([CLASSES["HEARTBEAT"].crc_extra])).crc.to_bytes(2, "little")
    broken = bytearray(good)
    broken[where] ^= flip
    for data in (
        bytes(broken),
        good + b"text",
        b"\xfd" + good,
        good + bytes(signed) + bytes(13) + good,
        good[:-1],
        b"",
    ):
        split = codec.split(data)
        ours = batch.decode(data)
        assert ours.malformed == split.malformed
        assert ours.headers.tolist() == [[f.sysid, f.compid, f.seq, f.msgid] for f in split.frames]
        assert ours.messages == [codec.fields(f) for f in split.frames]
