"""Waiting, before the questions, until a vehicle says that it could be armed, and where it is."""

from __future__ import annotations

from collections.abc import Sequence

from gcs.cli.check.asking import command_long, to_vehicle
from gcs.cli.check.dialogue import CheckedVehicle, Dialogue, Question, ReceivedMessage, Verdict, texts
from gcs.cli.check.predicates import OK
from gcs.cli.check.report import FAULTS
from gcs.mavlink.codec import Message
from skytender import mavlink as mav

BOOTS_WITHIN_S = 120.0
"""One that has run for longer is kept from being ready by something that waiting does not mend."""
HINT_WAIT_S = 60
EVERY_US = 500_000.0
PLACE = "LOCAL_POSITION_NED"
_BIT = mav.MAV_SYS_STATUS_PREARM_CHECK


def _ask(vehicle: CheckedVehicle) -> Sequence[Message]:
    """SYS_STATUS and the place, which some do not send unasked."""
    asked = list(command_long(mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_SYS_STATUS, EVERY_US)(vehicle))
    if vehicle.profile.streams_on_request:
        for stream in (mav.MAV_DATA_STREAM_EXTENDED_STATUS, mav.MAV_DATA_STREAM_POSITION):
            asked += to_vehicle("REQUEST_DATA_STREAM", req_stream_id=stream, req_message_rate=2, start_stop=1)(vehicle)
    return asked


def _could_be_armed(vehicle: CheckedVehicle) -> bool:
    status = vehicle.of("SYS_STATUS")
    return vehicle.armed or (status is not None and bool(status.onboard_control_sensors_health & _BIT))


def _judge(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict | None:
    """Its checks may pass some time before it begins to tell its place."""
    return OK if _could_be_armed(vehicle) and vehicle.of(PLACE) is not None else None


def _at_end(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict:
    if vehicle.of("SYS_STATUS") is None:
        return Verdict("missing", "it sends no SYS_STATUS, so its readiness is unknown")
    if _could_be_armed(vehicle):
        return Verdict("missing", f"its pre-arm checks pass, but it does not tell its place ({PLACE})")
    reasons = [text for text in texts(received) if "arm" in text.lower()]
    return Verdict("missing", f"not ready yet: {'; '.join(reasons[-3:]) or 'its pre-arm checks do not pass'}")


def readiness(within_s: float) -> Question:
    """The question whether it can be armed, which waits for so long."""
    what = f"ready: its pre-arm checks pass (SYS_STATUS), and it tells its place ({PLACE})"
    return Question("ready", what, {}, _judge, _ask, at_end=_at_end, repeat_s=within_s, tries=1, settles=True)


def hint(dialogue: Dialogue) -> str:
    """Advice for a vehicle that failed because it was asked too soon after its start; empty for any other.

    What it said at first counts, too: it may have become ready meanwhile.
    """
    vehicle, outcomes = dialogue.vehicle, {one.question.key: one.outcome for one in dialogue.findings}
    if vehicle is None or vehicle.armed or not FAULTS.intersection(outcomes.values()):
        return ""
    if vehicle.running_s is None or vehicle.running_s > BOOTS_WITHIN_S:
        return ""
    status = vehicle.of("SYS_STATUS")
    if outcomes.get("health-prearm") == "wrong" or (status is not None and not _could_be_armed(vehicle)):
        lack = "its pre-arm checks did not pass"
    elif outcomes.get("stream-local-position-ned") == "missing" or vehicle.of(PLACE) is None:
        lack = f"it did not tell its place ({PLACE})"
    else:
        return ""
    return (
        f"not ready yet: vehicle {vehicle.sysid} had run for {vehicle.running_s:.0f} s, and {lack}; "
        f"with --wait-ready {HINT_WAIT_S} the check waits for that first"
    )
