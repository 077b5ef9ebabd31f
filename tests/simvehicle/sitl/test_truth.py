"""The truth file: its ledger closes with power recomputed from the recorded thrust, not from the accumulators."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from pymavlink.dialects.v20 import common as mav

from simvehicle.autopilot.body import Start
from simvehicle.sitl.truth import ENERGY, STATE, TruthWriter
from simvehicle.sitl.unit import VehicleUnit

HEAD_NUMBERS = 2 + len(STATE) + len(ENERGY)


def read(path: Path) -> tuple[dict[str, Any], NDArray[np.float64], list[NDArray[np.float64]]]:
    """Head, the records' fixed part (n, 18) and the thrusts of each."""
    first, _, rest = path.read_bytes().partition(b"\n")
    numbers = np.frombuffer(rest, dtype="<f8")
    rows, thrusts, at = [], [], 0
    while at < len(numbers):
        steps = int(numbers[at + 1])
        rows.append(numbers[at : at + HEAD_NUMBERS])
        thrusts.append(numbers[at + HEAD_NUMBERS : at + HEAD_NUMBERS + steps])
        at += HEAD_NUMBERS + steps
    assert at == len(numbers)
    return json.loads(first), np.array(rows), thrusts


def written(bench: Any, path: Path, periods: int, *, period_ms: int = 100, start: bool = True) -> None:
    with TruthWriter(path, bench.sysid, bench.vehicle) as writer:
        unit = VehicleUnit(bench.vehicle, bench.services, writer)
        if start:
            unit.advance(0)
        for _ in range(periods):
            bench.gcs_heartbeat()
            unit.advance(bench.vehicle.time_ms + period_ms)
            bench.drain()


def test_power_recomputed_from_thrust_equals_what_was_drawn(vehicle_bench: Any, tmp_path: Path) -> None:
    bench = vehicle_bench(params={"SIM_BAT_INIT_J": 20_000.0})
    bench.arm()
    bench.vehicle.take_off(3.0)
    written(bench, tmp_path / "1.truth", 300)
    head, rows, thrusts = read(tmp_path / "1.truth")
    u1 = np.concatenate(thrusts)
    assert len(u1) == 300 * 25
    power_w = head["hover_w"] * (u1 / head["gravity_m_s2"]) ** 1.5 + head["avionics_w"]
    drawn_j = np.cumsum(power_w)[np.cumsum([len(t) for t in thrusts]) - 1][1:] * head["step_s"]
    columns = dict(zip(ENERGY, rows[1:, -4:].T, strict=True))
    assert np.abs(columns["drawn_j"] - drawn_j).max() < 1e-6 * head["capacity_j"]
    assert drawn_j[-1] > 1000.0
    gap = head["initial_j"] + columns["received_j"] - drawn_j - columns["given_j"] - columns["remaining_j"]
    assert np.abs(gap).max() < 1e-6 * head["capacity_j"]


def test_truth_agrees_with_what_is_reported(vehicle_bench: Any, tmp_path: Path) -> None:
    bench = vehicle_bench(5, start=Start((1.0, 2.0, -3.0), (0.5, 0.0, 0.0), (0.0, 0.0, 0.4), airborne=True))
    written(bench, tmp_path / "5.truth", 20)
    head, rows, _ = read(tmp_path / "5.truth")
    assert head["sysid"] == 5
    by_time = {round(1e3 * row[0]): row for row in rows}
    reported = bench.of("LOCAL_POSITION_NED")
    assert len(reported) == 21
    for m in reported:
        row = by_time[m.time_boot_ms]
        assert (m.x, m.y, m.z, m.vx, m.vy, m.vz) == pytest.approx(tuple(row[2:8]), rel=1e-6, abs=1e-6)
    for m in bench.of("ATTITUDE"):
        row = by_time[m.time_boot_ms]
        assert (m.roll, m.pitch, m.yaw) == pytest.approx(tuple(row[8:11]), rel=1e-6, abs=1e-6)


def test_given_and_received_are_in_the_ledger(vehicle_bench: Any, tmp_path: Path) -> None:
    bench = vehicle_bench(start=Start((0.0, 0.0, -3.0), airborne=True))
    bench.set_point((0.0, 0.0, -3.0))
    bench.send(mav.MAVLink_named_value_int_message(0, b"XferIn", 0), source=(2, 1))
    assert bench.result(mav.MAV_CMD_USER_1, 2.0, 1.0, 1e4, 300.0, 1.0, 0.0) == 0
    written(bench, tmp_path / "1.truth", 15)
    head, rows, _ = read(tmp_path / "1.truth")
    drawn, received, given, remaining = rows[:, -4:].T
    assert given.max() > 250.0
    assert np.array_equal(given, np.floor(given))
    assert np.abs(head["initial_j"] + received - drawn - given - remaining).max() < 1e-6


def test_existing_file_is_never_overwritten(vehicle_bench: Any, tmp_path: Path) -> None:
    path = tmp_path / "1.truth"
    path.write_text("precious")
    with pytest.raises(FileExistsError), TruthWriter(path, 1, vehicle_bench().vehicle):
        pass
    assert path.read_text() == "precious"


def test_truth_is_the_log_of_the_vehicle_and_erased_begins_anew_while_the_file_stays(
    vehicle_bench: Any, tmp_path: Path
) -> None:
    bench, path = vehicle_bench(), tmp_path / "1.truth"
    with TruthWriter(path, bench.sysid, bench.vehicle) as log:
        unit = VehicleUnit(bench.vehicle, bench.services, log)
        unit.start_clock(0, 1_700_000_000_000_000)
        for _ in range(50):
            unit.advance(bench.vehicle.time_ms + 100)
        whole = path.read_bytes()
        assert (log.number, log.unix_s, log.size_bytes) == (1, 1_700_000_000, len(whole))
        assert b"".join(log.read(at, 90) for at in range(0, len(whole), 90)) == whole
        assert log.read(len(whole), 90) == log.read(len(whole) + 900, 90) == b""
        log.erase()
        head = whole[: whole.index(b"\n") + 1]
        assert log.read(0, 9999) == head
        unit.advance(bench.vehicle.time_ms + 100)
        new = path.read_bytes()
        assert new.startswith(whole)
        assert (log.number, log.unix_s) == (2, 1_700_000_005)
        assert b"".join(log.read(at, 7) for at in range(0, log.size_bytes, 7)) == head + new[len(whole) :]
