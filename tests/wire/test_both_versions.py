"""Every message of pymavlink's dialects in MAVLink 1 and 2: on the air, in a stream, in a recording and exported.

What pymavlink packs and reads is the truth. Of `all`, the messages beyond `ardupilotmega` stand for those that the
table lacks: they are no loss, and nothing around them is."""

from __future__ import annotations

import csv
import socket
import struct
from pathlib import Path
from typing import Any

import pytest
from oracle import made, same, values_of
from pymavlink.dialects.v10 import all as every1
from pymavlink.dialects.v20 import all as every2
from pymavlink.dialects.v20 import ardupilotmega

from gcs.link.listener import Listener
from gcs.mavlink import codec, dialect, field_units
from gcs.mavlink.codec import Frame
from gcs.mavlink.frame_stream import FrameStream
from gcs.mavlink.gaps import GapCounter
from gcs.recording import export, tables, tlog_reader
from gcs.scenario.endpoint import address

VERSIONS = {1: every1, 2: every2}
T0_US = 1_767_225_600_000_000
SYSID = 7


def spoken(version: int) -> list[tuple[str, bytes]]:
    """(name, frame) of every message, numbered one after the other, as one vehicle sends them."""
    module = VERSIONS[version]
    sender = module.MAVLink(None, srcSystem=SYSID, srcComponent=1)
    frames = []
    for cls in module.mavlink_map.values():
        if version == 2 or cls.id < 256:
            frames.append((cls.msgname, bytes(made(cls, values_of(cls)).pack(sender))))
            sender.seq = (sender.seq + 1) % 256
    return frames


def read_by_pymavlink(version: int, raw: bytes) -> dict[str, Any]:
    (message,) = VERSIONS[version].MAVLink(None).parse_buffer(raw)
    return {name: getattr(message, name) for name in message.get_fieldnames()}


def assert_all_read(version: int, frames: list[Frame], kept_out: tuple[str, ...] = ()) -> None:
    """Each known message with pymavlink's fields, each unknown one by its number; none lost."""
    sent = [(name, raw) for name, raw in spoken(version) if name not in kept_out]
    assert len(frames) == len(sent)
    gaps = GapCounter()
    gaps.feed_all(frames)
    assert gaps.lost == len(spoken(version)) - len(sent)
    unread = set()
    for frame, (name, raw) in zip(frames, sent, strict=True):
        if frame.msgid not in ardupilotmega.mavlink_map:
            unread.add(name)
            continue
        assert codec.name(frame.msgid) == name
        content = codec.fields(frame)._asdict()
        for field, value in read_by_pymavlink(version, raw).items():
            assert same(content.pop(field), tuple(value) if isinstance(value, list) else value), (name, field)
        for value in content.values():  # of extension fields, which MAVLink 1 lacks
            assert not any(value) if isinstance(value, tuple) else not value, name
    known = {cls.msgname for cls in ardupilotmega.mavlink_map.values()}
    assert unread == {name for name, _ in sent} - known


def test_both_dialects_are_in_the_table() -> None:
    assert {"AHRS", "EKF_STATUS_REPORT", "MEMINFO", "HEARTBEAT", "OPEN_DRONE_ID_LOCATION"} <= {
        cls.msgname for cls in ardupilotmega.mavlink_map.values()
    }
    assert max(ardupilotmega.mavlink_map) < 1 << 16  # as tables by message id hold


@pytest.mark.parametrize("version", VERSIONS)
def test_a_datagram_of_each(version: int) -> None:
    frames = []
    for _, raw in spoken(version):
        split = codec.split(raw)
        assert split.malformed == 0
        assert (len(split.frames), len(split.older)) == ((0, 1) if version == 1 else (1, 0))
        frames += split.frames + split.older
    assert_all_read(version, frames)
    split = codec.split(b"".join(raw for _, raw in spoken(version)))
    assert split.malformed == 0
    assert_all_read(version, split.frames + split.older)


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("piece", [1, 7, 300])
def test_a_stream_in_pieces(version: int, piece: int) -> None:
    whole, stream, frames, malformed = b"".join(raw for _, raw in spoken(version)), FrameStream(), [], 0
    for at in range(0, len(whole), piece):
        split = stream.feed(whole[at : at + piece])
        frames += split.frames + split.older
        malformed += split.malformed
    assert malformed == 0
    assert_all_read(version, frames)


@pytest.mark.parametrize("version", VERSIONS)
def test_on_the_air(version: int) -> None:
    at = address("udpin:127.0.0.1:0")
    assert at is not None
    listener = Listener(at, older=True)
    frames: list[Frame] = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as vehicle:
        for _, raw in spoken(version):
            vehicle.sendto(raw, ("127.0.0.1", listener.connection.port))
            listener.wait(5.0)
            for found, _ in listener.receive():
                frames += found
    listener.close()
    assert_all_read(version, frames, ("SETUP_SIGNING",) if version == 2 else ())  # it carries a key


def recorded(version: int, path: Path) -> Path:
    path.write_bytes(b"".join(struct.pack(">Q", T0_US + 1000 * k) + raw for k, (_, raw) in enumerate(spoken(version))))
    return path


@pytest.mark.parametrize("version", VERSIONS)
def test_in_a_recording(version: int, tmp_path: Path) -> None:
    log = tlog_reader.read(recorded(version, tmp_path / "all.tlog"))
    assert_all_read(version, [frame for _, frame in log])
    assert log.problems == []


@pytest.mark.parametrize("version", VERSIONS)
def test_exported(version: int, tmp_path: Path) -> None:
    source = recorded(version, tmp_path / "all.tlog")
    written = tables.tables("csv", tmp_path)
    assert export.export(source, written) == []
    written.close()
    named = {name for name, _ in spoken(version)}
    known = {cls.msgname for cls in ardupilotmega.mavlink_map.values()} & named
    assert known <= written.rows.keys() <= known | {"UNKNOWN"}
    assert sum(written.rows.values()) == len(spoken(version))
    for cls in ardupilotmega.mavlink_map.values():
        if cls.msgname in known:
            shape = field_units.layout(cls.id)
            assert shape is not None
            with (tmp_path / f"{cls.msgname}.csv").open(newline="") as file:
                (row,) = csv.DictReader(file)
            assert list(row) == [*field_units.OWN, *(column.name for column in shape.columns)]


def test_a_frame_turned_into_mavlink_1_is_what_pymavlink_packs() -> None:
    for _, raw in spoken(1):
        split = codec.split(raw)
        (frame,) = split.older
        if split.unknown:
            with pytest.raises(ValueError, match="cannot be sent in MAVLink 1"):
                dialect.older_form(frame.raw)
        else:
            assert dialect.older_form(frame.raw) == raw


def test_extension_fields_and_a_signature_are_left_out_in_mavlink_1() -> None:
    sender = every2.MAVLink(None, srcSystem=SYSID, srcComponent=1)
    sender.signing.secret_key, sender.signing.sign_outgoing = b"k" * 32, True
    for cls in every2.mavlink_map.values():
        if cls.id >= 256 or cls.id not in ardupilotmega.mavlink_map:
            continue
        (old,) = (other for other in every1.mavlink_map.values() if other.id == cls.id)
        plain = every1.MAVLink(None, srcSystem=SYSID, srcComponent=1)
        plain.seq = sender.seq
        message = made(cls, values_of(cls))
        values = [getattr(message, field) for field in old.fieldnames]
        expected = old(*(v.encode() if isinstance(v, str) else v for v in values)).pack(plain)
        assert dialect.older_form(bytes(message.pack(sender))) == bytes(expected), cls.msgname
        sender.seq = (sender.seq + 1) % 256
