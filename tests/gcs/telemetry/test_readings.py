"""Readings by compiled code, against pymavlink's decoding of the frames that it sent."""

import math
import random
import struct
from typing import Any, cast

import numpy as np
import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import battery as battery_module
from gcs.mavlink import codec
from gcs.telemetry import energy, fleet, plausibility, readings
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.readings import FOUND, TelemetryReader, new_readings
from gcs.telemetry.track import Member

ORIGIN = GlobalOrigin(47.397742, 8.545594, 488.0)
NOTHING = readings.kept_elsewhere((), ())


def silent_account() -> Any:
    """Of a battery of which BATTERY_STATUS has said nothing for long."""
    account = energy.new_account(1e4, 5e3)
    account["first_hand_s"] = -100.0
    return account


def read_alone(data: bytes, now_s: float, row: Any, account: Any, found: Any) -> tuple[int, int]:
    """Read frames of a fleet's only vehicle: where the next one begins, and why it stops."""
    reader = TelemetryReader(np.zeros(256, np.int64), row[np.newaxis], account, NOTHING, found)
    return cast(tuple[int, int], reader.read(data, 0, len(data), 0, now_s))


class Read:
    """One frame, as pymavlink sends and reads it, and what the kernel makes of it."""

    def __init__(self, name: str, payload: bytes, row: Any = None, now_s: float = 5.0) -> None:
        cls = getattr(mav, f"MAVLink_{name.lower()}_message")
        body = payload.rstrip(b"\0") or b"\0"
        head = struct.pack("<BBBBBBHB", len(body), 0, 0, 7, 3, 1, cls.id & 0xFFFF, cls.id >> 16)
        crc = codec.mcrf4xx(head + body + bytes([cls.crc_extra]))
        raw = b"\xfd" + head + body + struct.pack("<H", crc)
        (self.content,) = mav.MAVLink(None).parse_buffer(raw)
        self.row = new_readings() if row is None else row
        self.account, self.found = silent_account(), np.zeros(FOUND)
        end, self.why = read_alone(raw, now_s, self.row, self.account, self.found)
        assert end == (0 if self.why == readings.ELSEWHERE else len(raw))

    def told(self, *columns: int) -> list[float]:
        return list(self.row[list(columns)])


def payloads(name: str, count: int) -> list[bytes]:
    """Payloads of any bytes, many with zeros at their end, which are cut on the wire."""
    rng = random.Random(name)
    size = getattr(mav, f"MAVLink_{name.lower()}_message").unpacker.size
    return [rng.randbytes(kept).ljust(size, b"\0") for kept in (rng.randrange(size + 1) for _ in range(count))]


def floats(count: int) -> list[bytes]:
    rng = random.Random(count)
    return [struct.pack(f"<I{count}f", rng.randrange(1 << 32), *(rng.uniform(-9.0, 9.0) for _ in range(count)))
            for _ in range(200)]  # fmt: skip


def test_places_are_read_as_pymavlink_reads_them() -> None:
    believed = 0
    for payload in [*floats(6), *payloads("LOCAL_POSITION_NED", 600)]:
        one = Read("LOCAL_POSITION_NED", payload)
        c = one.content
        told = [c.x, c.y, c.z, c.vx, c.vy, c.vz]
        possible = all(map(math.isfinite, told)) and max(map(abs, told[:3])) <= plausibility.FARTHEST_M
        possible = possible and math.hypot(*told[3:]) <= plausibility.FASTEST_M_S
        assert one.why == (readings.END if possible else readings.PLACE)
        if possible:
            assert one.told(readings.NORTH, readings.EAST, readings.DOWN) == told[:3]
            assert one.told(readings.V_NORTH, readings.V_EAST, readings.V_DOWN) == told[3:]
            assert one.told(readings.POSITION_S) == [5.0]
            believed += 1
    assert 220 < believed < 700


def test_a_place_is_as_old_as_its_vehicles_clock_says_and_none_older_follows() -> None:
    row = new_readings()
    row[readings.CLOCK_S] = 2.0
    for boot_ms, north, position_s, kept in ((1500, 1.0, 3.5, 1.0), (1400, 2.0, 3.5, 1.0), (9000, 3.0, 5.0, 3.0)):
        Read("LOCAL_POSITION_NED", struct.pack("<I6f", boot_ms, north, 0, 0, 0, 0, 0), row)
        assert list(row[[readings.POSITION_S, readings.NORTH]]) == [position_s, kept]


def test_attitudes_are_read_as_pymavlink_reads_them() -> None:
    for payload in [*floats(6), *payloads("ATTITUDE", 600)]:
        one = Read("ATTITUDE", payload)
        c = one.content
        heading = c.yaw if abs(c.yaw) <= math.tau else 0.0
        roll, pitch = (c.roll, c.pitch) if math.isfinite(c.roll) and math.isfinite(c.pitch) else (0.0, 0.0)
        assert one.why == readings.END
        assert one.told(readings.HEADING, readings.ROLL, readings.PITCH) == [heading, roll, pitch]


def test_modes_are_read_as_pymavlink_reads_them_and_told_once() -> None:
    for payload in payloads("HEARTBEAT", 500):
        one = Read("HEARTBEAT", payload)
        c = one.content
        assert one.why == readings.MODE
        columns = readings.AUTOPILOT, readings.CUSTOM_MODE, readings.BASE_MODE, readings.SYSTEM_STATUS
        assert one.told(*columns) == [c.autopilot, c.custom_mode, c.base_mode, c.system_status]
        assert Read("HEARTBEAT", payload, one.row, 6.0).why == readings.END
        assert one.told(readings.RECEIVED_S) == [6.0]


@pytest.mark.parametrize(("name", "convert"), [("BATTERY_STATUS", battery_module.battery_status),
                                               ("SYS_STATUS", battery_module.sys_status)])  # fmt: skip
def test_batteries_are_counted_as_by_their_reports(name: str, convert: Any) -> None:
    """The other path: pymavlink's fields, gcs/mavlink/battery.py, and the kernel that is called with a report."""
    rng = random.Random(5)
    size = getattr(mav, f"MAVLink_{name.lower()}_message").unpacker.size
    told = 0
    for payload in payloads(name, 1500):
        usual = bytearray(payload)
        if name == "BATTERY_STATUS" and rng.random() < 0.8:
            cells = [rng.choice([4000, 4000, 65535, 0]) for _ in range(10)]
            if rng.random() < 0.3:
                cells = [4000] * 10
                struct.pack_into("<4H", usual, 41, *(rng.choice([4000, 65535, 0]) for _ in range(4)))
            rest = rng.choice([-1, -100, 0, 1310]), 0, 0, 1, rng.choice([-1, 0, 80, 100, 101])
            struct.pack_into("<ih10HhBBBb", usual, 4, rng.choice([-1, 0, 50, 5000]), 0, *cells, *rest)
        elif rng.random() < 0.8:
            struct.pack_into("<Hh", usual, 14, rng.choice([0, 16_000, 65535]), rng.choice([-1, -100, 0, 1310]))
        one = Read(name, bytes(usual[:size]))
        if name == "BATTERY_STATUS" and (one.content.id != 0 or one.content.battery_function > 2):
            assert one.why == readings.ELSEWHERE
            continue
        report = convert(one.content, 5.0)
        words = [math.nan if word is None else word for word in report[1:4]]
        account = silent_account()
        fate, *facts = outcome = energy.take(account, 5.0, *words, report.second_hand, False)
        assert one.account.tobytes() == account.tobytes()
        assert one.row[readings.POWER_W] == account["power_w"][0]
        more = fate < energy.SECOND_HAND or account["power_source"][0] != energy.NONE or not np.isnan(facts).all()
        assert one.why == (readings.BATTERY if more else readings.END)
        if more:
            np.testing.assert_array_equal(one.found, [*words[:2], *outcome])
        told += more
    assert told > 250


def test_a_message_that_tells_nothing_new_changes_a_fleet_as_if_it_were_read_like_the_first(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Counters, origins and homes that recur, of one of ours and of an external vehicle, held against each message in
    turn given to what reads it for the first time."""
    rng = random.Random(4)
    members = [Member(3, "pursuer", "3", 24_000.0, 18_000.0), Member(4, "pursuer", "4", 2e4, 1e4, external=True)]
    usual, each = Fleet(members, ORIGIN), Fleet(members, ORIGIN)
    read: list[int] = []
    for msgid, handler in fleet._HANDLERS.items():
        monkeypatch.setitem(
            cast(dict[int, Any], fleet._HANDLERS), msgid,
            lambda *args, handler=handler, msgid=msgid: read.append(msgid) or handler(*args),
        )  # fmt: skip
    handled = 0
    for tick in range(800):
        sysid, boot_ms = rng.choice([3, 4]), 100 * tick - rng.randrange(300)
        if rng.random() < 0.01:
            joules = rng.randrange(100)
            usual.book(sysid, joules)
            each.book(sysid, joules)
        place = {"latitude": rng.choice([473977420, 473977420, 473977999]), "longitude": 85455940, "altitude": 488000}
        raw = rng.choice([
            codec.encode("NAMED_VALUE_INT", 0, sysid, 1, time_boot_ms=max(boot_ms, 0),
                         name=rng.choice(["XferIn", "XferOut", "Xfer", "XferOuts", ""]),
                         value=rng.choice([-1, tick // 100, tick // 100, 1_000_000_000])),
            codec.encode("GPS_GLOBAL_ORIGIN", 0, sysid, 1, **place, time_usec=0),
            codec.encode("HOME_POSITION", 0, sysid, 1, **place, x=0.0, y=0.0, z=float(rng.randrange(2)), q=[1, 0, 0, 0],
                         approach_x=0.0, approach_y=0.0, approach_z=0.0, time_usec=0),
            codec.encode("HEARTBEAT", 0, sysid, 1, type=2, autopilot=12, base_mode=rng.choice([0, 128]), custom_mode=0,
                         system_status=3),
        ])  # fmt: skip
        (frame,) = codec.split(raw).frames
        usual.ingest(frame, 0.1 * tick)
        handled += len(read)
        read.clear()
        if frame.msgid in fleet._HANDLERS:
            track = each._tracks[sysid]
            each.note_message(sysid, 0.1 * tick)
            fleet._HANDLERS[frame.msgid](each, track, codec.fields(frame), 0.1 * tick)
            each._settle(track)
            read.clear()
        else:
            each.ingest(frame, 0.1 * tick)
        views = [repr(one.snapshot(0.1 * tick)) for one in (usual, each)]
        assert views[0] == views[1]
        assert usual.snapshot(0.1 * tick).columns.changed.tolist() == each.snapshot(0.1 * tick).columns.changed.tolist()
    assert 80 < handled < 480


def test_efforts_and_landed_states_are_read_as_pymavlink_reads_them() -> None:
    names = [b"CtlEffort", b"CtlEffort\0", b"CtlEffortX", b"CtlEffor", b"XtlEffort", b""]
    for name in names:
        for value in (0.0, 1.5, -1.0, math.nan, math.inf, 2e12):
            one = Read("NAMED_VALUE_FLOAT", struct.pack("<If10s", 4000, value, name))
            believed = one.content.name == "CtlEffort" and 0.0 <= value <= readings.MOST_EFFORT
            assert one.told(readings.EFFORT) == [value if believed else 0.0]
            assert math.isnan(one.row[readings.EFFORT_S]) != believed
    for state in range(6):
        one = Read("EXTENDED_SYS_STATE", bytes([0, state]))
        on_ground = one.content.landed_state in (mav.MAV_LANDED_STATE_ON_GROUND, mav.MAV_LANDED_STATE_UNDEFINED)
        assert one.told(readings.LANDED_REPORTED, readings.LANDED) == [1.0, on_ground]


def test_nothing_is_read_of_other_components_and_beyond_the_end() -> None:
    raw = codec.encode("ATTITUDE", 0, 3, 100, time_boot_ms=0, roll=1.0, pitch=1.0, yaw=1.0, rollspeed=0.0,
                       pitchspeed=0.0, yawspeed=0.0)  # fmt: skip
    lying = b"\xfd\xff\0\0\0\x03\x01\x1e\0\0" + raw[10:14]
    for data in (raw, lying, raw[:9], b""):
        row = new_readings()
        _, why = read_alone(data, 5.0, row, energy.new_account(1.0, 1.0), np.zeros(FOUND))
        assert why == readings.END
        assert row[readings.ROLL] == 0.0
