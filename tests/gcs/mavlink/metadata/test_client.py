"""Component metadata read from a scripted vehicle that hosts PX4's kind of files: relative paths, xz as PX4's build
writes it, its checksum, files on the internet with a fallback of its own."""

from __future__ import annotations

import json
import lzma
from types import SimpleNamespace
from typing import Any

import pytest
from dialogue import converse
from metadata_vehicle import GENERAL, MetadataVehicle, crc32
from pymavlink.dialects.v20 import common as mav

from gcs.cli import parameter_meanings
from gcs.mavlink.metadata.client import EVENTS, PARAMETER, MetadataClient, MetadataRefused

ROWS = [
    {"name": "MPC_XY_CRUISE", "type": "Float", "units": "m/s", "shortDesc": "Cruise speed", "min": 3, "max": 20.5},
    {"name": "CAL_ACC{n}_ID", "type": "Int32", "shortDesc": "Id of accelerometer {n}", "rebootRequired": True},
]
PARAMETERS = json.dumps({"version": 3, "parameters": ROWS}).encode()


def read(vehicle: MetadataVehicle | None, *wanted: int) -> MetadataClient:
    client = MetadataClient(3, 1, wanted or None)
    converse(client, vehicle or SimpleNamespace(hear=lambda _: []))
    return client


def one(content: bytes, path: str = "etc/extras/parameters.json", **more: Any) -> MetadataVehicle:
    named = {"type": PARAMETER, "uri": f"mftp://{path}", "fileCrc": crc32(content), **more}
    return MetadataVehicle([named], {path: content})


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
    away = MetadataVehicle([{"type": PARAMETER, "uri": "https://px4.io/p.json.xz"}], {})
    assert read(away).problem == "it names 'https://px4.io/p.json.xz', which is no file of its own"


def test_only_what_is_wanted_is_read() -> None:
    vehicle = one(PARAMETERS)
    assert PARAMETER not in read(vehicle, EVENTS).files


BOMB = lzma.compress(b"0" * (1 << 26))


@pytest.mark.parametrize(
    ("vehicle", "why"),
    [
        (None, "it does not answer a request for COMPONENT_METADATA"),
        (MetadataVehicle([], {}, ack=mav.MAV_RESULT_UNSUPPORTED), "it has no metadata (UNSUPPORTED)"),
        (MetadataVehicle([], {}, crc=7), f"the checksum of {GENERAL} is wrong"),
        (MetadataVehicle([], {}, raw=b"no xz" * 9), f"{GENERAL} cannot be unpacked: Input format not sup"),
        (MetadataVehicle([], {}, raw=lzma.compress(b"{}")), "missing required field `version`"),
        (MetadataVehicle([], {}, raw=lzma.compress(b"\xff{")), "is not as the standard has it"),
        (MetadataVehicle([{"type": 1, "uri": "mftp://gone"}], {}), "gone: it has no such file"),
        (one(BOMB, "bomb.json.xz"), "bomb.json.xz has more than 33554432 bytes, or ends early"),
        (one(lzma.compress(PARAMETERS)[:-20], "cut.json.xz"), "bytes, or ends early"),
    ],
)  # fmt: skip
def test_a_file_that_is_not_what_it_is_said_to_be_is_refused(vehicle: MetadataVehicle | None, why: str) -> None:
    client = read(vehicle)
    assert why in client.problem
    assert client.parameters() == {}


def test_a_file_with_another_shape_is_refused() -> None:
    client = read(one(b'{"version": 3, "parameters": [{"name": 5}]}'))
    with pytest.raises(MetadataRefused, match="Expected `str`, got `int`"):
        client.parameters()
