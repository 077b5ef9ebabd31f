"""Signing keys and their time stamps on disk."""

from __future__ import annotations

import json
import stat
from pathlib import Path

import pytest
from commands import gcs
from pymavlink.dialects.v20 import common

from gcs.link.keys import LinkSigning, RefusalNotices, SignatureGate, new_key
from gcs.mavlink import codec
from simvehicle.mavlink import codec as vehicle_codec
from simvehicle.sitl.keys import Keyring
from skytender.key_files import AHEAD_TICKS, KeyRefused, read_key
from skytender.signing import SignatureVerdict, ticks

NOW_S = 1_800_000_000.0


class Clock:
    now_s = NOW_S

    def __call__(self) -> float:
        return self.now_s


@pytest.fixture
def key_file(tmp_path: Path) -> Path:
    path = tmp_path / "fleet.key"
    new_key(path)
    return path


def frame() -> bytes:
    return codec.encode("PING", 0, 7, 1, time_usec=1, seq=2, target_system=0, target_component=0)


def stamp(signed: bytes) -> int:
    return int.from_bytes(signed[-12:-6], "little")


def test_a_new_key_is_random_for_its_user_alone_and_read_by_both_programs(tmp_path: Path) -> None:
    keys = []
    for name in ("one", "two"):
        assert gcs("key", "new", str(tmp_path / name)).returncode == 0
        assert stat.S_IMODE((tmp_path / name).stat().st_mode) == 0o600
        keys.append(read_key(tmp_path / name))
        (signed,) = codec.split(Keyring(7, tmp_path / name).signed(frame(), 0)).frames
        assert LinkSigning(tmp_path / name).judge(signed) is SignatureVerdict.GOOD
    assert keys[0] != keys[1]
    again = gcs("key", "new", str(tmp_path / "one"))
    assert (again.returncode, "exists already" in again.stderr) == (2, True)
    assert read_key(tmp_path / "one") == keys[0]


@pytest.mark.parametrize(
    ("content", "mode", "words"),
    [("ab" * 32, 0o644, "can be read by others: chmod 600"), ("ab" * 31, 0o600, "holds no key"),
     ("no key at all", 0o600, "holds no key"), ("\xff" * 64, 0o600, "holds no key")],
)  # fmt: skip
def test_a_file_that_is_no_key_or_that_others_can_read_is_refused(
    tmp_path: Path, content: str, mode: int, words: str
) -> None:
    path = tmp_path / "bad.key"
    path.write_bytes(content.encode("latin-1"))
    path.chmod(mode)
    with pytest.raises(KeyRefused, match=words):
        read_key(path)
    with pytest.raises(KeyRefused, match=words):
        Keyring(7, path)
    refused = gcs("monitor", "--connect", "udpin:127.0.0.1:0", "--key-file", str(path))
    assert (refused.returncode, words in refused.stderr) == (2, True)


def test_stamps_outlive_a_run_its_death_and_a_clock_that_is_set_back(key_file: Path) -> None:
    clock = Clock()
    first = LinkSigning(key_file, clock=clock)
    last = max(stamp(first.sign(frame())) for _ in range(5))
    assert last == ticks(NOW_S) + 4
    stamps = key_file.with_name("fleet.key.stamps")
    assert stat.S_IMODE(stamps.stat().st_mode) == 0o600
    clock.now_s -= 3600.0
    killed = LinkSigning(key_file, clock=clock)
    assert last < stamp(killed.sign(frame())) <= ticks(NOW_S) + AHEAD_TICKS + 1
    first.close()
    assert json.loads(stamps.read_text())["latest"] == last


def test_frames_of_an_earlier_run_cannot_be_sent_again(key_file: Path) -> None:
    clock = Clock()
    sender = LinkSigning(key_file, link_id=9, clock=clock)
    (old,) = codec.split(sender.sign(frame())).frames
    sender.close()
    receiver = LinkSigning(key_file, clock=clock)
    assert receiver.judge(old) is SignatureVerdict.GOOD
    receiver.close()
    assert LinkSigning(key_file, clock=clock).judge(old) is SignatureVerdict.STALE


@pytest.mark.parametrize(
    "content", [b"[" * 50_000, b"{}", b'{"latest": "x", "streams": []}', b'{"latest":1,"streams":[1]}']
)
def test_broken_stamps_are_refused_in_a_sentence(key_file: Path, content: bytes) -> None:
    key_file.with_name("fleet.key.stamps").write_bytes(content)
    with pytest.raises(KeyRefused, match="holds no time stamps: mend it, or delete it"):
        LinkSigning(key_file)


def test_a_gate_lets_signed_frames_pass_and_counts_the_others(key_file: Path) -> None:
    sender, gate = LinkSigning(key_file, link_id=1), SignatureGate(key_file)
    good, plain = codec.split(sender.sign(frame())).frames[0], codec.split(frame()).frames[0]
    assert gate.accepted([good, plain, good]) == [good]
    assert (gate.refused[7], gate.reasons[7]) == (2, SignatureVerdict.STALE)
    assert gate.signed(good.raw) == good.raw
    unlocked = SignatureGate(None)
    assert unlocked.accepted([good, plain]) == [plain]
    assert unlocked.reasons == {7: SignatureVerdict.NO_KEY}
    assert unlocked.signed(plain.raw) == plain.raw


def test_a_message_that_carries_a_key_passes_no_gate() -> None:
    setup = common.MAVLink_setup_signing_message(0, 0, [1] * 32, 5).pack(common.MAVLink(None, 7, 1))
    assert SignatureGate(None).accepted(codec.split(bytes(setup)).frames) == []


def test_refusals_are_told_at_once_and_then_from_time_to_time() -> None:
    notices, reasons = RefusalNotices(), {7: SignatureVerdict.WRONG}
    assert notices.poll({7: 1}, reasons, 0.0) == [(7, "1 message is refused: signed with another key")]
    assert notices.poll({7: 5}, reasons, 5.0) == []
    assert notices.poll({7: 9}, reasons, 10.0) == [(7, "8 messages are refused: signed with another key")]
    assert notices.poll({7: 9}, reasons, 99.0) == []


def test_a_key_that_a_vehicle_was_given_outlives_it_in_its_state(tmp_path: Path) -> None:
    setup = bytes(common.MAVLink_setup_signing_message(1, 1, [7] * 32, 5).pack(common.MAVLink(None, 255, 190)))
    keyring = Keyring(1, None, tmp_path)
    assert keyring.accepted(list(vehicle_codec.split(setup))) == []
    assert keyring.has_key
    keyring.close()
    assert read_key(tmp_path / "1.key") == bytes([7] * 32)
    assert Keyring(1, None, tmp_path).has_key
    assert not Keyring(1).has_key
