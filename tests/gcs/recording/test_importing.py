"""Autopilots' own logs, read as recordings: a flight in a circle, whose truth is its closed form."""

from __future__ import annotations

import contextlib
import csv
import gzip
import json
import math
import struct
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import autopilot_logs as logs
import numpy as np
import pymap3d
import pytest
from commands import gcs
from hypothesis import given, settings
from hypothesis import strategies as st

from gcs.mavlink import codec
from gcs.mavlink.autopilots import profile_of
from gcs.mavlink.statustext import chunk_of, recorded
from gcs.recording import tlog_reader
from gcs.recording.importing import ImportFailed, beside, opened, tlog_writer
from gcs.recording.importing.sample import Sample
from gcs.recording.tlog_walk import SYSID, T_US, Chunk

WRITERS: dict[str, tuple[Callable[[Path], None], int]] = {
    "flight.BIN": (logs.dataflash, 7),
    "flight.ulg": (logs.ulog, 9),
}


@pytest.fixture(params=WRITERS)
def log(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    path = tmp_path / request.param
    WRITERS[request.param][0](path)
    return path


def dataflash(folder: Path, **how: Any) -> Path:
    path = folder / "flight.BIN"
    logs.dataflash(path, **how)
    return path


def ulog(folder: Path, more: bytes = b"", **how: Any) -> Path:
    path = folder / "flight.ulg"
    logs.ulog(path, **how)
    path.write_bytes(path.read_bytes() + more)
    return path


def imported(path: Path) -> Chunk:
    """All that a log became."""
    with opened(path) as source:
        (chunk,) = tlog_reader.read(source.path).chunks()
    return chunk


def test_a_log_is_the_flight_that_was_flown(log: Path) -> None:
    with opened(log) as source:
        (chunk,) = tlog_reader.read(source.path).chunks()
    assert not source.path.exists(), "nothing is left behind"
    flown = list(logs.moments())
    assert set(chunk.heads[:, SYSID].tolist()) == {WRITERS[log.name][1]}
    place, attitude = chunk.table("LOCAL_POSITION_NED"), chunk.table("ATTITUDE")
    assert len(place) == len(attitude) == len(flown)
    for axes, truth in (
        (("x", "y", "z"), [at.p_ned for at in flown]),
        (("vx", "vy", "vz"), [at.v_ned for at in flown]),
    ):
        np.testing.assert_allclose(np.column_stack([place[axis] for axis in axes]), truth, atol=1e-5)
    yaw_off = np.array(
        [math.remainder(a - at.yaw_rad, 2.0 * math.pi) for a, at in zip(attitude["yaw"], flown, strict=True)]
    )
    assert np.abs(yaw_off).max() < math.radians(0.01)
    times_us = place["t_us"] - place["t_us"][0]
    np.testing.assert_allclose(times_us, [at.t_us - logs.START_US for at in flown], atol=1000)
    assert abs(int(place["t_us"][0]) - logs.UTC_US) < 1_000_000, "by the satellites' time"
    origin = chunk.table("GPS_GLOBAL_ORIGIN")[0]
    assert (origin["latitude"], origin["longitude"]) == (round(1e7 * logs.LAT_DEG), round(1e7 * logs.LON_DEG))
    assert origin["altitude"] == pytest.approx(1e3 * logs.ALT_M)
    battery = chunk.table("BATTERY_STATUS")[-1]
    assert battery["voltages"][0] == 16_000
    assert battery["current_battery"] == 2000
    assert (chunk.table("HEARTBEAT")["base_mode"][-10:] & 128).all()
    assert set(chunk.table("EXTENDED_SYS_STATE")["landed_state"][-10:].tolist()) == {2}
    assert (np.diff(chunk.heads[:, T_US]) >= 0).all()


@pytest.mark.parametrize(
    ("program", "mode", "role", "name"),
    [
        ("ArduPlane", 11, "plane", "RTL"), ("ArduSub", 19, "submarine", "MANUAL"),
        ("ArduRover", 4, "rover", "HOLD"), ("ArduCopter", 11, "copter", "DRIFT"),
    ],
)  # fmt: skip
def test_a_log_is_of_its_program_and_in_its_mode_from_its_first_row_on(
    tmp_path: Path, program: str, mode: int, role: str, name: str
) -> None:
    """The program's name and the mode come after the first rows, and a role is not taken twice."""
    path = dataflash(tmp_path, program=program, mode=mode)
    played = gcs("replay", str(path), "--json")
    snapshots = [line for line in map(json.loads, played.stdout.splitlines()) if line["type"] == "snapshot"]
    told = {(row["role"], row["mode_name"]) for line in snapshots for row in line["vehicles"]}
    assert told == {(role, name)}


@pytest.mark.parametrize(
    ("nav_state", "name"),
    [(0, "Manual"), (8, "Altitude Cruise"), (18, "Land"), (20, "Precision Landing"), (30, "External 8")],
)
def test_every_navigation_state_of_px4_is_a_mode(tmp_path: Path, nav_state: int, name: str) -> None:
    """The states of PX4's VehicleStatus.msg; DESCEND is shown as a landing, as PX4's own MAVLink shows it."""
    chunk = imported(ulog(tmp_path, nav_state=nav_state))
    assert {profile_of(12).mode_name(int(mode)) for mode in chunk.table("HEARTBEAT")["custom_mode"]} == {name}


def test_a_ulog_with_global_positions_alone_has_places(tmp_path: Path) -> None:
    """PX4/Hawkeye issue 52: such logs often begin in the air."""
    path = ulog(tmp_path, frame="global")
    places = imported(path).table("GLOBAL_POSITION_INT")
    assert len(places) == len(list(logs.moments()))
    assert set(places["alt"].tolist()) == {round(1e3 * (logs.ALT_M + logs.HEIGHT_M))}
    played = gcs("replay", str(path), "--json")
    last = json.loads(played.stdout.splitlines()[-1])["vehicles"][0]
    assert last["trouble"] == []
    at = places[-1]
    origin = [line["origin"] for line in map(json.loads, played.stdout.splitlines()) if line["type"] == "session"][-1]
    assert origin[2] == pytest.approx(logs.ALT_M + logs.HEIGHT_M, abs=0.01)
    there = pymap3d.geodetic2ned(1e-7 * at["lat"], 1e-7 * at["lon"], 1e-3 * at["alt"], *origin)
    assert last["p_ned"] == pytest.approx([float(axis) for axis in there], abs=0.01)


def test_a_ulogs_parameters_keep_their_values_and_types(tmp_path: Path) -> None:
    path, tables = tmp_path / "flight.ulg", tmp_path / "tables"
    logs.ulog(path)
    assert gcs("export", str(path), "--format", "csv", "--out", str(tables)).returncode == 0
    with (tables / "PARAM_VALUE.csv").open() as file:
        told = [(row["param_id"], row["param_value"], int(row["param_type"])) for row in csv.DictReader(file)]
    assert [(name, kind) for name, _, kind in told] == [
        ("MAV_SYS_ID", 6), ("COM_FLTMODE1", 6), ("MPC_XY_CRUISE", 9), ("COM_FLTMODE1", 6),
    ]  # fmt: skip
    assert [float(number) for _, number, _ in told] == pytest.approx([9.0, -1.0, 5.1, 4.0])


@pytest.mark.parametrize("events", [(15,), (28,), (10,)])
def test_what_only_an_armed_copter_does_arms_it(tmp_path: Path, events: tuple[int, ...]) -> None:
    """A log that begins as the vehicle is armed may lack the event: the public flight of akj127/drone_rover does."""
    chunk = imported(dataflash(tmp_path, events=events))
    assert (chunk.table("HEARTBEAT")["base_mode"][-10:] & 128).all()


def test_replay_export_and_report_take_a_log(log: Path, tmp_path: Path) -> None:
    sysid = WRITERS[log.name][1]
    played = gcs("replay", str(log), "--json")
    snapshots = [line for line in map(json.loads, played.stdout.splitlines()) if line["type"] == "snapshot"]
    (row,) = snapshots[-1]["vehicles"]
    assert (row["sysid"], row["armed"], row["landed"]) == (sysid, True, False)
    assert row["p_ned"] == pytest.approx(list(logs.moments())[-1].p_ned, abs=0.1)
    assert row["mode"] == "offboard"
    tables = tmp_path / "tables"
    assert gcs("export", str(log), "--format", "csv", "--out", str(tables)).returncode == 0
    with (tables / "LOCAL_POSITION_NED.csv").open() as file:
        assert [float(line["z_ned_m"]) for line in csv.DictReader(file)] == [-logs.HEIGHT_M] * len(list(logs.moments()))
    page = tmp_path / "page.html"
    assert gcs("report", str(log), "--out", str(page)).returncode == 0
    assert log.name in page.read_text(encoding="utf-8")


def test_several_recordings_are_played_beside_each_other_under_ids_of_their_own(tmp_path: Path) -> None:
    """Two of the same vehicle, and a third: 7 is taken, 8 is free, 9 is its own."""
    paths = [tmp_path / name for name in ("one.BIN", "two.BIN", "three.ulg")]
    logs.dataflash(paths[0])
    logs.dataflash(paths[1])
    logs.ulog(paths[2])
    played = gcs("replay", *map(str, paths), "--json")
    snapshots = [line for line in map(json.loads, played.stdout.splitlines()) if line["type"] == "snapshot"]
    rows = {row["sysid"]: row for row in snapshots[-1]["vehicles"]}
    assert sorted(rows) == [7, 8, 9]
    for row in rows.values():
        assert row["p_ned"] == pytest.approx(list(logs.moments())[-1].p_ned, abs=0.1)
    assert snapshots[-1]["t_s"] < logs.SECONDS + 2.0
    tables = tmp_path / "tables"
    assert gcs("export", *map(str, paths), "--format", "csv", "--out", str(tables)).returncode == 0
    with (tables / "LOCAL_POSITION_NED.csv").open() as file:
        assert Counter(row["sysid"] for row in csv.DictReader(file)) == dict.fromkeys("789", len(list(logs.moments())))


@pytest.mark.parametrize("days", [0.5, 3.0])
def test_recordings_of_other_days_begin_together(tmp_path: Path, days: float) -> None:
    paths = [tmp_path / "one.tlog", tmp_path / "two.tlog"]
    for path, since_us in zip(paths, (0, round(86_400e6 * days)), strict=True):
        beats = [
            codec.encode("HEARTBEAT", k, 1, 1, type=2, autopilot=12, base_mode=0, custom_mode=0, system_status=3)
            for k in range(20)
        ]
        stamps = [logs.UTC_US + since_us + 1_000_000 * k for k in range(20)]
        path.write_bytes(b"".join(at.to_bytes(8, "big") + beat for at, beat in zip(stamps, beats, strict=True)))
    with beside(paths) as source:
        times_us = [t_us - logs.UTC_US for t_us, _ in tlog_reader.read(source.path)]
    assert max(times_us) == 19_000_000 + (0 if days > 1.0 else round(86_400e6 * days))


@pytest.mark.parametrize(("content", "words"), [
    (gzip.compress(b"a", mtime=0), "is a gzip archive: unpack it first"),
    (b"PK\x03\x04....", "is a zip archive: unpack it first"),
    (b"version https://git-lfs.github.com/spec/v1\noid sha256:81", "is a pointer of Git LFS to a file"),
    (b"QGC WPL 110\n", "is a list of mission items, not a recording: `gcs mission"),
    (b'{"fileType": "Plan"}', "is a QGroundControl plan, not a recording: `gcs mission"),
    (b"# Onboard parameters for Vehicle 1\n", "is a file of parameters"),
    (b"FMT, 128, 89, FMT, BBnNZ\n", "is an ArduPilot log as text"),
    (b"\xa3\x95\x80\x81\x0bTIMEQ".ljust(25, b"\0") + b"StartTime".ljust(64, b"\0"), "is a PX4 log of before ULog"),
    (b"ULog\x01\x12\x35\x01" + bytes(200), "without a position, an attitude or a mode"),
])  # fmt: skip
def test_a_file_of_another_kind_is_said_to_be_that(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "some.tlog"
    path.write_bytes(content)
    with pytest.raises(ImportFailed, match=words), opened(path):
        pass
    for command in (("replay",), ("export", "--format", "csv"), ("report",)):
        refused = gcs(command[0], str(path), *command[1:])
        assert refused.returncode == 2
        assert words in " ".join(refused.stderr.split())


@pytest.mark.parametrize("name", WRITERS)
@given(data=st.data())
@settings(max_examples=10, deadline=None)
def test_a_broken_log_gives_what_it_holds_or_a_sentence(
    name: str, tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    path = tmp_path_factory.mktemp("broken") / name
    WRITERS[name][0](path)
    content = bytearray(path.read_bytes())
    for at in data.draw(st.lists(st.integers(8, len(content) - 1), max_size=20)):
        content[at] = data.draw(st.integers(0, 255))
    path.write_bytes(content[: data.draw(st.integers(8, len(content)))])
    with contextlib.suppress(ImportFailed), opened(path) as source:
        assert all(codec.name(frame.msgid) for _, frame in tlog_reader.read(source.path))


def test_without_pymavlink_the_extra_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    logs.dataflash(tmp_path / "flight.BIN")
    monkeypatch.setitem(sys.modules, "pymavlink", None)
    with pytest.raises(ImportFailed, match=r"pymavlink, which is not installed: pip install '\.\[dataflash\]'"):
        opened(tmp_path / "flight.BIN").__enter__()


def test_a_log_without_satellites_begins_with_its_first_row(tmp_path: Path) -> None:
    path = tmp_path / "indoors.BIN"
    logs.dataflash(path, satellites=False)
    chunk = imported(path)
    assert chunk.heads[0, T_US] == logs.START_US, "not with what tells of its format, which has no time"
    place = chunk.table("LOCAL_POSITION_NED")
    assert (1000 * place["time_boot_ms"].astype(np.int64) == [at.t_us for at in logs.moments()]).all()


def test_a_height_above_the_start_is_read_from_either_generation(tmp_path: Path) -> None:
    for name in (b"TimeUS,Lat,Lng,Alt,RelAlt\0\0\0\0", b"TimeUS,Lat,Lng,Alt,RelHomeAlt"):
        path = tmp_path / "flight.BIN"
        logs.dataflash(path)
        path.write_bytes(path.read_bytes().replace(b"TimeUS,Lat,Lng,Alt,RelAlt\0\0\0\0", name))
        chunk = imported(path)
        assert set(chunk.table("GLOBAL_POSITION_INT")["relative_alt"].tolist()) == {1000 * logs.HEIGHT_M}


def test_a_long_text_is_whole(log: Path) -> None:
    with opened(log) as source:
        frames = [one for one in tlog_reader.read(source.path) if codec.name(one[1].msgid) == "STATUSTEXT"]
    texts = [text for _, _, text in recorded((1e-6 * t_us, chunk_of(frame)) for t_us, frame in frames)]
    assert logs.LONG_TEXT in texts


def said(path: Path) -> list[str]:
    """Sentences of `gcs export`, without the log's name."""
    done = gcs("export", str(path), "--format", "csv", "--out", str(path.with_name("tables")))
    assert done.returncode == 0
    return [line.removeprefix(f"gcs: {path.name}: ") for line in done.stderr.splitlines()]


def test_bytes_between_rows_are_said(tmp_path: Path) -> None:
    path = dataflash(tmp_path)
    content = path.read_bytes()
    att = [at for at in range(len(content)) if content.startswith(b"\xa3\x95\xc9", at)]  # ATT
    for at in (att[40], att[20]):
        content = content[:at] + bytes(range(100)) + content[at:]
    path.write_bytes(content + b"\0" * 7)
    assert said(path) == [
        "it holds 200 bytes in 2 places that are no message; they were passed over.",
        "its last 7 bytes are no whole message.",
    ]


def test_messages_that_an_ardupilot_could_not_write_are_said(tmp_path: Path) -> None:
    """DSF's Dp counts those of the backend since its start."""
    path = dataflash(tmp_path)
    form = struct.pack("<4s16s64s", b"DSF", b"QI", b"TimeUS,Dp")
    rows = [
        b"\xa3\x95\x32" + struct.pack("<QI", logs.START_US + 1_000_000 * (logs.SECONDS + k), dropped)
        for k, dropped in enumerate((3, 3, 20))
    ]
    path.write_bytes(path.read_bytes() + b"\xa3\x95\x80" + struct.pack("<BB", 0x32, 15) + form + b"".join(rows))
    assert said(path) == ["the vehicle could not write 17 messages of its log."]


DROPOUTS = b"".join(struct.pack("<HBH", 2, ord("O"), duration_ms) for duration_ms in (40, 1500, 60))


@pytest.mark.parametrize(
    ("more", "sentence"),
    [
        (DROPOUTS, "the vehicle could not write its log 3 times, 1.6 s in all, the longest 1.5 s at 11.9 s."),
        (struct.pack("<HB", 5, 0) + b"\xff" * 40, "it holds bytes that are no ULog message; they were passed over."),
    ],
)
def test_what_a_ulog_lacks_is_said(tmp_path: Path, more: bytes, sentence: str) -> None:
    assert said(ulog(tmp_path, more)) == [sentence]


def test_what_a_log_lacks_is_said_by_replay_and_report_and_beside_another(tmp_path: Path) -> None:
    path, other = tmp_path / "flight.ulg", tmp_path / "other.ulg"
    for one in (path, other):
        logs.ulog(one)
    path.write_bytes(path.read_bytes() + struct.pack("<HBH", 2, ord("O"), 1500))
    sentence = "flight.ulg: the vehicle could not write its log for 1.5 s at 11.9 s."
    assert sentence in gcs("replay", str(path), "--json").stderr
    assert sentence in gcs("replay", str(other), str(path), "--json").stderr
    assert gcs("report", str(path)).returncode == 0
    assert sentence in path.with_name("flight.ulg.html").read_text()


@given(
    period_us=st.integers(2_500, 300_000), jitter_us=st.lists(st.integers(-2_000, 2_000), min_size=600, max_size=600)
)
@settings(max_examples=15, deadline=None)
def test_ten_samples_a_second_are_written_or_all_of_a_slower_log(
    tmp_path_factory: pytest.TempPathFactory, period_us: int, jitter_us: list[int]
) -> None:
    times_us = sorted(10_000_000 + k * period_us + jitter for k, jitter in enumerate(jitter_us))
    attitude = dict.fromkeys(("time_boot_ms", "roll", "pitch", "yaw", "rollspeed", "pitchspeed", "yawspeed"), 0)
    path = tmp_path_factory.mktemp("thinned") / "x.tlog"
    written = tlog_writer.write(path, (Sample(t_us, 1, "ATTITUDE", attitude) for t_us in times_us))
    most = 1 + (times_us[-1] - times_us[0]) / tlog_writer.PERIOD_US
    assert written == len(times_us) if period_us >= tlog_writer.PERIOD_US else 0.85 * most <= written <= 1 + most
