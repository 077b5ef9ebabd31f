"""Parameter-protocol questions: list, read by name, write, rejection, value encoding, required parameters."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from gcs.cli.check.asking import MAVPROXY, MAVSDK, QGC, judged, to_vehicle
from gcs.cli.check.dialogue import CheckedVehicle, Question, ReceivedMessage, Verdict
from gcs.cli.check.predicates import OK, answered
from gcs.mavlink.codec import Message, layout
from skytender import mavlink as mav

LIST_S = 10.0
UNKNOWN_PARAMETER = "NO_SUCH_PARAM"
BIGGEST_PLAIN_INTEGER = 1_000_000_000
"""An integer of 1.0 read as bytes is 1,065,353,216: numbers beyond this, in most of a list, are the wrong encoding."""


def _count(vehicle: CheckedVehicle) -> int:
    return max((int(p.param_count) for p in vehicle.parameters.values()), default=0)


def _ask_parameters(vehicle: CheckedVehicle) -> Sequence[Message]:
    """The whole list, also where a few have come unasked; what is missing of it once most has come."""
    reported = {p.param_index for p in vehicle.parameters.values()}
    missing = [index for index in range(_count(vehicle)) if index not in reported]
    if not _count(vehicle) or 2 * len(missing) > _count(vehicle):
        return to_vehicle("PARAM_REQUEST_LIST")(vehicle)
    return [m for i in missing[:50] for m in to_vehicle("PARAM_REQUEST_READ", param_id="", param_index=i)(vehicle)]


def _parameters_reported(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict | None:
    indices = {h.fields.param_index for h in received if h.name == "PARAM_VALUE"}
    count = _count(vehicle)
    return OK if count and indices.issuperset(range(count)) else None


def _parameters_missing(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict:
    count = _count(vehicle)
    if not count or len(vehicle.parameters) < count:
        return Verdict("missing", f"{len(vehicle.parameters)} of {count} came" if count else "none came")
    indices = {h.fields.param_index for h in received if h.name == "PARAM_VALUE"}
    absent = next(index for index in range(count) if index not in indices)
    return Verdict("wrong", f"{count} of {count} came, but none with param_index {absent}")


def _encoding_fault(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
    bytewise = bool(vehicle.capabilities & mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE)
    cast = bool(vehicle.capabilities & mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST)
    if not bytewise and not vehicle.profile.parameter_encoding_said:
        cast = True  # its releases up to 4.6 claim neither: peers know it by its name
    elif bytewise == cast:
        said = "both" if cast else "neither"
        return Verdict("wrong", f"its capabilities have {said} of PARAM_ENCODE_BYTEWISE and PARAM_ENCODE_C_CAST")
    integers = [p.param_value for p in vehicle.parameters.values() if p.param_type < mav.MAV_PARAM_TYPE_REAL32]
    if cast and any(not math.isfinite(x) or x != int(x) for x in integers):
        return Verdict("wrong", "says C_CAST, but sends integers bytewise")
    if bytewise:
        nonzero = [x for x in integers if x != 0.0]
        plain = [x for x in nonzero if math.isfinite(x) and x == int(x) and abs(x) < BIGGEST_PLAIN_INTEGER]
        if nonzero and len(plain) > len(nonzero) / 2:
            return Verdict("wrong", "says BYTEWISE, but sends integers cast to float")
    return OK


def _no_parameters(vehicle: CheckedVehicle) -> str:
    return "" if vehicle.parameters else "no parameter came"


def _silent_on_unknown(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
    if not vehicle.profile.unknown_parameters_refused:
        return Verdict("late", "silence, as from PX4 up to 1.17 and ArduPilot up to 4.6")
    return Verdict("missing", "no answer")


def _px4_only(vehicle: CheckedVehicle) -> str:
    return _no_parameters(vehicle) if vehicle.profile.setup_checked else "only PX4 is asked for it"


def _has(*names: str, set_up: bool = False) -> Callable[[CheckedVehicle, Sequence[ReceivedMessage]], Verdict]:
    def at_end(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
        absent = [name for name in names if name not in vehicle.parameters]
        if absent:
            return Verdict("missing", f"lacks {', '.join(absent)}")
        unset = [name for name in names if vehicle.parameters[name].param_value == 0.0]
        return Verdict("wrong", f"{', '.join(unset)} is zero") if set_up and unset else OK

    return at_end


def _any_parameter(vehicle: CheckedVehicle) -> Any:
    """One that is read and written back; a float where there is one. By name: ArduPilot's answers to a name have no
    index."""
    return min(vehicle.parameters.values(), key=lambda p: (p.param_type != mav.MAV_PARAM_TYPE_REAL32, p.param_id))


def _ask_one(vehicle: CheckedVehicle) -> Sequence[Message]:
    return to_vehicle("PARAM_REQUEST_READ", param_id=_any_parameter(vehicle).param_id, param_index=-1)(vehicle)


def _set_one(vehicle: CheckedVehicle) -> Sequence[Message]:
    p = _any_parameter(vehicle)
    values = {"param_id": p.param_id, "param_value": p.param_value, "param_type": p.param_type}
    return to_vehicle("PARAM_SET", **values)(vehicle)


def _is_that_one(vehicle: CheckedVehicle, content: Any) -> bool:
    return bool(content.param_id == _any_parameter(vehicle).param_id)


def _echo_fault(vehicle: CheckedVehicle, content: Any) -> str:
    """By the bytes: these may be an integer's, or NaN."""
    (asked,) = vehicle.asked
    sent = layout(asked.msgid).record(*asked.values).param_value
    same = content.param_value.raw == sent.raw
    return "" if same else f"{content.param_id} was set to {sent:.9g} and came back as {content.param_value:.9g}"


PARAMETERS = [
    Question(
        "parameter-list",
        "every parameter of PARAM_REQUEST_LIST",
        {
            QGC: "says that the vehicle did not send its parameters, and hides its settings",
            MAVPROXY: "never says how many parameters it received",
            MAVSDK: "param.get_all_params() times out",
        },
        _parameters_reported,
        _ask_parameters,
        _parameters_missing,
        repeat_s=LIST_S,
    ),
    judged(
        "parameter-encoding",
        "one parameter encoding, said and kept",
        {MAVSDK: "reads wrong integers", QGC: "shows wrong integers"},
        _encoding_fault,
        when=lambda v: _no_parameters(v) or ("" if v.of("AUTOPILOT_VERSION") else "no AUTOPILOT_VERSION says which"),
    ),
    Question(
        "parameter-read",
        "a parameter by name",
        {MAVSDK: "param.get_param_float() says TIMEOUT"},
        answered("PARAM_VALUE", ours=_is_that_one),
        _ask_one,
        when=_no_parameters,
    ),
    Question(
        "parameter-set",
        "PARAM_SET echoed by PARAM_VALUE (one is set to the value that it has)",
        {
            MAVSDK: "param.set_param_float() says TIMEOUT",
            QGC: "says that the parameter write failed",
            MAVPROXY: "tries again",
        },
        answered("PARAM_VALUE", _echo_fault, ours=_is_that_one),
        _set_one,
        when=_no_parameters,
    ),
    Question(
        "parameter-unknown",
        "an unknown parameter refused by PARAM_ERROR",
        {MAVSDK: "waits 3 s for each name that the vehicle lacks"},
        answered("PARAM_ERROR"),
        to_vehicle("PARAM_REQUEST_READ", param_id=UNKNOWN_PARAMETER, param_index=-1),
        _silent_on_unknown,
    ),
    judged(
        "parameters-of-setup",
        "SYS_AUTOSTART, COM_RC_IN_MODE and RC_MAP_*",
        {QGC: "says that parameters are missing from the firmware"},
        _has("SYS_AUTOSTART", "COM_RC_IN_MODE", "RC_MAP_ROLL", "RC_MAP_PITCH", "RC_MAP_YAW", "RC_MAP_THROTTLE"),
        when=_px4_only,
    ),
    judged(
        "parameters-of-calibration",
        "CAL_GYRO0_ID, CAL_ACC0_ID and CAL_MAG0_ID, not zero",
        {QGC: "says that the sensors want to be calibrated"},
        _has("CAL_GYRO0_ID", "CAL_ACC0_ID", "CAL_MAG0_ID", set_up=True),
        when=_px4_only,
    ),
    judged(
        "parameter-of-takeoff",
        "MIS_TAKEOFF_ALT",
        {MAVSDK: "action.get_takeoff_altitude() says PARAMETER_ERROR"},
        _has("MIS_TAKEOFF_ALT"),
        when=_px4_only,
    ),
]
