"""What a person wants to hear of while a session flies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Level = Literal["info", "warning", "critical"]
Kind = Literal["text", "mode", "failsafe", "ack", "decision", "operator", "link", "death", "session"]


@dataclass(frozen=True)
class Event:
    """One happening; `sysid` 0 is the ground station itself, 255 the traffic."""

    t_s: float
    sysid: int
    level: Level
    text: str
    kind: Kind = "session"
    """`text` is the vehicle's own STATUSTEXT; `ack` its answer to a command, or that there was none"""
