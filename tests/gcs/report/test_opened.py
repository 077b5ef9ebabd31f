"""`gcs.open`: tables against pymavlink's reading of the same file and the session's summary; figures."""

from __future__ import annotations

import json
import shutil
import struct
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from pymavlink import mavutil
from pymavlink.dialects.v20 import ardupilotmega as mav
from sessions import Outcome, fly, small

import gcs
from gcs.recording import rotation, tlog_reader

mpl.use("agg")
EPOCH_US = 1_767_225_600_000_000


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(small(), tmp_path_factory.mktemp("flown"), "--plain")


@pytest.fixture(scope="module")
def flight(flown: Outcome) -> gcs.Recording:
    return gcs.open(flown.folder)


def messages(path: Path) -> list[Any]:
    log = mavutil.mavlink_connection(str(path), dialect="ardupilotmega")
    found = []
    while (message := log.recv_match()) is not None:
        if message.get_type() != "BAD_DATA":
            found.append(message)
    log.close()
    return found


def test_every_message_is_a_row_of_its_table(flown: Outcome, flight: gcs.Recording) -> None:
    read = messages(flown.folder / "session.tlog")
    counts = Counter(message.get_type() for message in read)
    assert {name: len(flight[name]) for name in counts} == counts
    assert flight.problems == []
    rows = flight["LOCAL_POSITION_NED"]
    ours = [m for m in read if m.get_type() == "LOCAL_POSITION_NED"]
    assert rows.z_ned_m.tolist() == [m.z for m in ours]
    assert rows.sysid.tolist() == [m.get_srcSystem() for m in ours]
    assert set(rows.direction) <= {"from", "to"}


def test_energy_ends_where_the_session_said(flown: Outcome, flight: gcs.Recording) -> None:
    last = flight["energy"].groupby("sysid").last()
    for vehicle in flown.summary["vehicles"]:
        assert last.remaining_j[vehicle["sysid"]] == pytest.approx(vehicle["energy"]["remaining_j"], abs=1.0)
    assert set(last.capacity_j) == {24_000.0, 60_000.0, 150_000.0}


def test_energy_of_the_recording_alone_begins_with_the_charge_at_the_start(flown: Outcome) -> None:
    """The capacity comes in flight, behind the first reports of the battery."""
    energy = gcs.open(flown.folder / "session.tlog")["energy"]
    assert energy.groupby("sysid").remaining_j.first().to_dict() == {1: 0.4 * 24_000, 101: 60_000, 201: 150_000}
    assert (energy.groupby("sysid").remaining_j.min() > 0.0).all()


def test_services_are_the_sessions(flown: Outcome, flight: gcs.Recording) -> None:
    (row,) = flight["services"].to_dict("records")
    (reported,) = flown.summary["refuelling"]
    assert {key: row[key] for key in ("receiver", "tanker", "start_s", "end_s", "energy_j")} == {
        key: reported[key] for key in ("receiver", "tanker", "start_s", "end_s", "energy_j")
    }
    assert flight.summary is not None
    assert flight.summary.digest == flown.summary["digest"]


def test_of_a_folder_whose_first_parts_are_gone_the_rest_is_right(flown: Outcome, tmp_path: Path) -> None:
    """The recording begins after the only refuelling. Charges agree with the summary to the percent reported."""
    (served,) = flown.summary["refuelling"]
    folder = shutil.copytree(flown.folder, tmp_path / "kept")
    begin_s = served["end_s"] + 0.5
    frames = [
        struct.pack(">Q", t_us) + frame.raw
        for t_us, frame in tlog_reader.read(folder / "session.tlog")
        if t_us >= EPOCH_US + 1e6 * begin_s
    ]
    lines = (folder / "decisions.jsonl").read_bytes().splitlines(keepends=True)
    kept = {"session.tlog": frames, "decisions.jsonl": [x for x in lines if json.loads(x)["t_s"] >= begin_s]}
    for name, parts in kept.items():
        (folder / name).write_bytes(b"")
        rotation.part(folder / name, 2).write_bytes(b"".join(parts))
    opened = gcs.open(folder)
    energy = opened["energy"]
    assert energy.time_s.min() >= begin_s
    assert (energy.remaining_j <= energy.capacity_j).all()
    last = energy.groupby("sysid").last()
    for vehicle in flown.summary["vehicles"]:
        one = last.loc[vehicle["sysid"]]
        assert one.remaining_j == pytest.approx(vehicle["energy"]["remaining_j"], abs=1.0)
    (row,) = opened["services"].to_dict("records")
    assert (row["end_s"], row["reason"]) == (served["end_s"], "the reason is not recorded")
    findings = opened.findings
    (said,) = findings.recorded.problems
    begin = findings.recorded.begin_s
    assert said.startswith(f"session.tlog and decisions.jsonl begin at {begin:.1f} s, for the parts before")
    assert begin == pytest.approx(begin_s, abs=0.2)
    assert all(link.rate_hz.t_s[0] > begin_s and link.rate_hz.values[0] > 0.0 for link in findings.links.values())
    assert all(link.lost.t_s[0] > begin_s - 1.0 for link in findings.links.values())
    texts = [text for health in findings.watched.health.values() for _, one in health for text in one.texts]
    assert not [text for text in texts if text.startswith("no ")]  # of what is not recorded nothing is said
    of_summary = {vehicle["sysid"]: vehicle["max_tracking_error_m"] for vehicle in flown.summary["vehicles"]}
    assert findings.greatest_errors == {sysid: of_summary[sysid] for sysid in findings.errors}


def test_its_names_are_those_that_it_has(flight: gcs.Recording) -> None:
    names = list(flight)
    assert len(names) == len(set(names)) == len(flight)
    assert {"energy", "services", "truth", "decisions_set_point", "ATTITUDE"} <= set(names)
    for name in names:
        assert len({len(column) for column in flight.table(name).values()}) == 1, name
    with pytest.raises(KeyError, match="ALTITUDE: the tables are "):
        flight["ALTITUDE"]


def test_only_some_tables_are_kept(flown: Outcome, flight: gcs.Recording) -> None:
    few = gcs.open(flown.folder, only=["ATTITUDE"])
    assert sorted(few) == ["ATTITUDE", "energy", "services"]
    assert few["ATTITUDE"].equals(flight["ATTITUDE"])
    assert sorted(gcs.open(flown.folder, only=("energy",))) == ["energy", "services"]
    with pytest.raises(ValueError, match=r"^'ATTITUD' is no table here; the tables are .*; did you mean 'ATTITUDE'\?$"):
        gcs.open(flown.folder, only=["energy", "ATTITUD"])


def record(t_us: int, message: Any, sysid: int) -> bytes:
    return struct.pack(">Q", t_us) + bytes(message.pack(mav.MAVLink(None, srcSystem=sysid, srcComponent=1)))


def tlog(path: Path, sysid: int) -> Path:
    battery = mav.MAVLink_battery_status_message(
        0, 0, 0, 32767, [65535] * 10, -1, -1, -1, 50, 0, 0, [0] * 4, 0, 0
    )  # its current and temperature are not known
    path.write_bytes(record(EPOCH_US, battery, sysid) + record(EPOCH_US + 500_000, battery, sysid))
    return path


def test_what_mavlink_calls_unknown_is_nan(tmp_path: Path) -> None:
    rows = gcs.open(tlog(tmp_path / "one.tlog", 7))["BATTERY_STATUS"]
    assert rows.time_s.tolist() == [0.0, 0.5]
    assert rows.isna().any().sum() > 3
    assert all(np.asarray(column).dtype.kind in "fiuO" for column in rows.to_dict("series").values())


def test_recordings_are_read_side_by_side(tmp_path: Path) -> None:
    both = gcs.open(tlog(tmp_path / "one.tlog", 7), tlog(tmp_path / "two.tlog", 7))
    assert set(both["BATTERY_STATUS"].sysid) == {7, 8}


@pytest.mark.parametrize(
    ("content", "why"), [(None, "does not exist"), (b"no recording at all", "holds no MAVLink frame|is no")]
)
def test_what_is_no_recording_is_refused_in_a_sentence(tmp_path: Path, content: bytes | None, why: str) -> None:
    path = tmp_path / "flight.tlog"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(gcs.RecordingError, match=why):
        gcs.open(path)


def test_figures_have_the_tables_values(flight: gcs.Recording) -> None:
    assert {"paths", "motion", "battery", "nearness", "link"} <= set(flight.figures)
    (axes,) = flight.plot("battery", sysid=1)
    (line,) = (one for one in axes.get_lines() if one.get_label() == "1")
    energy = flight["energy"]
    own = energy[energy.sysid == 1]
    assert np.asarray(line.get_xdata()).tolist() == own.time_s.tolist()
    assert np.asarray(line.get_ydata()) == pytest.approx(100.0 * own.remaining_j / own.capacity_j)
    assert len(flight.plot("attitude")) == 3
    (above,) = flight.plot()
    assert [one.get_label() for one in above.get_lines()] == ["1", "101", "201"]


def test_without_all_set_points_the_tracking_error_is_no_figure_and_that_is_said(tmp_path: Path) -> None:
    """By set points to 5 cm no errors of 3 cm are known."""
    short = {"goal": {"duration_s": 6.0}, "record": {"decisions": "changes"}}
    flight = gcs.open(fly(small(**short), tmp_path, "--plain").folder)
    said = "decisions.jsonl holds set points only where they change, to 5 cm (record: decisions: changes): "
    assert flight.problems == [said + "the tracking error cannot be shown."]
    assert "error" not in flight.figures
    assert "motion" in flight.figures
    assert flight.findings.recorded.problems == flight.problems


def test_a_figure_or_vehicle_that_is_not_there_is_named(flight: gcs.Recording) -> None:
    with pytest.raises(ValueError, match="'altitude' is no figure; the figures are paths, "):
        flight.plot("altitude")
    with pytest.raises(ValueError, match="9 is no vehicle here; the vehicles are 1, 101, 201"):
        flight.plot("battery", sysid=[1, 9])


def test_without_the_extras_they_are_named(flight: gcs.Recording, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(gcs.MissingExtra, match=r"pip install '\.\[pandas\]'"):
        flight["ATTITUDE"]


def test_a_notebook_is_shown_the_page_in_a_frame_of_its_own(flight: gcs.Recording) -> None:
    shown = flight._repr_html_()
    assert shown.startswith('<iframe sandbox="allow-scripts allow-downloads" srcdoc="&lt;!doctype html&gt;')
    assert "allow-same-origin" not in shown
    assert repr(flight) == f"<Recording of {flight._paths[0].name}, {len(flight)} tables>"
