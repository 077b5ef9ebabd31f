"""Recordings, whole, cut and foreign; pymavlink is the oracle."""

from __future__ import annotations

import io
import struct
from pathlib import Path
from typing import Any

import pytest
from pymavlink import mavutil
from pymavlink.dialects.v20 import ardupilotmega, common

from gcs.mavlink import codec
from gcs.recording import tlog_reader

T0_US = 1_767_225_600_000_000
STEP_US = 100_000


def packed(dialect: Any, sysid: int, messages: list[Any]) -> list[bytes]:
    """Frames as pymavlink packs them."""
    sender = dialect.MAVLink(io.BytesIO(), sysid, 1)
    raws = []
    for message in messages:
        raws.append(bytes(message.pack(sender)))
        sender.seq = (sender.seq + 1) % 256
    return raws


def attitudes(count: int, dialect: Any = common, period_ms: int = STEP_US // 1000) -> list[Any]:
    return [dialect.MAVLink_attitude_message(period_ms * k, 0.1 * k, -0.2, 0.3, 0.0, 0.5, 0.0) for k in range(count)]


def timed(raws: list[bytes]) -> list[bytes]:
    return [struct.pack(">Q", T0_US + STEP_US * k) + raw for k, raw in enumerate(raws)]


@pytest.fixture
def mixed() -> list[bytes]:
    """Records of many kinds: a payload cut short, an array, a text, 1,000 in all."""
    messages: list[Any] = []
    for k, attitude in enumerate(attitudes(250, period_ms=4 * STEP_US // 1000)):
        messages += [
            attitude,
            common.MAVLink_heartbeat_message(2, 12, 0x81, k << 16, 4, 3),
            common.MAVLink_statustext_message(6, f"said {k}".encode()),
            common.MAVLink_battery_status_message(0, 0, 0, 0, [k] * 10, -1, -1, 17 * k, 80),
        ]
    return timed(packed(common, 7, messages))


def test_what_pymavlink_reads_is_what_is_read(mixed: list[bytes], tmp_path: Path) -> None:
    path = tmp_path / "session.tlog"
    path.write_bytes(b"".join(mixed))
    log = tlog_reader.read(path)
    ours = list(log)
    oracle = mavutil.mavlogfile(str(path), robust_parsing=False)
    for t_us, frame in ours:
        message = oracle.recv_msg()
        assert message.get_msgbuf() == frame.raw
        assert round(1e6 * message._timestamp) == t_us
        assert (message.get_srcSystem(), message.get_srcComponent(), message.get_seq()) == frame[:3]
        assert (message.get_msgId(), message.get_type()) == (frame.msgid, codec.name(frame.msgid))
    assert oracle.recv_msg() is None
    oracle.close()
    assert len(ours) == 1000
    assert log.problems == []


@pytest.mark.parametrize("chunk_bytes", [576, 601, 1000, 1 << 20])
def test_the_stretches_in_which_it_is_read_make_no_difference(
    mixed: list[bytes], tmp_path: Path, chunk_bytes: int
) -> None:
    path = tmp_path / "session.tlog"
    content = [*mixed[:300], b"\xfd\x03 rubbish with markers \xfe\xfd" * 40, *mixed[300:], mixed[0][:-5]]
    path.write_bytes(b"".join(content))
    whole, pieces = tlog_reader.read(path), tlog_reader.Tlog(path, chunk_bytes)
    assert list(pieces) == list(whole)
    assert len(list(whole)) == len(mixed)
    assert pieces.problems == whole.problems
    assert len(whole.problems) == 2


@pytest.mark.parametrize("cut", [1, 5, 12, 30])
def test_a_cut_end_costs_the_last_frame_only(mixed: list[bytes], tmp_path: Path, cut: int) -> None:
    path = tmp_path / "session.tlog"
    path.write_bytes(b"".join(mixed)[:-cut])
    log = tlog_reader.read(path)
    assert len(list(log)) == len(mixed) - 1
    assert log.problems == [
        f"session.tlog ends inside a frame: its last {len(mixed[-1]) - cut} bytes could not be read."
    ]


def test_a_damaged_frame_costs_that_frame_only(mixed: list[bytes], tmp_path: Path) -> None:
    damaged = bytearray(mixed[500])
    damaged[-4] ^= 0x55
    path = tmp_path / "session.tlog"
    path.write_bytes(b"".join([*mixed[:500], bytes(damaged), *mixed[501:]]))
    log = tlog_reader.read(path)
    read = list(log)
    assert [frame.raw for _, frame in read] == [record[8:] for record in [*mixed[:500], *mixed[501:]]]
    assert read[500][0] == T0_US + 501 * STEP_US
    assert log.problems == [
        f"session.tlog holds {len(damaged)} bytes in one place that belong to no MAVLink frame; they were passed over."
    ]


def test_signed_frames_and_foreign_dialects_are_handed_out_whole(tmp_path: Path) -> None:
    signer = common.MAVLink(io.BytesIO(), 9, 1)
    signer.signing.secret_key, signer.signing.sign_outgoing = b"k" * 32, True
    signed = [bytes(message.pack(signer)) for message in attitudes(3)]
    foreign = packed(ardupilotmega, 4, [ardupilotmega.MAVLink_ahrs_message(0.1, 0, 0, 0, 0, 0, 0)] * 3)
    raws = [*signed, *foreign, *signed]
    path = tmp_path / "foreign.tlog"
    path.write_bytes(b"".join(timed(raws)))
    log = tlog_reader.read(path)
    assert [frame.raw for _, frame in log] == raws
    assert log.problems == []


def test_a_frame_without_a_time_of_its_own_has_the_one_before(tmp_path: Path) -> None:
    raws = packed(common, 2, attitudes(5))
    path = tmp_path / "one-missing.tlog"
    records = timed(raws)
    path.write_bytes(records[0] + records[1] + raws[2] + records[3] + records[4])
    read = [(t_us - T0_US, frame.raw) for t_us, frame in tlog_reader.read(path)]
    assert read == list(zip((0, STEP_US, STEP_US, 3 * STEP_US, 4 * STEP_US), raws, strict=True))


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "x.tlog is empty."),
        (b"time,voltage\n" * 100_000, "x.tlog holds no MAVLink frame: it is no tlog."),
        (bytes(range(256)) * 400, "x.tlog holds no MAVLink frame: it is no tlog."),
    ],
)
def test_a_file_that_is_no_recording_is_called_so(content: bytes, said: str, tmp_path: Path) -> None:
    path = tmp_path / "x.tlog"
    path.write_bytes(content)
    log = tlog_reader.read(path)
    assert list(log) == []
    assert log.problems == [said]


def test_an_unknown_message_has_no_table(mixed: list[bytes], tmp_path: Path) -> None:
    path = tmp_path / "session.tlog"
    path.write_bytes(b"".join(mixed))
    (chunk,) = tlog_reader.read(path).chunks()
    with pytest.raises(ValueError, match="NOT_A_MESSAGE is no message"):
        chunk.table("NOT_A_MESSAGE")
