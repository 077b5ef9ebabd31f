"""Set points of the supervisor: position and velocity in the common NED frame, and what is sent of them."""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.common_frame import Vec3, turned
from gcs.mavlink.ids import AUTOPILOT

POSITION_AND_VELOCITY = (
    mav.POSITION_TARGET_TYPEMASK_AX_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AY_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AZ_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_YAW_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE
)
_MSGID = codec.msgid("SET_POSITION_TARGET_LOCAL_NED")


class SetPoint(NamedTuple):
    """Position and velocity of one vehicle wanted at the tick's time; common NED frame, m and m/s."""

    sysid: int
    p_ned: Vec3
    v_ned: Vec3


class PlacedSetPoints(NamedTuple):
    """Set points of one tick, each in its vehicle's own frame, as they are sent."""

    time_ms: int
    rows: Mapping[int, int]
    """by system id; the same object for as long as they are the same"""
    values: NDArray[np.float64]
    """(k, 6) position and velocity, NED, m and m/s"""

    def message(self, sysid: int) -> Message:
        """SET_POSITION_TARGET_LOCAL_NED for one of these vehicles."""
        return set_point_message(self.time_ms, sysid, self.values[self.rows[sysid]].tolist())


class SetPointPlacer:
    """Brings set points into their vehicles' own frames, which seldom move: how they lie is kept."""

    def __init__(self) -> None:
        self._sysids: list[int] = []
        self._rows: dict[int, int] = {}
        self._offsets_ned: list[Vec3] = []
        self._turns_rad: list[float] = []
        self._origins = np.empty((0, 3))
        self._aslant: list[int] = []

    def place(
        self, points: Sequence[SetPoint], offsets_ned: list[Vec3], turns_rad: list[float], time_ms: int
    ) -> PlacedSetPoints:
        """These set points; for each where its vehicle's own frame lies in the common one, as `FramePlace` says."""
        if offsets_ned != self._offsets_ned or turns_rad != self._turns_rad:
            self._offsets_ned, self._turns_rad = offsets_ned, turns_rad
            self._origins = np.array(offsets_ned, np.float64).reshape(-1, 3)
            self._aslant = [row for row, turn_rad in enumerate(turns_rad) if turn_rad]
        sysids: list[int] = []
        flat: list[float] = []
        for sysid, p_ned, v_ned in points:
            sysids.append(sysid)
            flat += p_ned
            flat += v_ned
        values = np.empty((len(sysids), 6))
        struct.pack_into(f"{len(flat)}d", values.data, 0, *flat)  # a third of the time of np.array
        values[:, :3] -= self._origins
        for row in self._aslant:
            n, e, d, *v_ned = values[row].tolist()
            values[row, :3] = turned((n, e, d), -turns_rad[row])
            values[row, 3:] = turned((v_ned[0], v_ned[1], v_ned[2]), -turns_rad[row])
        if sysids != self._sysids:
            self._sysids, self._rows = sysids, {sysid: row for row, sysid in enumerate(sysids)}
        return PlacedSetPoints(time_ms, self._rows, values)


def set_point_message(time_ms: int, sysid: int, values: Sequence[float]) -> Message:
    """SET_POSITION_TARGET_LOCAL_NED of a position and a velocity in the vehicle's own frame, NED."""
    unused = (0.0, 0.0, 0.0, 0.0, 0.0)
    addressed = (POSITION_AND_VELOCITY, sysid, AUTOPILOT, mav.MAV_FRAME_LOCAL_NED)
    return Message(_MSGID, (time_ms, *values, *unused, *addressed))
