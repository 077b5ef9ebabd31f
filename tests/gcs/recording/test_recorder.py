"""What is recorded is read back by pymavlink; a full disk ends in one sentence; the digest sees what it should."""

import hashlib
import json
import math
import resource
import signal
import struct
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gcs.frame_spans import FrameSpans
from gcs.mavlink import codec
from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.recording.decision_lines import TickSetPoints, decision_lines, each
from gcs.recording.digest import Digest
from gcs.recording.recorder import BATCH_BYTES, DECISIONS, TLOG, Recorder, RecorderError

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # mavutil's own imports warn
    from pymavlink import mavutil

EPOCH_US = 1_700_000_000_000_000


def attitude(seq: int, sysid: int = 1, compid: int = 1, roll: float = 0.5) -> bytes:
    values = dict.fromkeys(("pitch", "yaw", "rollspeed", "pitchspeed", "yawspeed"), 0.25)
    return codec.encode("ATTITUDE", seq % 256, sysid, compid, time_boot_ms=seq, roll=roll, **values)


def test_pymavlink_reads_back_every_frame_and_its_time(tmp_path: Path) -> None:
    raws = [attitude(i, sysid=1 + i % 3) for i in range(20_000)]
    with Recorder(tmp_path) as recorder:
        for i, raw in enumerate(raws):
            recorder.frames(EPOCH_US + 1000 * i, [raw])
    assert sum(len(raw) + 8 for raw in raws) > 2 * BATCH_BYTES
    log = mavutil.mavlink_connection(str(tmp_path / TLOG), dialect="common")
    for i, raw in enumerate(raws):
        message = log.recv_msg()
        assert bytes(message.get_msgbuf()) == raw
        assert message._timestamp == pytest.approx((EPOCH_US + 1000 * i) * 1e-6, abs=2e-6)
    assert log.recv_msg() is None
    log.close()


def test_a_session_that_ends_has_recorded_the_answers_to_its_last_grant(scripted: Any) -> None:
    session = scripted()
    session.fly(3)
    session.supervisor.finish(lambda: None)
    log = mavutil.mavlink_connection(str(session.folder / TLOG), dialect="common")
    recorded = []
    while (message := log.recv_msg()) is not None:
        recorded.append((message._timestamp, bytes(message.get_msgbuf())))
    log.close()
    answers = {frame.raw for frame in session.link.answered[-1]}
    end_s = 1e-6 * session.supervisor.epoch_us + session.supervisor.time_s
    assert answers
    assert {raw for t_s, raw in recorded if t_s == pytest.approx(end_s, abs=1e-5) and raw in answers} == answers
    assert recorded[-1][1] in answers


def test_frames_side_by_side_are_recorded_and_counted_as_frames_apart(tmp_path: Path) -> None:
    raws = [attitude(k, sysid=k % 5 + 1) for k in range(40)]
    gaps, ends = b"?" + b"?".join(raws), np.cumsum([len(raw) + 1 for raw in raws])
    apart = FrameSpans(gaps, np.array([(end - len(raw), end) for raw, end in zip(raws, ends, strict=True)]))
    assert list(apart) == raws
    for name, frames in (("apart", raws), ("side by side", apart)):
        (tmp_path / name).mkdir()
        with Recorder(tmp_path / name) as recorder:
            recorder.frames(EPOCH_US, frames[:4], frames[4:])
            recorder.frames(EPOCH_US, frames[:0])
    recorded = {(tmp_path / name / TLOG).read_bytes() for name in ("apart", "side by side")}
    assert recorded == {b"".join(struct.pack(">Q", EPOCH_US) + raw for raw in raws)}
    assert digest_of((100, raws, [])) == digest_of((100, list(apart), [])) == digest_of((100, apart, []))


def test_decisions_are_one_sorted_json_line_each(tmp_path: Path) -> None:
    decisions = [{"t_s": 0.1, "kind": "win", "bids": {"3": 0.5}}, {"kind": "läuft\n"}]
    with Recorder(tmp_path) as recorder:
        recorder.decisions(decisions)
    lines = (tmp_path / DECISIONS).read_text().splitlines()
    assert [json.loads(line) for line in lines] == decisions
    assert list(json.loads(lines[0])) == ["bids", "kind", "t_s"]


@pytest.mark.parametrize("bad", [math.nan, math.inf, {"deep": [math.nan]}])
def test_decision_with_no_number_is_refused_and_leaves_no_trace(tmp_path: Path, bad: object) -> None:
    with Recorder(tmp_path) as recorder:
        with pytest.raises(ValueError, match="JSON compliant"):
            recorder.decisions([{"value": bad}])
        recorder.decisions([{"value": 1}])
    assert (tmp_path / DECISIONS).read_text() == '{"value":1}\n'


def json_line(decision: Mapping[str, Any]) -> bytes:
    return json.dumps(decision, sort_keys=True, separators=(",", ":")).encode() + b"\n"


def set_point(t_s: Any, sysid: Any, p_ned: Any, v_ned: Any) -> dict[str, Any]:
    return {"t_s": t_s, "kind": "set_point", "sysid": sysid, "p_ned": p_ned, "v_ned": v_ned}


def test_lines_of_a_tick_are_those_that_json_makes_one_by_one() -> None:
    """Set points among others, numbers of every size, and things that are no numbers."""
    random = np.random.default_rng(5)
    sizes = 10.0 ** random.integers(-9, 20, (4000, 6))
    values = (random.normal(size=(4000, 6)) * sizes * (random.random((4000, 6)) < 0.9)).tolist()
    points: list[Any] = [SetPoint(k % 254 + 1, tuple(row[:3]), tuple(row[3:])) for k, row in enumerate(values)]
    plain = points[:4000]
    odd = (True, (0.0,) * 3), (None, (0.0,) * 3), (7, ("-", ",", "ä")), (7, ([1.5], {}, 1)), (7, (1.0, 2.0))
    odd += (7, (3, -0.0, 5e-324)), (7, (np.float64(2.5), 1.7e308, 1e-7))
    points += [SetPoint(sysid, p_ned, (0.0, 0.0, 0.0)) for sysid, p_ned in odd]
    for t_s in (True, 0, 1e300):
        assert decision_lines([TickSetPoints(t_s, plain[:2])]) == [json_line(set_point(t_s, *one)) for one in plain[:2]]
    expected = [json_line(set_point(0.3, *point)) for point in points]
    assert decision_lines([TickSetPoints(0.3, points)]) == expected
    for k in range(0, 4000, 50):  # as many as a tick has: those with an odd one among them go another way
        tick = TickSetPoints(0.3, points[k : k + 50])
        other = {"kind": "win", "t_s": 1e-7}
        assert decision_lines([other, tick, {}]) == [json_line(other), *expected[k : k + 50], b"{}\n"]
        assert [json_line(one) for one in each([tick])] == expected[k : k + 50]
    assert decision_lines([TickSetPoints(0.3, SetPoints.of(plain))]) == expected[:4000]
    assert decision_lines([TickSetPoints(0.3, [])]) == decision_lines([TickSetPoints(0.3, SetPoints.of([]))]) == []


def test_numbers_of_every_size_at_every_place_are_written_as_json_writes_them() -> None:
    random = np.random.default_rng(6)
    shortest = [float(f"{digit}e{exponent}") for exponent in range(-12, 20) for digit in range(1, 10)]
    any_bits = random.integers(0, 2**64, 2000, np.uint64).view(np.float64)
    sizes = [0.0, 5e-324, *shortest, *any_bits[np.isfinite(any_bits)].tolist()]
    for number in [one for size in sizes for one in (size, -size)]:
        places = [tuple(number if k == place else 1.0 for k in range(6)) for place in range(6)]
        points = [SetPoint(place + 1, one[:3], one[3:]) for place, one in enumerate(places)]
        expected = [json_line(set_point(0.3, *point)) for point in points]
        assert decision_lines([TickSetPoints(0.3, SetPoints.of(points))]) == expected, number


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_a_set_point_without_a_number_is_refused(bad: float) -> None:
    with pytest.raises(ValueError, match="JSON"):
        decision_lines([TickSetPoints(0.1, [SetPoint(7, (bad, 0.0, 0.0), (0.0, 0.0, 0.0))])])
    with pytest.raises(ValueError, match="JSON"):
        decision_lines([TickSetPoints(bad, [SetPoint(7, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))])])


def test_existing_recording_is_never_overwritten(tmp_path: Path) -> None:
    (tmp_path / DECISIONS).write_text("precious")
    with pytest.raises(RecorderError, match=r"decisions\.jsonl cannot be created: file exists"):
        Recorder(tmp_path)
    assert (tmp_path / DECISIONS).read_text() == "precious"


def test_recording_after_close_is_refused(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path)
    recorder.close()
    recorder.close()
    with pytest.raises(RecorderError, match=r"session\.tlog is closed"):
        recorder.frames(EPOCH_US, [attitude(1)])
    assert (tmp_path / TLOG).stat().st_size == 0


@contextmanager
def largest_file(size: int) -> Iterator[None]:
    """Let no file of this process grow beyond `size` bytes: the system's own refusal, as of a full disk."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        signal.signal(signal.SIGXFSZ, handler)


def record_frames(recorder: Recorder, count: int) -> None:
    for i in range(count):
        recorder.frames(EPOCH_US + i, [attitude(i)])


def test_refused_write_ends_the_recording_in_a_sentence_with_whole_records_and_closed_files(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path)
    record = 8 + len(attitude(0))
    limit = BATCH_BYTES + BATCH_BYTES // 2
    recorder.decisions([{"kept": True}])
    sentence = r"session\.tlog cannot be written: file too large; recording has ended\.$"
    with largest_file(limit), pytest.raises(RecorderError, match=sentence):
        record_frames(recorder, 3 * BATCH_BYTES // record)
    size = (tmp_path / TLOG).stat().st_size
    assert size % record == 0
    assert BATCH_BYTES <= size <= limit
    assert (tmp_path / DECISIONS).read_text() == '{"kept":true}\n'
    open_files = [link.readlink() for link in Path("/proc/self/fd").iterdir() if link.is_symlink() and link.exists()]
    assert not [path for path in open_files if path.parent == tmp_path]
    with pytest.raises(RecorderError, match="file too large"):
        recorder.frames(0, [attitude(0)])
    with pytest.raises(RecorderError, match="file too large"):
        recorder.decisions([{}])
    recorder.close()


def test_refused_last_write_is_told_by_close(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path)
    recorder.decisions([{"long": "x" * 1000}])
    with largest_file(500), pytest.raises(RecorderError, match=r"decisions\.jsonl cannot be written"):
        recorder.close()
    assert (tmp_path / DECISIONS).read_text() == ""


def digest_of(
    *ticks: tuple[int, Sequence[bytes], Sequence[bytes]], decisions: tuple[dict[str, float], ...] = ()
) -> str:
    digest = Digest()
    for t_ms, came, went in ticks:
        digest.tick(t_ms, came, went, ())
    digest.tick(100, (), (), decision_lines(decisions))
    return digest.hexdigest()


def test_digest_is_the_hash_of_what_the_protocol_says() -> None:
    """docs/protocol/folder.md#digest, in its words."""
    random = np.random.default_rng(3)
    came = [attitude(k, sysid=k % 5 + 1, roll=float(random.normal())) for k in range(300)]
    came.append(codec.encode("SYSTEM_TIME", 7, 1, 1, time_unix_usec=0, time_boot_ms=0))  # its payload is one byte
    signed = bytes(attitude(1)[:2] + b"\x01" + attitude(1)[3:] + random.bytes(13))
    went, lines = [signed, attitude(9, roll=-0.5), signed], [b'{"a":1}\n', b'{"b":2}\n']
    digest, expected = Digest(), hashlib.sha256()
    digest.tick(12_300, came, went, lines)
    for direction, frames in ((0, came), (1, went)):
        for raw in frames:
            frame = codec.split(raw).frames[0] if raw != signed else codec.split(attitude(1)).frames[0]
            header = struct.pack("<QBBBB", 12_300, direction, len(frame.payload), frame.sysid, frame.compid)
            expected.update(header + frame.msgid.to_bytes(3, "little") + frame.payload)
    for line in lines:
        expected.update(struct.pack("<QBI", 12_300, 2, len(line)) + line)
    assert digest.hexdigest() == f"sha256:{expected.hexdigest()}"


def test_digest_of_nothing_is_sha256s() -> None:
    # FIPS 180-4: the hash of the empty message.
    assert Digest().hexdigest() == "sha256:e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"


def test_digest_does_not_see_sequence_numbers_batches_or_key_order() -> None:
    frames = [attitude(1), attitude(2)]
    renumbered = [raw[:4] + b"\x63" + raw[5:] for raw in frames]
    assert digest_of((100, frames, [])) == digest_of((100, renumbered, []))
    assert digest_of((100, frames, [])) == digest_of((100, frames[:1], []), (100, frames[1:], []))
    assert digest_of(decisions=({"a": 1.0, "b": 2.0},)) == digest_of(decisions=({"b": 2.0, "a": 1.0},))
