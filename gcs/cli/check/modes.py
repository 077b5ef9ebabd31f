"""Questions about standard modes: which modes it lists, which it flies, one set by its standard number."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from gcs.cli.check.asking import PEERS, QGC, command_long, commanded, requested
from gcs.cli.check.dialogue import CheckedVehicle, Question, ReceivedMessage, Verdict
from gcs.cli.check.predicates import always
from gcs.mavlink.codec import Message
from gcs.mavlink.services import standard_modes
from skytender import mavlink as mav

MOST_MODES = 40
"""Modes that are asked for one by one."""


def _list_fault(vehicle: CheckedVehicle, _: Any) -> str:
    listed = vehicle.modes.values()
    if nameless := [one.custom_mode for one in listed if not one.standard_mode and not one.mode_name]:
        return f"mode {nameless[0]} has neither a standard mode nor a name"
    flown = vehicle.of("HEARTBEAT").custom_mode
    if flown not in {one.custom_mode for one in listed}:
        return f"custom_mode {flown}, which its HEARTBEAT says, is not listed"
    return ""


def _whole_list() -> Question:
    """As `requested`, with every mode awaited; what a request for all leaves out is asked for by its index."""
    asked = requested(
        "AVAILABLE_MODES",
        "AVAILABLE_MODES, every mode once, or its refusal",
        {QGC: "offers the modes of its own table for that autopilot, and waits for it, three times, before it goes on"},
        fault=_list_fault,
        may_refuse=always,
    )

    def ask(vehicle: CheckedVehicle) -> Sequence[Message]:
        if not (missing := _missing(vehicle)):
            return asked.ask(vehicle)
        command, params = standard_modes.asked(missing[0])
        return command_long(command, *params)(vehicle)

    def judge(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict | None:
        last = vehicle.of("AVAILABLE_MODES")
        return None if last is not None and _missing(vehicle) else asked.judge(vehicle, received)

    def at_end(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict:
        if missing := ", ".join(map(str, _missing(vehicle))):
            return Verdict("wrong", f"these of its modes never came: {missing}")
        return asked.at_end(vehicle, received)

    return replace(asked, ask=ask, judge=judge, at_end=at_end, repeat_s=standard_modes.EACH_WITHIN_S, tries=MOST_MODES)


def _missing(vehicle: CheckedVehicle) -> list[int]:
    """Indices of modes that are yet to come."""
    return standard_modes.missing((index, one.number_modes) for index, one in vehicle.modes.items())


def _current_fault(vehicle: CheckedVehicle, content: Any) -> str:
    flown = vehicle.of("HEARTBEAT").custom_mode
    return "" if content.custom_mode == flown else f"it says custom_mode {content.custom_mode}, its HEARTBEAT {flown}"


def _lists_no_land(vehicle: CheckedVehicle) -> str:
    standard = {one.standard_mode for one in vehicle.modes.values()}
    return "" if mav.MAV_STANDARD_MODE_LAND in standard else "it lists no standard mode 7 (land)"


MODES = [
    _whole_list(),
    requested(
        "CURRENT_MODE",
        "CURRENT_MODE, the mode of its HEARTBEAT, or its refusal",
        {QGC: "shows the mode by its own table for that autopilot"},
        fault=_current_fault,
        may_refuse=always,
    ),
]
STANDARD_LAND = replace(
    commanded(
        "standard-mode",
        "DO_SET_STANDARD_MODE (262) to land",
        dict.fromkeys(PEERS, "cannot set a mode of an autopilot whose numbers it does not know"),
        mav.MAV_CMD_DO_SET_STANDARD_MODE,
        command_long(mav.MAV_CMD_DO_SET_STANDARD_MODE, float(mav.MAV_STANDARD_MODE_LAND)),
    ),
    when=_lists_no_land,
)
