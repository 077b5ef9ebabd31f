"""Component metadata read from a scripted vehicle that hosts PX4's kind of files: relative paths, xz as PX4's build
writes it, its checksum, files on the internet with a fallback of its own."""

from __future__ import annotations

import json
import lzma
from typing import Any

import newer
import pytest
from arducopter_files import Files
from pymavlink.dialects.v20 import common as mav

from gcs.cli import parameter_meanings
from gcs.mavlink import codec
from gcs.mavlink.metadata.client import EVENTS, PARAMETER, MetadataClient, MetadataRefused

OUT = mav.MAVLink(None, srcSystem=3, srcComponent=1)
GENERAL = "etc/extras/component_general.json.xz"
ROWS = [
    {"name": "MPC_XY_CRUISE", "type": "Float", "units": "m/s", "shortDesc": "Cruise speed", "min": 3, "max": 20.5},
    {"name": "CAL_ACC{n}_ID", "type": "Int32", "shortDesc": "Id of accelerometer {n}", "rebootRequired": True},
]
PARAMETERS = json.dumps({"version": 3, "parameters": ROWS}).encode()


def crc32(content: bytes) -> int:
    """As PX4's generate_crc.py counts it, bit by bit."""
    crc = 0
    for byte in content:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xEDB88320 if crc & 1 else 0)
    return crc


class Vehicle:
    """COMPONENT_METADATA, and the files behind it; `ack` is its answer to the request."""

    def __init__(self, named: list[dict[str, Any]], files: dict[str, bytes], **general: Any) -> None:
        raw = general.get("raw") or lzma.compress(json.dumps({"version": 1, "metadataTypes": named}).encode())
        self.ack = general.get("ack", mav.MAV_RESULT_ACCEPTED)
        self.crc = general.get("crc", crc32(raw))
        self.files = Files({GENERAL: raw, **files})

    def hear(self, heard: Any) -> list[Any]:
        if heard.get_type() == "FILE_TRANSFER_PROTOCOL":
            return self.files.hear(heard)
        assert (heard.command, heard.param1) == (mav.MAV_CMD_REQUEST_MESSAGE, 397.0)
        ack = mav.MAVLink_command_ack_message(heard.command, self.ack)
        if self.ack != mav.MAV_RESULT_ACCEPTED:
            return [ack]
        uri = f"mftp://{GENERAL}".encode()
        return [ack, newer.dialect.MAVLink_component_metadata_message(1, self.crc, uri)]


def read(vehicle: Vehicle | None, *wanted: int) -> MetadataClient:
    client, now_s = MetadataClient(3, 1, wanted or None), 0.0
    while not client.done:
        assert now_s < 60.0
        for message in client.poll(now_s):
            (heard,) = OUT.parse_buffer(codec.frame(message, 0, 255, 190)) or []
            for answer in vehicle.hear(heard) if vehicle else ():
                (frame,) = codec.split(bytes(answer.pack(OUT))).frames
                client.receive(codec.name(frame.msgid), codec.fields(frame), now_s)
        now_s += 0.05
    return client


def one(content: bytes, path: str = "etc/extras/parameters.json", **more: Any) -> Vehicle:
    named = {"type": PARAMETER, "uri": f"mftp://{path}", "fileCrc": crc32(content), **more}
    return Vehicle([named], {path: content})


@pytest.mark.parametrize("packed", [False, True])
def test_meanings_of_parameters_come_from_the_vehicle(packed: bool) -> None:
    content = lzma.compress(PARAMETERS, preset=9) if packed else PARAMETERS
    client = read(one(content, f"etc/extras/parameters.json{'.xz' * packed}"))
    assert client.problem == ""
    meanings = client.parameters()
    assert parameter_meanings.lines("MPC_XY_CRUISE", {"3": meanings}) == ["Cruise speed  [m/s]  3..20.5"]
    numbered = parameter_meanings.of("CAL_ACC0_ID", meanings)
    assert numbered is not None
    assert numbered.text == "Id of accelerometer {n}  after a reboot"
    assert parameter_meanings.of("CAL_GYRO0_ID", meanings) is None


def test_a_file_on_the_internet_is_left_for_the_vehicles_own() -> None:
    path = "etc/extras/parameters.json.xz"
    packed = lzma.compress(PARAMETERS)
    more = {"uri": "https://px4.io/p.json.xz", "uriFallback": f"mftp://[;comp=1]{path}"}
    vehicle = one(packed, path, **more, fileCrc=1, fileCrcFallback=crc32(packed))
    assert "MPC_XY_CRUISE" in read(vehicle).parameters()
    away = Vehicle([{"type": PARAMETER, "uri": "https://px4.io/p.json.xz"}], {})
    assert read(away).problem == "it names 'https://px4.io/p.json.xz', which is no file of its own"


def test_only_what_is_wanted_is_read() -> None:
    vehicle = one(PARAMETERS)
    assert PARAMETER not in read(vehicle, EVENTS).files


BOMB = lzma.compress(b"0" * (1 << 26))


@pytest.mark.parametrize(
    ("vehicle", "why"),
    [
        (None, "it does not answer a request for COMPONENT_METADATA"),
        (Vehicle([], {}, ack=mav.MAV_RESULT_UNSUPPORTED), "it has no metadata (UNSUPPORTED)"),
        (Vehicle([], {}, crc=7), f"the checksum of {GENERAL} is wrong"),
        (Vehicle([], {}, raw=b"no xz" * 9), f"{GENERAL} cannot be unpacked: Input format not supported by decoder"),
        (Vehicle([], {}, raw=lzma.compress(b"{}")), "missing required field `version`"),
        (Vehicle([], {}, raw=lzma.compress(b"\xff{")), "is not as the standard has it"),
        (Vehicle([{"type": 1, "uri": "mftp://gone"}], {}), "gone: it has no such file"),
        (one(BOMB, "bomb.json.xz"), "bomb.json.xz has more than 33554432 bytes, or ends early"),
        (one(lzma.compress(PARAMETERS)[:-20], "cut.json.xz"), "bytes, or ends early"),
    ],
)  # fmt: skip
def test_a_file_that_is_not_what_it_is_said_to_be_is_refused(vehicle: Vehicle | None, why: str) -> None:
    client = read(vehicle)
    assert why in client.problem
    assert client.parameters() == {}


def test_a_file_with_another_shape_is_refused() -> None:
    client = read(one(b'{"version": 3, "parameters": [{"name": 5}]}'))
    with pytest.raises(MetadataRefused, match="Expected `str`, got `int`"):
        client.parameters()
