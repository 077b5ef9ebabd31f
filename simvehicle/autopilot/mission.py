"""A mission in flight: which leg is flown, where it leads, and when the next one begins. No message, no clock.

The rules of a mission:
1. Legs are flown in order; a leg counts as reached when the vehicle is within its radius and has held there for its
   time. A leg that has nothing to fly (speed) is reached at once.
2. A vehicle on the ground first climbs straight up to its leg's height.
3. A mission that is left goes on, when it is entered again, with the leg that it was left in; one that was flown to
   its end begins again.
4. Its last leg done, the vehicle holds; RETURN hands over to the mode of that name.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum, StrEnum
from math import dist, hypot
from typing import NamedTuple

Vec3 = tuple[float, float, float]

LEVEL_M = 0.2
"""A climb is done this far below its height."""
OVER_M = 0.3
"""A landing begins this near to its place."""


class Kind(StrEnum):
    """Kind of a leg."""

    TAKEOFF = "take-off"
    WAYPOINT = "waypoint"
    STAY = "stay"
    WAIT = "wait"
    SPEED = "speed"
    RETURN = "return"
    LAND = "land"
    HOME = "home"


class Place(NamedTuple):
    """North and east in m (None: where the vehicle is) and height (None: the vehicle's) above home or the origin."""

    north_m: float | None = None
    east_m: float | None = None
    height_m: float | None = None
    above_home: bool = False


class Leg(NamedTuple):
    """One item of a mission; `radius_m` and `speed_m_s`: None for what the vehicle does by itself."""

    kind: Kind
    place: Place = Place()
    hold_s: float = 0.0
    radius_m: float | None = None
    speed_m_s: float | None = None


class Outcome(Enum):
    """Request of a mission to the vehicle's mode."""

    GOING = 0
    RETURN = 1
    DONE = 2


class Mission:
    """The legs and how far they are flown; `reached` collects the numbers of legs reached, for the mission
    microservice."""

    def __init__(self, legs: Sequence[Leg]) -> None:
        self.legs = tuple(legs)
        self.index = 0
        self.reached: list[int] = []
        self.speed_m_s: float | None = None
        self.landing = False
        self.climbing = False
        self.goal_ned: Vec3 | None = None
        self._arrived_s: float | None = None

    @property
    def complete(self) -> bool:
        """Whether nothing of it is left to fly."""
        return self.index >= len(self.legs)

    def enter(self) -> None:
        """Begin, or go on after a pause, from wherever the vehicle is now."""
        if self.complete:
            self.index = 0
            self.speed_m_s = None
        self._set_out_anew()

    def go_to(self, index: int) -> bool:
        """Make another leg the current one; False where there is none of this number."""
        if not 0 <= index < len(self.legs):
            return False
        self.index = index
        self._set_out_anew()
        return True

    def reset(self) -> None:
        """Let one that was flown to its end go on with its last leg."""
        if self.complete:
            self.go_to(len(self.legs) - 1)

    def advance(
        self, now_s: float, p_ned: Vec3, *, landed: bool, home_ned: Vec3, radius_m: float, takeoff_m: float
    ) -> Outcome:
        """See how far the vehicle has come; afterwards `goal_ned` is where it has to go, unless the mission ends.

        `radius_m` is for legs that name none, `takeoff_m` the least height above home of a climb from the ground.
        """
        while not self.complete:
            leg = self.legs[self.index]
            if leg.kind is Kind.SPEED:
                self.speed_m_s = leg.speed_m_s
            elif leg.kind not in (Kind.HOME, Kind.RETURN):
                if self.goal_ned is None:
                    self._set_out(leg, p_ned, landed, home_ned, takeoff_m)
                if not self._flown(leg, now_s, p_ned, radius_m):
                    return Outcome.GOING
            self._reach()
            if leg.kind is Kind.RETURN:
                return Outcome.RETURN
        return Outcome.DONE

    def touched_down(self) -> None:
        """The vehicle stands: a landing leg is reached."""
        if self.landing:
            self._reach()

    def _flown(self, leg: Leg, now_s: float, p_ned: Vec3, radius_m: float) -> bool:
        goal = self.goal_ned
        assert goal is not None
        if self.climbing:
            if p_ned[2] > goal[2] + LEVEL_M:
                return False
            self.climbing = False
            self.goal_ned = goal = _goal(leg, p_ned, goal[2])
        if leg.kind is Kind.LAND:
            self.landing = self.landing or hypot(p_ned[0] - goal[0], p_ned[1] - goal[1]) < OVER_M
            return False
        if self._arrived_s is None and dist(p_ned, goal) <= (leg.radius_m or radius_m):
            self._arrived_s = now_s
        arrived_s = self._arrived_s
        return leg.kind is not Kind.STAY and arrived_s is not None and now_s - arrived_s >= leg.hold_s

    def _set_out(self, leg: Leg, p_ned: Vec3, landed: bool, home_ned: Vec3, takeoff_m: float) -> None:
        place = leg.place
        down_m = p_ned[2]
        if place.height_m is not None and leg.kind is not Kind.LAND:
            down_m = (home_ned[2] if place.above_home else 0.0) - place.height_m
        if landed:
            down_m = min(down_m, home_ned[2] - takeoff_m) if leg.kind is not Kind.TAKEOFF else down_m
        self.climbing = landed or leg.kind is Kind.TAKEOFF
        self.goal_ned = (p_ned[0], p_ned[1], down_m) if self.climbing else _goal(leg, p_ned, down_m)

    def _set_out_anew(self) -> None:
        self.goal_ned = None
        self._arrived_s = None
        self.landing = self.climbing = False

    def _reach(self) -> None:
        self.reached.append(self.index)
        self.index += 1
        self._set_out_anew()


def _goal(leg: Leg, p_ned: Vec3, down_m: float) -> Vec3:
    """A leg's place at a height; a take-off goes straight up, and so does a leg without a place."""
    north, east = leg.place.north_m, leg.place.east_m
    if leg.kind is Kind.TAKEOFF or north is None or east is None:
        north, east = p_ned[0], p_ned[1]
    return north, east, down_m
