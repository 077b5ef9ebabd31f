"""Set points of the supervisor: position and velocity in the common NED frame, and what is sent of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.common_frame import Vec3
from gcs.mavlink.ids import AUTOPILOT
from skytender import mavlink as mav

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


class SetPoints(Sequence[SetPoint]):
    """Set points of one tick, in order of system id: a sequence of `SetPoint` that equals a list of the same ones.

    The columns hold all of them and are read-only; each `SetPoint` is made when it is asked for.
    """

    __slots__ = ("_made", "sysids", "values")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, sysids: tuple[int, ...], values: NDArray[np.float64]) -> None:
        self.sysids = sysids
        """of k vehicles"""
        self.values = values
        """(k, 6) position and velocity, m and m/s"""
        self._made: list[SetPoint] | None = None

    @classmethod
    def of(cls, points: Sequence[SetPoint]) -> SetPoints:
        """The same set points with columns."""
        if isinstance(points, cls):
            return points
        columns = np.array([(*point.p_ned, *point.v_ned) for point in points], np.float64).reshape(-1, 6)
        return cls(tuple([point.sysid for point in points]), columns)

    @property
    def p_ned(self) -> NDArray[np.float64]:
        """(k, 3) m."""
        return self.values[:, :3]

    @property
    def v_ned(self) -> NDArray[np.float64]:
        """(k, 3) m/s."""
        return self.values[:, 3:]

    def _points(self) -> list[SetPoint]:
        if self._made is None:
            places = ((n, e, d) for n, e, d in self.p_ned.tolist())
            velocities = ((n, e, d) for n, e, d in self.v_ned.tolist())
            self._made = list(map(SetPoint, self.sysids, places, velocities))
        return self._made

    def __len__(self) -> int:
        return len(self.sysids)

    def __iter__(self) -> Iterator[SetPoint]:
        return iter(self._points())

    @overload
    def __getitem__(self, index: int) -> SetPoint: ...

    @overload
    def __getitem__(self, index: slice) -> list[SetPoint]: ...

    def __getitem__(self, index: int | slice) -> SetPoint | list[SetPoint]:
        return self._points()[index]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Sequence):
            return NotImplemented
        return self._points() == list(other)

    def __repr__(self) -> str:
        return f"SetPoints({self._points()!r})"


class PlacedSetPoints(NamedTuple):
    """Set points of one tick, each in its vehicle's own frame, as they are sent."""

    time_ms: int
    sysids: tuple[int, ...]
    """of k vehicles"""
    values: NDArray[np.float64]
    """(k, 6) position and velocity, NED, m and m/s"""

    def message(self, sysid: int) -> Message:
        """SET_POSITION_TARGET_LOCAL_NED for one of these vehicles."""
        return set_point_message(self.time_ms, sysid, self.values[self.sysids.index(sysid)].tolist())


def set_point_message(time_ms: int, sysid: int, values: Sequence[float]) -> Message:
    """SET_POSITION_TARGET_LOCAL_NED of a position and a velocity in the vehicle's own frame, NED."""
    unused = (0.0, 0.0, 0.0, 0.0, 0.0)
    addressed = (POSITION_AND_VELOCITY, sysid, AUTOPILOT, mav.MAV_FRAME_LOCAL_NED)
    return Message(_MSGID, (time_ms, *values, *unused, *addressed))
