"""Arming, take-off and offboard stages of an external vehicle, whose autopilot may refuse or RC pilot take over.

    identify → arm → take off → start offboard → fly ⇄ yielded
        └────────┴─ not within arm_within_s: left out

1. Nothing is asked of it before it has reported where it is. It is armed in the mode that its autopilot wants for that.
2. A refusal is the autopilot's right: it is asked again, until `arm_within_s` have passed. Then it is left out.
3. Put into another mode by another than us, it is theirs (`yielded`): nothing is asked of it, but set points flow
   on, so that it can be handed back by putting it into offboard; on the ground it is taken off again then, for set
   points alone do not lift an ArduCopter. Hold is no exception, unless our own set points may just have failed to reach
   it: then it is the autopilot's answer to that, and offboard is asked for again. Before it has been in offboard, a
   mode that is not steered by hand is but on its way there: a HEARTBEAT may be a second old.
4. What an operator orders goes before all that, and so does the order to have it back.
5. On its mission that is its mode, and hold while it waits; by any other, or if it holds of its own, it is theirs.
6. While it is silent nothing changes; it may come back. A return or a landing in which it does is its failsafe's or a
   pilot's, which cannot be known: it is left alone, unless the scenario says `rejoins`.
7. One that has booted in flight, and is not armed then, has fallen: it is down, or brought back where the scenario says
   `rejoins`. What it said before it booted counts no more: it is armed once it has said anew where it is.
"""

from __future__ import annotations

import math

from gcs.mavlink.autopilots import STEERABLE, FlightMode
from gcs.mavlink.codec import Message
from gcs.mavlink.command_protocol import CommandRequest
from gcs.scenario.external import External
from gcs.supervisor.arming import ON_MISSION, ArmingSequence, Mission, Stage
from gcs.telemetry.state import VehicleView
from skytender import elementary
from skytender import mavlink as mav

FAR_M = 100e3
"""No origin is farther from the scenario's: the common frame is a plane (gcs/mavlink/common_frame.py)."""
SET_POINTS_FIRST_S = 1.0
"""PX4 wants a second of set points before offboard."""
PARAMETER_TRIES = 3
"""An external vehicle may not know our battery's parameters, and need not say so."""
TAKEOFF_AGAIN_S = 4.0
"""ArduCopter leaves the ground three seconds after it was armed, says so only then, and refuses to take off again."""
NEAR_SHARE = 0.2
"""Of the height of a take-off that may be missing at its end: autopilots are content with less than we are. One that
says by its mode that its take-off is over need not have come so far: a PX4 is content with 0.8 m less than it was
commanded, and moves its home's altitude, from which the height is reported, while it flies."""
ON_THE_WAY = frozenset({FlightMode.TAKEOFF, FlightMode.HOLD})
"""Modes from which offboard is asked for, of one that flies already when it is met."""
SHOWS_WITHIN_S = 2.5
"""An order shows in a HEARTBEAT, of which one a second comes, within so long."""
LATE_S, STALE_S = 0.3, 1.0
"""Autopilots leave offboard soon after the last set point (0.5 s by what plan B sets, and a period of ours is part of
that): a session that stood still for longer, or a link that was silent for longer, may have been why."""
BLAMED_S = 3.0
"""How long after that a hold is our own doing: it may need a HEARTBEAT or two to be reported. A return or a landing is
left alone even then, for a pilot may have wanted it; a PX4 that did so by itself, as it does by its defaults,
goes back to offboard by itself when set points flow again."""
COMING_DOWN = frozenset({FlightMode.RETURN, FlightMode.LAND})
"""Modes in which one that flies when it is met is waited for until it stands, and then armed: as a rule it is what an
earlier session ordered at its end."""
THEIRS = frozenset({FlightMode.MANUAL, FlightMode.RETURN, FlightMode.LAND})
"""Modes that are not on the way into offboard."""
_LED = frozenset({Stage.OFFBOARD, Stage.FLY, Stage.MISSION})
_FLOWN = _LED | {Stage.YIELDED}
_BEFORE_FLIGHT = frozenset({Stage.IDENTIFY, Stage.ARM, Stage.TAKEOFF})


class ExternalArmingSequence(ArmingSequence):
    """One external vehicle's way into the air and into offboard."""

    def __init__(self, sysid: int, takeoff_m: float, rules: External) -> None:
        super().__init__(sysid, takeoff_m, rejoins_itself=rules.rejoins)
        self._rules = rules
        self._now_s = 0.0
        self._begun_s = math.inf
        self._silent = self._flew = False
        self._booted_s = -math.inf
        self._took_off = self._climbs = self._on_its_way = False
        self._reads = 0
        self._decided_s = self._starved_s = self._takeoff_s = self._hold_asked_s = self._turned_s = -math.inf

    @property
    def sends_set_points(self) -> bool:
        """Whether set points should flow."""
        flown = self.stage in _FLOWN and self.stage is not Stage.MISSION
        return (flown or super().sends_set_points) and not self._silent

    def back_from(self, view: VehicleView) -> bool:
        """As `ArmingSequence.back_from`; where the scenario says `rejoins`, from anything."""
        return self._rejoins_itself or super().back_from(view)

    def mend(self, view: VehicleView) -> None:
        """As `ArmingSequence.mend`, also while its failsafe still flies it; a mode that it reports late counts too."""
        self._cut_off_s = self._now_s
        back = self.stage in (Stage.YIELDED, Stage.DOWN) and self.ordered is None and not self.left_out
        if back and self._rejoins_itself and self._has_energy(view):
            self.rejoin()

    def boot(self, view: VehicleView) -> None:
        """Its autopilot has booted: in flight it has fallen, if it does not say otherwise."""
        if not self._flew:
            return
        self._flew, self.booted, self._booted_s = False, True, self._now_s
        if self._rejoins_itself and self.ordered is None and not self.released and self._has_energy(view):
            self.rejoin()

    def decide(
        self, view: VehicleView, now_s: float, *, bound: bool = False, late_s: float = 0.0
    ) -> tuple[list[CommandRequest], list[Message]]:
        """As `ArmingSequence.decide`; a silent vehicle is asked for nothing."""
        if self.stage is Stage.BASE:
            self._begun_s = now_s  # what it is given to be armed in begins anew when it leaves
        elif self.stage is not Stage.IDENTIFY:
            self._begun_s = min(self._begun_s, now_s)
        elif self._begun_s == math.inf or self._took_off:  # at first, and when it is brought back
            self._begun_s, self._took_off = now_s, False
        if max(now_s - self._decided_s, late_s) > LATE_S or view.age_s > STALE_S or not view.alive:
            self._starved_s = now_s
        self._now_s = self._decided_s = now_s
        self._silent = not view.alive
        if self._silent:
            if self.stage in _FLOWN:
                self._cut_off_s = now_s
            return [], []
        wanted = super().decide(view, now_s, bound=bound)
        if view.fresh:  # else it may have fallen since
            self._flew = view.flying and (self.stage in _LED or self.ordered == "hold")
            self.booted = self.booted and not (view.armed and self._placed(view))
        return wanted

    def rests(self, view: VehicleView) -> bool:
        """Never: how long ago it was asked last is what it judges silence and late ticks by."""
        return False

    def _requests(self, view: VehicleView) -> list[Message]:
        if self._reads >= PARAMETER_TRIES:
            return []
        self._reads += 1
        return super()._requests(view)

    def _wanted(self, view: VehicleView, now_s: float) -> list[CommandRequest]:
        profile = view.profile
        if self.stage is Stage.ARM and view.mode not in profile.arms_in:
            return [self._command(mav.MAV_CMD_DO_SET_MODE, *profile.arming)]
        if self.stage is Stage.TAKEOFF:
            if not view.landed or now_s - self._takeoff_s < TAKEOFF_AGAIN_S:
                return []
            self._takeoff_s = now_s
        if self.stage is Stage.OFFBOARD and now_s - self._stage_since_s < SET_POINTS_FIRST_S:
            return []
        if self.stage is Stage.DOWN and self.left_out and view.armed and view.landed:
            return [self._command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 0.0, 0.0)]
        wanted = super()._wanted(view, now_s)
        if wanted and self.stage is Stage.MISSION and self.mission == "hold":
            self._hold_asked_s = now_s
        return wanted

    def _next(self, view: VehicleView) -> Stage:
        stage = self.stage
        if stage in _BEFORE_FLIGHT:
            if self._hopeless(view):
                return Stage.DOWN
            stage = self._before_flight(view)
        if stage not in _FLOWN or stage is not self.stage:
            return stage if stage is not self.stage or stage in _BEFORE_FLIGHT else super()._next(view)
        if self.grounded and stage is not Stage.YIELDED:
            return Stage.BASE
        if not view.armed and (view.landed or self.booted):
            return Stage.ARM if self.rejoining else Stage.DOWN
        if self.mission and self.stage is not Stage.OFFBOARD and (onward := self._mission_stage(view)) is not None:
            return onward
        if view.mode in STEERABLE:
            self.rejoining = False
            if view.landed and stage is not Stage.FLY:
                self._begun_s = self._now_s
                return Stage.TAKEOFF
            return Stage.FLY
        if stage is Stage.OFFBOARD:
            return Stage.YIELDED if view.mode in THEIRS and not self.rejoining else Stage.OFFBOARD
        shows = self._now_s - self._turned_s <= SHOWS_WITHIN_S  # what was ordered last may be seen only now
        if self.rejoining or ((stage is Stage.MISSION or shows) and view.mode in ON_MISSION):
            return Stage.OFFBOARD  # it was to step aside, or is done
        starved = self._now_s - self._starved_s <= BLAMED_S
        return Stage.OFFBOARD if starved and stage is Stage.FLY and view.mode is FlightMode.HOLD else Stage.YIELDED

    def _mission_stage(self, view: VehicleView) -> Stage | None:
        """Its stage as far as its mission says so; its mode may still be the one before the last order."""
        if view.mode is FlightMode.MISSION:
            self._on_its_way = self.mission == "hold"
            return Stage.MISSION if self.mission == "fly" or self.stage is Stage.MISSION else None
        if self.stage is not Stage.MISSION:
            begins = self.mission == "fly" and self.stage is Stage.FLY and view.mode in STEERABLE
            return Stage.MISSION if begins else None
        waits = self.mission == "hold" or self._on_its_way or self._now_s - self._starved_s <= BLAMED_S
        shows = self._now_s - self._hold_asked_s <= SHOWS_WITHIN_S  # it was to go on before it had said that it holds
        if view.mode in STEERABLE or (view.mode is FlightMode.HOLD and (waits or shows)):
            return Stage.MISSION
        return Stage.YIELDED

    def go_on_mission(self, mission: Mission) -> None:
        """As `ArmingSequence.go_on_mission`."""
        super().go_on_mission(mission)
        self._on_its_way, self._turned_s = True, self._now_s

    def _placed(self, view: VehicleView) -> bool:
        """Whether it has said where it is and in which mode, in this boot."""
        if view.p_ned is None or view.last_received_s < 0.0:
            return False
        return not self.booted or (view.fresh and view.last_received_s > self._booted_s)

    def _before_flight(self, view: VehicleView) -> Stage:
        if not self._placed(view):
            return Stage.IDENTIFY
        if self.stage is Stage.IDENTIFY:
            return self._when_flying(view) if view.flying else Stage.ARM
        climbed, self._climbs = self._climbs, view.armed and view.mode is FlightMode.TAKEOFF
        if not view.armed:
            return Stage.ARM
        self._took_off = True
        if view.landed:
            return Stage.TAKEOFF
        if view.mode in THEIRS:
            return Stage.YIELDED
        assert view.height_m is not None
        over = climbed and view.mode is FlightMode.HOLD
        return Stage.OFFBOARD if over or view.height_m >= self._takeoff_m * (1.0 - NEAR_SHARE) else Stage.TAKEOFF

    def _when_flying(self, view: VehicleView) -> Stage:
        """It is in the air already when it is met."""
        self._took_off = True
        if view.mode in STEERABLE:
            return Stage.FLY
        if view.mode in COMING_DOWN and not self.rejoining:
            self._took_off, self._begun_s = False, self._now_s
            return Stage.IDENTIFY
        return Stage.OFFBOARD if view.mode in ON_THE_WAY or self.rejoining else Stage.YIELDED

    def _hopeless(self, view: VehicleView) -> bool:
        """Whether it is to be left out, and why."""
        offset, waited_s = view.origin_offset_ned, self._rules.arm_within_s
        if offset is not None and elementary.norm(offset[:2]) > FAR_M:
            self.left_out = (
                f"Its origin is over {FAR_M / 1e3:.0f} km from the scenario's: is one of them wrong? Left out"
            )
        elif self._now_s - self._begun_s <= waited_s or not view.landed:
            return False
        elif view.origin_offset_ned is None:
            self.left_out = f"Has not reported its frame's origin within {waited_s:g} s: left out"
        elif not self._placed(view):
            self.left_out = f"Has not reported its position within {waited_s:g} s: left out"
        elif not view.armed:
            self.left_out = f"Has not let itself be armed within {waited_s:g} s: left out"
        else:
            self.left_out = f"Has not taken off within {waited_s:g} s: left out"
        return True
