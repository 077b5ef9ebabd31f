"""A tick's datagrams taken in by compiled code, against the same datagrams read by the system's own calls."""

import contextlib
import random
import socket
from collections.abc import Iterator

import numpy as np
import pytest

from gcs.link.inbox import FULL, LOST, NOTHING, UNKNOWN, Inbox
from gcs.link.intake import numbered
from gcs.mavlink import codec
from gcs.mavlink.frame_runs import ADDRESS, AWAITED, NUMBERS
from gcs.mavlink.sequence import TickCollector

KNOWN = 6
UNKNOWN_BYTES = 40


@pytest.fixture
def sockets() -> Iterator[list[socket.socket]]:
    """The receiver's, and those of senders."""
    with contextlib.ExitStack() as stack:
        made = [stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM)) for _ in range(KNOWN + 2)]
        made[0].bind(("127.0.0.1", 0))
        for sender in made[1:]:
            sender.connect(made[0].getsockname())
        yield made


def answer(sysid: int, number: int, t_ms: int, draw: random.Random) -> bytes:
    beat = codec.message("HEARTBEAT", type=2, autopilot=12, base_mode=0, custom_mode=0, system_status=3)
    end = codec.message("SYSTEM_TIME", time_unix_usec=0, time_boot_ms=t_ms)
    messages = [beat] * draw.randrange(4) + [end]
    return b"".join(codec.frame(message, (number + k) % 256, sysid, 1) for k, message in enumerate(messages))


@pytest.mark.parametrize("seed", range(10))
def test_every_datagram_is_an_answer_or_handed_over(sockets: list[socket.socket], seed: int) -> None:
    draw = random.Random(seed)
    receiver, senders = sockets[0], sockets[1:]
    most, room = draw.choice([1, 3, 50]), 300
    inbox = Inbox(draw.choice([200, 1 << 14]), most, room, UNKNOWN_BYTES)
    awaited, lanes = np.empty((KNOWN, AWAITED), np.int64), np.full(NUMBERS, -1)
    collectors = [TickCollector(k + 1, 1) for k in range(KNOWN)]
    for k, collector in enumerate(collectors):
        collector.live_in(awaited[k])
        awaited[k, ADDRESS] = numbered(k, shared=False)
        lanes[k + 1] = k
    inbox.know(senders[-1].getsockname(), numbered(KNOWN, shared=False))
    for k in range(KNOWN):
        inbox.know(senders[k].getsockname(), numbered(k, shared=False))
    inbox.forget(numbered(KNOWN, shared=False))
    numbers = [2] * KNOWN
    for tick in range(60):
        expected: dict[int, bytes] = {}
        others: list[tuple[int, bytes]] = []
        answering = draw.sample(range(KNOWN), draw.randrange(KNOWN + 1))
        sent: list[tuple[int, bytes]] = []
        for k in answering:
            collectors[k].begin(tick)
            whole = answer(k + 1, numbers[k], tick, draw)
            numbers[k] = (numbers[k] + len(codec.split(whole).frames)) % 256
            expected[k + 1] = whole
            sent.append((k, whole))
        for _ in range(draw.randrange(5)):
            k = draw.randrange(len(senders))
            datagram = draw.randbytes(draw.choice([0, 5, UNKNOWN_BYTES, UNKNOWN_BYTES + 1, room + 9]))
            sent.append((k, datagram))
            if k < KNOWN or len(datagram) <= UNKNOWN_BYTES:
                others.append((k, datagram[:room]))
        draw.shuffle(sent)
        for k, datagram in sent:
            senders[k].send(datagram)
        found: dict[int, bytes] = {}
        handed: list[tuple[int, bytes]] = []
        place = {sender.getsockname(): k for k, sender in enumerate(senders)}
        while True:
            met = inbox.receive(receiver.fileno(), draw.randrange(1, 4), draw.randrange(1, 4), awaited, lanes)
            stray = inbox.stray() if met in (UNKNOWN, FULL) else None
            while (rest := inbox.stopped()) is not None:
                handed.append((rest[0] >> 1, rest[1]))
                inbox.receive(-1, 0, 0, awaited, lanes)
            if stray is not None:
                handed.append((place[stray[1]], stray[0]))
            if met == NOTHING:
                break
        if inbox.answers:
            _, runs = inbox.pop_answers(awaited)
            found = {run.sender[0]: b"".join(run.raws()) for run in runs}
        for k, datagram in handed.copy():  # for an answer without a place the interpreter's way is left
            if expected.get(k + 1) == datagram and collectors[k].feed(codec.split(datagram).frames):
                collectors[k].pop_frames()
                found[k + 1] = datagram
                handed.remove((k, datagram))
        assert found == expected
        assert sorted(handed) == sorted(others)
    with pytest.raises(BlockingIOError):
        receiver.recv(1, socket.MSG_DONTWAIT)


def test_one_is_let_go_where_it_is_to_be_lost(sockets: list[socket.socket]) -> None:
    inbox = Inbox(1 << 10, 10, 300, UNKNOWN_BYTES)
    none, lanes = np.empty((0, AWAITED), np.int64), np.full(NUMBERS, -1)
    inbox.know(sockets[1].getsockname(), numbered(0, shared=False))
    for text in (b"lost", b"kept"):
        sockets[1].send(text)
    assert inbox.receive(sockets[0].fileno(), 5, 5, none, lanes, lost=True) == LOST
    assert inbox.taken == 1
    assert inbox.stopped() is None
    assert inbox.receive(sockets[0].fileno(), 5, 5, none, lanes) == NOTHING
    assert inbox.stopped() == (numbered(0, shared=False), b"kept")
