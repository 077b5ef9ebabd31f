"""Frames that strangers put on the wire, stored as they came: ours read the same fields, and write the same bytes.

The truth is the peers': bytes of MAVSDK's client, of MAVSDK's server plugins and of pymavlink, with the fields that
pymavlink read in them when `golden/capture.py` stored them.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import common

import gcs.mavlink.codec as gcs_codec
import simvehicle.mavlink.codec as vehicle_codec
from simvehicle.mavlink.dispatcher import UNDERSTOOD

FILES = {path.stem: json.loads(path.read_text()) for path in sorted((Path(__file__).parent / "golden").glob("*.json"))}
FRAMES = [frame for content in FILES.values() for frame in content["frames"]]


def plain(value: Any) -> Any:
    """A field as JSON holds it; NaN as something that equals itself."""
    if isinstance(value, tuple | list):
        return [plain(item) for item in value]
    return "NaN" if isinstance(value, float) and math.isnan(value) else value


def fields_of(record: Any) -> dict[str, Any]:
    return {name: plain(value) for name, value in record._asdict().items()}


def told(frame: dict[str, Any]) -> dict[str, Any]:
    return {name: plain(value) for name, value in frame["fields"].items()}


def test_a_strangers_frame_is_read_alike_by_both_of_ours() -> None:
    for frame in FRAMES:
        raw = bytes.fromhex(frame["hex"])
        (at_vehicle,) = vehicle_codec.split(raw)
        found = gcs_codec.split(raw)
        (at_gcs,) = found.frames
        assert (found.malformed, found.unknown) == (0, 0)
        for mine in (at_vehicle, at_gcs):
            assert [mine.sysid, mine.compid, mine.seq] == frame["from"]
            assert mine.raw == raw
        assert gcs_codec.name(at_gcs.msgid) == frame["name"]
        assert fields_of(vehicle_codec.decode(at_vehicle)) == told(frame), frame["name"]
        assert fields_of(gcs_codec.fields(at_gcs)) == told(frame), frame["name"]


def test_the_same_fields_are_written_as_the_same_bytes() -> None:
    for frame in FRAMES:
        raw, (sysid, compid, seq), values = bytes.fromhex(frame["hex"]), frame["from"], frame["fields"]
        content = vehicle_codec.message(frame["name"])(**values)
        assert vehicle_codec.encode(content, seq=seq, sysid=sysid, compid=compid) == raw, frame["name"]
        assert gcs_codec.encode(frame["name"], seq, sysid, compid, **values) == raw, frame["name"]


def test_pymavlink_of_today_still_reads_what_was_stored() -> None:
    for frame in FRAMES:
        (message,) = common.MAVLink(None).parse_buffer(bytes.fromhex(frame["hex"]))
        assert message.get_type() == frame["name"]
        assert {name: plain(getattr(message, name)) for name in message.get_fieldnames()} == told(frame), frame["name"]


def test_everything_that_mavsdk_says_to_a_vehicle_is_understood_by_ours() -> None:
    said = {frame["name"] for frame in FILES["mavsdk_client"]["frames"]}
    understood = {common.mavlink_map[msgid].msgname for msgid in UNDERSTOOD}
    assert said - understood == set()
