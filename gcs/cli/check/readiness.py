"""Waiting, before the questions, until a vehicle says that it could be armed."""

from __future__ import annotations

from collections.abc import Sequence

from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.cli.check.asking import command_long, to_vehicle
from gcs.cli.check.dialogue import CheckedVehicle, Question, ReceivedMessage, Verdict
from gcs.cli.check.judges import OK
from gcs.mavlink.codec import Message

EVERY_US = 500_000.0
_BIT = mav.MAV_SYS_STATUS_PREARM_CHECK


def _ask(vehicle: CheckedVehicle) -> Sequence[Message]:
    """SYS_STATUS, which some do not send unasked."""
    asked = list(command_long(mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_SYS_STATUS, EVERY_US)(vehicle))
    if vehicle.profile.streams_on_request:
        stream = mav.MAV_DATA_STREAM_EXTENDED_STATUS
        asked += to_vehicle("REQUEST_DATA_STREAM", req_stream_id=stream, req_message_rate=2, start_stop=1)(vehicle)
    return asked


def _judge(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict | None:
    status = vehicle.of("SYS_STATUS")
    if vehicle.armed or (status is not None and status.onboard_control_sensors_health & _BIT):
        return OK
    return None


def _at_end(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict:
    if vehicle.of("SYS_STATUS") is None:
        return Verdict("missing", "it sends no SYS_STATUS: nobody can know")
    texts = [one.fields.text for one in received if one.name == "STATUSTEXT"]
    reasons = list(dict.fromkeys(text for text in texts if "arm" in text.lower()))
    return Verdict("missing", f"not ready yet: {'; '.join(reasons[-3:]) or 'its pre-arm checks do not pass'}")


def readiness(within_s: float) -> Question:
    """The question whether it can be armed, which waits for so long."""
    what = "ready: its pre-arm checks pass (SYS_STATUS)"
    return Question("ready", what, {}, _judge, _ask, at_end=_at_end, repeat_s=within_s, tries=1)
