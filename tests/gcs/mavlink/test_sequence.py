"""Sequence numbers: gaps, and ticks gathered from datagrams that the network mistreats."""

import itertools
import random
from collections.abc import Sequence

import numpy as np
import pytest

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.gaps import GapCounter, RecordedGaps
from gcs.mavlink.sequence import FIRST_ANSWER, TickCollector

SYSID, COMPID = 4, 1


def heartbeat(seq: int, sysid: int = SYSID, compid: int = COMPID) -> bytes:
    fields = {"type": 2, "autopilot": 12, "base_mode": 0, "custom_mode": 0, "system_status": 4}
    return codec.encode("HEARTBEAT", seq % 256, sysid, compid, **fields)


def system_time(seq: int, t_ms: int, sysid: int = SYSID) -> bytes:
    return codec.encode("SYSTEM_TIME", seq % 256, sysid, COMPID, time_unix_usec=10**15, time_boot_ms=t_ms)


def answer(first: int, t_ms: int, count: int) -> list[bytes]:
    """A tick's frames, the answer last."""
    return [heartbeat(first + i) for i in range(count - 1)] + [system_time(first + count - 1, t_ms)]


def received(raws: Sequence[bytes]) -> list[Frame]:
    return codec.split(b"".join(raws)).frames


HELLO = [heartbeat(0), system_time(1, 0)]


@pytest.mark.parametrize(
    ("numbers", "lost"),
    [
        ([5, 6, 7], 0),
        ([254, 255, 0, 1], 0),
        ([5, 8], 2),  # 6 and 7
        ([254, 1], 2),  # 255 and 0
        ([5, 5, 6, 6], 0),
        ([5, 7, 6, 8], 0),
        ([5, 8, 6, 9, 6], 1),  # 7; the second 6 is a duplicate
        ([5, 8, 7, 6, 7, 6, 9], 0),
    ],
)
def test_gaps_are_counted_as_lost(numbers: list[int], lost: int) -> None:
    gaps = GapCounter()
    for number in numbers:
        gaps.feed(1, 1, number)
    assert gaps.lost == lost


def test_gap_count_ignores_order_and_repetition() -> None:
    rng = random.Random(4)
    gaps = GapCounter()
    kept = [n for n in range(5000) if n in (0, 4999) or rng.random() > 0.3]
    sent = sorted([*kept, *rng.sample(kept, 500)], key=lambda n: n + (0 if n in (0, 4999) else rng.random() * 20))
    for number in sent:
        gaps.feed(1, 1, number % 256)
    assert gaps.lost == 5000 - len(kept)


@pytest.mark.parametrize("missing", [0, 2, 4])
def test_tick_waits_for_any_missing_number(missing: int) -> None:
    collector = TickCollector(SYSID, COMPID)
    raws = answer(2, 100, 5)
    collector.begin(100)
    assert not collector.feed(received(raws[:missing] + raws[missing + 1 :]))
    with pytest.raises(RuntimeError, match="tick 100 of vehicle 4 is not complete"):
        collector.pop_frames()
    with pytest.raises(RuntimeError, match="tick 100 of vehicle 4 has not been taken"):
        collector.begin(200)
    assert collector.feed(received(raws))
    assert [frame.raw for frame in collector.pop_frames()] == raws


def test_ticks_survive_splitting_loss_reordering_repetition_and_every_turn_of_the_numbers() -> None:
    rng = random.Random(8)
    collector = TickCollector(SYSID, COMPID)
    at, earlier = FIRST_ANSWER, [HELLO]
    for tick in range(120):
        t_ms = 100 * tick
        raws = answer(at, t_ms, rng.randint(1, 127))
        cuts = [*sorted(rng.sample(range(len(raws)), min(len(raws) - 1, rng.randint(0, 3)))), len(raws)]
        datagrams = [raws[a:b] for a, b in zip([0, *cuts], cuts, strict=False) if a < b]
        collector.begin(t_ms)
        for _ in range(100):
            sent = [d for d in datagrams if rng.random() > 0.3] + [d for d in earlier if rng.random() < 0.3]
            rng.shuffle(sent)
            for datagram in sent:
                collector.feed(received(datagram))
            if collector.complete:
                break
        assert [frame.raw for frame in collector.pop_frames()] == raws
        at += len(raws)
        earlier = datagrams
    assert at > 256 * 10


def test_answer_of_half_a_turn_ago_is_told_from_new_numbers_by_its_time() -> None:
    collector = TickCollector(SYSID, COMPID)
    at = FIRST_ANSWER
    history = [answer(at + 100 * tick, 100 * tick, 100) for tick in range(3)]
    for tick, raws in enumerate(history):
        collector.begin(100 * tick)
        collector.feed(received(raws))
        collector.pop_frames()
    collector.begin(300)
    collector.feed(received(history[0]))  # numbers 2 … 101; the next one is 302 - 256 = 46
    assert collector.held == 0


def test_frames_and_answers_of_others_do_not_count() -> None:
    collector = TickCollector(SYSID, COMPID)
    collector.begin(100)
    collector.feed(received([heartbeat(2, sysid=9), heartbeat(2, compid=100), system_time(3, 100, sysid=9)]))
    assert collector.held == 0
    assert collector.feed(received([heartbeat(2), system_time(3, 100)]))


def test_answer_for_another_time_does_not_end_the_tick() -> None:
    collector = TickCollector(SYSID, COMPID)
    collector.begin(200)
    assert not collector.feed(received([heartbeat(2), system_time(3, 100)]))
    assert not collector.feed(received([heartbeat(2), system_time(3, 300)]))


def test_frames_counted_together_are_counted_as_one_by_one() -> None:
    rng = random.Random(1)
    frames, numbers = [], dict.fromkeys([(1, 1), (1, 2), (9, 1)], 250)
    for _ in range(3000):
        sender = rng.choice(list(numbers))
        numbers[sender] += rng.choice([1, 1, 1, 1, 1, 2, 5, 0, -3])
        frames.append(Frame(*sender, numbers[sender] % 256, 0, b""))
    together, single = GapCounter(), GapCounter()
    for first in range(0, len(frames), 7):
        together.feed_all(frames[first : first + 7])
    for frame in frames:
        single.feed(frame.sysid, frame.compid, frame.seq)
    assert together.lost_of == single.lost_of
    assert min(together.lost_of.values()) > 0


def test_a_recording_is_counted_in_pieces_of_any_length() -> None:
    rng = random.Random(2)
    numbers = [k % 256 for k in range(0, 900, 2) if rng.random() > 0.2]
    heads = np.array([(SYSID, COMPID, number) for number in numbers])
    recorded, single, first = RecordedGaps(), GapCounter(), 0
    for rows in itertools.cycle((5, 1, 2)):  # one row's columns are contiguous, those of several are not
        piece = heads[first : first + rows]
        if not len(piece):
            break
        lost, new = recorded.count(piece[:, 0], piece[:, 1], piece[:, 2])
        assert new.all()
        for change, number in zip(lost, piece[:, 2], strict=True):
            before = single.lost
            single.feed(SYSID, COMPID, int(number))
            assert single.lost - before == change
        first += rows
    assert single.lost > len(numbers)
