"""Messages between the vehicles of a fleet: reports as DEBUG_FLOAT_ARRAY, transfer orders as COMMAND_LONG
(docs/protocol/onboard.md#competition-on-board)."""

from __future__ import annotations

from typing import Any

from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.member import FleetMember
from simvehicle.fleet.peers import PeerReport, ServiceReport, report_of, row_of
from simvehicle.fleet.receiver import OrderToPeer
from simvehicle.fleet.rules import FleetRules
from simvehicle.mavlink.codec import ReceivedFrame, decode, message
from simvehicle.mavlink.commands import ACCEPTED, command_long
from skytender import mavlink as mav

PEER, SERVICE = "Peer", "Service"
FORMAT = 1
"""array_id of a peer's report."""
FLOATS = 58
FOLLOW_RATE_HZ = 10.0
MESSAGES = frozenset({mav.MAVLINK_MSG_ID_DEBUG_FLOAT_ARRAY, mav.MAVLINK_MSG_ID_COMMAND_ACK})
_SET_POINTS = frozenset(
    {mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED, mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT}
)


class FleetService:
    """MAVLink face of a fleet's member."""

    def __init__(self, vehicle: Vehicle, sysid: int, rules: FleetRules) -> None:
        self._vehicle = vehicle
        self._sysid = sysid
        self.member = FleetMember(vehicle, sysid, rules)
        self.follow_rate_hz = 0.0
        """how often FOLLOW_TARGET is to be sent"""

    def receive(self, frame: ReceivedFrame, *, from_fleet: bool = True) -> None:
        """Take in what concerns the fleet; other frames are passed over. Peers are believed on the fleet's own radio
        alone, the vehicle's first connection: anyone may speak on the others."""
        if frame.msgid in _SET_POINTS:
            self.member.led()
        if not from_fleet or frame.msgid not in MESSAGES or frame.sysid == self._sysid:
            return
        content = decode(frame)
        assert content is not None
        if frame.msgid == mav.MAVLINK_MSG_ID_COMMAND_ACK:
            if content.target_system == self._sysid and content.command == mav.MAV_CMD_USER_1:
                self.member.receive_answer(frame.sysid, content.result == ACCEPTED)
        elif content.name == PEER and content.array_id == FORMAT:
            report = report_of((content.time_usec - self._vehicle.unix_epoch_us) / 1e6, content.data)
            if report is not None and report.time_s <= self._vehicle.time_s:
                self.member.receive(frame.sysid, report)

    def tick(self) -> list[Any]:
        """Let the member do what is due; what it sends."""
        member = self.member
        member.tick()
        epoch_us = self._vehicle.unix_epoch_us
        out = [_peer(report, epoch_us) for report in member.reports]
        out += [_service(service, self._vehicle) for service in member.services]
        out += [_order(order) for order in member.orders]
        member.reports.clear()
        member.services.clear()
        member.orders.clear()
        serves = member.tanker is not None and member.tanker.receiver
        self.follow_rate_hz = FOLLOW_RATE_HZ if serves else 0.0
        return out


def _peer(report: PeerReport, epoch_us: int) -> Any:
    return _array(PEER, FORMAT, epoch_us + round(1e6 * report.time_s), row_of(report))


def _service(service: ServiceReport, vehicle: Vehicle) -> Any:
    times_s = (service.decided_s, service.start_s, service.end_s)
    row = (float(service.receiver), float(service.by), *times_s, float(service.energy_j), float(service.ending))
    return _array(SERVICE, service.number, vehicle.unix_epoch_us + 1000 * vehicle.time_ms, row)


def _array(name: str, array_id: int, time_usec: int, row: tuple[float, ...]) -> Any:
    data = (*row, *(0.0,) * (FLOATS - len(row)))
    return message("DEBUG_FLOAT_ARRAY")(time_usec=time_usec, array_id=array_id, name=name, data=data)


def _order(out: OrderToPeer) -> Any:
    order = out.order
    numbers = (order.partner, order.role, int(order.limit_j), order.rate_w, order.transfer_id, order.giver_start_j)
    return command_long(out.sysid, mav.MAV_CMD_USER_1, *numbers)
