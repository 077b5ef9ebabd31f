"""The latest of everything that chosen vehicles send."""

import json
import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.telemetry.message_inspector import MessageInspector

NAMES = {"XferIn": 1, "XferOut": -1}


def frame(message: str, sysid: int = 1, **fields: Any) -> Frame:
    return codec.split(codec.encode(message, 0, sysid, 1, **fields)).frames[0]


def attitude(sysid: int = 1, roll: float = 0.25) -> Frame:
    return frame("ATTITUDE", sysid, time_boot_ms=5, roll=roll, pitch=0.5, yaw=math.nan, rollspeed=0.0, pitchspeed=0.0,
                 yawspeed=0.0)  # fmt: skip


def test_the_latest_is_told_as_pymavlink_reads_it() -> None:
    inspection = MessageInspector()
    inspection.want({1})
    inspection.add([attitude(roll=0.1), attitude(roll=0.75)], 3.0)
    told = inspection.latest(4.5)["1"]["ATTITUDE"]
    (read,) = common.MAVLink(None).parse_buffer(attitude(roll=0.75).raw)
    theirs = {key: value for key, value in read.to_dict().items() if key != "mavpackettype"}
    assert told["fields"].pop("yaw") is None
    assert math.isnan(theirs.pop("yaw"))
    assert told["fields"] == theirs
    assert (told["count"], told["age_s"], told["rate_hz"]) == (2, 1.5, None)


def test_texts_and_arrays_are_json() -> None:
    inspection = MessageInspector()
    inspection.want({1})
    inspection.add([frame("STATUSTEXT", severity=4, text="Hold")], 0.0)
    battery = {"id": 0, "battery_function": 0, "type": 0, "temperature": 0, "voltages": [7] * 10, "current_battery": -1,
               "current_consumed": -1, "energy_consumed": 4, "battery_remaining": 9}  # fmt: skip
    inspection.add([frame("BATTERY_STATUS", **battery)], 0.0)
    told = json.loads(json.dumps(inspection.latest(0.0), allow_nan=False))["1"]
    assert told["STATUSTEXT"]["fields"]["text"] == "Hold"
    assert told["BATTERY_STATUS"]["fields"]["voltages"] == [7] * 10


@pytest.mark.parametrize("every_s", [0.1, 0.5, 1.0])
def test_the_rate_is_how_often_it_comes(every_s: float) -> None:
    inspection = MessageInspector()
    inspection.want({1})
    for k in range(100):
        inspection.add([attitude()], k * every_s)
    assert inspection.latest(100 * every_s)["1"]["ATTITUDE"]["rate_hz"] == pytest.approx(1.0 / every_s)


def test_nothing_is_kept_of_others_and_nothing_once_nobody_looks() -> None:
    inspection = MessageInspector()
    inspection.add([attitude()], 0.0)
    inspection.want({1, 2})
    inspection.add([attitude(1), attitude(3)], 0.0)
    assert {key: list(messages) for key, messages in inspection.latest(0.0).items()} == {"1": ["ATTITUDE"], "2": []}
    inspection.want({2})
    assert inspection.latest(0.0) == {"2": {}}
    inspection.want({1})
    assert inspection.latest(0.0) == {"1": {}}
    inspection.want(())
    assert inspection.latest(0.0) == {}


def test_values_that_share_a_message_are_told_each_by_its_name() -> None:
    inspection = MessageInspector()
    inspection.want({1})
    for k in range(3):
        named = [frame("NAMED_VALUE_INT", time_boot_ms=k, name=name, value=k * sign) for name, sign in NAMES.items()]
        inspection.add(named, float(k))
    told = inspection.latest(3.0)["1"]
    assert {name: message["fields"]["value"] for name, message in told.items()} == {
        "NAMED_VALUE_INT XferIn": 2,
        "NAMED_VALUE_INT XferOut": -2,
    }
    assert {message["count"] for message in told.values()} == {3}
    assert {message["rate_hz"] for message in told.values()} == {1.0}
