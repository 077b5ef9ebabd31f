"""What the network may throw at a vehicle: nothing of it is obeyed that should not be, and nothing after it is lost."""

import math
import random
import struct
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

ACCEPTED, DENIED = 0, 2
ARM = mav.MAV_CMD_COMPONENT_ARM_DISARM
REAL32 = mav.MAV_PARAM_TYPE_REAL32
NAN, INF = math.nan, math.inf


def framed(message: Any, seq: int = 0, source: tuple[int, int] = (255, 190)) -> bytes:
    writer = mav.MAVLink(None, *source)
    writer.seq = seq
    return bytes(message.pack(writer))


def arming(system: int = 1, component: int = 1) -> Any:
    return mav.MAVLink_command_long_message(system, component, ARM, 0, 1.0, *[0.0] * 6)


def ping(seq: int) -> Any:
    return mav.MAVLink_ping_message(1, seq, 0, 0)


def pinged(answers: list[Any]) -> list[int]:
    return [m.seq for m in answers if m.get_type() == "PING"]


def still_obeys(bench: Any) -> None:
    """An order after it all is acknowledged once and carried out."""
    assert bench.arm() == ACCEPTED
    assert bench.vehicle.armed
    bench.tick()
    assert all(map(math.isfinite, bench.vehicle.state[0]))


def test_frame_cut_short_anywhere_is_not_obeyed_and_the_next_one_is(vehicle_bench: Any) -> None:
    whole = framed(arming())
    for length in range(len(whole)):
        bench = vehicle_bench()
        answers = bench.feed(whole[:length] + framed(ping(length)))
        assert not bench.vehicle.armed
        assert pinged(answers) == [length]
    still_obeys(bench)


def test_each_flipped_bit_makes_a_frame_worthless_and_costs_none_beside_it(vehicle_bench: Any) -> None:
    """A flipped length may swallow what follows in its datagram, as it must; the next datagram is whole again."""
    whole = framed(arming())
    bench = vehicle_bench()
    for bit in range(8 * len(whole)):
        broken = bytearray(whole)
        broken[bit // 8] ^= 1 << bit % 8
        answers = bench.feed(framed(ping(1)) + bytes(broken) + framed(ping(2)))
        assert not bench.vehicle.armed, f"bit {bit}"
        assert pinged(answers) in ([1, 2], [1]), f"bit {bit}"
        assert 2 in pinged(answers) + pinged(bench.feed(framed(ping(2)))), f"bit {bit}"
    still_obeys(bench)


def test_oversized_datagram_of_noise_hides_no_frame(vehicle_bench: Any) -> None:
    noise = random.Random(3).randbytes(60_000).replace(b"\xfd", b"\xfc")
    bench = vehicle_bench()
    assert pinged(bench.feed(noise + framed(ping(5)) + noise)) == [5]
    still_obeys(bench)


def test_payload_longer_than_its_message_is_read_as_far_as_it_is_known(vehicle_bench: Any) -> None:
    """Newer dialects lengthen messages; what stands behind is none of this dialect's."""
    cls = mav.MAVLink_command_long_message
    payload = struct.pack("<7fHBBB", 1.0, *[0.0] * 6, ARM, 1, 1, 0) + bytes(range(1, 30))
    raw = bytes(mav.MAVLink_message(cls.id, cls.msgname)._pack(mav.MAVLink(None, 255, 190), cls.crc_extra, payload))
    bench = vehicle_bench()
    (ack,) = bench.feed(raw)
    assert (ack.result, bench.vehicle.armed) == (ACCEPTED, True)


@pytest.mark.parametrize("msgid", [8, 380, 441, 52_000, 0xFFFFFF])
def test_unknown_id_is_passed_over_in_its_datagram(vehicle_bench: Any, msgid: int) -> None:
    stranger = bytes(mav.MAVLink_message(msgid, "X")._pack(mav.MAVLink(None, 255, 190), 77, b"\x01\x02\x03"))
    bench = vehicle_bench()
    assert pinged(bench.feed(framed(ping(1)) + stranger + framed(ping(2)))) == [1, 2]
    still_obeys(bench)


def test_old_protocol_is_not_answered(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    assert bench.feed(bytes(arming().pack(mav.MAVLink(None, 255, 190), force_mavlink1=True))) == []
    still_obeys(bench)


ADDRESSED = {
    "command": arming,
    "command int": lambda s, c: mav.MAVLink_command_int_message(s, c, 0, ARM, 0, 0, 1.0, 0, 0, 0, 0, 0, 0.0),
    "set point": lambda s, c: mav.MAVLink_set_position_target_local_ned_message(0, s, c, 1, 3576, 1, 1, -1, *[0] * 8),
    "parameter": lambda s, c: mav.MAVLink_param_set_message(s, c, b"MPC_XY_CRUISE", 1.0, REAL32),
    "parameters": mav.MAVLink_param_request_list_message,
    "mission": lambda s, c: mav.MAVLink_mission_count_message(s, c, 1, 0),
    "clearing": lambda s, c: mav.MAVLink_mission_clear_all_message(s, c, 255),
    "stream": lambda s, c: mav.MAVLink_request_data_stream_message(s, c, 0, 50, 1),
    "files": lambda s, c: mav.MAVLink_file_transfer_protocol_message(0, s, c, [0] * 251),
}


@pytest.mark.parametrize("target", [(2, 1), (1, 77), (254, 0)])
@pytest.mark.parametrize("what", ADDRESSED)
def test_what_is_meant_for_another_changes_nothing_and_is_not_answered(
    vehicle_bench: Any, what: str, target: tuple[int, int]
) -> None:
    bench, twin = vehicle_bench(), vehicle_bench()
    assert bench.send(ADDRESSED[what](*target)) == []
    said, expected = ([(m.get_type(), m.get_msgbuf()) for b in (each,) for m in b.tick(20)] for each in (bench, twin))
    assert said == expected
    assert bench.vehicle.parameters.values() == twin.vehicle.parameters.values()
    still_obeys(bench)


def test_mode_message_for_another_changes_nothing(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    bench.send(mav.MAVLink_set_mode_message(2, 1, 4 << 16 | 6 << 24))
    assert bench.vehicle.mode == "hold"


def test_replayed_frames_act_as_once(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    frames = [framed(arming(), 0), framed(mav.MAVLink_command_long_message(1, 1, 22, 0, *[NAN] * 7), 1)]
    for raw in frames * 5:
        (ack,) = bench.feed(raw)
        assert ack.result == ACCEPTED
    bench.tick()
    assert bench.texts == ["Armed", "Take-off"]
    assert bench.vehicle.home_ned == (0.0, 0.0, 0.0)


def test_plain_frames_count_in_whatever_order_their_numbers_come(vehicle_bench: Any) -> None:
    """Sequence numbers of a plain connection tell of loss; they are no reason to drop an order."""
    bench = vehicle_bench()
    shuffled = list(range(20))
    random.Random(7).shuffle(shuffled)
    answers = bench.feed(b"".join(framed(ping(i), seq=i) for i in shuffled))
    assert pinged(answers) == shuffled
    still_obeys(bench)


def test_own_echo_is_not_obeyed(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    assert bench.feed(framed(arming(), source=(1, 1))) == []
    assert not bench.vehicle.armed


@pytest.mark.parametrize("bad", [NAN, INF, -INF])
@pytest.mark.parametrize(
    ("command", "slots"),
    [
        (ARM, (1,)),
        (mav.MAV_CMD_NAV_TAKEOFF, (7,)),
        (mav.MAV_CMD_DO_REPOSITION, (5, 6, 7)),
        (mav.MAV_CMD_DO_CHANGE_SPEED, (2,)),
        (mav.MAV_CMD_DO_SET_HOME, (5, 6, 7)),
        (mav.MAV_CMD_SET_MESSAGE_INTERVAL, (2,)),
        (mav.MAV_CMD_DO_PAUSE_CONTINUE, (1,)),
        (mav.MAV_CMD_USER_1, (1, 2, 3, 4, 5, 6)),
    ],
)
def test_number_that_is_none_is_denied_or_counts_as_unset(
    vehicle_bench: Any, command: int, slots: tuple[int, ...], bad: float
) -> None:
    for slot in slots:
        bench = vehicle_bench().in_air()
        height = -bench.vehicle.p_ned[2]
        params = [1.0, 1.0, 100.0, 100.0, 47.3978, 8.5456, 488.0 + height]
        if command == mav.MAV_CMD_DO_SET_HOME:
            params[0] = 0.0
        params[slot - 1] = bad
        result = bench.result(command, *params)
        unset = math.isnan(bad) and command in (
            mav.MAV_CMD_NAV_TAKEOFF, mav.MAV_CMD_DO_CHANGE_SPEED, mav.MAV_CMD_SET_MESSAGE_INTERVAL,
            mav.MAV_CMD_DO_REPOSITION,
        )  # fmt: skip
        assert (result == DENIED) != unset, f"parameter {slot} of {command}: {result}"
        bench.fly(2.0)
        assert all(map(math.isfinite, bench.vehicle.state[0]))
        assert -bench.vehicle.p_ned[2] == pytest.approx(height, abs=0.3)
        assert bench.vehicle.armed


def test_storm_of_noise_between_orders_loses_none_of_them(vehicle_bench: Any) -> None:
    chance = random.Random(11)
    bench = vehicle_bench().in_air()
    for seq in range(200):
        noise = b"\xfd" + chance.randbytes(chance.randrange(12, 300))
        noise = noise[:1] + bytes([len(noise) % 20]) + noise[2:]
        bench.feed(noise)
        assert pinged(bench.send(ping(seq))) == [seq]
    bench.fly(1.0)
    assert bench.vehicle.mode == "hold"
