"""Lines between a session and the program in Python that steps it (docs/protocol/socket.md#programs-that-act).

The program's are objects with a text `command`, one of the requests below or an operator's, and an `id`. The session
answers NEXT with the fleet, a column for each thing, and everything else but FINISH and STOP with a reply, each with
the request's `id` and in the order of the requests: the program may have given up waiting for one. Positions in m and
velocities in m/s, common NED frame; numbers that are not known, or infinite, are null, as msgspec writes them.
"""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from gcs.session.message_types import EventRow, ServiceRow

NEXT, FINISH, STOP = "next", "finish", "stop"
"""The next snapshot, with set points until then; that the session is to fly on to its end by itself; its end now."""
SEND, INJECT, CHANGE = "send", "inject", "change"
"""A MAV_CMD; a fault; a change of the world."""

Number = float | None
Numbers = list[Number]


class AcknowledgedRow(Struct):
    """A program's command that has ended; `result` is of MAV_RESULT, null after a time-out."""

    number: int
    sysid: int
    outcome: Literal["accepted", "rejected", "timeout"]
    result: str | None


class FleetMessage(Struct, tag_field="type", tag="fleet"):
    """n vehicles in order of system id, each of them at one place of every list."""

    t_s: float
    sysid: list[int]
    role: list[str]
    mode: list[str]
    mode_name: list[str]
    alive: list[bool]
    armed: list[bool]
    p_ned: list[Numbers]
    v_ned: list[Numbers]
    attitude_rad: list[Numbers]
    """roll, pitch, yaw"""
    set_point_p_ned: list[Numbers]
    set_point_v_ned: list[Numbers]
    target_m: Numbers
    battery: Numbers
    remaining_j: Numbers
    endurance_s: Numbers
    v: Numbers
    tau: Numbers
    age_s: Numbers
    heard_s: Numbers
    lost_share: Numbers
    trouble: list[list[str]]
    services: list[ServiceRow]
    refuelled: int
    events: list[EventRow]
    acknowledged: list[AcknowledgedRow]
    id: int | None = None
    """the request's"""
