"""Tables against pymavlink's own reading of the same file, and read by pandas, pyarrow and DuckDB."""

from __future__ import annotations

import json
import math
import re
import struct
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from commands import gcs
from pyarrow.parquet import read_table
from pymavlink import mavutil
from pymavlink.dialects.v20 import ardupilotmega as mav
from sessions import fly, small

from gcs.mavlink import field_units
from gcs.recording import tables, tlog_reader
from gcs.recording.export import ExportError, export
from gcs.report import opened

EPOCH_US = 1_767_225_600_000_000


def record(t_us: int, message: Any, sysid: int = 1, compid: int = 1, *, mavlink1: bool = False) -> bytes:
    """A frame as pymavlink writes it to a log."""
    sender = mav.MAVLink(None, srcSystem=sysid, srcComponent=compid)
    return struct.pack(">Q", t_us) + bytes(message.pack(sender, force_mavlink1=mavlink1))


def exported(source: Path, folder: Path, form: tables.Format = "csv") -> list[str]:
    folder.mkdir()
    written = tables.tables(form, folder)
    try:
        return export(source, written)
    finally:
        written.close()


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recorded session with one refuelling."""
    return fly(small(), tmp_path_factory.mktemp("flown"), "--plain").folder


@pytest.fixture(scope="module")
def csv(session: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("exported") / "csv"
    assert exported(session, folder) == []
    return folder


@pytest.fixture(scope="module")
def parquet(session: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("exported") / "parquet"
    assert exported(session, folder, "parquet") == []
    return folder


def test_every_frame_that_pymavlink_reads_is_a_row(session: Path, csv: Path) -> None:
    counted: dict[str, int] = {}
    reader = mavutil.mavlogfile(str(session / "session.tlog"), robust_parsing=False)
    while (message := reader.recv_match()) is not None:
        counted[message.get_type()] = counted.get(message.get_type(), 0) + 1
    reader.close()
    rows = {path.stem: len(pd.read_csv(path)) for path in csv.glob("[A-Z]*.csv")}
    assert rows == counted


SCALED = {
    "LOCAL_POSITION_NED": {"x_ned_m": ("x", 1.0), "vz_ned_m_s": ("vz", 1.0), "time_boot_s": ("time_boot_ms", 1e-3)},
    "GLOBAL_POSITION_INT": {"lat_deg": ("lat", 1e-7), "relative_alt_m": ("relative_alt", 1e-3),
                            "vx_ned_m_s": ("vx", 1e-2), "hdg_rad": ("hdg", 1e-2 * math.pi / 180.0)},
    "BATTERY_STATUS": {"energy_consumed_j": ("energy_consumed", 100.0), "battery_remaining_percent":
                       ("battery_remaining", 1.0), "current_battery_a": ("current_battery", 1e-2)},
    "SYS_STATUS": {"voltage_battery_v": ("voltage_battery", 1e-3), "load_percent": ("load", 0.1)},
    "ATTITUDE": {"roll_rad": ("roll", 1.0), "yawspeed_body_rad_s": ("yawspeed", 1.0)},
}  # fmt: skip


@pytest.mark.parametrize("message", SCALED)
def test_values_are_those_that_pymavlink_reads_in_si(session: Path, csv: Path, parquet: Path, message: str) -> None:
    reader = mavutil.mavlogfile(str(session / "session.tlog"), robust_parsing=False)
    sent: list[Any] = []
    while (one := reader.recv_match(type=message)) is not None:
        sent.append(one)
    reader.close()
    for table in (pd.read_csv(csv / f"{message}.csv"), pd.read_parquet(parquet / f"{message}.parquet")):
        assert table.sysid.tolist() == [one.get_srcSystem() for one in sent]
        np.testing.assert_allclose(table.time_s, [one._timestamp - EPOCH_US / 1e6 for one in sent], atol=1e-6)
        for column, (field, factor) in SCALED[message].items():
            expected = [getattr(one, field) * factor for one in sent]
            np.testing.assert_allclose(table[column].astype(float), expected, rtol=1e-12, atol=1e-15)


def test_decimals_stay_the_decimals_that_were_meant(csv: Path) -> None:
    """mm and degE7 become the nearest number to the decimal: it prints with no more digits than were sent."""
    text = pd.read_csv(csv / "GLOBAL_POSITION_INT.csv", dtype=str)
    assert text.lat_deg.str.fullmatch(r"47\.\d{1,7}").all()
    assert text.alt_m.str.fullmatch(r"\d+\.\d{1,3}").all()
    times = pd.read_csv(csv / "ATTITUDE.csv", dtype=str).time_s
    assert times.str.fullmatch(r"\d+\.\d").all()


def test_what_is_sent_to_a_vehicle_is_told_from_what_came_from_one(csv: Path) -> None:
    """The giver's FOLLOW_TARGET is relayed with its own header: once from it, once to the receiver."""
    assert set(pd.read_csv(csv / "SET_POSITION_TARGET_LOCAL_NED.csv").direction) == {"to"}
    assert set(pd.read_csv(csv / "LOCAL_POSITION_NED.csv").direction) == {"from"}
    follow = pd.read_csv(csv / "FOLLOW_TARGET.csv")
    sent, heard = follow[follow.direction == "to"], follow[follow.direction == "from"]
    assert set(follow.sysid) == {201}
    assert len(sent) > 10
    assert len(sent) <= len(heard)
    assert set(sent.timestamp_s) <= set(heard.timestamp_s)
    beats = pd.read_csv(csv / "HEARTBEAT.csv")
    assert (beats.direction == "to").equals(beats.type == mav.MAV_TYPE_GCS)


def test_decisions_are_tables_of_their_own(session: Path, csv: Path) -> None:
    lines = [json.loads(line) for line in (session / "decisions.jsonl").read_text().splitlines()]
    points = [line for line in lines if line["kind"] == "set_point"]
    table = pd.read_csv(csv / "decisions_set_point.csv")
    assert table[["n_ned_m", "e_ned_m", "d_ned_m"]].to_numpy().tolist() == [line["p_ned"] for line in points]
    decided = next(line for line in lines if line["kind"] == "decided")
    bids = pd.read_csv(csv / "decisions_decided_by_vehicle.csv")
    assert dict(zip(bids.sysid.astype(str), bids.need, strict=True)) == decided["need"]
    served = pd.read_csv(csv / "decisions_served.csv")
    assert served.energy_j.tolist() == [line["energy_j"] for line in lines if line["kind"] == "served"]


def test_booleans_and_objects_of_decisions_are_such_in_the_tables(tmp_path: Path) -> None:
    """A boolean that only some decisions of a kind have is null in the others; an object that is no list of vehicles is
    a column of JSON."""
    ball = {"name": "bait", "sphere_m": [1.0, 2.0, -5.0], "radius_m": 0.5, "range_m": 4.0}
    moved = {"kind": "world", "change": "moved", "part": "attractor", "index": 0, "name": "bait", "now": ball}
    path = {"kind": "world", "change": "path", "sysid": 101, "path_m": [[0, 0, -2]], "closed": False}
    decisions = [
        {"t_s": 1.0, "kind": "safety", "sysid": 1, "braked": False},
        {"t_s": 2.0, "kind": "safety", "sysid": 1, "braked": True},
        {"t_s": 2.0, **moved},
        {"t_s": 3.0, **path},
    ]
    (tmp_path / "decisions.jsonl").write_text("".join(json.dumps(one) + "\n" for one in decisions))
    exported(tmp_path, tmp_path / "parquet", "parquet")
    exported(tmp_path, tmp_path / "csv")
    safety, world = (read_table(tmp_path / f"parquet/decisions_{name}.parquet") for name in ("safety", "world"))
    assert safety["braked"].to_pylist() == [False, True]
    assert world["closed"].to_pylist() == [None, False]
    assert [now and json.loads(now) for now in world["now"].to_pylist()] == [ball, ""]
    flight = opened.open(tmp_path)
    assert flight["decisions_safety"].braked.dtype == bool
    assert flight.table("decisions_world")["closed"] == [None, False]
    texts = (tmp_path / "csv/decisions_safety.csv").read_text().splitlines()
    assert [line.split(",")[2] for line in texts] == ["braked", "false", "true"]
    assert pd.read_csv(tmp_path / "csv/decisions_world.csv").closed.isna().tolist() == [True, False]


def test_truth_is_a_table_whose_last_row_is_the_summarys_ledger(session: Path, csv: Path) -> None:
    summary = json.loads((session / "summary.json").read_text())
    last = pd.read_csv(csv / "truth.csv").groupby("sysid").last()
    for vehicle in summary["vehicles"]:
        assert last.received_j[vehicle["sysid"]] == vehicle["energy"]["received_j"]
        assert last.given_j[vehicle["sysid"]] == vehicle["energy"]["given_j"]
    thrust = pd.read_csv(csv / "truth_thrust.csv")
    gaps = thrust[thrust.sysid == 1].time_s.diff().dropna()
    np.testing.assert_allclose(gaps, 0.004, atol=1e-8)


def test_every_unit_of_every_message_has_a_conversion() -> None:
    used = {unit for cls in mav.mavlink_map.values() for unit in cls.fieldunits_by_name.values()}
    assert used <= field_units.UNITS.keys()


def test_no_column_has_the_name_of_another() -> None:
    for msgid in mav.mavlink_map:
        shape = field_units.layout(msgid)
        assert shape is not None
        names = [*field_units.OWN, *(column.name for column in shape.columns)]
        assert len(set(names)) == len(names), shape.name
        assert all(re.fullmatch(r"[a-z0-9_]+", name) for name in names)


def foreign_log() -> bytes:
    """What another ground station might have kept: MAVLink 1, ArduPilot's own messages, an id of nobody."""
    beat = mav.MAVLink_heartbeat_message(2, 3, 81, 4, 4, 3)
    station = mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)
    status = mav.MAVLink_ekf_status_report_message(5, 0.5, 0.25, 0.125, 0.0, 1.0)
    battery = mav.MAVLink_battery_status_message(0, 0, 0, 32767, [11_800, *[65535] * 9], -1, -1, -1, -1)
    return b"".join(
        [
            record(EPOCH_US, beat, 7, mavlink1=True),
            record(EPOCH_US + 500_000, station, 255, 230),
            record(EPOCH_US + 1_000_000, status, 7),
            record(EPOCH_US + 1_500_000, battery, 7),
        ]
    )


def test_a_strangers_log_is_exported_with_mavlink_1_and_ardupilots_messages(tmp_path: Path) -> None:
    path = tmp_path / "flight.tlog"
    path.write_bytes(foreign_log())
    assert exported(path, tmp_path / "out") == []
    beats = pd.read_csv(tmp_path / "out" / "HEARTBEAT.csv")
    assert beats[["time_s", "sysid", "direction"]].to_numpy().tolist() == [[0.0, 7, "from"], [0.5, 255, "to"]]
    status = pd.read_csv(tmp_path / "out" / "EKF_STATUS_REPORT.csv").iloc[0]
    assert (status.time_s, status["flags"], status.velocity_variance) == (1.0, 5, 0.5)
    battery = pd.read_csv(tmp_path / "out" / "BATTERY_STATUS.csv").iloc[0]
    assert battery.voltages_0_v == 11.8
    assert battery[["voltages_1_v", "temperature_degc", "current_battery_a", "energy_consumed_j"]].isna().all()


def test_a_folder_without_its_log_gives_its_decisions_and_says_so(session: Path, tmp_path: Path) -> None:
    folder = tmp_path / "half"
    folder.mkdir()
    lines = (session / "decisions.jsonl").read_bytes()
    (folder / "decisions.jsonl").write_bytes(lines + b'{"t_s": 1.0, "ki')
    problems = exported(folder, tmp_path / "out")
    assert "no session.tlog" in problems[0]
    assert problems[1:] == ["decisions.jsonl: 1 line is no decision and was passed over."]
    assert len(pd.read_csv(tmp_path / "out" / "decisions_served.csv")) == 1


def test_a_session_killed_before_its_first_frame_is_exported_as_far_as_it_goes(session: Path, tmp_path: Path) -> None:
    folder = tmp_path / "killed"
    folder.mkdir()
    (folder / "scenario.yaml").symlink_to(session / "scenario.yaml")
    for name in ("session.tlog", "decisions.jsonl"):
        (folder / name).touch()
    assert "session.tlog is empty." in exported(folder, tmp_path / "out")
    assert list((tmp_path / "out").iterdir()) == []


def test_truth_that_should_be_there_is_said_to_be_missing(session: Path, tmp_path: Path) -> None:
    for name in ("scenario.yaml", "session.tlog"):
        (tmp_path / name).symlink_to(session / name)
    whole = sorted((session / "vehicles").glob("*.truth"))
    (tmp_path / "vehicles").mkdir()
    for truth in whole[1:]:
        (tmp_path / "vehicles" / truth.name).symlink_to(truth)
    problems = exported(tmp_path, tmp_path / "tables")
    assert [problem for problem in problems if "no truth" in problem] == [
        f"{tmp_path / 'vehicles'} has no truth of vehicle {whole[0].stem}: what they knew themselves is left out."
    ]


def test_what_is_no_recording_is_refused_in_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "words.txt").write_text("no flight at all")
    for source, word in ((tmp_path, "no session's folder"), (tmp_path / "words.txt", "no tlog"),
                         (tmp_path / "nowhere", "does not exist")):  # fmt: skip
        with pytest.raises(ExportError, match=word):
            export(source, tables.CsvTables(tmp_path))


def test_the_command_writes_a_folder_once(tmp_path: Path) -> None:
    (tmp_path / "flight.tlog").write_bytes(foreign_log())
    first = gcs("export", str(tmp_path / "flight.tlog"), "--format", "csv")
    assert (first.returncode, first.stderr) == (0, "")
    assert f"tables: {tmp_path / 'flight-csv'}" in first.stdout
    again = gcs("export", str(tmp_path / "flight.tlog"), "--format", "csv")
    assert again.returncode == 2
    assert "exists already" in again.stderr
    nothing = gcs("export", str(tmp_path), "--format", "csv")
    assert nothing.returncode == 2
    assert {path.name for path in tmp_path.iterdir()} == {"flight.tlog", "flight-csv"}


def test_without_pyarrow_one_sentence_says_which_extra_to_install(tmp_path: Path) -> None:
    """A module that cannot be found stands in for a package that is not installed."""
    (tmp_path / "flight.tlog").write_bytes(foreign_log())
    hide = "import sys, importlib.util as u; find = u.find_spec\n"
    hide += "u.find_spec = lambda name, *a: None if name == 'pyarrow' else find(name, *a)\n"
    code = f"{hide}from gcs.cli.main import main; main()"
    argv = [sys.executable, "-c", code, "export", str(tmp_path / "flight.tlog"), "--format", "parquet"]
    refused = subprocess.run(argv, capture_output=True, text=True, check=False)
    assert refused.returncode == 2
    assert "pip install '.[parquet]' in Skytender's checkout" in refused.stderr
    assert "Traceback" not in refused.stderr


def test_memory_does_not_grow_with_the_log(tmp_path: Path) -> None:
    """A log of four stretches needs at its height what one of a single stretch needs."""
    row = record(EPOCH_US, mav.MAVLink_attitude_message(1000, 0.1, 0.2, 0.3, 0.0, 0.0, 0.0))
    rows = tlog_reader.CHUNK_BYTES // len(row)
    few, many = tmp_path / "few.tlog", tmp_path / "many.tlog"
    for path, stretches in ((few, 1), (many, 4)):
        frames = np.tile(np.frombuffer(row, np.uint8), (stretches * rows, 1))
        stamps = EPOCH_US + 10_000 * np.arange(len(frames), dtype=np.uint64)
        frames[:, :8] = stamps.astype(">u8").view(np.uint8).reshape(-1, 8)
        path.write_bytes(frames.tobytes())
    probe = (
        "import resource, sys; from pathlib import Path; from gcs.recording import tables, export\n"
        "for source in map(Path, sys.argv[1:]):\n"
        "    out = source.with_suffix(''); out.mkdir(); t = tables.tables('parquet', out)\n"
        "    export.export(source, t); t.close()\n"
        "    print(t.rows['ATTITUDE'], resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)\n"
    )
    argv = [sys.executable, "-c", probe, str(few), str(many)]
    said = subprocess.run(argv, capture_output=True, text=True, check=True).stdout.splitlines()
    (rows, height), (more_rows, more_height) = (map(int, line.split()) for line in said)
    assert more_rows == 4 * rows
    assert more_height < 1.5 * height
