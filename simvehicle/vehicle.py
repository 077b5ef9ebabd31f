"""One vehicle: modes, failsafes and transfer around the flight law. No socket, no clock, no process-wide state.

A step is always the same: failsafes → mode's set point → flight law → transfer.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from simvehicle import flight
from simvehicle.dynamics import attitude_ned_from_nwu, body_rates, ned_from_nwu
from simvehicle.geo import LocalFrame
from simvehicle.mavlink.identity import Identity
from simvehicle.mavlink.parameters import Parameters
from simvehicle.mavlink.telemetry import Snapshot, Vec3
from simvehicle.modes import FAILSAFES, Event, Mode, Rule, Severity, rule_for
from simvehicle.params import pack
from simvehicle.transfer import Envelope, Neighbour, Order, Role, Transfer, refusal

STEP_MS = 4
CHUNK_MS = 100
"""Modes, failsafes and transfer are looked at this often at least, however long the step asked for."""
REACHED_M = 0.3
NO_POSITION: Vec3 = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Start:
    """Where and how a vehicle begins; `airborne`: armed, in offboard on its own state, and without a ground."""

    p_ned: Vec3 = NO_POSITION
    v_ned: Vec3 = NO_POSITION
    attitude_ned_rad: Vec3 = NO_POSITION
    airborne: bool = False


@dataclass(frozen=True)
class SetPoint:
    """What offboard control asked for last; `use_position` and `use_velocity` tell which axes count."""

    p_ned: Vec3
    v_ned: Vec3
    use_position: tuple[bool, bool, bool]
    yaw_ned_rad: float | None
    time_s: float


class Vehicle:
    """State and behaviour of one quadrotor; `advance` is the only thing that moves its time."""

    def __init__(self, identity: Identity, parameters: Parameters, frame: LocalFrame, start: Start) -> None:
        self.identity = identity
        self.parameters = parameters
        self.frame = frame
        self.home_ned: Vec3 = start.p_ned
        self.time_ms = 0
        self.unix_epoch_us = 0
        self.mode = Mode.OFFBOARD if start.airborne else Mode.HOLD
        self.armed = start.airborne
        self.ground = not start.airborne
        self.given_j = 0
        self.received_j = 0
        self.transfer: Transfer | None = None
        self.transfer_ended_s = -math.inf
        self.neighbours: dict[int, Neighbour] = {}
        self.announcements: list[tuple[Severity, str]] = []
        self.on_change: Callable[[], None] = lambda: None
        self._initial_params = parameters.flight()
        self.initial_j = self._initial_params.battery.initial_j
        self.retune()
        self.state: NDArray[np.float64] = flight.initial_state(
            self._initial_params,
            position_nwu=_nwu(start.p_ned),
            velocity_nwu=_nwu(start.v_ned),
            attitude_rad=(start.attitude_ned_rad[0], -start.attitude_ned_rad[1], -start.attitude_ned_rad[2]),
            airborne=start.airborne,
        )[np.newaxis]
        self.thrust_m_s2: NDArray[np.float64] = np.empty((1, 0))
        self._power_w = 0.0
        self._gcs_seen_s: float | None = None
        self._setpoint: SetPoint | None = None
        self._anchor_ned: Vec3 = start.p_ned
        self._anchor_s = 0.0
        self._takeoff_down_m = 0.0
        self._return_down_m: float | None = None
        self._command = np.zeros((1, flight.COMMAND_SIZE))
        self._yaw_ned = start.attitude_ned_rad[2]
        if start.airborne:
            self._setpoint = SetPoint(start.p_ned, start.v_ned, (True, True, True), None, 0.0)

    # what it is now

    @property
    def time_s(self) -> float:
        """Seconds since boot."""
        return self.time_ms / 1e3

    @property
    def p_ned(self) -> Vec3:
        """Position in the local frame, m."""
        return _ned(self.state[0, flight.POSITION])

    @property
    def v_ned(self) -> Vec3:
        """Velocity, m/s."""
        return _ned(self.state[0, flight.VELOCITY])

    @property
    def euler_rates_ned(self) -> Vec3:
        """Time derivatives of roll, pitch and yaw, rad/s."""
        return _tuple(attitude_ned_from_nwu(self.state[0, flight.RATES]))

    @property
    def landed(self) -> bool:
        """Standing on the ground."""
        return self.ground and self.p_ned[2] >= 0.0 and self.v_ned == NO_POSITION

    @property
    def remaining_j(self) -> float:
        """Energy in the battery."""
        return float(self.state[0, flight.REMAINING_J])

    @property
    def drawn_j(self) -> float:
        """Energy used by motors and avionics since boot."""
        return float(self.state[0, flight.DRAWN_J])

    @property
    def capacity_j(self) -> float:
        """What the battery holds."""
        return self.parameters["SIM_BAT_CAP_J"]

    def snapshot(self) -> Snapshot:
        """Everything that telemetry tells, at the present time."""
        row = self.state[0]
        attitude_nwu = row[flight.ATTITUDE]
        p, q, r = body_rates(attitude_nwu, row[flight.RATES])
        return Snapshot(
            identity=self.identity,
            frame=self.frame,
            time_ms=self.time_ms,
            unix_us=self.unix_epoch_us + 1000 * self.time_ms,
            mode=self.mode,
            armed=self.armed,
            landed=self.landed,
            ready_to_arm=self.arming_refusal() is None,
            p_ned=self.p_ned,
            v_ned=self.v_ned,
            attitude_ned=_tuple(attitude_ned_from_nwu(attitude_nwu)),
            rates_body=(float(p), -float(q), -float(r)),
            target_p_ned=_ned(row[flight.REFERENCE_POSITION]),
            target_v_ned=_ned(row[flight.REFERENCE_VELOCITY]),
            target_yaw_ned=self._yaw_ned,
            home_ned=self.home_ned,
            power_w=self._power_w,
            drawn_j=self.drawn_j,
            remaining_j=self.remaining_j,
            capacity_j=self.capacity_j,
            control_effort=float(row[flight.EFFORT]),
            given_j=self.given_j,
            received_j=self.received_j,
        )

    # what others ask of it

    def retune(self) -> None:
        """Fly with the parameters' present values from the next step on."""
        self._packed = pack(self.parameters.flight())[np.newaxis]

    def trigger(self, event: Event) -> bool:
        """Let an event happen; False where the table of modes refuses it."""
        rule = rule_for(event, self.mode, self.armed)
        if rule is None:
            return False
        self._apply(rule)
        return True

    def arming_refusal(self) -> str | None:
        """Why the vehicle would not arm; None when it would."""
        if self._battery_low():
            return "battery below BAT_EMERGEN_THR"
        return None

    def take_off(self, height_m: float) -> bool:
        """Climb to a height above home; False where the mode table refuses."""
        self._takeoff_down_m = self.home_ned[2] - height_m
        return self.trigger(Event.TAKEOFF)

    def reposition(self, p_ned: Vec3) -> bool:
        """Hold at another place."""
        if not self.trigger(Event.HOLD):
            return False
        self._anchor_ned = p_ned
        return True

    def set_point(self, setpoint: SetPoint) -> None:
        """Take an offboard set point; it is flown in offboard and refuel, and keeps them alive."""
        self._setpoint = setpoint

    def setpoints_fresh(self) -> bool:
        """Whether offboard would have something to fly."""
        age_s = math.inf if self._setpoint is None else self.time_s - self._setpoint.time_s
        return age_s <= self.parameters["COM_OF_LOSS_T"]

    def gcs_heard(self) -> None:
        """A ground station's HEARTBEAT has come."""
        self._gcs_seen_s = self.time_s

    def order(self, order: Order) -> str | None:
        """Begin or end a transfer; the reason where it is refused."""
        if order.role is Role.STOP:
            self._end_transfer("stopped")
            return None
        if self.transfer is not None:
            return None if self.transfer.order == order else "another transfer is under way"
        if order.role is Role.RECEIVE:
            reason = refusal(self.neighbours.get(order.partner), self.p_ned, self.v_ned, self.time_s, self._envelope())
            if reason is not None:
                return reason
        if not self.trigger(Event.REFUEL):
            return f"not from mode {self.mode}"
        self.transfer = Transfer(order, self.time_s)
        return None

    def hear_counter(self, partner: int, name: str, value_j: int) -> None:
        """XferOut or XferIn of the partner, as relayed."""
        if self.transfer is None or self.transfer.order.partner != partner:
            return
        if name == "XferOut" and self.transfer.order.role is Role.RECEIVE:
            self.transfer.hear_out(value_j)
        elif name == "XferIn" and self.transfer.order.role is Role.GIVE:
            self.transfer.hear_in(value_j, self.time_s)

    def announce(self, severity: Severity, text: str) -> None:
        """Say something to everyone by STATUSTEXT."""
        self.announcements.append((severity, text))

    # time

    def set_clock(self, time_ms: int, unix_us: int) -> None:
        """Start the clock without a step; set points known so far become as old as now."""
        self.time_ms = time_ms
        self.unix_epoch_us = unix_us - 1000 * time_ms
        self._anchor_s = self.time_s
        if self._setpoint is not None:
            self._setpoint = SetPoint(
                self._setpoint.p_ned, self._setpoint.v_ned, self._setpoint.use_position, None, self.time_s
            )

    def advance(self, to_ms: int) -> None:
        """Fly to a time; whole steps of 4 ms, a remainder waits for the next call."""
        thrusts = []
        while to_ms - self.time_ms >= STEP_MS:
            span_ms = min(to_ms - self.time_ms, CHUNK_MS)
            steps = span_ms // STEP_MS
            self._check_failsafes()
            self._progress()
            self._fly(steps)
            thrusts.append(self.thrust_m_s2)
            self.time_ms += steps * STEP_MS
            self._move_joules(steps * STEP_MS / 1e3)
        if len(thrusts) > 1:
            self.thrust_m_s2 = np.concatenate(thrusts, axis=1)

    def _fly(self, steps: int) -> None:
        drawn_j = self.drawn_j
        self._fill_command()
        self.state, self.thrust_m_s2 = flight.advance(
            self.state, self._command, self._packed, time_s=self.time_s, steps=steps
        )
        self._power_w = (self.drawn_j - drawn_j) / (steps * STEP_MS / 1e3)

    def _fill_command(self) -> None:
        row = self._command[0]
        p_ned, v_ned, use, time_s, speed_m_s = self._wish()
        row[flight.CMD_POSITION] = _nwu(p_ned)
        row[flight.CMD_VELOCITY] = _nwu(v_ned)
        row[flight.CMD_TIME_S] = time_s
        row[flight.CMD_USE_POSITION] = use
        row[flight.CMD_YAW] = -self._yaw_ned
        row[flight.CMD_MOTORS] = float(self.armed and not (self.landed and self.mode in _RESTING))
        row[flight.CMD_GROUND] = float(self.ground)
        row[flight.CMD_SPEED_MAX] = speed_m_s
        row[flight.CMD_PERIOD_S] = CHUNK_MS / 1e3

    def _wish(self) -> tuple[Vec3, Vec3, tuple[bool, bool, bool], float, float]:
        """What the mode wants flown: position, velocity, axes with position, time of validity, speed limit."""
        everything = (True, True, True)
        fastest = self.parameters["MPC_XY_VEL_MAX"]
        anchor = self._anchor_ned
        if self.mode in (Mode.OFFBOARD, Mode.REFUEL) and self._setpoint is not None:
            wish = self._setpoint
            if wish.yaw_ned_rad is not None:
                self._yaw_ned = wish.yaw_ned_rad
            return wish.p_ned, wish.v_ned, wish.use_position, wish.time_s, fastest
        if self.mode is Mode.TAKEOFF:
            climb = min(self.parameters["MPC_TKO_SPEED"], fastest)
            return (anchor[0], anchor[1], self._takeoff_down_m), NO_POSITION, everything, self.time_s, climb
        if self.mode is Mode.LAND:
            sink = (0.0, 0.0, self.parameters["MPC_LAND_SPEED"])
            return anchor, sink, (True, True, False), self._anchor_s, fastest
        if self.mode is Mode.RETURN and self._return_down_m is not None:
            above_home = (self.home_ned[0], self.home_ned[1], self._return_down_m)
            climbed = self.p_ned[2] <= self._return_down_m + REACHED_M
            goal = above_home if climbed else (anchor[0], anchor[1], self._return_down_m)
            return goal, NO_POSITION, everything, self.time_s, min(self.parameters["MPC_XY_CRUISE"], fastest)
        return anchor, NO_POSITION, everything, self.time_s, fastest

    def _progress(self) -> None:
        """Events that the vehicle finds out by itself."""
        p_ned = self.p_ned
        if self.mode is Mode.TAKEOFF and p_ned[2] <= self._takeoff_down_m + 0.5 * REACHED_M:
            self.trigger(Event.TAKEOFF_DONE)
            self._anchor_ned = (self._anchor_ned[0], self._anchor_ned[1], self._takeoff_down_m)
        elif self.mode is Mode.RETURN and math.dist(p_ned[:2], self.home_ned[:2]) < REACHED_M:
            if math.hypot(*self.v_ned) < REACHED_M:
                self.trigger(Event.HOME_REACHED)
        elif self.mode is Mode.LAND and self.landed:
            self.trigger(Event.TOUCHDOWN)

    def _check_failsafes(self) -> None:
        if not self.armed:
            return
        happened = {
            Event.BATTERY_EMPTY: self._battery_low(),
            Event.GCS_LOST: self._gcs_seen_s is not None
            and self.time_s - self._gcs_seen_s > self.parameters["COM_DL_LOSS_T"],
            Event.SETPOINTS_LOST: not self.setpoints_fresh(),
        }
        for event in FAILSAFES:
            if happened[event]:
                rule = rule_for(event, self.mode, self.armed)
                if rule is not None:
                    self._apply(rule if not self.landed else _STAND_DOWN)

    def _battery_low(self) -> bool:
        return self.remaining_j < self.parameters["BAT_EMERGEN_THR"] * self.capacity_j

    def _apply(self, rule: Rule) -> None:
        before = (self.mode, self.armed)
        if rule.arming is not None:
            if rule.arming and self.landed:
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
            self._end_transfer(f"mode {self.mode}")

    def _enter(self, mode: Mode) -> None:
        """Fix what a mode keeps while it lasts: the place where the vehicle can come to rest, or stands."""
        v_ned = self.v_ned
        coast_s = 0.3 + math.hypot(*v_ned) / (2.0 * 2.5) if not self.landed else 0.0
        p_ned = self.p_ned
        self._anchor_ned = (
            p_ned[0] + coast_s * v_ned[0],
            p_ned[1] + coast_s * v_ned[1],
            min(p_ned[2] + coast_s * v_ned[2], 0.0) if self.ground else p_ned[2] + coast_s * v_ned[2],
        )
        self._anchor_s = self.time_s
        if mode is Mode.TAKEOFF:
            self._anchor_ned = p_ned
        elif mode is Mode.RETURN:
            self._return_down_m = min(p_ned[2], self.home_ned[2] - self.parameters["RTL_RETURN_ALT"])

    # transfer

    def _envelope(self) -> Envelope:
        return Envelope(self.parameters["SIM_XFER_DIST"], self.parameters["SIM_XFER_SPEED"])

    def _move_joules(self, dt_s: float) -> None:
        transfer = self.transfer
        if transfer is None:
            return
        if transfer.order.role is Role.GIVE:
            joules = transfer.give(dt_s, self.remaining_j)
            self.given_j += joules
            self.state[0, flight.REMAINING_J] -= joules
            reason = transfer.finished(self.time_s)
        else:
            neighbour = self.neighbours.get(transfer.order.partner)
            reason = refusal(neighbour, self.p_ned, self.v_ned, self.time_s, self._envelope())
            if reason is None:
                joules = transfer.credit(self.capacity_j - self.remaining_j)
                self.received_j += joules
                self.state[0, flight.REMAINING_J] += joules
        if reason is not None:
            self._end_transfer(reason)

    def _end_transfer(self, reason: str) -> None:
        if self.transfer is None:
            return
        verb = "gave" if self.transfer.order.role is Role.GIVE else "received"
        self.announce(Severity.INFO, f"Transfer ended: {reason}, {verb} {self.transfer.moved_j} J")
        self.transfer = None
        self.transfer_ended_s = self.time_s
        self.trigger(Event.REFUEL_END)
        self.on_change()


_RESTING = frozenset({Mode.HOLD, Mode.LAND, Mode.RETURN})
_STAND_DOWN = Rule(
    Event.DISARM, frozenset(Mode), True, Mode.HOLD, False, Severity.WARNING, "Failsafe on the ground, disarmed"
)


def _tuple(v: NDArray[np.float64]) -> Vec3:
    return (float(v[0]), float(v[1]), float(v[2]))


def _ned(v_nwu: NDArray[np.float64]) -> Vec3:
    return _tuple(ned_from_nwu(v_nwu))


def _nwu(v_ned: Vec3) -> Vec3:
    return (v_ned[0], -v_ned[1], -v_ned[2])
