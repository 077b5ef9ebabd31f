"""Compiled telemetry against the messages that pymavlink reads, and against the builders that it stands for."""

from __future__ import annotations

import math

import numpy as np
import pytest
from pymavlink.dialects.v20 import common

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law import rows
from simvehicle.mavlink import motion_frames, telemetry
from simvehicle.mavlink.codec import encode
from simvehicle.mavlink.connection import Connection

BUILDERS = {
    motion_frames.ATTITUDE: telemetry.attitude,
    motion_frames.LOCAL_POSITION: telemetry.local_position_ned,
    motion_frames.GLOBAL_POSITION: telemetry.global_position_int,
}


def vehicle_in(random: np.random.Generator, scale: float) -> Vehicle:
    """A vehicle somewhere on the globe in a random state; some of its numbers are 0."""
    origin = LocalFrame(random.uniform(-80.0, 80.0), random.uniform(-180.0, 180.0), random.uniform(-100.0, 4000.0))
    vehicle = Vehicle(IDENTITIES["px4"], Parameters(), origin, Start(airborne=True))
    state = random.normal(size=rows.STATE_SIZE) * scale * (random.random(rows.STATE_SIZE) < 0.8)
    vehicle.plant.state[0] = state
    vehicle.plant.now = state.tolist()
    vehicle.time_ms = int(random.integers(0, 1 << 31))
    vehicle.home_ned = (0.0, 0.0, float(random.normal()))
    return vehicle


@pytest.mark.parametrize("scale", [1e-3, 1.0, 30.0, 1e6])
@pytest.mark.parametrize("wanted", range(1, 8))
def test_frames_are_the_builders_byte_for_byte(scale: float, wanted: int) -> None:
    random = np.random.default_rng(wanted)
    out = np.empty(motion_frames.LARGEST_BYTES, np.uint8)
    for seq in range(0, 300, 3):
        vehicle = vehicle_in(random, scale)
        *_, end = motion_frames.write_motion(
            out, vehicle.state, vehicle.frame.row, vehicle.home_ned[2], vehicle.time_ms, wanted, seq & 0xFF, 7, 1
        )
        snapshot = vehicle.snapshot()
        contents = [build(snapshot) for bit, build in BUILDERS.items() if wanted & bit]
        expected = [encode(one, seq=(seq + k) & 0xFF, sysid=7, compid=1) for k, one in enumerate(contents)]
        assert out[:end].tobytes() == b"".join(expected)


def test_pymavlink_reads_the_state() -> None:
    vehicle = Vehicle(IDENTITIES["px4"], Parameters(), LocalFrame(47.0, 8.0, 500.0), Start(airborne=True))
    state = np.zeros(rows.STATE_SIZE)
    state[:12] = (1.0, -2.0, 3.0, 0.1, -0.2, 0.3, 0.01, -0.02, -0.5, 0.0, 0.0, 0.25)
    vehicle.plant.state[0], vehicle.plant.now = state, state.tolist()
    vehicle.time_ms = 1200
    out = np.empty(motion_frames.LARGEST_BYTES, np.uint8)
    *_, end = motion_frames.write_motion(out, vehicle.state, vehicle.frame.row, 0.0, 1200, 7, 254, 3, 1)
    attitude, local, world = common.MAVLink(None).parse_buffer(out[:end].tobytes())
    assert [m.get_seq() for m in (attitude, local, world)] == [254, 255, 0]
    assert (attitude.roll, attitude.pitch, attitude.yaw) == pytest.approx((0.01, 0.02, 0.5))
    assert attitude.yawspeed == pytest.approx(-0.25 * math.cos(0.01) * math.cos(0.02))
    assert (local.x, local.y, local.z) == (1.0, 2.0, -3.0)
    assert (local.vx, local.vy, local.vz) == pytest.approx((0.1, 0.2, -0.3))
    assert (world.lat, world.alt, world.relative_alt) == (470000000 + round(1e7 / 111165.9), 503000, 3000)
    assert (world.vx, world.vy, world.vz) == (10, 20, -30)
    assert world.hdg == round(100.0 * math.degrees(0.5))
    assert {m.time_boot_ms for m in (attitude, local, world)} == {1200}


def test_a_connection_numbers_motion_with_everything_else() -> None:
    connection = Connection(5)
    vehicle = Vehicle(IDENTITIES["px4"], Parameters(), LocalFrame(47.0, 8.0, 500.0), Start(airborne=True))
    parser = common.MAVLink(None)
    numbers, names = [], []
    for _ in range(100):
        vehicle.time_ms += 100
        connection.put_due(vehicle)
        connection.put(telemetry.heartbeat(vehicle.snapshot()))
        for frame in connection.frames():
            (one,) = parser.parse_buffer(frame)
            numbers.append(one.get_seq())
            names.append(one.get_type())
    assert numbers == [k % 256 for k in range(len(numbers))]
    assert names.count("ATTITUDE") == names.count("LOCAL_POSITION_NED") == 100
