"""Compiled bundles against the frames that pymavlink packs of the same messages."""

import math

import numpy as np
import pytest
from pymavlink.dialects.v20 import common

from gcs.link.bundles import Recipients
from gcs.link.link import TickGrants
from gcs.mavlink import bundle_frames
from gcs.mavlink.bundle_frames import LEFT_OUT, NONE, write_bundles
from gcs.mavlink.ids import STATION
from gcs.mavlink.setpoints import PlacedSetPoints

VEHICLES = 40
UNIX_US = 1_767_225_600_000_000
SPECIAL = (0.0, -0.0, 1e-46, -3e-39, 3.4028234e38, -3.4028235e38, math.inf, -math.inf, 16777217.0)


def packed(message: common.MAVLink_message, number: int) -> bytes:
    sender = common.MAVLink(None, srcSystem=STATION[0], srcComponent=STATION[1])
    sender.seq = number
    return bytes(message.pack(sender))


def set_point(time_ms: int, sysid: int, values: list[float]) -> common.MAVLink_message:
    mask = 0b1101_1100_0000  # acceleration, yaw and yaw rate are to be ignored
    return common.MAVLink_set_position_target_local_ned_message(
        time_ms, sysid, 1, common.MAV_FRAME_LOCAL_NED, mask, *values, 0.0, 0.0, 0.0, 0.0, 0.0
    )


@pytest.mark.parametrize("seed", range(20))
def test_bundles_are_what_pymavlink_packs(seed: int) -> None:
    random = np.random.default_rng(seed)
    values = random.normal(size=(VEHICLES, 6)) * 10.0 ** random.integers(-40, 38, (VEHICLES, 6)).astype(float)
    special = random.random((VEHICLES, 6)) < 0.2
    values[special] = random.choice(SPECIAL, special.sum())
    time_ms = (0, 5, 1 << 24, (1 << 32) - 1, int(random.integers(1 << 32)))[seed % 5]
    unix_us = (0, UNIX_US, (1 << 63) - 1)[seed % 3]
    rows, markers = np.zeros((VEHICLES, bundle_frames.COLUMNS), np.int64), np.zeros((VEHICLES, 32), np.uint8)
    expected, frames, numbers = [], [], []
    templates = bundle_frames.made_templates()
    for k in range(VEHICLES):
        number, sysid, marker = int(random.integers(256)), int(random.integers(1, 255)), random.bytes(26 * (seed % 2))
        point, heartbeat_due = int(random.choice([k, NONE, LEFT_OUT], p=[0.7, 0.2, 0.1])), bool(random.random() < 0.3)
        rows[k] = number, sysid, len(marker), point, heartbeat_due
        markers[k, : len(marker)] = list(marker)
        told = [common.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)] * heartbeat_due
        told += [set_point(time_ms, sysid, values[k].tolist())] * (point == k)
        told += [common.MAVLink_system_time_message(unix_us, time_ms)]
        own = [packed(message, (number + n) % 256) for n, message in enumerate(told)] if point != LEFT_OUT else []
        expected.append(marker + b"".join(own) if own else b"")
        frames += own
        numbers.append((number + len(own)) % 256)
    out = np.empty(VEHICLES * bundle_frames.BUNDLE_BYTES, np.uint8)
    cuts, spans = np.empty((VEHICLES, 3), np.int64), np.empty((VEHICLES * bundle_frames.MOST_FRAMES, 2), np.int64)
    for told_ms in ((time_ms + 255) % (1 << 32), time_ms):  # nothing of an earlier tick is left
        again = rows.copy()
        end, refused = write_bundles(out, again, markers, values, *templates, cuts, spans, told_ms, unix_us, told_ms)
    assert refused == NONE
    raw, spans = out[:end].tobytes(), spans[: cuts[-1, 2]]
    assert [raw[begin:end] for begin, end, _ in cuts] == expected
    assert raw == b"".join(expected)
    assert [raw[begin:end] for begin, end in spans] == frames
    assert again[:, bundle_frames.NUMBER].tolist() == numbers


@pytest.mark.parametrize("value", [3.5e38, -1e39, 3.40282357e38])
def test_a_set_point_that_no_frame_can_hold_is_refused_as_the_codec_does(value: float) -> None:
    values = np.zeros((2, 6))
    values[1, 4] = value
    keys = [(7, 1), (8, 1)]
    recipients = Recipients(keys, [b"", b""], [("127.0.0.1", 1), ("127.0.0.1", 2)])
    with pytest.raises(ValueError, match=r"^SET_POSITION_TARGET_LOCAL_NED\.vy cannot be "):
        recipients.bundled((), TickGrants(0, 0, keys, (), PlacedSetPoints(0, (7, 8), values), {}))
