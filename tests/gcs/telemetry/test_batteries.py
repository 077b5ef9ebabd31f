"""Several batteries: all are known, and the emptiest that a vehicle flies on counts, live, in a replay and a report.

The truth is a dictionary: the last charge of each battery that is no payload's and no avionics'."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink import codec
from gcs.recording import series
from gcs.recording.recorder import Recorder
from gcs.recording.session_folder import read
from gcs.scenario.file import dump
from gcs.scenario.model import Scenario
from gcs.session.observer import Observer
from gcs.telemetry.batteries import GONE_S, MOST_BATTERIES, Batteries
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.track import Member

CAPACITY_J = 20_000.0
EPOCH_US = 1_767_225_600_000_000
FLOWN_ON = (mav.MAV_BATTERY_FUNCTION_UNKNOWN, mav.MAV_BATTERY_FUNCTION_ALL, mav.MAV_BATTERY_FUNCTION_PROPULSION)


def frame(message: Any, compid: int = 1) -> codec.Frame:
    """As pymavlink packs it."""
    return codec.split(bytes(message.pack(mav.MAVLink(None, srcSystem=1, srcComponent=compid)))).frames[0]


def battery(id: int, percent: int, function: int = 0, compid: int = 1, **more: Any) -> codec.Frame:
    values = {
        "temperature": 32767, "voltages": [65535] * 10, "current_battery": -1, "current_consumed": -1,
        "energy_consumed": -1,
    } | more  # fmt: skip
    return frame(mav.MAVLink_battery_status_message(id, function, 0, battery_remaining=percent, **values), compid)


def beat(armed: bool = True) -> codec.Frame:
    return frame(mav.MAVLink_heartbeat_message(2, 12, 0x81 if armed else 1, 4 << 16 | 3 << 24, 4, 3))


@st.composite
def told(draw: st.DrawFn) -> list[tuple[int, int, int]]:
    """(battery, function, percent) in the order in which they come; each battery only empties, or never says a word."""
    batteries = draw(st.lists(st.tuples(st.integers(0, 255), st.integers(0, 4), st.booleans()), min_size=1, max_size=5,
                              unique_by=lambda one: one[0]))  # fmt: skip
    left = {number: draw(st.integers(0, 100)) for number, _, _ in batteries}
    words = []
    for k in range(draw(st.integers(1, 30))):
        number, function, says = (
            batteries[k % len(batteries)] if k < len(batteries) else draw(st.sampled_from(batteries))
        )
        left[number] = draw(st.integers(max(left[number] - 10, 0), left[number]))
        words.append((number, function, left[number] if says else -1))
    return words


@settings(max_examples=80, deadline=None)
@given(told())
def test_a_session_and_a_monitor_know_the_emptiest_that_is_flown_on(words: list[tuple[int, int, int]]) -> None:
    fleet = Fleet([Member(1, "pursuer", "pursuer 1", CAPACITY_J, CAPACITY_J, external=True)], GlobalOrigin(47, 8, 400))
    observer = Observer("monitor", "udpin:127.0.0.1:0")
    for one in (fleet.ingest, observer.receive):
        one(beat(), 0.0)
    last: dict[int, int] = {}
    every: dict[int, int] = {}
    for k, (number, function, percent) in enumerate(words):
        t_s = 0.5 * k
        for one in (fleet.ingest, observer.receive):
            one(battery(number, percent, function), t_s)
        every[number] = percent
        if function in FLOWN_ON and percent >= 0:
            last[number] = percent
        row = observer.snapshot(t_s, speed=1.0, phase="flying")["vehicles"][0]
        if not last:
            assert row["battery"] is None
            continue
        worst = min(last.values())
        assert row["battery"] == pytest.approx(0.01 * worst)
        assert (f"battery {worst} %" in row["trouble"]) == (worst < 20)
        shown = {one["id"]: one["share"] for one in row.get("batteries", [{"id": 0, "share": row["battery"]}])}
        assert shown == pytest.approx({number: None if p < 0 else 0.01 * p for number, p in every.items()})
        if last.keys() == {0}:
            continue  # the one that every vehicle has: its account is in test_energy.py
        view = fleet.snapshot(t_s).vehicle(1)
        assert view.remaining_j == pytest.approx(0.01 * worst * CAPACITY_J)
        assert view.drawn_j >= 0.0
        assert {one.id for one in fleet.batteries(1)} <= every.keys()


def test_the_emptiest_counts_from_the_first_word_of_another_on() -> None:
    fleet = Fleet([Member(1, "pursuer", "pursuer 1", CAPACITY_J, CAPACITY_J, external=True)], GlobalOrigin(47, 8, 400))
    for number, percent in ((0, 20), (1, 80), (2, 50), (0, 19)):
        fleet.ingest(battery(number, percent, voltages=[15_000] + [65535] * 9), 1.0)
        worst = 20 if number else percent
        assert fleet.snapshot(1.0).vehicle(1).remaining_j == pytest.approx(0.01 * worst * CAPACITY_J)
        assert not number or fleet.batteries(1)[0].voltage_v == 15.0


def test_one_that_knows_nothing_hides_none_that_does() -> None:
    fleet = Fleet([Member(1, "pursuer", "pursuer 1", CAPACITY_J, CAPACITY_J, external=True)], GlobalOrigin(47, 8, 400))
    for k in range(4):
        fleet.ingest(battery(0, -1), 1.0 * k)
        fleet.ingest(battery(1, 37, energy_consumed=10 + k), 1.0 * k)
    view = fleet.snapshot(4.0).vehicle(1)
    assert view.remaining_j == pytest.approx(0.37 * CAPACITY_J, abs=301.0)
    assert view.energy_source == "energy_consumed"


def test_sys_status_does_not_hide_the_emptiest() -> None:
    observer = Observer("monitor", "udpin:127.0.0.1:0")
    observer.receive(beat(), 0.0)
    status = frame(mav.MAVLink_sys_status_message(0, 0, 0, 0, 16_000, 100, 90, 0, 0, 0, 0, 0, 0))
    for one in (battery(0, 90), battery(1, 12), status):
        observer.receive(one, 1.0)
    assert observer.snapshot(1.0, speed=1.0, phase="flying")["vehicles"][0]["battery"] == pytest.approx(0.12)


def test_a_battery_that_is_a_component_of_its_own_counts_in_a_monitor() -> None:
    observer = Observer("monitor", "udpin:127.0.0.1:0")
    for one in (beat(), battery(0, 90), battery(0, 15, compid=mav.MAV_COMP_ID_BATTERY)):
        observer.receive(one, 1.0)
    row = observer.snapshot(1.0, speed=1.0, phase="flying")["vehicles"][0]
    assert row["battery"] == pytest.approx(0.15)
    assert [(one["compid"], one["id"]) for one in row["batteries"]] == [(1, 0), (mav.MAV_COMP_ID_BATTERY, 0)]


def test_a_battery_that_was_taken_out_counts_no_more_and_their_number_is_bounded() -> None:
    batteries = Batteries()
    batteries.add(1, codec.fields(battery(0, 5)), 0.0)
    batteries.add(1, codec.fields(battery(1, 80)), 1.0)
    assert batteries.share(GONE_S - 0.1) == pytest.approx(0.05)
    assert batteries.share(GONE_S + 0.1) == pytest.approx(0.8)
    for number in range(256):
        batteries.add(1, codec.fields(battery(number, 50)), 2.0)
    assert len(batteries.all) == MOST_BATTERIES


@pytest.mark.parametrize("emptier", [0, 1])
def test_a_report_keeps_the_account_that_the_session_kept(tmp_path: Path, emptier: int) -> None:
    scenario = Scenario.model_validate(
        {
            "schema": 1, "name": "batteries", "axes": "ned",
            "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
             "goal": {"duration_s": 20.0}, "clock": {"mode": "real"},
            "vehicles": {"pursuers": [{"sysid": 1, "start_m": (0.0, 0.0, 0.0), "battery": {"capacity_j": CAPACITY_J},
                                       "external": {"connect": "udpin:127.0.0.1:14550"}}],
                         "targets": [{"sysid": 101, "start_m": (9.0, 0.0, 0.0), "battery": {"capacity_j": CAPACITY_J},
                                     "path_m": [(9.0, 0.0, -5.0)], "speed_m_s": 1.0}]},
        }
    )  # fmt: skip
    folder = tmp_path / "session"
    folder.mkdir()
    (folder / "scenario.yaml").write_text(dump(scenario), encoding="utf-8")
    epoch_us = round(1e6 * scenario.clock.epoch.timestamp())
    fleet = Fleet([Member(1, "pursuer", "pursuer 1", CAPACITY_J, CAPACITY_J, external=True)], GlobalOrigin(47, 8, 400))
    live: list[float] = []
    with Recorder(folder) as recorder:
        for k in range(20):
            left = (60 - 2 * k, 90 - k) if emptier == 0 else (90 - k, 60 - 2 * k)
            frames = [beat(), battery(0, left[0]), battery(1, left[1]) if k > 4 else beat()]
            frames += [battery(2, 3, 4)] if k > 6 else []
            for one in frames:
                recorder.frames(epoch_us + 1_000_000 * k, [one.raw])
                fleet.ingest(one, 1.0 * k)
                if one.msgid == codec.msgid("BATTERY_STATUS"):
                    live.append(fleet.snapshot(1.0 * k).vehicle(1).remaining_j)
    kept = series.batteries(read(folder))[1].remaining
    assert kept.values.tolist() == pytest.approx(live[-len(kept.values) :])
    assert len(kept.values) >= len(live) - 1
    assert kept.values[-1] == pytest.approx(0.22 * CAPACITY_J)
