"""A vehicle's metadata as files: fetched by pymavlink's frames, unpacked, and held against the standard's schemas
(tests/support/metadata_schemas.json: mavlink/mavlink component_metadata and mavlink/libevents validation, their
constraints) and PX4's way of counting the checksum."""

from __future__ import annotations

import json
import lzma
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from metadata_vehicle import crc32
from pymavlink.dialects.v20 import common as mav

from skytender.vehicle.parameters import TABLE
from tests.simvehicle.mavlink.test_file_protocol import ACK, BURST, OPEN, ask, read

SCHEMAS = json.loads((Path(__file__).parents[2] / "support" / "metadata_schemas.json").read_text(encoding="utf-8"))
COMPONENT_METADATA = 397
PARAMETER, EVENTS = 1, 4
SPEED = {"m/s": "MPC_XY_CRUISE", "s": "COM_DL_LOSS_T", "J": "SIM_BAT_CAP_J", "deg": "MPC_TILTMAX_AIR"}


def fetched(bench: Any, uri: str) -> bytes:
    assert uri.startswith("mftp://")
    assert ask(bench, OPEN, uri.removeprefix("mftp://").encode())[0][0] == ACK
    ask(bench, BURST, size=239)
    answers = [answer for _ in range(10) for answer in read(bench.tick())]
    return b"".join(data for opcode, _, _, data in answers if opcode == ACK)


def general(bench: Any) -> tuple[Any, bytes]:
    """COMPONENT_METADATA, and the file that it names."""
    (ack, said) = bench.command(mav.MAV_CMD_REQUEST_MESSAGE, float(COMPONENT_METADATA))[:2]
    assert (ack.result, said.get_type()) == (mav.MAV_RESULT_ACCEPTED, "COMPONENT_METADATA")
    return said, fetched(bench, said.uri)


def files(bench: Any) -> dict[int, Any]:
    named = json.loads(lzma.decompress(general(bench)[1]))["metadataTypes"]
    content = {one["type"]: fetched(bench, one["uri"]) for one in named}
    assert {one["type"]: one["fileCrc"] for one in named} == {kind: crc32(raw) for kind, raw in content.items()}
    return {kind: json.loads(lzma.decompress(raw)) for kind, raw in content.items()}


def test_the_general_file_is_there_with_its_checksum_and_names_the_others(vehicle_bench: Any) -> None:
    said, raw = general(vehicle_bench())
    assert said.file_crc == crc32(raw)
    content = json.loads(lzma.decompress(raw))
    jsonschema.validate(content, SCHEMAS["general"])
    assert [one["type"] for one in content["metadataTypes"]] == [PARAMETER, EVENTS]


@pytest.mark.parametrize("autopilot", ["px4", "ardupilot"])
def test_parameters_are_described_as_the_vehicle_has_them(vehicle_bench: Any, autopilot: str) -> None:
    bench = vehicle_bench(autopilot=autopilot)
    content = files(bench)[PARAMETER]
    jsonschema.validate(content, SCHEMAS["parameters"])
    described = {row["name"]: row for row in content["parameters"]}
    values = {m.param_id: m for m in bench.send(mav.MAVLink_param_request_list_message(1, 1))}
    assert list(described) == list(values)
    kinds = {mav.MAV_PARAM_TYPE_INT32: "Int32", mav.MAV_PARAM_TYPE_REAL32: "Float"}
    assert {name: row["type"] for name, row in described.items()} == {
        name: kinds[value.param_type] for name, value in values.items()
    }
    assert {unit: described[name]["units"] for unit, name in SPEED.items()} == {unit: unit for unit in SPEED}
    assert all(row["shortDesc"] and row["min"] <= row["default"] <= row["max"] for row in content["parameters"])


def test_what_a_range_says_is_refused_beyond_it(vehicle_bench: Any) -> None:
    bench = vehicle_bench()
    for row in files(bench)[PARAMETER]["parameters"]:
        if row["type"] == "Float" and not row["readOnly"]:
            beyond = mav.MAVLink_param_set_message(1, 1, row["name"].encode(), 1.001 * row["max"] + 1.0, 9)
            (error,) = [m for m in bench.send(beyond) if m.get_type() == "PARAM_ERROR"]
            assert error.error == mav.MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE


def test_events_are_described_by_libevents_schema(vehicle_bench: Any) -> None:
    jsonschema.validate(files(vehicle_bench())[EVENTS], SCHEMAS["events"])


def test_every_parameter_that_begins_with_a_unit_says_so() -> None:
    known = {"J", "W", "deg", "m", "m/s", "m/s2", "rad/s2", "s"}
    first = {row.name: row.meaning.split()[0].rstrip(",") for row in TABLE}
    assert {name for name, word in first.items() if word in known} == {row.name for row in TABLE if row.units}
