"""The MAVLink face of a vehicle: every message to its microservice, every answer and all telemetry to the connections.

Nothing that the network sends may stop a vehicle: an unknown message is passed over, an unknown command is answered as
unsupported, a number that is none is refused and said so.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import cython
import cython.cimports.simvehicle.mavlink.offboard as compiled_offboard
from cython.cimports.simvehicle.mavlink.lockstep import SYSTEM
from cython.cimports.skytender.messages import (
    HEARTBEAT_ID,
    LOCAL_POSITION_NED_ID,
    MAV_COMP_ID_AUTOPILOT1,
    POSITION_TARGET_LOCAL_NED_ID,
    SET_POSITION_TARGET_LOCAL_NED_ID,
)

from simvehicle.autopilot.failures import Failure
from simvehicle.autopilot.modes import Severity
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.peer_table import PeerTable
from simvehicle.fleet.rules import FleetRules
from simvehicle.mavlink import (
    commands,
    file_protocol,
    flight_commands,
    log_protocol,
    maintenance,
    message_requests,
    missions,
    offboard,
    parameter_protocol,
    traffic,
)
from simvehicle.mavlink.codec import ReceivedFrame, as_bytes, decode, message
from simvehicle.mavlink.commands import NOT_IN_CONTROL, TEMPORARILY_REJECTED, UNSUPPORTED
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.context import Call, CommandHandler, MessageHandler, ServiceContext, Store
from simvehicle.mavlink.fleet_messages import FleetService
from simvehicle.mavlink.services import component_metadata, operator_control
from simvehicle.mavlink.services.remote_id import RemoteIdService
from skytender import mavlink as mav

TRANSFER_RATE_HZ = 10.0
COUNTERS_STAY_FAST_S = 2.0
TEXT_BYTES = 50
_SEVERITY = {
    Severity.INFO: mav.MAV_SEVERITY_INFO,
    Severity.WARNING: mav.MAV_SEVERITY_WARNING,
    Severity.CRITICAL: mav.MAV_SEVERITY_CRITICAL,
}
MESSAGES: dict[int, MessageHandler] = {
    **offboard.MESSAGES,
    **flight_commands.MESSAGES,
    **message_requests.MESSAGES,
    **parameter_protocol.MESSAGES,
    **traffic.MESSAGES,
}
COMMANDS: dict[int, CommandHandler] = {**flight_commands.COMMANDS, **message_requests.COMMANDS, **maintenance.COMMANDS}
_COMMAND_MESSAGES = frozenset({mav.MAVLINK_MSG_ID_COMMAND_LONG, mav.MAVLINK_MSG_ID_COMMAND_INT})
_OTHERS = frozenset({mav.MAVLINK_MSG_ID_HEARTBEAT, mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED})
UNDERSTOOD = (
    _OTHERS | _COMMAND_MESSAGES | missions.MESSAGES | log_protocol.MESSAGES | {file_protocol.MESSAGE} | set(MESSAGES)
)
"""Ids of the messages that the vehicle acts on."""


class Services:
    """The MAVLink face of one vehicle, shared by all its connections."""

    vehicle: Vehicle
    sysid: int
    connections: list[Connection]
    fleet: FleetService | None
    _context: ServiceContext
    _planning: missions.Planning
    _logs: log_protocol.LogService
    _files: file_protocol.FileService
    _remote_id: RemoteIdService
    _reboot: maintenance.Reboot
    _control: operator_control.OwnerService
    _commands: dict[int, CommandHandler]
    _follow_rate_hz: float
    _fast_counters: bool
    _long_texts: int
    _leads: bool
    _peers: PeerTable | None
    _at_work: bool
    """whether a service may have something to do beside telemetry"""

    def __init__(
        self,
        vehicle: Vehicle,
        sysid: int,
        connections: Iterable[Connection] = (),
        store: Store | None = None,
        rules: FleetRules | None = None,
        log: log_protocol.Log | None = None,
    ) -> None:
        """`rules`: of the fleet that it belongs to, where vehicles compete on board. `log`: what it writes down."""
        self.vehicle = vehicle
        self.sysid = sysid
        self.connections = list(connections)
        self._context = ServiceContext(vehicle, sysid, self.connections, store)
        self._planning = missions.Planning(self._context)
        self._logs = log_protocol.LogService(log)
        self._files = file_protocol.FileService(log, lambda path: component_metadata.content_of(vehicle, path))
        self._remote_id = RemoteIdService(vehicle, sysid, self.connections)
        self._reboot = maintenance.Reboot(self._context, self._planning.restart)
        self._control = operator_control.OwnerService(self._context)
        self._commands = {**COMMANDS, mav.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN: self._reboot.ask}
        self._commands[mav.MAV_CMD_REQUEST_OPERATOR_CONTROL] = self._control.request
        self.fleet = None if rules is None else FleetService(vehicle, sysid, rules)
        self._follow_rate_hz = 0.0
        self._fast_counters = False
        self._long_texts = 0
        self._at_work = True
        self._leads = False
        self._peers = None if vehicle.separation is None else vehicle.separation.peers
        vehicle.on_change = self._hasten_heartbeats
        self._planning.restart()

    def receive(self, frame: ReceivedFrame, connection: Connection) -> None:
        """Act on one frame; answers wait on the same connection."""
        if self.fleet is not None and not self._deaf():
            self.fleet.receive(frame, from_fleet=connection is self.connections[0])
        if frame.sysid == self.sysid and frame.compid == MAV_COMP_ID_AUTOPILOT1:
            return
        if frame.msgid == SET_POSITION_TARGET_LOCAL_NED_ID:
            if not self._deaf() and (self.vehicle.gcs_main == 0 or not self._control.bars(frame.sysid)):
                compiled_offboard.local_set_point(self._context, self.vehicle, self.sysid, frame.payload)
                self.vehicle.station_leads = frame.sysid == SYSTEM and connection is self.connections[0]
            return
        if frame.msgid in (LOCAL_POSITION_NED_ID, POSITION_TARGET_LOCAL_NED_ID):
            if self._peers is not None and connection is self.connections[0] and not self._deaf():
                self._peers.receive(frame.sysid, frame.msgid, frame.payload, self.vehicle.time_ms)
            return
        if frame.msgid == HEARTBEAT_ID:
            owner = self.vehicle.gcs_main
            if owner not in (0, frame.sysid) or self._deaf():
                return  # while one owns it, that one is the link
            if compiled_offboard.is_ground_station(frame.payload):
                self.vehicle.receive_gcs_heartbeat()
            return
        if frame.msgid not in UNDERSTOOD:
            return
        content = decode(frame)
        assert content is not None
        self._at_work = True
        if getattr(content, "target_system", 0) not in (0, self.sysid):
            return
        if getattr(content, "target_component", 0) not in (0, MAV_COMP_ID_AUTOPILOT1):
            return
        call = Call(content, frame, connection)
        if frame.msgid in _COMMAND_MESSAGES:
            self._command(call)
        elif self._deaf() or (frame.msgid in operator_control.STATE_CHANGING and self._control.bars(frame.sysid)):
            return
        elif frame.msgid in missions.MESSAGES:
            self._planning.receive(call)
        elif frame.msgid in log_protocol.MESSAGES:
            self._logs.receive(call)
        elif frame.msgid == file_protocol.MESSAGE:
            self._files.receive(call)
        else:
            MESSAGES[frame.msgid](self._context, call)

    def _deaf(self) -> bool:
        failed = self.vehicle.failed
        return self.vehicle.booting or (bool(failed) and Failure.LINK in failed)

    def _command(self, call: Call) -> None:
        request = commands.request_from(call.content, call.sender)
        if Failure.LINK in self.vehicle.failed and request.command != mav.MAV_CMD_INJECT_FAILURE:
            return
        owned = self.vehicle.gcs_main not in (0, SYSTEM)
        if call.frame.sysid == SYSTEM and call.connection is self.connections[0] and not owned:
            self.vehicle.receive_gcs_command()
        handler = self._commands.get(request.command)
        result = UNSUPPORTED
        if self._reboot.busy_with(request):
            result = TEMPORARILY_REJECTED
        elif self._control.bars_command(request):
            result = NOT_IN_CONTROL
        elif handler is not None:
            result = handler(self._context, request, call.connection)
        call.connection.put(commands.acknowledgement(request, result))
        for content in self._context.after_ack:
            call.connection.put(content)
        self._context.after_ack.clear()

    def decide(self) -> None:
        """Let a fleet's member decide at the vehicle's present time, and queue what it tells the others."""
        if self.vehicle.separation is not None:
            self._intend()
        if self.fleet is None:
            return
        contents = self.fleet.tick()
        if self._deaf():
            return
        for content in contents:
            for connection in self.connections:
                connection.put(content)
        if self.fleet.follow_rate_hz != self._follow_rate_hz:
            self._follow_rate_hz = self.fleet.follow_rate_hz
            self._context.set_rate("FOLLOW_TARGET", self._follow_rate_hz)

    def _intend(self) -> None:
        """Let peers know of a leader of its own in every period."""
        vehicle = self.vehicle
        vehicle.separation.intend()
        if vehicle.leads != self._leads:
            self._leads = vehicle.leads
            interval_us = 1e6 * vehicle.period_s if vehicle.leads else 0.0
            self.connections[0].streams.set_interval(POSITION_TARGET_LOCAL_NED_ID, interval_us, vehicle.time_ms)

    def report(self) -> None:
        """Queue what became due at the vehicle's present time: announcements, then telemetry."""
        vehicle = self.vehicle
        at_work = self._at_work or vehicle.mission is not None
        if at_work:
            self._reboot.finish()
        if vehicle.failed and Failure.LINK in vehicle.failed:
            vehicle.announcements.clear()
            return
        if at_work:
            self._planning.report()
        self._pace_counters()
        if vehicle.gcs_main != 0:
            self._control.watch()
        if vehicle.announcements:
            self._announce()
        for connection in self.connections:
            compiled = cython.declare(Connection, connection)
            compiled.put_due(vehicle)
        if at_work:
            self._at_work = self._reboot.at_work or self._planning.at_work
            for service in (self._context.events, self._logs, self._files, self._remote_id):
                service.report()
                self._at_work = self._at_work or service.at_work

    def _announce(self) -> None:
        """Queue what the vehicle has to say, for everyone."""
        events = self._context.events
        for severity, text in self.vehicle.announcements:
            self._long_texts += len(as_bytes(text)) > TEXT_BYTES
            event = events.take(severity, text)
            for connection in self.connections:
                both = event is not None and events.reaches(connection)
                words = f"{text}\t" if both else text
                for content in _status_texts(_SEVERITY[severity], words, self._long_texts):
                    connection.put(content)
                if both:
                    connection.put(event)
        self.vehicle.announcements.clear()

    def _counts_fast(self) -> bool:
        vehicle = self.vehicle
        exchange = vehicle.exchange
        return exchange.current is not None or vehicle.time_ms / 1e3 - exchange.ended_s < COUNTERS_STAY_FAST_S

    def _pace_counters(self) -> None:
        fast = self._counts_fast()
        if fast != self._fast_counters:
            self._fast_counters = fast
            for key in ("XferOut", "XferIn"):
                self._context.set_rate(key, TRANSFER_RATE_HZ if fast else 1.0)

    def _hasten_heartbeats(self) -> None:
        for connection in self.connections:
            connection.streams.hasten("HEARTBEAT", self.vehicle.time_ms)
            connection.streams.hasten("CURRENT_MODE", self.vehicle.time_ms)


def _status_texts(severity: int, text: str, number: int) -> list[Any]:
    """STATUSTEXT, in chunks that share an id where one cannot hold the text; an empty part ends a full last chunk."""
    raw = as_bytes(text)
    if len(raw) <= TEXT_BYTES:
        return [message("STATUSTEXT")(severity=severity, text=text)]
    parts = [raw[at : at + TEXT_BYTES] for at in range(0, len(raw) + 1, TEXT_BYTES)]
    return [
        message("STATUSTEXT")(severity=severity, text=part, id=1 + number % 65535, chunk_seq=seq)
        for seq, part in enumerate(parts)
    ]
