"""What the vehicle does with each MAVLink message that reaches it: two tables, one of messages and one of commands.

Nothing that the network sends may stop a vehicle: an unknown message is passed over, an unknown command is answered as
unsupported, a number that is none is refused and said so.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

from pymavlink.dialects.v20 import common as mav

from simvehicle.maneuvers import SetPoint
from simvehicle.mavlink import commands, parameters
from simvehicle.mavlink.codec import Frame, decode, message
from simvehicle.mavlink.commands import ACCEPTED, DENIED, TEMPORARILY_REJECTED, UNSUPPORTED, Request
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.parameters import ParameterError
from simvehicle.mavlink.telemetry import TELEMETRY, Vec3, autopilot_version
from simvehicle.modes import Event, Mode, Severity
from simvehicle.transfer import Neighbour, Order, Role
from simvehicle.vehicle import Vehicle

COMPID = 1
FORCE_ARM = (21196, 2989)
COMPLAIN_EVERY_S = 5.0
TRANSFER_RATE_HZ = 10.0
COUNTERS_STAY_FAST_S = 2.0
TEXT_CHARACTERS = 50
_NEVER_FLOWN = (
    mav.POSITION_TARGET_TYPEMASK_AX_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AY_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_AZ_IGNORE
    | mav.POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE
)
"""Bits that a set point must set: accelerations, or forces, and yaw rates are not flown."""
_SEVERITY = {
    Severity.INFO: mav.MAV_SEVERITY_INFO,
    Severity.WARNING: mav.MAV_SEVERITY_WARNING,
    Severity.CRITICAL: mav.MAV_SEVERITY_CRITICAL,
}
_EVENT_OF_MODE = {
    Mode.OFFBOARD: Event.OFFBOARD,
    Mode.HOLD: Event.HOLD,
    Mode.LAND: Event.LAND,
    Mode.RETURN: Event.RETURN,
}


class Services:
    """The MAVLink face of one vehicle, shared by all its connections."""

    def __init__(self, vehicle: Vehicle, sysid: int, connections: Iterable[Connection] = ()) -> None:
        self.vehicle = vehicle
        self.sysid = sysid
        self.connections = list(connections)
        self._after_ack: list[Any] = []
        self._complained_s: dict[str, float] = {}
        self._fast_counters = False
        self._long_texts = 0
        vehicle.on_change = self._hasten_heartbeats

    # in

    def receive(self, frame: Frame, connection: Connection) -> None:
        """Act on one frame; answers wait on the same connection."""
        handler = _MESSAGES.get(frame.msgid)
        if handler is None or (frame.sysid, frame.compid) == (self.sysid, COMPID):
            return
        content = decode(frame)
        assert content is not None
        if getattr(content, "target_system", 0) not in (0, self.sysid):
            return
        if getattr(content, "target_component", 0) not in (0, COMPID):
            return
        handler(self, content, frame, connection)

    # out

    def report(self) -> None:
        """Queue what became due at the vehicle's present time: announcements, then telemetry."""
        vehicle = self.vehicle
        self._pace_counters()
        for severity, text in vehicle.announcements:
            self._long_texts += len(text) > TEXT_CHARACTERS
            for content in _status_texts(_SEVERITY[severity], text, self._long_texts):
                for connection in self.connections:
                    connection.put(content)
        vehicle.announcements.clear()
        snapshot = vehicle.snapshot()
        for connection in self.connections:
            connection.put_due(snapshot)

    def _pace_counters(self) -> None:
        vehicle = self.vehicle
        fast = vehicle.transfer is not None or vehicle.time_s - vehicle.transfer_ended_s < COUNTERS_STAY_FAST_S
        if fast != self._fast_counters:
            self._fast_counters = fast
            for connection in self.connections:
                for key in ("XferOut", "XferIn"):
                    connection.streams.set_rate(key, TRANSFER_RATE_HZ if fast else 1.0, vehicle.time_ms)

    def _hasten_heartbeats(self) -> None:
        for connection in self.connections:
            connection.streams.hasten("HEARTBEAT", self.vehicle.time_ms)

    def _complain(self, about: str, text: str) -> None:
        """Warn by STATUSTEXT, but not about the same kind of thing all the time."""
        if self.vehicle.time_s - self._complained_s.get(about, -math.inf) >= COMPLAIN_EVERY_S:
            self._complained_s[about] = self.vehicle.time_s
            self.vehicle.announce(Severity.WARNING, text)

    # messages

    def _heartbeat(self, content: Any, frame: Frame, connection: Connection) -> None:
        if content.type == mav.MAV_TYPE_GCS:
            self.vehicle.gcs_heard()

    def _set_point(self, content: Any, frame: Frame, connection: Connection) -> None:
        if content.coordinate_frame != mav.MAV_FRAME_LOCAL_NED:
            return self._complain("frame", f"Set point ignored: frame {content.coordinate_frame}")
        mask = content.type_mask
        use_position = (not mask & 1, not mask & 2, not mask & 4)
        use_velocity = (not mask & 8, not mask & 16, not mask & 32)
        flown = all(p or v for p, v in zip(use_position, use_velocity, strict=True))
        if mask & _NEVER_FLOWN != _NEVER_FLOWN or not flown:
            return self._complain("type_mask", f"Set point ignored: type_mask {mask}")
        use_yaw = not mask & mav.POSITION_TARGET_TYPEMASK_YAW_IGNORE
        p_ned = _where_used((content.x, content.y, content.z), use_position)
        v_ned = _where_used((content.vx, content.vy, content.vz), use_velocity)
        if not all(map(math.isfinite, (*p_ned, *v_ned, content.yaw if use_yaw else 0.0))):
            return self._complain("number", "Set point ignored: not a number")
        yaw_rad = content.yaw if use_yaw else None
        self.vehicle.set_point(SetPoint(p_ned, v_ned, use_position, yaw_rad, self.vehicle.time_s))
        return None

    def _command(self, content: Any, frame: Frame, connection: Connection) -> None:
        request = commands.request_from(content, (frame.sysid, frame.compid))
        handler = _COMMANDS.get(request.command)
        result = UNSUPPORTED if handler is None else handler(self, request, connection)
        connection.put(commands.acknowledgement(request, result))
        while self._after_ack:
            connection.put(self._after_ack.pop(0))

    def _set_mode_message(self, content: Any, frame: Frame, connection: Connection) -> None:
        self._enter_custom(content.custom_mode)

    def _param_list(self, content: Any, frame: Frame, connection: Connection) -> None:
        for index, (row, value) in enumerate(self.vehicle.parameters):
            connection.put(self._param_value(row, value, index))

    def _param_read(self, content: Any, frame: Frame, connection: Connection) -> None:
        found = parameters.row_at(content.param_id if content.param_index < 0 else content.param_index)
        if found is not None:
            index, row = found
            connection.put(self._param_value(row, self.vehicle.parameters[row.name], index))

    def _param_set(self, content: Any, frame: Frame, connection: Connection) -> None:
        found = parameters.row_at(content.param_id)
        if found is None:
            return
        index, row = found
        bytewise = self.vehicle.identity.integers_bytewise
        try:
            value = parameters.value_from_wire(row, content.param_value, content.param_type, bytewise=bytewise)
            self.vehicle.parameters.set(row.name, value)
            self.vehicle.retune()
        except ParameterError as error:
            self._complain(row.name, str(error))
        connection.put(self._param_value(row, self.vehicle.parameters[row.name], index))

    def _param_value(self, row: parameters.Row, value: float, index: int) -> Any:
        return parameters.value_message(row, value, index, bytewise=self.vehicle.identity.integers_bytewise)

    def _follow_target(self, content: Any, frame: Frame, connection: Connection) -> None:
        numbers = (content.alt, *content.vel)
        if all(map(math.isfinite, numbers)):
            p_ned = self.vehicle.frame.to_local(1e-7 * content.lat, 1e-7 * content.lon, content.alt)
            self.vehicle.neighbours[frame.sysid] = Neighbour(p_ned, tuple(content.vel), self.vehicle.time_s)

    def _named_value_int(self, content: Any, frame: Frame, connection: Connection) -> None:
        self.vehicle.hear_counter(frame.sysid, content.name, content.value)

    # commands

    def _arm(self, request: Request, connection: Connection) -> int:
        vehicle = self.vehicle
        if request.params[0] not in (0.0, 1.0):
            return DENIED
        if request.whole(1) == 1:
            reason = vehicle.arming_refusal()
            if reason is not None and request.whole(2) not in FORCE_ARM:
                vehicle.announce(Severity.WARNING, f"Arming refused: {reason}")
                return TEMPORARILY_REJECTED
            return self._result(vehicle.trigger(Event.ARM))
        if not vehicle.landed and request.whole(2) not in FORCE_ARM:
            vehicle.announce(Severity.WARNING, "Disarming refused: in the air")
            return TEMPORARILY_REJECTED
        return self._result(vehicle.trigger(Event.DISARM))

    def _take_off(self, request: Request, connection: Connection) -> int:
        vehicle = self.vehicle
        height_m = request.value(7, 0.0)
        if height_m == 0.0:
            height_m = vehicle.parameters["MIS_TAKEOFF_ALT"]
        elif not (vehicle.identity.takeoff_altitude_is_relative or request.altitude_is_relative):
            height_m -= vehicle.frame.to_global(*vehicle.home_ned)[2]
        if not 0.0 < height_m < 1e4:
            return DENIED
        return self._result(vehicle.take_off(height_m))

    def _land(self, request: Request, connection: Connection) -> int:
        return self._result(self.vehicle.trigger(Event.LAND))

    def _return(self, request: Request, connection: Connection) -> int:
        return self._result(self.vehicle.trigger(Event.RETURN))

    def _hold(self, request: Request, connection: Connection) -> int:
        return self._result(self.vehicle.trigger(Event.HOLD))

    def _reposition(self, request: Request, connection: Connection) -> int:
        vehicle, numbers = self.vehicle, request.params[4:7]
        if not all(map(math.isfinite, numbers)) or not request.frame_is_known:
            return DENIED
        if request.frame == mav.MAV_FRAME_LOCAL_NED:
            north, east, down = numbers
        else:
            north, east, down = vehicle.frame.to_local(*numbers)
        if request.altitude_is_relative:
            down = vehicle.home_ned[2] - numbers[2]
        return self._result(vehicle.reposition((north, east, down)))

    def _do_set_mode(self, request: Request, connection: Connection) -> int:
        main, sub = request.whole(2), request.whole(3)
        bytewise = self.vehicle.identity.autopilot != mav.MAV_AUTOPILOT_ARDUPILOTMEGA
        if not (0 <= main <= 255 and 0 <= sub <= 255):
            return DENIED
        return self._enter_custom(main << 16 | sub << 24 if bytewise else main)

    def _enter_custom(self, custom_mode: int) -> int:
        mode = self.vehicle.identity.heard.get(custom_mode)
        if mode is None:
            return UNSUPPORTED
        if mode is Mode.TAKEOFF:
            return self._result(self.vehicle.take_off(self.vehicle.parameters["MIS_TAKEOFF_ALT"]))
        if mode is Mode.OFFBOARD and not self.vehicle.setpoints_fresh():
            self.vehicle.announce(Severity.WARNING, "Offboard refused: no set points")
            return TEMPORARILY_REJECTED
        return self._result(self.vehicle.trigger(_EVENT_OF_MODE[mode]))

    def _set_interval(self, request: Request, connection: Connection) -> int:
        interval_us = request.value(2, 0.0)
        if not math.isfinite(interval_us):
            return DENIED
        known = connection.streams.set_interval(request.whole(1, -1), interval_us, self.vehicle.time_ms)
        return ACCEPTED if known else UNSUPPORTED

    def _get_interval(self, request: Request, connection: Connection) -> int:
        interval_us = connection.streams.interval_us(request.whole(1, -1))
        if interval_us is None:
            return UNSUPPORTED
        self._after_ack.append(message("MESSAGE_INTERVAL")(message_id=request.whole(1), interval_us=interval_us))
        return ACCEPTED

    def _request_message(self, request: Request, connection: Connection) -> int:
        return self._answer_with(request.whole(1, -1))

    def _request_version(self, request: Request, connection: Connection) -> int:
        return self._answer_with(mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION)

    def _get_home(self, request: Request, connection: Connection) -> int:
        return self._answer_with(mav.MAVLINK_MSG_ID_HOME_POSITION)

    def _answer_with(self, msgid: int) -> int:
        snapshot = self.vehicle.snapshot()
        answers = [stream.build(snapshot) for stream in TELEMETRY if stream.msgid == msgid]
        if msgid == mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION:
            answers = [autopilot_version(snapshot, self.sysid)]
        self._after_ack.extend(answers)
        return ACCEPTED if answers else UNSUPPORTED

    def _transfer(self, request: Request, connection: Connection) -> int:
        if not all(map(math.isfinite, request.params[:6])) or request.whole(2) not in tuple(Role):
            return DENIED
        role = Role(request.whole(2))
        if role is not Role.STOP and not (request.params[2] > 0.0 and request.params[3] > 0.0):
            return DENIED
        order = Order(
            partner=request.whole(1),
            role=role,
            limit_j=request.params[2],
            rate_w=request.params[3],
            transfer_id=request.whole(5),
            giver_start_j=request.whole(6),
        )
        reason = self.vehicle.order(order)
        if reason is not None:
            self.vehicle.announce(Severity.WARNING, f"Transfer refused: {reason}")
            return TEMPORARILY_REJECTED
        for counter in ("XferOut", "XferIn"):
            connection.streams.hasten(counter, self.vehicle.time_ms)
        return ACCEPTED

    @staticmethod
    def _result(done: bool) -> int:
        return ACCEPTED if done else TEMPORARILY_REJECTED


def _status_texts(severity: int, text: str, number: int) -> list[Any]:
    """STATUSTEXT, in chunks that share an id where one cannot hold the text; an empty part ends a full last chunk."""
    if len(text) <= TEXT_CHARACTERS:
        return [message("STATUSTEXT")(severity=severity, text=text, id=0, chunk_seq=0)]
    parts = [text[at : at + TEXT_CHARACTERS] for at in range(0, len(text) + 1, TEXT_CHARACTERS)]
    return [
        message("STATUSTEXT")(severity=severity, text=part, id=1 + number % 65535, chunk_seq=seq)
        for seq, part in enumerate(parts)
    ]


def _where_used(numbers: Vec3, used: tuple[bool, bool, bool]) -> Vec3:
    """The numbers, 0 where they are not used, since anything may stand there."""
    first, second, third = (number if use else 0.0 for number, use in zip(numbers, used, strict=True))
    return first, second, third


_Handler = Callable[[Services, Any, Frame, Connection], None]
_MESSAGES: dict[int, _Handler] = {
    mav.MAVLINK_MSG_ID_HEARTBEAT: Services._heartbeat,
    mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED: Services._set_point,
    mav.MAVLINK_MSG_ID_COMMAND_LONG: Services._command,
    mav.MAVLINK_MSG_ID_COMMAND_INT: Services._command,
    mav.MAVLINK_MSG_ID_SET_MODE: Services._set_mode_message,
    mav.MAVLINK_MSG_ID_PARAM_REQUEST_LIST: Services._param_list,
    mav.MAVLINK_MSG_ID_PARAM_REQUEST_READ: Services._param_read,
    mav.MAVLINK_MSG_ID_PARAM_SET: Services._param_set,
    mav.MAVLINK_MSG_ID_FOLLOW_TARGET: Services._follow_target,
    mav.MAVLINK_MSG_ID_NAMED_VALUE_INT: Services._named_value_int,
}
_COMMANDS: dict[int, Callable[[Services, Request, Connection], int]] = {
    mav.MAV_CMD_COMPONENT_ARM_DISARM: Services._arm,
    mav.MAV_CMD_NAV_TAKEOFF: Services._take_off,
    mav.MAV_CMD_NAV_LAND: Services._land,
    mav.MAV_CMD_NAV_RETURN_TO_LAUNCH: Services._return,
    mav.MAV_CMD_NAV_LOITER_UNLIM: Services._hold,
    mav.MAV_CMD_DO_REPOSITION: Services._reposition,
    mav.MAV_CMD_DO_SET_MODE: Services._do_set_mode,
    mav.MAV_CMD_SET_MESSAGE_INTERVAL: Services._set_interval,
    mav.MAV_CMD_GET_MESSAGE_INTERVAL: Services._get_interval,
    mav.MAV_CMD_REQUEST_MESSAGE: Services._request_message,
    mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES: Services._request_version,
    mav.MAV_CMD_GET_HOME_POSITION: Services._get_home,
    mav.MAV_CMD_USER_1: Services._transfer,
}
