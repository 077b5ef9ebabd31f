"""Frames side by side are the frames that they are apart."""

import random

import numpy as np
import pytest

from gcs.frame_spans import FrameSpans

PIECES = [b"one", b"", b"three", b"4", b"fifty-five"]


def test_frames_side_by_side_are_those_apart() -> None:
    whole = FrameSpans.of(PIECES)
    assert (list(whole), len(whole), whole[2], whole[-1]) == (PIECES, 5, b"three", b"fifty-five")
    assert list(whole[1:4]) == PIECES[1:4]
    assert whole[1:4].data is whole.data
    assert whole == PIECES
    assert whole != PIECES[1:]
    assert FrameSpans.of(whole) is whole
    assert list(FrameSpans.of([])) == []
    with pytest.raises(IndexError):
        whole[5]


def test_parts_are_joined_in_their_order_and_no_memory_twice() -> None:
    chance = random.Random(2)
    memory = bytes(chance.randrange(256) for _ in range(500))
    marked = FrameSpans(memory, np.array([(3, 9), (12, 40), (40, 41), (100, 500)]))
    for _ in range(200):
        parts = [
            chance.choice((marked[: chance.randrange(5)], marked[chance.randrange(4) :], PIECES[chance.randrange(4) :]))
            for _ in range(chance.randrange(6))
        ]
        joined = FrameSpans.joined(parts)
        assert list(joined) == [frame for part in parts for frame in part]
        assert joined.data.count(memory) <= 1
