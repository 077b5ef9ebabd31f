"""ArduPilot's JSON interface by its bytes."""

from __future__ import annotations

import json
import struct
from itertools import pairwise

import pytest

from simvehicle.mavlink.real_autopilots import json_backend


@pytest.mark.parametrize(("magic", "channels"), [(18458, 16), (29569, 32)])
def test_a_servo_packet_is_read_and_what_is_none_is_not(magic: int, channels: int) -> None:
    pwm = (1000, 1250, 1500, 2100, *[0] * (channels - 4))
    datagram = struct.pack(f"<HHI{channels}H", magic, 400, 7, *pwm)
    assert json_backend.parse(datagram) == (7, (0.0, 0.25, 0.5, 1.0))
    for wrong in (datagram[:-1], datagram + b"\0", b"\0\0" + datagram[2:], b"", b"\x1a"):
        assert json_backend.parse(wrong) is None
    off = struct.pack(f"<HHI{channels}H", magic, 400, 8, *[0] * channels)
    assert json_backend.parse(off) == (8, (0.0, 0.0, 0.0, 0.0))


def test_an_answer_is_one_line_with_an_end_of_line_on_both_sides() -> None:
    line = json_backend.answer(
        step=3,
        dt_s=0.004,
        rates_body=(0.1, 0.2, 0.3),
        accel_body=(0.0, 0.0, -9.80665),
        p_ned=(1.0, 2.0, -3.0),
        v_ned=(4.0, 5.0, 6.0),
        quaternion=(1.0, 0.0, 0.0, 0.0),
        volts=16.0,
        amperes=2.5,
    )
    assert line[:1] == line[-1:] == b"\n"
    assert line.count(b"\n") == 2
    content = json.loads(line)
    assert int(content.pop("timestamp") * 1e6) == 12000
    assert content == {
        "imu": {"gyro": [0.1, 0.2, 0.3], "accel_body": [0.0, 0.0, -9.80665]},
        "position": [1.0, 2.0, -3.0],
        "velocity": [4.0, 5.0, 6.0],
        "quaternion": [1.0, 0.0, 0.0, 0.0],
        "battery": {"voltage": 16.0, "current": 2.5},
        "no_time_sync": 1,
    }
    times_s = [k * (0.004 + json_backend.EXTRA_S) for k in range(100_000)]
    assert {int((b - a) * 1e6) for a, b in pairwise(times_s)} == {4000}
