"""Frames from a stream that is cut anywhere: the same as from the whole; nothing grows."""

import random

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.frame_stream import FrameStream


def spoken(count: int) -> list[bytes]:
    sender = mav.MAVLink(None, srcSystem=4, srcComponent=1)
    rng = random.Random(3)
    frames = []
    for i in range(count):
        if i % 3:
            message = mav.MAVLink_attitude_message(i, *(rng.uniform(-1, 1) for _ in range(6)))
        else:
            text = bytes(rng.choice([0x41, 0x7A]) for _ in range(rng.randrange(1, 50)))
            message = mav.MAVLink_statustext_message(6, text)
        frames.append(bytes(message.pack(sender)))
    return frames


def test_however_a_stream_is_cut_its_frames_are_those_that_were_sent() -> None:
    frames = spoken(300)
    whole = b"".join(frames)
    for most in (1, 7, 64, 1000):
        rng, stream, at, found, malformed = random.Random(most), FrameStream(), 0, [], 0
        while at < len(whole):
            step = rng.randrange(1, most + 1)
            split = stream.feed(whole[at : at + step])
            found += [frame.raw for frame in split.frames]
            malformed += split.malformed
            at += step
        assert found == frames
        assert malformed == 0


def test_what_waits_is_never_more_than_a_frame() -> None:
    stream = FrameStream()
    for byte in (b"\xfd\xff\x00", b"\xfd", b"\x00", b"\xfd\x09\x01"):
        for _ in range(50):
            stream.feed(byte * 700)
            assert len(stream._pending) < codec.LARGEST_FRAME
