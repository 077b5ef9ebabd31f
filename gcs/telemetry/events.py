"""Events that a person should see while a session flies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from skytender import mavlink as mav

Level = Literal["info", "warning", "critical"]
Kind = Literal[
    "text", "mode", "failsafe", "ack", "decision", "operator", "link", "death", "session", "violation", "fault"
]

LESS_SEVERE: dict[int, Level] = {
    mav.MAV_SEVERITY_WARNING: "warning",
    mav.MAV_SEVERITY_NOTICE: "info",
    mav.MAV_SEVERITY_INFO: "info",
    mav.MAV_SEVERITY_DEBUG: "info",
}


def level_of(severity: int) -> Level:
    """Level of a STATUSTEXT of this MAV_SEVERITY; from error on, and what is none, it is critical."""
    return LESS_SEVERE.get(severity, "critical")


@dataclass(frozen=True)
class Event:
    """One happening; `sysid` 0 is the ground station itself, 255 the traffic."""

    t_s: float
    sysid: int
    level: Level
    text: str
    kind: Kind = "session"
    """`text` is the vehicle's own STATUSTEXT; `ack` its answer to a command, or that there was none"""
