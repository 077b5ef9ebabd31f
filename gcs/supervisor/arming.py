"""Arming, take-off and offboard sequence of one vehicle: the next command to it.

    identify → arm → take off → start offboard → fly
                                      ▲           │ any other mode, unless it is landing
                                      └───────────┘

One that flies a mission leaves `fly` for `mission`, and comes back by `start offboard`.

A vehicle that starts in the air and already follows set points goes from `identify` straight to `fly`. One that lands,
whatever its reason, is `down` and stays there, unless it was to land: then it is `at a base`, and comes back by `arm`.
One that refuses to be armed is asked ever more seldom, and at once when its battery has been charged. One that an
operator takes is his from any stage (`operator`). From that and from `down` it comes back by `rejoin`: from
where it is, through as many of these stages as that needs. One whose failsafe flies or has landed it because its link
was out rejoins by itself once it is received again, if `rejoins_itself` and its battery allows.
"""

from __future__ import annotations

import math
from enum import StrEnum
from typing import Literal

from gcs.mavlink.autopilots import STEERABLE, End, FlightMode
from gcs.mavlink.codec import Message, message
from gcs.mavlink.command_protocol import ARMING, OPERATOR, CommandRequest
from gcs.telemetry.battery_account import BATTERY_PARAMETERS
from gcs.telemetry.state import VehicleView
from skytender import mavlink as mav

RETRY_S = 1.0
SELDOM_S = 32.0
"""A vehicle of ours that refuses to be armed is asked again after 1, 2, 4 s and so on, in the end so seldom."""
MOST_REFUSALS = 64
"""Different refusals that are remembered, so that none is reported twice."""
CHARGED_SHARE = 0.01
"""Of its battery: so much more in it, and it is asked at once."""
_ROUNDING_S = 1e-6
REACHED_M = 0.3
DISARMS_ITSELF_S = 3.0
"""Most autopilots disarm by themselves so long after touchdown."""
CUT_OFF_S = 2.0
"""Not received for so long, a vehicle may have lost the ground station, too, and be flown by its failsafe."""
BLAMED_S = 3.0
"""How long after that a landing is put down to it: it may need a HEARTBEAT or two to be reported."""
REJOIN_SHARE = 0.2
"""[choice] Of its battery that a vehicle needs to rejoin by itself: to take off, come back and land again."""
SET_POINTS_FIRST_S = 0.2
"""Set points flow for this long before offboard is asked for: PX4 wants them first."""


Mission = Literal["", "fly", "hold"]
"""Part of a vehicle in its mission: none, as it is led by set points; fly it, or stand where it is."""
ON_MISSION = frozenset({FlightMode.MISSION, FlightMode.HOLD})
"""Modes of a vehicle that flies its mission, or holds on it."""


class Stage(StrEnum):
    """Stage of a vehicle."""

    IDENTIFY = "identify"
    ARM = "arm"
    TAKEOFF = "take off"
    OFFBOARD = "start offboard"
    FLY = "fly"
    MISSION = "mission"
    YIELDED = "yielded"
    BASE = "at a base"
    DOWN = "down"
    TAKEN = "operator"


class ArmingSequence:
    """One vehicle's way into the air."""

    def __init__(
        self, sysid: int, takeoff_m: float, *, seldom_s: float = RETRY_S, rejoins_itself: bool = False
    ) -> None:
        self.sysid = sysid
        self._rejoins_itself = rejoins_itself
        self._cut_off_s = -math.inf
        self._seldom_s = seldom_s
        self._arming_tries = 0
        self._refused_j = math.inf
        self._refusals: set[str] = set()
        self.stage = Stage.IDENTIFY
        self.grounded = False
        """whether the schedule wants it to land where it is, and to stay there"""
        self.mission: Mission = ""
        self._comes_down = self._led_still = False
        self._takeoff_m = takeoff_m
        self._stage_since_s = 0.0
        self._asked_s = self._read_s = -RETRY_S
        self.ordered: End | None = None
        """what an operator wants it to fly; None while it is the planner's"""
        self.released = False
        """whether another ground station flies it, and it is commanded nothing"""
        self._order_sent = False
        self.rejoining = False
        """whether it is on its way back to the planner"""
        self.checked = True
        """whether its check list has ended; it is not armed before"""
        self.unfit = ""
        """why it must not be armed, as a sentence; empty while it may be"""
        self.left_out = ""
        """why it takes no part, as a sentence; empty while it does"""
        self.booted = False
        """whether its autopilot has booted in flight, and it has not been armed since"""
        self.touched: set[int] = set()
        """set into which it enters its id when something is requested of it, so that it is asked only then"""

    @property
    def sends_set_points(self) -> bool:
        """Whether set points should flow."""
        at_base = self.stage is Stage.BASE and not self._comes_down
        return self.stage in (Stage.OFFBOARD, Stage.FLY) or at_base or (self.stage is Stage.MISSION and self._led_still)

    @property
    def down(self) -> bool:
        """Whether it flies no more, for good."""
        return self.stage is Stage.DOWN

    def unheard_lately(self, now_s: float) -> bool:
        """Whether what it does now may be its failsafe's doing, because its link was out."""
        return now_s - self._cut_off_s <= BLAMED_S

    def order(self, mode: End) -> None:
        """An operator wants it to hold, return or land, and to be left alone then."""
        self.ordered, self.released, self._order_sent = mode, False, False
        self.touched.add(self.sysid)

    def go_on_mission(self, mission: Mission) -> None:
        """Let this be its part in its mission from now on."""
        self.mission, self._asked_s = mission, -RETRY_S
        self.touched.add(self.sysid)

    def release(self) -> None:
        """Leave it to another ground station, at once."""
        self.released = True
        self.ordered = None
        self.touched.add(self.sysid)

    def rejoin(self) -> None:
        """Bring a vehicle back that was taken or is down, from where it is."""
        self.ordered, self.released, self.rejoining = None, False, True
        self.stage, self._asked_s = Stage.IDENTIFY, -RETRY_S
        self.touched.add(self.sysid)

    def excuse(self, now_s: float) -> None:
        """The vehicle does not hear the ground station: what its failsafe does is put down to that, for a while."""
        self._cut_off_s = now_s

    def back_from(self, view: VehicleView) -> bool:
        """Whether it is brought back from what flies it since the session stood still: no pilot's wish."""
        return view.failsafe or view.mode is FlightMode.HOLD

    def mend(self, view: VehicleView) -> None:
        """Nothing keeps the vehicle from flying any more: bring it back if it is down, and its battery allows."""
        if self.stage is Stage.DOWN and self.ordered is None and self._has_energy(view) and self._rejoins_itself:
            self.rejoin()

    def boot(self, view: VehicleView) -> None:
        """The vehicle's autopilot has booted: of one of ours the process has ended, which says it."""

    def decide(
        self, view: VehicleView, now_s: float, *, bound: bool = False, late_s: float = 0.0
    ) -> tuple[list[CommandRequest], list[Message]]:
        """Commands and requests for now, given what is known of the vehicle; moves the stage on.

        While it is `bound`, to end a transfer in order, an operator's order waits. `late_s`: how late this tick comes.
        """
        self._move_on(view, now_s, bound)
        if self.stage is Stage.TAKEN:
            return self._carry_out_order(view), []
        requests: list[Message] = []
        if now_s - self._read_s >= RETRY_S - _ROUNDING_S and not view.battery_reported and view.last_received_s >= 0.0:
            requests, self._read_s = self._requests(view), now_s
        if now_s - self._asked_s < self._wait_s(view) - _ROUNDING_S:
            return [], requests
        commands = self._wanted(view, now_s)
        if commands:
            self._asked_s = now_s
            self._arming_tries += self.stage is Stage.ARM
            self._refused_j = view.remaining_j
        return commands, requests

    def rests(self, view: VehicleView) -> bool:
        """Whether, having decided on this view, it would decide nothing and stay as it is at every later time, as long
        as nothing is requested of it and nothing of the vehicle changes but figures.

        It has no parameters to ask for then, and what it looks at is no figure: while a view is `fresh`, its age is
        none that cuts it off. Charge, check list and time count only on the way into the air.
        """
        if not view.battery_reported:
            return False
        if self.stage is Stage.TAKEN:
            return self._order_sent or self.ordered is None
        if self.ordered is not None or self.grounded or self.mission == "fly":
            return False
        steered = view.fresh and view.armed and view.mode in STEERABLE
        return self.stage is Stage.DOWN or (self.stage is Stage.FLY and steered and not self.rejoining)

    def _wait_s(self, view: VehicleView) -> float:
        """Time from one command to the next."""
        charged = view.remaining_j - self._refused_j >= CHARGED_SHARE * view.capacity_j
        if self._arming_tries == 0 or charged:
            return RETRY_S
        return min(RETRY_S * float(2 ** min(self._arming_tries - 1, 16)), self._seldom_s)

    @property
    def asks_again(self) -> str:
        """Words behind a refusal that does not end the matter."""
        seldom = self.stage is Stage.ARM and self._seldom_s > RETRY_S
        return f"; it is asked again, after a second and then up to {self._seldom_s:.0f} s" if seldom else ""

    def repeats(self, text: str) -> bool:
        """Whether a vehicle of ours has said so before since it is asked to arm: it would refuse again."""
        if not self.asks_again:
            return False
        again = text in self._refusals
        if len(self._refusals) < MOST_REFUSALS:
            self._refusals.add(text)
        return again

    def has_left(self, token: str) -> bool:
        """Whether a command is of a stage that has ended."""
        return token.startswith(ARMING) and not token.startswith(f"{ARMING} {self.stage}")

    def _come_down(self, view: VehicleView, now_s: float) -> list[CommandRequest]:
        """Land; and disarm where the autopilot does not so by itself."""
        if view.landed:
            waited = now_s - self._stage_since_s >= DISARMS_ITSELF_S and now_s - self._asked_s >= DISARMS_ITSELF_S
            return [self._command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 0.0, 0.0)] if view.armed and waited else []
        if view.mode is FlightMode.LAND:
            return []
        command, params = view.ending("land")
        return [self._command(command, *params)]

    def _carry_out_order(self, view: VehicleView) -> list[CommandRequest]:
        """The operator's order, once, as soon as the vehicle reports again where it does not; one whose motors are off
        stays where it is without a command."""
        if self._order_sent or self.ordered is None or view.age_s > CUT_OFF_S:
            return []
        self._order_sent = True
        if not view.armed:
            return []
        command, params = view.ending(self.ordered)
        return [self._command(command, *params, token=f"{OPERATOR} {self.ordered}")]

    def _requests(self, view: VehicleView) -> list[Message]:
        to = {"target_system": self.sysid, "target_component": mav.MAV_COMP_ID_AUTOPILOT1}
        return [message("PARAM_REQUEST_READ", **to, param_id=name, param_index=-1) for name in BATTERY_PARAMETERS]

    def _wanted(self, view: VehicleView, now_s: float) -> list[CommandRequest]:
        """The command that the stage needs."""
        if self.stage is Stage.ARM:
            if not self.checked or self.unfit:
                return []
            return [self._command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0, 0.0)]
        if self.stage is Stage.TAKEOFF and view.mode is not FlightMode.TAKEOFF:
            height = view.profile.takeoff_param7(self._takeoff_m, view.ground_amsl_m)
            return [self._command(mav.MAV_CMD_NAV_TAKEOFF, 0.0, 0.0, 0.0, *[view.profile.not_given] * 3, height)]
        if self.stage is Stage.OFFBOARD and now_s - self._stage_since_s >= SET_POINTS_FIRST_S - _ROUNDING_S:
            return [self._command(mav.MAV_CMD_DO_SET_MODE, *view.profile.offboard)]
        if self.stage is Stage.MISSION:
            return self._on_mission(view)
        return self._come_down(view, now_s) if self.stage is Stage.BASE else []

    def _on_mission(self, view: VehicleView) -> list[CommandRequest]:
        """The command that starts its mission, or lets it go on; or by which it holds."""
        if self.mission == "fly" and view.mode is not FlightMode.MISSION:
            command, params = view.profile.mission
        elif self.mission == "hold" and view.mode is FlightMode.MISSION:
            command, params = view.profile.ending("hold")
        else:
            return []
        return [self._command(command, *params, token=f"{ARMING} {self.stage}, {self.mission}")]

    def _move_on(self, view: VehicleView, now_s: float, bound: bool) -> None:
        if self.stage in (Stage.OFFBOARD, Stage.FLY):
            self._blame_link(view, now_s)
        taken = self.released or (self.ordered is not None and view.alive and not bound)
        refused = self.unfit if self.stage is Stage.ARM else ""
        self.left_out = refused or self.left_out
        stage = Stage.TAKEN if taken else Stage.DOWN if refused else self._next(view)
        if stage is not self.stage:
            self.stage = stage
            self._stage_since_s = now_s
            self._asked_s = now_s - RETRY_S
            self._arming_tries = 0
            self._refusals.clear()
        self._comes_down = view.landed or view.mode not in STEERABLE
        self._led_still = view.mode in STEERABLE

    def _blame_link(self, view: VehicleView, now_s: float) -> None:
        """Let a vehicle rejoin that its failsafe took out of offboard control because its link was out."""
        if view.age_s > CUT_OFF_S:
            self._cut_off_s = now_s
        elif (
            self._rejoins_itself
            and self.unheard_lately(now_s)
            and not (view.mode in STEERABLE and view.armed)
            and self._has_energy(view)
        ):
            self.rejoining = True

    def _has_energy(self, view: VehicleView) -> bool:
        return view.alive and view.remaining_j >= REJOIN_SHARE * view.capacity_j

    def _next(self, view: VehicleView) -> Stage:
        if not view.alive:
            return Stage.DOWN
        if self.stage is Stage.TAKEN:
            return Stage.TAKEN
        if self.stage is Stage.IDENTIFY:
            if view.p_ned is None or view.last_received_s < 0.0:
                return Stage.IDENTIFY
            if view.flying and view.mode in STEERABLE:
                return Stage.FLY
            if self.rejoining and view.flying:
                return self._climbed(view)
            return Stage.ARM
        if self.stage is Stage.ARM:
            return Stage.TAKEOFF if view.armed else Stage.ARM
        if self.stage is Stage.TAKEOFF:
            return self._climbed(view) if view.armed else Stage.ARM
        if self.stage is Stage.FLY and self.mission == "fly" and view.mode in STEERABLE and view.armed:
            return Stage.MISSION
        if self.stage is Stage.MISSION and self.mission and view.armed and view.mode in STEERABLE | ON_MISSION:
            return Stage.MISSION
        if self.grounded and self.stage in (Stage.OFFBOARD, Stage.FLY, Stage.BASE):
            return Stage.BASE
        if self.stage is Stage.BASE:
            return Stage.OFFBOARD if view.flying else Stage.ARM
        if self.stage in (Stage.OFFBOARD, Stage.FLY, Stage.MISSION):
            if view.mode in STEERABLE and view.armed:
                self.rejoining = False
                return Stage.FLY
            if self.rejoining:  # it may still be on its way down
                return Stage.OFFBOARD if view.armed else Stage.ARM
            return Stage.DOWN if view.mode is FlightMode.LAND or not view.armed else Stage.OFFBOARD
        return Stage.DOWN

    def _climbed(self, view: VehicleView) -> Stage:
        """Whether it is high enough to follow set points."""
        assert view.p_ned is not None
        assert view.origin_offset_ned is not None
        height_m = view.origin_offset_ned[2] - view.p_ned[2]
        return Stage.OFFBOARD if height_m >= self._takeoff_m - REACHED_M else Stage.TAKEOFF

    def _command(self, command: int, *params: float, token: str = "") -> CommandRequest:
        return CommandRequest(self.sysid, command, params, token or f"{ARMING} {self.stage}")
