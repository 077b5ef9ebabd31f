"""Recordings whose stamps pass at another rate than their vehicles' clocks: the clocks hold, where stamps are far off
by all of them."""

from __future__ import annotations

import io
import itertools
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.recording import tlog_reader

Times = NDArray[np.int64]
SECOND_US = 1_000_000
EPOCH_US = 1_767_225_600 * SECOND_US
PERIOD_US = 200_000
FLIGHT_S = 60
GCS = mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)


def attitude(boot_us: int) -> Any:
    return mav.MAVLink_attitude_message(boot_us // 1000, 0.1, 0.2, 0.3, 0.0, 0.0, 0.0)


def system_time(boot_us: int) -> Any:
    return mav.MAVLink_system_time_message(EPOCH_US + boot_us, boot_us // 1000)


def position(boot_us: int) -> Any:
    """The time stands in the middle of the payload."""
    return mav.MAVLink_local_position_ned_cov_message(boot_us, 1, *[0.0] * 9, [0.0] * 45)


def imu(boot_us: int) -> Any:
    return mav.MAVLink_highres_imu_message(boot_us, *[0.1] * 13, 63)


KINDS = {"time_boot_ms": attitude, "time_boot_ms behind others": system_time, "time_usec": imu, "of 64 bits": position}


def flight(sysid: int, kind: str, *, begin_s: float = 100.0, rate: float = 1.0) -> Iterator[tuple[int, bytes]]:
    """(when it came, µs of true time; frame): HEARTBEAT and a message that says the time, which passes at a rate."""
    sender = mav.MAVLink(io.BytesIO(), sysid, 1)
    for came_us in range(0, FLIGHT_S * SECOND_US, PERIOD_US):
        messages = [KINDS[kind](round(begin_s * SECOND_US + rate * came_us))]
        if came_us % SECOND_US == 0:
            messages.insert(0, mav.MAVLink_heartbeat_message(2, 12, 0x81, 0, 4, 3))
        for message in messages:
            yield came_us, bytes(message.pack(sender))
            sender.seq = (sender.seq + 1) % 256


def recorded(path: Path, *flights: Iterator[tuple[int, bytes]], stamps: Any) -> Times:
    """When frames came, µs since the first; `stamps`: of all those times, (n,) µs."""
    came = sorted(itertools.chain(*flights), key=lambda one: one[0])
    came_us = np.array([one for one, _ in came])
    stamps_us = np.rint(EPOCH_US + stamps(came_us)).astype(np.int64)
    path.write_bytes(
        b"".join(struct.pack(">Q", at) + raw for at, (_, raw) in zip(stamps_us.tolist(), came, strict=True))
    )
    return came_us


def read(path: Path) -> tuple[Times, list[str]]:
    log = tlog_reader.Tlog(path, chunk_bytes=4096)
    times_us = np.array([t_us for t_us, _ in log])
    return times_us - EPOCH_US, log.problems


@given(
    rate=st.floats(1e-2, 1e2).filter(lambda rate: not 0.7 < rate < 1.4),
    kinds=st.lists(st.sampled_from(list(KINDS)), min_size=1, max_size=3),
    begin_s=st.floats(1.0, 4e6),
)
@settings(max_examples=20, deadline=None)
def test_stamps_at_an_even_wrong_rate_are_not_believed(
    tmp_path_factory: pytest.TempPathFactory, rate: float, kinds: list[str], begin_s: float
) -> None:
    path = tmp_path_factory.mktemp("log") / "flight.tlog"
    flights = [flight(number + 1, kind, begin_s=begin_s + 50 * number) for number, kind in enumerate(kinds)]
    came_us = recorded(path, *flights, stamps=lambda came_us: rate * came_us)
    times_us, problems = read(path)
    assert np.abs(times_us - came_us).max() <= PERIOD_US
    (problem,) = problems
    times = rate if rate > 1.0 else 1.0 / rate
    how = "fast" if rate > 1.0 else "slowly"
    assert f"times as {how} as the vehicles' own clocks; it has the times of these" in problem
    assert float(problem.split("its stamps pass ")[1].split()[0]) == pytest.approx(times, rel=0.02)


BELIEVED: dict[str, tuple[Any, Any]] = {
    "one vehicle's clock agrees": ([1.0, 5.0], lambda came_us: came_us),
    "two simulations at speeds of their own": ([5.0, 20.0], lambda came_us: came_us),
    "a clock in another unit": ([1000.0], lambda came_us: came_us),
    "a clock that stands still": ([0.0], lambda came_us: came_us),
    "frames that come in bursts of 8 s": (
        [1.0],
        lambda came_us: came_us // 8_000_000 * 8_000_000 + came_us % 8_000_000 / 100,
    ),
}


@pytest.mark.parametrize("case", BELIEVED)
def test_stamps_that_no_clock_refutes_are_believed(tmp_path: Path, case: str) -> None:
    rates, stamps = BELIEVED[case]
    path = tmp_path / "flight.tlog"
    came_us = recorded(path, *(flight(n + 1, "time_boot_ms", rate=rate) for n, rate in enumerate(rates)), stamps=stamps)
    times_us, problems = read(path)
    assert np.abs(times_us - stamps(came_us)).max() <= 1
    assert not any("pass" in problem or "set" in problem for problem in problems)


def test_a_ground_stations_clock_is_no_vehicles(tmp_path: Path) -> None:
    """A simulation of five times the speed, beside the SYSTEM_TIME of the station that recorded it."""
    station = mav.MAVLink(io.BytesIO(), 255, 190)
    beside = [
        (at_us, bytes(message.pack(station)))
        for at_us in range(0, FLIGHT_S * SECOND_US, SECOND_US)
        for message in (GCS, system_time(7 * SECOND_US + at_us // 5))
    ]
    path = tmp_path / "sitl.tlog"
    came_us = recorded(path, flight(1, "time_boot_ms"), iter(beside), stamps=lambda came_us: came_us / 5)
    times_us, problems = read(path)
    assert np.abs(times_us - came_us).max() <= SECOND_US
    assert problems == [
        "sitl.tlog: its stamps pass 5 times as slowly as the vehicles' own clocks; it has the times of these."
    ]


def test_a_silence_at_a_wrong_rate_is_as_long_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "flight.tlog"
    late = (
        (came_us + (40 * SECOND_US if came_us > 30 * SECOND_US else 0), raw)
        for came_us, raw in flight(1, "time_boot_ms")
    )
    came_us = recorded(path, late, stamps=lambda came_us: 6.0 * came_us)
    times_us, problems = read(path)
    true_us = np.where(came_us > 31 * SECOND_US, came_us - 40 * SECOND_US, came_us)
    assert np.abs(times_us - true_us).max() <= PERIOD_US, "the vehicle's clock did not pass in the silence"
    assert "6 times as fast" in problems[0]


@pytest.mark.parametrize("by_s", [30, 631, 3000])
def test_a_vehicle_heard_again_much_later_by_its_clock_alone(tmp_path: Path, by_s: int) -> None:
    """The first third is so much older than its stamps, as of the public recording tlog_data_0."""
    path = tmp_path / "flight.tlog"
    third_us = FLIGHT_S * SECOND_US // 3
    both = [
        *((at_us, raw) for at_us, raw in flight(1, "time_boot_ms") if at_us < third_us),
        *((at_us, raw) for at_us, raw in flight(1, "time_boot_ms", begin_s=100.0 + by_s) if at_us >= third_us),
    ]
    came_us = recorded(path, iter(both), stamps=lambda came_us: came_us)
    times_us, problems = read(path)
    true_us = came_us + np.where(came_us < third_us, -by_s * SECOND_US, 0)
    assert (np.abs(times_us - true_us) > PERIOD_US).sum() <= 1, "but for the HEARTBEAT before the first time that leaps"
    assert any(f"set back by {by_s}.0 s" in problem for problem in problems)
