"""Frames of ours read by MAVSDK, which takes them apart with a MAVLink implementation of its own (libmav)."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

from pymavlink.dialects.v20 import common

import gcs.mavlink.codec as gcs_codec
import simvehicle.mavlink.codec as vehicle_codec
from simvehicle.mavlink.telemetry import TELEMETRY

PROGRAM = Path(__file__).with_name("read_by_mavsdk.py")
OTHERS = "COMMAND_ACK STATUSTEXT PARAM_VALUE AUTOPILOT_VERSION MISSION_ITEM_INT MISSION_COUNT MISSION_ACK SYSTEM_TIME"
UNKNOWN_THERE = {"CONTROL_STATUS"}
"""Messages of MAVLink's development definitions, which MAVSDK does not have: test_asked_by_mavsdk.py gives it these."""
OURS = sorted(
    ({common.mavlink_map[stream.msgid].msgname for stream in TELEMETRY} | set(OTHERS.split())) - UNKNOWN_THERE
)
THEIRS = "HEARTBEAT COMMAND_LONG COMMAND_INT SET_POSITION_TARGET_LOCAL_NED PARAM_SET PARAM_REQUEST_READ SYSTEM_TIME"
READER = 200


def values(name: str) -> dict[str, Any]:
    """A value of its own for each field, exact in every type that it may have."""
    cls = common.mavlink_map[gcs_codec.msgid(name)]
    kinds = dict(zip(cls.fieldnames, cls.fieldtypes, strict=True))
    given: dict[str, Any] = {}
    for at, (field, length) in enumerate(zip(cls.ordered_fieldnames, cls.array_lengths, strict=True)):
        if kinds[field] == "char":
            given[field] = f"Text {at}"
        elif length:
            given[field] = tuple(at + step + 1 for step in range(length))
        else:
            given[field] = at + 1.5 if kinds[field] in ("float", "double") else at + 1
    to = {"target_system": READER, "target_component": 1}
    return given | {field: number for field, number in to.items() if field in given}


def test_mavsdk_reads_what_the_vehicle_and_the_ground_station_write(peers: Path) -> None:
    sent = [(name, 7, vehicle_codec.encode(vehicle_codec.message(name)(**values(name)), seq=1, sysid=7, compid=1))
            for name in OURS]  # fmt: skip
    sent += [(name, 255, gcs_codec.encode(name, 1, 255, 1, **values(name))) for name in THEIRS.split()]
    lines = "".join(f"{raw.hex()}\n" for _, _, raw in sent)
    done = subprocess.run(
        [str(peers / "python"), str(PROGRAM)], input=lines, capture_output=True, text=True, timeout=50.0, check=True
    )
    # MAVSDK's own log lines are in colour
    answers = [line for line in done.stdout.splitlines() if line.startswith(("read", "nothing"))]
    assert len(answers) == len(sent)
    for (name, sysid, _), answer in zip(sent, answers, strict=True):
        verdict, system, component, fields = answer.split(" ", 3)
        assert (verdict, int(system), int(component)) == ("read", sysid, 1), name
        told = json.loads(fields)
        assert told.pop("message_name") == name
        del told["message_id"]
        wanted = {field: list(v) if isinstance(v, tuple) else v for field, v in values(name).items()}
        newer = {field: told.pop(field) for field in told.keys() - wanted.keys()}
        assert told == wanted, name
        assert not any(newer.values()), name
