"""The battery of a vehicle that another autopilot flies (docs/protocol/autopilots.md#autopilots-of-others): what it
tells, and the energy that it takes in the air. No socket, no clock.

The autopilot knows nothing of transfers. So what concerns the battery is answered here, in the autopilot's name, by
which a supervisor knows its vehicles; the autopilot never sees it.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from simvehicle.autopilot.body import CELL_FULL_V, CELLS
from simvehicle.autopilot.energy_transfer import Envelope, Exchange, Neighbour, TransferSide
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.vectors import Vec3
from simvehicle.law.plants import RotorPlant
from simvehicle.mavlink import commands
from simvehicle.mavlink.codec import ReceivedFrame, decode, message
from skytender import mavlink as mav

STATUS_EVERY_S, COUNTER_EVERY_S, FAST_EVERY_S = 0.5, 1.0, 0.1
STAYS_FAST_S = 2.0
"""How long after a transfer its counter is sent often: the last report must arrive."""
HELD_SPEED_SHARE = 2.0
"""[choice] A transfer ends at so many times the relative speed at which it may begin: round the corners of a target's
path an ArduCopter differs from a tanker by up to 1.1 m/s, where 0.5 m/s is asked for."""
UNKNOWN_U16 = 65535
PARAMETERS = ("SIM_BAT_CAP_J", "SIM_BAT_INIT_J")
_COMMANDS = frozenset({mav.MAVLINK_MSG_ID_COMMAND_LONG, mav.MAVLINK_MSG_ID_COMMAND_INT})
_OF_PARTNERS = frozenset({mav.MAVLINK_MSG_ID_FOLLOW_TARGET, mav.MAVLINK_MSG_ID_NAMED_VALUE_INT})


class BatteryComponent:
    """Its counters, its transfer, and its messages; the cells are the plant's."""

    def __init__(
        self,
        cells: RotorPlant,
        sysid: int,
        frame: LocalFrame,
        envelope: Envelope,
        *,
        capacity_j: float,
        initial_j: float,
    ) -> None:
        self._cells, self._sysid, self._frame, self._envelope = cells, sysid, frame, envelope
        self._held = replace(envelope, relative_speed_m_s=HELD_SPEED_SHARE * envelope.relative_speed_m_s)
        self._values = dict(zip(PARAMETERS, (capacity_j, initial_j), strict=True))
        self.exchange = Exchange()
        self._status_s = self._counter_s = -math.inf

    @property
    def percent(self) -> int:
        """Charge, of its capacity."""
        share = self._cells.remaining_j / self._values["SIM_BAT_CAP_J"]
        return min(max(round(100.0 * share), 0), 100)

    def receive(self, frame: ReceivedFrame, now_s: float, p_ned: Vec3, v_ned: Vec3) -> list[Any] | None:
        """Answers to a frame that concerns the battery; None where it does not, and is the autopilot's."""
        if frame.msgid in _OF_PARTNERS:
            self._learn(frame, now_s, v_ned)
            return []
        if frame.msgid == mav.MAVLINK_MSG_ID_PARAM_REQUEST_READ:
            name = getattr(decode(frame), "param_id", "")
            return [self._parameter(name)] if name in self._values else None
        if frame.msgid not in _COMMANDS:
            return None
        content: Any = decode(frame)
        if content.command != mav.MAV_CMD_USER_1 or content.target_system not in (0, self._sysid):
            return None
        request = commands.request_from(content, frame.sender)
        result, said = self._order(request, now_s, p_ned)
        return [commands.acknowledgement(request, result), *said, self._counter(now_s)]

    def move(self, now_s: float, dt_s: float, p_ned: Vec3) -> list[Any]:
        """Carry a transfer on by dt_s; the messages that are due."""
        exchange, said = self.exchange, []
        joules, reason = exchange.move(
            dt_s,
            now_s,
            p_ned,
            remaining_j=self._cells.remaining_j,
            capacity_j=self._values["SIM_BAT_CAP_J"],
            envelope=self._held,
        )
        if joules:
            self._cells.charge(joules)
        if reason is not None:
            said.append(self._text(f"{exchange.end(now_s)}: {reason}"))
        busy = exchange.current is not None or now_s - exchange.ended_s < STAYS_FAST_S
        if now_s - self._counter_s >= (FAST_EVERY_S if busy else COUNTER_EVERY_S) - 1e-6:
            said.append(self._counter(now_s))
        if now_s - self._status_s >= STATUS_EVERY_S - 1e-6:
            self._status_s = now_s
            said.append(self.status())
        return said

    def _learn(self, frame: ReceivedFrame, now_s: float, v_ned: Vec3) -> None:
        content: Any = decode(frame)
        if frame.msgid == mav.MAVLINK_MSG_ID_NAMED_VALUE_INT:
            self.exchange.receive_counter(frame.sysid, content.name, content.value, now_s)
        elif all(map(math.isfinite, (content.alt, *content.vel))):
            there = self._frame.to_local(1e-7 * content.lat, 1e-7 * content.lon, content.alt)
            self.exchange.neighbours[frame.sysid] = Neighbour(there, tuple(content.vel), v_ned, now_s)

    def _order(self, request: commands.VehicleCommand, now_s: float, p_ned: Vec3) -> tuple[int, list[Any]]:
        """Begin or end taking; it gives nothing."""
        order, exchange = commands.transfer_order(request), self.exchange
        if order is None or order.role not in (TransferSide.STOP, TransferSide.RECEIVE):
            return commands.DENIED, []
        if order.role is TransferSide.STOP:
            if exchange.current is not None and exchange.current.stopped_by(order):
                return commands.ACCEPTED, [self._text(f"{exchange.end(now_s)}: stopped")]
            return commands.ACCEPTED, []
        reason = exchange.refuses(order, p_ned, now_s, self._envelope)
        if reason is not None:
            return commands.TEMPORARILY_REJECTED, [self._text(f"Transfer refused: {reason}")]
        if exchange.current is None:
            exchange.begin(order, now_s)
        return commands.ACCEPTED, []

    def _counter(self, now_s: float) -> Any:
        self._counter_s = now_s
        received_j = self.exchange.received_j
        return message("NAMED_VALUE_INT")(time_boot_ms=round(1e3 * now_s), name="XferIn", value=received_j)

    def _parameter(self, name: str) -> Any:
        index = PARAMETERS.index(name)
        return message("PARAM_VALUE")(
            param_id=name,
            param_value=self._values[name],
            param_type=mav.MAV_PARAM_TYPE_REAL32,
            param_count=len(PARAMETERS),
            param_index=index,
        )

    def status(self) -> Any:
        """Its BATTERY_STATUS now."""
        volts, amperes = self._cells.electric
        cell_mv = min(max(round(1e3 * volts / CELLS), 0), UNKNOWN_U16 - 1)
        drawn_j = self._cells.drawn_j
        return message("BATTERY_STATUS")(
            battery_function=mav.MAV_BATTERY_FUNCTION_ALL,
            type=mav.MAV_BATTERY_TYPE_LIPO,
            temperature=32767,
            voltages=(cell_mv,) * CELLS + (UNKNOWN_U16,) * (10 - CELLS),
            current_battery=min(round(1e2 * amperes), 2**15 - 1),
            current_consumed=round(1e3 * drawn_j / (CELLS * CELL_FULL_V) / 3600.0),
            energy_consumed=math.floor(drawn_j / 100.0),
            battery_remaining=self.percent,
            charge_state=mav.MAV_BATTERY_CHARGE_STATE_OK,
        )

    def _text(self, text: str) -> Any:
        return message("STATUSTEXT")(severity=mav.MAV_SEVERITY_INFO, text=text[:50])
