"""Frames of a datagram found by compiled code, against the codec's own splitting and against the frames that pymavlink
sent."""

import random
from itertools import groupby

import pytest
from oracle import CLASSES, peer_frame
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.datagram import FrameRun, frame_at, raws_of, runs_of
from gcs.mavlink.frame_runs import MOST_BYTES
from gcs.mavlink.gaps import GapCounter
from gcs.mavlink.sequence import TickCollector

OFTEN = ("ATTITUDE", "LOCAL_POSITION_NED", "SYSTEM_TIME", "HEARTBEAT", "BATTERY_STATUS")
NAMES = sorted(CLASSES)


def sent(rng: random.Random, count: int) -> list[bytes]:
    """Frames of a few senders, most of them numbered on, with payloads of any bytes."""
    frames, numbers = [], dict.fromkeys([(3, 1), (3, 100), (9, 1)], rng.randrange(256))
    sender = rng.choice(list(numbers))
    for _ in range(count):
        if rng.random() < 0.2:
            sender = rng.choice(list(numbers))
        name = rng.choice(OFTEN if rng.random() < 0.7 else NAMES)
        size = CLASSES[name].unpacker.size
        payload = rng.randbytes(rng.randrange(1, size + 1) if rng.random() < 0.3 else size)
        frames.append(signed(peer_frame(name, payload, numbers[sender], *sender), rng))
        numbers[sender] = (numbers[sender] + (1 if rng.random() < 0.9 else rng.randrange(256))) % 256
    return frames


def signed(raw: bytes, rng: random.Random) -> bytes:
    """Some of them with a signature, which nobody checks here."""
    if rng.random() > 0.1:
        return raw
    head = bytes([raw[0], raw[1], 1]) + raw[3:-2]
    crc = codec.mcrf4xx(head[1:] + codec.seed_of(raw))
    return head + crc.to_bytes(2, "little") + rng.randbytes(13)


def spoilt(rng: random.Random, datagram: bytes) -> bytes:
    """A byte changed, cut out or put in, the end missing, or something else between frames."""
    at = rng.randrange(len(datagram))
    kind = rng.randrange(5)
    if kind == 0:
        return datagram[:at] + bytes([datagram[at] ^ 1 << rng.randrange(8)]) + datagram[at + 1 :]
    if kind == 1:
        return datagram[:at] + datagram[at + 1 :]
    if kind == 2:
        return datagram[:at] + rng.randbytes(1) + datagram[at:]
    if kind == 3:
        return datagram[:at]
    return rng.choice([b"\xfe\x09\x00", b"\xfd", rng.randbytes(20)]) + datagram


@pytest.mark.parametrize("seed", range(5))
def test_a_datagram_is_found_whole_exactly_where_the_codec_finds_nothing_else(seed: int) -> None:
    rng = random.Random(seed)
    whole = broken = 0
    for _ in range(200):
        datagram = b"".join(sent(rng, rng.randrange(1, 30)))
        if rng.random() < 0.5:
            datagram = spoilt(rng, datagram)
        frames, malformed, unknown, older, _ = codec.split(datagram)
        runs = runs_of(datagram)
        if runs is None:
            assert malformed or unknown or older or not datagram
            broken += 1
            continue
        assert (malformed, unknown) == (0, 0)
        assert [frame for run in runs for frame in run] == frames
        whole += 1
    assert whole > 50 < broken


@pytest.mark.parametrize("seed", range(3))
def test_a_run_says_of_its_frames_what_they_say_one_by_one(seed: int) -> None:
    rng = random.Random(seed)
    for _ in range(200):
        raws = sent(rng, rng.randrange(1, 30))
        runs = runs_of(b"".join(raws))
        assert runs is not None
        assert [raw for run in runs for raw in raws_of(run)] == raws
        apart = [list(run) for _, run in groupby((frame_at(raw, 0) for raw in raws), lambda frame: frame.sysid)]
        assert runs == apart
        for run, frames in zip(runs, apart, strict=True):
            first, last = frames[0], frames[-1]
            assert (len(run), run[0], run[-1]) == (len(frames), first, last)
            assert (run.sender, run.first) == (first[:2], first.seq)
            steps = [(frame.seq - first.seq) % 256 for frame in frames]
            same = all(frame.compid == first.compid for frame in frames)
            assert run.in_step == (same and steps == [k % 256 for k in range(len(frames))])
            time_ms = codec.fields(last).time_boot_ms if codec.name(last.msgid) == "SYSTEM_TIME" else None
            assert run.time_ms == time_ms
            assert run.data[slice(*run.span)] == b"".join(frame.raw for frame in frames)


def test_ids_that_the_dialect_lacks_are_left_to_the_codec() -> None:
    rng = random.Random(1)
    (raw,) = sent(rng, 1)
    for low, high in ((0x7C, 1), (raw[7], 1), (0xFF, 0)):
        foreign = raw[:7] + bytes([low, raw[8], high]) + raw[10:]
        assert runs_of(foreign) is None
        assert runs_of(raw + foreign) is None


def test_datagrams_of_no_frame_or_of_too_many_bytes_are_left_to_the_codec() -> None:
    (raw,) = sent(random.Random(2), 1)
    assert runs_of(b"") is None
    assert runs_of(raw * (MOST_BYTES // len(raw))) is not None
    assert runs_of(raw * (MOST_BYTES // len(raw) + 1)) is None
    shortest = codec.encode("HEARTBEAT", 0, 1, 1, type=0, autopilot=0, base_mode=0, custom_mode=0, system_status=0,
                            mavlink_version=0)  # fmt: skip
    (run,) = runs_of(shortest * (MOST_BYTES // len(shortest))) or ()
    assert len(run) == MOST_BYTES // len(shortest)


@pytest.mark.parametrize("seed", range(3))
def test_a_tick_is_gathered_from_runs_as_from_frames(seed: int) -> None:
    """Datagrams as sent, cut, repeated, out of order or with another's frames in them."""
    rng = random.Random(seed)
    by_runs, by_frames = TickCollector(3, 1), TickCollector(3, 1)
    number, together = 2, 0
    for tick in range(1, 200):
        raws = [peer_frame("ATTITUDE", rng.randbytes(28), (number + k) % 256, 3, 1) for k in range(rng.randrange(9))]
        time = rng.randbytes(8) + (100 * tick).to_bytes(4, "little")
        raws.append(peer_frame("SYSTEM_TIME", time, (number + len(raws)) % 256, 3, 1))
        number += len(raws)
        cut = rng.randrange(len(raws) + 1) if rng.random() < 0.4 else 0
        datagrams = [part for part in (raws[:cut], raws[cut:]) if part]
        if rng.random() < 0.3:
            rng.shuffle(datagrams)
        if rng.random() < 0.2:
            datagrams[0].insert(0, peer_frame("ATTITUDE", rng.randbytes(28), raws[0][4], 3, 2))
        if rng.random() < 0.3:
            datagrams.insert(rng.randrange(len(datagrams) + 1), rng.choice(datagrams))
        by_runs.begin(100 * tick)
        by_frames.begin(100 * tick)
        for datagram in datagrams:
            (run,) = runs_of(b"".join(datagram)) or ()
            assert by_runs.feed(run) == by_frames.feed(list(run))
            assert by_runs.held == by_frames.held
        assert by_runs.complete
        told = by_runs.pop_frames()
        assert list(told) == by_frames.pop_frames()
        assert raws_of(told) == raws
        together += isinstance(told, FrameRun)
    assert 20 < together < 199


def test_losses_are_counted_in_runs_as_in_frames() -> None:
    rng = random.Random(3)
    by_runs, by_frames, number = GapCounter(), GapCounter(), 0
    for _ in range(3000):
        count = rng.randrange(1, 9)
        raws = [peer_frame("ATTITUDE", rng.randbytes(28), (number + k) % 256, 3, 1) for k in range(count)]
        number += count + rng.choice([0, 0, 0, 0, 1, 2, 40, -count, -count - 3])
        (run,) = runs_of(b"".join(raws)) or ()
        by_runs.feed_all(run)
        for frame in run:
            by_frames.feed(frame.sysid, frame.compid, frame.seq)
        assert by_runs.lost_of == by_frames.lost_of
    assert by_runs.lost > 100


def test_a_frame_as_another_component_sent_it() -> None:
    """Cut payloads and signed frames too, against pymavlink, whose writer then has that component."""
    for component in (0, 1, 190):
        sender, other = mav.MAVLink(None, 3, 77), mav.MAVLink(None, 3, component)
        sender.signing.sign_outgoing, sender.signing.secret_key = True, bytes(32)
        for message in (mav.MAVLink_heartbeat_message(2, 3, 81, 4, 4, 3), mav.MAVLink_ping_message(0, 0, 0, 0)):
            (frame,) = codec.split(bytes(message.pack(sender))).frames
            raw = bytes(message.pack(other))
            assert codec.sent_by(frame, component) == codec.split(raw).frames[0]
