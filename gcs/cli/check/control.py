"""Questions about operator control: whose the vehicle is, and whether a station is given it and can give it back."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from gcs.cli.check.asking import PEERS, command_long, commanded, requested
from gcs.cli.check.dialogue import CheckedVehicle, Question
from gcs.cli.check.predicates import always
from skytender import mavlink as mav

_COMMAND = mav.MAV_CMD_REQUEST_OPERATOR_CONTROL
_MISSES = dict.fromkeys(PEERS, "shares the vehicle with every other station that commands it")


def _status_fault(_: CheckedVehicle, content: Any) -> str:
    if not content.flags & mav.GCS_CONTROL_STATUS_FLAGS_SYSTEM_MANAGER:
        return "its flags lack SYSTEM_MANAGER, so that it speaks for one component only"
    if content.gcs_main == 0 and any(content.gcs_secondary):
        return "it has secondary owners and no main one"
    return ""


def _without_status(vehicle: CheckedVehicle) -> str:
    return "" if vehicle.of("CONTROL_STATUS") is not None else "it reports no owner (CONTROL_STATUS)"


def _asked(key: str, what: str, *, take: bool) -> Question:
    judged = commanded(key, what, _MISSES, _COMMAND, lambda _: ())
    return replace(
        judged,
        ask=lambda v: command_long(_COMMAND, float(take), 0.0, 10.0, float(v.station[0]))(v),
        when=_without_status,
    )


STATUS = requested(
    "CONTROL_STATUS", "CONTROL_STATUS for the whole system, or its refusal", _MISSES, fault=_status_fault,
    may_refuse=always,
)  # fmt: skip
CONTROL = [
    _asked("operator-control", "REQUEST_OPERATOR_CONTROL (32100): control is given", take=True),
    _asked("operator-control-released", "REQUEST_OPERATOR_CONTROL (32100): control is taken back", take=False),
]
