"""One vehicle: modes, failsafes and transfer around the flight law. No socket, no clock, no process-wide state.

A step is always the same: failsafes → mode's set point → flight law → transfer.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import cython
from cython.cimports.libc.math import isnan, rint
from cython.cimports.simvehicle.autopilot.body import CHUNK_MS, STEP_MS
from cython.cimports.simvehicle.autopilot.vehicle import SetPoint

from simvehicle.autopilot.body import CELL_EMPTY_V, CELL_FULL_V, CELLS, Body, Start
from simvehicle.autopilot.energy_transfer import Envelope, Exchange, Transfer, TransferOrder, TransferSide
from simvehicle.autopilot.failures import Failure
from simvehicle.autopilot.follow import Followed, smoothed
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.geofence import Fence
from simvehicle.autopilot.identity import Identity
from simvehicle.autopilot.maneuvers import (
    REACHED_M,
    Anchor,
    ManeuverTarget,
    OffboardSetPoint,
    ReturnLeg,
    resting_place,
    target_of,
)
from simvehicle.autopilot.mission import Leg, Mission, Outcome
from simvehicle.autopilot.modes import (
    COPTER_FAILSAFES,
    FAILSAFES,
    PROGRESS,
    RESTING,
    STAND_DOWN,
    Mode,
    Rule,
    Severity,
    Trigger,
    rule_for,
)
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vectors import Vec3
from simvehicle.law.plants import Plant
from skytender import elementary

FENCE_HOLD, FENCE_RETURN = 2, 3
"""Values of GF_ACTION beside nothing and a warning."""

_OFFBOARD, _REFUEL, _GUIDED = Mode.OFFBOARD, Mode.REFUEL, Mode.GUIDED


def _nothing() -> None:
    """Do nothing beside a change of mode."""


class Vehicle(Body):
    """Behaviour of one quadrotor; `advance` is the only thing that moves its time."""

    identity: Identity
    frame: LocalFrame
    origin: Any
    home: Any
    home_locked: bool
    unix_epoch_us: int
    mode: Mode
    armed: bool
    exchange: Exchange
    mission: Mission | None
    _fence: Fence
    _fenced: bool
    rally_ned: tuple[Vec3, ...]
    failed: set[Failure]
    booting: bool
    announcements: list[tuple[Severity, str]]
    on_change: Callable[[], None]
    gcs_seen_s: float
    set_point_now: Any
    station_leads: bool
    separation: Any
    period_s: float
    leads: bool
    ordered: bool
    in_failsafe: bool
    gcs_main: int
    takeover_allowed: bool
    intended: Mode
    leader: Any
    gcs_loss_s: float
    set_point_loss_s: float
    fastest_m_s: float
    floor_j: float
    _breached: bool
    """whether it was outside its fence, armed, when that was last looked at"""
    _followed: Followed | None
    _return_ned: Vec3
    _anchor: Anchor
    _leg: ReturnLeg | None
    _plan: Any
    _began_s: float
    _over_home_s: float
    _granted_s: float
    _takeoff_down_m: float
    yaw_ned: float

    def __init__(
        self, identity: Identity, parameters: Parameters, frame: LocalFrame, start: Start, plant: Plant | None = None
    ) -> None:
        Body.__init__(self, parameters, start, plant)
        self.identity = identity
        self.frame = frame
        origin = cython.declare("const double[::1]", frame.row)
        self.origin = cython.address(origin[0])
        self.home_ned = start.p_ned
        self.home_locked = False
        self.unix_epoch_us = 0
        self.mode = self.intended = _OFFBOARD if start.airborne else Mode.HOLD
        self.armed = start.airborne
        self.exchange = Exchange()
        self.mission = None
        self.fence = Fence()
        self.rally_ned = ()
        self.failed = set()
        self.booting = False
        self.announcements = []
        self.on_change = _nothing
        self.gcs_seen_s = self.set_point_now.time_s = self.set_point_before.time_s = math.nan
        self.station_leads = self.leads = self.takeover_allowed = False
        self.gcs_main = 0
        self.ordered = True
        self.in_failsafe = False
        self.separation = None
        self._followed = None
        self._breached = False
        self._return_ned = start.p_ned
        self._anchor = Anchor(start.p_ned, 0.0, start.p_ned[2])
        self._leg = self._plan = None
        self._began_s = self._granted_s = 0.0
        self._over_home_s = math.nan
        self._takeoff_down_m = start.p_ned[2]
        self.yaw_ned = start.attitude_ned_rad[2]
        if start.airborne:
            self.set_point(OffboardSetPoint(start.p_ned, start.v_ned, (True, True, True), None, 0.0))

    def retune(self) -> None:
        """As every body; and let its limits be those of now."""
        Body.retune(self)
        values = self.parameters
        self.gcs_loss_s, self.set_point_loss_s = values["COM_DL_LOSS_T"], values["COM_OF_LOSS_T"]
        self.fastest_m_s = values["MPC_XY_VEL_MAX"]
        self.floor_j = values["BAT_EMERGEN_THR"] * values["SIM_BAT_CAP_J"]

    # what it is now

    @property
    def fence(self) -> Fence:
        """Where it may be."""
        return self._fence

    @fence.setter
    def fence(self, fence: Fence) -> None:
        self._fence, self._fenced = fence, bool(fence.inside or fence.outside)

    @property
    def home_ned(self) -> Vec3:
        """Place that it returns to, m."""
        return self.home[0], self.home[1], self.home[2]

    @home_ned.setter
    def home_ned(self, place_ned: Vec3) -> None:
        self.home[0], self.home[1], self.home[2] = place_ned

    @property
    def transfer(self) -> Transfer | None:
        """The transfer in progress."""
        return self.exchange.current

    @property
    def given_j(self) -> int:
        """Joules given since boot."""
        return self.exchange.given_j

    @property
    def received_j(self) -> int:
        """Joules received since boot."""
        return self.exchange.received_j

    def voltage_v(self) -> float:
        """Voltage at the battery: the plant's, else linear in the charge."""
        if self.plant.rotors:
            return self.plant.rotors.voltage_v
        share = min(max(self.shown_j() / self.capacity_j, 0.0), 1.0)
        return CELLS * (CELL_EMPTY_V + (CELL_FULL_V - CELL_EMPTY_V) * share)

    def current_a(self) -> float:
        """Current from the battery: the plant's, else of the power at the voltage."""
        return self.plant.rotors.current_a if self.plant.rotors else self.power_w / self.voltage_v()

    def shown_j(self) -> float:
        """Energy in the battery as reported: none where it has failed."""
        return 0.0 if self.failed and Failure.BATTERY in self.failed else self.plant.row.remaining_j

    def percent(self) -> int:
        """Charge in whole percent."""
        return cython.cast(cython.int, min(max(rint(100.0 * self.shown_j() / self.capacity_j), 0.0), 100.0))

    # what others ask of it

    def trigger(self, event: Trigger) -> bool:
        """Let an event happen; False where the table of modes refuses it."""
        rule = rule_for(event, self.mode, self.armed)
        if rule is None:
            return False
        as_intended = self.mode is self.intended
        self._apply(rule)
        self.ordered = True
        self.in_failsafe = self.in_failsafe and event in PROGRESS
        if as_intended or event not in PROGRESS:
            self.intended = self.mode
        return True

    def outside(self) -> bool:
        """Whether it is outside its fence now."""
        return self._fenced and self._fence.breached(*self.p_ned[:2])

    def arming_refusal(self) -> str | None:
        """Why the vehicle would not arm; None when it would."""
        if self.parameters["ARMING_CHECK"] == 0.0:
            return None
        for failure in (Failure.GPS, Failure.BATTERY, Failure.MOTOR) if self.failed else ():
            if failure in self.failed:
                return f"{failure} failed"
        if self.battery_low():
            return "battery below BAT_EMERGEN_THR"
        if self.outside() and self.parameters["GF_ACTION"] != 0:
            return "outside the geofence"
        return None

    def take_off(self, height_m: float) -> bool:
        """Climb to a height above home, or stay where the vehicle is higher; False where the mode table refuses."""
        if rule_for(Trigger.TAKEOFF, self.mode, self.armed) is None:
            return False
        self._takeoff_down_m = min(self.home_ned[2] - height_m, self.p_ned[2])
        self._anchor = replace(self._anchor, down_m=self._takeoff_down_m)
        return self.trigger(Trigger.TAKEOFF)

    def reposition(self, p_ned: Vec3, speed_m_s: float | None = None, yaw_ned_rad: float = math.nan) -> bool:
        """Hold at another place, flying there no faster than asked, with a yaw (NaN: as it is); False where the vehicle
        is not flying."""
        hold = Trigger.GUIDED_HOLD if self.identity.guided else Trigger.HOLD
        if self.landed or not self.armed or not self.trigger(hold):
            return False
        self._anchor = replace(self._anchor, p_ned=p_ned, speed_m_s=speed_m_s)
        if not isnan(yaw_ned_rad):
            self.yaw_ned = math.remainder(yaw_ned_rad, math.tau)
        return True

    def change_speed(self, speed_m_s: float | None) -> None:
        """Fly the mission, or to where it was sent, at another speed; None for the parameters' own."""
        self._anchor = replace(self._anchor, speed_m_s=speed_m_s)
        if self.mission is not None:
            self.mission.speed_m_s = speed_m_s

    def load_mission(self, legs: Sequence[Leg]) -> None:
        """Take a new mission, or none; a vehicle that flies the old one begins the new one, or holds."""
        self.mission = Mission(legs) if legs else None
        if self.mode is Mode.MISSION:
            if self.mission is None:
                self.trigger(Trigger.MISSION_DONE)
            else:
                self.mission.enter()

    def receive_target(self, p_ned: Vec3, v_ned: Vec3) -> None:
        """Take in the position of a target that may be followed."""
        north, east, _ = self.p_ned
        self._followed = smoothed(
            self._followed,
            p_ned,
            v_ned,
            self.time_s,
            kept=self.parameters["FLW_TGT_RS"],
            towards_rad=elementary.atan2(p_ned[1] - east, p_ned[0] - north),
        )

    def restart(self) -> None:
        """Forget everything that a reboot forgets; place, time, energy and its counters stay."""
        self.failed.clear()
        self.load_mission(())
        self.fence, self.rally_ned = Fence(), ()
        self._followed = None
        self.gcs_main = 0
        self.home_locked = False
        self.gcs_seen_s = self.set_point_now.time_s = math.nan
        if self.leads:
            self.separation.release()
        self.trigger(Trigger.HOLD)
        self.retune()

    def set_point(self, setpoint: OffboardSetPoint) -> None:
        """Take an offboard set point; it is flown in offboard and refuel, and keeps them alive."""
        wanted = cython.declare(SetPoint)
        for i in range(3):
            wanted.p_ned[i], wanted.v_ned[i] = setpoint.p_ned[i], setpoint.v_ned[i]
            wanted.use_position[i] = setpoint.use_position[i]
        wanted.place_alone = False
        wanted.yaw_ned = math.nan if setpoint.yaw_ned_rad is None else setpoint.yaw_ned_rad
        wanted.yaw_rate = math.nan if setpoint.yaw_rate_rad_s is None else setpoint.yaw_rate_rad_s
        wanted.time_s = setpoint.time_s
        self.take_set_point(cython.address(wanted))

    def take_set_point(self, wanted: Any) -> None:
        """`set_point`."""
        self.set_point_before = self.set_point_now
        self.set_point_now = wanted[0]
        self.station_leads = False
        if self.mode is _GUIDED and self.armed and not self.stands():
            self.trigger(Trigger.OFFBOARD)

    def lead_of_set_points(self, period_s: float) -> tuple[Vec3, Vec3]:
        """Place and velocity of the virtual leader that the last set point, of a period, brought the vehicle.

        A set point has the leader's place at the period's beginning and its mean velocity in it; what that grows by
        from one period to the next, the velocity grows by half as much until the period's end.
        """
        now, before = cython.address(self.set_point_now), cython.address(self.set_point_before)
        p, v = cython.declare(cython.double[3]), cython.declare(cython.double[3])
        follows = now.time_s - before.time_s < 1.5 * period_s  # not where there is none, which is NaN
        for i in range(3):
            p[i] = now.p_ned[i] + period_s * now.v_ned[i]
            v[i] = now.v_ned[i] + (0.5 * (now.v_ned[i] - before.v_ned[i]) if follows else 0.0)
        return (p[0], p[1], p[2]), (v[0], v[1], v[2])

    def put_leader(self, row: tuple[float, ...]) -> None:
        """Report its own virtual leader: place, velocity, and the acceleration that it wants, NED."""
        for i in range(9):
            self.leader[i] = row[i]

    def returning_s(self) -> float:
        """Time since it began to return by the fleet's timetable; negative while it does not."""
        by_plan = self._plan is not None and (self.mode is Mode.RETURN or self.mode is Mode.LAND)
        return self.time_s - self._began_s if by_plan else -1.0

    def return_from(self, p_ned: Vec3) -> None:
        """Hold at a place, or climb over it on a return."""
        if self.mode is Mode.HOLD or (self.mode is Mode.RETURN and self._leg in (None, ReturnLeg.UP, ReturnLeg.WAIT)):
            self._anchor = replace(self._anchor, p_ned=p_ned)

    def alone(self, for_s: float) -> bool:
        """Whether a ground station that was there has been silent for so long."""
        return self.time_ms / 1e3 - self.gcs_seen_s > for_s

    def setpoints_fresh(self) -> bool:
        """Whether offboard would have something to fly."""
        return self.time_ms / 1e3 - self.set_point_now.time_s <= self.set_point_loss_s

    def receive_gcs_heartbeat(self) -> None:
        """A ground station's HEARTBEAT has come."""
        self.gcs_seen_s = self.time_ms / 1e3

    def receive_gcs_command(self) -> None:
        """A command of the ground station has come: one that was silent is there again, and the mode that it sets
        stays. One whose HEARTBEAT never came is not waited for."""
        if not isnan(self.gcs_seen_s):
            self.receive_gcs_heartbeat()

    def order(self, order: TransferOrder) -> str | None:
        """Begin or end a transfer; the reason where it is refused."""
        if order.role is TransferSide.STOP:
            if self.transfer is not None and self.transfer.stopped_by(order):
                self.end_transfer("stopped")
            return None
        if order.role is TransferSide.SETTLE:
            return self._settle(order)
        reason = self.exchange.refuses(order, self.p_ned, self.time_s, self.envelope())
        if reason is not None or self.transfer is not None:
            return reason
        charged = order.role is TransferSide.RECEIVE and self.landed and not self.armed  # at a base, in whatever mode
        if not charged and not self.trigger(Trigger.REFUEL):
            return f"not from mode {self.mode}"
        self.exchange.begin(order, self.time_s)
        return None

    def announce(self, severity: Severity, text: str) -> None:
        """Say something to everyone by STATUSTEXT."""
        self.announcements.append((severity, text))

    # time

    def set_clock(self, time_ms: int, unix_us: int) -> None:
        """Start the clock without a step; set points known so far become as old as now."""
        self.time_ms = time_ms
        self.unix_epoch_us = unix_us - 1000 * time_ms
        self._anchor = replace(self._anchor, time_s=self.time_s)
        if not isnan(self.set_point_now.time_s):
            self.set_point_now.time_s = self.time_s

    def advance(self, to_ms: int) -> None:
        """Fly to a time; whole steps of 4 ms, a remainder waits for the next call."""
        steps = (to_ms - self.time_ms) // STEP_MS
        if steps > self.room:
            self.have_room(steps)
        self.steps, self._granted_s = 0, self.time_ms / 1e3
        while to_ms - self.time_ms >= STEP_MS:
            span_ms = min(to_ms - self.time_ms, CHUNK_MS)
            steps = span_ms // STEP_MS
            self._check_failsafes()
            self._progress()
            self._fly(steps)
            self.time_ms += steps * STEP_MS
            self._move_joules(steps * STEP_MS / 1e3)

    def mode_target(self) -> ManeuverTarget:
        """Target of a mode that flies by itself."""
        return target_of(
            self.mode,
            self._anchor,
            p_ned=self.p_ned,
            home_ned=self.home_ned,
            return_ned=self._return_ned,
            now_s=self.time_s,
            parameters=self.parameters,
            mission=self.mission,
            followed=self._followed,
            blind=Failure.GPS in self.failed,
            leg=self._leg,
            descend_m=math.inf if self._plan is None else self._plan.descend_m,
        )

    def _fly(self, steps: int) -> None:
        if self.separation is not None and self._keeps_apart():
            self.put_target(self.separation.target)
        elif (self.mode is _OFFBOARD or self.mode is _REFUEL) and not isnan(self.set_point_now.time_s):
            self._steer(steps * STEP_MS / 1e3)
        else:
            self.put_target(self.mode_target())
        turning = self.armed and not (self.failed and Failure.MOTOR in self.failed)
        at_rest = self.stands() and self.mode in RESTING
        self.fly(steps, self.yaw_ned, turning and not at_rest)

    def _keeps_apart(self) -> bool:
        """Whether it follows a leader of its own: not in a grant with which a set point came, nor where a pilot's was
        the last, nor without knowing where it is."""
        steered = self.mode is _OFFBOARD or self.mode is _REFUEL
        led = steered and (not self.station_leads or self.set_point_now.time_s > self._granted_s - 1e-6)
        if led or (self.failed and Failure.GPS in self.failed):
            if self.leads:
                self.separation.release()
            return False
        return self.separation.step()

    def _steer(self, dt_s: float) -> None:
        """Command the set point, and the yaw that it wants after so long."""
        wanted, command = cython.address(self.set_point_now), cython.address(self.command)
        if not isnan(wanted.yaw_rate):
            fastest_rad_s = self.fastest_turn_rad_s
            self.yaw_ned += dt_s * min(max(wanted.yaw_rate, -fastest_rad_s), fastest_rad_s)
        elif not isnan(wanted.yaw_ned):
            self.yaw_ned = wanted.yaw_ned
        for i in range(3):
            sign = 1.0 if i == 0 else -1.0
            place = wanted.p_ned[i] - self.shift_ned[i] if self.shifted else wanted.p_ned[i]
            command.position[i], command.velocity[i] = sign * place, sign * wanted.v_ned[i]
            command.use_position[i] = wanted.use_position[i]
        command.time_s, command.speed_max = wanted.time_s, self.fastest_m_s

    def _progress(self) -> None:
        """Events that the vehicle finds out by itself."""
        if self.mode is _OFFBOARD and not self.failed:
            return
        p_ned = self.p_ned
        if self.mode is Mode.TAKEOFF and p_ned[2] <= self._takeoff_down_m + 0.5 * REACHED_M:
            self.trigger(Trigger.GUIDED_HOLD if self.identity.guided else Trigger.TAKEOFF_DONE)
            north, east, _ = self._anchor.p_ned
            self._anchor = replace(self._anchor, p_ned=(north, east, self._takeoff_down_m))
        elif self.mode is Mode.RETURN:
            self._progress_return(p_ned)
        elif self.mode is Mode.LAND and self.landed:
            self.trigger(Trigger.TOUCHDOWN)
        elif self.mode is Mode.MISSION and self.armed:
            self._progress_mission(p_ned)
        if Failure.MOTOR in self.failed and self.landed:
            self.trigger(Trigger.CRASHED)

    def _progress_return(self, p_ned: Vec3) -> None:
        """Go on to a return's next leg, by the fleet's timetable if it was the ground station that was lost."""
        plan, low = self._plan, True
        if plan is not None:
            self._leg = self._leg_of(plan, p_ned)
            low = self._leg is ReturnLeg.DOWN and p_ned[2] >= self._return_ned[2] - plan.descend_m - REACHED_M
        there = low and elementary.distance(p_ned[:2], self._return_ned[:2]) < REACHED_M
        if not there or elementary.norm(self.v_ned) >= REACHED_M:
            return
        if isnan(self._over_home_s):
            self._over_home_s = self.time_s
        if plan is not None or self.time_s - self._over_home_s >= self.parameters["RTL_LAND_DELAY"]:
            self.trigger(Trigger.HOME_REACHED)

    def _leg_of(self, plan: Any, p_ned: Vec3) -> ReturnLeg:
        """Leg that is due. One that has not climbed in time waits where it began until the others have landed."""
        flown_s = self.time_s - self._began_s
        if self._leg is ReturnLeg.DOWN or flown_s < plan.level_after_s:
            return self._leg or ReturnLeg.UP
        if self._leg is not ReturnLeg.LEVEL and p_ned[2] > self._anchor.down_m + REACHED_M:
            if flown_s < plan.again_after_s:
                return ReturnLeg.WAIT
            self._began_s = self.time_s
            return ReturnLeg.UP
        over = elementary.distance(p_ned[:2], self._return_ned[:2]) < REACHED_M
        return ReturnLeg.DOWN if over and flown_s >= plan.down_after_s else ReturnLeg.LEVEL

    def _progress_mission(self, p_ned: Vec3) -> None:
        mission = self.mission
        assert mission is not None, "mode MISSION is entered with a mission only"
        if mission.landing and self.landed:
            mission.touched_down()
            self.trigger(Trigger.TOUCHDOWN)
            return
        outcome = mission.advance(
            self.time_s,
            p_ned,
            landed=self.landed,
            home_ned=self.home_ned,
            radius_m=self.parameters["NAV_ACC_RAD"],
            takeoff_m=self.parameters["MIS_TAKEOFF_ALT"],
        )
        if outcome is not Outcome.GOING:
            self.trigger(Trigger.RETURN if outcome is Outcome.RETURN else Trigger.MISSION_DONE)

    def _check_failsafes(self) -> None:
        if not self.armed:
            self._breached = False
            return
        crossed = self._fence_crossed()
        now_s = self.time_ms / 1e3
        battery, gps = self.battery_low(), bool(self.failed) and Failure.GPS in self.failed
        silent, steered = now_s - self.gcs_seen_s > self.gcs_loss_s, self.setpoints_fresh()
        if not (battery or gps or silent or crossed) and steered:
            return
        action = self.parameters["GF_ACTION"]
        happened = (  # in the order of FAILSAFES
            *(battery, gps, silent),
            crossed and action == FENCE_RETURN,
            crossed and action == FENCE_HOLD,
            not steered,
        )
        for event, has_happened in zip(FAILSAFES, happened, strict=True):
            if has_happened:
                rule = rule_for(event, self.mode, self.armed)
                if rule is None:
                    continue
                if event is Trigger.SETPOINTS_LOST and self.identity.guided:
                    self._hold_guided()
                else:
                    self._apply(rule if not self.landed else STAND_DOWN)
                self.ordered = False
                self.in_failsafe = not self.identity.copter_rules or event in COPTER_FAILSAFES
                if event is Trigger.FENCE_HOLD:
                    self._enter(self.mode)
                if event is Trigger.GCS_LOST and self.mode is Mode.RETURN and self.separation is not None:
                    self._plan, self._return_ned = self.separation.plan, self.separation.home_ned

    def _hold_guided(self) -> None:
        """Hold without set points: where the last one leads that gave a place alone, else where it comes to rest."""
        self.trigger(Trigger.GUIDED_HOLD)
        now = cython.address(self.set_point_now)
        if now.place_alone:
            self._anchor = replace(self._anchor, p_ned=(now.p_ned[0], now.p_ned[1], now.p_ned[2]))

    def _fence_crossed(self) -> bool:
        """Whether the vehicle has left the fence since it was last asked, or was armed outside; announced, whatever is
        done about it."""
        outside = self.outside()
        crossed = outside and not self._breached and self.parameters["GF_ACTION"] != 0
        self._breached = outside
        if crossed:
            self.announce(Severity.WARNING, "Geofence breached")
        return crossed

    def battery_low(self) -> bool:
        """Whether it holds less than it lands at, or says so since it has failed."""
        empty = bool(self.failed) and Failure.BATTERY in self.failed
        return empty or self.plant.row.remaining_j < self.floor_j

    def _apply(self, rule: Rule) -> None:
        before = (self.mode, self.armed)
        if rule.arming is not None:
            if rule.arming and self.landed and not self.home_locked:
                self.home_ned = self.p_ned
            self.armed = rule.arming
        if rule.mode is not None:
            self.mode = rule.mode
            if rule.mode is not before[0]:
                self._enter(rule.mode)
        if rule.text and (self.mode, self.armed) != before:
            self.announce(rule.severity, rule.text)
            self.on_change()
        if self.mode is not Mode.REFUEL and self.transfer is not None:
            self.end_transfer(f"mode {self.mode}")

    def _enter(self, mode: Mode) -> None:
        """Fix what a mode keeps while it lasts: the place where the vehicle can come to rest, or stands."""
        p_ned = self.p_ned
        place, down_m = resting_place(p_ned, self.v_ned, ground=self.ground, landed=self.landed), p_ned[2]
        if self.leads:
            place = self.separation.resting_place()
        if mode is Mode.TAKEOFF:
            place, down_m = p_ned, self._takeoff_down_m
        elif mode is Mode.MISSION and self.mission is not None:
            self.mission.enter()
        elif mode is Mode.RETURN:
            self._leg, self._plan, self._began_s, self._over_home_s = None, None, self.time_s, math.nan
            self._return_ned = min(
                (self.home_ned, *self.rally_ned), key=lambda p: elementary.distance(p[:2], p_ned[:2])
            )
            down_m = min(p_ned[2], self.home_ned[2] - self.parameters["RTL_RETURN_ALT"])
        self._anchor = Anchor(place, self.time_s, down_m)

    # transfer

    def envelope(self) -> Envelope:
        """Distance and speed of a giver that allow this vehicle to take from it."""
        return Envelope(self.parameters["SIM_XFER_DIST"], self.parameters["SIM_XFER_SPEED"])

    def _move_joules(self, dt_s: float) -> None:
        if self.exchange.current is None:
            return
        joules, reason = self.exchange.move(
            dt_s,
            self.time_s,
            self.p_ned,
            remaining_j=self.remaining_j,
            capacity_j=self.capacity_j,
            envelope=self.envelope(),
        )
        self.plant.charge(joules)
        if reason is not None:
            self.end_transfer(reason)

    def _settle(self, order: TransferOrder) -> str | None:
        back_j, reason = self.exchange.settle(order, self.capacity_j - self.remaining_j)
        if back_j:
            self.plant.charge(back_j)
            self.announce(Severity.INFO, f"Took back {back_j} J that did not arrive")
        return reason

    def end_transfer(self, reason: str) -> None:
        """End the own side of a transfer, if there is one."""
        if self.transfer is not None:
            self.announce(Severity.INFO, f"{self.exchange.end(self.time_s)}: {reason}")
            self.trigger(Trigger.REFUEL_END)
            self.on_change()
