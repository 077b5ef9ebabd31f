"""The vehicle's codec against pymavlink, on what a vehicle sends and obeys, and on what is no message."""

import itertools
import struct
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import peer_frame, same, with_crc
from pymavlink.dialects.v20 import common

from simvehicle.mavlink import codec
from simvehicle.mavlink.dispatcher import UNDERSTOOD
from simvehicle.mavlink.telemetry import TELEMETRY

CLASSES: dict[int, Any] = dict(common.mavlink_map)
ANSWERS = (
    common.MAVLINK_MSG_ID_COMMAND_ACK,
    common.MAVLINK_MSG_ID_STATUSTEXT,
    common.MAVLINK_MSG_ID_PARAM_VALUE,
    common.MAVLINK_MSG_ID_AUTOPILOT_VERSION,
    common.MAVLINK_MSG_ID_MESSAGE_INTERVAL,
    common.MAVLINK_MSG_ID_SYSTEM_TIME,
    common.MAVLINK_MSG_ID_ADSB_VEHICLE,
    common.MAVLINK_MSG_ID_PARAM_ERROR,
    common.MAVLINK_MSG_ID_MISSION_ACK,
    common.MAVLINK_MSG_ID_MISSION_ITEM_REACHED,
)
SPOKEN = sorted({stream.msgid for stream in TELEMETRY} | UNDERSTOOD | set(ANSWERS))
RANGES = {"b": (-128, 127), "B": (0, 255), "h": (-(2**15), 2**15 - 1), "H": (0, 2**16 - 1)} | {
    "i": (-(2**31), 2**31 - 1),
    "I": (0, 2**32 - 1),
    "q": (-(2**63), 2**63 - 1),
    "Q": (0, 2**64 - 1),
}


def name_of(msgid: int) -> str:
    return str(CLASSES[msgid].msgname)


def peer(seq: int = 7, sysid: int = 3, compid: int = 1) -> Any:
    mav = common.MAVLink(None, srcSystem=sysid, srcComponent=compid)
    mav.seq = seq
    return mav


def assert_reads_like_pymavlink(raw: bytes) -> None:
    (theirs,) = common.MAVLink(None).parse_buffer(raw)
    (frame,) = codec.split(raw)
    assert frame.raw == raw
    ids = (theirs.get_srcSystem(), theirs.get_srcComponent(), theirs.get_seq(), theirs.get_msgId())
    assert (frame.sysid, frame.compid, frame.seq, frame.msgid) == ids
    ours: Any = codec.decode(frame)
    assert type(ours).__name__ == theirs.get_type()
    assert set(ours._fields) == set(theirs.get_fieldnames())
    for field in ours._fields:
        value = getattr(theirs, field)
        if isinstance(value, str) and not value.isascii():
            continue  # pymavlink guesses an encoding, the vehicle shows a replacement character
        assert same(getattr(ours, field), value), field


def field_values(msgid: int) -> st.SearchStrategy[dict[str, Any]]:
    """Values that the fields of a message hold, by name."""
    cls = CLASSES[msgid]
    formats = cls.unpacker.format[1:]
    letters: list[str] = []
    count = ""
    for letter in formats:
        if letter.isdigit():
            count += letter
            continue
        letters.extend([letter] if letter == "s" else [letter] * int(count or 1))
        count = ""
    strategies: dict[str, st.SearchStrategy[Any]] = {}
    at = 0
    for name, length in zip(cls.ordered_fieldnames, cls.array_lengths, strict=True):
        letter = letters[at]
        if letter == "s":
            strategies[name] = st.text(st.characters(min_codepoint=32, max_codepoint=126), max_size=length)
            at += 1
            continue
        one: st.SearchStrategy[Any] = st.integers(*RANGES[letter]) if letter in RANGES else st.floats(width=64)
        if letter == "f":
            one = st.floats(width=32)
        strategies[name] = st.tuples(*[one] * length) if length else one
        at += length or 1
    return st.fixed_dictionaries(strategies)


@pytest.mark.parametrize("msgid", SPOKEN, ids=name_of)
@settings(max_examples=25)
@given(data=st.data())
def test_message_with_any_values_is_written_and_read_like_pymavlinks(msgid: int, data: st.DataObject) -> None:
    values = data.draw(field_values(msgid))
    raw = codec.encode(codec.message(name_of(msgid))(**values), seq=7, sysid=3, compid=1)
    cls = CLASSES[msgid]
    theirs = cls(**{k: v.encode() if isinstance(v, str) else v for k, v in values.items()})
    assert raw == bytes(theirs.pack(peer()))
    (frame,) = codec.split(raw)
    ours: Any = codec.decode(frame)
    assert same(tuple(ours), tuple(values[field] for field in cls.ordered_fieldnames))


@pytest.mark.parametrize("msgid", SPOKEN, ids=name_of)
@settings(max_examples=25)
@given(data=st.data())
def test_message_with_any_payload_of_any_length_is_read_like_pymavlink(msgid: int, data: st.DataObject) -> None:
    size = CLASSES[msgid].unpacker.size
    assert_reads_like_pymavlink(peer_frame(name_of(msgid), data.draw(st.binary(min_size=1, max_size=size))))


def test_payload_longer_than_known_is_read_as_far_as_known() -> None:
    for msgid in SPOKEN:
        size = CLASSES[msgid].unpacker.size
        assert_reads_like_pymavlink(peer_frame(name_of(msgid), bytes(i % 90 + 32 for i in range(min(size + 5, 255)))))


def heartbeat(seq: int = 0) -> bytes:
    return bytes(common.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3).pack(peer(seq, 255, 190)))


def test_signed_frame_is_taken_whole_and_its_signature_is_no_content() -> None:
    plain = heartbeat()
    signed = with_crc(plain[:2] + b"\x01" + plain[3:-2], CLASSES[0].crc_extra) + bytes(range(13))
    frames = list(codec.split(signed + plain))
    assert [frame.raw for frame in frames] == [signed, plain]
    assert codec.decode(frames[0]) == codec.decode(frames[1])
    assert list(codec.split(signed[:-1])) == []


@pytest.mark.parametrize("flags", [0x02, 0x03, 0x80])
def test_frame_with_an_unknown_incompatibility_flag_is_passed_over(flags: int) -> None:
    plain = heartbeat()
    assert list(codec.split(with_crc(plain[:2] + bytes([flags]) + plain[3:-2], CLASSES[0].crc_extra))) == []


def test_mavlink_1_is_passed_over() -> None:
    old = bytes(common.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3).pack(peer(), force_mavlink1=True))
    assert [frame.seq for frame in codec.split(old + heartbeat(9) + old)] == [9]


def test_any_single_wrong_byte_keeps_the_frame_out() -> None:
    good = heartbeat()
    for at, flip in itertools.product(range(len(good)), (1, 0x80, 0xFF)):
        assert list(codec.split(good[:at] + bytes([good[at] ^ flip]) + good[at + 1 :])) == [], at


@pytest.mark.parametrize("msgid", [8, 380, 11030, 0xFFFFFF])
def test_unknown_id_is_passed_over_and_its_neighbours_are_read(msgid: int) -> None:
    assert msgid not in common.mavlink_map
    head = struct.pack("<BBBBBBBHB", 0xFD, 3, 0, 0, 5, 1, 1, msgid & 0xFFFF, msgid >> 16)
    stranger = with_crc(head + b"\x01\x02\x03", 99)
    assert [frame.seq for frame in codec.split(heartbeat(1) + stranger + heartbeat(2))] == [1, 2]
    assert codec.decode(codec.ReceivedFrame(1, 1, 0, msgid, b"", b"")) is None


@settings(max_examples=300)
@given(st.lists(st.one_of(st.binary(max_size=40), st.just(b"\xfd"), st.just(heartbeat()))))
def test_garbage_raises_nothing_invents_nothing_and_hides_no_frame(pieces: list[bytes]) -> None:
    datagram = b"".join(pieces)
    frames = list(codec.split(datagram))
    assert all(frame.raw == heartbeat() for frame in frames)
    assert len(frames) == datagram.count(heartbeat())


@settings(max_examples=100)
@given(st.integers(0, 100), st.integers(1, 5))
def test_truncated_datagram_gives_its_whole_frames(cut: int, count: int) -> None:
    datagram = b"".join(heartbeat(seq) for seq in range(count))
    datagram = datagram[: max(len(datagram) - cut, 0)]
    assert [frame.seq for frame in codec.split(datagram)] == list(range(len(datagram) // len(heartbeat())))


@pytest.mark.parametrize("decoy", [b"\xfd", b"\xfd\xff\0\0\0\1\1\0\0\0"])
def test_few_places_of_a_hostile_datagram_are_tried(decoy: bytes) -> None:
    room = bytes(300)  # so that each place has room for the frame that it may begin
    assert len(codec.split(decoy * (codec.MOST_TRIES - 1) + room + heartbeat())) == 1
    assert codec.split(decoy * codec.MOST_TRIES + room + heartbeat()) == []


def test_nothing_is_kept_of_ids_that_the_dialect_does_not_know() -> None:
    before = len(codec._rows)
    for msgid in range(20_000, 24_000):
        assert codec.schema(msgid) is None
        assert list(codec.split(with_crc(struct.pack("<BBBBBBBHB", 0xFD, 1, 0, 0, 0, 1, 1, msgid, 0) + b"x", 0))) == []
    assert len(codec._rows) == before


def test_text_ends_at_its_first_nul_and_is_utf_8() -> None:
    raw = peer_frame("STATUSTEXT", b"\x06" + b"armed\0hidden".ljust(50, b"\0"))
    (frame,) = codec.split(raw)
    assert codec.decode(frame).text == "armed"  # type: ignore[union-attr]
    content = codec.message("STATUSTEXT")(severity=6, text="5 µs", id=0, chunk_seq=0)
    (frame,) = codec.split(codec.encode(content, seq=0, sysid=1, compid=1))
    assert codec.decode(frame).text == "5 µs"  # type: ignore[union-attr]
