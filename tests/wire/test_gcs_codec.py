"""The ground station's codec against pymavlink, on every message and on what is no message."""

import math
import struct
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import CLASSES, peer_frame, same, value_of, with_crc
from pymavlink.dialects.v20 import ardupilotmega as mavlink

from gcs.mavlink import codec

HOT = (
    "HEARTBEAT",
    "LOCAL_POSITION_NED",
    "ATTITUDE",
    "GLOBAL_POSITION_INT",
    "BATTERY_STATUS",
    "NAMED_VALUE_FLOAT",
)
SIGNATURE = bytes(range(13))
# Ids that real autopilots send and the dialect lacks.
UNKNOWN_IDS = (8, 290)


def unknown_frame(msgid: int, payload: bytes, seed: int = 99) -> bytes:
    assert msgid not in mavlink.mavlink_map
    head = struct.pack("<BBBBBBBHB", 0xFD, len(payload), 0, 0, 5, 1, 1, msgid & 0xFFFF, msgid >> 16)
    return with_crc(head + payload, seed)


def assert_reads_like_pymavlink(raw: bytes) -> None:
    (theirs,) = mavlink.MAVLink(None).parse_buffer(raw)
    (frame,), malformed, unknown, *_ = codec.split(raw)
    assert (malformed, unknown) == (0, 0)
    assert (frame.sysid, frame.compid, frame.seq) == (
        theirs.get_srcSystem(),
        theirs.get_srcComponent(),
        theirs.get_seq(),
    )
    assert frame.msgid == theirs.get_msgId()
    assert frame.raw == raw
    ours = codec.fields(frame)
    assert type(ours).__name__ == theirs.get_type() == codec.name(frame.msgid)
    assert set(ours._fields) == set(theirs.get_fieldnames())
    for field in ours._fields:
        assert same(getattr(ours, field), value_of(theirs, field)), (theirs.get_type(), field)


@pytest.mark.parametrize("name", HOT)
@settings(max_examples=60)
@given(data=st.data())
def test_hot_message_with_random_payload_has_pymavlinks_fields(name: str, data: st.DataObject) -> None:
    size = CLASSES[name].unpacker.size
    payload = data.draw(st.binary(min_size=size, max_size=size))
    assert_reads_like_pymavlink(peer_frame(name, payload))


@pytest.mark.parametrize("name", HOT)
@pytest.mark.parametrize("seed", range(3))
def test_hot_message_cut_at_any_byte_has_pymavlinks_fields(name: str, seed: int) -> None:
    size = CLASSES[name].unpacker.size
    payload = bytes((37 * (seed + 1) * (i + 1)) % 255 + 1 for i in range(size))
    for length in range(1, size + 1):
        raw = peer_frame(name, payload[:length])
        assert len(raw) == 12 + length
        assert_reads_like_pymavlink(raw)


@pytest.mark.parametrize("name", HOT)
def test_payload_longer_than_known_is_read_as_far_as_known(name: str) -> None:
    size = CLASSES[name].unpacker.size
    assert_reads_like_pymavlink(peer_frame(name, bytes(range(1, size + 6))))


def test_every_message_is_read_like_pymavlink() -> None:
    for name, cls in CLASSES.items():
        size = cls.unpacker.size
        for payload in (
            bytes(size),
            bytes(i % 90 + 32 for i in range(size)),
            bytes(255 - i % 256 for i in range(size)),
        ):
            assert_reads_like_pymavlink(peer_frame(name, payload))


def values_of(cls: Any) -> dict[str, Any]:
    """Values of all fields of a message, each another."""
    given_values: dict[str, Any] = {}
    for index, (field, kind) in enumerate(zip(cls.fieldnames, cls.fieldtypes, strict=True)):
        length = cls.array_lengths[cls.orders[index]]
        if kind == "char":
            given_values[field] = "Skytender"[: length or 1]
        elif length:
            given_values[field] = [(i + index) % 100 for i in range(length)]
        else:
            given_values[field] = index + 0.5 if kind in ("float", "double") else index + 1
    return given_values


def test_every_message_is_written_like_pymavlink() -> None:
    for name, cls in CLASSES.items():
        given_values = values_of(cls)
        theirs = cls(**{k: v.encode() if isinstance(v, str) else v for k, v in given_values.items()})
        mav = mavlink.MAVLink(None, srcSystem=255, srcComponent=190)
        mav.seq = 200
        raw = codec.encode(name, 200, 255, 190, **given_values)
        assert raw == bytes(theirs.pack(mav)), name
        assert codec.encode(cls.id, 200, 255, 190, **given_values) == raw, name
        assert_reads_like_pymavlink(raw)


@settings(max_examples=100)
@given(
    st.lists(st.floats(width=32), min_size=11, max_size=11),
    st.integers(0, 2**32 - 1),
    st.tuples(*[st.integers(0, 255)] * 3),
    st.integers(0, 65535),
)
def test_packed_set_point_equals_pymavlinks(
    floats: list[float], time_boot_ms: int, ids: tuple[int, int, int], mask: int
) -> None:
    theirs = mavlink.MAVLink_set_position_target_local_ned_message(time_boot_ms, *ids, mask, *floats)
    mav = mavlink.MAVLink(None, srcSystem=255, srcComponent=190)
    msgid = codec.msgid("SET_POSITION_TARGET_LOCAL_NED")

    def pack(seq: int, sysid: int, compid: int, *values: Any) -> bytes:
        return codec.frame(codec.Message(msgid, values), seq, sysid, compid)

    assert pack(0, 255, 190, time_boot_ms, *floats, mask, *ids) == bytes(theirs.pack(mav))


def test_heartbeat_needs_no_protocol_version_and_extensions_are_optional() -> None:
    heartbeat = codec.encode("HEARTBEAT", 0, 255, 190, type=6, autopilot=8, base_mode=0, custom_mode=0, system_status=4)
    assert codec.fields(codec.split(heartbeat).frames[0]).mavlink_version == 3
    ack = codec.fields(codec.split(codec.encode("COMMAND_ACK", 0, 1, 1, command=400, result=0)).frames[0])
    assert ack == (400, 0, 0, 0, 0, 0)


def test_text_ends_at_its_first_nul_and_arrays_are_tuples() -> None:
    raw = peer_frame("STATUSTEXT", b"\x06" + b"armed\0hidden".ljust(50, b"\0"))
    assert codec.fields(codec.split(raw).frames[0]).text == "armed"
    battery = peer_frame("BATTERY_STATUS", bytes(54))
    assert codec.fields(codec.split(battery).frames[0]).voltages == (0,) * 10


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        ({"type": 256}, "HEARTBEAT.type cannot be 256"),
        ({"type": -1}, "HEARTBEAT.type cannot be -1"),
        ({"custom_mode": math.nan}, "HEARTBEAT.custom_mode cannot be nan"),
        ({"custom_mode": "GUIDED"}, "HEARTBEAT.custom_mode cannot be 'GUIDED'"),
        ({"colour": 1}, "HEARTBEAT has no field colour"),
    ],
)
def test_value_that_a_field_cannot_hold_is_named(change: dict[str, Any], complaint: str) -> None:
    good = {"type": 6, "autopilot": 8, "base_mode": 0, "custom_mode": 0, "system_status": 4}
    with pytest.raises(ValueError, match=complaint):
        codec.message("HEARTBEAT", **(good | change))


def test_missing_field_long_text_short_array_and_huge_float_are_named() -> None:
    with pytest.raises(ValueError, match="COMMAND_ACK needs result"):
        codec.message("COMMAND_ACK", command=1)
    with pytest.raises(ValueError, match=r"NAMED_VALUE_INT.name holds 10 bytes of text, not the 11"):
        codec.message("NAMED_VALUE_INT", time_boot_ms=0, name="a" * 11, value=1)
    rest = (0, 0, 0, 0, 0, 0, 0, [0] * 4, 0, 0)
    for voltages, said in (([1], "holds 10 values"), ([70000] * 10, "cannot be 70000")):
        with pytest.raises(ValueError, match=rf"BATTERY_STATUS.voltages {said}"):
            codec.frame(codec.Message(codec.msgid("BATTERY_STATUS"), (0, 0, 0, voltages, *rest)), 0, 1, 1)
    with pytest.raises(ValueError, match=r"NAMED_VALUE_FLOAT.value cannot be 1e\+300"):
        codec.message("NAMED_VALUE_FLOAT", time_boot_ms=0, name="x", value=1e300)
    with pytest.raises(ValueError, match="ATTITUDE takes 7 values"):
        codec.frame(codec.Message(codec.msgid("ATTITUDE"), (2,)), 0, 1, 1)
    with pytest.raises(ValueError, match=r"ATTITUDE.seq cannot be 256"):
        codec.frame(codec.Message(codec.msgid("ATTITUDE"), (0,) * 7), 256, 1, 1)


def test_message_outside_the_dialect_is_named() -> None:
    with pytest.raises(ValueError, match="NO_SUCH is no message"):
        codec.layout("NO_SUCH")
    with pytest.raises(ValueError, match="message id 8 is not in"):
        codec.layout(8)
    assert codec.name(8) == "UNKNOWN_8"
    assert codec.name(codec.msgid("PING")) == "PING"


def frames_of(count: int) -> list[bytes]:
    return [peer_frame(HOT[i % 6], bytes(range(1, CLASSES[HOT[i % 6]].unpacker.size + 1)), seq=i) for i in range(count)]


def test_packed_datagram_gives_every_frame_in_order() -> None:
    raws = frames_of(12)
    frames, malformed, unknown, *_ = codec.split(b"".join(raws))
    assert [frame.raw for frame in frames] == raws
    assert [frame.seq for frame in frames] == list(range(12))
    assert [frame.payload for frame in frames] == [raw[10:-2] for raw in raws]
    assert (malformed, unknown) == (0, 0)


@pytest.mark.parametrize(
    "garbage", [b"console text\r\n", b"\xfd", b"\xfd\xff\0", b"\xfe\x09\0" + bytes(14), bytes(300)]
)
def test_garbage_around_frames_is_skipped_and_each_run_counted(garbage: bytes) -> None:
    raws = frames_of(3)
    frames, malformed, *_ = codec.split(garbage + raws[0] + garbage + raws[1] + raws[2] + garbage)
    assert [frame.raw for frame in frames] == raws
    assert malformed == 3


def test_signed_frame_is_taken_with_its_signature() -> None:
    plain = frames_of(1)[0]
    signed = with_crc(plain[:2] + b"\x01" + plain[3:-2], CLASSES["HEARTBEAT"].crc_extra) + SIGNATURE
    frames, malformed, *_ = codec.split(signed + plain)
    assert [frame.raw for frame in frames] == [signed, plain]
    assert malformed == 0
    assert codec.fields(frames[0]) == codec.fields(frames[1])
    assert frames[0].payload == frames[1].payload


def test_signed_frame_with_a_cut_payload_reads_no_signature_byte() -> None:
    head = struct.pack("<BBBBBBBHB", 0xFD, 1, 1, 0, 0, 1, 1, 30, 0)
    signed = with_crc(head + b"\x05", CLASSES["ATTITUDE"].crc_extra) + SIGNATURE
    assert codec.fields(codec.split(signed).frames[0]) == (5, 0, 0, 0, 0, 0, 0)


@pytest.mark.parametrize("flags", [0x02, 0x03, 0x80])
def test_other_incompatibility_flags_are_malformed(flags: int) -> None:
    plain = frames_of(1)[0]
    strange = with_crc(plain[:2] + bytes([flags]) + plain[3:-2], CLASSES["HEARTBEAT"].crc_extra) + SIGNATURE
    assert codec.split(strange)[:3] == ([], 1, 0)


def test_any_single_wrong_byte_keeps_the_frame_out() -> None:
    good = frames_of(3)[2]
    for at in range(len(good)):
        for flip in (1, 0x80, 0xFF):
            bad = good[:at] + bytes([good[at] ^ flip]) + good[at + 1 :]
            known = [frame for frame in codec.split(bad).frames if frame.msgid in mavlink.mavlink_map]
            assert known == []


@pytest.mark.parametrize("msgid", UNKNOWN_IDS)
@pytest.mark.parametrize("seed", [0, 99, 255])
def test_unknown_message_is_delivered_and_counted_apart(msgid: int, seed: int) -> None:
    known, stranger = frames_of(1)[0], unknown_frame(msgid, b"\x01\x02\x03", seed)
    frames, malformed, unknown, *_ = codec.split(known + stranger + known + stranger)
    assert [frame.raw for frame in frames] == [known, stranger, known, stranger]
    assert (malformed, unknown) == (0, 2)
    with pytest.raises(ValueError, match=f"message id {msgid} is not in"):
        codec.fields(frames[1])


def test_unknown_message_must_join_its_neighbours_without_a_gap() -> None:
    stranger = unknown_frame(8, b"\x01\x02\x03")
    assert codec.split(b"text" + stranger)[:3] == ([], 1, 0)
    assert codec.split(stranger + b"text")[:3] == ([], 1, 0)


def test_garbage_rarely_passes_for_an_unknown_message() -> None:
    # Even with a perfect header and no gap, one checksum in 256 fits some seed: 2**8 of 2**16.
    head = struct.pack("<BBBBBBBHB", 0xFD, 3, 0, 0, 5, 1, 1, 8, 0) + b"\x01\x02\x03"
    taken = sum(codec.split(head + struct.pack("<H", crc)).unknown for crc in range(65536))
    assert taken == 256


@pytest.mark.parametrize("decoy", [b"\xfd", b"\xfe", b"\xfd\xff\0\0\0\1\1\0\0\0", b"\xfe\x08\0\0"])
def test_few_places_of_a_hostile_datagram_are_tried(decoy: bytes) -> None:
    good = frames_of(1)[0]
    room = bytes(300)  # so that each place has room for the frame that it may begin
    assert [frame.raw for frame in codec.split(decoy * (codec.MOST_TRIES - 1) + room + good).frames] == [good]
    assert codec.split(decoy * codec.MOST_TRIES + room + good)[:3] == ([], 1, 0)


@settings(max_examples=300)
@given(st.lists(st.one_of(st.binary(max_size=40), st.just(b"\xfd"), st.sampled_from(frames_of(6)))))
def test_any_bytes_split_without_error_and_frames_are_found_in_place(pieces: list[bytes]) -> None:
    datagram = b"".join(pieces)
    frames, malformed, unknown, *_ = codec.split(datagram)
    covered = sum(len(frame.raw) for frame in frames)
    assert covered <= len(datagram)
    assert (malformed > 0) == (covered < len(datagram))
    at = 0
    for frame in frames:
        at = datagram.index(frame.raw, at) + len(frame.raw)
    assert unknown == sum(frame.msgid not in mavlink.mavlink_map for frame in frames)


@settings(max_examples=100)
@given(st.integers(0, 200), st.integers(1, 6))
def test_truncated_datagram_gives_its_whole_frames(cut: int, count: int) -> None:
    raws = frames_of(count)
    datagram = b"".join(raws)[: -cut or None] if cut < sum(map(len, raws)) else b""
    ends = [sum(map(len, raws[: i + 1])) for i in range(count)]
    frames, malformed, *_ = codec.split(datagram)
    whole = sum(end <= len(datagram) for end in ends)
    assert [frame.raw for frame in frames] == raws[:whole]
    assert malformed == (len(datagram) not in (0, *ends))


@settings(max_examples=300)
@given(st.binary(min_size=50, max_size=50))
def test_a_text_that_was_read_can_be_sent_on_whatever_its_bytes_are(raw: bytes) -> None:
    (frame,) = codec.split(peer_frame("STATUSTEXT", b"\x06" + raw + b"\0" * 3)).frames
    content = codec.fields(frame)
    sent_on = codec.frame(codec.Message(frame.msgid, tuple(content)), 0, 1, 1)
    again = codec.fields(codec.split(sent_on).frames[0])
    assert again.text == content.text.replace("\ufffd", "?")
