"""Questions about what is used before and after a flight: logs, clock, signing, and neighbours behind one address."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from gcs.cli.check.asking import MAVPROXY, MAVSDK, QGC, command_long, judged, requested, to_vehicle
from gcs.cli.check.dialogue import CheckedVehicle, Question, ReceivedMessage, Verdict
from gcs.cli.check.predicates import OK, always, answered, leaves_alone
from gcs.supervisor.preflight import CLOCK_OFF_S, NO_TIME_BEFORE_S
from skytender import mavlink as mav


def _logs_kept_back(vehicle: CheckedVehicle) -> str:
    silent = vehicle.armed and not vehicle.profile.logs_while_armed
    return "it is armed, and answers only on the ground" if silent else ""


LOGS = Question(
    "log-list",
    "its logs listed (LOG_ENTRY), if only that there is none",
    {QGC: "shows no logs", MAVSDK: "log_files.get_entries() times out", MAVPROXY: "'log list' prints nothing"},
    answered("LOG_ENTRY"),
    to_vehicle("LOG_REQUEST_LIST", start=0, end=0xFFFF),
    when=_logs_kept_back,
    repeat_s=1.0,
)


def clock(now_unix_s: Callable[[], float]) -> Question:
    """Its clock beside ours: logs and signatures of one that is off belong to another time."""

    def fault(_: CheckedVehicle, content: Any) -> str:
        theirs_s = content.time_unix_usec / 1e6
        off_s = theirs_s - now_unix_s()
        if theirs_s < NO_TIME_BEFORE_S or abs(off_s) <= CLOCK_OFF_S:
            return ""
        return f"{abs(off_s):.0f} s {'ahead of' if off_s > 0.0 else 'behind'} ours"

    misses = {QGC: "dates its logs wrong", MAVPROXY: "refuses its signatures, or it ours"}
    what = f"its clock within {CLOCK_OFF_S:g} s of ours, or not reported"
    return requested("SYSTEM_TIME", what, misses, fault=fault, may_refuse=always)


def signing(*, signed: bool) -> Question:
    """Over a link with a key: whether it refuses what is not signed."""
    return Question(
        "signing",
        "a command that is not signed is refused",
        dict.fromkeys((MAVSDK, QGC, MAVPROXY), "is not alone: any program that reaches the link commands the vehicle"),
        leaves_alone("without a signature"),
        command_long(mav.MAV_CMD_REQUEST_MESSAGE, mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION),
        lambda *_: OK,
        when=lambda _: "" if signed else "no --key-file is given, so nothing here is signed",
        tries=1,
        repeat_s=1.0,
        unsigned=True,
    )


def _alone(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
    if not vehicle.neighbours:
        return OK
    others = ", ".join(f"vehicle {sysid} ({name})" for sysid, name in sorted(vehicle.neighbours.items()))
    return Verdict("wrong", f"acknowledged too by {others}")


def _twin(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
    if len(vehicle.uids) <= 1 and all(len(uids) <= 1 for uids in vehicle.uids.values()):
        return OK
    said = [f"{at} (uid {' and '.join(sorted(filter(None, uids))) or 'not said'})" for at, uids in vehicle.uids.items()]
    return Verdict("wrong", f"its system id comes from {' and from '.join(said)}")


TWIN = judged(
    "twin",
    "its system id from one address, with one uid",
    dict.fromkeys((MAVSDK, QGC, MAVPROXY), "takes two vehicles for one, and commands both"),
    _twin,
)
ALONE = judged(
    "neighbours",
    "no other vehicle behind this address obeyed its commands",
    {MAVSDK: "flies several when it means one", QGC: "shows the answer of another vehicle"},
    _alone,
)
