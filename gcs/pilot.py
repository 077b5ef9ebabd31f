"""From the ground into offboard control, and back into it: what one vehicle must be told next.

    identify → arm → take off → start offboard → fly
                                      ▲           │ any other mode, unless it is landing
                                      └───────────┘

A vehicle that starts in the air and already follows set points goes from `identify` straight to `fly`. One that lands,
whatever its reason, is `down` and stays there.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from pymavlink.dialects.v20 import common as mav

from gcs.fleet import BATTERY_PARAMETERS, VehicleView
from gcs.mavlink.codec import Message, message
from gcs.profiles import STEERABLE, FlightMode

RETRY_S = 1.0
_ROUNDING_S = 1e-6
REACHED_M = 0.3
SET_POINTS_FIRST_S = 0.2
"""Set points flow for this long before offboard is asked for: PX4 wants them first."""


class Stage(StrEnum):
    """How far a vehicle is."""

    IDENTIFY = "identify"
    ARM = "arm"
    TAKEOFF = "take off"
    OFFBOARD = "start offboard"
    FLY = "fly"
    DOWN = "down"


@dataclass(frozen=True)
class Wish:
    """A command that someone in the ground station wants a vehicle to carry out; `token` comes back with its result."""

    sysid: int
    command: int
    params: tuple[float, float, float, float, float, float, float]
    token: str


class Pilot:
    """One vehicle's way into the air."""

    def __init__(self, sysid: int, takeoff_m: float) -> None:
        self.sysid = sysid
        self.stage = Stage.IDENTIFY
        self._takeoff_m = takeoff_m
        self._stage_since_s = 0.0
        self._asked_s = -RETRY_S

    @property
    def sends_set_points(self) -> bool:
        """Whether set points should flow."""
        return self.stage in (Stage.OFFBOARD, Stage.FLY)

    @property
    def down(self) -> bool:
        """Whether it flies no more, for good."""
        return self.stage is Stage.DOWN

    def decide(self, view: VehicleView, now_s: float) -> tuple[list[Wish], list[Message]]:
        """Commands and requests for now, given what is known of the vehicle; moves the stage on."""
        self._move_on(view, now_s)
        if now_s - self._asked_s < RETRY_S - _ROUNDING_S:
            return [], []
        wishes: list[Wish] = []
        requests: list[Message] = []
        if not view.battery_told and view.heard_s >= 0.0:
            requests = [self._read(name) for name in BATTERY_PARAMETERS]
        if self.stage is Stage.ARM:
            wishes = [self._wish(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, 0.0)]
        elif self.stage is Stage.TAKEOFF and view.mode is not FlightMode.TAKEOFF:
            height = view.profile.takeoff_param7(self._takeoff_m, view.ground_amsl_m)
            wishes = [
                self._wish(mav.MAV_CMD_NAV_TAKEOFF, 0.0, 0.0, 0.0, *[view.profile.not_given] * 3, height),
            ]
        elif self.stage is Stage.OFFBOARD and now_s - self._stage_since_s >= SET_POINTS_FIRST_S - _ROUNDING_S:
            wishes = [self._wish(mav.MAV_CMD_DO_SET_MODE, *view.profile.offboard)]
        if wishes or requests:
            self._asked_s = now_s
        return wishes, requests

    def _move_on(self, view: VehicleView, now_s: float) -> None:
        stage = self._next(view)
        if stage is not self.stage:
            self.stage = stage
            self._stage_since_s = now_s
            self._asked_s = now_s - RETRY_S

    def _next(self, view: VehicleView) -> Stage:
        if not view.alive:
            return Stage.DOWN
        if self.stage is Stage.IDENTIFY:
            if view.p_ned is None or view.heard_s < 0.0:
                return Stage.IDENTIFY
            return Stage.FLY if view.flying and view.mode in STEERABLE else Stage.ARM
        if self.stage is Stage.ARM:
            return Stage.TAKEOFF if view.armed else Stage.ARM
        if self.stage is Stage.TAKEOFF:
            if not view.armed:
                return Stage.ARM
            assert view.p_ned is not None
            assert view.origin_offset_ned is not None
            height_m = view.origin_offset_ned[2] - view.p_ned[2]
            return Stage.OFFBOARD if height_m >= self._takeoff_m - REACHED_M else Stage.TAKEOFF
        if self.stage in (Stage.OFFBOARD, Stage.FLY):
            if view.mode is FlightMode.LAND or not view.armed:
                return Stage.DOWN
            return Stage.FLY if view.mode in STEERABLE else Stage.OFFBOARD
        return Stage.DOWN

    def _wish(self, command: int, *params: float) -> Wish:
        filled = (*params, *(0.0 for _ in range(7 - len(params))))
        return Wish(self.sysid, command, filled, f"pilot {self.stage}")  # type: ignore[arg-type]

    def _read(self, name: str) -> Message:
        return message(
            "PARAM_REQUEST_READ",
            target_system=self.sysid,
            target_component=mav.MAV_COMP_ID_AUTOPILOT1,
            param_id=name,
            param_index=-1,
        )
