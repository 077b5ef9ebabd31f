"""Signatures of both programs against pymavlink's: each signs what the other accepts, and refuses what it refuses."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import common

from gcs.mavlink import codec
from simvehicle.mavlink import codec as vehicle_codec
from simvehicle.mavlink import signing as vehicle_signing
from simvehicle.mavlink.signing import VehicleSigning
from skytender import signing
from skytender.signing import SignatureVerdict, Signing

THREAT_MODEL = Path(__file__).resolve().parents[2] / "docs" / "threat-model.md"
KEY, OTHER = bytes(range(32)), bytes(range(1, 33))
NOW = signing.ticks(time.time())
FIELDS = {"type": 6, "autopilot": 8, "base_mode": 0, "custom_mode": 0, "system_status": 4}


def peer(key: bytes = KEY, *, sysid: int = 255, stamp: int = NOW, link_id: int = 3) -> Any:
    """pymavlink at the other end."""
    mav = common.MAVLink(None, sysid, 190)
    mav.signing.secret_key = key
    mav.signing.sign_outgoing = True
    mav.signing.link_id = link_id
    mav.signing.timestamp = stamp
    return mav


def beat(mav: Any) -> bytes:
    return bytes(common.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3).pack(mav))


def plain(seq: int = 0) -> bytes:
    return codec.encode("HEARTBEAT", seq, 7, 1, **FIELDS)


class Ours:
    """The ground station's signing, or the vehicle's, by one way of asking."""

    def __init__(self, program: str, key: bytes | None = KEY, **how: Any) -> None:
        self.program = program
        self.gcs = Signing(key, **how) if program == "gcs" and key is not None else None
        self.vehicle = VehicleSigning(1, key, **how) if program == "simvehicle" else None

    def sign(self, raw: bytes, now: int = NOW) -> bytes:
        return self.gcs.sign(raw, codec.seed_of(raw), 5, now) if self.gcs else self.vehicle.sign(raw, 5, now)  # type: ignore[union-attr]

    def judge(self, raw: bytes, now: int = NOW) -> str:
        if self.vehicle is not None:
            (frame,) = vehicle_codec.split(raw)
            return str(self.vehicle.judge(frame, now))
        (own,) = codec.split(raw).frames
        return str(self.gcs.judge(raw, own.msgid, now) if self.gcs else signing.without_key(raw))


@pytest.fixture(params=["gcs", "simvehicle"])
def program(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def test_pymavlink_accepts_what_is_signed_here_and_refuses_it_with_another_key(program: str) -> None:
    ours = Ours(program)
    frames = [ours.sign(plain(seq)) for seq in range(3)]
    receiver = peer(stamp=NOW - 10)
    for seq, raw in enumerate(frames):
        (message,) = receiver.parse_buffer(raw)
        assert (message.get_type(), message.get_seq(), message.get_signed(), message.get_link_id()) == (
            "HEARTBEAT", seq, True, 5,
        )  # fmt: skip
    assert [int.from_bytes(raw[-12:-6], "little") for raw in frames] == [NOW, NOW + 1, NOW + 2]
    stranger = peer(OTHER)
    stranger.robust_parsing = True
    assert [m.get_type() for m in stranger.parse_buffer(frames[0]) or ()] != ["HEARTBEAT"]


def test_what_pymavlink_signs_counts_once(program: str) -> None:
    ours, station = Ours(program), peer()
    first, second = beat(station), beat(station)
    assert ours.judge(first) == "good"
    assert ours.judge(second) == "good"
    assert ours.judge(second) == SignatureVerdict.STALE
    assert ours.judge(first) == SignatureVerdict.STALE
    assert ours.judge(beat(peer(sysid=254))) == "good"  # a stream of its own


def test_another_key_a_flipped_bit_and_no_signature_are_refused(program: str) -> None:
    ours = Ours(program)
    assert ours.judge(beat(peer(OTHER))) == SignatureVerdict.WRONG
    raw = beat(peer())
    for at in range(len(raw) - 13, len(raw)):  # of link id, time stamp and hash: a bit before is the checksum's
        assert ours.judge(raw[:at] + bytes([raw[at] ^ 1]) + raw[at + 1 :]) == SignatureVerdict.WRONG
    assert ours.judge(plain()) == SignatureVerdict.UNSIGNED
    assert ours.judge(raw) == "good"


def test_without_a_key_what_is_signed_is_refused_and_the_rest_is_not(program: str) -> None:
    ours = Ours(program, None)
    assert ours.judge(beat(peer())) == SignatureVerdict.NO_KEY
    assert ours.judge(plain()) == "good"


@pytest.mark.parametrize(("name", "verdict"), [("RADIO_STATUS", "good"), ("COMMAND_LONG", SignatureVerdict.UNSIGNED)])
def test_a_short_list_may_come_unsigned(program: str, name: str, verdict: str) -> None:
    layout = codec.layout(name)
    raw = codec.encode(name, 0, 51, 68, **dict.fromkeys(layout.record._fields, 0))
    assert Ours(program).judge(raw) == verdict


def test_a_new_stream_may_be_a_minute_behind_and_no_more(program: str) -> None:
    minute = 60 * signing.TICKS_PER_S
    assert Ours(program).judge(beat(peer(stamp=NOW - minute))) == "good"
    assert Ours(program).judge(beat(peer(stamp=NOW - minute - 10))) == SignatureVerdict.STALE
    # where the clock was set back, by what was used before
    behind = Ours(program, latest=NOW)
    assert behind.judge(beat(peer(stamp=NOW - minute - 10)), 0) == SignatureVerdict.STALE


def test_a_stamp_from_years_ahead_keeps_new_streams_out_as_by_pymavlink_and_the_threat_model_says_so(
    program: str,
) -> None:
    """Streams that are known go on; a program that starts anew knows none of it."""
    ours, theirs = Ours(program), peer(sysid=9)
    known, new = peer(sysid=2), peer(sysid=3)
    ahead = peer(sysid=1, stamp=NOW + 3 * 31_557_600 * signing.TICKS_PER_S)
    said = [(beat(each), verdict) for each, verdict in ((known, "good"), (ahead, "good"), (known, "good"))]
    for raw, verdict in (*said, (beat(new), SignatureVerdict.STALE)):
        assert ours.judge(raw) == verdict
        try:
            (heard,) = theirs.parse_buffer(raw)
        except common.MAVError:
            heard = None
        assert (heard is not None) == (verdict == "good")
    assert Ours(program).judge(beat(new)) == "good"
    text = THREAT_MODEL.read_text(encoding="utf-8")
    assert "one message signed with the key and dated years ahead" in text
    assert "ArduPilot and PX4 do the same" in text


def test_an_earlier_runs_frames_are_stale_and_its_stamps_are_not_used_again(program: str) -> None:
    first = Ours(program)
    raw = beat(peer())
    assert first.judge(raw) == "good"
    known = first.gcs or (first.vehicle and first.vehicle.current)
    assert known
    again = Ours(program, latest=known.latest, streams=known.streams)
    assert again.judge(raw) == SignatureVerdict.STALE
    signed = again.sign(plain(), 0)
    assert int.from_bytes(signed[-12:-6], "little") > NOW


def test_streams_are_bounded(program: str) -> None:
    most = 1024 if program == "gcs" else vehicle_signing.MOST_STREAMS
    ours = Ours(program, streams={(s >> 8, s & 0xFF, 9): 1 for s in range(most)})
    assert ours.judge(beat(peer())) == SignatureVerdict.STALE


def setup(key: bytes, target: int = 1) -> Any:
    return common.MAVLink_setup_signing_message(target, 1, list(key), NOW)


def test_a_key_is_set_by_anybody_while_there_is_none_and_then_only_by_who_has_it() -> None:
    keys: list[bytes | None] = []
    vehicle = VehicleSigning(1, on_key=keys.append)

    def give(raw: bytes) -> str:
        (frame,) = vehicle_codec.split(raw)
        why = vehicle.judge(frame, NOW)
        if why is not SignatureVerdict.GOOD:
            return str(why)
        return "set up" if vehicle.take_setup(frame) else "passed"

    unsigned = common.MAVLink(None, 255, 190)
    assert give(bytes(setup(KEY, target=2).pack(unsigned))) == "set up"  # another vehicle's: not passed on either
    assert not vehicle.has_key
    assert give(bytes(setup(KEY).pack(unsigned))) == "set up"
    assert give(beat(unsigned)) == SignatureVerdict.UNSIGNED
    assert give(bytes(setup(OTHER).pack(unsigned))) == SignatureVerdict.UNSIGNED
    assert give(bytes(setup(OTHER).pack(peer(OTHER)))) == SignatureVerdict.WRONG
    assert give(bytes(setup(OTHER).pack(peer()))) == "set up"
    assert give(beat(peer())) == SignatureVerdict.WRONG
    assert give(bytes(setup(bytes(32)).pack(peer(OTHER, stamp=NOW + 9)))) == "set up"
    assert give(beat(unsigned)) == "passed"
    assert keys == [KEY, OTHER, None]


def test_no_key_is_set_while_the_vehicle_is_armed() -> None:
    keys: list[bytes | None] = []
    vehicle = VehicleSigning(1, on_key=keys.append)
    (frame,) = vehicle_codec.split(bytes(setup(KEY).pack(common.MAVLink(None, 255, 190))))
    assert vehicle.take_setup(frame, armed=True)  # nor passed on
    assert (vehicle.has_key, keys) == (False, [])


def test_a_key_has_32_bytes(program: str) -> None:
    with pytest.raises(ValueError, match="32 bytes, not 31"):
        Ours(program, bytes(31))


def test_who_has_used_up_all_time_stamps_signs_on_and_is_refused(program: str) -> None:
    """A key's holder, or whoever sets up the signing of a vehicle without a key, may tell any time stamp."""
    last = (1 << 48) - 1
    ours = Ours(program, latest=last - 1)
    frames = [ours.sign(plain(seq)) for seq in range(3)]
    assert [int.from_bytes(raw[-12:-6], "little") for raw in frames] == [last] * 3
    receiver = Ours("gcs", streams={(7, 1, 5): last - 1})
    assert [receiver.judge(raw) for raw in frames] == ["good", SignatureVerdict.STALE, SignatureVerdict.STALE]


@pytest.mark.parametrize("size", range(12))
def test_what_is_too_short_to_be_a_frame_is_neither_signed_nor_accepted(size: int) -> None:
    own = Signing(KEY)
    with pytest.raises(ValueError, match=f"a frame has at least 12 bytes, not {size}"):
        own.sign(plain()[:size], codec.seed_of(plain()), 5, NOW)
    assert own.judge(b"\xfd\x00\x01" + bytes(max(size - 3, 0)), 0, NOW) != SignatureVerdict.GOOD


def test_a_stamp_kept_from_an_earlier_run_that_no_signature_can_hold_is_taken_for_the_last_one() -> None:
    assert Signing(KEY, latest=1 << 200).latest == signing.LAST_STAMP
