"""Pre-flight questions: hold, offboard, arm, disarm. They change modes and arm: only where allowed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from gcs.cli.check.asking import MAVPROXY, MAVSDK, QGC, command_long, commanded, to_vehicle
from gcs.cli.check.control import CONTROL
from gcs.cli.check.dialogue import CheckedVehicle, Question, ReceivedMessage, Verdict
from gcs.cli.check.modes import STANDARD_LAND
from gcs.cli.check.predicates import OK, answered
from gcs.mavlink.autopilots import FlightMode
from gcs.mavlink.codec import Message, message
from skytender import mavlink as mav


def _set_hold(vehicle: CheckedVehicle) -> Sequence[Message]:
    hold = min(number for number, mode in vehicle.profile.modes.items() if mode is FlightMode.HOLD)
    base = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
    return [message("SET_MODE", target_system=vehicle.sysid, base_mode=base, custom_mode=hold)]


def _hold(key: str, what: str) -> Question:
    def flies(vehicle: CheckedVehicle, content: Any) -> bool:
        return vehicle.profile.mode(content.custom_mode) is FlightMode.HOLD

    misses = {QGC: "tries three times, then shows the old mode"}
    return Question(key, what, misses, answered("HEARTBEAT", ours=flies), _set_hold, repeat_s=1.2)


def _says(wanted: bool) -> Callable[[CheckedVehicle, Sequence[ReceivedMessage]], Verdict | None]:
    """The newest HEARTBEAT, which may have come together with the acknowledgement."""
    return lambda vehicle, _: OK if vehicle.armed is wanted else None


def _stay(vehicle: CheckedVehicle) -> Sequence[Message]:
    place = vehicle.of("LOCAL_POSITION_NED")
    x, y, z = (place.x, place.y, place.z) if place is not None else (0.0, 0.0, 0.0)
    rest = dict.fromkeys(("vx", "vy", "vz", "afx", "afy", "afz", "yaw", "yaw_rate"), 0.0)
    frame = {"coordinate_frame": mav.MAV_FRAME_LOCAL_NED, "type_mask": 2552, "time_boot_ms": 0}
    return to_vehicle("SET_POSITION_TARGET_LOCAL_NED", x=x, y=y, z=z, **rest, **frame)(vehicle)


def _arming(wanted: bool) -> list[Question]:
    word = "arm" if wanted else "disarm"
    command = mav.MAV_CMD_COMPONENT_ARM_DISARM
    return [
        commanded(
            word,
            f"{word}: acknowledged",
            {
                MAVSDK: f"action.{word}() fails",
                QGC: f"says that the vehicle refused to {word}",
                MAVPROXY: "prints the refusal",
            },
            command,
            command_long(command, float(wanted)),
        ),
        Question(
            f"{word}-heartbeat",
            f"{word}: the next HEARTBEAT says so",
            {QGC: "keeps showing the old state", MAVSDK: f"telemetry.armed() stays {not wanted}"},
            _says(wanted),
            repeat_s=1.2,
            tries=1,
        ),
    ]


PREPARATION = [
    _hold("set-mode", "SET_MODE (11) to hold: the HEARTBEAT says so"),
    replace(
        commanded(
            "offboard",
            "offboard after half a second of set points",
            {MAVSDK: "offboard.start() is refused"},
            mav.MAV_CMD_DO_SET_MODE,
            lambda v: command_long(mav.MAV_CMD_DO_SET_MODE, *v.profile.offboard)(v),
        ),
        streams=_stay,
        lead_s=0.5,
    ),
    STANDARD_LAND,
    _hold("hold-again", "SET_MODE (11) back to hold"),
    *_arming(True),
    *_arming(False),
    *CONTROL,
]
