"""Recordings whose stamps are wrong in every way that was seen: times are held against those at which frames came."""

from __future__ import annotations

import csv
import io
import math
import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from fastcrc.crc16 import mcrf4xx
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from pymavlink.dialects.v20 import common

from gcs.recording import session_folder, tables, tlog_reader
from gcs.recording.export import export
from gcs.recording.times.recorded_clock import NO_STAMP, judged
from gcs.recording.times.vehicle_clock import VehicleClock
from gcs.session.replay import Replay

Times = NDArray[np.int64]
SECOND_US = 1_000_000
EPOCH_US = 1_767_225_600 * SECOND_US
PERIOD_US = 100_000
FRAMES = 1200
YEAR_S, HOUR_S = 31_557_600, 3600


def came() -> Times:
    """When frames came: ten a second for two minutes, a silence of 65 s in the middle."""
    times_us = EPOCH_US + PERIOD_US * np.arange(FRAMES, dtype=np.int64)
    times_us[FRAMES // 2 :] += 65 * SECOND_US
    return times_us


def vehicle(times_us: Times) -> VehicleClock:
    """Two frames of three say the time since 30 s before the first."""
    rows = np.array([row for row in range(len(times_us)) if row % 3])
    return VehicleClock(rows, 1000 * ((times_us[rows] - EPOCH_US + 30 * SECOND_US) // 1000))


def shifted(rows: slice, by_s: float) -> Callable[[Times], Times]:
    def change(stamps_us: Times) -> Times:
        stamps_us[rows] += round(by_s * SECOND_US)
        return stamps_us

    return change


def interleaved(stamps_us: Times) -> Times:
    stamps_us[np.arange(FRAMES) % 5 > 2] -= 7 * HOUR_S * SECOND_US
    return stamps_us


def valued(rows: slice | int, value: int) -> Callable[[Times], Times]:
    def change(stamps_us: Times) -> Times:
        stamps_us[rows] = value
        return stamps_us

    return change


BROKEN = {
    "as they came": lambda stamps_us: stamps_us,
    **{f"set back by {s} s": shifted(slice(400, None), -s) for s in (1, 10, HOUR_S, YEAR_S)},
    **{f"set ahead by {s} s": shifted(slice(400, None), s) for s in (40, HOUR_S, YEAR_S, 3500 * YEAR_S)},
    "set ahead by a year, and back later": shifted(slice(400, 900), YEAR_S),
    "set back by an hour, and ahead later": shifted(slice(300, 500), -HOUR_S),
    "1970 until the first fix": shifted(slice(0, 200), -(EPOCH_US // SECOND_US)),
    "two clocks by turns": interleaved,
    "one stamp of zero at the start": valued(0, 0),
    "one stamp of zero in the middle": valued(700, 0),
    "one stamp of zero at the end": valued(FRAMES - 1, 0),
    "three far ahead at the end": valued(slice(FRAMES - 3, None), EPOCH_US + 3500 * YEAR_S * SECOND_US),
    "two far ahead in the middle": valued(slice(800, 802), EPOCH_US + 3500 * YEAR_S * SECOND_US),
    "one that is negative": valued(100, -(1 << 62)),
    "all zero": valued(slice(None), 0),
    "all the same": valued(slice(None), EPOCH_US),
    "none": valued(slice(None), NO_STAMP),
}


def off_us(times_us: Times) -> int:
    """How far times since the second frame are off, of frames that say the vehicle's time: others lie between."""
    off = (times_us - times_us[1]) - (came() - came()[1])
    return int(np.abs(off[np.arange(FRAMES) % 3 > 0]).max())


BELIEVED = {f"set ahead by {s} s" for s in (40, HOUR_S, YEAR_S)}


@pytest.mark.parametrize("broken", [name for name in BROKEN if name not in BELIEVED])
def test_without_a_vehicles_clock_times_do_not_fall_nor_leap(broken: str) -> None:
    """All but a leap that lasts, which nothing tells from a silence, if both sides of it are times of MAVLink's."""
    times_us, _ = judged(BROKEN[broken](came()), [])
    assert (np.diff(times_us) >= -PERIOD_US).all()
    assert times_us[-1] - times_us[0] <= came()[-1] - came()[0] + SECOND_US


def test_the_longest_part_keeps_its_stamps() -> None:
    true_us = came()
    assert judged(shifted(slice(0, 200), -YEAR_S)(came()), [vehicle(true_us)]).times_us[-1] == true_us[-1]


def test_a_vehicle_that_starts_anew_is_no_step() -> None:
    rows, boot_us = vehicle(came())
    anew = rows >= 500
    boot_us[anew] -= boot_us[anew][0] - SECOND_US
    assert (judged(came(), [VehicleClock(rows, boot_us)]).times_us == came()).all()


@given(
    steps=st.lists(st.tuples(st.integers(1, FRAMES - 1), st.integers(-YEAR_S, YEAR_S)), max_size=4),
    wrong=st.lists(st.tuples(st.integers(0, FRAMES - 1), st.integers(0, 1 << 62)), max_size=6),
)
@settings(max_examples=60, deadline=None)
def test_whatever_is_set_and_flipped_times_do_not_fall(
    steps: list[tuple[int, int]], wrong: list[tuple[int, int]]
) -> None:
    stamps_us = came()
    for row, by_s in steps:
        stamps_us[row:] += by_s * SECOND_US
    for row, stamp_us in wrong:
        stamps_us[row] = stamp_us
    times_us, _ = judged(stamps_us, [vehicle(came())])
    assert (np.diff(times_us) >= -PERIOD_US).all()


@given(row=st.integers(3, FRAMES - 3), by_s=st.integers(-YEAR_S, YEAR_S).filter(lambda by_s: not 0 <= by_s <= 11))
@settings(max_examples=60, deadline=None)
def test_a_step_anywhere_is_found(row: int, by_s: int) -> None:
    assert off_us(judged(shifted(slice(row, None), by_s)(came()), [vehicle(came())]).times_us) <= 3 * PERIOD_US


def recording(path: Path, stamps_us: Times, *, stamped: bool = True) -> None:
    """HEARTBEAT and twice ATTITUDE by turns, as pymavlink packs them."""
    sender = common.MAVLink(io.BytesIO(), 7, 1)
    out = []
    for row, (stamp_us, true_us) in enumerate(zip(stamps_us.tolist(), came().tolist(), strict=True)):
        boot_ms = (true_us - EPOCH_US) // 1000 + 30_000
        message = (
            common.MAVLink_attitude_message(boot_ms, 0.1, 0.2, 0.3, 0.0, 0.0, 0.0)
            if row % 3
            else common.MAVLink_heartbeat_message(2, 12, 0x81, 0, 4, 3)
        )
        out.append(struct.pack(">q", stamp_us) * stamped + bytes(message.pack(sender)))
        sender.seq = (sender.seq + 1) % 256
    path.write_bytes(b"".join(out))


@pytest.mark.parametrize("broken", [name for name in BROKEN if name not in ("none", "one that is negative")])
def test_a_file_is_read_by_them(tmp_path: Path, broken: str) -> None:
    path = tmp_path / "flight.tlog"
    recording(path, BROKEN[broken](came()))
    log = tlog_reader.Tlog(path, chunk_bytes=4096)
    times_us = np.array([t_us for t_us, _ in log])
    assert off_us(times_us) <= 3.0 * PERIOD_US
    assert (np.diff(times_us) >= -PERIOD_US).all()
    assert log.problems, "the silence at least is said"
    assert all(problem.startswith("flight.tlog: ") for problem in log.problems)
    again = tlog_reader.Tlog(path, chunk_bytes=1 << 20, times=log.times)
    assert [t_us for t_us, _ in again] == times_us.tolist()


@pytest.mark.parametrize("broken", ["as they came", "set back by 3600 s", "1970 until the first fix", "none"])
def test_replay_report_and_export_have_these_times(tmp_path: Path, broken: str) -> None:
    path = tmp_path / "flight.tlog"
    recording(path, BROKEN[broken](came()), stamped=broken != "none")
    log = tlog_reader.Tlog(path)
    times_us = np.array([t_us for t_us, frame in log if frame.msgid == common.MAVLINK_MSG_ID_ATTITUDE])
    replay = Replay(path)
    replay.advance(math.inf, math.inf)
    written = tables.tables("csv", tmp_path)
    problems = export(path, written)
    written.close()
    with (tmp_path / "ATTITUDE.csv").open(newline="") as file:
        exported_s = np.array([float(row["time_s"]) for row in csv.DictReader(file)])
    np.testing.assert_allclose(exported_s - exported_s[0], 1e-6 * (times_us - times_us[0]), atol=2e-6)
    true_s = 1e-6 * (came()[-1] - came()[0])
    for end_s in (replay.to_s, session_folder.read_recording(path, path).end_s, exported_s[-1]):
        assert end_s == pytest.approx(true_s, abs=0.5)
    assert problems == replay.problems == log.problems


@pytest.mark.parametrize("name", ["flight.tlog.raw", "flight.rlog", "flight.tlog"])
def test_a_file_without_stamps_has_the_vehicles_times(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    recording(path, came(), stamped=False)
    log = tlog_reader.read(path)
    times_us = np.array([t_us for t_us, _ in log])
    assert len(times_us) == FRAMES
    assert off_us(times_us) <= PERIOD_US
    assert log.problems == [f"{name}: its frames have no times: they have those of the vehicle's own clock."]


def test_frames_without_stamps_that_the_dialect_lacks_are_frames(tmp_path: Path) -> None:
    """Every fifth has an id that no dialect has, and a seed of its own."""
    path = tmp_path / "foreign.tlog.raw"
    recording(path, came(), stamped=False)
    known = [frame.raw for _, frame in tlog_reader.read(path)]
    body = bytes([3, 0, 0, 9, 7, 1, 0x61, 0xEA, 0]) + b"abc"
    foreign = b"\xfd" + body + mcrf4xx(body + b"\x07").to_bytes(2, "little")
    path.write_bytes(b"".join(raw + foreign * (row % 5 == 0) for row, raw in enumerate(known)))
    log = tlog_reader.read(path)
    assert [frame.raw for _, frame in log].count(foreign) == FRAMES // 5
    assert not any("belong to no" in problem for problem in log.problems)
