"""Two voltages of one battery that disagree are said once; those of PX4-Autopilot issue 18535 are the example."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import gcs
from hypothesis import given
from hypothesis import strategies as st
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink import codec
from gcs.mavlink.battery import cells_mv, voltage_v
from gcs.session.observer import Observer
from gcs.telemetry.voltage_watch import LASTING_S, VoltageWatch

EPOCH_US = 1_767_225_600_000_000
TEN_OF_TWELVE = [4580] * 10
SAID = "SYS_STATUS says 55.0 V and BATTERY_STATUS 45.8 V of battery 0: what BATTERY_STATUS says is shown"


def frames(cells: list[int], whole_mv: int, seconds: int = 30) -> list[tuple[float, bytes]]:
    sender = mav.MAVLink(None, srcSystem=7, srcComponent=1)
    told: list[tuple[float, bytes]] = []
    for k in range(seconds):
        status: Any = mav.MAVLink_sys_status_message(0, 0, 0, 0, whole_mv, 1000, 70, 0, 0, 0, 0, 0, 0)
        battery: Any = mav.MAVLink_battery_status_message(0, 0, 1, 32767, cells, 1000, -1, -1, 70)
        beat: Any = mav.MAVLink_heartbeat_message(2, 12, 0x81, 4 << 16, 4, 3)
        told += [(float(k), bytes(one.pack(sender))) for one in (beat, battery, status)]
    return told


@pytest.fixture
def tlog(tmp_path: Path) -> Path:
    path = tmp_path / "twelve_cells.tlog"
    stamped = [struct.pack(">Q", EPOCH_US + round(1e6 * t_s)) + raw for t_s, raw in frames(TEN_OF_TWELVE, 55_000)]
    path.write_bytes(b"".join(stamped))
    return path


@pytest.mark.parametrize(
    ("cells", "whole_mv", "count"),
    [
        (TEN_OF_TWELVE, 55_000, 1), (TEN_OF_TWELVE, 45_900, 0), ([65_534, 4_000, *[65535] * 8], 65_534, 1),
        ([55_000, *[65535] * 9], 55_000, 0), (TEN_OF_TWELVE, 65_535, 0), ([65535] * 10, 55_000, 0),
    ],
)  # fmt: skip
def test_a_monitor_says_it_once_where_both_are_known(cells: list[int], whole_mv: int, count: int) -> None:
    observer, texts = Observer("monitor", "udpin:127.0.0.1:14550"), []
    for t_s, raw in frames(cells, whole_mv):
        observer.receive(codec.split(raw).frames[0], t_s)
        texts += [e["text"] for e in observer.snapshot(t_s, speed=1.0, phase="flying")["events"]]
    assert sum("SYS_STATUS says" in text for text in texts) == count


def test_replay_export_and_report_say_it(tlog: Path, tmp_path: Path) -> None:
    assert SAID in gcs("replay", str(tlog), "--json").stdout
    exported = gcs("export", str(tlog), "--format", "csv", "--out", str(tmp_path / "tables"))
    assert exported.returncode == 0
    assert f"Vehicle 7 at 10.0 s: {SAID}" in exported.stderr
    assert gcs("report", str(tlog)).returncode == 0
    assert f"Vehicle 7: {SAID}" in tlog.with_name(f"{tlog.name}.html").read_text(encoding="utf-8")


def test_it_must_last_and_any_of_several_batteries_may_be_meant() -> None:
    watch = VoltageWatch()
    for k in range(100):
        t_s = 0.5 * LASTING_S * k
        watch.take_battery(0, 22.0, t_s)
        watch.take_battery(1, 50.0 if k % 2 else 12.0, t_s)
        assert watch.take_status(50.0, t_s) is None


def test_an_old_voltage_is_not_compared() -> None:
    watch = VoltageWatch()
    watch.take_battery(0, 12.0, 0.0)
    assert {watch.take_status(50.0, 11.0 + k) for k in range(60)} == {None}


@given(st.floats(0.001, 655.0))
def test_any_voltage_is_told_by_cells_that_sum_to_it(volts: float) -> None:
    """By the message's definition: cell 0 is full before cell 1 holds anything, and none is the mark of no cell."""
    cells = cells_mv(volts)
    used = [cell for cell in cells if cell != 65535]
    assert voltage_v(cells) == pytest.approx(volts, abs=6e-4) or (round(1e3 * volts) == 0 and not used)
    assert used == cells[: len(used)]
    assert all(cell == 65534 for cell in used[:-1])


@pytest.mark.parametrize("volts", [0.0, -1.0, np.nan, np.inf, 1e6])
def test_what_is_no_voltage_is_none(volts: float) -> None:
    assert cells_mv(volts) == [65535] * 10
