"""One session told four times: live, by its summary, by its replay and by its report. They say the same."""

from __future__ import annotations

import bisect
import json
import os
import signal
import time
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from ports import free_port
from sessions import Outcome, Running, small
from strangers import ARDUCOPTER, strangers

from gcs.recording.session_folder import read
from gcs.report.findings import Findings
from gcs.session.replay import Replay

STRANGER, PERIOD_S = 3, 0.1
LATE_S = 0.7
"""For so long the supervisor is stopped while the stranger takes off."""
TEXT = "Battery 1 is low and the pilot is told so at such length that it needs a third chunk, which ends here and now"


@dataclass
class Told:
    """What each of the four says."""

    outcome: Outcome
    live: list[dict[str, Any]]
    replay: list[dict[str, Any]]
    sought: dict[str, Any]
    report: Findings

    @property
    def snapshots(self) -> tuple[dict[str, Any], ...]:
        """The last of the session, of its replay from begin to end, and of a replay that went to the end at once."""
        return self.live[-1], self.replay[-1], self.sought


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> Told:
    """A stranger's ArduCopter that tells voltage and current, a text in three chunks, and loses frames; beside it a
    pursuer, its target and a tanker of ours. The supervisor is stopped for a while, so that one of its ticks comes
    late."""
    folder = tmp_path_factory.mktemp("truth")
    port = free_port()
    content = small(
        clock={"mode": "real", "speed": 1.0},
        goal={"duration_s": 35.0, "refuelled_at_least": 1, "pursue": {"within_m": 4.0, "for_s": 2.0}},
    )
    external = {"sysid": STRANGER, "connect": f"udpin:127.0.0.1:{port}", "capacity_j": 252_000}
    content["vehicles"]["pursuers"].append({"external": external})
    command = [*ARDUCOPTER, "--sysid", str(STRANGER), "--connect", f"udpout:127.0.0.1:{port}", "--lose", "0.05"]
    place = ["--origin", "47.397742,8.545594,488.0", "--start", "2.0,4.0,0.0", "--battery-told", "current"]
    with strangers(folder, [*command, *place, "--says", TEXT]):
        running, stopped = Running(content, folder, "--json"), False
        try:
            live = []
            for line in running.lines():
                live.append(json.loads(line))
                if not stopped and live[-1]["type"] == "snapshot" and live[-1]["t_s"] >= 6.0:
                    stopped, supervisor = True, running.named("gcs.session.process").pid
                    os.kill(supervisor, signal.SIGSTOP)
                    time.sleep(LATE_S)
                    os.kill(supervisor, signal.SIGCONT)
            outcome = running.finish()
        finally:
            running.stop()
    replay = Replay(outcome.folder)
    shown = []
    for tenth in range(round(10.0 * replay.to_s) + 1):
        replay.advance(tenth / 10, float("inf"))
        shown.append(replay.snapshot(speed=None))
    replay.advance(replay.to_s, float("inf"))
    shown.append(replay.snapshot(speed=None))
    sought = Replay(outcome.folder, block_bytes=1 << 16)
    sought.seek(sought.to_s)
    snapshots = [line for line in live if line["type"] == "snapshot"]
    return Told(outcome, snapshots, shown, sought.snapshot(speed=None), Findings(read(outcome.folder)))


def row(snapshot: dict[str, Any], sysid: int) -> dict[str, Any]:
    found: dict[str, Any] = next(vehicle for vehicle in snapshot["vehicles"] if vehicle["sysid"] == sysid)
    return found


@pytest.mark.parametrize("sysid", [1, STRANGER, 101, 201])
def test_what_a_battery_holds(told: Told, sysid: int) -> None:
    ledger = told.outcome.vehicle(sysid)["energy"]
    assert ledger["source"] == ("current_voltage" if sysid == STRANGER else "energy_consumed")
    assert ledger["drawn_j"] > 1000.0
    remaining_j = [row(snapshot, sysid)["remaining_j"] for snapshot in told.snapshots]
    assert remaining_j == pytest.approx([ledger["remaining_j"]] * 3, abs=1e-6)
    for snapshot in told.snapshots:
        share = ledger["remaining_j"] / told.report.batteries[sysid].capacity_j
        assert row(snapshot, sysid)["battery"] == pytest.approx(share, abs=1e-9)
    battery = told.report.batteries[sysid]
    assert battery.remaining.values[-1] == pytest.approx(ledger["remaining_j"], abs=1e-6)


@pytest.mark.parametrize("sysid", [1, 101, 201])
def test_where_a_vehicle_is(told: Told, sysid: int) -> None:
    """As its own record has it at the time of the snapshot, less the age of the report."""
    truth = told.outcome.truth(sysid)
    flown = [(line["t_s"], row(line, sysid)) for line in told.live if line["t_s"] >= 1.0]
    for t_s, shown in flown:
        at = bisect.bisect_left(truth.time_s.tolist(), t_s - shown["age_s"] - 1e-6)
        assert truth.time_s[at] == pytest.approx(t_s - shown["age_s"], abs=1e-6)
        assert shown["p_ned"] == pytest.approx(truth.p_ned[at].tolist(), abs=0.02)
    assert max(shown["speed_m_s"] for _, shown in flown) > 0.5


@pytest.mark.parametrize("sysid", [1, 101, 201])
def test_the_greatest_tracking_error(told: Told, sysid: int) -> None:
    error_m = told.outcome.vehicle(sysid)["max_tracking_error_m"]
    assert error_m > 0.0
    assert float(np.nanmax(told.report.errors[sysid].values)) == pytest.approx(error_m, abs=1e-6)


def test_a_text_in_chunks(told: Told) -> None:
    for snapshots in (told.live, told.replay):
        events = [event for snapshot in snapshots for event in snapshot["events"] if event["kind"] == "text"]
        ((level, text),) = {(e["level"], e["text"]) for e in events if "low" in e["text"]}
        assert (level, text) == ("warning", TEXT)
    assert [(sysid, text) for _, sysid, _, text in told.report.texts if "low" in text] == [(STRANGER, TEXT)]


def test_how_long_the_pursuit_was_held(told: Told) -> None:
    """The session measures at the ticks that it makes, a replay at all: where ticks come late as the pursuit begins,
    they may differ by as much. A busy machine shows the last moments in fewer snapshots, so that the last one is
    compared with the replay's of the same time."""
    last = told.live[-1]
    then = min(told.replay, key=lambda snapshot: abs(float(snapshot["t_s"]) - float(last["t_s"])))
    held_s = last["goal"]["pursue_held_s"]
    made_s = sorted({t_s for t_s, _ in told.outcome.messages("SET_POSITION_TARGET_LOCAL_NED")})
    after = bisect.bisect_left(made_s, last["t_s"] - held_s - 0.01)
    late_s = made_s[after] - made_s[after - 1] - PERIOD_S
    assert held_s > 2.0
    assert then["goal"]["pursue_held_s"] == pytest.approx(held_s, abs=0.11 + late_s)
    (reached_s,) = (part["value"] for part in told.outcome.summary["goal"] if part["part"] == "pursue")
    by_replay, by_sought = (snapshot["goal"]["pursue_held_s"] for snapshot in (told.replay[-1], told.sought))
    assert by_replay == by_sought == pytest.approx(reached_s, abs=0.11 + late_s)
    assert min(told.report.nearness.held_s.values()) == pytest.approx(reached_s, abs=0.11 + late_s)


def test_frames_lost(told: Told) -> None:
    lost = told.outcome.summary["link"]["lost"]
    assert lost > 5
    for snapshot in told.snapshots:
        assert [(v["sysid"], v["lost"]) for v in snapshot["vehicles"] if v["lost"]] == [(STRANGER, lost)]
    by_vehicle = told.report.recorded.traffic_lost
    assert {sysid: table.sum() for sysid, table in by_vehicle.items() if table.any()} == {STRANGER: lost}


def test_refuellings(told: Told) -> None:
    keys = ("receiver", "tanker", "base", "by", "decided_at_s", "joined_at_s", "start_s", "end_s", "energy_j")
    summary = [tuple(service[key] for key in keys) for service in told.outcome.summary["refuelling"]]
    ended = [service for service in summary if service[keys.index("end_s")] is not None]
    assert len(ended) >= 1
    for snapshot in told.snapshots:
        assert [tuple(service[key] for key in keys) for service in snapshot["history"]] == ended
    assert [tuple(getattr(service, key) for key in keys) for service in told.report.services] == summary


def test_times_of_the_four(told: Told) -> None:
    assert told.report.end_s == pytest.approx(told.replay[-1]["t_s"])
    assert told.replay[-1]["t_s"] == pytest.approx(told.live[-1]["t_s"], abs=3.0)
