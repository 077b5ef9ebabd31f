"""Figure 1: decoding and encoding against pymavlink, the same bytes in the same rounds."""

from __future__ import annotations

import random

from measure import Figure, cpu_times
from pymavlink.dialects.v20 import common

from gcs.mavlink import batch, codec

VEHICLES = 254
SET_POINTS = 500


def hot_frames() -> list[bytes]:
    """One tick of a full fleet: the six hot messages of each vehicle."""
    rng = random.Random(1)
    frames = []
    for sysid in range(1, VEHICLES + 1):
        mav = common.MAVLink(None, srcSystem=sysid, srcComponent=1)
        n, e, d, *rest = [rng.uniform(-50.0, 50.0) for _ in range(6)]
        for message in (
            common.MAVLink_heartbeat_message(2, 12, 217, 6 << 16, 4, 3),
            common.MAVLink_attitude_message(61_200, 0.1 * n, 0.01 * e, 0.01 * d, *rest),
            common.MAVLink_local_position_ned_message(61_200, n, e, d, *rest),
            common.MAVLink_global_position_int_message(61_200, 473977420, 85455940, 500_000, 12_000, 12, -3, 5, 9000),
            common.MAVLink_battery_status_message(
                0, 0, 1, 32767, [4000] * 4 + [65535] * 6, 1310, 100, 50 + sysid, 80, 100, 1
            ),
            common.MAVLink_named_value_float_message(61_200, b"CtlEffort", abs(n)),
        ):
            frames.append(bytes(message.pack(mav)))
            mav.seq = (mav.seq + 1) % 256
    return frames


def figures() -> list[Figure]:
    frames = hot_frames()
    data, count = b"".join(frames), len(frames)
    packed = [b"".join(frames[i : i + 6]) for i in range(0, count, 6)]
    peer = common.MAVLink(None)
    peer.robust_parsing = False

    def one_by_one() -> None:
        for datagram in packed:
            for frame in codec.split(datagram).frames:
                codec.fields(frame)

    ours_s, single_s, peer_s = cpu_times(
        lambda: batch.decode(data), one_by_one, lambda: [peer.parse_buffer(datagram) for datagram in packed]
    )
    pack = codec.packer("SET_POSITION_TARGET_LOCAL_NED")
    values = (61_200, 1.5, -2.5, -5.0, 0.5, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3520, 7, 1, 1)
    sender = common.MAVLink(None, srcSystem=255, srcComponent=190)
    message = common.MAVLink_set_position_target_local_ned_message
    fields = (61_200, 7, 1, 1, 3520, 1.5, -2.5, -5.0, 0.5, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert pack(0, 255, 190, *values) == bytes(message(*fields).pack(sender))
    encode_s, peer_encode_s = cpu_times(
        lambda: [pack(7, 255, 190, *values) for _ in range(SET_POINTS)],
        lambda: [message(*fields).pack(sender) for _ in range(SET_POINTS)],
    )
    unit, pymavlink = "messages/CPU s", "pymavlink parse_buffer"
    return [
        Figure(1, "decode, a tick of 254 vehicles", count / ours_s, unit, 9.0, False, True, pymavlink, count / peer_s),
        Figure(1, "decode, datagram by datagram", count / single_s, unit, peer=pymavlink, peer_value=count / peer_s),
        Figure(
            1, "encode set points", SET_POINTS / encode_s, unit, 4.0, False, True, "pymavlink pack",
            SET_POINTS / peer_encode_s,
        ),
    ]  # fmt: skip
