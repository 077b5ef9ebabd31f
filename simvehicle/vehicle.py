"""One vehicle: modes, failsafes and transfer around the flight law. No socket, no clock, no process-wide state.

A step is always the same: failsafes → mode's set point → flight law → transfer.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from simvehicle import flight
from simvehicle.dynamics import attitude_ned_from_nwu, body_rates, ned_from_nwu
from simvehicle.geo import LocalFrame
from simvehicle.maneuvers import AT_REST, REACHED_M, Anchor, SetPoint, resting_place, wish
from simvehicle.mavlink.identity import Identity
from simvehicle.mavlink.parameters import Parameters
from simvehicle.mavlink.telemetry import Snapshot, Vec3
from simvehicle.modes import FAILSAFES, RESTING, STAND_DOWN, STEERED, Event, Mode, Rule, Severity, rule_for
from simvehicle.params import pack
from simvehicle.transfer import Envelope, Neighbour, Order, OrderKey, Role, Transfer, refusal

__all__ = ["STEP_MS", "SetPoint", "Start", "Vehicle"]

STEP_MS = 4
CHUNK_MS = 100
"""Modes, failsafes and transfer are looked at this often at least, however long the step asked for."""


@dataclass(frozen=True)
class Start:
    """Where and how a vehicle begins; `airborne`: armed, in offboard on its own state, and without a ground."""

    p_ned: Vec3 = AT_REST
    v_ned: Vec3 = AT_REST
    attitude_ned_rad: Vec3 = AT_REST
    airborne: bool = False


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
        self._ended_orders: set[OrderKey] = set()
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
        self._anchor = Anchor(start.p_ned, 0.0, start.p_ned[2])
        self._takeoff_down_m = start.p_ned[2]
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
        return self.ground and self.p_ned[2] >= 0.0 and self.v_ned == AT_REST

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
        """Climb to a height above home, or stay where the vehicle is higher; False where the mode table refuses."""
        if rule_for(Event.TAKEOFF, self.mode, self.armed) is None:
            return False
        self._takeoff_down_m = min(self.home_ned[2] - height_m, self.p_ned[2])
        self._anchor = replace(self._anchor, down_m=self._takeoff_down_m)
        return self.trigger(Event.TAKEOFF)

    def reposition(self, p_ned: Vec3) -> bool:
        """Hold at another place; False where the vehicle is not flying."""
        if self.landed or not self.armed or not self.trigger(Event.HOLD):
            return False
        self._anchor = replace(self._anchor, p_ned=p_ned)
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
            if self.transfer is not None and self.transfer.stopped_by(order):
                self._end_transfer("stopped")
            return None
        if self.transfer is not None:
            return None if self.transfer.order == order else "another transfer is under way"
        if order.key in self._ended_orders:
            return "that transfer has ended; a new one needs a new id"
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
        self._anchor = replace(self._anchor, time_s=self.time_s)
        if self._setpoint is not None:
            self._setpoint = replace(self._setpoint, time_s=self.time_s)

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
        wanted = wish(
            self.mode,
            self._setpoint,
            self._anchor,
            p_ned=self.p_ned,
            home_ned=self.home_ned,
            now_s=self.time_s,
            parameters=self.parameters,
        )
        if self.mode in STEERED and self._setpoint is not None and self._setpoint.yaw_ned_rad is not None:
            self._yaw_ned = self._setpoint.yaw_ned_rad
        row[flight.CMD_POSITION] = _nwu(wanted.p_ned)
        row[flight.CMD_VELOCITY] = _nwu(wanted.v_ned)
        row[flight.CMD_TIME_S] = wanted.time_s
        row[flight.CMD_USE_POSITION] = wanted.use_position
        row[flight.CMD_YAW] = -self._yaw_ned
        row[flight.CMD_MOTORS] = float(self.armed and not (self.landed and self.mode in RESTING))
        row[flight.CMD_GROUND] = float(self.ground)
        row[flight.CMD_SPEED_MAX] = wanted.speed_m_s
        row[flight.CMD_PERIOD_S] = CHUNK_MS / 1e3

    def _progress(self) -> None:
        """Events that the vehicle finds out by itself."""
        p_ned = self.p_ned
        if self.mode is Mode.TAKEOFF and p_ned[2] <= self._takeoff_down_m + 0.5 * REACHED_M:
            self.trigger(Event.TAKEOFF_DONE)
            north, east, _ = self._anchor.p_ned
            self._anchor = replace(self._anchor, p_ned=(north, east, self._takeoff_down_m))
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
                    self._apply(rule if not self.landed else STAND_DOWN)

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
        p_ned = self.p_ned
        place, down_m = resting_place(p_ned, self.v_ned, ground=self.ground, landed=self.landed), p_ned[2]
        if mode is Mode.TAKEOFF:
            place, down_m = p_ned, self._takeoff_down_m
        elif mode is Mode.RETURN:
            down_m = min(p_ned[2], self.home_ned[2] - self.parameters["RTL_RETURN_ALT"])
        self._anchor = Anchor(place, self.time_s, down_m)

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
                if self.capacity_j - self.remaining_j < 1.0:
                    reason = "the battery is full"
        if reason is not None:
            self._end_transfer(reason)

    def _end_transfer(self, reason: str) -> None:
        if self.transfer is None:
            return
        verb = "Gave" if self.transfer.order.role is Role.GIVE else "Received"
        self.announce(Severity.INFO, f"{verb} {self.transfer.moved_j} J: {reason}")
        if self.transfer.touched:
            self._ended_orders.add(self.transfer.order.key)
        self.transfer = None
        self.transfer_ended_s = self.time_s
        self.trigger(Event.REFUEL_END)
        self.on_change()


def _tuple(v: NDArray[np.float64]) -> Vec3:
    return (float(v[0]), float(v[1]), float(v[2]))


def _ned(v_nwu: NDArray[np.float64]) -> Vec3:
    return _tuple(ned_from_nwu(v_nwu))


def _nwu(v_ned: Vec3) -> Vec3:
    return (v_ned[0], -v_ned[1], -v_ned[2])
