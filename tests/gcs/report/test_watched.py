"""A report's link events and health equal a replay's of the same recording."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from sessions import fly, small

from gcs.mavlink import codec
from gcs.recording.session_folder import read, read_recording
from gcs.report import flight
from gcs.report.findings import Findings
from gcs.report.pack import Pack
from gcs.report.watched import KINDS, Watched
from gcs.session.replay import Replay

EPOCH_US = 1_790_000_000_000_000
BEAT = {"type": 2, "autopilot": 12, "base_mode": 0x81, "custom_mode": 6 << 16, "system_status": 4}
PLACE = {"x": 1.0, "y": 0.0, "z": -3.0, "vx": 0.0, "vy": 0.0, "vz": 0.0}


def replayed(source: Path) -> tuple[list[tuple[float, int, str]], dict[int, list[dict[str, Any]]]]:
    """Events of the report's kinds, and each vehicle's rows, from a replay that is looked at twice a second."""
    replay, events, rows = Replay(source), [], dict[int, list[dict[str, Any]]]()
    for half in range(1, round(2.0 * replay.to_s) + 1):
        replay.advance(half / 2, math.inf)
        snapshot = replay.snapshot(speed=None)
        events += [(e["t_s"], e["sysid"], e["text"]) for e in snapshot["events"] if e["kind"] in KINDS]
        for row in snapshot["vehicles"]:
            rows.setdefault(row["sysid"], []).append({"t_s": half / 2, **row})
    return events, rows


def without_loss(texts: Any) -> list[str]:
    """A report counts packets by whole seconds."""
    return [text for text in texts if "packet loss" not in text]


@pytest.mark.parametrize(
    "radio",
    [
        {"ground_blackouts": [{"from_s": 9.0, "to_s": 20.0}]},
        {
            "loss": 0.4,
            "blackouts": [{"sysid": 1, "from_s": 12.0, "to_s": 16.0}, {"sysid": 201, "from_s": 14, "to_s": 26}],
        },
    ],
    ids=["blind until the end", "some of some"],
)
def test_a_report_has_the_silences_and_troubles_of_a_replay(radio: dict[str, Any], tmp_path: Path) -> None:
    folder = fly(small(radio=radio, goal={"duration_s": 20.0}), tmp_path, "--no-report").folder
    watched = Watched(read(folder))
    events, rows = replayed(folder)
    assert [(event.t_s, event.sysid, event.text) for event in watched.events] == events
    assert any("No telemetry for" in text for _, _, text in events)
    assert watched.health.keys() == rows.keys()
    for sysid, seen in watched.health.items():
        for row in rows[sysid]:
            health = next(found for t_s, found in reversed(seen) if t_s <= row["t_s"] + 1e-6)
            assert without_loss(health.texts) == without_loss(row["trouble"]), (sysid, row["t_s"])
            assert (health.condition == "silent") == (row["condition"] == "silent"), (sysid, row["t_s"])
    last = {sysid: seen[-1][1].condition for sysid, seen in watched.health.items()}
    assert last[201] == "silent"


def test_a_report_carries_them_to_its_page_and_names_them_among_what_went_wrong(tmp_path: Path) -> None:
    radio = {"ground_blackouts": [{"from_s": 9.0, "to_s": 20.0}]}
    found = Findings(read(fly(small(radio=radio, goal={"duration_s": 20.0}), tmp_path, "--no-report").folder))
    carried = flight.flight(found, Pack(0.0, found.end_s))
    assert carried is not None
    silent = [
        (event["sysid"], event["level"], event["kind"]) for event in carried["events"] if "No telem" in event["text"]
    ]
    assert silent == [(sysid, "warning", "link") for sysid in (1, 101, 201)]
    for sysid in ("1", "101", "201"):
        row = carried["health"]["rows"][carried["health"]["of"][sysid][-1][1]]
        assert (row["condition"], row["severity"]) == ("silent", 2)
        assert row["trouble"][0].startswith("no ")
    said = [problem.text for problem in found.problems if problem.text.startswith("No telemetry")]
    assert said == ["No telemetry of 1, 101, 201 for more than 1.5 s (3 times, first at 10.5 s)."]


@pytest.mark.parametrize("vehicles", [2, 30])
def test_of_many_vehicles_fewer_frames_are_kept_and_silences_are_found_all_the_same(
    vehicles: int, tmp_path: Path
) -> None:
    """Places ten times a second; one vehicle silent for 4 s, but for SYSTEM_TIME."""
    frames, sent = bytearray(), dict.fromkeys(range(1, vehicles + 1), 0)
    for tick in range(300):
        for sysid in range(1, vehicles + 1):
            silent = sysid == 2 and 100 < tick < 140
            contents = [] if silent else [("LOCAL_POSITION_NED", {**PLACE, "time_boot_ms": 100 * tick})]
            contents += [] if silent or tick % 10 else [("HEARTBEAT", BEAT)]
            contents += [("SYSTEM_TIME", {"time_unix_usec": 0, "time_boot_ms": 100 * tick})]
            for name, fields in contents:
                stamp = (EPOCH_US + 100_000 * tick).to_bytes(8, "big")
                frames += stamp + codec.encode(name, sent[sysid] % 256, sysid, 1, **fields)
                sent[sysid] += 1
    (tmp_path / "many.tlog").write_bytes(frames)
    recorded = read_recording(tmp_path / "many.tlog", tmp_path / "many.tlog")
    kept = sum(len(chunk.heads) for chunk in recorded.health_frames) / vehicles
    assert kept < (300 if vehicles > 16 else 450)
    silences = [(event.sysid, event.text) for event in Watched(recorded).events if "telemetry" in event.text]
    again = [event.sysid for event in Watched(recorded).events if event.text == "Heard again"]
    assert ([sysid for sysid, _ in silences], again) == ([2], [2])
